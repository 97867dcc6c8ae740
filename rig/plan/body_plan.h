#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rig/limb.h"

namespace stretch::rig {

/// A round bone of a plan's figure: two circles and what lies between them.
struct FigureBone {
  float fromX = 0.0F, fromY = 0.0F, fromRadius = 0.0F;
  float toX = 0.0F, toY = 0.0F, toRadius = 0.0F;
};

struct FigurePoint {
  float x = 0.0F;
  float y = 0.0F;
};

/// How a limb moves where nothing else is asked: what a new trail and new weight of it start from. A biped's
/// limbs keep the program's own.
struct LimbManner {
  bool stands = false;    ///< Its trails stop at the ground.
  bool turnEnd = false;   ///< Its end turns with it: a tail's does, a foot keeps to the ground.
  double overshoot = 0.0; ///< 0..1: how far its trails swing past the motion as they let go.
  double stiffness = 1.0; ///< Stiffness of its weight.
  double damping = 0.7;   ///< Damping of its weight: below 1 it swings over before it rests.

  friend bool operator==(const LimbManner&, const LimbManner&) = default;
};

/// One limb of a plan, and how the plan's figure shows it. The figure stands in a box 180 wide and 232 high:
/// x = 0 is its middle, y grows downwards.
struct PlannedLimb {
  std::string id;
  LimbPlace place;
  bool usual = true; ///< Has a key, and is drawn, where it is missing as well.
  std::vector<FigureBone> bones;
  FigurePoint end; ///< End of the limb: what a trail is drawn for.
  FigurePoint key; ///< Place where its key is written.
  LimbManner manner = {};
  bool ledByHead = false; ///< Trails bring its head elsewhere, however the joints run; its other end stays.
};

struct PlannedController {
  std::string id;
  FigurePoint place;
};

/// From where the figure is seen: in front, its left is on the right; from above, on the left.
enum class FigureView { front, above };

/// Features that bodies of one sort have in common: data, and nothing else asks which plan it is
/// (docs/body_plans.md).
struct BodyPlan {
  std::string id;                 ///< "quadruped".
  std::string title;              ///< "a quadruped".
  int legs = 0;                   ///< That it stands on.
  std::vector<PlannedLimb> limbs; ///< In the order of LimbPlace, which is that of the keys 1 to 9.
  std::vector<PlannedController> controllers;
  FigureView view = FigureView::above;
};

/// All of them, the biped first, `other` last: it has no limbs of its own and fits every body.
[[nodiscard]] const std::vector<BodyPlan>& bodyPlans();

/// "biped, quadruped, ...".
[[nodiscard]] std::string planIds();

/// Null when there is none of the id.
[[nodiscard]] const BodyPlan* planNamed(std::string_view id);

/// Null when the plan has no limb of the id, or at the place.
[[nodiscard]] const PlannedLimb* plannedLimb(const BodyPlan& plan, std::string_view id);
[[nodiscard]] const PlannedLimb* plannedLimb(const BodyPlan& plan, const LimbPlace& place);

/// The place of a limb; that of a chain where the plan has none of the id.
[[nodiscard]] LimbPlace placeInPlan(const BodyPlan& plan, std::string_view id);

} // namespace stretch::rig
