#pragma once

#include <memory>
#include <vector>

#include "app/edits/trail/sphere_edits.h"
#include "app/session.h"
#include "ui/panels/state/ui_state.h"
#include "ui/render/picking/picking.h"

namespace stretch::ui {

/// Samples of a drawn path.
inline constexpr std::size_t pathSamplesPerFrame = 2;

/// One trail as pictures show it.
struct ShownTrail {
  int id = 0;
  rig::DrawnTrail drawn; ///< pathSamplesPerFrame samples a frame.
  std::vector<app::PlacedSphere> spheres;
  int colour = 0;
  bool exaggerated = false;
  bool applied = false; ///< Drawn quieter.
  double startFrame = 0.0;
  double endFrame = 0.0;
  rig::Pivot pivot = rig::Pivot::start;
};

/// The trails of a clip, and what they were made from.
struct ShownTrails {
  std::vector<ShownTrail> trails = {};
  std::shared_ptr<const rig::MotionState> madeFrom; ///< They are made again only when it is another.
  std::vector<Vec3> momentPath = {}; ///< Way of a moment, world space, two points a frame; empty: none is
                                     ///< shown.
};

/// `paths`: one for each trail of the motion, pathSamplesPerFrame samples a frame.
[[nodiscard]] ShownTrails shownTrails(std::shared_ptr<const rig::MotionState> motion,
                                      const std::vector<app::TrailPaths>& paths);

/// Makes `shown` again where the document's trails differ from what it was made from.
void updateShownTrails(app::Session& session, ShownTrails& shown);

/// Null when it is not shown.
[[nodiscard]] const ShownTrail* findShown(const ShownTrails& shown, int trailId);

/// Whether a trail is drawn: visible, and pinned, on a selected limb, or everything is.
[[nodiscard]] bool isDrawn(const rig::Trail& trail, const std::vector<std::string>& selectedLimbs,
                           const ViewportOverlays& overlays);

/// Whether the trail with that id is drawn of the open character: none is beside locators.
[[nodiscard]] bool isSeen(const app::Session& session, int trailId, const ViewportOverlays& overlays);

/// The exaggerated path at a frame, or the original where there is none.
[[nodiscard]] Vec3 pointOnTrail(const ShownTrail& trail, double frame, bool exaggerated);

} // namespace stretch::ui
