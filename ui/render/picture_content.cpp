#include "ui/render/picture_content.h"

#include "ui/render/skeleton_drawing.h"

namespace stretch::ui {

Overlay overlayOf(const Scene& scene, const View& view, const PictureContent& content) {
  Overlay overlay;
  if (content.skeleton) {
    overlay.add(
        drawSkeleton(scene, content.frame, skeletonStyle(content.style.palette), content.style.highlight));
  }
  for (const StyledTrail& trail : content.trails) {
    overlay.add(drawTrail(view, trail.path, trail.style));
  }
  if (content.handles) {
    overlay.add(drawAxisHandles(view, *content.handles, content.activeAxis));
  }
  return overlay;
}

} // namespace stretch::ui
