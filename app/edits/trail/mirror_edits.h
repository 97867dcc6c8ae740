#pragma once

#include <optional>
#include <vector>

#include "app/document.h"
#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

/// The limb on the other side of the body; an error for spine, neck and chains of the user's.
[[nodiscard]] Result<std::string> otherSide(const Document& document, const std::string& limbId);

/// Unit normal of the character's sagittal plane (to its left) at a frame of a clip as the source has it:
/// between the bases of the first pair of limbs at rest, turned along with the hips, level with the ground
/// (+Y is up). (1, 0, 0) when the character has no pair.
[[nodiscard]] Vec3 sagittalNormal(const Document& document, int clip, double frame);

/// Unit normal of the plane that a whole pose is mirrored by: the mean of sagittalNormal over the clip, so
/// that hips that turn to and fro in a walk or a punch swap sides with the rest; that of the frame where the
/// character turns on the way.
[[nodiscard]] Vec3 headingNormal(const Document& document, int clip, double frame);

/// A vector in a mirror at right angles to this unit normal.
[[nodiscard]] Vec3 reflected(const Vec3& vector, const Vec3& unitNormal);

struct SagittalPlane {
  Vec3 point{0.0};
  Vec3 normal{1.0, 0.0, 0.0}; ///< Unit length, level with the ground, to the character's left.
};

/// The plane between the bases of the first pair of limbs where nodes stand so; nothing without a pair.
[[nodiscard]] std::optional<SagittalPlane> sagittalPlaneOf(const Document& document,
                                                           const std::vector<Mat4>& worlds);

/// Settings as they act on the other side of a plane with this unit normal: sphere offsets, view axes and the
/// stop plane (about `planePoint`) are reflected; everything else is the same on both sides.
[[nodiscard]] rig::TrailSettings mirroredSettings(const rig::TrailSettings& settings, const Vec3& normal,
                                                  const Vec3& planePoint);

/// Makes (or replaces) the trail of the other side's limb with the same range, mirrored.
[[nodiscard]] Result<CreatedTrail> mirrorTrail(const Document& document, const rig::Trail& trail);

} // namespace stretch::app
