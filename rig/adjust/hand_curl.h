#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/reach/bind_places.h"

namespace stretch::rig {

/// One joint of a finger, and how it bends for a fist.
struct FingerJoint {
  NodeIndex node;
  Vec3 axis{0.0};           ///< In the joint's own space: a positive turn about it closes the hand.
  double fistRadians = 0.0; ///< For a curl of 1.
};

/// The fingers of an arm's hand: each bends in its own plane where the bind pose shows one, else towards the
/// palm; the thumb by half (docs/controllers.md, Curl and roll). Empty without fingers.
[[nodiscard]] std::vector<FingerJoint> handCurl(const Scene& scene, const Limb& arm,
                                                const BindPlaces& places);

/// Turns the fingers; 0 changes nothing.
void applyCurl(const Scene& scene, const std::vector<FingerJoint>& fingers, double curl, FrameState& frame);

} // namespace stretch::rig
