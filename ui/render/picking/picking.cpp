#include "ui/render/picking/picking.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

struct SegmentDistance {
  double pixels = 0.0;
  double screenFraction = 0.0; // 0..1 along the segment on the screen
};

SegmentDistance distanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double lengthSquared = glm::dot(along, along);
  const double fraction =
      lengthSquared > 0.0 ? std::clamp(glm::dot(point - from, along) / lengthSquared, 0.0, 1.0) : 0.0;
  return {glm::length(point - from - fraction * along), fraction};
}

// Screen position moves along a segment in 1/w: turns a share on the screen into a share in space.
double worldFraction(double screenFraction, double depthFrom, double depthTo, bool perspective) {
  if (!perspective) {
    return screenFraction;
  }
  const double near = screenFraction * depthFrom;
  return near / (near + (1.0 - screenFraction) * depthTo);
}

bool isPerspective(const View& view) {
  return view.projection[3][3] == 0.0;
}

struct SphereCandidate {
  std::size_t index = 0;
  double pixels = 0.0;
  double depth = 0.0;
  bool underMouse = false;
};

bool goesBefore(const SphereCandidate& a, const SphereCandidate& b) {
  if (a.underMouse != b.underMouse) {
    return a.underMouse;
  }
  if (a.underMouse || a.pixels == b.pixels) {
    return a.depth < b.depth;
  }
  return a.pixels < b.pixels;
}

} // namespace

std::optional<std::size_t> pickSphere(const View& view, std::span<const Vec3> centresWorld,
                                      const Vec2& mousePixels, const SphereRadii& radii) {
  const double scale = view.viewport.pixelsPerPoint;
  std::optional<SphereCandidate> best;
  for (std::size_t i = 0; i < centresWorld.size(); ++i) {
    const std::optional<ScreenPoint> centre = projectToPixels(view, centresWorld[i]);
    if (!centre) {
      continue;
    }
    const double pixels = glm::length(centre->pixels - mousePixels);
    const SphereCandidate candidate{i, pixels, centre->depth, pixels <= radii.drawnPoints * scale};
    if (pixels <= std::max(radii.hitPoints, radii.drawnPoints) * scale &&
        (!best || goesBefore(candidate, *best))) {
      best = candidate;
    }
  }
  return best ? std::optional(best->index) : std::nullopt;
}

std::array<Vec3, 3> handleTips(const View& view, const AxisHandles& handles) {
  const double length =
      handles.lengthPoints * view.viewport.pixelsPerPoint * unitsPerPixel(view, handles.origin);
  return {handles.origin + length * handles.axes[0], handles.origin + length * handles.axes[1],
          handles.origin + length * handles.axes[2]};
}

std::optional<std::size_t> pickAxis(const View& view, const AxisHandles& handles, const Vec2& mousePixels,
                                    double tolerancePoints) {
  constexpr double shortestPoints = 8.0;
  constexpr double ownedByOrigin = 0.2;
  const double scale = view.viewport.pixelsPerPoint;
  const std::optional<ScreenPoint> origin = projectToPixels(view, handles.origin);
  const std::array<Vec3, 3> tips = handleTips(view, handles);
  std::optional<std::size_t> best;
  double bestPixels = tolerancePoints * scale;
  for (std::size_t axis = 0; origin && axis < tips.size(); ++axis) {
    const std::optional<ScreenPoint> tip = projectToPixels(view, tips[axis]);
    if (!tip || glm::length(tip->pixels - origin->pixels) < shortestPoints * scale) {
      continue;
    }
    const Vec2 start = glm::mix(origin->pixels, tip->pixels, ownedByOrigin);
    const double pixels = distanceToSegment(mousePixels, start, tip->pixels).pixels;
    if (pixels <= bestPixels && (!best || pixels < bestPixels)) {
      best = axis;
      bestPixels = pixels;
    }
  }
  return best;
}

std::optional<PolylineHit> pickPolyline(const View& view, std::span<const Vec3> pointsWorld,
                                        const Vec2& mousePixels, double tolerancePoints) {
  std::optional<PolylineHit> best;
  const double tolerancePixels = tolerancePoints * view.viewport.pixelsPerPoint;
  for (std::size_t i = 0; i + 1 < pointsWorld.size(); ++i) {
    const std::optional<ScreenPoint> from = projectToPixels(view, pointsWorld[i]);
    const std::optional<ScreenPoint> to = projectToPixels(view, pointsWorld[i + 1]);
    if (!from || !to) {
      continue;
    }
    const SegmentDistance distance = distanceToSegment(mousePixels, from->pixels, to->pixels);
    if (distance.pixels <= tolerancePixels && (!best || distance.pixels < best->distancePixels)) {
      const double fraction =
          worldFraction(distance.screenFraction, from->depth, to->depth, isPerspective(view));
      best =
          PolylineHit{i, fraction, glm::mix(pointsWorld[i], pointsWorld[i + 1], fraction), distance.pixels};
    }
  }
  return best;
}

std::optional<std::size_t> pickBone(const View& view, std::span<const BoneSegment> bones,
                                    const Vec2& mousePixels, double tolerancePoints) {
  constexpr double equallyNearPoints = 3.0;
  const double scale = view.viewport.pixelsPerPoint;
  std::optional<std::size_t> best;
  double bestPixels = 0.0;
  double bestDepth = 0.0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const BoneSegment& bone = bones[i];
    const std::optional<ScreenPoint> from = projectToPixels(view, bone.fromWorld);
    const std::optional<ScreenPoint> to = projectToPixels(view, bone.toWorld);
    if (!from || !to) {
      continue;
    }
    const SegmentDistance distance = distanceToSegment(mousePixels, from->pixels, to->pixels);
    const double depth = glm::mix(from->depth, to->depth, distance.screenFraction);
    const bool clearlyNearer = distance.pixels < bestPixels - equallyNearPoints * scale;
    const bool equallyNear = distance.pixels <= bestPixels + equallyNearPoints * scale;
    if (distance.pixels <= tolerancePoints * scale &&
        (!best || clearlyNearer || (equallyNear && depth < bestDepth))) {
      best = i;
      bestPixels = distance.pixels;
      bestDepth = depth;
    }
  }
  return best;
}

} // namespace stretch::ui
