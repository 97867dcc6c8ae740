#pragma once

#include <memory>
#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/controllers/adjustment.h"
#include "rig/hold/hold.h"
#include "rig/limb.h"
#include "rig/motion/motion.h"
#include "rig/reach/bind_places.h"

namespace stretch::rig {

/// Input from which the motion of one clip is solved. `scene` and `clip` must be there and outlive the call.
struct MotionInput {
  const Scene* scene = nullptr;
  const Clip* clip = nullptr;
  int clipIndex = -1;
  NodeIndex hips;            ///< Node from which the space "root" is measured; none: the world's origin.
  std::vector<Limb> limbs;   ///< All limbs that trails and weight may name, the user's chains included.
  std::vector<Trail> trails; ///< Trails of this clip. Those whose limb is missing are left out.
  bool loops = false;
  std::vector<Adjustment> adjustments = {}; ///< Adjustments of this clip. Those of missing controllers are
                                            ///< left out.
  Holds holds = {};                         ///< Holds of this clip. Those of missing limbs are left out.
  std::shared_ptr<const AdjustedBody> body = {}; ///< Body that adjustments are solved on, made for the same
                                                 ///< scene, clip, hips and limbs; null: it is made where it
                                                 ///< is needed.
  std::shared_ptr<const BindPlaces> places = {}; ///< bindPlaces of the scene; null: found where they are
                                                 ///< needed.
  /// Solved before for the same scene and clip, whatever moved it then: what the clip says as it is, its
  /// frames and its paths' times, is taken over; null: none.
  const MotionState* sameClip = nullptr;
  /// Solved before for the same scene, clip, hips, limbs, adjustments and loop: what did not change since is
  /// taken over.
  const MotionState* previous = nullptr;
};

[[nodiscard]] MotionState solveMotion(const MotionInput& input);

/// Lets limbs give way on top of trails and holds. A leg that is not among them keeps its foot where it is
/// when the other one moves the hips. Weight of limbs that are missing, or that has not one strain for each
/// bone, is left out.
void setWeight(const MotionInput& input, std::vector<LimbWeight> weights, MotionState& motion);

/// The default range of a limb in a clip (docs/exaggeration.md, Words): first frame .. frame at which the
/// end, seen from the base, is farthest from where it began. Frames.
[[nodiscard]] Vec2 defaultRange(const Scene& scene, const Clip& clip, const Limb& limb);

/// The space that a new trail over these frames starts in (docs/exaggeration.md, Spaces): root where the hips
/// move by more than half of what the limb's end moves seen from its base, else world. What is led by its
/// first joint carries the hips itself: world.
[[nodiscard]] TrailSpace startingSpace(const Scene& scene, const Clip& clip, const Limb& limb, NodeIndex hips,
                                       const Vec2& rangeFrames);

} // namespace stretch::rig
