#include "ui/render/trail_drawing.h"

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

Polyline pathLine(const TrailPicture& trail, const std::vector<Vec3>& path, const PathStyle& style) {
  const bool hasColors = !style.dashed && trail.exaggeratedColors.size() == path.size();
  Polyline line;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const glm::vec4 color = hasColors ? trail.exaggeratedColors[i] : style.color;
    line.points.push_back(
        {path[i], withAlpha(color, windowShare(trail, static_cast<double>(i))), style.widthPoints});
  }
  line.dashPoints = style.dashed ? 6.0F : 0.0F;
  line.gapPoints = style.dashed ? 5.0F : 0.0F;
  line.outlined = !style.dashed;
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
  overlay.lines.push_back(pathLine(trail, path, style));
  addTicks(overlay, view, trail, path, style);
}

Marker sphereMark(const TrailSphere& sphere, const TrailStyle& style) {
  const float growth = sphere.selected ? 1.25F : sphere.hovered ? 1.15F : 1.0F;
  Marker mark;
  mark.world = sphere.world;
  mark.shape = MarkerShape::sphere;
  mark.radiusPoints = growth * style.sphereRadiusPoints;
  mark.fill = sphere.hovered && !sphere.selected ? glm::mix(style.exaggeratedColor, glm::vec4(1.0F), 0.35F)
                                                 : style.exaggeratedColor;
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

TrailStyle quieter(TrailStyle style) {
  constexpr float quiet = 0.55F;
  style.originalColor = withAlpha(style.originalColor, quiet);
  style.exaggeratedColor = withAlpha(style.exaggeratedColor, quiet);
  style.currentColor = withAlpha(style.currentColor, quiet);
  style.exaggeratedWidthPoints *= 0.6F;
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
  for (const TrailSphere& sphere : trail.spheres) {
    overlay.markers.push_back(sphereMark(sphere, style));
  }
  addEnds(overlay, trail, style);
  addCurrent(overlay, trail, style);
  return overlay;
}

} // namespace stretch::ui
