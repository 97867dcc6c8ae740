#include "ui/render/viewport_renderer.h"

namespace stretch::ui {

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
  const Status resized =
      target.resize(static_cast<int>(viewport.widthPixels), static_cast<int>(viewport.heightPixels),
                    picture.style.quality.samples);
  if (!resized) {
    return resized;
  }
  const GlStateGuard guard;
  scene_.draw(view, picture.frame, picture.ghosts, picture.style, target.framebufferId());
  target.bind();
  overlay_.draw(view, picture.overlay, picture.style.palette);
  target.resolve();
  return Success{};
}

} // namespace stretch::ui
