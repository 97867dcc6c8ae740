#include "ui/render/picture/picture_content.h"

#include <glm/common.hpp>

#include "ui/render/overlay/skeleton_drawing.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

Overlay overlayOf(const Scene& scene, const View& view, const PictureContent& content) {
  Overlay overlay = content.bones;
  const bool isStickFigure = ui::isStickFigure(scene);
  if (content.skeleton || isStickFigure) {
    SkeletonStyle style = skeletonStyle(content.style.palette);
    style.widthPoints *= isStickFigure ? 1.6F : 1.0F;
    overlay.add(drawSkeleton(scene, content.frame, style, content.style.highlight));
  }
  overlay.add(drawControllers(view, content.controllers, controllerStyle(content.style.palette)));
  for (const StyledTrail& trail : content.trails) {
    overlay.add(drawTrail(view, trail.path, trail.style));
  }
  if (content.controllerHandles) {
    overlay.add(drawControllerHandles(view, *content.controllerHandles, content.activeHandle));
  }
  if (content.handles) {
    overlay.add(drawAxisHandles(view, *content.handles, content.activeAxis));
  }
  return overlay;
}

const std::array<glm::vec4, 3>& axisColours() {
  static const std::array<glm::vec4, 3> colours{rgba(0xE5484D), rgba(0x5BB65B), rgba(0x4C8DF6)};
  return colours;
}

Overlay drawAxisHandles(const View& view, const AxisHandles& handles, std::optional<std::size_t> active) {
  const std::array<Vec3, 3> tips = handleTips(view, handles);
  constexpr double startShare = 0.16; // leaves room for the sphere at the origin
  Overlay overlay;
  for (std::size_t axis = 0; axis < tips.size(); ++axis) {
    Arrow arrow;
    arrow.from = glm::mix(handles.origin, tips[axis], startShare);
    arrow.to = tips[axis];
    arrow.color = axisColours()[axis];
    if (active == axis) {
      arrow.color = glm::mix(arrow.color, glm::vec4(1.0F), 0.35F);
      arrow.widthPoints = 4.0F;
      arrow.headPoints = 15.0F;
    } else if (active) {
      arrow.color.a = 0.45F;
    }
    overlay.arrows.push_back(arrow);
  }
  return overlay;
}

} // namespace stretch::ui
