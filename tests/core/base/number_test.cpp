#include "core/base/number.h"

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
