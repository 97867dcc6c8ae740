#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "core/anim/frame_state.h"
#include "core/scene/camera.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// How a camera sees a trail at its tip.
struct Seen {
  double ratio = 1.0; ///< Length of the limb in the picture, over that of the source.
  double of = 1.0; ///< Likewise what was asked for: its own length, or the scale where that counts as seen.
  /// So much of the exaggeration is seen, 0..1: the smaller one of two shares, of the way that the tip is
  /// carried in the picture and of the lengthening. 1 where nothing is exaggerated.
  double share = 1.0;
};

/// Less than this share of an exaggeration is worth a warning.
inline constexpr double smallestSeenShare = 1.0 / 3.0;

/// Returns what is seen of an exaggerated trail of the motion through a camera; nothing where the limb is not
/// in front of it, or points straight at it.
[[nodiscard]] std::optional<Seen> seenBy(const Document& document, const rig::MotionState& motion,
                                         const rig::SolvedTrail& trail, const CameraPlace& camera);

/// Length of the exaggerated path in the picture, over that of the original; 1 where that is not seen.
[[nodiscard]] double seenPath(const Document& document, const rig::MotionState& motion,
                              const rig::SolvedTrail& trail, const CameraPlace& camera);

/// The direction towards the eye from which the action of a trail is seen best (rig/motion/best_view.h).
[[nodiscard]] Vec3 bestViewOf(const Document& document, const rig::MotionState& motion,
                              const rig::SolvedTrail& trail);

/// "from 70 degrees to its left, 5 degrees above": the direction as seen from where the character faces.
[[nodiscard]] std::string viewInWords(const Document& document, int clip, const Vec3& towardsEye);

/// A camera of the file in a frame of it; nothing where its node is squashed flat.
[[nodiscard]] std::optional<CameraPlace> cameraIn(const SceneCamera& camera, const FrameState& frame);

/// Tells what is wrong with how the trail's own camera sees it, with the remedy; empty where all is well, or
/// no camera judges it.
[[nodiscard]] std::vector<std::string> seenWarnings(const Document& document, const rig::MotionState& motion,
                                                    const rig::SolvedTrail& trail);

/// Returns the way from the end of a limb that stays to the one that leads, world space.
[[nodiscard]] Vec3 reachOf(const rig::Limb& limb, const FrameState& frame);

} // namespace stretch::app
