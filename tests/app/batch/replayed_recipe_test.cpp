// What `exaggerate` makes of its options and of a recipe, and what it tells of them.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;

namespace {

constexpr const char* dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";

} // namespace

TEST_CASE("What is given before the first limb gives way to what a limb is given itself") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const test::VerbAnswer answer =
      test::runVerb({"exaggerate", dummy, "-o", out, "--scale", "2", "--range", "21:27", "--limb", "left-arm",
                     "--scale", "1.5", "--limb", "right-arm", "--json"});
  REQUIRE(answer.exitCode == 0);
  const gltf::Json trails = gltf::Json::parse(answer.output)["trails"];
  const auto growth = [&](std::size_t i) {
    return trails[i]["limb_length_after"].get<double>() / trails[i]["limb_length_before"].get<double>();
  };
  REQUIRE(trails.size() == 2);
  CHECK(growth(0) == Approx(1.5).epsilon(1e-3));
  CHECK(growth(1) == Approx(2.0).epsilon(1e-3));
}

TEST_CASE("Eases that are off, or meet nowhere, are taken with any value on their side") {
  const test::TemporaryFolder folder;
  for (const std::vector<std::string>& eases :
       std::vector<std::vector<std::string>>{{"--ease-in", "0.6,0.5", "--ease-out", "0.39,0.5"},
                                             {"--ease-in", "0,0.9", "--ease-out", "0,0.1"}}) {
    std::vector<std::string> words{"exaggerate", dummy,      "-o",      (folder / "out.glb").string(),
                                   "--limb",     "left-arm", "--scale", "2"};
    words.insert(words.end(), eases.begin(), eases.end());
    CHECK(test::exitCodeOf(words) == 0);
  }
}

namespace {

/// What `exaggerate` does with a recipe; its report is a document of JSON.
test::VerbAnswer replayed(const test::TemporaryFolder& folder, const std::string& recipe) {
  return test::runVerb({"exaggerate", dummy, "-o", (folder / "out.glb").string(), "--recipe",
                        folder.write("recipe.json", recipe).string(), "--json-line"});
}

} // namespace

TEST_CASE("A recipe that holds or poses tells in exaggerate, too, what it could not do") {
  const test::TemporaryFolder folder;
  const test::VerbAnswer held = replayed(
      folder, R"({"version":1,"pins":[{"limb":"left-leg","range":[5,20],"stretch":0,"place":[0,5,0]}]})");
  REQUIRE(held.exitCode == 0);
  const gltf::Json report = gltf::Json::parse(held.output);
  REQUIRE(report["holds"].size() == 1);
  CHECK(report["holds"][0]["limb"] == "left-leg");
  CHECK_FALSE(report["holds"][0]["reached"].get<bool>());
  CHECK_THAT(report["warnings"].dump(), Catch::Contains("left-leg") || Catch::Contains("left leg"));
  const test::VerbAnswer posed = replayed(
      folder,
      R"({"version":1,"adjustments":[{"controller":"left-hand","keys":[{"frame":12,"move":[0,30,0]}]},
          {"attribute":"left-arm.stretch","keys":[{"frame":0,"value":0}]}]})");
  REQUIRE(posed.exitCode == 0);
  const gltf::Json pose = gltf::Json::parse(posed.output);
  CHECK(pose["controllers"][0]["keys"][0]["missed_by"].get<double>() > 1.0);
  CHECK_THAT(pose["warnings"].dump(), Catch::Contains("left-hand misses its place at frames 0 to "));
  const test::VerbAnswer plain =
      replayed(folder, R"({"version":1,"trails":[{"limb":"left-arm","range":[21,27],"scale":2}]})");
  CHECK_FALSE(gltf::Json::parse(plain.output).contains("holds"));
}

TEST_CASE("What is wrong in a recipe is told with its file and its place") {
  const test::TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"({"version":1,"clip":1,"trails":[]})", "recipe.json: clip: 1 is not the name of a clip"},
      {R"({"version":1,"clip":null,"trails":[]})", "recipe.json: clip: null is not the name of a clip"},
      {R"({"version":1,"clip":["Guard"],"trails":[]})", "is not the name of a clip"},
      {"{\"version\":1,\n \"trails\":[}", "recipe.json: is not JSON (at line 2, column 12)"},
      {"", "recipe.json: is not JSON (at line 1, column 1)"},
      {R"({"version":1,"adjustments":[{"controller":"hips","keys":[{"frame":12,"move":[0,0.1,0]},
           {"frame":3,"move":[0,0,0]},{"frame":12,"move":[0,0.2,0]}]}]})",
       "recipe.json: adjustments[0].keys: two keys stand at frame 12"},
      {R"({"version":1,"adjustments":[{"controller":"hips","keys":[]}]})", "recipe.json: hips: has no keys"},
      {R"({"version":1,"trails":[{"limb":"left-arm","scale":2,"ease_in":[0.5,0.1],"ease_out":[0.5,0.9]}]})",
       "recipe.json: ease_in: both eases together take the whole path"},
      {R"({"version":1,"trails":[{"limb":"left-leg","range":[21,27],"scale":2},
           {"limb":"LeftUpLeg..LeftFoot","range":[24,30],"scale":2}]})",
       "LeftUpLeg..LeftFoot: has the joints of left-leg, which acts at the same time"},
      {R"({"version":1,"elastic":[{"limb":"left-arm"},{"limb":"LeftArm..LeftHand"}]})",
       "LeftArm..LeftHand: has the joints of left-arm, which acts at the same time"}};
  for (const auto& [recipe, reason] : wrong) {
    CAPTURE(recipe);
    const test::VerbAnswer answer = replayed(folder, recipe);
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains(reason));
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("A chain of a limb's joints may act when the limb does not, and weight alone makes a recipe") {
  const test::TemporaryFolder folder;
  CHECK(replayed(folder, R"({"version":1,"trails":[{"limb":"left-leg","range":[21,27],"scale":2},
                            {"limb":"LeftUpLeg..LeftFoot","range":[27,33],"scale":2}]})")
            .exitCode == 0);
  const test::VerbAnswer weighted = replayed(folder, R"({"version":1,"elastic":[{"limb":"left-arm"}]})");
  REQUIRE(weighted.exitCode == 0);
  CHECK(gltf::Json::parse(weighted.output)["elastic"].size() == 1);
}

TEST_CASE("A trail that gives way to a new one is told, others that the file holds are not") {
  const test::TemporaryFolder folder;
  const std::string first = (folder / "first.glb").string();
  const std::string second = (folder / "second.glb").string();
  REQUIRE(test::exitCodeOf({"exaggerate", dummy, "-o", first, "--limb", "left-arm", "--range", "21:27",
                            "--scale", "2", "--limb", "right-arm", "--range", "21:27", "--scale", "2"}) == 0);
  const test::VerbAnswer answer = test::runVerb(
      {"exaggerate", first, "-o", second, "--limb", "left-arm", "--range", "25:30", "--scale", "2"});
  REQUIRE(answer.exitCode == 0);
  CHECK_THAT(answer.told, Catch::Contains("left-arm: the trail from 21 to 27 that was there gives way") &&
                              !Catch::Contains("right-arm"));
}

TEST_CASE("A limb that does not get as long as asked names the setting of its trail by which") {
  const test::TemporaryFolder folder;
  const std::string trail = R"({"version":1,"trails":[{"limb":"left-arm","range":[21,27],"scale":2)";
  const auto kept = [&](const std::string& setting) {
    const gltf::Json report =
        gltf::Json::parse(replayed(folder, trail + setting + "}]}").output)["trails"][0];
    CHECK(report["reached"].get<bool>() == !report.contains("kept"));
    return report.value("kept", std::string());
  };
  CHECK(kept("").empty());
  CHECK(kept(R"(,"blend":1)") == "by its blend");
  CHECK(kept(R"(,"switch":0.5)") == "by its stretch switch");
  CHECK(kept(R"(,"spheres":[{"frame":27,"offset":[0,0.2,0]}])") == "by the sphere at its tip");
  CHECK(kept(R"(,"spheres":[{"frame":23,"offset":[0,0.2,0]}])").empty());
}

TEST_CASE("Poses and holds that give way to those of a recipe are told, in exaggerate and in pose") {
  const test::TemporaryFolder folder;
  const auto recipe = [](const std::string& rangeOfHips, const std::string& pin, const std::string& hand) {
    return R"({"version":1,"trails":[],"adjustments":[{"controller":"hips","keys":[{"frame":22,"move":[0,-0.1,0]}])" +
           rangeOfHips + R"(},{"controller":")" + hand +
           R"(","range":[2,9],"keys":[{"frame":5,"move":[0,0.1,0]}]}],"pins":[{"limb":"left-leg","range":)" +
           pin + "}]}";
  };
  const std::string first = (folder / "first.glb").string();
  const std::string before = folder.write("before.json", recipe("", "[0,30]", "left-hand")).string();
  const std::string after =
      folder.write("after.json", recipe(R"(,"range":[20,24])", "[30,34]", "right-hand")).string();
  REQUIRE(test::exitCodeOf({"pose", dummy, "-o", first, "--recipe", before}) == 0);
  for (const char* const verb : {"pose", "exaggerate"}) {
    CAPTURE(verb);
    const test::VerbAnswer answer =
        test::runVerb({verb, first, "-o", (folder / "second.glb").string(), "--recipe", after});
    REQUIRE(answer.exitCode == 0);
    CHECK_THAT(
        answer.told,
        Catch::Contains("hips: the offsets over the whole clip that were there give way to the new ones") &&
            Catch::Contains("left-leg: the pin from 0 to 30 that was there gives way to the new one") &&
            !Catch::Contains("left-hand: the offsets"));
  }
}
