#include "app/schema/trail_json.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/gltf/json.h"

namespace stretch::app {

namespace {

using gltf::Json;
using rig::TrailSettings;

Json spheresToJson(const std::vector<rig::SphereOffset>& spheres, double lengthUnit) {
  Json list = Json::array();
  for (const rig::SphereOffset& sphere : spheres) {
    list.push_back({{"frame", sphere.frame}, {"offset", vectorToJson(sphere.offset / lengthUnit)}});
  }
  return list;
}

Status readRange(const Json& json, TrailSettings& settings) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number() ||
      json[0].get<double>() > json[1].get<double>()) {
    return Error{json.dump() + " is no range", "range", "give the first and the last frame, such as [0, 12]"};
  }
  settings.startFrame = json[0].get<double>();
  settings.endFrame = json[1].get<double>();
  return Success{};
}

Status readSpheres(const Json& json, double lengthUnit, TrailSettings& settings) {
  if (!json.is_array()) {
    return Error{"is no list", "spheres", "give a list of {\"frame\", \"offset\"}"};
  }
  std::vector<rig::SphereOffset> spheres;
  for (const Json& entry : json) {
    if (!entry.is_object() || !entry.contains("frame") || !entry["frame"].is_number() ||
        !entry.contains("offset")) {
      return Error{entry.dump() + " is no sphere", "spheres",
                   "give {\"frame\": number, \"offset\": [x, y, z]}"};
    }
    const Result<Vec3> offset = vectorFromJson(entry["offset"], "spheres");
    if (!offset) {
      return offset.error();
    }
    spheres.push_back({entry["frame"].get<double>(), *offset * lengthUnit});
  }
  std::sort(spheres.begin(), spheres.end(), [](const auto& a, const auto& b) { return a.frame < b.frame; });
  settings.spheres = std::move(spheres);
  return Success{};
}

Status readStopPlane(const Json& json, TrailSettings& settings) {
  if (json.is_null()) {
    settings.stopAt.reset();
    return Success{};
  }
  if (!json.is_object() || !json.contains("point") || !json.contains("normal")) {
    return Error{json.dump() + " is no plane", "stop_at",
                 "give {\"point\": [x, y, z], \"normal\": [x, y, z]}"};
  }
  const Result<Vec3> point = vectorFromJson(json["point"], "stop_at.point");
  const Result<Vec3> normal = vectorFromJson(json["normal"], "stop_at.normal");
  if (!point || !normal) {
    return point ? normal.error() : point.error();
  }
  settings.stopAt = rig::StopPlane{*point, *normal};
  return Success{};
}

Status readViewAxes(const Json& json, TrailSettings& settings) {
  if (!json.is_array() || json.size() != 3) {
    return Error{json.dump() + " is no set of axes", "view_axes", "give three vectors"};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Result<Vec3> axis = vectorFromJson(json[i], "view_axes");
    if (!axis) {
      return axis.error();
    }
    settings.viewAxes[i] = *axis;
  }
  return Success{};
}

Status readOther(const std::string& key, const Json& value, double lengthUnit, TrailSettings& settings) {
  if (key == "range") {
    return readRange(value, settings);
  }
  if (key == "spheres") {
    return readSpheres(value, lengthUnit, settings);
  }
  if (key == "stop_at") {
    return readStopPlane(value, settings);
  }
  if (key == "view_axes") {
    return readViewAxes(value, settings);
  }
  return Error{"is no setting of a trail", key, "remove it, or correct its name"};
}

} // namespace

Json vectorToJson(const Vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Result<Vec3> vectorFromJson(const Json& json, const std::string& where) {
  const bool isVector =
      json.is_array() && json.size() == 3 &&
      std::all_of(json.begin(), json.end(), [](const Json& number) { return number.is_number(); });
  if (!isVector) {
    return Error{json.dump() + " is no vector", where, "give three numbers"};
  }
  return Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

Json settingsToJson(const TrailSettings& settings, double lengthUnit) {
  Json json;
  json["range"] = Json::array({settings.startFrame, settings.endFrame});
  for (const TrailSetting& setting : trailSettings()) {
    json[setting.name] = setting.read(settings);
  }
  json["spheres"] = spheresToJson(settings.spheres, lengthUnit);
  if (settings.stopAt) {
    json["stop_at"] = {{"point", vectorToJson(settings.stopAt->point)},
                       {"normal", vectorToJson(settings.stopAt->normal)}};
  }
  if (settings.space == rig::TrailSpace::view) {
    json["view_axes"] = Json::array({vectorToJson(settings.viewAxes[0]), vectorToJson(settings.viewAxes[1]),
                                     vectorToJson(settings.viewAxes[2])});
  }
  return json;
}

Status settingsFromJson(const Json& json, double lengthUnit, const std::vector<std::string>& allowed,
                        TrailSettings& settings) {
  if (!json.is_object()) {
    return Error{json.dump() + " is no set of settings", "trails", "give an object"};
  }
  for (const auto& [key, value] : json.items()) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) {
      continue;
    }
    const std::string& name = key;
    const auto known = std::find_if(trailSettings().begin(), trailSettings().end(),
                                    [&](const TrailSetting& setting) { return setting.name == name; });
    const Status read = known != trailSettings().end() ? setTrailSetting(*known, value, settings)
                                                       : readOther(key, value, lengthUnit, settings);
    if (!read) {
      return read;
    }
  }
  return Success{};
}

} // namespace stretch::app
