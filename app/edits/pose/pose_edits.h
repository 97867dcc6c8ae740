#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/edits/pose/offset_edits.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

// Poses made from poses: what is set by setOffsets() afterwards.

/// The attributes that go with a controller: those of the limb that it is the end of.
[[nodiscard]] std::vector<rig::Attribute> attributesHeldBy(const rig::ControllerList& list,
                                                           const rig::Controller& controller);

/// The controller or attribute on the other side of the body: "right-hand" of "left-hand", of a joint the one
/// that stands there in the bind pose. One in the middle is its own; empty where there is none.
[[nodiscard]] std::string otherSideOf(const Document& document, const std::string& id);

/// The pose as the other side has it: reflected at the character's own plane, which the body and the hips
/// take from where the clip has turned them at this frame. What has no other side is an error that names it.
[[nodiscard]] Result<OffsetPose> mirroredPose(const Document& document, int clip, double frame,
                                              const OffsetPose& pose);

/// The pose with moves in lengths of its controllers, so that it fits another character; and back, in world
/// units. What the character lacks, and what its controller cannot do, is left out.
[[nodiscard]] OffsetPose inLengths(const Document& document, const OffsetPose& pose);
[[nodiscard]] OffsetPose inWorldUnits(const Document& document, const OffsetPose& pose);

/// Between the key before the frame (0) and the key after it (1), or past them; the ends of a range are keys.
/// What does not have both is left out.
[[nodiscard]] OffsetPose tweenedPose(const Document& document, int clip, double frame,
                                     std::span<const std::string> ids, double between);

} // namespace stretch::app
