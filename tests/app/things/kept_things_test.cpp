#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/files/saved_work.h"
#include "app/recipe/recipe.h"
#include "app/things/place.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using rig::KeyInterpolation;

namespace {

constexpr KeyInterpolation interpolations[]{KeyInterpolation::automatic, KeyInterpolation::flat,
                                            KeyInterpolation::linear, KeyInterpolation::stepped,
                                            KeyInterpolation::free};

/// A key of each interpolation; slopes where a key is free, which alone has them.
std::vector<rig::OffsetKey> keysOfEachKind(bool ofAttribute) {
  std::vector<rig::OffsetKey> keys;
  for (const KeyInterpolation interpolation : interpolations) {
    rig::OffsetKey key;
    key.frame = 4.0 + 1.5 * static_cast<double>(keys.size());
    key.interpolation = interpolation;
    const bool isFree = interpolation == KeyInterpolation::free;
    if (ofAttribute) {
      key.value = 0.1 * key.frame - 0.3;
      key.valueSlope = isFree ? 0.02 : 0.0;
    } else {
      key.move = Vec3(0.01, -0.02, 0.03) * key.frame;
      key.turn = Vec3(-0.1, 0.05, 0.02) * key.frame;
      key.moveSlope = isFree ? Vec3(0.004, 0.005, -0.006) : Vec3(0.0);
      key.turnSlope = isFree ? Vec3(0.07, -0.08, 0.09) : Vec3(0.0);
    }
    keys.push_back(key);
  }
  return keys;
}

/// Holds and offsets in which no part is as it is by itself.
Things withEveryPart() {
  Things things = test::oneOfEach(0, 0.4);
  things.adjustments[0].keys = keysOfEachKind(false);
  things.adjustments[1].keys = keysOfEachKind(true);
  rig::Pin& pin = things.holds.pins[0];
  pin.atFrame = 5.5;
  pin.turns = false;
  rig::Pin placed = pin;
  placed.time = {{14.0, 17.0}, {0.5, 0.25}};
  placed.place = rig::HeldPlace{{0.3, -0.4, 1.2}, axisAngle(glm::normalize(Vec3(1, 2, 3)), 0.7)};
  things.holds.pins.push_back(placed);
  things.holds.grips[0].relationFrame = 7.25;
  rig::Prop& prop = things.holds.props[0];
  prop.time = rig::HoldTime{{2.0, 9.0}, {1.5, 2.5}};
  prop.boundFrame.reset();
  prop.move = {0.1, -0.2, 0.3};
  prop.turn = {0.5, 0.6, -0.7};
  prop.stretch = 0.2;
  prop.hands.push_back({"right-arm", keysOfEachKind(true)});
  return things;
}

Document withEveryThing() {
  const Result<Placed> made = place(test::twoPunches(), withEveryPart(), Entry::request);
  INFO(test::refusal(made));
  REQUIRE(made);
  return made->document;
}

// Units of a recipe are divided by and multiplied with: the last bits may differ.
bool isNear(double a, double b) {
  return std::abs(a - b) < 1e-12;
}
bool isNear(const Vec3& a, const Vec3& b) {
  return glm::length(a - b) < 1e-12;
}
bool isNear(const Quat& a, const Quat& b) {
  return std::abs(glm::dot(a, b)) > 1.0 - 1e-12;
}
bool isNear(const rig::OffsetKey& a, const rig::OffsetKey& b) {
  return a.interpolation == b.interpolation && isNear(a.frame, b.frame) && isNear(a.move, b.move) &&
         isNear(a.turn, b.turn) && isNear(a.value, b.value) && isNear(a.moveSlope, b.moveSlope) &&
         isNear(a.turnSlope, b.turnSlope) && isNear(a.valueSlope, b.valueSlope);
}
bool areNear(const std::vector<rig::OffsetKey>& a, const std::vector<rig::OffsetKey>& b) {
  return a.size() == b.size() &&
         std::ranges::equal(a, b, [](const auto& one, const auto& other) { return isNear(one, other); });
}

} // namespace

TEST_CASE("Every part of a hold and of an offset comes back from the saved work") {
  const Document document = withEveryThing();
  Document restored = test::twoPunches();
  restored.scene = document.scene;
  restored.clips = document.clips;
  REQUIRE(restoreWork(workOf(document), restored));
  CHECK(restored.holds == document.holds);
  CHECK(restored.adjustments == document.adjustments);
}

TEST_CASE("Every part of a hold and of an offset comes back from a recipe") {
  const Document document = withEveryThing();
  Document other = test::twoPunches();
  const Result<Recipe> recipe = recipeFromJson(recipeToJson(document, 0), other);
  INFO(test::refusal(recipe));
  REQUIRE(recipe);
  REQUIRE(recipe->adjustments.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(recipe->adjustments[i].controller == document.adjustments[i].controller);
    CHECK(recipe->adjustments[i].rangeFrames == document.adjustments[i].rangeFrames);
    CHECK(areNear(recipe->adjustments[i].keys, document.adjustments[i].keys));
  }
  CHECK(recipe->holds.grips == document.holds.grips);
  REQUIRE(recipe->holds.pins.size() == 2);
  CHECK(recipe->holds.pins[0] == document.holds.pins[0]);
  const rig::Pin& placed = recipe->holds.pins[1];
  CHECK(placed.time == document.holds.pins[1].time);
  REQUIRE(placed.place);
  CHECK(isNear(placed.place->position, document.holds.pins[1].place->position));
  CHECK(isNear(placed.place->orientation, document.holds.pins[1].place->orientation));
  const rig::Prop& prop = recipe->holds.props.at(0);
  const rig::Prop& wanted = document.holds.props[0];
  CHECK(prop.time == wanted.time);
  CHECK_FALSE(prop.boundFrame);
  CHECK(isNear(prop.move, wanted.move));
  CHECK(isNear(prop.turn, wanted.turn));
  CHECK(prop.stretch == wanted.stretch);
  REQUIRE(prop.hands.size() == 2);
  CHECK(prop.hands[1].limb == "right-arm");
  CHECK(areNear(prop.hands[1].keys, wanted.hands[1].keys));
}

TEST_CASE("A recipe counts turns and their slopes in degrees, moves and theirs by one length") {
  const Json recipe = Json::parse(R"({"version": 1, "trails": [], "adjustments": [{"controller": "left-hand",
    "keys": [{"frame": 8, "interpolation": "free", "move": [0.5, 0, 0], "move_slope": [0.05, 0, 0],
              "turn": [0, 90, 0], "turn_slope": [0, 9, 0]}]}]})");
  for (const bool inMetres : {false, true}) {
    CAPTURE(inMetres);
    Json asked = recipe;
    if (inMetres) {
      asked["units"] = "metres";
    }
    Document document = test::twoPunches();
    const Result<Recipe> read = recipeFromJson(asked, document);
    INFO(test::refusal(read));
    REQUIRE(read);
    const rig::OffsetKey& key = read->adjustments.at(0).keys.at(0);
    const double unit = inMetres ? 1.0 : 0.6; // the arm's length
    CHECK(isNear(key.move, Vec3(0.5 * unit, 0.0, 0.0)));
    CHECK(isNear(key.moveSlope, Vec3(0.05 * unit, 0.0, 0.0)));
    CHECK(isNear(key.turn, Vec3(0.0, 0.5 * pi, 0.0)));
    CHECK(isNear(key.turnSlope, Vec3(0.0, 0.05 * pi, 0.0)));
    const Result<Placed> made = place(document, *read, Entry::request);
    REQUIRE(made);
    const Json again = recipeToJson(made->document, 0)["adjustments"][0]["keys"][0];
    CHECK(again["turn_slope"][1].get<double>() == Approx(9.0));
    CHECK(again["turn"][1].get<double>() == Approx(90.0));
    CHECK(again["move_slope"][0].get<double>() == Approx(0.05 * unit / 0.6));
  }
}

TEST_CASE("A prop's moves in a recipe are lengths of the body, or metres") {
  const Json recipe = Json::parse(R"({"version": 1, "trails": [], "props": [{"node": "Stick",
    "move": [0, 0.5, 0], "hands": {"left-arm": [{"frame": 0, "value": 1}]}}]})");
  Json inMetres = recipe;
  inMetres["units"] = "metres";
  Document document = test::twoPunches();
  const Result<Recipe> metres = recipeFromJson(inMetres, document);
  INFO(test::refusal(metres));
  REQUIRE(metres);
  CHECK(metres->holds.props.at(0).move == Vec3(0.0, 0.5, 0.0));
  const Result<Recipe> lengths = recipeFromJson(recipe, document);
  REQUIRE(lengths);
  // As the controller of the body counts.
  const Json moved = Json::parse(R"({"version": 1, "trails": [], "adjustments": [{"controller": "body",
    "keys": [{"frame": 0, "move": [0, 0.5, 0]}]}]})");
  const Result<Recipe> body = recipeFromJson(moved, document);
  REQUIRE(body);
  CHECK(lengths->holds.props.at(0).move == body->adjustments.at(0).keys.at(0).move);
  CHECK(lengths->holds.props.at(0).move != metres->holds.props.at(0).move);
}
