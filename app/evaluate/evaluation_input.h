#pragma once

#include <memory>
#include <vector>

#include "app/document.h"
#include "app/weight/weight_motion.h"
#include "rig/motion/motion.h"
#include "rig/motion/paths.h"
#include "rig/motion/solve.h"

namespace stretch::app {

/// Ground that every trail and the weight of one clip stand on: the clip and its adjustments.
struct EvaluationGround {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const std::vector<Clip>> clips;
  int clip = -1; ///< None, or one that is not there: the character at rest.
  NodeIndex hips;
  double height = 1.0;
  double size = 1.0;            ///< Body::size.
  std::vector<rig::Limb> limbs; ///< allLimbs.
  bool loops = false;
  std::vector<rig::Adjustment> adjustments = {}; ///< Adjustments of the clip.

  friend bool operator==(const EvaluationGround&, const EvaluationGround&) = default;
};

/// All that the motion of one clip is made from: its stages see nothing else of the document. So two equal
/// ones (scene and clips by identity: they never change) have the same motion, and no cache can miss a
/// setting.
struct EvaluationInput {
  EvaluationGround ground;
  std::vector<rig::Trail> trails;    ///< Trails of the clip.
  rig::Holds holds;                  ///< Holds of the clip.
  std::vector<WeightedLimb> weights; ///< Weights of the clip.

  friend bool operator==(const EvaluationInput&, const EvaluationInput&) = default;
};

[[nodiscard]] EvaluationInput evaluationInput(const Document& document, int clip);

/// The clip; one without tracks where there is none.
[[nodiscard]] const Clip& clipOrStill(const std::vector<Clip>& clips, int clip);
[[nodiscard]] const Clip& clipOf(const EvaluationGround& ground);

/// Input of the stages of rig before a time is known: EvaluationCache alone says in which order. It points
/// into `input`, which outlives it. At a time the stages are those of rig/motion/evaluate.h.
[[nodiscard]] rig::MotionInput motionInput(const EvaluationInput& input);

/// Input from which the weight of the clip's limbs is worked out.
[[nodiscard]] WeightInput weightInput(const EvaluationInput& input);

/// The paths of one trail, as they are drawn.
struct TrailPaths {
  rig::DrawnTrail drawn;   ///< Evenly over range and release.
  rig::DrawnTrail spheres; ///< At SolvedTrail::controlFrames.
};

/// Paths made before of a motion on the same ground, with as many samples for each frame.
struct EarlierPaths {
  const rig::MotionState* motion = nullptr; ///< Null: none.
  const std::vector<TrailPaths>* paths = nullptr;
};

/// One for each trail of `motion`. Of trails that are the same as before, and that no changed one moves, the
/// earlier paths are taken over.
[[nodiscard]] std::vector<TrailPaths> drawPaths(const EvaluationGround& ground,
                                                const rig::MotionState& motion, std::size_t samplesPerFrame,
                                                const EarlierPaths& earlier);

} // namespace stretch::app
