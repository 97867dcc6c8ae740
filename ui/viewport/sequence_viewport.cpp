#include "ui/viewport/sequence_viewport.h"

#include <memory>
#include <optional>
#include <utility>

#include <imgui.h>

#include "core/base/hash.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/viewport/cube_marker.h"
#include "ui/viewport/sequence_picture.h"
#include "ui/widgets/color_legend.h"

namespace stretch::ui {

namespace {

/// What the scene on the graphics card was made from: it is made and uploaded again when this changes.
std::uint64_t sceneKey(const app::SequenceSession& session) {
  Hash key;
  key.mix(session.document().mesh.get());
  key.mix(session.document().result.get());
  key.mix(session.view().showOriginal);
  key.mix(session.view().showSkinned);
  key.mix(session.view().look);
  return key.value();
}

/// The scene once, then the vertices of each frame alone.
void uploadFrame(const app::SequenceSession& session, ViewportGpu& gpu) {
  SequenceUpload& upload = gpu.sequence;
  const std::uint64_t key = sceneKey(session);
  const std::size_t frame = app::shownFrame(session);
  const bool isNew = upload.picture == nullptr || gpu.uploaded != upload.scene || upload.key != key;
  if (isNew) {
    upload.picture = std::make_unique<SequencePicture>(contentOf(session.document()), session.view());
    upload.scene = std::make_shared<const Scene>(upload.picture->scene());
    upload.key = key;
    gpu.uploaded = upload.scene;
    gpu.renderer.setScene(*upload.scene);
  }
  if (isNew || upload.frame != frame) {
    gpu.renderer.reshape(upload.picture->shapeAt(frame));
    upload.frame = frame;
    ++upload.shapes;
  }
}

SceneStyle sequenceStyleOf(const ViewportContext& context, const ViewportGpu& gpu) {
  const app::SequenceDocument& document = context.open.sequence()->document();
  SceneStyle style;
  style.palette = paletteOf(context.theme.kind);
  style.quality = qualityOf(gpu.governor.level());
  style.wireframe = context.ui.overlays.wire;
  style.floor = context.ui.overlays.grid;
  style.measures = {document.analysis->low.y, 0.4 * boxDiagonal(std::as_const(*document.mesh).frame(0))};
  return style;
}

void drawLegend(ViewportContext& context, const SequencePicture& picture) {
  const std::optional<SequenceLegend>& legend = picture.legend();
  if (!legend) {
    return;
  }
  const ColorLegend bar{legend->title, legend->low, legend->high, legend->detail,
                        [&](double share) { return packed(legend->colour(share)); }};
  const Theme& theme = context.theme;
  const Rect& box = context.viewport.box;
  const ImVec2 size = legendSize(theme, bar);
  drawColorLegend(WidgetContext{theme, context.items}, "viewport/legend",
                  {box.min.x + theme.px(12.0F), box.max.y - theme.px(12.0F) - size.y}, bar);
}

} // namespace

void frameSequence(ViewportContext& context) {
  const app::SequenceAnalysis& analysis = *context.open.sequence()->document().analysis;
  Box box;
  box.add(analysis.low);
  box.add(analysis.high);
  context.viewport.camera = fitted(context.viewport.camera, context.viewport.view.viewport, box, 0.06);
}

void drawSequenceScene(ViewportContext& context, ViewportGpu& gpu, const Rect& picture) {
  const app::SequenceSession& session = *context.open.sequence();
  uploadFrame(session, gpu);
  const SceneStyle style = sequenceStyleOf(context, gpu);
  const Overlay overlay = context.ui.overlays.skeleton ? drawBones(contentOf(session.document()),
                                                                   app::shownFrame(session), style.palette)
                                                       : Overlay{};
  const FrameState frame = restOf(*gpu.uploaded);
  drawPicture(context, gpu, gpu.picture, {frame, {}, overlay, style});
  showPicture(gpu.picture, picture);
  drawLegend(context, *gpu.sequence.picture);
  drawViewCube(context);
}

} // namespace stretch::ui
