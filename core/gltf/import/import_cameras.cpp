#include <cmath>
#include <set>

#include <fmt/core.h>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

bool isLength(double value) {
  return value > 0.0 && std::isfinite(value);
}

// Nothing where the camera says too little to look through it.
std::optional<SceneCamera> lensOf(const Json& json) {
  SceneCamera camera;
  const std::string kind = textOr(json, "type");
  const Json* const lens = kind.empty() ? nullptr : find(json, kind);
  if (lens == nullptr) {
    return std::nullopt;
  }
  if (kind == "perspective") {
    camera.fieldOfViewRadians = numberOr(*lens, "yfov", 0.0);
    const double aspect = numberOr(*lens, "aspectRatio", 0.0);
    camera.aspect = isLength(aspect) ? std::optional(aspect) : std::nullopt;
    const bool isUsable = camera.fieldOfViewRadians > 0.0 && camera.fieldOfViewRadians < pi;
    return isUsable ? std::optional(camera) : std::nullopt;
  }
  camera.kind = CameraKind::orthographic;
  camera.halfHeight = std::abs(numberOr(*lens, "ymag", 0.0));
  const double aspect = std::abs(numberOr(*lens, "xmag", 0.0)) / camera.halfHeight;
  camera.aspect = isLength(aspect) ? std::optional(aspect) : std::nullopt;
  return kind == "orthographic" && isLength(camera.halfHeight) ? std::optional(camera) : std::nullopt;
}

std::string nameOf(const Json& node, const Json& camera, std::size_t index, std::set<std::string>& taken) {
  std::string name = shownName(node);
  name = name.empty() ? shownName(camera) : name;
  if (name.empty() || taken.contains(name)) {
    name = fmt::format("{} #{}", name.empty() ? "camera" : name, index);
  }
  taken.insert(name);
  return name;
}

} // namespace

std::vector<SceneCamera> importCameras(const Source& source, Problems& problems) {
  std::vector<SceneCamera> cameras;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < sizeOf(source.json, "nodes"); ++i) {
    const Json& node = element(source.json, "nodes", i);
    const int index = indexOr(node, "camera");
    if (index < 0 || static_cast<std::size_t>(index) >= sizeOf(source.json, "cameras")) {
      continue;
    }
    const Json& json = element(source.json, "cameras", static_cast<std::size_t>(index));
    std::optional<SceneCamera> camera = lensOf(json);
    if (!camera) {
      problems.warning(at("cameras", static_cast<std::size_t>(index)),
                       "has neither a usable angle nor a usable height: nobody can look through it");
      continue;
    }
    camera->name = nameOf(node, json, i, taken);
    camera->node = NodeIndex(i);
    cameras.push_back(std::move(*camera));
  }
  return cameras;
}

} // namespace stretch::gltf
