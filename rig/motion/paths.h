#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

/// Points of a trail's paths, world space, one for each frame asked for. Inner trails carry both paths.
struct DrawnTrail {
  std::vector<double> frames;
  std::vector<Vec3> original;
  std::vector<Vec3> exaggerated;

  friend bool operator==(const DrawnTrail&, const DrawnTrail&) = default;
};

/// A path at frames of its own.
struct PathRequest {
  std::size_t trail = 0;      ///< Place in MotionState::trails.
  std::vector<double> frames; ///< Ascending.
};

/// One answer for each request: what they share is computed once. The exaggerated path of a limb that the
/// motion's holds keep somewhere is there, where the character follows the trail.
[[nodiscard]] std::vector<DrawnTrail> pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion,
                                              const std::vector<PathRequest>& requests);

/// The paths of one trail at given frames, ascending, as at the control spheres (SolvedTrail::controlFrames).
[[nodiscard]] DrawnTrail pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion,
                                 std::size_t trail, const std::vector<double>& frames);

/// Whether the paths of the trail `outer` depend on the trail `inner`: it is active, acts earlier, and is on
/// the same base or on a limb that carries it.
[[nodiscard]] bool shapesPath(const Scene& scene, const MotionState& motion, std::size_t inner,
                              std::size_t outer);

/// Whether a hold of the clip keeps the limb's end somewhere, at some time.
[[nodiscard]] bool isHeldLimb(const MotionState& motion, const std::string& limb);

/// The frames at which a path is drawn: evenly `samplesPerFrame` per frame over range and release. At least
/// one. `acrossSeam`: those of the release that a loop's next or last turn has, too, counted on past the
/// clip's end or before its start.
[[nodiscard]] std::vector<double> drawnFrames(const Clip& clip, const SolvedTrail& solved,
                                              std::size_t samplesPerFrame, bool acrossSeam = false);

} // namespace stretch::rig
