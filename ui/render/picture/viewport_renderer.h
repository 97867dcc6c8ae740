#pragma once

#include <span>

#include "ui/render/gl/render_target.h"
#include "ui/render/overlay/overlay_renderer.h"
#include "ui/render/scene/scene_renderer.h"

namespace stretch::ui {

/// Everything that the viewport shows of one moment.
struct ViewportPicture {
  const FrameState& frame;
  std::span<const Ghost> ghosts;
  const Overlay& overlay;
  const SceneStyle& style;
};

/// The one that the viewport pane and the pictures without a display call: scene and overlays into a target.
class ViewportRenderer {
public:
  /// Needs a current context of OpenGL 3.3 core; an error carries the driver's complaint.
  [[nodiscard]] static Result<ViewportRenderer> create();

  /// Uploads the scene; call again when another file was opened. The scene must live as long as it is drawn.
  void setScene(const Scene& scene) { scene_.setScene(scene); }
  [[nodiscard]] double secondsUnthinned() const { return scene_.secondsUnthinned(); }
  /// See SceneRenderer::reshape.
  void reshape(const SceneShape& shape) { scene_.reshape(shape); }

  /// Draws and resolves. The target gets the viewport's size and the style's samples first, so a pane just
  /// passes its size in. The state of the context that the caller set stays as it was.
  Status draw(RenderTarget& target, const View& view, const ViewportPicture& picture);

private:
  ViewportRenderer(SceneRenderer scene, OverlayRenderer overlay)
      : scene_(std::move(scene)), overlay_(std::move(overlay)), inSoftware_(drawsInSoftware()) {}

  SceneRenderer scene_;
  OverlayRenderer overlay_;
  bool inSoftware_ = false;
};

} // namespace stretch::ui
