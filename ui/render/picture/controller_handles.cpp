#include "ui/render/picture/controller_handles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/render/picking/picking.h"
#include "ui/render/picture/picture_content.h"

namespace stretch::ui {

namespace {

constexpr double arrowPoints = 92.0;
constexpr double ringPoints = 66.0; // radius
constexpr double squareFromPoints = 20.0;
constexpr double squareToPoints = 34.0;
constexpr int pointsAround = 64;

Vec3 unit(std::size_t axis) {
  Vec3 vector(0.0);
  vector[static_cast<int>(axis % 3)] = 1.0;
  return vector;
}

// In a small picture handles are smaller, so that they are not cut off.
double shareOfSize(const View& view) {
  constexpr double mostOfPicture = 0.32;
  const double side = std::min(view.viewport.widthPixels, view.viewport.heightPixels);
  return std::min(1.0, mostOfPicture * side / (arrowPoints * view.viewport.pixelsPerPoint));
}

double unitsPerPoint(const View& view, const Vec3& place) {
  return shareOfSize(view) * view.viewport.pixelsPerPoint * unitsPerPixel(view, place);
}

AxisHandles arrowsOf(const View& view, const ControllerHandles& handles) {
  AxisHandles arrows;
  arrows.origin = handles.origin;
  arrows.lengthPoints = shareOfSize(view) * arrowPoints;
  return arrows;
}

Vec3 towardsViewer(const View& view, const Vec3& place) {
  const bool perspective = view.projection[3][3] == 0.0;
  return perspective ? glm::normalize(view.eye - place) : -view.forward;
}

// Whether the handle shows more than an edge on the screen.
bool isSeen(const View& view, const ControllerHandles& handles, const HandlePart& part) {
  constexpr double edgeOn = 0.12;
  const double across = std::abs(glm::dot(towardsViewer(view, handles.origin), unit(part.axis)));
  return part.kind != HandleKind::plane || across > edgeOn;
}

bool isInside(const View& view, const std::vector<Vec3>& closed, const Vec2& mousePixels) {
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i + 1 < closed.size(); ++i) {
    const auto from = projectToPixels(view, closed[i]);
    const auto to = projectToPixels(view, closed[i + 1]);
    if (!from || !to) {
      return false;
    }
    const Vec2 along = to->pixels - from->pixels;
    const Vec2 away = mousePixels - from->pixels;
    const double side = along.x * away.y - along.y * away.x;
    (side > 0.0 ? left : right) += 1;
  }
  return left == 0 || right == 0;
}

// Pixels from the mouse to the near half of a ring.
std::optional<double> ringDistance(const View& view, const ControllerHandles& handles, std::size_t axis,
                                   const Vec2& mousePixels) {
  constexpr double tolerancePoints = 8.0;
  const std::vector<Vec3> ring = pointsOf(view, handles, {HandleKind::ring, axis});
  std::optional<double> best;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    if (!facesViewer(view, handles.origin, 0.5 * (ring[i] + ring[i + 1]))) {
      continue;
    }
    const std::array<Vec3, 2> piece{ring[i], ring[i + 1]};
    if (const auto hit = pickPolyline(view, piece, mousePixels, tolerancePoints);
        hit && (!best || hit->distancePixels < *best)) {
      best = hit->distancePixels;
    }
  }
  return best;
}

glm::vec4 colourOf(const HandlePart& part, const std::optional<HandlePart>& active) {
  glm::vec4 colour = axisColours()[part.axis];
  if (active == part) {
    return glm::mix(colour, glm::vec4(1.0F), 0.35F);
  }
  colour.a = active ? 0.45F : 1.0F;
  return colour;
}

Polyline lineOf(const View& view, const ControllerHandles& handles, const HandlePart& part,
                const std::optional<HandlePart>& active) {
  constexpr float farHalf = 0.22F;
  const float width = active == part ? 3.0F : 2.0F;
  Polyline line;
  line.depth = OverlayDepth::onTop;
  line.outlined = active == part || part.kind == HandleKind::plane;
  for (const Vec3& point : pointsOf(view, handles, part)) {
    glm::vec4 colour = colourOf(part, active);
    const bool isFar = part.kind == HandleKind::ring && !facesViewer(view, handles.origin, point);
    colour.a *= isFar ? farHalf : 1.0F;
    line.points.push_back({point, colour, width});
  }
  return line;
}

} // namespace

double handleReachPixels(const View& view) {
  return shareOfSize(view) * arrowPoints * view.viewport.pixelsPerPoint;
}

std::vector<HandlePart> partsOf(const ControllerHandles& handles) {
  std::vector<HandlePart> parts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (handles.turns) {
      parts.push_back({HandleKind::ring, axis});
    }
    if (handles.moves) {
      parts.push_back({HandleKind::plane, axis});
      parts.push_back({HandleKind::axis, axis});
    }
  }
  return parts;
}

std::vector<Vec3> pointsOf(const View& view, const ControllerHandles& handles, const HandlePart& part) {
  const double scale = unitsPerPoint(view, handles.origin);
  const Vec3 first = unit(part.axis + 1);
  const Vec3 second = unit(part.axis + 2);
  if (part.kind == HandleKind::axis) {
    const Vec3 axis = unit(part.axis);
    return {handles.origin + 0.16 * arrowPoints * scale * axis, handles.origin + arrowPoints * scale * axis};
  }
  std::vector<Vec3> points;
  if (part.kind == HandleKind::plane) {
    constexpr std::array<Vec2, 5> corners{{{squareFromPoints, squareFromPoints},
                                           {squareToPoints, squareFromPoints},
                                           {squareToPoints, squareToPoints},
                                           {squareFromPoints, squareToPoints},
                                           {squareFromPoints, squareFromPoints}}};
    for (const Vec2& corner : corners) {
      points.push_back(handles.origin + scale * (corner.x * first + corner.y * second));
    }
    return points;
  }
  for (int i = 0; i <= pointsAround; ++i) {
    const double angle = 2.0 * pi * i / pointsAround;
    points.push_back(handles.origin +
                     ringPoints * scale * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

bool facesViewer(const View& view, const Vec3& origin, const Vec3& point) {
  constexpr double edge = -0.05; // of the radius: a ring seen from straight ahead is near all around
  const Vec3 away = point - origin;
  return glm::dot(away, towardsViewer(view, origin)) >= edge * glm::length(away);
}

std::optional<HandlePart> pickHandle(const View& view, const ControllerHandles& handles,
                                     const Vec2& mousePixels) {
  for (std::size_t axis = 0; handles.moves && axis < 3; ++axis) {
    const HandlePart part{HandleKind::plane, axis};
    if (isSeen(view, handles, part) && isInside(view, pointsOf(view, handles, part), mousePixels)) {
      return part;
    }
  }
  if (handles.moves) {
    if (const auto arrow = pickAxis(view, arrowsOf(view, handles), mousePixels)) {
      return HandlePart{HandleKind::axis, *arrow};
    }
  }
  std::optional<HandlePart> best;
  double bestPixels = 1e300;
  for (std::size_t axis = 0; handles.turns && axis < 3; ++axis) {
    const auto pixels = ringDistance(view, handles, axis, mousePixels);
    if (pixels && *pixels < bestPixels) {
      best = HandlePart{HandleKind::ring, axis};
      bestPixels = *pixels;
    }
  }
  return best;
}

Overlay drawControllerHandles(const View& view, const ControllerHandles& handles,
                              const std::optional<HandlePart>& active) {
  Overlay overlay;
  for (const HandlePart& part : partsOf(handles)) {
    if (part.kind != HandleKind::axis && isSeen(view, handles, part)) {
      overlay.lines.push_back(lineOf(view, handles, part, active));
    }
  }
  if (handles.moves) {
    const bool onArrow = active && active->kind == HandleKind::axis;
    Overlay arrows =
        drawAxisHandles(view, arrowsOf(view, handles), onArrow ? std::optional(active->axis) : std::nullopt);
    for (Arrow& arrow : arrows.arrows) {
      arrow.color.a *= active && !onArrow ? 0.45F : 1.0F;
    }
    overlay.add(arrows);
  }
  return overlay;
}

} // namespace stretch::ui
