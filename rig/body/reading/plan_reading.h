#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig/body/evidence/bind_pose.h"
#include "rig/body/evidence/body_view.h"
#include "rig/limb.h"
#include "rig/plan/body_plan.h"

namespace stretch::rig::body {

/// A body read as one of a plan.
struct PlanReading {
  const BodyPlan* plan = nullptr;
  std::vector<Limb> limbs; ///< In the order of LimbPlace.
  NodeIndex hips;          ///< Joint that carries the body; -1: none.
  NodeIndex head;
  double confidence = 0.0;
  Vec3 up{0.0, 1.0, 0.0}; ///< Unit: along which it stands in its bind pose.
  std::vector<std::string> reasons;
  std::vector<std::string> warnings;
};

/// Reads what body this is, from which ends touch the ground, symmetry, the order along the body, and names;
/// any plan but the biped's, whose limbs are read by more evidence. Nothing where no plan fits, `other` never
/// does. A body that stands on nothing is tried upside down and lying as well, with a warning.
[[nodiscard]] std::optional<PlanReading> readPlan(const Scene& scene, const BindPose& bindPose,
                                                  const BodyView& view);

/// Reads the body as a plan that the user chose: what of it the body has, however well it fits.
[[nodiscard]] PlanReading readAsPlan(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                                     const BodyPlan& plan);

/// Every chain between branchings, named by its ends as chains chosen by hand are; the longest ones first.
[[nodiscard]] std::vector<Limb> chainsOfTree(const Scene& scene, const BindPose& bindPose,
                                             const BodyView& view);

} // namespace stretch::rig::body
