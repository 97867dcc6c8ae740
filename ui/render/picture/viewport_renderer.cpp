#include "ui/render/picture/viewport_renderer.h"

#include <cmath>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

// A floor that is seen edge-on, as in the front and side views, shows nothing: a line behind the character
// stands for it.
Overlay floorEdge(const View& view, const SceneStyle& style) {
  constexpr double steepestSine = 1e-3;
  constexpr double heightsBehind = 3.0;
  const bool orthographic = view.projection[3][3] != 0.0;
  Overlay overlay;
  if (!style.floor || !orthographic || std::abs(view.forward.y) > steepestSine) {
    return overlay;
  }
  const double away = heightsBehind * style.measures.characterHeight - glm::dot(view.eye, view.forward);
  Vec3 middle = view.eye + away * view.forward;
  middle.y = style.measures.floorHeight;
  const Vec3 reach = 2.0 * style.measures.characterHeight * viewRight(view);
  const glm::vec4 full(style.palette.floorLine, 1.0F);
  const glm::vec4 none(style.palette.floorLine, 0.0F);
  Polyline line;
  line.points = {{middle - reach, none, 1.5F}, {middle, full, 1.5F}, {middle + reach, none, 1.5F}};
  overlay.lines.push_back(line);
  return overlay;
}

} // namespace

Result<ViewportRenderer> ViewportRenderer::create() {
  Result<SceneRenderer> scene = SceneRenderer::create();
  if (!scene) {
    return scene.error();
  }
  Result<OverlayRenderer> overlay = OverlayRenderer::create();
  if (!overlay) {
    return overlay.error();
  }
  return ViewportRenderer(std::move(scene).value(), std::move(overlay).value());
}

Status ViewportRenderer::draw(RenderTarget& target, const View& view, const ViewportPicture& picture) {
  const Viewport& viewport = view.viewport;
  Status resized = target.resize(static_cast<int>(viewport.widthPixels),
                                 static_cast<int>(viewport.heightPixels), picture.style.quality.samples);
  if (!resized) {
    return resized;
  }
  const GlStateGuard guard;
  scene_.draw(view, picture.frame, picture.ghosts, picture.style, target.framebufferId());
  target.bind();
  overlay_.draw(view, floorEdge(view, picture.style), picture.style.palette);
  overlay_.draw(view, picture.overlay, picture.style.palette);
  target.resolve();
  if (inSoftware_) {
    glFinish(); // software draws on threads of its own: whoever times this call shall see what the frame took
  }
  return Success{};
}

} // namespace stretch::ui
