#include "app/schema/weight_description.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/schema/trail_description.h"
#include "app/schema/trail_json.h"
#include "core/gltf/json.h"

namespace stretch::app {

namespace {

using gltf::Json;
using S = WeightSettings;

constexpr double softestModulus = 1.0;
constexpr double hardestModulus = 1e12;

WeightSetting number(std::string name, double minimum, double maximum, std::string unit, std::string help,
                     double S::*member) {
  return {name,
          "--" + name,
          WeightSettingKind::number,
          minimum,
          maximum,
          std::move(unit),
          std::move(help),
          [member](const S& s) { return Json(s.*member); },
          [member](const Json& v, S& s) { s.*member = v.get<double>(); }};
}

WeightSetting young() {
  return {
      "young",
      "--young",
      WeightSettingKind::optionalNumber,
      softestModulus,
      hardestModulus,
      "Pa",
      fmt::format("Young's modulus of the flesh; default: a limb at rest gives way by {:g} % of its length.",
                  100.0 * stillSag),
      [](const S& s) { return s.youngModulus ? Json(*s.youngModulus) : Json(nullptr); },
      [](const Json& v, S& s) {
        s.youngModulus = v.is_null() ? std::optional<double>() : std::optional<double>(v.get<double>());
      }};
}

WeightSetting gravity() {
  return {"gravity",
          "--gravity",
          WeightSettingKind::vector,
          -1000.0,
          1000.0,
          "m/s^2",
          "Gravity along x, y, z of the scene; 0,0,0 leaves inertia alone.",
          [](const S& s) { return vectorToJson(s.gravity); },
          [](const Json& v, S& s) {
            s.gravity = Vec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
          }};
}

std::vector<WeightSetting> weightTable() {
  return {
      number("amount", 0.0, 1.0, "", "Share of the effect that is shown; 0 is the clip as it was.",
             &S::amount),
      number("stiffness", 0.01, 100.0, "", "Multiplies the moduli and quickens the response.", &S::stiffness),
      number("damping", 0.0, 10.0, "", "1 comes to rest without swinging over, below it the limb wobbles.",
             &S::damping),
      number("inertia", 0.0, 1.0, "", "How much of the limb's own acceleration counts beside gravity.",
             &S::inertia),
      gravity(),
      young(),
      number("density", 0.0, 100000.0, "kg/m^3", "Density of the limb and of the body that stands on it.",
             &S::density),
  };
}

bool isNumberWithin(const Json& value, const WeightSetting& setting) {
  return value.is_number() && value.get<double>() >= setting.minimum &&
         value.get<double>() <= setting.maximum;
}

bool isValid(const WeightSetting& setting, const Json& value) {
  switch (setting.kind) {
  case WeightSettingKind::number:
    return isNumberWithin(value, setting);
  case WeightSettingKind::optionalNumber:
    return value.is_null() || isNumberWithin(value, setting);
  case WeightSettingKind::vector:
    return value.is_array() && value.size() == 3 &&
           std::all_of(value.begin(), value.end(), [&](const Json& v) { return isNumberWithin(v, setting); });
  }
  return false;
}

Status readRange(const Json& json, S& settings) {
  const bool isRange = json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number() &&
                       json[0].get<double>() < json[1].get<double>();
  if (!isRange && !json.is_null()) {
    return Error{json.dump() + " is no range", "range", "give the first and the last frame, such as [0, 12]"};
  }
  settings.rangeFrames =
      isRange ? std::optional(Vec2(json[0].get<double>(), json[1].get<double>())) : std::nullopt;
  return Success{};
}

Status readModuli(const Json& json, S& settings) {
  const Result<skinning::SegmentModuli> moduli = skinning::parseModuli(Json{{"segments", json}}.dump());
  if (!moduli) {
    return moduli.error();
  }
  settings.moduli = moduli->ranges;
  return Success{};
}

Status readEntry(const std::string& key, const Json& value, S& settings) {
  if (key == "range") {
    return readRange(value, settings);
  }
  if (key == "moduli") {
    return readModuli(value, settings);
  }
  const auto known = std::find_if(weightSettings().begin(), weightSettings().end(),
                                  [&](const WeightSetting& setting) { return setting.name == key; });
  return known != weightSettings().end()
             ? setWeightSetting(*known, value, settings)
             : Status(Error{"is no setting of a limb's weight", key, "remove it, or correct its name"});
}

} // namespace

const std::vector<WeightSetting>& weightSettings() {
  static const std::vector<WeightSetting> table = weightTable();
  return table;
}

Status setWeightSetting(const WeightSetting& setting, const Json& value, S& settings) {
  if (!isValid(setting, value)) {
    const std::string what = setting.kind == WeightSettingKind::vector ? "three numbers" : "a number";
    return Error{fmt::format("{} is not a value of it", value.dump()), setting.name,
                 fmt::format("give {} from {:g} to {:g}", what, setting.minimum, setting.maximum)};
  }
  setting.write(value, settings);
  return Success{};
}

Result<Json> parseWeightText(const WeightSetting& setting, const std::string& text) {
  if (setting.kind == WeightSettingKind::vector) {
    const Result<Vec3> vector = parseVector(text, setting.option);
    return vector ? Result<Json>(vectorToJson(*vector)) : Result<Json>(vector.error());
  }
  const Result<double> value = parseNumber(text, setting.option);
  return value ? Result<Json>(Json(*value)) : Result<Json>(value.error());
}

Json weightToJson(const S& settings) {
  Json json;
  for (const WeightSetting& setting : weightSettings()) {
    json[setting.name] = setting.read(settings);
  }
  if (settings.rangeFrames) {
    json["range"] = Json::array({settings.rangeFrames->x, settings.rangeFrames->y});
  }
  for (const skinning::SegmentModuli::Range& range : settings.moduli) {
    json["moduli"].push_back({{"from", range.first}, {"to", range.last}, {"young", range.youngModulus}});
  }
  return json;
}

Status weightFromJson(const Json& json, const std::vector<std::string>& allowed, S& settings) {
  if (!json.is_object()) {
    return Error{json.dump() + " is no set of settings", "elastic", "give an object"};
  }
  for (const auto& [key, value] : json.items()) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) {
      continue;
    }
    if (const Status read = readEntry(key, value, settings); !read) {
      return read;
    }
  }
  return Success{};
}

} // namespace stretch::app
