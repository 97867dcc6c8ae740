#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/edits/pose/offset_edits.h"
#include "core/anim/frame_state.h"
#include "rig/motion/controller_places.h"

namespace stretch::app {

// Poses as they are seen, by whatever moves the character: the clip, offsets, trails, holds, weight
// (docs/controllers.md, Poses).

/// One moment of a character: the frame as it is shown, and its controllers there.
struct SeenMoment {
  const Document& document;
  int clip = 0;
  double frame = 0.0;
  const std::vector<rig::PlacedController>& placed;
  const FrameState& shown;
};

struct SeenController {
  std::string id;
  Vec3 placeWorld{0.0};
  Quat turnWorld{1.0, 0.0, 0.0, 0.0}; ///< From the bind pose.
  /// From the base of its limb, in lengths of the controller, along the world's axes: what another character
  /// is given of hands, heads, tips and poles. Nothing for all others.
  std::optional<Vec3> fromBase;
  /// Height above the soles in the bind pose, world units: what its height is counted from on another
  /// character. Nothing for what is placed from a base, and without legs.
  std::optional<double> restHeight = {};
};

/// Places and turns of some controllers at one time, with what they are measured by on another character.
struct SeenPose {
  std::vector<SeenController> controllers;
  std::vector<AttributeValue> values; ///< What places do not tell: a fist, how a limb gives way.
  std::shared_ptr<const Scene> of;    ///< Character that it was seen on.
  Vec3 standingWorld{0.0};            ///< Point of the ground (y = 0) below the hips.
  Vec3 leftWorld{1.0, 0.0, 0.0};      ///< To the character's left in the bind pose; unit length, level.
  Vec3 leftOnItsWay{1.0, 0.0, 0.0};   ///< To its left on its way through the clip: headingNormal.
  double legLength = 1.0;             ///< Length that moves of the hips count in, world units.
};

/// Returns what is seen of these controllers; of all but the body's where none is named.
[[nodiscard]] SeenPose seenPose(const SeenMoment& moment, std::span<const std::string> ids);

/// The pose as the other side of the body has it, reflected at the plane through the hips that the character
/// is symmetric by. What has no other side is left out.
[[nodiscard]] SeenPose mirroredPose(const Document& document, const SeenPose& pose);

/// The pose as a library keeps it: of no character, standing at the origin with its left along +X, in lengths
/// of the leg.
[[nodiscard]] SeenPose standardised(const SeenPose& pose);

/// Returns where the pose wants each controller of the moment's character: where it was seen, on the
/// character that it was seen on; on another one in proportion to its limbs, standing on `standingWorld` and
/// facing its own way. What that character lacks is left out.
[[nodiscard]] std::vector<SeenController> goalsOn(const SeenMoment& moment, const SeenPose& pose,
                                                  const Vec3& standingWorld);

} // namespace stretch::app
