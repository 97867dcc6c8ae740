#include "ui/viewport/controller_tool.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/commands/pose/posing.h"
#include "app/commands/table/selection.h"
#include "app/locators/locator_edits.h"

namespace stretch::ui {

namespace {

// The mouse turns about an axis: how far, in radians, from one place to another.
double turnBetween(const View& view, const Vec3& about, const Vec3& axis, const Vec2& from, const Vec2& to) {
  constexpr double edgeOn = 0.25; // cosine: below, the ring is seen from its edge
  const std::optional<ScreenPoint> centre = projectToPixels(view, about);
  if (!centre) {
    return 0.0;
  }
  const Vec3 towards = glm::normalize(view.eye - about);
  const double facing = glm::dot(axis, towards);
  const Vec2 before = from - centre->pixels;
  const Vec2 after = to - centre->pixels;
  if (std::abs(facing) >= edgeOn) {
    if (glm::length(before) < 1.0 || glm::length(after) < 1.0) {
      return 0.0;
    }
    // The screen's y runs down: what turns to the right there is a negative turn about what faces the viewer.
    const double right = std::atan2(before.x * after.y - before.y * after.x, glm::dot(before, after));
    return facing > 0.0 ? -right : right;
  }
  constexpr double pointsPerRadian = 66.0;
  const Vec3 along = glm::normalize(glm::cross(axis, towards));
  const Vec2 onScreen(glm::dot(along, viewRight(view)), -glm::dot(along, viewUp(view)));
  return glm::dot(to - from, onScreen) / (pointsPerRadian * view.viewport.pixelsPerPoint);
}

// Where the mouse comes to in the plane across an axis.
Vec3 pointAcross(const View& view, const Vec3& through, const Vec3& normal, const Vec2& pixels) {
  const Ray ray = rayThroughPixel(view, pixels);
  const double slope = glm::dot(ray.direction, normal);
  constexpr double edgeOn = 1e-3;
  if (std::abs(slope) < edgeOn) {
    return through;
  }
  return ray.origin + glm::dot(through - ray.origin, normal) / slope * ray.direction;
}

Vec3 pulledTo(const Pull& tool, const Mat3& axes, const View& view, const Vec2& mousePixels) {
  if (const std::optional<Vec3> axis = app::lockedAxis(tool.modal.lock, axes)) {
    return (positionAlongAxis(view, tool.anchor, *axis, mousePixels) -
            positionAlongAxis(view, tool.anchor, *axis, tool.startPixels)) *
           *axis;
  }
  if (tool.modal.lock.plane) {
    app::AxisLock across = tool.modal.lock;
    across.plane = false;
    const Vec3 normal = *app::lockedAxis(across, axes);
    return pointAcross(view, tool.anchor, normal, mousePixels) -
           pointAcross(view, tool.anchor, normal, tool.startPixels);
  }
  return pointInViewPlane(view, tool.anchor, mousePixels) -
         pointInViewPlane(view, tool.anchor, tool.startPixels);
}

std::string titleOf(const app::Document& document, const std::vector<app::HeldController>& held) {
  return held.size() == 1 ? app::controllerTitle(document, held.front().placed.id)
                          : fmt::format("{} controllers", held.size());
}

std::vector<std::string> idsOf(const std::vector<app::HeldController>& held) {
  std::vector<std::string> ids;
  ids.reserve(held.size());
  for (const app::HeldController& one : held) {
    ids.push_back(one.placed.id);
  }
  return ids;
}

// What a tool begins with, whatever it holds.
ControllerTool begun(const app::Session& session, const ControllerStart& start,
                     std::vector<app::HeldController> held) {
  ControllerTool tool;
  tool.held = std::move(held);
  tool.unkeyed = session.view().unkeyed;
  tool.anchor = tool.held.back().placed.placeWorld;
  tool.byDrag = start.byDrag;
  tool.startPixels = start.startPixels;
  tool.lastPixels = start.startPixels;
  tool.modal.motion = start.motion;
  tool.modal.lock = start.lock;
  tool.modal.viewAxes = session.view().cameraAxes;
  tool.modal.arrowUnits = app::nudgeUnits(session.document());
  return tool;
}

Result<ControllerTool> startLocators(app::Session& session, const ControllerStart& start) {
  const std::vector<std::string>& selected = session.view().selection.locators();
  std::vector<app::HeldController> held;
  for (const std::string& name : selected) {
    const rig::Locator* const locator = rig::findLocator(session.document().locators, name);
    if (locator != nullptr) {
      rig::PlacedController placed;
      placed.id = name;
      placed.placeWorld = locator->position;
      placed.carrierAxesWorld = glm::mat3_cast(locator->orientation);
      held.push_back({placed, {}});
    }
  }
  if (held.empty()) {
    return Error{"no locator is selected", "", "click one"};
  }
  const bool moves = start.motion == app::PullMotion::move;
  ControllerTool tool = begun(session, start, std::move(held));
  tool.title = selected.size() == 1 ? selected.front() : fmt::format("{} locators", selected.size());
  tool.isOfLocators = true;
  session.begin((moves ? "Move " : "Turn ") + tool.title);
  return tool;
}

// All move as the one that was taken last, whose axes a lock may name.
Status previewLocators(app::Session& session, const ControllerTool& tool) {
  const std::vector<std::string> names = idsOf(tool.held);
  const Vec3 change = app::worldChange(tool.modal, tool.held.back().placed.carrierAxesWorld);
  const bool mirror = session.view().mirrorLocators;
  const app::Document& base = session.atBegin();
  if (change == Vec3(0.0)) {
    session.preview(base);
  } else if (tool.modal.motion == app::PullMotion::move) {
    session.preview(app::moveLocators(base, names, change, mirror));
  } else {
    session.preview(app::turnLocators(base, names, change, mirror));
  }
  return Success{};
}

} // namespace

bool followMouse(Pull& pull, const Mat3& axes, const View& view, const Vec2& mousePixels) {
  if (!pull.moved && glm::distance(mousePixels, pull.startPixels) < 3.0 * view.viewport.pixelsPerPoint) {
    return false;
  }
  pull.moved = true;
  if (pull.modal.motion == app::PullMotion::move) {
    pull.modal.mouseWorld = pulledTo(pull, axes, view, mousePixels);
  } else {
    const Vec3 axis = app::lockedAxis(pull.modal.lock, axes).value_or(pull.modal.viewAxes[2]);
    pull.modal.mouseRadians += turnBetween(view, pull.anchor, axis, pull.lastPixels, mousePixels);
  }
  pull.lastPixels = mousePixels;
  return true;
}

Result<ControllerTool> startControllers(app::Session& session, const ControllerStart& start) {
  if (app::showsLocators(session)) {
    return startLocators(session, start);
  }
  const bool moves = start.motion == app::PullMotion::move;
  const std::vector<std::string>& selected = session.view().selection.controllers();
  std::vector<rig::PlacedController> placed;
  std::vector<app::ControllerOffset> offsets;
  for (const rig::PlacedController& one : session.controllersAt(session.view().frame)) {
    if (std::ranges::find(selected, one.id) != selected.end()) {
      placed.push_back(one);
      offsets.push_back(app::shownOffset(session, one.id));
    }
  }
  std::vector<app::HeldController> held = app::heldControllers(start.motion, placed, offsets);
  if (held.empty()) {
    return Error{moves ? "none of the selected controllers moves" : "none of the selected controllers turns",
                 "",
                 moves ? "select the body, hips, spine, head, a hand, a foot or a pole"
                       : "select the body, hips, the top of the spine, head, a hand, a foot or a joint"};
  }
  // The last selected one is the one with the handles.
  const auto last = std::ranges::find_if(
      held, [&](const app::HeldController& one) { return one.placed.id == selected.back(); });
  std::iter_swap(last == held.end() ? std::prev(held.end()) : last, std::prev(held.end()));
  ControllerTool tool = begun(session, start, std::move(held));
  tool.title = titleOf(session.document(), tool.held);
  if (session.view().autoKey) {
    session.begin(app::poseLabel(session.document(), moves ? "Move" : "Turn", idsOf(tool.held)));
  }
  return tool;
}

Status previewControllers(app::Session& session, const ControllerTool& tool) {
  if (tool.isOfLocators) {
    return previewLocators(session, tool);
  }
  const std::vector<app::ControllerOffset> offsets = app::changedOffsets(tool.modal, tool.held);
  const bool same = std::ranges::equal(offsets, tool.held,
                                       [](const auto& now, const auto& held) { return now == held.offset; });
  if (!same) {
    return app::previewPose(session, {offsets, {}});
  }
  session.view().unkeyed = tool.unkeyed;
  if (session.isDragging()) {
    session.preview(session.atBegin());
  }
  return Success{};
}

void endControllers(app::Session& session, const ControllerTool& tool, bool keep) {
  if (!keep) {
    session.view().unkeyed = tool.unkeyed;
  } else if (session.isDragging()) {
    for (const app::HeldController& held : tool.held) {
      session.view().unkeyed.offsets.erase(held.placed.id); // It is keyed now.
    }
  }
}

} // namespace stretch::ui
