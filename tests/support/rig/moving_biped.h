#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/anim/clip.h"
#include "rig/body/reading/detection.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/paths.h"
#include "rig/motion/solve.h"
#include "tests/support/rig/synthetic_biped.h"

namespace stretch::test {

/// A synthetic biped with its limbs found and a clip to move it.
struct MovingBiped {
  Scene scene;
  std::map<std::string, NodeIndex> node; ///< By key, as in SyntheticBiped.
  rig::Body body;
  Clip clip;

  [[nodiscard]] const rig::Limb& limb(const std::string& id) const;
};

using RotationKeys = std::vector<std::pair<double, Quat>>; ///< Seconds, local rotation.
using VectorKeys = std::vector<std::pair<double, Vec3>>;

/// Tracks of these keys; cubic splines get three-point tangents.
[[nodiscard]] Track rotationTrack(NodeIndex node, Interpolation interpolation, const RotationKeys& keys);
[[nodiscard]] Track vectorTrack(NodeIndex node, Channel channel, Interpolation interpolation,
                                const VectorKeys& keys);

/// The body with detected limbs and an empty clip of 24 frames per second.
[[nodiscard]] MovingBiped still(const SyntheticBiped& body);

/// A body with names that detection knows.
[[nodiscard]] SyntheticBiped namedBody(const BodyOptions& options = {});

/// One second: the left arm winds up, punches forwards at frame 12 and comes back; the left leg kicks, the
/// spine leans, the hips travel. Keys at frames 0, 6, 12, 18, 24.
void addPunch(MovingBiped& moving, Interpolation interpolation);
[[nodiscard]] MovingBiped punchingBiped(Interpolation interpolation = Interpolation::linear);

/// The clip with a key of each track on every frame.
[[nodiscard]] Clip keyedOnEveryFrame(const Clip& clip);

/// A trail that the character follows.
[[nodiscard]] rig::Trail connectedTrail(const std::string& limb, double startFrame, double endFrame,
                                        double scale);

/// What solving the trails over the biped's clip starts from.
[[nodiscard]] rig::MotionInput motionInput(const MovingBiped& moving, const std::vector<rig::Trail>& trails,
                                           bool loops = false);

[[nodiscard]] rig::MotionState solved(const MovingBiped& moving, const std::vector<rig::Trail>& trails,
                                      bool loops = false);

/// The character at a frame of the clip, with the trails and without.
[[nodiscard]] FrameState atFrame(const MovingBiped& moving, const rig::MotionState& motion, double frame);
[[nodiscard]] FrameState sourceAtFrame(const MovingBiped& moving, double frame);

/// From the base of a limb to its end, straight, as the nodes stand.
[[nodiscard]] double lengthOf(const rig::Limb& limb, const FrameState& frame);

/// Largest distance between the same nodes of two frames, world units.
[[nodiscard]] double largestNodeMiss(const FrameState& a, const FrameState& b);
/// Largest difference of any number in the world matrices of two frames.
[[nodiscard]] double largestMatrixMiss(const FrameState& a, const FrameState& b);

} // namespace stretch::test
