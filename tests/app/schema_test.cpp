#include <set>

#include <catch2/catch.hpp>

#include "app/schema/parse_text.h"
#include "app/schema/schema_json.h"
#include "app/schema/sequence_schema.h"
#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "tests/support/app/other_value.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::otherValue;

namespace {

std::string textOfValue(const Json& value) {
  std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  std::erase_if(text, [](char letter) { return letter == '[' || letter == ']'; });
  return text;
}

template <typename Settings>
void checkNames(const Schema<Settings>& schema) {
  std::set<std::string> names;
  std::set<std::string> options;
  for (const Setting<Settings>& setting : schema) {
    INFO(setting.name);
    CHECK(names.insert(setting.name).second);
    CHECK(options.insert(setting.option).second);
    CHECK((setting.help.back() == '.' && setting.minimum <= setting.maximum));
    CHECK_FALSE(labelOf(setting).empty());
    CHECK(setting.row.minimum.value_or(setting.minimum) <= setting.row.maximum.value_or(setting.maximum));
  }
}

template <typename Settings>
void checkValues(const Schema<Settings>& schema) {
  for (const Setting<Settings>& setting : schema) {
    INFO(setting.name);
    Settings settings;
    CHECK(setSetting(setting, setting.read(settings), settings));
    CHECK(settings == Settings{});
    const Json other = otherValue(setting);
    REQUIRE(setSetting(setting, other, settings));
    CHECK(setting.read(settings) == other);
    CHECK_FALSE(settings == Settings{});
    for (const Json& wrong : {Json::object(), Json::array({1, 2, 3, 4}), Json("much more")}) {
      if (wrong.is_string() && setting.kind == SettingKind::text) {
        continue; // any text is a name; whether something has it, the door asks
      }
      Settings unchanged;
      const Status set = setSetting(setting, wrong, unchanged);
      REQUIRE_FALSE(set);
      CHECK(set.error().where == setting.name);
      CHECK(unchanged == Settings{});
    }
    const bool isRanged = setting.kind == SettingKind::number || setting.kind == SettingKind::whole;
    for (const double outside : {setting.minimum - 1.0, setting.maximum * 2.0 + 1.0}) {
      CHECK((!isRanged || !setSetting(setting, outside, settings)));
    }
  }
}

template <typename Settings>
void checkTexts(const Schema<Settings>& schema) {
  for (const Setting<Settings>& setting : schema) {
    INFO(setting.name);
    const Json other = otherValue(setting);
    const Result<Json> value = valueOfText(setting, textOfValue(other));
    REQUIRE(value.ok());
    CHECK(*value == other);
    if (setting.kind != SettingKind::flag && setting.kind != SettingKind::text) {
      const Result<Json> wrong = valueOfText(setting, "many,");
      REQUIRE_FALSE(wrong.ok());
      CHECK(wrong.error().where == setting.option);
    }
  }
}

template <typename Settings>
Settings changedEverywhere(const Schema<Settings>& schema) {
  Settings settings;
  for (const Setting<Settings>& setting : schema) {
    REQUIRE(setSetting(setting, otherValue(setting), settings));
  }
  return settings;
}

} // namespace

TEST_CASE("Every setting has names of its own and a sentence of help") {
  checkNames(trailSchema());
  checkNames(weightSchema());
  checkNames(sequenceSchema());
  checkNames(clipSchema());
}

TEST_CASE("Every setting takes its default and another value, and refuses what it cannot be") {
  checkValues(trailSchema());
  checkValues(weightSchema());
  checkValues(sequenceSchema());
  checkValues(clipSchema());
}

TEST_CASE("Every setting is read from the text of its option") {
  checkTexts(trailSchema());
  checkTexts(weightSchema());
  checkTexts(sequenceSchema());
  checkTexts(clipSchema());
}

TEST_CASE("Settings go through JSON as they were") {
  const WeightSettings weight = changedEverywhere(weightSchema());
  WeightSettings read;
  REQUIRE(weightFromJson(weightToJson(weight), {}, read));
  CHECK(read == weight);
}

TEST_CASE("A trail's settings come back from JSON as they were, with offsets in the unit asked for") {
  rig::TrailSettings settings = changedEverywhere(trailSchema());
  settings.startFrame = 3.0;
  settings.endFrame = 11.5;
  settings.spheres = {{4.0, Vec3(0.25, 0.5, -1.0)}, {9.0, Vec3(0.0, 0.0, 2.0)}};
  settings.stopAt = rig::StopPlane{Vec3(0, 1, 0), Vec3(0, 0, 1)};
  settings.viewAxes = Mat3(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(-1, 0, 0));
  settings.space = rig::TrailSpace::view;
  settings.sight.view = cameraFrom(Vec3(0.0, 0.0, 1.0));
  settings.sight.view->kind = GENERATE(CameraKind::perspective, CameraKind::orthographic);
  settings.sight.view->position = Vec3(0.25, 1.0, 4.0);
  const double lengthUnit = GENERATE(1.0, 0.5);
  const Json json = trailToJson(settings, lengthUnit);
  CHECK(json["spheres"][1]["offset"][2] == 2.0 / lengthUnit);
  CHECK(json["seen_view"]["position"][2] == 4.0 / lengthUnit);
  rig::TrailSettings read;
  REQUIRE(trailFromJson(json, lengthUnit, {}, read));
  CHECK(read == settings);
}

TEST_CASE("A view that judges a trail has a kind, a place and two directions, or is none") {
  rig::TrailSettings settings;
  const auto read = [&](const char* view) {
    return trailFromJson(Json{{"seen_view", Json::parse(view)}}, 1.0, {}, settings);
  };
  REQUIRE(read(R"({"kind": "orthographic", "position": [0, 1, 5], "right": [2, 0, 0], "up": [0, 3, 0]})"));
  CHECK(settings.sight.view->right == Vec3(1.0, 0.0, 0.0));
  CHECK(settings.sight.view->up == Vec3(0.0, 1.0, 0.0));
  CHECK(settings.sight.view->forward == Vec3(0.0, 0.0, -1.0));
  REQUIRE(read("null"));
  CHECK_FALSE(settings.sight.view);
  for (const char* const wrong :
       {"3", R"({"kind": "fisheye", "position": [0, 1, 5], "right": [1, 0, 0], "up": [0, 1, 0]})",
        R"({"position": [0, 1, 5], "right": [1, 0, 0], "up": [0, 1, 0]})",
        R"({"kind": "perspective", "right": [1, 0, 0], "up": [0, 1, 0]})",
        R"({"kind": "perspective", "position": [0, 1], "right": [1, 0, 0], "up": [0, 1, 0]})",
        R"({"kind": "perspective", "position": [0, 1, 5], "right": [0, 2, 0], "up": [0, 1, 0]})"}) {
    INFO(wrong);
    const Status refused = read(wrong);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().where, Catch::StartsWith("seen_view"));
    CHECK_FALSE(settings.sight.view);
  }
}

TEST_CASE("A wrong value is told in plain words") {
  rig::TrailSettings settings;
  const Setting<rig::TrailSettings>* const blend = findSetting(trailSchema(), "blend");
  REQUIRE(blend != nullptr);
  CHECK(setSetting(*blend, 1000.0, settings).error().line() ==
        "blend: 1000 is not possible; give a number from 0 to 2");
  CHECK(valueOfText(*blend, "much").error().line() ==
        "--blend: 'much' is not a number; give one number, such as 2 or 0.5");
}

TEST_CASE("A range of weight is two frames in order, or none") {
  WeightSettings settings;
  settings.rangeFrames = Vec2(1.0, 2.0);
  REQUIRE(weightFromJson(Json{{"range", {3, 12.5}}}, {}, settings));
  CHECK(settings.rangeFrames == Vec2(3.0, 12.5));
  REQUIRE(weightFromJson(Json{{"range", nullptr}}, {}, settings));
  CHECK_FALSE(settings.rangeFrames);
  for (const char* const range : {"[]", "[3]", "[3, 12, 20]", "[3, \"12\"]", "[\"3\", 12]", "[12, 3]",
                                  "[3, 3]", "3", "\"3:12\"", "{\"0\": 3}"}) {
    INFO(range);
    const Status read = weightFromJson(Json{{"range", Json::parse(range)}}, {}, settings);
    REQUIRE_FALSE(read.ok());
    CHECK_THAT(read.error().line(), Catch::Contains("is not a range"));
  }
}

TEST_CASE("A damaged value is brought near, or left out") {
  const SettingFacts& blend = *findSetting(trailSchema(), "blend");
  const SettingFacts& pivot = *findSetting(trailSchema(), "pivot");
  CHECK(nearestValue(blend, 17) == Json(2.0));
  CHECK_FALSE(nearestValue(blend, "big"));
  CHECK(nearestValue(pivot, 1) == Json("end"));
  CHECK(nearestValue(pivot, 99) == Json("end"));
  CHECK_FALSE(nearestValue(pivot, "middle"));
}

TEST_CASE("The text of a vector is three numbers, with commas or without") {
  for (const char* text : {"0,-9.81,2", "0, -9.81, 2", "0 -9.81 2"}) {
    INFO(text);
    CHECK(parseVector(text, "--gravity").value() == Vec3(0.0, -9.81, 2.0));
  }
  for (const char* text : {"", "1 2", "1,2", "1 2 3 4", "a,b,c", "1,2,nan"}) {
    INFO(text);
    CHECK_FALSE(parseVector(text, "--gravity"));
  }
}

TEST_CASE("The text of an option is one number, or nothing is taken") {
  CHECK(parseNumber("-2.5e3", "--scale").value() == -2500.0);
  for (const char* text : {"", "2x", " 2", "nan", "inf", "1,5", "--"}) {
    INFO(text);
    const Result<double> number = parseNumber(text, "--scale");
    REQUIRE_FALSE(number);
    CHECK(number.error().where == "--scale");
  }
}
