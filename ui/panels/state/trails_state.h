#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::ui {

/// A trail, or a group of trails, that is given a name.
struct RenameState {
  bool open = false;
  int trail = 0; ///< Id; of one in the group.
  bool ofGroup = false;
  std::string present = {}; ///< Its name.
  std::string typed = {};
  bool wasOpen = false; ///< In the frame before.
};

/// Findings that an animator would stumble over in the selected trail, as last looked for.
struct LookState {
  std::shared_ptr<const rig::MotionState> motion = {}; ///< Looked at in this one; null: not yet.
  int trailId = 0;
  std::vector<std::string> warnings = {};
  bool clipCouldLoop = false;                      ///< Marking the clip as a loop mends the way back.
  std::shared_ptr<const rig::MotionState> waiting; ///< A newer one, while it still changes,
  double waitingSince = 0.0;                       ///< seconds of the window's clock.
  bool bodyTravels = false;                        ///< Why a new trail there starts in the space root.
};

/// How much of the selected trail is seen, as last looked for.
struct SeenState {
  std::shared_ptr<const rig::MotionState> motion = {}; ///< Looked at in this one; null: not yet.
  int trailId = 0;
  CameraPlace camera = {};
  std::string text = {};
  double share = 1.0;
};

/// The style that was taken last, and for which trails of which character.
struct TakenStyle {
  std::shared_ptr<const Scene> scene = {}; ///< Null: none was taken.
  std::vector<int> trails = {};            ///< Ids.
  int style = 0;                           ///< Into app::styles().
};

/// The panels of trails and their settings.
struct TrailPanels {
  LookState look;
  SeenState seen;
  TakenStyle takenStyle;
  RenameState rename;
  bool allWarnings = false; ///< Every warning of the trail is listed, not the first alone.
};

} // namespace stretch::ui
