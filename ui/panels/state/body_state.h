#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/files/user_poses.h"
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

/// The library of poses, while one is tried on the character before it is kept.
struct PoseLibraryState {
  bool open = false;
  std::vector<app::LibraryPose> poses = {}; ///< By name.
  std::vector<ImTextureID> pictures = {};   ///< Pictures of the poses; null: none.
  std::uint64_t version = 0;                ///< Counts how often the list, or a picture, changed.
  int chosen = -1;                          ///< Into poses; -1: none.
  double amount = 1.0;
  bool mirrored = false;
  std::string typedName = {};
  std::string refused = {}; ///< Why a file of the folder is no pose; empty: all are.
  bool deleteAsked = false; ///< The chosen pose is deleted by the next press.
  bool scrolls = false;     ///< The chosen pose is to be scrolled into view.
  std::string remark = {};  ///< Why the chosen pose cannot be taken, or which controllers do not come there.
  bool reaches = false;     ///< The chosen pose can be taken.
  bool changed = false;     ///< The preview is to be made anew.
  bool renamed = false;     ///< The typed name is to be taken.
  bool accepted = false;    ///< The preview is to be kept.
};

/// The panels of limbs, rig and controllers.
struct BodyPanels {
  JointPick jointPick;
  WeightView weights;
  std::string jointFilter;  ///< Typed into the list of joints.
  std::string expandedLimb; ///< Limb whose reasons the rig panel shows.
  double tween = 0.5;       ///< Place of the tween that is dragged, from key (0) to key (1).
  PoseLibraryState library;
};

} // namespace stretch::ui
