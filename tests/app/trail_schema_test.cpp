#include <set>

#include <catch2/catch.hpp>

#include "app/schema/trail_description.h"
#include "app/schema/trail_json.h"
#include "core/gltf/json.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

// A value of the setting that is not its default.
Json otherValue(const TrailSetting& setting) {
  const Json standard = setting.read({});
  switch (setting.kind) {
  case SettingKind::number:
    return standard == setting.maximum ? setting.minimum : setting.maximum;
  case SettingKind::optionalNumber:
    return 7.5;
  case SettingKind::flag:
    return !standard.get<bool>();
  case SettingKind::choice:
    return standard == setting.choices.back() ? setting.choices.front() : setting.choices.back();
  case SettingKind::axes:
    return "y";
  case SettingKind::ease:
    return Json::array({0.25, 0.75});
  }
  return nullptr;
}

} // namespace

TEST_CASE("Every setting of a trail has names of its own and a sentence of help") {
  std::set<std::string> names;
  std::set<std::string> options;
  for (const TrailSetting& setting : trailSettings()) {
    INFO(setting.name);
    CHECK(names.insert(setting.name).second);
    CHECK((setting.option.empty() || options.insert(setting.option).second));
    CHECK(setting.help.back() == '.');
    CHECK(setting.minimum <= setting.maximum);
  }
}

TEST_CASE("Every setting takes its default and another value, and gives back what it took") {
  for (const TrailSetting& setting : trailSettings()) {
    INFO(setting.name);
    rig::TrailSettings settings;
    CHECK(setTrailSetting(setting, setting.read(settings), settings));
    CHECK(settings == rig::TrailSettings{});
    const Json other = otherValue(setting);
    REQUIRE(setTrailSetting(setting, other, settings));
    CHECK(setting.read(settings) == other);
    CHECK_FALSE(settings == rig::TrailSettings{});
  }
}

TEST_CASE("A value of the wrong kind or out of range is refused and changes nothing") {
  for (const TrailSetting& setting : trailSettings()) {
    INFO(setting.name);
    std::vector<Json> wrong{Json::object(), Json::array({1, 2, 3})};
    if (setting.kind == SettingKind::number) {
      wrong.insert(wrong.end(), {setting.minimum - 1.0, setting.maximum + 1.0, "2", nullptr});
    }
    for (const Json& value : wrong) {
      rig::TrailSettings settings;
      const Status set = setTrailSetting(setting, value, settings);
      REQUIRE_FALSE(set);
      CHECK(set.error().where == setting.name);
      CHECK(settings == rig::TrailSettings{});
    }
  }
}

TEST_CASE("Settings come back from JSON as they were, with offsets in the unit asked for") {
  rig::TrailSettings settings;
  for (const TrailSetting& setting : trailSettings()) {
    REQUIRE(setTrailSetting(setting, otherValue(setting), settings));
  }
  settings.startFrame = 3.0;
  settings.endFrame = 11.5;
  settings.spheres = {{4.0, Vec3(0.25, 0.5, -1.0)}, {9.0, Vec3(0.0, 0.0, 2.0)}};
  settings.stopAt = rig::StopPlane{Vec3(0, 1, 0), Vec3(0, 0, 1)};
  settings.viewAxes = Mat3(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(-1, 0, 0));
  settings.space = rig::TrailSpace::view;
  const double lengthUnit = GENERATE(1.0, 0.5);
  const Json json = settingsToJson(settings, lengthUnit);
  CHECK(json["spheres"][1]["offset"][2] == 2.0 / lengthUnit);
  rig::TrailSettings read;
  REQUIRE(settingsFromJson(json, lengthUnit, {}, read));
  CHECK(read == settings);
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
