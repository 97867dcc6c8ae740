#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/scene/camera.h"
#include "rig/adjust/frame_table.h"
#include "rig/motion/motion.h"
#include "rig/motion/solve.h"

namespace stretch::rig {

/// Standard views, which every character has as orthographic cameras.
inline constexpr std::array<std::string_view, 4> standardViews{"front", "side", "top", "three-quarter"};

[[nodiscard]] bool isStandardView(const std::string& name);

/// The camera of a standard view of a character that faces this way: a level direction, not zero. `side` is
/// the character's left.
[[nodiscard]] CameraPlace standardView(const std::string& name, const Vec3& facing);

/// Direction along which the character is looked at from the front in a clip: the axis of the scene nearest
/// to where it faces as the clip begins. Unit, level.
[[nodiscard]] Vec3 facingInClip(const Scene& scene, const Clip& clip, NodeIndex hips,
                                const std::vector<Limb>& limbs, const BindPlaces& places);

/// A camera of the file at a time of the adjusted clip; nothing where its node is squashed flat.
[[nodiscard]] std::optional<CameraPlace> placeOfCamera(const SceneCamera& camera, FrameSource& frames,
                                                       double timeSeconds);

} // namespace stretch::rig
