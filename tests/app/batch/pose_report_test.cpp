// What `pose` and `exaggerate --recipe` tell of controllers, against what the saved file plays.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::TemporaryFolder;

namespace {

Json reportOf(const TemporaryFolder& folder, const Json& recipe) {
  const test::Posed posed = test::pose(folder, recipe, {"--clean"});
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  return Json::parse(posed.answer.output);
}

Vec3 vectorOf(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

} // namespace

TEST_CASE("Places that are told as reached are those that the saved file plays, at every key", "[pose]") {
  const TemporaryFolder folder;
  Json recipe{{"version", 1}, {"adjustments", Json::array()}};
  const std::map<std::string, std::string> limbs{{"left-hand", "left-arm"},
                                                 {"right-hand", "right-arm"},
                                                 {"left-foot", "left-leg"},
                                                 {"right-foot", "right-leg"}};
  for (const auto& [controller, limb] : limbs) {
    Json keys = Json::array();
    for (const double frame : {0.0, 7.0, 12.0, 30.0, 41.5}) {
      keys.push_back({{"frame", frame}, {"move", {0.02, 0.001 * frame, 0.03}}});
    }
    recipe["adjustments"].push_back({{"controller", controller}, {"keys", keys}});
  }
  const Json report = reportOf(folder, recipe);
  const Document source = test::openedFile(test::posedCharacter);
  const Document saved = test::openedFile((folder / "posed.glb").string());
  REQUIRE(report["controllers"].size() == 4);
  for (const Json& controller : report["controllers"]) {
    const std::string limb = limbs.at(controller["controller"].get<std::string>());
    REQUIRE(controller["keys"].size() == 5);
    for (const Json& key : controller["keys"]) {
      const double frame = key["frame"].get<double>();
      CAPTURE(limb, frame);
      const Vec3 asked = vectorOf(key["asked"]);
      const Vec3 reached = vectorOf(key["reached"]);
      CHECK(glm::length(reached - test::endOf(saved, limb, frame)) < 2e-3);
      CHECK(key["missed_by"].get<double>() == Approx(glm::length(asked - reached)).margin(1e-9));
      const double unit = findLimb(source, limb)->restLength;
      CHECK(glm::length(asked - test::endOf(source, limb, frame)) ==
            Approx(unit * glm::length(Vec3(0.02, 0.001 * frame, 0.03))).margin(1e-6));
    }
  }
}

TEST_CASE("Turns are told key by key, each as its joint turns at that frame", "[pose]") {
  const TemporaryFolder folder;
  const Json report = reportOf(folder, Json::parse(R"({"version": 1, "adjustments": [
      {"controller": "hips", "keys": [{"frame": 4, "turn": [0, 10, 0]}, {"frame": 12, "turn": [0, 40, 0]},
                                      {"frame": 20, "move": [0, 0.02, 0]}, {"frame": 30, "turn": [15, 0, 0]}]},
      {"controller": "left-hand", "keys": [{"frame": 0, "turn": [0, 0, 5]}, {"frame": 9, "turn": [60, 0, 0]},
                                           {"frame": 14, "turn": [190, 0, 0]}, {"frame": 18, "turn": [350, 0, 0]},
                                           {"frame": 22, "turn": [0, 370, 0]}, {"frame": 26, "turn": [0, 0, 560]}]}]})"));
  const std::vector<std::vector<double>> degrees{{10.0, 40.0, 0.0, 15.0},
                                                 {5.0, 60.0, 190.0, 350.0, 370.0, 560.0}};
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    for (std::size_t k = 0; k < degrees[i].size(); ++k) {
      CAPTURE(i, k);
      const Json& key = report["controllers"][i]["keys"][k];
      REQUIRE(key.contains("turn") == (degrees[i][k] > 0.0));
      if (degrees[i][k] > 0.0) {
        CHECK(key["turn"]["asked_degrees"].get<double>() == Approx(degrees[i][k]));
        CHECK(key["turn"]["reached_degrees"].get<double>() == Approx(degrees[i][k]).margin(0.1));
      }
    }
  }
}

TEST_CASE("Values are told as far as they go, at either end", "[pose]") {
  const TemporaryFolder folder;
  const Json report = reportOf(folder, Json::parse(R"({"version": 1, "adjustments": [
      {"attribute": "left-hand.curl", "keys": [{"frame": 0, "value": -7}, {"frame": 3, "value": 7}]},
      {"attribute": "right-hand.curl", "keys": [{"frame": 1, "value": -0.1}, {"frame": 2, "value": 0.9}]}]})"));
  const Json& left = report["controllers"][0]["keys"];
  const Json& right = report["controllers"][1]["keys"];
  CHECK(left[0] == Json{{"frame", 0.0}, {"asked", -7.0}, {"reached", -0.2}});
  CHECK(left[1] == Json{{"frame", 3.0}, {"asked", 7.0}, {"reached", 1.0}});
  CHECK(right[0]["reached"] == -0.1);
  CHECK(right[1]["reached"] == 0.9);
  REQUIRE(report["warnings"].size() == 2);
  CHECK(report["warnings"][0] == "left-hand.curl is asked for -7 at frame 0, and goes to -0.2 at most");
  CHECK(report["warnings"][1] == "left-hand.curl is asked for 7 at frame 3, and goes to 1 at most");
}

TEST_CASE("What feet and hands miss between keys, and where nothing of theirs is keyed, is told", "[pose]") {
  const TemporaryFolder folder;
  const Json recipe = Json::parse(R"({"version": 1, "adjustments": [
      {"attribute": "left-leg.stretch", "keys": [{"frame": 0, "value": 0}]},
      {"attribute": "left-arm.stretch", "keys": [{"frame": 0, "value": 0}]},
      {"attribute": "left-arm.follow", "keys": [{"frame": 0, "value": 0}]},
      {"controller": "left-hand", "keys": [{"frame": 0, "move": [0, 0, 0.001]},
                                           {"frame": 60, "move": [0, 0, 0.001]}]},
      {"controller": "hips", "range": [10, 40], "keys": [{"frame": 25, "move": [0, 0.5, 0]}]}]})");
  const test::Posed posed = test::pose(folder, recipe, {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const Json report = Json::parse(posed.answer.output);
  const std::string told = report["warnings"].dump();
  CHECK_THAT(told, Catch::Contains("left-foot misses its place at frames "));
  CHECK_THAT(told, Catch::Contains("left-hand misses its place at frames "));
  CHECK_THAT(told, !Catch::Contains("right-foot") && !Catch::Contains("right-hand"));
  const Document source = test::openedFile(test::posedCharacter);
  const Document saved = test::openedFile(posed.path);
  double farthest = 0.0;
  double worst = 0.0;
  for (double frame = 10.0; frame <= 40.0; frame += 0.5) {
    const double miss =
        glm::length(test::endOf(saved, "left-leg", frame) - test::endOf(source, "left-leg", frame));
    worst = miss > farthest ? frame : worst;
    farthest = std::max(farthest, miss);
  }
  CHECK(farthest > 0.02);
  CHECK_THAT(told, Catch::Contains(fmt::format("most at frame {:g}: its limb", worst)));
}

TEST_CASE("A place that is missed at a key between two half frames alone is told with that frame", "[pose]") {
  const TemporaryFolder folder;
  const Json report = reportOf(folder, Json::parse(R"({"version": 1, "adjustments": [
      {"attribute": "left-arm.stretch", "keys": [{"frame": 0, "value": 0}]},
      {"controller": "left-hand", "range": [5.1, 5.4], "keys": [{"frame": 5.25, "move": [3, 0, 0]}]}]})"));
  REQUIRE(report["warnings"].size() == 1);
  CHECK_THAT(report["warnings"][0].get<std::string>(),
             Catch::StartsWith("left-hand misses its place at frame 5.25 by ") &&
                 Catch::EndsWith(": its limb is not to stretch so far"));
}

TEST_CASE("In plain words a hold is held, held in part, overridden or too far", "[pose]") {
  const TemporaryFolder folder;
  const auto toldOf = [&](const std::string& holds) {
    const std::string recipe =
        folder.write("holds.json", R"({"version": 1, "units": "metres", )" + holds + "}").string();
    const test::VerbAnswer answer = test::runVerb(
        {"pose", test::posedCharacter, "-o", (folder / "held.glb").string(), "--recipe", recipe});
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    return answer.output;
  };
  CHECK_THAT(toldOf(R"("pins": [{"limb": "left-arm", "range": [5, 9]}])"),
             Catch::StartsWith("pin of left-arm: held, at most "));
  // Full between two half frames alone: at the later one a thirtieth of the blend is over, which is smooth.
  CHECK_THAT(toldOf(R"("pins": [{"limb": "left-arm", "range": [5.3, 5.4], "blend": [3, 3]}])"),
             Catch::StartsWith("pin of left-arm: held by a strength of at most 0.9967\nkeys   "));
  const std::string both = toldOf(R"("pins": [{"limb": "right-arm", "range": [10, 40]}],
      "grips": [{"leader": "left-arm", "follower": "right-arm", "range": [0, 60]}])");
  CHECK_THAT(both, Catch::Contains("grip of right-arm: held, at most "));
  CHECK_THAT(both, Catch::Contains("pin of right-arm: overridden, up to "));
  CHECK_THAT(toldOf(R"("pins": [{"limb": "left-arm", "range": [5, 9], "place": [5, 1, 0], "stretch": 0}])"),
             Catch::StartsWith("pin of left-arm: falls short by up to "));
}

TEST_CASE("Keys of changed tracks are told, and those that were there: the rest of the clip keeps its own") {
  const TemporaryFolder folder;
  const std::string posed = (folder / "pinned.glb").string();
  const auto keysOf = [](const std::string& file) {
    const test::VerbAnswer answer = test::runVerb({"info", file, "--json"});
    return gltf::Json::parse(answer.output)["clips"][0]["keys"].get<int>();
  };
  const std::string recipe =
      folder.write("pin.json", R"({"version": 1, "pins": [{"limb": "left-arm", "range": [5, 9]}]})").string();
  const test::VerbAnswer answer =
      test::runVerb({"pose", test::posedCharacter, "-o", posed, "--recipe", recipe, "--json", "--clean"});
  REQUIRE(answer.exitCode == 0);
  const gltf::Json counts = gltf::Json::parse(answer.output)["key_counts"];
  const int before = counts["before"].get<int>();
  const int after = counts["after"].get<int>();
  CHECK(before > 0);
  CHECK(after > before);
  CHECK(keysOf(posed) - keysOf(test::posedCharacter) == after - before);
}
