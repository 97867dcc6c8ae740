#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/document.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/recipe/recipe.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::endOf;
using test::nodeOf;
using test::openedFile;
using test::pose;
using test::Posed;
using test::posedCharacter;

namespace {

Json controllerKey(const std::string& controller, double frame, const Json& offset) {
  Json key = offset;
  key["frame"] = frame;
  return {{"controller", controller}, {"keys", Json::array({key})}};
}

Json attributeKey(const std::string& attribute, double frame, double value) {
  return {{"attribute", attribute}, {"keys", Json::array({{{"frame", frame}, {"value", value}}})}};
}

Json poseRecipe(const Json& adjustments) {
  return {{"version", 1}, {"units", "metres"}, {"adjustments", adjustments}};
}

} // namespace

TEST_CASE("pose puts a hand where the recipe asks for it, at every frame and half frame of the saved file") {
  const test::TemporaryFolder folder;
  const Json recipe = poseRecipe({controllerKey("body", 0, {{"move", {0.2, 0.0, 0.1}}}),
                                  controllerKey("left-hand", 0, {{"turn", {0, 0, 30}}})});
  const Posed posed = pose(folder, recipe, {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(posedCharacter);
  const Document file = openedFile(posed.path);
  CHECK(file.adjustments.empty());
  for (double frame = 0.0; frame <= 60.0; frame += 0.5) {
    const Vec3 wanted = endOf(source, "left-arm", frame) + Vec3(0.2, 0.0, 0.1);
    CHECK(glm::length(endOf(file, "left-arm", frame) - wanted) < 1e-4 * source.body.height);
  }
}

TEST_CASE("pose lowers the hips over planted feet, and tells the places asked for and reached") {
  const test::TemporaryFolder folder;
  const double down = 0.1 * openedFile(posedCharacter).body.height;
  const Json recipe = poseRecipe({controllerKey("hips", 12, {{"move", {0.0, -down, 0.0}}}),
                                  controllerKey("right-hand", 12, {{"move", {0.05, 0.1, 0.0}}})});
  const Posed posed = pose(folder, recipe, {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(posedCharacter);
  const Document file = openedFile(posed.path);
  for (double frame = 0.0; frame <= 60.0; frame += 0.5) {
    for (const char* leg : {"left-leg", "right-leg"}) {
      CHECK(glm::length(endOf(file, leg, frame) - endOf(source, leg, frame)) < 1e-4 * source.body.height);
    }
    CHECK(std::abs(nodeOf(file, source.body.hips, frame).y - nodeOf(source, source.body.hips, frame).y +
                   down) < 1e-4 * source.body.height);
  }
  const Json report = Json::parse(posed.answer.output);
  REQUIRE(report["controllers"].size() == 2);
  const Json& hand = report["controllers"][1]["keys"][0];
  CHECK(report["controllers"][1]["controller"] == "right-hand");
  CHECK(hand["missed_by"].get<double>() < 1e-6);
  const Vec3 reached(hand["reached"][0].get<double>(), hand["reached"][1].get<double>(),
                     hand["reached"][2].get<double>());
  CHECK(glm::length(endOf(file, "right-arm", 12.0) - reached) < 1e-4 * source.body.height);
}

TEST_CASE("adjustments of nothing leave the bytes of the source") {
  const test::TemporaryFolder folder;
  const Json recipe = poseRecipe(
      {controllerKey("hips", 12, {{"move", {0, 0, 0}}}), controllerKey("left-knee", 3, {{"move", {0, 0, 0}}}),
       attributeKey("left-hand.curl", 12, 0.0), attributeKey("spine.stretch", 12, 0.5)});
  REQUIRE(pose(folder, recipe, {"--clean"}).answer.exitCode == 0);
  CHECK(*readFile(folder / "posed.glb") == *readFile(posedCharacter));
}

TEST_CASE(
    "adjustments are kept in the file, changed tomorrow, and gone without a trace when they are deleted") {
  const test::TemporaryFolder folder;
  Json waved = controllerKey("left-hand", 12, {{"move", {0.0, 0.2, 0.0}}, {"turn", {0, 0, 40}}});
  waved["range"] = {8, 16};
  waved["keys"][0]["interpolation"] = "flat";
  const Json recipe = poseRecipe({waved, attributeKey("right-hand.curl", 0, 1.0)});
  const Posed posed = pose(folder, recipe);
  REQUIRE(posed.answer.exitCode == 0);
  Document file = openedFile(posed.path);
  REQUIRE(file.adjustments.size() == 2);
  CHECK(file.adjustments[0].rangeFrames == Vec2(8, 16));
  CHECK(file.adjustments[0].keys[0].interpolation == rig::KeyInterpolation::flat);
  CHECK(file.adjustments[1].controller == "right-hand.curl");
  CHECK(glm::length(endOf(file, "left-arm", 12.0) - endOf(openedFile(posedCharacter), "left-arm", 12.0)) <=
        0.0);
  REQUIRE(saveDocument(file, folder / "again.glb", {}));
  CHECK(*readFile(folder / "again.glb") == *readFile(posed.path));
  for (const char* controller : {"left-hand", "right-hand.curl"}) {
    file = removeAdjustments(file, controller, 0);
  }
  REQUIRE(saveDocument(file, folder / "without.glb", {}));
  CHECK(*readFile(folder / "without.glb") == *readFile(posedCharacter));
}

TEST_CASE("adjustments of another clip than the first come back on it") {
  const test::TemporaryFolder folder;
  const Json recipe = poseRecipe(Json::array({controllerKey("left-hand", 6, {{"move", {0.0, 0.2, 0.0}}})}));
  const Posed posed = pose(folder, recipe, {"--clip", "Guard"});
  REQUIRE(posed.answer.exitCode == 0);
  const Document file = openedFile(posed.path);
  REQUIRE(file.adjustments.size() == 1);
  CHECK(clipOf(file, file.adjustments[0].clip).name == "Guard");
}

TEST_CASE("a recipe that is written from a document poses another one alike") {
  const test::TemporaryFolder folder;
  const Json recipe =
      poseRecipe({controllerKey("spine-top", 12, {{"move", {0.0, -0.02, 0.1}}, {"turn", {30, 10, 0}}}),
                  attributeKey("left-foot.roll", 12, 0.5)});
  const Posed posed = pose(folder, recipe);
  REQUIRE(posed.answer.exitCode == 0);
  const Document first = openedFile(posed.path);
  Document second = openedFile(posedCharacter);
  const Result<Recipe> again = recipeFromJson(recipeToJson(first, 0), second);
  REQUIRE(again);
  REQUIRE(again->adjustments.size() == 2);
  CHECK(glm::length(again->adjustments[0].keys[0].move - first.adjustments[0].keys[0].move) < 1e-12);
  CHECK(glm::length(again->adjustments[0].keys[0].turn - first.adjustments[0].keys[0].turn) < 1e-12);
  CHECK(again->adjustments[1] == first.adjustments[1]);
}

TEST_CASE("a recipe that asks for what is not there is told in one line, and nothing is written") {
  const Json move{{"move", {0, 0.1, 0}}};
  const auto with = [&](const char* key, const Json& value) {
    Json adjustment = controllerKey("left-hand", 12, move);
    adjustment["keys"][0][key] = value;
    return adjustment;
  };
  const std::vector<std::pair<Json, std::string>> cases{
      {controllerKey("third-hand", 12, move), "third-hand"},
      {controllerKey("LeftForeArm", 12, move), "LeftForeArm"},
      {attributeKey("third-hand.curl", 12, 1), "third-hand.curl"},
      {attributeKey("left-hand.curl", 12, 1e9), "left-hand.curl"},
      {with("move", {0, 1e9, 0}), "out of proportion"},
      {with("move", {0, nullptr, 0}), "keys[0].move"},
      {with("interpolation", "wavy"), "wavy"},
      {with("colour", 3), "colour"},
      {with("frame", 1e9), "1e+09"},
      {controllerKey("left-knee", 12, {{"turn", {0, 30, 0}}}), "does not turn"},
      {{{"controller", "hips"}, {"keys", Json::array()}}, "no keys"},
      {{{"keys", Json::array()}}, "adjustments[0]"},
      {{{"controller", "hips"}, {"range", {9, 3}}, {"keys", {{{"frame", 5}}}}}, "no length"}};
  for (const auto& [adjustment, told] : cases) {
    INFO(adjustment.dump());
    const test::TemporaryFolder folder;
    const Posed posed = pose(folder, poseRecipe(Json::array({adjustment})));
    CHECK(posed.answer.exitCode == 1);
    CHECK_THAT(posed.answer.told, Catch::Contains(told));
    CHECK(std::count(posed.answer.told.begin(), posed.answer.told.end(), '\n') == 1);
    CHECK(folder.fileCount() == 1);
  }
  const test::TemporaryFolder folder;
  CHECK(pose(folder, poseRecipe(Json::array())).answer.exitCode == 1);
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("info lists what a character can be posed by") {
  const Json info = Json::parse(test::runVerb({"info", posedCharacter, "--json"}).output);
  const Json& controllers = info["controllers"];
  const auto lists = [&](const char* kind, const std::string& id) {
    return std::any_of(controllers.begin(), controllers.end(),
                       [&](const Json& entry) { return entry.value(kind, std::string()) == id; });
  };
  CHECK(lists("controller", "hips"));
  CHECK(lists("controller", "right-knee"));
  CHECK(lists("attribute", "left-leg.follow"));
  CHECK(lists("attribute", "right-hand.curl"));
  CHECK(!lists("controller", "tail"));
}

TEST_CASE("a recipe with adjustments and trails plays both by exaggerate, the trail from the adjusted clip") {
  const test::TemporaryFolder folder;
  Json recipe = poseRecipe(Json::array({controllerKey("left-hand", 12, {{"move", {0.0, 0.1, 0.0}}})}));
  recipe["trails"] = Json::array({{{"limb", "left-arm"}, {"range", {21, 27}}, {"scale", 2}}});
  const std::string file = folder.write("both.json", recipe.dump()).string();
  const std::string output = (folder / "both.glb").string();
  REQUIRE(test::runVerb({"exaggerate", posedCharacter, "-o", output, "--recipe", file}).exitCode == 0);
  const Document both = openedFile(output);
  CHECK(both.adjustments.size() == 1);
  CHECK(both.trails.size() == 1);
  const rig::MotionState motion = prepareMotion(both, 0);
  Document alone = both;
  alone.trails.clear();
  const FrameState adjusted = evaluate(alone, prepareMotion(alone, 0), 27.0 / motion.framesPerSecond);
  const Vec3 tip = motion.trails.front().path.samples.back().end;
  CHECK(glm::length(tip - rig::endPosition(*findLimb(both, "left-arm"), adjusted)) < 1e-9);
}
