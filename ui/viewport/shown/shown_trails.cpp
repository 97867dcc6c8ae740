#include "ui/viewport/shown/shown_trails.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"

namespace stretch::ui {

namespace {

ShownTrail showTrail(const rig::SolvedTrail& solved, const app::TrailPaths& paths) {
  ShownTrail shown;
  shown.id = solved.trail.id;
  shown.colour = solved.trail.colour;
  shown.exaggerated = solved.trail.exaggerated;
  shown.applied = solved.trail.applied;
  shown.startFrame = solved.settings.startFrame;
  shown.endFrame = solved.settings.endFrame;
  shown.pivot = solved.settings.pivot;
  shown.drawn = paths.drawn;
  const rig::DrawnTrail& spheres = paths.spheres;
  for (std::size_t i = 0; i < spheres.frames.size(); ++i) {
    shown.spheres.push_back(
        {spheres.frames[i], shown.exaggerated ? spheres.exaggerated[i] : spheres.original[i]});
  }
  return shown;
}

} // namespace

ShownTrails shownTrails(std::shared_ptr<const rig::MotionState> motion,
                        const std::vector<app::TrailPaths>& paths) {
  ShownTrails shown{.madeFrom = std::move(motion)};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    shown.trails.push_back(showTrail(shown.madeFrom->trails[i], paths[i]));
  }
  return shown;
}

void updateShownTrails(app::Session& session, ShownTrails& shown) {
  std::shared_ptr<const rig::MotionState> motion = session.sharedMotion();
  if (shown.madeFrom == motion) {
    return;
  }
  shown = app::hasClip(session.document(), session.view().clip)
              ? shownTrails(std::move(motion), session.paths(pathSamplesPerFrame))
              : ShownTrails{.madeFrom = std::move(motion)};
}

const ShownTrail* findShown(const ShownTrails& shown, int trailId) {
  const auto found =
      std::ranges::find_if(shown.trails, [&](const ShownTrail& trail) { return trail.id == trailId; });
  return found == shown.trails.end() ? nullptr : &*found;
}

bool isDrawn(const rig::Trail& trail, const std::vector<std::string>& selectedLimbs,
             const ViewportOverlays& overlays) {
  const bool selected =
      std::find(selectedLimbs.begin(), selectedLimbs.end(), trail.limb) != selectedLimbs.end();
  return trail.visible && (trail.pinned || selected || !overlays.trailsOnlyWhenSelected);
}

bool isSeen(const app::Session& session, int trailId, const ViewportOverlays& overlays) {
  const rig::Trail* const trail = app::findTrail(session.document(), trailId);
  return trail != nullptr && !app::showsLocators(session) &&
         isDrawn(*trail, session.view().selection.limbs(), overlays);
}

Vec3 pointOnTrail(const ShownTrail& trail, double frame, bool exaggerated) {
  const std::vector<Vec3>& points = exaggerated ? trail.drawn.exaggerated : trail.drawn.original;
  const std::vector<double>& frames = trail.drawn.frames;
  if (points.empty()) {
    return Vec3(0.0);
  }
  const auto after = std::lower_bound(frames.begin(), frames.end(), frame - 1e-6);
  const auto index = static_cast<std::size_t>(after - frames.begin());
  if (index == 0 || index >= points.size()) {
    return index == 0 ? points.front() : points.back();
  }
  const double share = (frame - frames[index - 1]) / (frames[index] - frames[index - 1]);
  return glm::mix(points[index - 1], points[index], std::clamp(share, 0.0, 1.0));
}

} // namespace stretch::ui
