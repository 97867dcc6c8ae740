// What the verbs that write tell in words of the form of what was saved, as they tell it in numbers.
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;

namespace {

/// What is told of a punch that is saved with these options.
std::string savedPunch(const std::vector<std::string>& options) {
  const test::TemporaryFolder folder;
  std::vector<std::string> words{"exaggerate", test::posedCharacter,
                                 "-o",         (folder / "out.glb").string(),
                                 "--limb",     "left-arm",
                                 "--range",    "21:27",
                                 "--scale",    "2"};
  words.insert(words.end(), options.begin(), options.end());
  const test::VerbAnswer answer = test::runVerb(words);
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  return answer.output;
}

} // namespace

TEST_CASE("What corners make of a stretch, and how far off its fit is, is told in words as in numbers") {
  const Json form = Json::parse(savedPunch({"--form", "volume", "--influences", "4", "--json"}))["form"];
  const Json& miss = form["miss_percent_of_height"];
  REQUIRE(form["fitted_vertices"].get<int>() > 0);
  CHECK(miss["median"].get<double>() < miss["percentile_99"].get<double>());
  CHECK(miss["percentile_99"].get<double>() < miss["worst"].get<double>());
  const std::string words = savedPunch({"--form", "volume", "--influences", "4"});
  CHECK_THAT(words, Catch::Contains(fmt::format(
                        "form   volume: {} corners of {} joints move {} vertices; {} fitted to 4 influences: "
                        "off by {:.3f} % of the height in the middle, {:.3f} % at the 99th percentile, "
                        "{:.3f} % at worst\n",
                        form["corners"].get<int>(), form["joints"].get<int>(), form["vertices"].get<int>(),
                        form["fitted_vertices"].get<int>(), miss["median"].get<double>(),
                        miss["percentile_99"].get<double>(), miss["worst"].get<double>())));
  CHECK_THAT(words, !Catch::Contains("keep their thickness"));
}

TEST_CASE("Each warning about one of all clips begins with the clip's name") {
  const test::TemporaryFolder folder;
  const test::VerbAnswer answer =
      test::runVerb({"exaggerate", test::posedCharacter, "-o", (folder / "out.glb").string(), "--all-clips",
                     "--limb", "left-arm", "--scale", "4"});
  REQUIRE(answer.exitCode == 0);
  REQUIRE_THAT(answer.told, Catch::Contains("warning: "));
  std::istringstream lines(answer.told);
  for (std::string line; std::getline(lines, line);) {
    CHECK_THAT(line, Catch::StartsWith("warning: Guard: ") || Catch::StartsWith("warning: One-two punch: "));
  }
}

TEST_CASE(
    "That limbs keep their thickness is told where they do, and how far whole frames miss where they are "
    "asked for") {
  CHECK_THAT(savedPunch({"--keep-skeleton"}),
             Catch::Contains("form   translation: limbs keep their thickness") &&
                 !Catch::Contains("keys   on whole frames"));
  const Json report = Json::parse(savedPunch({"--key-frames", "whole", "--json"}));
  const std::string words = savedPunch({"--key-frames", "whole"});
  CHECK_THAT(words, Catch::Contains(fmt::format(
                        "keys   on whole frames and where a range or its way back ends: between them the "
                        "motion is at most {:.3f} % of the height off\n",
                        report["whole_frames"]["miss_percent_of_height"].get<double>())));
  CHECK_THAT(words, !Catch::Contains("form   "));
}
