#pragma once

#include "app/schema/schema.h"
#include "rig/trail/trail.h"

namespace stretch::app {

/// All settings of a trail but range, spheres, stop plane and view axes, which have shapes of their own.
[[nodiscard]] const Schema<rig::TrailSettings>& trailSchema();

inline constexpr double easeHalf = 0.5; ///< An ease-in's value is at most this, an ease-out's at least.

/// Whether both eases leave a piece of the path between them, and their values lie on their sides of the
/// half: what crosses it would be a jump. An ease that is off may have any value.
[[nodiscard]] Status checkEases(const rig::Ease& easeIn, const rig::Ease& easeOut);

/// A trail's settings as recipes and saved files hold them: "range", every setting of the schema, "spheres",
/// "stop_at", "view_axes" for the space `view`, "seen_view". `lengthUnit` is what one unit of a sphere's
/// offset and of a kept view's position is in world units: 1 for metres, the limb's rest length for offsets
/// in lengths of the limb.
[[nodiscard]] gltf::Json trailToJson(const rig::TrailSettings& settings, double lengthUnit);

/// Adds what the user called a trail and its group, and which group it is; nothing where there is none.
void addNames(const rig::Trail& trail, gltf::Json& json);

/// Reads what trailToJson writes; what is missing keeps its value in `settings`. `allowed` names further keys
/// that the caller reads itself. An unknown key or a wrong value is an error that names it.
[[nodiscard]] Status trailFromJson(const gltf::Json& json, double lengthUnit,
                                   const std::vector<std::string>& allowed, rig::TrailSettings& settings);

} // namespace stretch::app
