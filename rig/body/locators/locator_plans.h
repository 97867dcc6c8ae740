#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rig/limb.h"

namespace stretch::rig {

/// One joint of a plan's locators.
struct LocatorJoint {
  std::string name;
  std::string parent;   ///< Empty for the first one.
  bool isNeeded = true; ///< A body may lack the others: its bones go on to the next joint.
  LimbPlace limb = {};  ///< Limb that it is fitted to, and its row.
  double along = 0.0;   ///< 0..1: where on that limb it stands if no bend shows.
  bool facesUp = false; ///< +Z of its locator points to the body's back or up; else to where the body faces.
};

/// The locators of a body plan: data. What fits them, moves them and makes joints at them asks this table.
struct LocatorPlan {
  std::string id;                   ///< Of the body plan (rig/plan/body_plan.h).
  std::vector<LocatorJoint> joints; ///< Parents before their children, a limb's joints one after the other.
  std::vector<std::string> across;  ///< Joints of a pair, without their sides: from one to the other is
                                    ///< across.
  bool stands = false;              ///< The way from the first joint to the head goes up, not forward.
};

/// The plans that have locators, the biped first: a new one is added there, and nowhere else.
[[nodiscard]] const std::vector<LocatorPlan>& locatorPlans();

/// Null when the plan has no locators.
[[nodiscard]] const LocatorPlan* locatorPlan(std::string_view id);

/// "biped", "quadruped", ...
[[nodiscard]] std::vector<std::string> locatorPlanIds();

/// Null when the name is no joint of the plan.
[[nodiscard]] const LocatorJoint* findJoint(const LocatorPlan& plan, std::string_view name);

} // namespace stretch::rig
