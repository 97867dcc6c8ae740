#pragma once

#include <memory>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// What every trail and the weight of one clip stand on.
struct EvaluationGround {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const std::vector<Clip>> clips;
  int clip = -1; ///< None, or one that is not there: the character at rest.
  NodeIndex hips;
  double height = 1.0;
  std::vector<rig::Limb> limbs; ///< allLimbs.
  bool loops = false;

  friend bool operator==(const EvaluationGround&, const EvaluationGround&) = default;
};

/// All that the motion of one clip is made from: its stages see nothing else of the document. So two equal
/// ones (scene and clips by identity: they never change) have the same motion, and no cache can miss a
/// setting.
struct EvaluationInput {
  EvaluationGround ground;
  std::vector<rig::Trail> trails;    ///< Of the clip.
  std::vector<WeightedLimb> weights; ///< Of the clip.

  friend bool operator==(const EvaluationInput&, const EvaluationInput&) = default;
};

[[nodiscard]] EvaluationInput evaluationInput(const Document& document, int clip);

/// The clip; one without tracks where there is none.
[[nodiscard]] const Clip& clipOrStill(const std::vector<Clip>& clips, int clip);
[[nodiscard]] const Clip& clipOf(const EvaluationGround& ground);

} // namespace stretch::app
