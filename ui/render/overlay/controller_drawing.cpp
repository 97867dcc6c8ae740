#include "ui/render/overlay/controller_drawing.h"

#include <algorithm>

#include <glm/common.hpp>

namespace stretch::ui {

namespace {

struct LineLook {
  glm::vec4 color{1.0F};
  float widthPoints = 1.5F;
};

LineLook lookOf(const ControllerPicture& controller, const ControllerStyle& style) {
  constexpr float selectedGrowth = 1.6F;
  constexpr float hoveredGrowth = 1.4F;
  const glm::vec4 own = controller.side == BodySide::left    ? style.left
                        : controller.side == BodySide::right ? style.right
                                                             : style.centre;
  LineLook look{own, style.widthPoints};
  if (controller.selected) {
    look = {style.selected, selectedGrowth * style.widthPoints};
  }
  if (controller.hovered) {
    look.color = glm::mix(look.color, style.selected, 0.5F);
    look.widthPoints = std::max(look.widthPoints, hoveredGrowth * style.widthPoints);
  }
  return look;
}

void addLines(const ControllerPicture& controller, const LineLook& look, Overlay& overlay) {
  for (const std::vector<Vec3>& points : controller.lines) {
    Polyline line;
    line.outlined = true;
    for (const Vec3& point : points) {
      line.points.push_back({point, look.color, look.widthPoints});
    }
    overlay.lines.push_back(std::move(line));
  }
}

Marker markAt(const Vec3& place, MarkerShape shape, float radiusPoints) {
  Marker mark;
  mark.world = place;
  mark.shape = shape;
  mark.radiusPoints = radiusPoints;
  return mark;
}

// As large as its neighbours allow; the one that is meant is as large as all are where there is room.
float fittedRing(const View& view, const ControllerPicture& controller, const ControllerStyle& style) {
  if (!controller.ringRoom || controller.selected || controller.hovered) {
    return style.ringPoints;
  }
  const double pixels = *controller.ringRoom / unitsPerPixel(view, *controller.ring);
  const auto room = static_cast<float>(pixels / view.viewport.pixelsPerPoint);
  return std::clamp(room, style.leastRingPoints, style.ringPoints);
}

void addMarks(const View& view, const ControllerPicture& controller, const LineLook& look,
              const ControllerStyle& style, Overlay& overlay) {
  const float growth = look.widthPoints / style.widthPoints;
  if (controller.knob) {
    Marker knob = markAt(*controller.knob, MarkerShape::sphere, style.knobPoints * std::min(growth, 1.3F));
    knob.fill = look.color;
    knob.edge = glm::vec4(0.07F, 0.075F, 0.085F, 0.9F);
    knob.edgePoints = 1.0F;
    overlay.markers.push_back(knob);
  }
  if (controller.ring) {
    Marker ring = markAt(*controller.ring, MarkerShape::ring, fittedRing(view, controller, style));
    ring.fill = glm::vec4(0.0F);
    ring.edge = look.color;
    ring.edgePoints = look.widthPoints;
    ring.depth = OverlayDepth::onTop;
    overlay.markers.push_back(ring);
  }
}

} // namespace

ControllerStyle controllerStyle(const Palette& palette) {
  ControllerStyle style;
  style.centre = palette.controllerCentre;
  style.left = palette.controllerLeft;
  style.right = palette.controllerRight;
  style.selected = palette.selectionLine;
  return style;
}

Overlay drawControllers(const View& view, std::span<const ControllerPicture> controllers,
                        const ControllerStyle& style) {
  Overlay overlay;
  for (const bool picked : {false, true}) {
    for (const ControllerPicture& controller : controllers) {
      if ((controller.selected || controller.hovered) == picked) {
        const LineLook look = lookOf(controller, style);
        addLines(controller, look, overlay);
        addMarks(view, controller, look, style, overlay);
      }
    }
  }
  return overlay;
}

} // namespace stretch::ui
