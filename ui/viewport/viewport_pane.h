#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "ui/render/picture/viewport_renderer.h"
#include "ui/render/scene/bounds.h"
#include "ui/render/view/quality.h"
#include "ui/viewport/sequence_picture.h"
#include "ui/viewport/viewport_context.h"
#include "ui/viewport/welcome.h"

namespace stretch::ui {

/// One picture of the viewport on the graphics card, and what it shows.
struct DrawnPicture {
  RenderTarget target;
  std::uint64_t contentKey = 0; ///< Key of what was drawn; it is not drawn again while this stays.
  std::uint64_t wantedKey = 0;  ///< Key of the last picture that was asked for.
  double wantedSinceSeconds = 0.0;
};

/// Part of a mesh sequence that is on the graphics card.
struct SequenceUpload {
  std::unique_ptr<SequencePicture> picture; ///< Null: nothing yet.
  std::shared_ptr<const Scene> scene;
  std::uint64_t key = 0;    ///< Key of what the picture was made from.
  std::size_t frame = 0;    ///< Frame whose vertices are there.
  std::uint64_t shapes = 0; ///< Number of times that vertices were moved.
};

/// Objects that the viewport keeps on the graphics card; must go before its context.
struct ViewportGpu {
  ViewportRenderer renderer;
  DrawnPicture picture;
  DrawnPicture originalPicture; ///< Beside it, while original and exaggerated are compared.
  QualityGovernor governor;
  std::shared_ptr<const Scene> uploaded;
  std::optional<BoundsSampler> bounds;
  SceneMeasures measures;
  SequenceUpload sequence;
  WelcomePictures welcome;
  bool drewPicture = false; ///< In this frame: tells the governor whether the frame's time counts.
  bool paints = true;       ///< In this frame: pictures that have changed are drawn.
};

[[nodiscard]] Result<std::unique_ptr<ViewportGpu>> createViewportGpu();

/// Draws a picture unless it would be the same again.
void drawPicture(ViewportContext& context, ViewportGpu& gpu, DrawnPicture& drawn,
                 const ViewportPicture& wanted);
/// Puts it into the current window.
void showPicture(const DrawnPicture& drawn, const Rect& box);

/// The viewport with its bar, mouse and overlays, in `rect` (window units).
void drawViewportPane(ViewportContext& context, ViewportGpu& gpu, const Rect& rect, double pixelsPerUnit);

/// Moves the camera so that the selection (or with `everything` the character) fills the viewport.
void frameCamera(ViewportContext& context, ViewportGpu& gpu, bool everything);

} // namespace stretch::ui
