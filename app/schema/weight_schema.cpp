#include "app/schema/weight_schema.h"

#include <fmt/core.h>

#include "app/schema/schema_json.h"
#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

using gltf::Json;

Schema<WeightSettings> responseSettings() {
  return {
      setting<WeightSettings>({.name = "amount",
                               .maximum = 1.0,
                               .help = "Share of the effect that is shown; 0 is the clip as it was.",
                               .row = {.section = "weight", .percent = true}},
                              &WeightSettings::amount),
      setting<WeightSettings>({.name = "stiffness",
                               .minimum = 0.01,
                               .maximum = 100.0,
                               .help = "Multiplies the moduli and quickens the response.",
                               .row = {.section = "weight", .minimum = 0.05, .maximum = 5.0}},
                              &WeightSettings::stiffness),
      setting<WeightSettings>({.name = "damping",
                               .maximum = 10.0,
                               .help = "1 comes to rest without swinging over, below it the limb wobbles.",
                               .row = {.section = "weight", .maximum = 2.0}},
                              &WeightSettings::damping),
      setting<WeightSettings>({.name = "inertia",
                               .maximum = 1.0,
                               .help = "How much of the limb's own acceleration counts beside gravity.",
                               .row = {.section = "weight", .percent = true}},
                              &WeightSettings::inertia),
  };
}

Schema<WeightSettings> materialSettings() {
  return {
      setting<WeightSettings>({.name = "gravity",
                               .minimum = -1000.0,
                               .maximum = 1000.0,
                               .unit = "m/s^2",
                               .help = "Gravity along x, y, z of the scene; 0,0,0 leaves inertia alone.",
                               .row = {.section = "weight", .minimum = -30.0, .maximum = 30.0}},
                              &WeightSettings::gravity),
      setting<WeightSettings>(
          {.name = "young",
           .minimum = 1.0,
           .maximum = 1e12,
           .unit = "Pa",
           .help = fmt::format(
               "Young's modulus of the flesh; default: a limb at rest gives way by {:g} % of its length.",
               100.0 * stillSag),
           .row = {.section = "weight",
                   .label = "Modulus",
                   .minimum = 1e3,
                   .maximum = 2e6,
                   .step = 1e3,
                   .shownUnit = "kPa",
                   .shownFactor = 1e-3}},
          &WeightSettings::youngModulus),
      setting<WeightSettings>({.name = "density",
                               .minimum = 1.0,
                               .maximum = 100000.0,
                               .unit = "kg/m^3",
                               .help = "Density of the limb and of the body that stands on it.",
                               .row = {.section = "weight", .maximum = 4000.0, .step = 10.0}},
                              &WeightSettings::density),
  };
}

Status readWeightRange(const Json& json, WeightSettings& settings) {
  const bool isRange = json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number() &&
                       json[0].get<double>() < json[1].get<double>();
  if (!isRange && !json.is_null()) {
    return Error{json.dump() + " is not a range", "range",
                 "give the first frame and a later last one, such as [0, 12]"};
  }
  settings.rangeFrames =
      isRange ? std::optional(Vec2(json[0].get<double>(), json[1].get<double>())) : std::nullopt;
  return Success{};
}

Status readModuli(const Json& json, WeightSettings& settings) {
  const Result<skinning::SegmentModuli> moduli = skinning::parseModuli(Json{{"segments", json}}.dump());
  if (!moduli) {
    return moduli.error();
  }
  settings.moduli = moduli->ranges;
  return Success{};
}

} // namespace

const Schema<WeightSettings>& weightSchema() {
  static const Schema<WeightSettings> schema =
      joined<WeightSettings>({responseSettings(), materialSettings()});
  return schema;
}

Json weightToJson(const WeightSettings& settings) {
  Json json;
  writeSettings(weightSchema(), settings, json);
  if (settings.rangeFrames) {
    json["range"] = Json::array({settings.rangeFrames->x, settings.rangeFrames->y});
  }
  for (const skinning::SegmentModuli::Range& range : settings.moduli) {
    json["moduli"].push_back({{"from", range.first}, {"to", range.last}, {"young", range.youngModulus}});
  }
  return json;
}

Status weightFromJson(const Json& json, const std::vector<std::string>& allowed, WeightSettings& settings) {
  if (!json.is_object()) {
    return Error{json.dump() + " is not a set of settings", "elastic", "give an object"};
  }
  return readSettings(json, weightSchema(), settings, [&](const std::string& key, const Json& value) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) {
      return Status(Success{});
    }
    if (key == "range") {
      return readWeightRange(value, settings);
    }
    return key == "moduli"
               ? readModuli(value, settings)
               : Status(Error{"is not a setting of a limb's weight", key, "remove it, or correct its name"});
  });
}

} // namespace stretch::app
