#include "ui/viewport/shown/tangent_handles.h"

#include <glm/geometric.hpp>

#include "app/edits/trail/sphere_edits.h"
#include "core/anim/frames.h"
#include "ui/viewport/shown/shown_trails.h"

namespace stretch::ui {

namespace {

constexpr double shortestPoints = 34.0; ///< Clear of the sphere and of what takes the mouse for it.
constexpr double reachPoints = 10.0;

/// The tip, moved out along the handle where it would stand on its sphere.
Vec3 shownTip(const View& view, const app::TangentHandle& handle) {
  const auto from = projectToPixels(view, handle.sphereWorld);
  const auto to = projectToPixels(view, handle.tipWorld);
  if (!from || !to) {
    return handle.tipWorld;
  }
  const double wanted = shortestPoints * view.viewport.pixelsPerPoint;
  const double pixels = glm::distance(from->pixels, to->pixels);
  if (pixels >= wanted) {
    return handle.tipWorld;
  }
  const Vec3 arm = handle.tipWorld - handle.sphereWorld;
  const double length = glm::length(arm);
  const double unitsWanted = wanted * unitsPerPixel(view, handle.sphereWorld);
  // One that points at the viewer keeps short on the screen: growing without end would help nobody.
  const bool pointsAway = pixels > 0.2 * length / unitsPerPixel(view, handle.sphereWorld);
  // Where the path all but stands still it has no direction to show.
  const Vec3 direction = length > 0.15 * unitsWanted ? arm / length : handle.towardsNeighbour;
  const bool grows = pointsAway && length > 0.15 * unitsWanted;
  return handle.sphereWorld + (grows ? length * wanted / pixels : unitsWanted) * direction;
}

} // namespace

void updateTangents(app::Session& session, const ViewportOverlays& overlays, const View& view,
                    ShownTangents& shown) {
  const std::vector<double>& selected = session.view().selection.spheres();
  if (selected.empty() || !isSeen(session, session.view().selection.trail(), overlays)) {
    shown = {};
    return;
  }
  std::shared_ptr<const rig::MotionState> motion = session.sharedMotion();
  if (motion != shown.motion || !sameFrame(selected.back(), shown.sphereFrame)) {
    shown = {{}, std::move(motion), selected.back()};
    for (const app::TangentHandle& handle : app::tangentHandles(session, selected.back())) {
      shown.handles.push_back({handle, handle.tipWorld});
    }
  }
  for (ShownTangent& tangent : shown.handles) {
    tangent.tipWorld = shownTip(view, tangent.handle);
  }
}

std::optional<std::size_t> pickTangent(const View& view, const ShownTangents& shown,
                                       const Vec2& mousePixels) {
  const double scale = view.viewport.pixelsPerPoint;
  std::optional<std::size_t> best;
  double nearest = reachPoints * scale;
  for (std::size_t i = 0; i < shown.handles.size(); ++i) {
    const auto tip = projectToPixels(view, shown.handles[i].tipWorld);
    const auto sphere = projectToPixels(view, shown.handles[i].handle.sphereWorld);
    if (!tip || !sphere) {
      continue;
    }
    const double toTip = glm::distance(tip->pixels, mousePixels);
    if (toTip <= nearest && toTip < glm::distance(sphere->pixels, mousePixels)) {
      nearest = toTip;
      best = i;
    }
  }
  return best;
}

} // namespace stretch::ui
