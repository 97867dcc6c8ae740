#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "app/schema/schema_json.h"
#include "app/schema/trail_schema.h"

namespace stretch::app {

namespace {

using gltf::Json;
using rig::TrailSettings;

Json spheresToJson(const std::vector<rig::SphereOffset>& spheres, double lengthUnit) {
  Json list = Json::array();
  for (const rig::SphereOffset& sphere : spheres) {
    Json entry{{"frame", sphere.frame}, {"offset", vectorToJson(sphere.offset / lengthUnit)}};
    if (sphere.tangent) {
      entry["tangent"] = vectorToJson(*sphere.tangent / lengthUnit);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Status readRange(const Json& json, TrailSettings& settings) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number() ||
      json[0].get<double>() > json[1].get<double>()) {
    return Error{json.dump() + " is not a range", "range",
                 "give the first and the last frame, such as [0, 12]"};
  }
  settings.startFrame = json[0].get<double>();
  settings.endFrame = json[1].get<double>();
  return Success{};
}

Result<rig::SphereOffset> readSphere(const Json& entry, double lengthUnit) {
  if (!entry.is_object() || !entry.contains("frame") || !entry["frame"].is_number() ||
      !entry.contains("offset")) {
    return Error{entry.dump() + " is not a sphere", "spheres",
                 R"(give {"frame": number, "offset": [x, y, z]})"};
  }
  const Result<Vec3> offset = vectorFromJson(entry["offset"], "spheres");
  if (!offset) {
    return offset.error();
  }
  rig::SphereOffset sphere{entry["frame"].get<double>(), *offset * lengthUnit, {}};
  if (entry.contains("tangent")) {
    const Result<Vec3> tangent = vectorFromJson(entry["tangent"], "spheres.tangent");
    if (!tangent) {
      return tangent.error();
    }
    sphere.tangent = *tangent * lengthUnit;
  }
  return sphere;
}

Status readSpheres(const Json& json, double lengthUnit, TrailSettings& settings) {
  if (!json.is_array()) {
    return Error{"is not a list", "spheres", R"(give a list of {"frame", "offset"})"};
  }
  std::vector<rig::SphereOffset> spheres;
  for (const Json& entry : json) {
    const Result<rig::SphereOffset> sphere = readSphere(entry, lengthUnit);
    if (!sphere) {
      return sphere.error();
    }
    spheres.push_back(*sphere);
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
    return Error{json.dump() + " is not a plane", "stop_at",
                 R"(give {"point": [x, y, z], "normal": [x, y, z]})"};
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
    return Error{json.dump() + " is not a set of axes", "view_axes", "give three vectors"};
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

constexpr std::array<const char*, 2> cameraKinds{"perspective", "orthographic"};

Json viewToJson(const CameraPlace& view, double lengthUnit) {
  return {{"kind", cameraKinds[static_cast<std::size_t>(view.kind)]},
          {"position", vectorToJson(view.position / lengthUnit)},
          {"right", vectorToJson(view.right)},
          {"up", vectorToJson(view.up)}};
}

Status readSeenView(const Json& json, double lengthUnit, TrailSettings& settings) {
  if (json.is_null()) {
    settings.sight.view.reset();
    return Success{};
  }
  const auto* const kind = std::ranges::find_if(
      cameraKinds, [&](const char* name) { return json.is_object() && json.value("kind", Json()) == name; });
  if (kind == cameraKinds.end() || !json.contains("position") || !json.contains("right") ||
      !json.contains("up")) {
    return Error{json.dump() + " is not a view", "seen_view",
                 R"(give {"kind": "perspective" or "orthographic", "position", "right", "up": [x, y, z]})"};
  }
  std::array<Vec3, 3> vectors;
  constexpr std::array<const char*, 3> keys{"right", "up", "position"};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Result<Vec3> vector = vectorFromJson(json[keys[i]], std::string("seen_view.") + keys[i]);
    if (!vector) {
      return vector.error();
    }
    vectors[i] = *vector;
  }
  const Mat4 world(Vec4(vectors[0], 0.0), Vec4(vectors[1], 0.0),
                   Vec4(glm::cross(vectors[0], vectors[1]), 0.0), Vec4(lengthUnit * vectors[2], 1.0));
  settings.sight.view = cameraPlace(static_cast<CameraKind>(kind - cameraKinds.begin()), world);
  return settings.sight.view ? Status(Success{})
                             : Status(Error{"right and up lie on one line, or have no length", "seen_view",
                                            "give two directions at right angles"});
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
  if (key == "seen_view") {
    return readSeenView(value, lengthUnit, settings);
  }
  return Error{"is not a setting of a trail", key, "remove it, or correct its name"};
}

} // namespace

void addNames(const rig::Trail& trail, Json& json) {
  if (!trail.name.empty()) {
    json["name"] = trail.name;
  }
  if (trail.group > 0) {
    json["group"] = trail.group;
  }
  if (trail.group > 0 && !trail.groupName.empty()) {
    json["group_name"] = trail.groupName;
  }
}

Json trailToJson(const TrailSettings& settings, double lengthUnit) {
  Json json;
  json["range"] = Json::array({settings.startFrame, settings.endFrame});
  writeSettings(trailSchema(), settings, json);
  json["spheres"] = spheresToJson(settings.spheres, lengthUnit);
  if (settings.stopAt) {
    json["stop_at"] = {{"point", vectorToJson(settings.stopAt->point)},
                       {"normal", vectorToJson(settings.stopAt->normal)}};
  }
  if (settings.space == rig::TrailSpace::view) {
    json["view_axes"] = Json::array({vectorToJson(settings.viewAxes[0]), vectorToJson(settings.viewAxes[1]),
                                     vectorToJson(settings.viewAxes[2])});
  }
  if (settings.sight.view) {
    json["seen_view"] = viewToJson(*settings.sight.view, lengthUnit);
  }
  return json;
}

Status trailFromJson(const Json& json, double lengthUnit, const std::vector<std::string>& allowed,
                     TrailSettings& settings) {
  if (!json.is_object()) {
    return Error{json.dump() + " is not a set of settings", "trails", "give an object"};
  }
  return readSettings(json, trailSchema(), settings, [&](const std::string& key, const Json& value) {
    const bool isCallers = std::find(allowed.begin(), allowed.end(), key) != allowed.end();
    return isCallers ? Status(Success{}) : readOther(key, value, lengthUnit, settings);
  });
}

} // namespace stretch::app
