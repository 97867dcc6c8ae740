#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/run_verb.h"

using stretch::gltf::Json;
using stretch::test::runVerb;
using stretch::test::VerbAnswer;

namespace {

Json flattened(std::vector<std::string> words) {
  words.insert(words.begin(), "flatten");
  words.emplace_back("--json");
  const VerbAnswer answer = runVerb(words);
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output);
}

} // namespace

// l = 0.88 mm, w = 0.085 mm, m = 2 ug, E = 3770 Pa: Table 1 of "Elasticity-inspired stretching".
TEST_CASE("Eq. 6 with the values of Table 1 flattens by a ten-thousandth, not by 12.3 %") {
  const Json report =
      flattened({"--mass", "2e-9", "--young", "3770", "--length", "0.88e-3", "--width", "0.085e-3"});
  CHECK(report["force"].get<double>() == Approx(1.962e-8));
  CHECK(report["deflection"].get<double>() == Approx(9.2896e-9).epsilon(1e-4));
  CHECK(report["ratio"].get<double>() == Approx(1.0929e-4).epsilon(1e-4));
  CHECK(report["height"].get<double>() == Approx(0.085e-3 * (1.0 - 1.0929e-4)));
  CHECK(report["width"].get<double>() == Approx(0.085e-3 / (1.0 - 1.0929e-4)));
  CHECK(report["warnings"].empty());
}

TEST_CASE("the printed 12.3 % is Eq. 6 of a thousand times the mass and rounded sizes") {
  const Json report =
      flattened({"--mass", "2e-6", "--young", "3770", "--length", "0.80e-3", "--width", "0.083e-3"});
  CHECK(report["deflection"].get<double>() == Approx(1.02185e-5).epsilon(1e-4));
  CHECK(report["ratio"].get<double>() == Approx(0.12311).epsilon(1e-4));
}

TEST_CASE("a tilted cylinder is flattened by what pulls across it, in the units of its mesh") {
  const Json lying = flattened(
      {"--mass", "2", "--young", "1e4", "--length", "10", "--width", "2", "--metres-per-unit", "0.1"});
  const Json tilted = flattened({"--mass", "2", "--young", "1e4", "--length", "10", "--width", "2",
                                 "--metres-per-unit", "0.1", "--angle", "60"});
  CHECK(lying["ratio"].get<double>() == Approx(2.0 * 9.81 * 3.14159265 / (2.0 * 1e4 * 1.0) / 0.2));
  CHECK(tilted["ratio"].get<double>() == Approx(0.5 * lying["ratio"].get<double>()));
  CHECK(lying["height"].get<double>() == Approx(2.0 * (1.0 - lying["ratio"].get<double>())));
}

TEST_CASE("what is too soft for the model is cut and told") {
  const Json report = flattened({"--mass", "1", "--young", "100", "--length", "1", "--width", "0.1"});
  CHECK(report["ratio"].get<double>() == 0.5);
  CHECK(report["warnings"].size() == 1);
}

TEST_CASE("sizes that are none are wrong arguments, told in one line") {
  for (const char* const young : {"0", "-1", "nan", "soft"}) {
    const VerbAnswer answer =
        runVerb({"flatten", "--mass", "1", "--young", young, "--length", "1", "--width", "1"});
    CHECK(answer.exitCode == 2);
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
  }
}
