#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/auto/exaggerate_clip.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"

namespace stretch::ui {

/// A trail, a group of trails, or a selection set that is given a name.
struct RenameState {
  bool open = false;
  int trail = 0; ///< Id; of one in the group; 0: a selection set is named.
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
};

/// The style that was taken last, and for which trails of which character.
struct TakenStyle {
  std::shared_ptr<const Scene> scene = {}; ///< Null: none was taken.
  std::vector<int> trails = {};            ///< Ids.
  int style = 0;                           ///< Into TrailPanels::styles.
  std::vector<rig::Trail> made = {}; ///< Those that were made in it for the whole clip, each with its own
                                     ///< scale.

  /// Whether it was taken for all of these; never where there are none.
  [[nodiscard]] bool isFor(const std::shared_ptr<const Scene>& shown, const std::vector<int>& asked) const {
    return scene != nullptr && scene == shown && !asked.empty() &&
           std::ranges::all_of(asked, [&](int id) { return std::ranges::find(trails, id) != trails.end(); });
  }
};

/// Why trails that are exaggerated leave their limbs as long as they were at the tip, as last looked for.
struct IdleTrails {
  std::shared_ptr<const rig::MotionState> motion = {}; ///< Looked at in this one; null: not yet.
  std::map<int, std::string> why = {}; ///< Reasons of those that do, by id; an empty one is not known.
};

/// The whole clip exaggerated in one style, while it is looked at before it is kept.
struct ClipStyleState {
  bool open = false;
  int style = usualStyle; ///< Into TrailPanels::styles.
  double strength = 1.0;
  std::vector<rig::Moment> moments = {};  ///< Moments of the clip, strongest first.
  std::vector<bool> on = {};              ///< Moments that are to be exaggerated.
  std::vector<app::AutoMoment> made = {}; ///< Outcome of those that are on, as last worked out.
  std::vector<int> trails = {};           ///< Trails that were made for them, and what goes along.
  std::vector<int> replaced = {}; ///< Trails of an earlier style that give way, and that nobody changed.
  bool changed = false;           ///< It is to be worked out anew.
  bool working = false;           ///< It is being worked out.
  bool accepted = false;          ///< It is to be kept, as soon as it is worked out.

  static constexpr int usualStyle = 6; ///< The average of the measured ones.
};

/// Why none of the clip's moments is exaggerated; empty where one is, or it is not known yet.
[[nodiscard]] std::string whyNothing(const ClipStyleState& state);

/// The panels of trails and their settings.
struct TrailPanels {
  std::vector<rig::Style> styles = rig::builtInStyles(); ///< Styles that are offered: with the user's own.
  ClipStyleState clipStyle;
  LookState look;
  SeenState seen;
  IdleTrails idle;
  TakenStyle takenStyle;
  RenameState rename;
  bool allWarnings = false; ///< Every warning of the trail is listed, not the first alone.
};

} // namespace stretch::ui
