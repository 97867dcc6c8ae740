#pragma once

#include <optional>
#include <vector>

#include "rig/body/evidence/body_view.h"
#include "rig/body/reading/detection.h"

namespace stretch::rig::body {

/// Body as one way of choosing candidates finds it.
struct Finding {
  Body result;
  std::optional<Limb> tail; ///< A biped's.
  int legs = 0;             ///< Legs that it stands on.
  Vec3 bodyUp{0.0};
  Vec3 legsReach{0.0}; ///< From the hips to the feet.
  bool limbsAreNamed = false;
  bool standsOnNamedLegs = false; ///< On the two that names call its legs, and on no others.
  bool isPerson = false; ///< Arms, legs, spine and head are sure, the limbs named, and no others called legs.
  NodeIndex skeleton;    ///< Topmost joint of the one of several that it is of.

  [[nodiscard]] double weight() const {
    double sum = 0.0;
    for (const Limb& limb : result.limbs) {
      sum += limb.confidence;
    }
    return sum;
  }
};

/// Whether a limb was found with enough confidence to count towards a biped.
[[nodiscard]] bool isSure(const std::vector<Limb>& limbs, const LimbPlace& place);

/// Whether limbs make a biped: both legs, and arms or a spine.
[[nodiscard]] bool makesBiped(const std::vector<Limb>& limbs);

/// Limbs of a biped among the candidates of one kind. `within`: the topmost joint of the one skeleton that
/// is looked at; -1: all of them.
[[nodiscard]] Finding findWith(const Scene& scene, const BindPose& bindPose, Candidates candidates,
                               NodeIndex within = NodeIndex::none);

[[nodiscard]] bool isBetter(const Finding& finding, const Finding& than);

} // namespace stretch::rig::body
