#include "skinning/elastic/moduli.h"

#include <catch2/catch.hpp>

#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::skinning;

TEST_CASE("moduli that do not say what they should are refused with their place") {
  const auto [text, told] = GENERATE(table<std::string, std::string>({
      {"3", "moduli: the moduli are no JSON object"},
      {"{", "moduli: the moduli are no JSON object"},
      {R"({"young": 0})", "moduli.young: the modulus is no positive number"},
      {R"({"young": -1})", "moduli.young: the modulus is no positive number"},
      {R"({"young": "5"})", "moduli.young: the modulus is no positive number"},
      {R"({"young": 1e30})", "moduli.young: the modulus is no positive number"},
      {R"({"segments": 3})", "moduli: unknown key 'segments'"},
      {R"({"segments": {"from": 0, "to": 1, "young": 5}})", "moduli: unknown key 'segments'"},
      {R"({"soft": 3})", "moduli: unknown key 'soft'"},
      {R"({"segments": [3]})", "moduli.segments[0]: a range of segments is an object"},
      {R"({"segments": [{"from": 0, "to": 1, "young": 5}, {"from": 0, "to": 1, "young": 5, "x": 1}]})",
       "moduli.segments[1]: unknown key 'x'"},
      {R"({"segments": [{"from": 2, "to": 1, "young": 5}]})", "moduli.segments[0]: a range needs from <= to"},
      {R"({"segments": [{"to": 1, "young": 5}]})", "moduli.segments[0]: a range needs from <= to"},
      {R"({"segments": [{"from": 0, "young": 5}]})", "moduli.segments[0]: a range needs from <= to"},
      {R"({"segments": [{"from": 0, "to": 1}]})", "moduli.segments[0]: a range needs from <= to"},
      {R"({"segments": [{"from": -1, "to": 1, "young": 5}]})",
       "moduli.segments[0]: a range needs from <= to"},
      {R"({"segments": [{"from": 0, "to": 1000000, "young": 5}]})",
       "moduli.segments[0]: a range needs from <= to"},
      {R"({"segments": [{"from": 0, "to": 1, "young": 0}]})", "moduli.segments[0]: a range needs from <= to"},
  }));
  INFO(text);
  CHECK(test::refusal(parseModuli(text)).find(told) == 0);
}

TEST_CASE("moduli may leave out either part, and a range may be one segment") {
  CHECK(*parseModuli("{}") == SegmentModuli{});
  const auto one = parseModuli(
      R"({"segments": [{"from": 3, "to": 3, "young": 0.5}, {"from": 0, "to": 999999, "young": 9}]})");
  REQUIRE(one);
  CHECK_FALSE(one->youngModulus);
  CHECK(one->ranges == std::vector<SegmentModuli::Range>{{3, 3, 0.5}, {0, 999999, 9.0}});
  CHECK(parseModuli(R"({"young": 0.25})")->youngModulus == 0.25);
}

TEST_CASE(
    "a segment has the modulus of the last range that names it, its ends among them, else that of all") {
  SegmentModuli moduli;
  CHECK(moduli.at(4, 7.0) == 7.0);
  moduli.youngModulus = 5.0;
  moduli.ranges = {{2, 4, 1.0}, {4, 6, 2.0}};
  const std::vector<double> wanted{5.0, 5.0, 1.0, 1.0, 2.0, 2.0, 2.0, 5.0};
  for (std::size_t segment = 0; segment < wanted.size(); ++segment) {
    CHECK(moduli.at(segment, 7.0) == wanted[segment]);
  }
  CHECK(*parseModuli(moduliText(moduli)) == moduli);
  CHECK(moduliText({}) == "{}\n");
  CHECK(moduliText({3.5, {}}) == "{\n  \"young\": 3.5\n}\n");
}
