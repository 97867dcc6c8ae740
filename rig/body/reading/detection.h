#pragma once

#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// Body that was recognised in a character.
struct Body {
  std::vector<Limb> limbs;     ///< In the order of LimbPlace; a limb that was not found is missing.
  std::string plan = "biped";  ///< Id of the body plan that the limbs are of (rig/plan/body_plan.h).
  double planConfidence = 1.0; ///< 0..1.
  std::vector<std::string> planReasons;
  NodeIndex hips; ///< Node that carries the body: space "root" is measured from it. -1: none found.
  NodeIndex head;
  bool isBiped = false; ///< Both legs, and arms or a spine, found with enough confidence.
  double height = 1.0;  ///< Extent along +Y of the shown body at the first frame of the first clip, world
                        ///< units, > 0: every tolerance is relative to it.
  double size = 1.0; ///< Extent in the bind pose: the height of a biped, else the largest extent, since the
                     ///< height of a creature says little of how large it is. World units, > 0.
  std::vector<std::string> warnings;

  friend bool operator==(const Body&, const Body&) = default;
};

/// Finds the limbs from the VRM humanoid table, joint names, topology and proportions (docs/rig.md,
/// Finding limbs). Names are evidence, not truth: position in the chain and geometry decide. What is no
/// upright body on two legs is read by the other body plans (docs/body_plans.md); where none fits, a biped
/// that is not complete has limbs of confidence 0.3 at most, with a warning, and another body the rows of
/// joints between branchings. Never fails: a file without joints gives an empty list with a warning. Sides:
/// names that agree with each other win over a single hint of geometry; what contradicts is told as a
/// question. A VRM humanoid table is taken as it is. A spine of one joint ends at the neck or head; one
/// without a joint above the hips starts at the hips. The height is measured at the start of `clip`, without
/// one at rest; nothing else depends on it.
[[nodiscard]] Body detectBody(const Scene& scene, const Clip* clip = nullptr);

/// A joint by its name or as "#index"; among several nodes of one name the one that a skin uses. An error
/// says what is missing or ambiguous.
[[nodiscard]] Result<NodeIndex> jointByName(const Scene& scene, const std::string& joint);

/// Any chain from joint A down to joint B, both by name or as "#index". An error names what is missing,
/// ambiguous or not above the other.
[[nodiscard]] Result<Limb> chainLimb(const Scene& scene, const std::string& jointA,
                                     const std::string& jointB);

} // namespace stretch::rig
