#pragma once

#include "app/schema/trail_description.h"
#include "core/base/result.h"
#include "core/gltf/source.h"
#include "rig/trail/trail.h"

namespace stretch::app {

/// A trail's settings as recipes and saved files hold them: "range", every entry of trailSettings(),
/// "spheres", "stop_at", "view_axes" for the space `view`. `lengthUnit` is what one unit of a sphere's offset
/// is in world units: 1 for metres, the limb's rest length for offsets in lengths of the limb.
[[nodiscard]] gltf::Json settingsToJson(const rig::TrailSettings& settings, double lengthUnit);

/// Reads what settingsToJson writes; what is missing keeps its value in `settings`. `allowed` names further
/// keys that the caller reads itself. An unknown key or a wrong value is an error that names it.
[[nodiscard]] Status settingsFromJson(const gltf::Json& json, double lengthUnit,
                                      const std::vector<std::string>& allowed, rig::TrailSettings& settings);

[[nodiscard]] gltf::Json vectorToJson(const Vec3& v);
[[nodiscard]] Result<Vec3> vectorFromJson(const gltf::Json& json, const std::string& where);

} // namespace stretch::app
