#include "core/base/number.h"

#include <cstdint>
#include <span>
#include <vector>

#include <catch2/catch.hpp>

#include "core/base/hash.h"

using namespace stretch;

TEST_CASE("A number is the whole text") {
  CHECK(parseNumber("-2.5e3") == -2500.0);
  CHECK(parseNumber("+1") == 1.0);
  CHECK(parseNumber<int>("12") == 12);
  for (const char* text : {"", "+", "+-1", "2x", " 2", "2 ", "nan", "inf", "1e999", "0,5"}) {
    INFO(text);
    CHECK_FALSE(parseNumber(text));
  }
  CHECK_FALSE(parseNumber<int>("1.5"));
  CHECK_FALSE(parseNumber<int>("99999999999"));
  CHECK_FALSE(parseNumber<std::size_t>("-1"));
}

TEST_CASE("The hash is that of its authors' examples") {
  const auto hashOf = [](std::string_view text) {
    Hash hash;
    hash.add(text);
    return hash.value();
  };
  CHECK(hashOf("") == 0xcbf29ce484222325U);
  CHECK(hashOf("foobar") == 0x85944171f73967e8U);
}

TEST_CASE("Each byte that is mixed into a hash counts, whether they are whole eights or not") {
  const auto mixedOf = [](const std::vector<std::uint8_t>& bytes) {
    Hash hash;
    hash.mix(std::span(bytes));
    return hash.value();
  };
  for (std::size_t size = 1; size <= 17; ++size) {
    std::vector<std::uint8_t> bytes(size, 7);
    const std::uint64_t before = mixedOf(bytes);
    for (std::uint8_t& byte : bytes) {
      byte = 8;
      CHECK(mixedOf(bytes) != before);
      byte = 7;
    }
    CHECK(mixedOf(bytes) == before);
  }
}
