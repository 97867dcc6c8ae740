#include "ui/viewport/viewport_pane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

#include "app/commands/table/frames.h"
#include "app/commands/table/moments.h"
#include "app/commands/table/selection.h"
#include "core/base/hash.h"
#include "ui/panels/body/weight_view.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/panels.h"
#include "ui/viewport/sequence_viewport.h"
#include "ui/viewport/viewport_labels.h"
#include "ui/viewport/viewport_messages.h"
#include "ui/viewport/viewport_mouse.h"
#include "ui/viewport/viewport_scene.h"
#include "ui/viewport/welcome.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

namespace {

void addFrame(Hash& key, const FrameState& frame) {
  key.mix(std::span(frame.worlds));
  key.mix(std::span(frame.stretch));
  for (const std::vector<float>& weights : frame.pose.weights) {
    key.mix(std::span(weights));
  }
}

void addOverlay(Hash& key, const Overlay& overlay) {
  for (const Polyline& line : overlay.lines) {
    for (const LinePoint& point : line.points) {
      key.mix(point.world);
      key.mix(point.color);
      key.mix(point.widthPoints);
    }
    key.mix(std::array{line.dashPoints, line.gapPoints});
    key.mix(line.depth);
    key.mix(line.outlined);
  }
  for (const Marker& marker : overlay.markers) {
    key.mix(marker.world);
    key.mix(marker.shape);
    key.mix(std::array{marker.radiusPoints, marker.edgePoints});
    key.mix(marker.turnRadians);
    key.mix(marker.depth);
    key.mix(marker.fill);
    key.mix(marker.edge);
  }
  for (const Arrow& arrow : overlay.arrows) {
    key.mix(arrow.from);
    key.mix(arrow.to);
    key.mix(arrow.color);
    key.mix(std::array{arrow.widthPoints, arrow.headPoints});
  }
}

std::uint64_t keyOf(const View& view, const ViewportPicture& picture, const ViewportGpu& gpu,
                    ThemeKind theme) {
  Hash key;
  key.mix(gpu.uploaded.get());
  key.mix(gpu.sequence.shapes);
  key.mix(theme);
  key.mix(view.view);
  key.mix(view.projection);
  key.mix(view.viewport);
  addFrame(key, picture.frame);
  for (const Ghost& ghost : picture.ghosts) {
    addFrame(key, ghost.frame);
    key.mix(ghost.tint);
  }
  addOverlay(key, picture.overlay);
  key.mix(picture.style.shading);
  key.mix(picture.style.normals);
  key.mix(picture.style.newStretchTurns);
  key.mix(picture.style.wireframe);
  key.mix(picture.style.mesh);
  key.mix(picture.style.floor);
  key.mix(std::array{picture.style.measures.floorHeight, picture.style.measures.characterHeight});
  const Quality& quality = picture.style.quality;
  key.mix(std::array{quality.samples, quality.floorShadowPixels, quality.floorShadowBlurs,
                     quality.selfShadowPixels, quality.thinned ? 1 : 0});
  if (picture.style.backdrop) {
    const Backdrop& backdrop = *picture.style.backdrop;
    const Result<std::shared_ptr<const Image>> image = backdrop.image();
    key.mix(image ? image->get() : nullptr);
    key.mix(Vec3(backdrop.across, backdrop.height, backdrop.opacity));
  }
  key.mix(std::span(picture.style.highlight));
  key.mix(std::span(picture.style.stretchRatio));
  return key.value();
}

void uploadScene(ViewportContext& context, ViewportGpu& gpu) {
  const app::Document& document = context.open.character()->document();
  if (gpu.uploaded == document.scene) {
    return;
  }
  gpu.renderer.setScene(*document.scene);
  gpu.uploaded = document.scene;
  gpu.bounds.emplace(*document.scene);
  gpu.measures = measuresOf(*document.scene, *gpu.bounds);
}

/// The place of the picture that is worked on: the right half while the original stands beside it.
Rect workBox(const Rect& picture, bool sideBySide) {
  return sideBySide ? Rect{{std::floor(picture.centre().x) + 1.0F, picture.min.y}, picture.max} : picture;
}

void drawContent(ViewportContext& context, ViewportGpu& gpu, DrawnPicture& drawn, PictureContent content) {
  content.style.quality = qualityOf(gpu.governor.level());
  content.style.newStretchTurns = context.ui.savedForm.form == app::StretchForm::scale;
  const Overlay overlay = overlayOf(*gpu.uploaded, context.viewport.view, content);
  drawPicture(context, gpu, drawn, {content.frame, content.ghosts, overlay, content.style});
}

void drawScene(ViewportContext& context, ViewportGpu& gpu, const Rect& picture) {
  app::Session& session = *context.open.character();
  const ViewportState& viewport = context.viewport;
  const ViewportOverlays& overlays = context.ui.overlays;
  const Palette palette = paletteOf(context.theme.kind);
  PictureContent content = workPicture(session, viewport, overlays, palette, gpu.measures);
  const FrameState pose = content.frame;
  drawContent(context, gpu, gpu.picture, std::move(content));
  showPicture(gpu.picture, viewport.box);
  if (overlays.sideBySide) {
    const Rect left{picture.min, {viewport.box.min.x - 2.0F, picture.max.y}};
    drawContent(context, gpu, gpu.originalPicture,
                originalPicture(session, viewport, overlays, palette, gpu.measures));
    showPicture(gpu.originalPicture, left);
  }
  drawViewportLabels(context, pose);
}

/// Puts the file's camera to where it stands at the playhead; one that is gone is looked through no longer.
void lookThrough(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  app::Session* const session = context.open.character();
  const SceneCamera* const camera =
      session != nullptr ? cameraNamed(*session->document().scene, viewport.look.name) : nullptr;
  viewport.look.through =
      camera != nullptr ? throughCamera(session->document(), *camera, session->shownAt(session->view().frame))
                        : std::nullopt;
  if (!viewport.look.through) {
    viewport.look.name.clear();
  }
}

void updateView(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  Viewport size;
  size.widthPixels = std::max(1.0, viewport.pixelsPerUnit * static_cast<double>(viewport.box.width()));
  size.heightPixels = std::max(1.0, viewport.pixelsPerUnit * static_cast<double>(viewport.box.height()));
  size.pixelsPerPoint = viewport.pixelsPerUnit * static_cast<double>(context.theme.scale);
  lookThrough(context);
  viewport.view =
      viewport.look.through ? viewThrough(*viewport.look.through, size) : makeView(viewport.camera, size);
  if (context.open.character() != nullptr) {
    context.open.character()->view().cameraAxes =
        Mat3(viewRight(viewport.view), viewUp(viewport.view), -viewport.view.forward);
    context.open.character()->view().camera = placeOf(viewport.view);
  }
}

/// Whether the mouse is over the picture, and whether a button that was pressed there is still down.
struct MouseOver {
  bool hovered = false;
  bool held = false;
};

/// A dialog takes the mouse of all that is not in it. Where it is about the picture, the mouse is free there.
MouseOver mouseBesideDialog(const ViewportState& viewport) {
  const bool free =
      !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left) ||
                    ImGui::IsMouseDown(ImGuiMouseButton_Middle) || ImGui::IsMouseDown(ImGuiMouseButton_Right);
  constexpr int dialogAlone = 1; // a list of it that is open takes the press that closes it
  return {free && !ImGui::IsAnyItemActive() &&
              ImGui::GetCurrentContext()->OpenPopupStack.Size == dialogAlone &&
              ImGui::IsMouseHoveringRect(viewport.box.min, viewport.box.max, false),
          down && viewport.gesture != ViewportGesture::none};
}

void drawPictureArea(ViewportContext& context, ViewportGpu& gpu) {
  ViewportState& viewport = context.viewport;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Rect picture{corner, {corner.x + std::max(room.x, 8.0F), corner.y + std::max(room.y, 8.0F)}};
  viewport.box = workBox(picture, context.ui.overlays.sideBySide && context.open.character() != nullptr);
  ImGui::InvisibleButton("viewport", {picture.width(), picture.height()},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  context.items.add("viewport", viewport.box.min, viewport.box.max);
  const auto [hovered, held] =
      isSeenBesideDialog(context)
          ? mouseBesideDialog(viewport)
          : MouseOver{ImGui::IsItemHovered() && !pressMessage(context), ImGui::IsItemActive()};
  updateView(context);
  if (context.open.sequence() != nullptr) {
    const bool all = std::exchange(viewport.framePending, false);
    const bool selected = std::exchange(viewport.frameSelectionPending, false);
    if (all || selected) {
      frameSequence(context);
    }
    handleViewportMouse(context, hovered, held);
    updateView(context);
    drawSequenceScene(context, gpu, picture);
    return;
  }
  if (context.open.character() == nullptr) {
    drawWelcome(context, gpu.welcome, picture);
    return;
  }
  uploadScene(context, gpu);
  if (viewport.framePending || viewport.frameSelectionPending) {
    frameCamera(context, gpu, viewport.framePending);
    viewport.framePending = false;
    viewport.frameSelectionPending = false;
  }
  const auto updateShown = [&] {
    updateShownTrails(*context.open.character(), viewport.shown);
    updateTangents(*context.open.character(), context.ui.overlays, viewport.view, viewport.tangents);
    viewport.controllers = shownControllers(*context.open.character(), context.ui.overlays);
    viewport.weightsOf = weightsShownOf(context.ui, *context.open.character());
  };
  updateShown();
  handleViewportMouse(context, hovered, held);
  updateView(context);
  updateShown();
  viewport.tipFrame = tipGhostFrame(context);
  const std::optional<rig::Moment> moment = std::exchange(context.ui.time.hoveredMoment, std::nullopt);
  viewport.shown.momentPath =
      moment ? app::pathOfMoment(*context.open.character(), *moment) : std::vector<Vec3>{};
  tellTipOutOfView(context);
  drawScene(context, gpu, picture);
}

// A heavy character that moves is drawn with few triangles, until the picture has been the same for as long
// as the whole one takes.
bool waitsForRest(const ViewportGpu& gpu, DrawnPicture& drawn, std::uint64_t key) {
  constexpr double restSeconds = 0.25;
  const double now = ImGui::GetTime();
  if (key != drawn.wantedKey) {
    drawn.wantedKey = key;
    drawn.wantedSinceSeconds = now;
  }
  const double whole = gpu.renderer.secondsUnthinned();
  return whole > 0.0 && key != drawn.contentKey &&
         now - drawn.wantedSinceSeconds < std::max(restSeconds, whole);
}

} // namespace

void drawPicture(ViewportContext& context, ViewportGpu& gpu, DrawnPicture& drawn,
                 const ViewportPicture& wanted) {
  SceneStyle style = wanted.style;
  const ViewportPicture picture{wanted.frame, wanted.ghosts, wanted.overlay, style};
  const auto currentKey = [&] { return keyOf(context.viewport.view, picture, gpu, context.theme.kind); };
  std::uint64_t key = currentKey();
  if (waitsForRest(gpu, drawn, key)) {
    style.quality.thinned = true;
    key = currentKey();
  }
  if (!gpu.paints || (key == drawn.contentKey && drawn.target.textureId() != 0)) {
    return;
  }
  const Status done = gpu.renderer.draw(drawn.target, context.viewport.view, picture);
  drawn.contentKey = done ? key : 0;
  tellProblem(context, done);
  gpu.drewPicture = true;
}

void showPicture(const DrawnPicture& drawn, const Rect& box) {
  // The target's rows run from the bottom.
  ImGui::GetWindowDrawList()->AddImage(textureOf(drawn.target.textureId()), box.min, box.max, {0.0F, 1.0F},
                                       {1.0F, 0.0F});
}

Result<std::unique_ptr<ViewportGpu>> createViewportGpu() {
  Result<ViewportRenderer> renderer = ViewportRenderer::create();
  if (!renderer) {
    return renderer.error();
  }
  return std::make_unique<ViewportGpu>(ViewportGpu{std::move(renderer).value(),
                                                   {},
                                                   {},
                                                   QualityGovernor(startingQualityLevel()),
                                                   {},
                                                   {},
                                                   {},
                                                   {},
                                                   {},
                                                   false,
                                                   true});
}

void drawViewportPane(ViewportContext& context, ViewportGpu& gpu, const Rect& rect, double pixelsPerUnit) {
  context.viewport.pixelsPerUnit = pixelsPerUnit;
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize({rect.width(), rect.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                 ImGuiWindowFlags_NoScrollWithMouse;
  if (ImGui::Begin("viewport-pane", nullptr, flags)) {
    drawPictureArea(context, gpu);
    showMessages(context);
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void frameCamera(ViewportContext& context, ViewportGpu& gpu, bool everything) {
  if (context.open.character() == nullptr) {
    return;
  }
  app::Session& session = *context.open.character();
  updateShownTrails(session, context.viewport.shown);
  Box box = everything ? Box{} : selectionBox(session, context.viewport.shown);
  if (box.empty() && gpu.bounds) {
    box = gpu.bounds->boxOf(*session.document().scene, session.shownAt(session.view().frame));
    box.add(everything ? selectionBox(session, context.viewport.shown) : Box{});
  }
  lookFreely(context.viewport.look, context.viewport.camera);
  context.viewport.camera = fitted(context.viewport.camera, context.viewport.view.viewport, box, 0.1);
}

} // namespace stretch::ui
