#include "ui/viewport/controller_mouse.h"

#include <algorithm>
#include <utility>

#include "app/commands/table/selection.h"
#include "app/locators/locator_edits.h"
#include "rig/controllers/controller.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

namespace {

void start(ViewportContext& context, app::PullMotion motion, const app::AxisLock& lock) {
  tellProblem(context, startControllerTool(*context.open.character(), context.tool,
                                           {motion, lock, context.viewport.pressPixels, true}));
}

app::AxisLock lockOf(const HandlePart& part) {
  return {static_cast<int>(part.axis), part.kind == HandleKind::plane, false};
}

/// The controller at the end of the limb that was pressed; empty where there is none.
std::string pressedEnd(const ViewportContext& context) {
  const rig::Limb* const limb =
      app::findLimb(context.open.character()->document(), context.viewport.hoveredLimb);
  const std::string id = limb == nullptr ? std::string() : rig::endController(*limb);
  return findShown(context.viewport.controllers, id) == nullptr ? std::string() : id;
}

} // namespace

void hoverHandles(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  if (const auto handles = controllerHandles(*context.open.character(), viewport.controllers)) {
    viewport.hoveredHandle = pickHandle(viewport.view, *handles, viewport.mousePixels);
  }
}

void hoverControllers(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  viewport.hoveredController =
      pickController(viewport.view, viewport.controllers, viewport.mousePixels).value_or("");
}

void markHeldHandle(ViewportState& viewport, const ControllerTool& tool) {
  const app::AxisLock& lock = tool.modal.lock;
  const HandleKind kind = tool.modal.motion == app::PullMotion::turn ? HandleKind::ring
                          : lock.plane                               ? HandleKind::plane
                                                                     : HandleKind::axis;
  viewport.hoveredHandle = lock.axis && !lock.ofCarrier
                               ? std::optional(HandlePart{kind, static_cast<std::size_t>(*lock.axis)})
                               : std::nullopt;
}

bool pressController(ViewportContext& context, bool add) {
  ViewportState& viewport = context.viewport;
  app::Session& session = *context.open.character();
  if (viewport.hoveredHandle) {
    const bool turns = viewport.hoveredHandle->kind == HandleKind::ring;
    start(context, turns ? app::PullMotion::turn : app::PullMotion::move, lockOf(*viewport.hoveredHandle));
    return true;
  }
  if (viewport.hoveredController.empty()) {
    return false;
  }
  // Pressing one of several keeps them all, so that they can be dragged together.
  const std::vector<std::string>& selected = selectedHandles(session);
  if (add || std::ranges::find(selected, viewport.hoveredController) == selected.end()) {
    const auto select = app::showsLocators(session) ? app::selectLocator : app::selectController;
    select(session, viewport.hoveredController, add);
  }
  viewport.gesture = add ? ViewportGesture::none : ViewportGesture::pressController;
  return true;
}

bool dragController(ViewportContext& context) {
  ViewportState& viewport = context.viewport;
  app::Session& session = *context.open.character();
  if (viewport.gesture == ViewportGesture::pressEnd) {
    const std::string id = pressedEnd(context);
    if (id.empty()) {
      return false;
    }
    app::selectController(session, id, false);
  } else if (viewport.gesture != ViewportGesture::pressController) {
    return false;
  }
  viewport.gesture = ViewportGesture::none;
  const std::vector<std::string>& selected = selectedHandles(session);
  const ShownController* const pressed =
      findShown(viewport.controllers, selected.empty() ? std::string() : selected.back());
  const bool onlyTurns = pressed != nullptr && !pressed->placed.moves;
  start(context, onlyTurns ? app::PullMotion::turn : app::PullMotion::move, {});
  return true;
}

bool selectControllersInBox(ViewportContext& context, const Vec2& low, const Vec2& high, bool add) {
  app::Session& session = *context.open.character();
  if (context.viewport.controllers.empty() || session.view().selection.trail() != 0) {
    return false;
  }
  std::vector<std::string> wanted = add ? selectedHandles(session) : std::vector<std::string>();
  for (std::string& id : controllersInBox(context.viewport.view, context.viewport.controllers, low, high)) {
    if (std::ranges::find(wanted, id) == wanted.end()) {
      wanted.push_back(std::move(id));
    }
  }
  const bool areLocators = app::showsLocators(session);
  (areLocators ? app::selectLocators : app::selectControllers)(session, std::move(wanted));
  return true;
}

} // namespace stretch::ui
