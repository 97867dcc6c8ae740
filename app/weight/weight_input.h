#pragma once

#include <memory>
#include <vector>

#include "app/weight/weight_settings.h"
#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::app {

/// What the weight of the limbs of one clip is worked out from.
struct WeightInput {
  std::shared_ptr<const Scene> scene;
  const Clip* clip = nullptr;
  std::vector<rig::Limb> limbs;      ///< All limbs that weight may name, chains included.
  double height = 1.0;               ///< Of the character, world units, > 0.
  bool loops = false;                ///< The clip goes on with its own beginning.
  std::vector<WeightedLimb> weights; ///< Of this clip; what is off or names no limb is passed over.

  [[nodiscard]] double metresPerUnit() const { return characterHeightMetres / height; }
};

/// Places in WeightInput::weights of the limbs that give way: on, and there.
[[nodiscard]] std::vector<std::size_t> activeWeights(const WeightInput& input);

} // namespace stretch::app
