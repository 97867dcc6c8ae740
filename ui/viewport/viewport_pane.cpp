#include "ui/viewport/viewport_pane.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "ui/panels/panels.h"
#include "ui/viewport/content_key.h"
#include "ui/viewport/sequence_viewport.h"
#include "ui/viewport/viewport_labels.h"
#include "ui/viewport/viewport_mouse.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

void addFrame(ContentKey& key, const FrameState& frame) {
  key.addAll(frame.worlds);
  key.addAll(frame.stretch);
  for (const std::vector<float>& weights : frame.pose.weights) {
    key.addAll(weights);
  }
}

void addOverlay(ContentKey& key, const Overlay& overlay) {
  for (const Polyline& line : overlay.lines) {
    for (const LinePoint& point : line.points) {
      key.add(point.world);
      key.add(point.color);
      key.add(point.widthPoints);
    }
  }
  for (const Marker& marker : overlay.markers) {
    key.add(marker.world);
    key.add(marker.radiusPoints);
    key.add(marker.fill);
    key.add(marker.edge);
  }
  for (const Arrow& arrow : overlay.arrows) {
    key.add(arrow.from);
    key.add(arrow.to);
    key.add(arrow.color);
    key.add(arrow.widthPoints);
  }
}

std::uint64_t keyOf(const View& view, const ViewportPicture& picture, const Scene* scene, ThemeKind theme) {
  ContentKey key;
  key.add(scene);
  key.add(theme);
  key.add(view.view);
  key.add(view.projection);
  key.add(view.viewport);
  addFrame(key, picture.frame);
  for (const Ghost& ghost : picture.ghosts) {
    addFrame(key, ghost.frame);
    key.add(ghost.tint);
  }
  addOverlay(key, picture.overlay);
  key.add(picture.style.shading);
  key.add(picture.style.wireframe);
  key.add(picture.style.floor);
  key.add(picture.style.quality);
  key.addAll(picture.style.highlight);
  return key.value();
}

SceneStyle styleOf(const Shell& shell, const ViewportGpu& gpu) {
  SceneStyle style;
  style.palette = paletteOf(shell.theme.kind);
  style.quality = qualityOf(gpu.governor.level());
  style.shading = shell.ui.overlays.heatMap ? SurfaceShading::stretchHeat : SurfaceShading::material;
  style.wireframe = shell.ui.overlays.wire;
  style.floor = shell.ui.overlays.grid;
  style.floorHeight = gpu.floorHeight;
  style.characterHeight = shell.open.character()->document().biped.height;
  style.highlight = highlightOf(*shell.open.character(), shell.viewport.hoveredLimb);
  return style;
}

void uploadScene(Shell& shell, ViewportGpu& gpu) {
  const app::Document& document = shell.open.character()->document();
  if (gpu.uploaded == document.scene) {
    return;
  }
  gpu.renderer.setScene(*document.scene);
  gpu.uploaded = document.scene;
  gpu.bounds.emplace(*document.scene);
  gpu.floorHeight =
      floorHeightOf(gpu.bounds->boxOf(*document.scene, shell.open.character()->originalAt(0.0)));
}

/// The place of the picture that is worked on: the right half while the original stands beside it.
Rect workBox(const Rect& picture, bool sideBySide) {
  return sideBySide ? Rect{{std::floor(picture.centre().x) + 1.0F, picture.min.y}, picture.max} : picture;
}

void drawOriginalBeside(Shell& shell, ViewportGpu& gpu, const Rect& picture) {
  ViewportState& viewport = shell.viewport;
  const Rect left{picture.min, {viewport.box.min.x - 2.0F, picture.max.y}};
  const Overlay nothing;
  drawPicture(shell, gpu, gpu.originalPicture,
              {shell.open.character()->originalAt(shell.open.character()->view().frame),
               {},
               nothing,
               styleOf(shell, gpu)});
  showPicture(gpu.originalPicture, left);
}

void drawScene(Shell& shell, PanelContext& context, ViewportGpu& gpu, const Rect& picture) {
  app::Session& session = *shell.open.character();
  const double at = session.view().frame;
  const FrameState& frame = session.view().showOriginal ? session.originalAt(at) : session.frameAt(at);
  const SceneStyle style = styleOf(shell, gpu);
  const std::vector<Ghost> ghosts = ghostsOf(session, shell.ui.overlays);
  const Overlay overlay = overlayOf(session, shell.ui, shell.viewport, frame, style.palette);
  drawPicture(shell, gpu, gpu.picture, {frame, ghosts, overlay, style});
  showPicture(gpu.picture, shell.viewport.box);
  if (shell.ui.overlays.sideBySide) {
    drawOriginalBeside(shell, gpu, picture);
  }
  drawViewportLabels(shell, context, frame);
}

void updateView(Shell& shell) {
  ViewportState& viewport = shell.viewport;
  Viewport size;
  size.widthPixels = std::max(1.0, viewport.pixelsPerUnit * static_cast<double>(viewport.box.width()));
  size.heightPixels = std::max(1.0, viewport.pixelsPerUnit * static_cast<double>(viewport.box.height()));
  size.pixelsPerPoint = viewport.pixelsPerUnit * static_cast<double>(shell.theme.scale);
  viewport.view = makeView(viewport.camera, size);
  if (shell.open.character() != nullptr) {
    shell.open.character()->view().cameraAxes =
        Mat3(viewRight(viewport.view), viewUp(viewport.view), -viewport.view.forward);
  }
}

void drawPictureArea(Shell& shell, PanelContext& context, ViewportGpu& gpu) {
  ViewportState& viewport = shell.viewport;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Rect picture{corner, {corner.x + std::max(room.x, 8.0F), corner.y + std::max(room.y, 8.0F)}};
  viewport.box = workBox(picture, shell.ui.overlays.sideBySide && shell.open.character() != nullptr);
  ImGui::InvisibleButton("viewport", {picture.width(), picture.height()},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  context.items.add("viewport", viewport.box.min, viewport.box.max);
  const bool hovered = ImGui::IsItemHovered();
  const bool held = ImGui::IsItemActive();
  updateView(shell);
  if (shell.open.sequence() != nullptr) {
    if (std::exchange(viewport.framePending, false) | std::exchange(viewport.frameSelectionPending, false)) {
      frameSequence(shell);
    }
    handleViewportMouse(shell, hovered, held);
    updateView(shell);
    drawSequenceScene(shell, context, gpu, picture);
    return;
  }
  if (shell.open.character() == nullptr) {
    drawEmptyViewport(shell, context, picture);
    return;
  }
  uploadScene(shell, gpu);
  if (viewport.framePending || viewport.frameSelectionPending) {
    frameCamera(shell, gpu, viewport.framePending);
    viewport.framePending = false;
    viewport.frameSelectionPending = false;
  }
  updateShownTrails(*shell.open.character(), viewport.shown);
  handleViewportMouse(shell, hovered, held);
  updateView(shell);
  updateShownTrails(*shell.open.character(), viewport.shown);
  drawScene(shell, context, gpu, picture);
}

} // namespace

Palette paletteOf(ThemeKind theme) {
  switch (theme) {
  case ThemeKind::light:
    return lightPalette();
  case ThemeKind::highContrast:
    return highContrastPalette();
  case ThemeKind::dark:
    break;
  }
  return darkPalette();
}

void drawPicture(Shell& shell, ViewportGpu& gpu, DrawnPicture& drawn, const ViewportPicture& picture) {
  const std::uint64_t key = keyOf(shell.viewport.view, picture, gpu.uploaded.get(), shell.theme.kind);
  if (key == drawn.contentKey && drawn.target.textureId() != 0) {
    return;
  }
  const Status done = gpu.renderer.draw(drawn.target, shell.viewport.view, picture);
  drawn.contentKey = done ? key : 0;
  tellProblem(shell, done);
  gpu.drewPicture = true;
}

void showPicture(const DrawnPicture& drawn, const Rect& box) {
  // The target's rows run from the bottom.
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(drawn.target.textureId()));
  ImGui::GetWindowDrawList()->AddImage(texture, box.min, box.max, {0.0F, 1.0F}, {1.0F, 0.0F});
}

Result<std::unique_ptr<ViewportGpu>> createViewportGpu() {
  Result<ViewportRenderer> renderer = ViewportRenderer::create();
  if (!renderer) {
    return renderer.error();
  }
  return std::unique_ptr<ViewportGpu>(new ViewportGpu{
      std::move(renderer).value(), {}, {}, QualityGovernor(startingQualityLevel()), {}, {}, 0.0, 0, false});
}

void drawViewportPane(Shell& shell, PanelContext& context, ViewportGpu& gpu, const Rect& rect,
                      double pixelsPerUnit) {
  shell.viewport.pixelsPerUnit = pixelsPerUnit;
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize({rect.width(), rect.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                 ImGuiWindowFlags_NoScrollWithMouse;
  if (ImGui::Begin("viewport-pane", nullptr, flags)) {
    drawPictureArea(shell, context, gpu);
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void frameCamera(Shell& shell, ViewportGpu& gpu, bool everything) {
  if (shell.open.character() == nullptr) {
    return;
  }
  app::Session& session = *shell.open.character();
  updateShownTrails(session, shell.viewport.shown);
  Box box = everything ? Box{} : selectionBox(session, shell.viewport.shown);
  if (box.empty() && gpu.bounds) {
    box = gpu.bounds->boxOf(*session.document().scene, session.frameAt(session.view().frame));
    box.add(everything ? selectionBox(session, shell.viewport.shown) : Box{});
  }
  shell.viewport.camera = fitted(shell.viewport.camera, shell.viewport.view.viewport, box, 0.1);
}

} // namespace stretch::ui
