#include <catch2/catch.hpp>

#include "app/schema/adjustment_json.h"
#include "app/schema/hold_json.h"
#include "core/gltf/json/json.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

constexpr AdjustmentUnits world{};
constexpr AdjustmentUnits halves{0.5, 0.25};

template <typename T>
std::string lineOf(const Result<T>& result) {
  return result ? "" : result.error().line();
}

} // namespace

TEST_CASE("Pins, grips and props come back from their text as it stood, to the last byte") {
  for (const AdjustmentUnits& units : {world, halves}) {
    for (const char* const text :
         {R"({"limb":"left-hand","range":[1.0,5.5],"blend":[0.0,2.0],"at":3.0,"turn":false,"stretch":0.4})",
          R"({"limb":"left-hand","range":[1.0,5.0],"blend":[0.0,0.0],"at":1.0,"turn":true,"stretch":1.0,)"
          R"("place":[1.0,0.0,3.0],"orientation":[0.0,0.0,0.6,0.8]})"}) {
      const Result<rig::Pin> pin = pinFromJson(Json::parse(text), units, {});
      REQUIRE(pin);
      CHECK(pinToJson(*pin, units).dump() == text);
    }
    for (
        const char* const text :
        {R"({"node":"bat","bound_at":0.0,"move":[0.0,0.0,0.0],"turn":[0.0,0.0,0.0],"stretch":1.0,"hands":{}})",
         R"({"node":"bat","bound_at":"source","range":[0.0,4.0],"blend":[1.0,2.0],"move":[1.0,2.0,3.0],)"
         R"("turn":[0.0,90.0,0.0],"stretch":0.2,"hands":{"right-arm":[{"frame":0.0,"interpolation":"auto",)"
         R"("value":1.0},{"frame":4.0,"interpolation":"free","value":0.0,"value_slope":0.5}],"left-arm":[]}})"}) {
      const Result<rig::Prop> prop = propFromJson(Json::parse(text), units, {});
      REQUIRE(prop);
      CHECK(propToJson(*prop, units).dump() == text);
    }
  }
  for (
      const char* const text :
      {R"({"leader":"a","follower":"b","range":[0.0,9.0],"blend":[0.0,0.0],"relation":"source","stretch":1.0})",
       R"({"leader":"a","follower":"b","range":[0.0,9.0],"blend":[1.0,1.0],"relation":4.25,"stretch":0.5})"}) {
    const Result<rig::Grip> grip = gripFromJson(Json::parse(text), {});
    REQUIRE(grip);
    CHECK(gripToJson(*grip).dump() == text);
  }
}

TEST_CASE("Offsets come back from their text as it stood, to the last byte") {
  for (const AdjustmentUnits& units : {world, halves}) {
    for (const std::string text :
         {R"({"controller":"left-hand","keys":[{"frame":1.0,"interpolation":"free","move":[1.0,1.0,1.0],)"
          R"("turn":[0.0,0.0,0.0],"move_slope":[1.0,0.0,0.0],"turn_slope":[0.0,2.0,0.0]},{"frame":3.0,)"
          R"("interpolation":"auto","move":[0.5,0.0,0.0],"turn":[10.0,0.0,0.0]}]})",
          R"({"attribute":"left-hand.curl","range":[0.0,5.0],"keys":[{"frame":3.0,"interpolation":"flat",)"
          R"("value":0.3},{"frame":4.0,"interpolation":"stepped","value":1.0},{"frame":5.0,)"
          R"("interpolation":"free","value":1.0,"value_slope":0.1}]})"}) {
      const Result<rig::Adjustment> read = adjustmentFromJson(Json::parse(text), units, {});
      REQUIRE(read);
      CHECK(adjustmentToJson(*read, text.starts_with(R"({"attribute")"), units).dump() == text);
    }
  }
  const Result<rig::Adjustment> unsorted = adjustmentFromJson(
      Json::parse(R"({"controller":"x","keys":[{"frame":3,"move":[2,0,0]},{"frame":1}]})"), halves, {});
  REQUIRE(unsorted);
  CHECK(unsorted->keys.front().frame == 1.0);
  CHECK(unsorted->keys.back().move == Vec3(1.0, 0.0, 0.0));
}

TEST_CASE("What is wrong in a hold or an offset is told by its key") {
  const auto pin = [](const char* text) { return lineOf(pinFromJson(Json::parse(text), world, {"clip"})); };
  const auto offsets = [](const char* text) {
    return lineOf(adjustmentFromJson(Json::parse(text), world, {"clip"}));
  };
  using Catch::Contains;
  CHECK_THAT(pin("7"), Contains("7 is not an object"));
  CHECK_THAT(pin(R"({"range":[1,2]})"), Contains("limb: is missing"));
  CHECK_THAT(pin(R"({"limb":7,"range":[1,2]})"), Contains("limb: 7 is not a name"));
  CHECK_THAT(pin(R"({"limb":"l","range":[1]})"), Contains("range: [1] is not a pair of frames"));
  CHECK_THAT(pin(R"({"limb":"l","range":[1,2],"turn":1})"), Contains("turn: 1 is neither true nor false"));
  CHECK_THAT(pin(R"({"limb":"l","range":[1,2],"at":"x"})"), Contains("at: \"x\" is not a number"));
  CHECK_THAT(pin(R"({"limb":"l","range":[1,2],"place":[1]})"), Contains("place: [1] is not a vector"));
  CHECK_THAT(pin(R"({"limb":"l","range":[1,2],"foo":1})"), Contains("foo: is not a part of it"));
  CHECK(pin(R"({"limb":"l","range":[1,2],"clip":1})").empty());
  CHECK_THAT(offsets(R"({"controller":"x","range":[1,"a"]})"), Contains("range: [1,\"a\"] is not a range"));
  CHECK_THAT(offsets(R"({"controller":"x","foo":1})"), Contains("foo: is not a part of an adjustment"));
  CHECK_THAT(offsets(R"({"controller":"x","keys":[{"frame":1,"value":3}]})"),
             Contains("keys[0].value: is not a part of a controller's key"));
  CHECK_THAT(offsets(R"({"attribute":"x","keys":[{"frame":1}]})"),
             Contains("keys[0]: {\"frame\":1} is not a key"));
  CHECK_THAT(offsets(R"({"controller":"x","keys":[{"frame":1,"interpolation":"foo"}]})"),
             Contains("keys[0].interpolation: \"foo\" is no interpolation"));
  CHECK(offsets(R"({"controller":"x","keys":[],"clip":1})").empty());
  const Result<rig::Prop> prop = propFromJson(Json::parse(R"({"node":"bat","hands":[]})"), world, {});
  CHECK_THAT(lineOf(prop), Contains("hands: is not an object"));
}

TEST_CASE("A pin without a frame stands where its range begins, and at a place it turns only as it is told") {
  const auto pin = [](const char* more) {
    const Result<rig::Pin> read =
        pinFromJson(Json::parse(R"({"limb":"l","range":[4,9])" + std::string(more) + "}"), halves, {});
    REQUIRE(read);
    return *read;
  };
  CHECK(pin("").atFrame == 4.0);
  CHECK(pin(R"(,"at":7)").atFrame == 7.0);
  CHECK(pin("").turns);
  CHECK_FALSE(pin("").place);
  const rig::Pin placed = pin(R"(,"place":[2,0,0])");
  REQUIRE(placed.place);
  CHECK(placed.place->position == Vec3(1.0, 0.0, 0.0));
  CHECK_FALSE(placed.turns);
  CHECK(pin(R"(,"place":[2,0,0],"orientation":[0,0,0,1])").turns);
  CHECK_FALSE(pin(R"(,"place":[2,0,0],"orientation":[0,0,0,1],"turn":false)").turns);
}

TEST_CASE("What a prop or an offset says by halves, or twice, is refused") {
  const auto prop = [](const char* more) {
    return lineOf(
        propFromJson(Json::parse(R"({"node":"bat","hands":{})" + std::string(more) + "}"), world, {}));
  };
  const auto offsets = [](const char* text) {
    return lineOf(adjustmentFromJson(Json::parse(text), world, {}));
  };
  using Catch::StartsWith;
  CHECK(prop("").empty());
  CHECK(prop(R"(,"range":[1,5])").empty());
  CHECK(prop(R"(,"range":[1,5],"blend":[1,2])").empty());
  CHECK_THAT(prop(R"(,"blend":[1,2])"), StartsWith("blend: comes with no range"));
  CHECK_THAT(prop(R"(,"bound_at":"start")"), StartsWith("bound_at: \"start\" is no relation"));
  CHECK_THAT(lineOf(propFromJson(Json::parse(R"({"node":"bat"})"), world, {})),
             StartsWith("hands: is missing"));
  const Json hand = Json::parse(R"({"node":"bat","hands":{"left-arm":[{"frame":2,"value":1},{"frame":2}]}})");
  CHECK_THAT(lineOf(propFromJson(hand, world, {})), StartsWith("hands.left-arm.keys[1]: "));
  const std::string none = "names no controller and no attribute, or both";
  CHECK_THAT(offsets(R"({"keys":[]})"), StartsWith(none));
  CHECK_THAT(offsets(R"({"controller":"x","attribute":"y","keys":[]})"), StartsWith(none));
  CHECK_THAT(offsets(R"({"controller":"x","keys":3})"), StartsWith("keys: is not a list"));
  CHECK_THAT(offsets(R"({"controller":"x","keys":[{"frame":3},{"frame":1},{"frame":3.0004}]})"),
             StartsWith("keys: two keys stand at frame 3"));
  CHECK(offsets(R"({"controller":"x","keys":[{"frame":3},{"frame":3.01}]})").empty());
}
