#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/pose/hold_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/recipe/recipe.h"
#include "core/base/file.h"
#include "core/gltf/patch/edits.h"
#include "rig/motion/solved_holds.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::endOf;
using test::openedFile;
using test::pose;
using test::Posed;
using test::posedCharacter;

namespace {

// Pins, grips and props from a recipe on the command line to the saved file, read back.

constexpr double heldShare = 1e-4; // of the height

Json heldRecipe(const char* list, const Json& entry) {
  return {{"version", 1}, {"units", "metres"}, {list, Json::array({entry})}};
}

Json lowHips() {
  return Json::array({{{"controller", "hips"},
                       {"keys", {{{"frame", 12}, {"move", {0.1, -0.15, 0.05}}, {"turn", {0, 20, 0}}}}}}});
}

std::vector<double> halfFrames(double first, double last) {
  std::vector<double> frames;
  for (double frame = first; frame <= last; frame += 0.5) {
    frames.push_back(frame);
  }
  return frames;
}

Vec3 seenFromHand(const Document& document, const char* leader, const char* follower, double frame) {
  const Mat4 hand = test::worldOf(document, findLimb(document, leader)->endNode, frame);
  return glm::inverse(rotationOf(hand)) * (endOf(document, follower, frame) - positionOf(hand));
}

// Another node than a joint: the bundled character with a stick that hangs on nothing.
std::string characterWithStick(const test::TemporaryFolder& folder) {
  const Document source = openedFile(posedCharacter);
  gltf::Edits edits;
  edits.addedNodes.push_back(
      {"Stick", NodeIndex::none, {Vec3(0.2, 1.0, 0.3), Quat(1, 0, 0, 0), Vec3(1)}, {}, false});
  const Result<gltf::Source> changed = gltf::patched(*source.source, edits);
  REQUIRE(changed);
  const std::filesystem::path path = folder / "stick.glb";
  REQUIRE(gltf::save(*changed, path));
  return path.string();
}

Json oneHand(double value) {
  return Json::array({{{"frame", 0}, {"value", value}}});
}

} // namespace

TEST_CASE("a pinned hand stays at its place over the range, whatever the hips do, in the saved file") {
  const test::TemporaryFolder folder;
  Json recipe = heldRecipe("pins", {{"limb", "left-arm"}, {"range", {8, 20}}, {"at", 4}, {"blend", {3, 4}}});
  recipe["adjustments"] = lowHips();
  const Posed posed = pose(folder, recipe, {"--clean"});
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  const Document file = openedFile(posed.path);
  const double height = file.body.height;
  const Vec3 held = endOf(file, "left-arm", 8);
  for (const double frame : halfFrames(8, 20)) {
    CHECK(glm::length(endOf(file, "left-arm", frame) - held) < heldShare * height);
  }
  CHECK(glm::length(endOf(file, "left-arm", 30) - held) > 0.02 * height);
}

TEST_CASE("a pin holds where the clip has the hand at its frame, or at the place that it gives") {
  const test::TemporaryFolder folder;
  const Document source = openedFile(posedCharacter);
  const Json timed{{"limb", "right-arm"}, {"range", {10, 14}}, {"at", 2}};
  const Posed at = pose(folder, heldRecipe("pins", timed), {"--clean"});
  REQUIRE(at.answer.exitCode == 0);
  CHECK(glm::length(endOf(openedFile(at.path), "right-arm", 12) - endOf(source, "right-arm", 2)) <
        heldShare * source.body.height);
  Json placed = timed;
  placed["place"] = {-0.3, 1.1, 0.25};
  const Posed there = pose(folder, heldRecipe("pins", placed), {"--clean"});
  REQUIRE(there.answer.exitCode == 0);
  CHECK(glm::length(endOf(openedFile(there.path), "right-arm", 12) - Vec3(-0.3, 1.1, 0.25)) <
        heldShare * source.body.height);
}

TEST_CASE("a pin changes its limb alone, and leaves every key outside of its range and blends") {
  const test::TemporaryFolder folder;
  const Posed posed = pose(
      folder, heldRecipe("pins", {{"limb", "left-arm"}, {"range", {8, 20}}, {"at", 4}, {"blend", {2, 2}}}),
      {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(posedCharacter);
  const Document file = openedFile(posed.path);
  for (const double frame : halfFrames(0, 40)) {
    CHECK(glm::length(endOf(file, "right-arm", frame) - endOf(source, "right-arm", frame)) <= 0.0);
    CHECK(glm::length(endOf(file, "left-leg", frame) - endOf(source, "left-leg", frame)) <= 0.0);
    if (frame < 6.0 || frame > 22.0) {
      CHECK(glm::length(endOf(file, "left-arm", frame) - endOf(source, "left-arm", frame)) < 1e-6);
    }
  }
}

TEST_CASE("the second hand keeps its relation to the first, whatever a trail makes of the first") {
  const test::TemporaryFolder folder;
  Json recipe = heldRecipe("grips", {{"leader", "left-arm"}, {"follower", "right-arm"}, {"range", {0, 40}}});
  recipe["trails"] = Json::array({{{"limb", "left-arm"}, {"range", {21, 27}}, {"scale", 2}}});
  const std::string written = folder.write("both.json", recipe.dump()).string();
  const std::string output = (folder / "both.glb").string();
  REQUIRE(
      test::runVerb({"exaggerate", posedCharacter, "-o", output, "--recipe", written, "--clean"}).exitCode ==
      0);
  const Document source = openedFile(posedCharacter);
  const Document file = openedFile(output);
  CHECK(glm::length(endOf(file, "left-arm", 27) - endOf(source, "left-arm", 27)) > 0.1 * source.body.height);
  for (const double frame : halfFrames(0, 40)) {
    CHECK(glm::length(seenFromHand(file, "left-arm", "right-arm", frame) -
                      seenFromHand(source, "left-arm", "right-arm", frame)) < heldShare * source.body.height);
  }
}

TEST_CASE("what holds a hand back from the length of its own trail is told beside that length") {
  const test::TemporaryFolder folder;
  Json recipe = heldRecipe("grips", {{"leader", "left-arm"}, {"follower", "right-arm"}, {"range", {0, 40}}});
  recipe["trails"] = Json::array({{{"limb", "right-arm"}, {"range", {21, 27}}, {"scale", 2}}});
  const std::string written = folder.write("held.json", recipe.dump()).string();
  const std::string output = (folder / "held.glb").string();
  const std::vector<std::string> words{"exaggerate", posedCharacter, "-o", output, "--recipe", written};
  CHECK_THAT(test::runVerb(words).output, Catch::Contains("long, held by a grip"));
  std::vector<std::string> asJson = words;
  asJson.emplace_back("--json");
  const Json report = Json::parse(test::runVerb(asJson).output);
  CHECK_FALSE(report["trails"][0]["reached"].get<bool>());
  CHECK(report["trails"][0]["kept"] == "held by a grip");
}

TEST_CASE("of several holds that keep a hand from its length the one is told that decides") {
  const test::TemporaryFolder folder;
  Json recipe = heldRecipe("grips", {{"leader", "left-arm"}, {"follower", "right-arm"}, {"range", {0, 60}}});
  recipe["pins"] = Json::array({{{"limb", "right-arm"}, {"range", {10, 40}}}});
  recipe["trails"] = Json::array({{{"limb", "right-arm"}, {"range", {21, 27}}, {"scale", 2}}});
  const std::string written = folder.write("both.json", recipe.dump()).string();
  const std::string told =
      test::runVerb({"exaggerate", posedCharacter, "-o", (folder / "both.glb").string(), "--recipe", written})
          .output;
  CHECK_THAT(told, Catch::Contains("long, held by a grip"));
  CHECK_THAT(told, !Catch::Contains("held by a pin"));
}

TEST_CASE("an arm that a trail has stretched is no longer than it has to be where it is pinned") {
  const Document source = openedFile(posedCharacter);
  Document document = test::withNewTrail(source, {.startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
  const auto armLength = [](const Document& of, double frame) {
    const rig::MotionState motion = prepareMotion(of, 0);
    const FrameState state = evaluate(of, motion, frame / clipOf(of, 0).framesPerSecond);
    const std::vector<Vec3> points = rig::limbPoints(*findLimb(of, "left-arm"), state);
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += glm::length(points[i] - points[i - 1]);
    }
    return length;
  };
  REQUIRE(armLength(document, 27.0) > 2.0 * armLength(source, 27.0));
  rig::Holds holds;
  holds.pins.resize(1);
  holds.pins[0].limb = "left-arm";
  holds.pins[0].atFrame = 21.0;
  holds.pins[0].time.rangeFrames = {21.0, 30.0};
  const Result<Document> held = placeHolds(document, holds);
  REQUIRE(held);
  for (const double frame : halfFrames(22, 29)) {
    CHECK(armLength(*held, frame) < 1.1 * armLength(source, frame));
  }
}

TEST_CASE("a grip may keep the relation of one frame") {
  const test::TemporaryFolder folder;
  const Posed posed = pose(folder,
                           heldRecipe("grips", {{"leader", "right-arm"},
                                                {"follower", "left-arm"},
                                                {"range", {10, 30}},
                                                {"relation", 12},
                                                {"blend", {2, 2}}}),
                           {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(posedCharacter);
  const Document file = openedFile(posed.path);
  const Vec3 relation = seenFromHand(source, "right-arm", "left-arm", 12);
  for (const double frame : halfFrames(10, 30)) {
    CHECK(glm::length(seenFromHand(file, "right-arm", "left-arm", frame) - relation) <
          heldShare * source.body.height);
  }
}

TEST_CASE("a prop stays in the hand that holds it") {
  const test::TemporaryFolder folder;
  const std::string character = characterWithStick(folder);
  const Json hands{{"right-arm", oneHand(1.0)}};
  const Posed posed =
      pose(folder, heldRecipe("props", {{"node", "Stick"}, {"bound_at", 0}, {"hands", hands}}), {"--clean"},
           character);
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(character);
  const Document file = openedFile(posed.path);
  const NodeIndex stick(source.scene->nodes.size() - 1);
  const auto inHand = [&](const Document& document, double frame) {
    const Mat4 hand = test::worldOf(document, findLimb(document, "right-arm")->endNode, frame);
    return rig::seenFrom({positionOf(hand), rotationOf(hand)},
                         {test::nodeOf(document, stick, frame), Quat(1, 0, 0, 0)})
        .position;
  };
  for (const double frame : halfFrames(0, 40)) {
    CHECK(glm::length(inHand(file, frame) - inHand(source, 0)) < heldShare * source.body.height);
    CHECK(glm::length(endOf(file, "right-arm", frame) - endOf(source, "right-arm", frame)) <= 0.0);
  }
}

TEST_CASE("two hands stay on a prop until one lets go, and the other then has it alone") {
  const test::TemporaryFolder folder;
  const std::string character = characterWithStick(folder);
  const Json letsGo = Json::array({{{"frame", 0}, {"value", 1}},
                                   {{"frame", 20}, {"value", 1}, {"interpolation", "linear"}},
                                   {{"frame", 24}, {"value", 0}}});
  const Json hands{{"right-arm", letsGo}, {"left-arm", oneHand(1.0)}};
  const Posed posed =
      pose(folder, heldRecipe("props", {{"node", "Stick"}, {"bound_at", 0}, {"hands", hands}}), {"--clean"},
           character);
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(character);
  const Document file = openedFile(posed.path);
  const NodeIndex stick(source.scene->nodes.size() - 1);
  const auto onStick = [&](const Document& document, const char* limb, double frame) {
    const Mat4 world = test::worldOf(document, stick, frame);
    return glm::inverse(rotationOf(world)) * (endOf(document, limb, frame) - positionOf(world));
  };
  for (const double frame : halfFrames(0, 40)) {
    const double limit = heldShare * source.body.height;
    CHECK(glm::length(onStick(file, "left-arm", frame) - onStick(source, "left-arm", 0)) < limit);
    if (frame <= 20.0) {
      CHECK(glm::length(onStick(file, "right-arm", frame) - onStick(source, "right-arm", 0)) < limit);
    }
    if (frame >= 24.0) {
      CHECK(glm::length(endOf(file, "right-arm", frame) - endOf(source, "right-arm", frame)) < limit);
      CHECK(glm::length(endOf(file, "left-arm", frame) - endOf(source, "left-arm", frame)) < limit);
    }
  }
}

TEST_CASE("A prop between hands that turn against each other by half a turn is told with the frame, and by "
          "less is not") {
  const test::TemporaryFolder folder;
  const std::string character = characterWithStick(folder);
  const auto flipsOf = [&](double degrees) {
    Json recipe = heldRecipe("props", {{"node", "Stick"},
                                       {"bound_at", 0},
                                       {"hands", {{"right-arm", oneHand(1.0)}, {"left-arm", oneHand(1.0)}}}});
    recipe["adjustments"] = Json::array({{{"controller", "left-hand"},
                                          {"keys",
                                           {{{"frame", 0}, {"turn", {0, 0, 0}}, {"interpolation", "linear"}},
                                            {{"frame", 24}, {"turn", {0, 0, degrees}}}}}}});
    const Posed posed = pose(folder, recipe, {"--clean"}, character);
    REQUIRE(posed.answer.exitCode == 0);
    std::vector<std::string> told;
    const Json report = Json::parse(posed.answer.output);
    for (const Json& warning : report["warnings"]) {
      if (warning.get<std::string>().find("turns over") != std::string::npos) {
        told.push_back(warning.get<std::string>());
      }
    }
    return told;
  };
  const std::vector<std::string> told = flipsOf(340.0);
  REQUIRE(told.size() == 1);
  CHECK(told[0].starts_with("the prop \"Stick\" turns over by "));
  CHECK(flipsOf(90.0).empty());
}

TEST_CASE("a hand with two keys stays firm on a prop until shortly before the second") {
  const test::TemporaryFolder folder;
  const std::string character = characterWithStick(folder);
  const Json letsGo = Json::array({{{"frame", 0}, {"value", 1}}, {{"frame", 24}, {"value", 0}}});
  const Json hands{{"right-arm", letsGo}, {"left-arm", oneHand(1.0)}};
  const Posed posed =
      pose(folder, heldRecipe("props", {{"node", "Stick"}, {"bound_at", 0}, {"hands", hands}}), {"--clean"},
           character);
  REQUIRE(posed.answer.exitCode == 0);
  const Document source = openedFile(character);
  const Document file = openedFile(posed.path);
  const NodeIndex stick(source.scene->nodes.size() - 1);
  const auto onStick = [&](const Document& document, double frame) {
    const Mat4 world = test::worldOf(document, stick, frame);
    return glm::inverse(rotationOf(world)) * (endOf(document, "right-arm", frame) - positionOf(world));
  };
  const double limit = heldShare * source.body.height;
  for (const double frame : halfFrames(0, 21)) {
    CHECK(glm::length(onStick(file, frame) - onStick(source, 0)) < limit);
  }
  for (const double frame : halfFrames(24, 40)) {
    CHECK(glm::length(endOf(file, "right-arm", frame) - endOf(source, "right-arm", frame)) < limit);
  }
}

TEST_CASE("a limb that is not to stretch falls short of its pin, and the frames are told") {
  const test::TemporaryFolder folder;
  Json pin{{"limb", "left-arm"}, {"range", {8, 12}}, {"place", {0.0, 1.0, 2.0}}, {"stretch", 0}};
  const Posed posed = pose(folder, heldRecipe("pins", pin));
  REQUIRE(posed.answer.exitCode == 0);
  const Json hold = Json::parse(posed.answer.output)["holds"][0];
  CHECK(hold["hold"] == "pin");
  CHECK(hold["limb"] == "left-arm");
  CHECK_FALSE(hold["reached"].get<bool>());
  CHECK(hold["farthest"].get<double>() > 0.5);
  CHECK(hold["falls_short_at"].front() == 8.0);
  CHECK(hold["falls_short_at"].back() == 12.0);
  pin["stretch"] = 1;
  const Json held = Json::parse(pose(folder, heldRecipe("pins", pin)).answer.output)["holds"][0];
  CHECK(held["reached"].get<bool>());
  CHECK(held["farthest"].get<double>() < 1e-9);
}

TEST_CASE("holds are kept in the file, and gone without a trace when they are taken away") {
  const test::TemporaryFolder folder;
  const std::string character = characterWithStick(folder);
  Json recipe =
      heldRecipe("pins", {{"limb", "left-leg"}, {"range", {5, 20}}, {"turn", false}, {"blend", {1, 2}}});
  recipe["grips"] = Json::array({{{"leader", "left-arm"}, {"follower", "right-arm"}, {"range", {0, 9}}}});
  recipe["props"] = Json::array({{{"node", "Stick"},
                                  {"bound_at", 3},
                                  {"range", {2, 30}},
                                  {"turn", {0, 90, 0}},
                                  {"move", {0, 0.1, 0}},
                                  {"hands", {{"left-arm", oneHand(0.5)}}}}});
  const Posed posed = pose(folder, recipe, {}, character);
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  Document file = openedFile(posed.path);
  REQUIRE(file.holds.pins.size() == 1);
  CHECK_FALSE(file.holds.pins[0].turns);
  CHECK(file.holds.pins[0].time == rig::HoldTime{{5, 20}, {1, 2}});
  CHECK(file.holds.grips.size() == 1);
  CHECK(file.holds.props[0].hands[0].keys[0].value == 0.5);
  CHECK(file.holds.props[0].turn.y == Approx(0.5 * pi));
  REQUIRE(saveDocument(file, folder / "again.glb", {}));
  CHECK(*readFile(folder / "again.glb") == *readFile(posed.path));
  Document other = openedFile(character);
  const Result<Recipe> again = recipeFromJson(recipeToJson(file, 0), other);
  REQUIRE(again);
  CHECK(again->holds.pins == file.holds.pins);
  CHECK(again->holds.grips == file.holds.grips);
  CHECK(glm::length(again->holds.props[0].move - file.holds.props[0].move) < 1e-12);
  for (const rig::HoldKind kind : {rig::HoldKind::pin, rig::HoldKind::grip, rig::HoldKind::prop}) {
    file = removeHold(file, {kind, 0});
  }
  REQUIRE(saveDocument(file, folder / "without.glb", {}));
  CHECK(*readFile(folder / "without.glb") == *readFile(character));
}

TEST_CASE("info lists what is held and what is offset") {
  const test::TemporaryFolder folder;
  Json recipe = heldRecipe("pins", {{"limb", "left-leg"}, {"range", {5, 20}}});
  recipe["adjustments"] = lowHips();
  const Posed posed = pose(folder, recipe);
  REQUIRE(posed.answer.exitCode == 0);
  const Json info = Json::parse(test::runVerb({"info", posed.path, "--json"}).output);
  CHECK(info["pins"][0]["limb"] == "left-leg");
  CHECK(info["pins"][0]["range"] == Json::array({5.0, 20.0}));
  CHECK(info["adjustments"][0]["controller"] == "hips");
  CHECK(info["props"].empty());
}

TEST_CASE("info writes a zero without a sign") {
  const test::TemporaryFolder folder;
  Json recipe = heldRecipe("pins", {{"limb", "left-leg"}, {"range", {5, 20}}, {"place", {-0.0, 0.5, -0.0}}});
  recipe["adjustments"] =
      Json::array({{{"controller", "hips"}, {"keys", {{{"frame", 12}, {"move", {-0.0, 0.0, -0.0}}}}}}});
  const Posed posed = pose(folder, recipe);
  REQUIRE(posed.answer.exitCode == 0);
  const std::string info = test::runVerb({"info", posed.path, "--json-line"}).output;
  CHECK(Json::parse(info)["pins"][0]["place"] == Json::array({0.0, 0.5, 0.0}));
  CHECK(info.find("-0.0,") == std::string::npos);
  CHECK(info.find("-0.0]") == std::string::npos);
}

TEST_CASE("pose pins feet where they stand, with a recipe or without") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "planted.glb").string();
  REQUIRE(test::runVerb({"pose", posedCharacter, "-o", output, "--pin-feet"}).exitCode == 0);
  CHECK_FALSE(openedFile(output).holds.pins.empty());
  const std::string other = (folder / "other.glb").string();
  CHECK(test::runVerb({"pose", posedCharacter, "-o", other}).exitCode == 2);
}

TEST_CASE("frames of a recipe's holds and offsets may be parts of the clip") {
  Document document = openedFile(posedCharacter);
  const Clip& clip = clipOf(document, 0);
  const double last = clip.endSeconds * clip.framesPerSecond;
  Json recipe =
      heldRecipe("pins", {{"limb", "left-leg"}, {"range_of_clip", {0.25, 0.5}}, {"at_of_clip", 0.1}});
  recipe["adjustments"] = Json::array({{{"controller", "hips"},
                                        {"range_of_clip", {0.0, 0.5}},
                                        {"keys", {{{"frame_of_clip", 0.25}, {"move", {0, -0.1, 0}}}}}}});
  const Result<Recipe> read = recipeFromJson(recipe, document);
  INFO((read ? std::string() : read.error().line()));
  REQUIRE(read);
  CHECK(read->holds.pins[0].time.rangeFrames.y == Approx(0.5 * last));
  CHECK(read->holds.pins[0].atFrame == Approx(0.1 * last));
  CHECK(read->adjustments[0].rangeFrames->y == Approx(0.5 * last));
  CHECK(read->adjustments[0].keys[0].frame == Approx(0.25 * last));
}

TEST_CASE("a hold that cannot be is told in one line, and nothing is written") {
  const auto grip = [](const char* leader, const char* follower) {
    return Json{{"leader", leader}, {"follower", follower}, {"range", {0, 10}}};
  };
  const Json pin{{"limb", "left-arm"}, {"range", {0, 10}}};
  const auto with = [](Json entry, const char* key, const Json& value) {
    entry[key] = value;
    return entry;
  };
  const Json hands{{"left-arm", oneHand(1.0)}};
  struct Case {
    const char* list;
    Json entries;
    std::string told;
  };
  const std::vector<Case> cases{
      {"pins", {with(pin, "limb", "third-arm")}, "third-arm"},
      {"pins", {with(pin, "limb", "spine")}, "spine"},
      {"pins", {with(pin, "range", {20, 3})}, "ends before it starts"},
      {"pins", {with(pin, "range", {5000, 6000})}, "outside the clip"},
      {"pins", {with(pin, "place", {0, 1e9, 0})}, "out of proportion"},
      {"pins", {with(pin, "place", {0, nullptr, 0})}, "place"},
      {"pins", {with(pin, "stretch", 2)}, "stretch"},
      {"pins", {with(pin, "colour", 2)}, "colour"},
      {"pins", {Json{{"limb", "left-arm"}}}, "range"},
      {"pins", {pin, pin}, "held twice"},
      {"grips", {grip("left-arm", "left-arm")}, "itself"},
      {"grips", {grip("left-arm", "right-arm"), grip("right-arm", "left-arm")}, "circle"},
      {"grips", {with(grip("left-arm", "right-arm"), "relation", "loose")}, "relation"},
      {"props", {Json{{"node", "Bat"}, {"hands", hands}}}, "Bat"},
      {"props", {Json{{"node", "LeftForeArm"}, {"hands", hands}}}, "part of the body"},
      {"props", {Json{{"node", "Hips"}, {"hands", hands}}}, "part of the body"},
      {"props", {Json{{"node", "LeftForeArm"}, {"hands", Json::object()}}}, "hand"},
      {"props", {Json{{"node", "#0"}}}, "hands"}};
  for (const Case& one : cases) {
    INFO(one.entries.dump());
    const test::TemporaryFolder folder;
    const Posed posed = pose(folder, {{"version", 1}, {one.list, one.entries}});
    CHECK(posed.answer.exitCode == 1);
    CHECK_THAT(posed.answer.told, Catch::Contains(one.told));
    CHECK(std::count(posed.answer.told.begin(), posed.answer.told.end(), '\n') == 1);
    CHECK(folder.fileCount() == 1);
  }
}

TEST_CASE("pose --pin-feet leaves a foot to the recipe's own pin and pins the other where it stands") {
  const test::TemporaryFolder folder;
  const Posed posed = pose(
      folder, heldRecipe("pins", {{"limb", "left-leg"}, {"range", {0, 60}}, {"at", 30}, {"stretch", 0.5}}),
      {"--pin-feet"});
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  const std::vector<rig::Pin> pins = openedFile(posed.path).holds.pins;
  const auto isOf = [](const char* limb) { return [limb](const rig::Pin& pin) { return pin.limb == limb; }; };
  REQUIRE(std::ranges::count_if(pins, isOf("left-leg")) == 1);
  const rig::Pin& own = *std::ranges::find_if(pins, isOf("left-leg"));
  CHECK(own.time.rangeFrames == Vec2(0, 60));
  CHECK(own.atFrame == 30.0);
  CHECK(own.stretch == 0.5);
  CHECK(std::ranges::count_if(pins, isOf("right-leg")) >= 1);
}

TEST_CASE("softness moves the knee or elbow alone, of a foot that is lifted and of a hand that is pinned") {
  struct Places {
    Vec3 joint;
    Vec3 end;
  };
  const auto placesOf = [](const Json& recipe, const char* limb) {
    const test::TemporaryFolder folder;
    const Posed posed = pose(folder, recipe, {"--clean"});
    INFO(posed.answer.told);
    REQUIRE(posed.answer.exitCode == 0);
    const Document file = openedFile(posed.path);
    return Places{test::nodeOf(file, findLimb(file, limb)->joints[1], 12.0), endOf(file, limb, 12.0)};
  };
  const auto movedAt12 = [](const char* controller, const Vec3& move) {
    return Json::array(
        {{{"controller", controller},
          {"keys",
           {{{"frame", 6}, {"move", {0, 0, 0}}}, {{"frame", 12}, {"move", {move.x, move.y, move.z}}}}}}});
  };
  const double height = openedFile(posedCharacter).body.height;
  Json lifted{{"version", 1}, {"units", "metres"}, {"adjustments", movedAt12("left-foot", {0, -0.06, 0})}};
  Json pinned = heldRecipe("pins", {{"limb", "right-arm"}, {"range", {6, 20}}, {"at", 6}});
  pinned["adjustments"] = movedAt12("body", {0.0, 0.3, 0.0});
  for (const auto& [limb, plain] : {std::pair("left-leg", lifted), std::pair("right-arm", pinned)}) {
    Json soft = plain;
    soft["adjustments"].push_back(
        {{"attribute", std::string(limb) + ".softness"}, {"keys", {{{"frame", 12}, {"value", 0.3}}}}});
    const Places hard = placesOf(plain, limb);
    const Places softer = placesOf(soft, limb);
    INFO(plain.dump());
    CHECK(glm::length(softer.end - hard.end) < heldShare * height);
    CHECK(glm::length(softer.joint - hard.joint) > 20.0 * heldShare * height);
  }
}
