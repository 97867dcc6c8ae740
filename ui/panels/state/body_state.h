#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace stretch::ui {

/// Choosing joints from the skeleton tree: a limb's correction or a new chain.
struct JointPick {
  bool open = false;
  std::string limbId; ///< Limb to correct; empty: a new chain.
  NodeIndex baseNode;
  NodeIndex endNode;
  std::string filter;
  std::string message; ///< Why the last try was refused.
};

/// Joint whose weights the viewport shows (ui/panels/body/weight_view.h).
struct WeightView {
  NodeIndex joint;                           ///< None, or one that no mesh follows: the first that one does.
  std::vector<std::string> limbs = {};       ///< That were selected when it was chosen,
  std::vector<std::string> controllers = {}; ///< and controllers.
  std::string filter = {};                   ///< Typed into the list of joints.
};

/// The panels of limbs, rig and controllers.
struct BodyPanels {
  JointPick jointPick;
  WeightView weights;
  std::string jointFilter;  ///< Typed into the list of joints.
  std::string expandedLimb; ///< Limb whose reasons the rig panel shows.
  double tween = 0.5;       ///< Place of the tween that is dragged, from key (0) to key (1).
};

} // namespace stretch::ui
