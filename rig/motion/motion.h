#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "rig/body/detection.h"
#include "rig/limb.h"
#include "rig/motion/bend_normal.h"
#include "rig/motion/limb_topology.h"
#include "rig/motion/limb_weight.h"
#include "rig/trail/exaggeration.h"
#include "rig/trail/limb_path.h"
#include "rig/trail/release.h"
#include "rig/trail/sphere_offsets.h"
#include "rig/trail/trail.h"

namespace stretch::rig {

/// One trail of a clip, solved: everything that drawing and evaluating it at any time needs.
struct SolvedTrail {
  Trail trail;
  TrailSettings settings; ///< As used: range clamped to the clip, scale to its limits.
  Limb limb;
  LimbTopology topology;
  LimbPath path;   ///< The original path over the range, in world space and in the trail's space.
  TipSolution tip; ///< In the trail's space.
  Remap remap{RemapKind::spline, {}, {}};
  SphereOffsets offsets;
  Release release;
  BendNormal bend;
  double startSeconds = 0.0; ///< The range.
  double endSeconds = 0.0;
  double tipSeconds = 0.0;
  double windowStartSeconds = 0.0; ///< Range, release and fade: outside nothing moves.
  double windowEndSeconds = 0.0;
  std::vector<double> controlFrames; ///< Where the control spheres are.
  bool active = false;               ///< The character follows it.
  std::vector<std::string> warnings; ///< "not reachable: the limb gets to x of y", ...
};

/// All trails of a clip, in the order in which they act: from the root outwards (order.h).
struct MotionState {
  int clip = -1;
  double framesPerSecond = 30.0;
  double startSeconds = 0.0; ///< Of the clip: where a release wraps from and to when it loops.
  double endSeconds = 0.0;
  bool loops = false;
  int hips = -1; ///< What the space "root" is measured from.
  std::vector<SolvedTrail> trails;
  std::vector<SolvedWeight> weights; ///< From the root outwards, on top of the trails (setWeight).
};

struct MotionInput {
  const Scene* scene = nullptr;
  const Clip* clip = nullptr;
  int clipIndex = -1;
  const Biped* biped = nullptr;
  std::vector<Limb> limbs;   ///< All limbs that trails may name, the user's chains included.
  std::vector<Trail> trails; ///< Of this clip. Those whose limb is missing are left out.
  bool loops = false;
  /// Solved before for the same scene, clip, biped, limbs and loop: what did not change since is taken over.
  const MotionState* previous = nullptr;
};

[[nodiscard]] MotionState solveMotion(const MotionInput& input);

/// Lets limbs give way on top of the trails. A leg that has no weight of its own keeps its foot where it is
/// when the other one moves the hips. Weight of limbs that are missing, or without one strain for each bone,
/// is left out.
void setWeight(const MotionInput& input, std::vector<LimbWeight> weights, MotionState& motion);

/// The character at one time with every active trail and the weight of all limbs applied.
[[nodiscard]] FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                                        double timeSeconds);

/// Points of a trail's paths, world space, one for each frame asked for. Inner trails carry both paths.
struct DrawnTrail {
  std::vector<double> frames;
  std::vector<Vec3> original;
  std::vector<Vec3> exaggerated;
};

/// The paths at given frames, ascending, as at the control spheres (SolvedTrail::controlFrames).
[[nodiscard]] DrawnTrail pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion,
                                 const SolvedTrail& solved, const std::vector<double>& frames);

/// Several paths, each at frames of its own: what they share is computed once. One answer for each request.
struct PathRequest {
  const SolvedTrail* trail = nullptr; ///< One of the motion's own.
  std::vector<double> frames;         ///< Ascending.
};
[[nodiscard]] std::vector<DrawnTrail> pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion,
                                              const std::vector<PathRequest>& requests);

/// Whether the paths of `outer` depend on `inner`: an active trail of the same motion that acts earlier, on
/// the same limb or on one that carries it.
[[nodiscard]] bool shapesPath(const Scene& scene, const SolvedTrail& inner, const SolvedTrail& outer);

/// The frames at which a path is drawn: evenly `samplesPerFrame` per frame over range and release. At least
/// one.
[[nodiscard]] std::vector<double> drawnFrames(const Clip& clip, const SolvedTrail& solved,
                                              std::size_t samplesPerFrame);

/// The paths at these frames.
[[nodiscard]] DrawnTrail drawnPaths(const Scene& scene, const Clip& clip, const MotionState& motion,
                                    const SolvedTrail& solved, std::size_t samplesPerFrame);

/// The default range of a limb in a clip (docs/exaggeration.md, Words): first frame .. frame at which the
/// end, seen from the base, is farthest from where it began. Frames.
[[nodiscard]] Vec2 defaultRange(const Scene& scene, const Clip& clip, const Limb& limb);

} // namespace stretch::rig
