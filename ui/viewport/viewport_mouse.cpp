#include "ui/viewport/viewport_mouse.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/commands/table/selection.h"
#include "core/anim/frames.h"
#include "ui/panels/body/weight_view.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/render/picking/picking.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/viewport/controller_mouse.h"
#include "ui/viewport/cube_marker.h"

namespace stretch::ui {

namespace {

constexpr double boxSelectStartPoints = 4.0;

std::vector<Vec3> centresOf(const ShownTrail& trail) {
  std::vector<Vec3> centres;
  for (const app::PlacedSphere& sphere : trail.spheres) {
    centres.push_back(sphere.positionWorld);
  }
  return centres;
}

/// Whether the mouse has hardly left where the button went down: a click, and no drag.
bool isClick(const ViewportState& viewport) {
  const double far = boxSelectStartPoints * viewport.view.viewport.pixelsPerPoint;
  return glm::distance(viewport.mousePixels, viewport.pressPixels) <= far;
}

/// The navigation that a press begins; none when it is for editing.
ViewportGesture navigationGesture(NavigationStyle style, const ImGuiIO& io) {
  const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  const bool middle = ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
  const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (style == NavigationStyle::blender && middle) {
    return io.KeyShift ? ViewportGesture::pan : io.KeyCtrl ? ViewportGesture::zoom : ViewportGesture::orbit;
  }
  if (middle) {
    return ViewportGesture::pan;
  }
  if (io.KeyAlt && left) {
    return ViewportGesture::orbit;
  }
  return io.KeyAlt && right ? ViewportGesture::zoom : ViewportGesture::none;
}

void navigate(ViewportState& viewport) {
  const Vec2 moved = viewport.mousePixels - viewport.lastPixels;
  const Viewport& size = viewport.view.viewport;
  if (moved != Vec2(0.0) && viewport.gesture <= ViewportGesture::zoom &&
      viewport.gesture != ViewportGesture::none) {
    lookFreely(viewport.look, viewport.camera);
  }
  switch (viewport.gesture) {
  case ViewportGesture::orbit:
    viewport.camera = orbited(viewport.camera, size, moved);
    break;
  case ViewportGesture::pan:
    viewport.camera = panned(viewport.camera, size, moved);
    break;
  case ViewportGesture::zoom:
    viewport.camera =
        zoomed(viewport.camera, size, std::exp(-0.006 * (moved.x - moved.y) / size.pixelsPerPoint),
               viewport.pressPixels);
    break;
  default:
    break;
  }
}

void selectSphere(app::Session& session, double frame, bool add) {
  std::vector<double>& selected = session.view().selection.editTrails().spheres;
  const auto found =
      std::find_if(selected.begin(), selected.end(), [&](double other) { return sameFrame(other, frame); });
  if (add && found != selected.end()) {
    selected.erase(found);
  } else if (add) {
    selected.push_back(frame);
  } else if (found == selected.end()) {
    selected = {frame};
  } else {
    // Pressing one of several keeps them all, so that they can be dragged together; it becomes the one with
    // the handles.
    selected.erase(found);
    selected.push_back(frame);
  }
}

void grabFromPress(ViewportContext& context, const GrabStart& start) {
  tellProblem(context, startGrab(*context.open.character(), context.tool, start));
}

/// The selected trail where it is seen; else null.
const ShownTrail* seenTrail(const ViewportContext& context) {
  const int selected = context.open.character()->view().selection.trail();
  return isSeen(*context.open.character(), selected, context.ui.overlays)
             ? findShown(context.viewport.shown, selected)
             : nullptr;
}

/// The frame at which the selected trail is drawn nearest to the mouse; a whole one where frames snap.
std::optional<double> frameUnderMouse(const ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  const ShownTrail* const trail = seenTrail(context);
  if (trail == nullptr) {
    return std::nullopt;
  }
  const auto& points = trail->exaggerated ? trail->drawn.exaggerated : trail->drawn.original;
  const auto hit = pickPolyline(viewport.view, points, viewport.mousePixels);
  if (!hit) {
    return std::nullopt;
  }
  const double from = trail->drawn.frames[hit->segment];
  const double frame = from + hit->fraction * (trail->drawn.frames[hit->segment + 1] - from);
  return context.ui.time.timeline.snapToFrames ? std::round(frame) : frame;
}

void addSphereUnderMouse(ViewportContext& context) {
  if (const std::optional<double> frame = frameUnderMouse(context)) {
    tellProblem(context, app::addSphere(*context.open.character(), *frame));
  }
}

/// A press on the view cube turns the view by its drag, or else looks from the part that was pressed.
bool pressCube(ViewportState& viewport) {
  const bool pressed = viewport.look.hoveredPart && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  viewport.gesture = pressed ? ViewportGesture::pressCube : viewport.gesture;
  return pressed;
}

void dragCube(ViewportState& viewport) {
  if (viewport.gesture == ViewportGesture::pressCube && !isClick(viewport)) {
    viewport.gesture = ViewportGesture::orbit;
  }
}

void releaseCube(ViewportState& viewport) {
  if (viewport.gesture == ViewportGesture::pressCube && viewport.look.hoveredPart) {
    lookFreely(viewport.look, viewport.camera);
    viewport.camera = lookingAt(viewport.camera, *viewport.look.hoveredPart, viewport.look.facingYawRadians);
  }
}

/// A press with the left button: tangent handle, axis handle, sphere, trail, limb, or the beginning of a box.
void pressLeft(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  app::Session& session = *context.open.character();
  const bool add = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
  if (pressController(context, add)) {
    return;
  }
  if (viewport.hoveredTangent) {
    const ShownTangent& held = viewport.tangents.handles[*viewport.hoveredTangent];
    GrabStart start;
    start.startPixels = viewport.pressPixels;
    start.byDrag = true;
    start.falloffRadius = viewport.falloffRadius;
    tellProblem(context, startTangentGrab(session, context.tool, held.handle, held.tipWorld, start));
  } else if (viewport.hoveredAxis) {
    grabFromPress(context, {viewport.pressPixels, std::nullopt, static_cast<int>(*viewport.hoveredAxis), true,
                            viewport.falloffRadius});
  } else if (viewport.hoveredSphere) {
    viewport.gesture = ViewportGesture::pressSphere;
    viewport.pressedFrame = viewport.hoveredSphere;
    selectSphere(session, *viewport.hoveredSphere, add);
  } else if (viewport.hoveredTrail != 0) {
    app::selectTrail(session, viewport.hoveredTrail);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      addSphereUnderMouse(context);
    }
  } else if (!viewport.hoveredLimb.empty()) {
    app::selectLimb(session, viewport.hoveredLimb, add);
    viewport.gesture = viewport.hoveredEnd && !add ? ViewportGesture::pressEnd : ViewportGesture::none;
  } else {
    viewport.gesture = ViewportGesture::boxSelect;
  }
  if (viewport.hoveredJoint.exists()) {
    showWeightsOf(context.ui.body.weights, session, viewport.hoveredJoint);
  }
}

void beginGesture(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  viewport.pressPixels = viewport.mousePixels;
  viewport.lastPixels = viewport.mousePixels;
  viewport.gesture = navigationGesture(context.ui.navigation, ImGui::GetIO());
  if (viewport.gesture != ViewportGesture::none || (!isRunning(context.tool) && pressCube(viewport))) {
    return;
  }
  const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (isRunning(context.tool) && (left || right)) {
    finishTool(*context.open.character(), context.tool, left);
  } else if (left) {
    pressLeft(context);
  } else if (right) {
    viewport.gesture = ViewportGesture::pressMenu;
  }
}

/// A right click opens the menu of what lies under the mouse, on a handle of what it belongs to; what is
/// selected with it stays selected.
void clickRight(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  app::Session& session = *context.open.character();
  MenuTarget target = MenuTarget::viewport;
  if (viewport.hoveredHandle && !session.view().selection.controllers().empty()) {
    target = MenuTarget::controller;
  } else if (viewport.hoveredAxis || viewport.hoveredTangent) {
    target = MenuTarget::sphere;
  } else if (!viewport.hoveredController.empty()) {
    if (!app::isControllerSelected(session, viewport.hoveredController)) {
      app::selectController(session, viewport.hoveredController, false);
    }
    target = MenuTarget::controller;
  } else if (viewport.hoveredSphere) {
    selectSphere(session, *viewport.hoveredSphere, false);
    target = MenuTarget::sphere;
  } else if (viewport.hoveredTrail != 0) {
    app::selectTrail(session, viewport.hoveredTrail);
    target = MenuTarget::trail;
  } else if (!viewport.hoveredLimb.empty()) {
    if (!app::isSelected(session, viewport.hoveredLimb)) {
      app::selectLimb(session, viewport.hoveredLimb, false);
    }
    target = MenuTarget::limb;
  }
  askForMenu(context.ui, target);
}

/// A click beside everything lets go: of the spheres, and with none selected of all.
void clickNothing(app::Session& session) {
  app::ViewState& view = session.view();
  app::clearControllers(session);
  if (view.selection.spheres().empty()) {
    view.selection = {};
    session.followSelection();
  }
  view.selection.dropSpheres();
}

void selectInBox(ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  app::Session& session = *context.open.character();
  const Vec2 low = glm::min(viewport.pressPixels, viewport.mousePixels);
  const Vec2 high = glm::max(viewport.pressPixels, viewport.mousePixels);
  const bool add = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
  if (glm::distance(low, high) < boxSelectStartPoints * viewport.view.viewport.pixelsPerPoint) {
    if (!add) {
      clickNothing(session);
    }
    return;
  }
  if (selectControllersInBox(context, low, high, add)) {
    return;
  }
  if (!add) {
    session.view().selection.dropSpheres();
  }
  const ShownTrail* const trail = seenTrail(context);
  if (trail == nullptr) {
    return;
  }
  std::vector<double>& selected = session.view().selection.editTrails().spheres;
  for (const app::PlacedSphere& sphere : trail->spheres) {
    const auto place = projectToPixels(viewport.view, sphere.positionWorld);
    const bool inside = place && place->pixels.x >= low.x && place->pixels.x <= high.x &&
                        place->pixels.y >= low.y && place->pixels.y <= high.y;
    const bool known =
        std::ranges::any_of(selected, [&](double frame) { return sameFrame(frame, sphere.frame); });
    if (inside && !known) {
      selected.push_back(sphere.frame);
    }
  }
}

/// A press that moves becomes a drag: of the spheres, or of a hand, foot or head.
void continueGesture(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  dragCube(viewport);
  navigate(viewport);
  if (isRunning(context.tool) || isClick(viewport)) {
    return;
  }
  app::Session& session = *context.open.character();
  if (dragController(context)) {
    return;
  }
  if (viewport.gesture == ViewportGesture::pressSphere && !session.view().selection.spheres().empty()) {
    grabFromPress(context,
                  {viewport.pressPixels, viewport.pressedFrame, std::nullopt, true, viewport.falloffRadius});
  } else if (viewport.gesture == ViewportGesture::pressEnd) {
    viewport.gesture = ViewportGesture::none;
    tellProblem(context, startLimbGrab(session, context.tool, viewport.hoveredLimb,
                                       {viewport.pressPixels, std::nullopt, std::nullopt, true, 0.0}));
  }
}

void endGesture(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  if (viewport.gesture == ViewportGesture::boxSelect) {
    selectInBox(context);
  }
  releaseCube(viewport);
  if (viewport.gesture == ViewportGesture::pressMenu && isClick(viewport)) {
    clickRight(context);
  }
  viewport.gesture = ViewportGesture::none;
}

/// The mouse for a running tool: it follows without a button under G, with the button held in a drag.
void driveTool(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  auto* const grab = std::get_if<GrabTool>(&context.tool);
  const auto* const controllers = std::get_if<ControllerTool>(&context.tool);
  const bool navigating = viewport.gesture == ViewportGesture::orbit ||
                          viewport.gesture == ViewportGesture::pan ||
                          viewport.gesture == ViewportGesture::zoom;
  if (controllers != nullptr) {
    markHeldHandle(viewport, *controllers);
  }
  if ((grab == nullptr && controllers == nullptr) || navigating) {
    return;
  }
  if (viewport.mousePixels != viewport.lastPixels) {
    tellProblem(context,
                moveToolMouse(*context.open.character(), context.tool, viewport.view, viewport.mousePixels));
  }
  viewport.falloffRadius = grab != nullptr ? grab->falloffRadius : viewport.falloffRadius;
  const bool byDrag = grab != nullptr ? grab->byDrag : controllers->byDrag;
  if (byDrag && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    finishTool(*context.open.character(), context.tool, true);
    viewport.gesture = ViewportGesture::none;
  }
}

void turnWheel(ViewportContext& context, double steps) {
  if (std::holds_alternative<GrabTool>(context.tool)) {
    tellProblem(context, turnFalloff(*context.open.character(), context.tool, steps));
    return;
  }
  ViewportState& viewport = context.viewport;
  lookFreely(viewport.look, viewport.camera);
  viewport.camera =
      zoomed(viewport.camera, viewport.view.viewport, std::pow(0.88, steps), viewport.mousePixels);
}

void hoverSphere(ViewportState& viewport, const ShownTrail& trail) {
  if (const auto hit = pickSphere(viewport.view, centresOf(trail), viewport.mousePixels)) {
    viewport.hoveredSphere = trail.spheres[*hit].frame;
  }
}

void hoverTrails(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  double nearest = 1e300;
  for (const ShownTrail& trail : viewport.shown.trails) {
    if (!isSeen(*context.open.character(), trail.id, context.ui.overlays)) {
      continue;
    }
    const auto& points = trail.exaggerated ? trail.drawn.exaggerated : trail.drawn.original;
    const auto hit = pickPolyline(viewport.view, points, viewport.mousePixels);
    if (hit && hit->distancePixels < nearest) {
      nearest = hit->distancePixels;
      viewport.hoveredTrail = trail.id;
    }
  }
}

void hoverLimbs(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  const LimbUnderMouse found =
      limbUnderMouse(*context.open.character(), viewport.view, viewport.mousePixels, viewport.limbs);
  viewport.hoveredLimb = found.limb;
  viewport.hoveredEnd = found.atEnd;
  viewport.hoveredJoint = found.joint;
}

bool canPick(const ViewportContext& context) {
  return context.open.character() != nullptr && !isSeenBesideDialog(context);
}

/// On a mesh sequence and beside a dialog nothing can be picked: the left button alone turns the view as
/// well, and a right click opens the menu of the view where no dialog is.
void lookAround(ViewportContext& context, bool pressed, bool held) {
  ViewportState& viewport = context.viewport;
  if (pressed) {
    viewport.pressPixels = viewport.lastPixels = viewport.mousePixels;
    viewport.gesture = navigationGesture(context.ui.navigation, ImGui::GetIO());
    if (viewport.gesture == ViewportGesture::none && !pressCube(viewport) &&
        ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
      viewport.gesture = ViewportGesture::orbit;
    }
    const bool asksMenu = viewport.gesture == ViewportGesture::none && !isSeenBesideDialog(context) &&
                          ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    viewport.gesture = asksMenu ? ViewportGesture::pressMenu : viewport.gesture;
  } else if (held) {
    dragCube(viewport);
    navigate(viewport);
  } else {
    releaseCube(viewport);
    if (viewport.gesture == ViewportGesture::pressMenu && isClick(viewport)) {
      askForMenu(context.ui, MenuTarget::viewport);
    }
    viewport.gesture = ViewportGesture::none;
  }
}

} // namespace

void updateHover(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  if (viewport.gesture != ViewportGesture::none || isRunning(context.tool)) {
    return; // What was taken stays marked until it is let go.
  }
  viewport.hoveredHandle.reset();
  viewport.hoveredController.clear();
  viewport.hoveredSphere.reset();
  viewport.hoveredAxis.reset();
  viewport.hoveredTangent.reset();
  viewport.hoveredTrail = 0;
  viewport.hoveredLimb.clear();
  viewport.hoveredEnd = false;
  viewport.hoveredJoint = NodeIndex::none;
  viewport.look.hoveredPart = viewport.hovered ? cubePartUnderMouse(context) : std::nullopt;
  if (!viewport.hovered || viewport.look.hoveredPart || !canPick(context)) {
    return;
  }
  const bool pressed =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (context.ui.time.timeline.playing && !pressed) {
    return; // The surface is another in each frame: it is looked at when it is asked for.
  }
  hoverHandles(context);
  if (viewport.hoveredHandle) {
    return;
  }
  const app::ViewState& view = context.open.character()->view();
  viewport.hoveredTangent = pickTangent(viewport.view, viewport.tangents, viewport.mousePixels);
  if (viewport.hoveredTangent) {
    return;
  }
  if (const ShownTrail* const selected = seenTrail(context)) {
    if (const auto handles = handlesOf(viewport.shown, selected->id, view.selection.spheres())) {
      viewport.hoveredAxis = pickAxis(viewport.view, *handles, viewport.mousePixels);
    }
    if (!viewport.hoveredAxis) {
      hoverSphere(viewport, *selected);
    }
  }
  const bool onSphere = viewport.hoveredAxis || viewport.hoveredSphere;
  if (!onSphere) {
    hoverControllers(context);
  }
  if (!onSphere && viewport.hoveredController.empty()) {
    hoverTrails(context);
  }
  if (!onSphere && viewport.hoveredController.empty() && viewport.hoveredTrail == 0) {
    hoverLimbs(context);
  }
}

namespace {

/// What the mouse would do, by its shape: a hand that takes, arrows that pull.
void shapeCursor(const ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  if (!viewport.hovered) {
    return;
  }
  const bool pulls =
      std::holds_alternative<GrabTool>(context.tool) || std::holds_alternative<ControllerTool>(context.tool);
  if (pulls || viewport.hoveredHandle || viewport.hoveredAxis || viewport.hoveredSphere) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  } else if (viewport.look.hoveredPart || !viewport.hoveredController.empty() || viewport.hoveredEnd ||
             viewport.hoveredTrail != 0 || !viewport.hoveredLimb.empty()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
}

} // namespace

void handleViewportMouse(ViewportContext& context, bool hovered, bool held) {
  ViewportState& viewport = context.viewport;
  const ImGuiIO& io = ImGui::GetIO();
  viewport.hovered = hovered;
  viewport.lastPixels = viewport.mousePixels;
  viewport.mousePixels =
      viewport.pixelsPerUnit * Vec2(io.MousePos.x - viewport.box.min.x, io.MousePos.y - viewport.box.min.y);
  updateHover(context);
  const bool pressed = hovered && (ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                                   ImGui::IsMouseClicked(ImGuiMouseButton_Middle) ||
                                   ImGui::IsMouseClicked(ImGuiMouseButton_Right));
  if (!canPick(context)) {
    lookAround(context, pressed, held);
  } else if (pressed) {
    beginGesture(context);
  } else if (held) {
    continueGesture(context);
  } else if (viewport.gesture != ViewportGesture::none) {
    endGesture(context);
  }
  if (hovered && io.MouseWheel != 0.0F) {
    turnWheel(context, static_cast<double>(io.MouseWheel));
  }
  driveTool(context);
  shapeCursor(context);
}

} // namespace stretch::ui
