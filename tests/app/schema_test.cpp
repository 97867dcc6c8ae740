#include <cmath>
#include <optional>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/schema/import_schema.h"
#include "app/schema/parse_text.h"
#include "app/schema/schema_json.h"
#include "app/schema/sequence_schema.h"
#include "app/schema/style_schema.h"
#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "tests/support/app/other_value.h"
#include "tests/support/recorded.h"

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
  checkNames(importSchema());
}

TEST_CASE("Every setting takes its default and another value, and refuses what it cannot be") {
  checkValues(trailSchema());
  checkValues(weightSchema());
  checkValues(sequenceSchema());
  checkValues(clipSchema());
  checkValues(importSchema());
}

TEST_CASE("Every setting is read from the text of its option") {
  checkTexts(trailSchema());
  checkTexts(weightSchema());
  checkTexts(sequenceSchema());
  checkTexts(clipSchema());
  checkTexts(importSchema());
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

TEST_CASE("The axes of a view are three vectors, no fewer and no more") {
  rig::TrailSettings settings;
  const auto read = [&](const char* axes) {
    return trailFromJson(Json{{"view_axes", Json::parse(axes)}}, 1.0, {}, settings);
  };
  REQUIRE(read("[[0, 0, 1], [0, 1, 0], [-1, 0, 0]]"));
  CHECK(settings.viewAxes == Mat3(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(-1, 0, 0)));
  for (const char* const wrong :
       {"3", "[[0, 0, 1], [0, 1, 0]]", "[[0, 0, 1], [0, 1, 0], [-1, 0, 0], [1, 0, 0]]"}) {
    const Status refused = read(wrong);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().what == Json::parse(wrong).dump() + " is not a set of axes");
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

namespace {

std::string numberText(const std::optional<double>& number) {
  return number ? fmt::format("{:g}", *number) : "-";
}

template <typename Settings>
std::string tableOf(const std::string& title, const Schema<Settings>& schema) {
  std::string text = title + "\n";
  for (const Setting<Settings>& setting : schema) {
    const SettingRow& row = setting.row;
    std::string choices;
    for (const SettingChoice& choice : setting.choices) {
      choices += " " + choice.name;
    }
    text += fmt::format("{} {}: takes {}{}{}, at first {}\n", setting.option, setting.name,
                        takenValues(setting), choices.empty() ? "" : " of", choices, setting.standard);
    text +=
        fmt::format("  shown in '{}' as '{}', from {} to {} by {:g} or {:g}, {}'{}' times {:g} in '{}'{}\n",
                    row.section, labelOf(setting), numberText(row.minimum), numberText(row.maximum), row.step,
                    row.fineStep, row.percent ? "per cent, " : "", row.prefix, row.shownFactor, row.shownUnit,
                    row.typed ? ", typed" : "");
  }
  return text;
}

template <typename Settings>
void checkEdges(const Schema<Settings>& schema) {
  for (const Setting<Settings>& setting : schema) {
    INFO(setting.name);
    const bool isVector = setting.kind == SettingKind::vector;
    const bool isNumber = setting.kind == SettingKind::number || setting.kind == SettingKind::whole ||
                          setting.kind == SettingKind::optionalNumber;
    if (!isVector && !isNumber) {
      continue;
    }
    const auto takes = [&](double number) {
      if (!isVector) {
        return checkValue(setting, number).ok();
      }
      bool each = true;
      bool any = false;
      for (std::size_t place = 0; place < 3; ++place) {
        Json vector = Json::array({setting.minimum, setting.maximum, setting.minimum});
        vector[place] = number;
        const bool taken = checkValue(setting, vector).ok();
        each = each && taken;
        any = any || taken;
      }
      CHECK(each == any); // each of the three is looked at
      return each;
    };
    const double beside = 1e-9 + 1e-9 * std::abs(setting.maximum);
    CHECK(takes(setting.minimum));
    CHECK(takes(setting.maximum));
    CHECK_FALSE(takes(setting.minimum - std::max(1e-9 * std::abs(setting.minimum), 1e-35)));
    CHECK_FALSE(takes(setting.maximum + beside));
    if (setting.kind == SettingKind::whole) {
      CHECK_FALSE(takes(setting.minimum + 0.5));
    }
    CHECK(checkValue(setting, nullptr).ok() == (setting.kind == SettingKind::optionalNumber));
  }
}

} // namespace

TEST_CASE("Every setting is offered as it was looked at") {
  const std::string difference = test::differenceFromRecord(
      "settings", tableOf("trail", trailSchema()) + tableOf("weight", weightSchema()) +
                      tableOf("sequence", sequenceSchema()) + tableOf("clip", clipSchema()) +
                      tableOf("style", styleSchema()));
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE(
    "Every number of a setting is taken from its least to its largest, both included, and none beyond") {
  checkEdges(trailSchema());
  checkEdges(weightSchema());
  checkEdges(sequenceSchema());
  checkEdges(clipSchema());
  checkEdges(styleSchema());
}

TEST_CASE("A setting says what it takes, and how it is called, by its kind") {
  const auto taken = [](const auto& schema, const char* name) {
    return takenValues(*findSetting(schema, name));
  };
  CHECK(taken(trailSchema(), "blend") == "a number from 0 to 2");
  CHECK(taken(trailSchema(), "release") == "a number from 0 to 100000 frames");
  CHECK(taken(sequenceSchema(), "bones") == "a whole number from 1 to 1000");
  CHECK(taken(trailSchema(), "pull") == "true or false");
  CHECK(taken(trailSchema(), "axes") == "any of x, y, z");
  CHECK(taken(trailSchema(), "ease_in") == "a fraction below 1 and a value from 0 to 1");
  CHECK(taken(weightSchema(), "gravity") == "three numbers from -1000 to 1000 m/s^2");
  CHECK(taken(trailSchema(), "camera") == "a name");
  CHECK(taken(trailSchema(), "pivot") == "one of start, end");
  const auto label = [](const char* name) { return labelOf(*findSetting(trailSchema(), name)); };
  CHECK(label("turn_end") == "Turn end");
  CHECK(label("stay_in_world") == "Keep place");
  CHECK(label("scale") == "Scale");
}

TEST_CASE("An ease is a fraction below the whole and a value within it, in two numbers") {
  const SettingFacts& ease = *findSetting(trailSchema(), "ease_in");
  for (const char* const good : {"[0, 0]", "[0.999, 1]", "[0.5, 0.25]"}) {
    CHECK(checkValue(ease, Json::parse(good)));
  }
  for (const char* const bad : {"[1, 0]", "[-0.1, 0]", "[0, 1.1]", "[0, -0.1]", "[0]", "[0, 0, 0]",
                                "[\"0\", 0]", "[0, null]", "0", "null"}) {
    INFO(bad);
    CHECK_FALSE(checkValue(ease, Json::parse(bad)));
  }
  CHECK(valueOfText(ease, "0.6,0.1").value() == Json::array({0.6, 0.1}));
  const auto refused = [&](const char* text) { return valueOfText(ease, text).error().line(); };
  CHECK(refused("0.6") == "--ease-in: '0.6' has no comma; give a fraction and a value, such as 0.6,0.1");
  CHECK(refused("a,0.1") == "--ease-in: 'a' is not a number; give one number, such as 2 or 0.5");
  CHECK(refused("0.6,b") == "--ease-in: 'b' is not a number; give one number, such as 2 or 0.5");
  CHECK(refused("2,0") ==
        "--ease-in: '2,0' is not possible; give a fraction below 1 and a value from 0 to 1");
}

TEST_CASE("Per cent may be written with its sign where it is the unit, and nowhere else") {
  CHECK(valueOfText(*findSetting(sequenceSchema(), "tolerance"), "0.5%").value() == Json(0.5));
  CHECK(valueOfText(*findSetting(clipSchema(), "key_tolerance"), "0.5%").value() == Json(0.5));
  CHECK_FALSE(valueOfText(*findSetting(trailSchema(), "blend"), "0.5%"));
  CHECK_FALSE(valueOfText(*findSetting(sequenceSchema(), "tolerance"), "%"));
  // A switch that is given says the opposite of what stands without it.
  CHECK(valueOfText(*findSetting(trailSchema(), "pull"), "").value() == Json(false));
  CHECK(valueOfText(*findSetting(trailSchema(), "turn_end"), "").value() == Json(true));
}

TEST_CASE("A text that is no number, vector or range is told with what it was") {
  const auto line = [](const auto& result) {
    REQUIRE_FALSE(result);
    return result.error().line();
  };
  CHECK(line(parseNumber("two", "--scale")) ==
        "--scale: 'two' is not a number; give one number, such as 2 or 0.5");
  CHECK(line(parseVector("1,2", "--gravity")) ==
        "--gravity: '1,2' is not a vector; give three numbers, such as 0,-9.81,0");
  CHECK(line(parseRange("5", "--range")) ==
        "--range: '5' is not a range; give the first and the last frame, such as 0:12");
  CHECK(line(parseRange("a:5", "--range")) ==
        "--range: 'a' is not a number; give one number, such as 2 or 0.5");
  CHECK(line(parseRange("5:", "--range")) ==
        "--range: '' is not a number; give one number, such as 2 or 0.5");
  CHECK(line(parseRange("6:5", "--range")) ==
        "--range: the first frame comes after the last; give them in order");
  CHECK(parseRange("5:5", "--range").value() == Vec2(5.0, 5.0));
  CHECK(parseRange("-2.5:12", "--range").value() == Vec2(-2.5, 12.0));
}
