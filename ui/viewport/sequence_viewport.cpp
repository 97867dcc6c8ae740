#include "ui/viewport/sequence_viewport.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "core/base/hash.h"
#include "ui/render/sequence_scene.h"
#include "ui/render/skeleton_drawing.h"
#include "ui/render/value_colors.h"
#include "ui/viewport/viewport_scene.h"
#include "ui/widgets/color_legend.h"

namespace stretch::ui {

namespace {

using app::SequenceColours;

double diagonalOf(const app::SequenceDocument& document) {
  return boxDiagonal(document.mesh->frame(0));
}

bool showsSkinned(const app::SequenceSession& session) {
  return session.document().result != nullptr && session.view().showSkinned;
}

/// The end of the error's scale: three times the root of the mean squared error, so that one outlier does not
/// grey everything else.
double largestShownError(const app::SequenceDocument& document) {
  return 0.03 * document.result->compressed.metrics.rmsePercent * diagonalOf(document);
}

double largestThickness(const app::SequenceDocument& document) {
  const std::vector<double>& diameters = document.analysis->vertexDiameters;
  return diameters.empty() ? 0.0 : *std::max_element(diameters.begin(), diameters.end());
}

std::vector<glm::vec4> thicknessColors(const app::SequenceDocument& document) {
  const std::vector<double>& diameters = document.analysis->vertexDiameters;
  return valueColors(ValueScale::thickness, std::vector<float>(diameters.begin(), diameters.end()),
                     largestThickness(document));
}

std::vector<glm::vec4> errorColors(const app::SequenceDocument& document, std::size_t frame,
                                   const std::vector<glm::vec3>& skinned) {
  const std::span<const glm::vec3> original = document.mesh->frame(frame);
  std::vector<float> errors(skinned.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    errors[v] = glm::distance(skinned[v], original[v]);
  }
  return valueColors(ValueScale::error, errors, largestShownError(document));
}

std::vector<glm::vec4> colorsOf(const app::SequenceSession& session, std::size_t frame, ImU32 plain,
                                const std::vector<glm::vec3>& skinned) {
  if (session.view().colours == SequenceColours::thickness) {
    return thicknessColors(session.document());
  }
  if (session.view().colours == SequenceColours::error && !skinned.empty()) {
    return errorColors(session.document(), frame, skinned);
  }
  return {linearLight(toColour(plain))};
}

/// The original, and the result over it. Two surfaces that carry the same values would only hide each other:
/// with values as colours the result is shown where there is one.
Scene sceneOf(const app::SequenceSession& session) {
  const MeshSequence& mesh = *session.document().mesh;
  const std::size_t frame = app::shownFrame(session);
  std::vector<glm::vec3> skinned;
  if (session.document().result != nullptr) {
    skinned.resize(mesh.vertexCount);
    skinning::skinFrame(session.document().result->compressed.skinned, frame, skinned);
  }
  const std::span<const glm::vec3> original(mesh.frame(frame));
  const bool plain = session.view().colours == SequenceColours::plain;
  std::vector<PlainMesh> meshes;
  if (session.view().showOriginal && (plain || !showsSkinned(session))) {
    meshes.push_back({original, mesh.triangles, colorsOf(session, frame, originalMeshColour, skinned)});
  }
  if (showsSkinned(session)) {
    meshes.push_back({skinned, mesh.triangles, colorsOf(session, frame, skinnedMeshColour, skinned)});
  }
  return sceneOfMeshes(meshes);
}

/// What the scene was made from: it is made and uploaded again when this changes.
std::uint64_t sceneKey(const app::SequenceSession& session) {
  Hash key;
  key.mix(session.document().mesh.get());
  key.mix(session.document().result.get());
  key.mix(app::shownFrame(session));
  key.mix(session.view().showOriginal);
  key.mix(session.view().showSkinned);
  key.mix(session.view().colours);
  return key.value();
}

void uploadFrame(const app::SequenceSession& session, ViewportGpu& gpu) {
  const std::uint64_t key = sceneKey(session);
  if (gpu.uploaded != nullptr && gpu.sequenceKey == key) {
    return;
  }
  gpu.uploaded = std::make_shared<const Scene>(sceneOf(session));
  gpu.renderer.setScene(*gpu.uploaded);
  gpu.sequenceKey = key;
}

SceneStyle sequenceStyleOf(const ViewportContext& context, const ViewportGpu& gpu) {
  const app::SequenceDocument& document = context.open.sequence()->document();
  SceneStyle style;
  style.palette = paletteOf(context.theme.kind);
  style.quality = qualityOf(gpu.governor.level());
  style.wireframe = context.ui.overlays.wire;
  style.floor = context.ui.overlays.grid;
  style.measures = {document.analysis->low.y, 0.4 * diagonalOf(document)};
  return style;
}

Marker jointMarker(const Vec3& place, const SkeletonStyle& style) {
  Marker joint;
  joint.world = place;
  joint.radiusPoints = style.jointPoints;
  joint.fill = style.bone;
  joint.depth = OverlayDepth::onTop;
  return joint;
}

Overlay bonesOf(const app::SequenceSession& session, const Palette& palette) {
  const SkeletonStyle style = skeletonStyle(palette);
  Overlay overlay;
  for (const app::ShownBone& shown : app::bonesAt(session.document(), app::shownFrame(session))) {
    Polyline bone;
    bone.points = {{shown.start, style.bone, style.widthPoints},
                   {shown.end, style.bone, 0.5F * style.widthPoints}};
    bone.depth = OverlayDepth::onTop;
    bone.outlined = true;
    overlay.lines.push_back(bone);
    overlay.markers.push_back(jointMarker(shown.start, style));
    if (shown.isLast) {
      overlay.markers.push_back(jointMarker(shown.end, style));
    }
  }
  return overlay;
}

std::optional<ColorLegend> legendOf(const app::SequenceSession& session) {
  const app::SequenceDocument& document = session.document();
  const auto colours = [](ValueScale scale) {
    return [scale](double share) {
      const std::uint32_t hex = valueColorHex(scale, share);
      return IM_COL32((hex >> 16U) & 0xFFU, (hex >> 8U) & 0xFFU, hex & 0xFFU, 255);
    };
  };
  if (session.view().colours == SequenceColours::error && document.result != nullptr) {
    const double largest = largestShownError(document);
    return ColorLegend{"Distance to the original", "0", fmt::format("{:.3g} units and more", largest),
                       fmt::format("{:.3g} % of the diagonal", 100.0 * largest / diagonalOf(document)),
                       colours(ValueScale::error)};
  }
  if (session.view().colours == SequenceColours::thickness) {
    return ColorLegend{"Shape diameter", "0", fmt::format("{:.3g} units", largestThickness(document)),
                       "of the first frame", colours(ValueScale::thickness)};
  }
  return std::nullopt;
}

void drawLegend(ViewportContext& context) {
  const auto legend = legendOf(*context.open.sequence());
  if (!legend) {
    return;
  }
  const Theme& theme = context.theme;
  const Rect& box = context.viewport.box;
  const ImVec2 size = legendSize(theme, *legend);
  drawColorLegend(WidgetContext{theme, context.items}, "viewport/legend",
                  {box.min.x + theme.px(12.0F), box.max.y - theme.px(12.0F) - size.y}, *legend);
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
  uploadFrame(*context.open.sequence(), gpu);
  const SceneStyle style = sequenceStyleOf(context, gpu);
  const Overlay overlay =
      context.ui.overlays.skeleton ? bonesOf(*context.open.sequence(), style.palette) : Overlay{};
  const FrameState frame = restOf(*gpu.uploaded);
  drawPicture(context, gpu, gpu.picture, {frame, {}, overlay, style});
  showPicture(gpu.picture, picture);
  drawLegend(context);
}

} // namespace stretch::ui
