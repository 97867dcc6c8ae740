#include "ui/render/overlay/trail_drawing.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace stretch::ui {

namespace {

const glm::vec4 darkEdge(0.07F, 0.075F, 0.085F, 0.9F);

glm::vec4 withAlpha(const glm::vec4& color, float share) {
  return {color.r, color.g, color.b, color.a * share};
}

// Opacity of a sample: full inside the window around the playhead, fading over half a window outside it.
float windowShare(const TrailPicture& trail, double sample) {
  if (!trail.windowSamples || !trail.currentSample) {
    return 1.0F;
  }
  const double beyond = std::abs(sample - *trail.currentSample) - *trail.windowSamples;
  const double fade = std::max(0.5 * *trail.windowSamples, 1.0);
  return static_cast<float>(1.0 - std::clamp(beyond / fade, 0.0, 1.0));
}

struct PathStyle {
  glm::vec4 color;
  float widthPoints = 2.0F;
  bool dashed = false;
};

/// A point between samples, on a curve through them (E. Catmull, R. Rom, "A class of local interpolating
/// splines", 1974).
Vec3 pointBetween(const std::vector<Vec3>& path, std::size_t segment, double t) {
  const Vec3& from = path[segment];
  const Vec3& to = path[segment + 1];
  const Vec3& before = segment == 0 ? from : path[segment - 1];
  const Vec3& after = segment + 2 < path.size() ? path[segment + 2] : to;
  return from + 0.5 * t *
                    ((to - before) + t * ((2.0 * before - 5.0 * from + 4.0 * to - after) +
                                          t * (3.0 * (from - to) + after - before)));
}

/// Straight pieces that a segment is drawn with, so that no corner shows at any zoom.
int piecesOf(const View& view, const Vec3& from, const Vec3& to) {
  constexpr double longestPoints = 7.0;
  constexpr int most = 24;
  const std::optional<ScreenPoint> start = projectToPixels(view, from);
  const std::optional<ScreenPoint> end = projectToPixels(view, to);
  if (!start || !end) {
    return 1;
  }
  const double points = glm::distance(start->pixels, end->pixels) / view.viewport.pixelsPerPoint;
  return std::clamp(static_cast<int>(std::min(points / longestPoints, 1e3)), 1, most);
}

Polyline pathLine(const View& view, const TrailPicture& trail, const std::vector<Vec3>& path,
                  const PathStyle& style) {
  const bool hasColors = !style.dashed && trail.exaggeratedColors.size() == path.size();
  Polyline line;
  const auto add = [&](const Vec3& place, double sample) {
    const glm::vec4 color =
        hasColors ? trail.exaggeratedColors[static_cast<std::size_t>(std::round(sample))] : style.color;
    line.points.push_back({place, withAlpha(color, windowShare(trail, sample)), style.widthPoints});
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const int pieces = piecesOf(view, path[i], path[i + 1]);
    for (int piece = 0; piece < pieces; ++piece) {
      const double t = static_cast<double>(piece) / pieces;
      add(piece == 0 ? path[i] : pointBetween(path, i, t), static_cast<double>(i) + t);
    }
  }
  add(path.back(), static_cast<double>(path.size() - 1));
  line.dashPoints = style.dashed ? 6.0F : 0.0F;
  line.gapPoints = style.dashed ? 5.0F : 0.0F;
  line.outlined = true;
  return line;
}

// Direction of the path on the screen at a sample, from the screen's right towards its top.
double screenAngle(const View& view, const std::vector<Vec3>& path, std::size_t sample) {
  const std::optional<ScreenPoint> before = projectToPixels(view, path[sample == 0 ? 0 : sample - 1]);
  const std::optional<ScreenPoint> after = projectToPixels(view, path[std::min(sample + 1, path.size() - 1)]);
  if (!before || !after) {
    return 0.0;
  }
  const Vec2 along = after->pixels - before->pixels;
  return std::atan2(-along.y, along.x);
}

void addTicks(Overlay& overlay, const View& view, const TrailPicture& trail, const std::vector<Vec3>& path,
              const PathStyle& style) {
  for (std::size_t sample = 0; trail.samplesPerFrame > 0 && sample < path.size();
       sample += trail.samplesPerFrame) {
    const float share = windowShare(trail, static_cast<double>(sample));
    Marker mark;
    mark.world = path[sample];
    mark.shape = style.dashed ? MarkerShape::tick : MarkerShape::disc;
    mark.radiusPoints = style.dashed ? 3.5F : 0.5F * style.widthPoints + 1.0F;
    mark.turnRadians = style.dashed ? screenAngle(view, path, sample) : 0.0;
    mark.fill = style.dashed ? withAlpha(style.color, share)
                             : withAlpha(glm::mix(style.color, glm::vec4(1.0F), 0.55F), share);
    mark.edge = withAlpha(darkEdge, share);
    mark.edgePoints = style.dashed ? 0.0F : 1.0F;
    overlay.markers.push_back(mark);
  }
}

Marker currentMark(const Vec3& place, const glm::vec4& fill, const glm::vec4& edge, float radiusPoints) {
  Marker mark;
  mark.world = place;
  mark.radiusPoints = radiusPoints;
  mark.fill = fill;
  mark.edge = edge;
  mark.edgePoints = 2.0F;
  mark.depth = OverlayDepth::onTop;
  return mark;
}

void addPath(Overlay& overlay, const View& view, const TrailPicture& trail, const std::vector<Vec3>& path,
             const PathStyle& style) {
  if (path.empty()) {
    return;
  }
  overlay.lines.push_back(pathLine(view, trail, path, style));
  addTicks(overlay, view, trail, path, style);
}

/// How large spheres may be on the screen so that they keep apart: one for each, points.
std::vector<float> roomForSpheres(const View& view, const std::vector<TrailSphere>& spheres) {
  constexpr double shareOfGap = 0.45;
  constexpr float least = 2.5F;
  std::vector<std::optional<ScreenPoint>> places;
  places.reserve(spheres.size());
  for (const TrailSphere& sphere : spheres) {
    places.push_back(projectToPixels(view, sphere.world));
  }
  std::vector<float> room(spheres.size(), 1e3F);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; places[i] && k < places.size(); ++k) {
      if (k != i && places[k]) {
        const double gap = glm::distance(places[i]->pixels, places[k]->pixels) / view.viewport.pixelsPerPoint;
        room[i] = std::min(room[i], std::max(least, static_cast<float>(shareOfGap * gap)));
      }
    }
  }
  return room;
}

Marker sphereMark(const TrailSphere& sphere, const TrailStyle& style, float roomPoints) {
  constexpr float farShare = 0.6F;
  constexpr float seeThrough = 0.62F;
  const bool picked = sphere.selected || sphere.hovered;
  const float growth = sphere.selected ? 1.25F : sphere.hovered ? 1.15F : sphere.nearby ? 1.0F : farShare;
  const float wanted = growth * style.sphereRadiusPoints;
  Marker mark;
  mark.world = sphere.world;
  mark.shape = MarkerShape::sphere;
  mark.radiusPoints = picked ? wanted : std::min(wanted, std::max(roomPoints, 0.35F * wanted));
  mark.fill = sphere.hovered && !sphere.selected ? glm::mix(style.exaggeratedColor, glm::vec4(1.0F), 0.35F)
                                                 : style.exaggeratedColor;
  mark.fill = picked ? mark.fill : withAlpha(mark.fill, seeThrough);
  mark.edge = sphere.selected ? style.currentColor : darkEdge;
  mark.edgePoints = sphere.selected ? 2.5F : 1.5F;
  mark.depth = OverlayDepth::onTop;
  return mark;
}

// Comes after the spheres: where both stand at one place the mark shows inside the sphere.
void addCurrent(Overlay& overlay, const TrailPicture& trail, const TrailStyle& style) {
  if (!trail.currentSample) {
    return;
  }
  if (!trail.original.empty()) {
    overlay.markers.push_back(currentMark(pointOfPath(trail.original, *trail.currentSample),
                                          style.currentColor, style.originalColor, 3.5F));
  }
  if (!trail.exaggerated.empty()) {
    overlay.markers.push_back(currentMark(pointOfPath(trail.exaggerated, *trail.currentSample),
                                          style.currentColor, style.exaggeratedColor,
                                          0.5F * style.exaggeratedWidthPoints + 2.0F));
  }
}

void addEnds(Overlay& overlay, const TrailPicture& trail, const TrailStyle& style) {
  if (trail.pivot) {
    Marker pivot = currentMark(*trail.pivot, darkEdge, style.exaggeratedColor, 4.5F);
    pivot.shape = MarkerShape::diamond;
    overlay.markers.push_back(pivot);
  }
  if (trail.tip) {
    Marker tip = currentMark(*trail.tip, glm::vec4(0.0F), style.exaggeratedColor, 10.0F);
    tip.shape = MarkerShape::ring;
    tip.edgePoints = 1.5F;
    overlay.markers.push_back(tip);
  }
}

/// Thinner and without force, but readable on every ground: what is done and what is not selected.
TrailStyle quieter(TrailStyle style) {
  constexpr float quietOriginal = 0.6F;
  constexpr float quiet = 0.85F;
  style.originalColor = withAlpha(style.originalColor, quietOriginal);
  style.exaggeratedColor = withAlpha(style.exaggeratedColor, quiet);
  style.currentColor = withAlpha(style.currentColor, quiet);
  style.exaggeratedWidthPoints *= 0.7F;
  return style;
}

} // namespace

Vec3 pointOfPath(const std::vector<Vec3>& path, double sample) {
  const auto last = static_cast<double>(path.size() - 1);
  const double place = std::clamp(sample, 0.0, last);
  const auto index = std::min(static_cast<std::size_t>(place), path.size() - 1);
  return glm::mix(path[index], path[std::min(index + 1, path.size() - 1)], place - std::floor(place));
}

Overlay drawTrail(const View& view, const TrailPicture& trail, const TrailStyle& wanted) {
  const TrailStyle style = wanted.emphasised ? wanted : quieter(wanted);
  Overlay overlay;
  addPath(overlay, view, trail, trail.original, {style.originalColor, style.originalWidthPoints, true});
  addPath(overlay, view, trail, trail.exaggerated,
          {style.exaggeratedColor, style.exaggeratedWidthPoints, false});
  const std::vector<float> room = roomForSpheres(view, trail.spheres);
  for (std::size_t i = 0; i < trail.spheres.size(); ++i) {
    overlay.markers.push_back(sphereMark(trail.spheres[i], style, room[i]));
  }
  addEnds(overlay, trail, style);
  addCurrent(overlay, trail, style);
  return overlay;
}

} // namespace stretch::ui
