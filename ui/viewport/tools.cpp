#include "ui/viewport/tools.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/commands/keys/keys.h"
#include "app/commands/pose/hold.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "core/anim/frames.h"
#include "ui/viewport/keys_tool.h"

namespace stretch::ui {

namespace {

Status show(app::Session& session, Result<app::Document> changed) {
  if (!changed) {
    return changed.error();
  }
  session.preview(std::move(changed).value());
  return Success{};
}

Status previewExaggerate(app::Session& session, const ExaggerateTool& tool) {
  return show(session, app::exaggeratedWith(tool.targets, tool.modal));
}

/// The trail as the pull makes it.
Result<app::Document> pulled(const GrabTool& tool) {
  const Vec3 delta = app::worldChange(tool.modal);
  if (delta == Vec3(0.0)) {
    return tool.base;
  }
  if (tool.tangent) {
    const Vec3 turn = app::toTrailAxes(tool.settings, delta) / tool.tangent->frames;
    return app::setSphereTangent(tool.base, tool.trailId, tool.tangent->sphereFrame, tool.slope + turn);
  }
  return app::moveSpheres(
      tool.base, tool.trailId,
      app::softMoves(tool.settings, tool.spheres, tool.selected, delta, tool.falloffRadius));
}

Status previewGrab(app::Session& session, const GrabTool& tool) {
  return show(session, pulled(tool));
}

Status previewTool(app::Session& session, Tool& tool) {
  if (const auto* exaggerate = std::get_if<ExaggerateTool>(&tool)) {
    return previewExaggerate(session, *exaggerate);
  }
  if (const auto* grab = std::get_if<GrabTool>(&tool)) {
    return previewGrab(session, *grab);
  }
  if (const auto* keys = std::get_if<KeysTool>(&tool)) {
    return previewKeys(session, *keys);
  }
  if (const auto* controllers = std::get_if<ControllerTool>(&tool)) {
    return previewControllers(session, *controllers);
  }
  return Success{};
}

double defaultRelease(app::Session& session, int trailId) {
  const rig::SolvedTrail* solved = app::solvedTrail(session, trailId);
  if (solved == nullptr) {
    return 0.0;
  }
  const double frames = (solved->windowEndSeconds - solved->endSeconds) * session.motion().framesPerSecond;
  return std::max(0.0, std::round(frames));
}

std::optional<Vec3> positionOfSphere(const std::vector<app::PlacedSphere>& spheres, double frame) {
  const auto found = std::find_if(spheres.begin(), spheres.end(), [&](const app::PlacedSphere& sphere) {
    return sameFrame(sphere.frame, frame);
  });
  return found == spheres.end() ? std::nullopt : std::optional(found->positionWorld);
}

/// A pull of the selected spheres of the trail, from the document as it is shown.
Result<GrabTool> grabOf(app::Session& session, const rig::Trail& trail, const GrabStart& start) {
  const std::vector<double>& selected = session.view().selection.spheres();
  GrabTool started;
  started.trailId = trail.id;
  started.base = session.document();
  started.settings = trail.settings;
  started.selected = selected;
  started.spheres = app::placedSpheres(session, trail.id);
  const std::optional<Vec3> held =
      positionOfSphere(started.spheres, start.heldFrame.value_or(selected.back()));
  if (!held) {
    return Error{"the sphere is not on this trail", "", "select it again"};
  }
  started.anchor = *held;
  started.startPixels = start.startPixels;
  started.byDrag = start.byDrag;
  started.falloffRadius = start.falloffRadius;
  started.modal.hasCarriers = false;
  started.modal.viewAxes = session.view().cameraAxes;
  started.modal.arrowUnits = app::nudgeUnits(session.document());
  started.modal.lock.axis = start.axis;
  return started;
}

} // namespace

Status startExaggerate(app::Session& session, Tool& tool, app::OverlapChoice choice) {
  Result<app::ExaggerateTargets> targets = app::exaggerateTargets(session, choice);
  if (!targets) {
    return targets.error();
  }
  const int leading = targets->trailIds.front();
  const rig::Trail trail = *app::findTrail(targets->document, leading);
  ExaggerateTool started;
  started.limbTitle = targets->trailIds.size() == 1 ? app::limbTitle(session.document(), trail.limb)
                                                    : fmt::format("{} limbs", targets->trailIds.size());
  session.begin("Exaggerate");
  session.preview(targets->document);
  app::selectTrail(session, leading);
  session.view().selection.dropSpheres();
  started.modal = app::beginExaggerate(trail.settings, defaultRelease(session, leading));
  started.modal.hasStrokes = app::nextStroke(session, *targets, true).has_value();
  started.targets = std::move(targets).value();
  tool = std::move(started);
  return Success{};
}

Status startGrab(app::Session& session, Tool& tool, const GrabStart& start) {
  const rig::Trail* trail = app::selectedTrail(session);
  const std::vector<double>& selected = session.view().selection.spheres();
  if (trail == nullptr || selected.empty()) {
    return Error{"no control sphere is selected", "", "press Tab to select one, or click it"};
  }
  Result<GrabTool> started = grabOf(session, *trail, start);
  if (!started) {
    return started.error();
  }
  session.begin(selected.size() == 1 ? "Move the sphere" : "Move the spheres");
  tool = std::move(started).value();
  return Success{};
}

Status startTangentGrab(app::Session& session, Tool& tool, const app::TangentHandle& handle,
                        const Vec3& tipWorld, const GrabStart& start) {
  const rig::Trail* const trail = app::selectedTrail(session);
  const rig::SolvedTrail* const solved = trail == nullptr ? nullptr : app::solvedTrail(session, trail->id);
  if (solved == nullptr) {
    return app::missingTrail(session.view().selection.trail());
  }
  GrabStart fromSphere = start;
  fromSphere.heldFrame = handle.sphereFrame;
  Result<GrabTool> started = grabOf(session, *trail, fromSphere);
  if (!started) {
    return started.error();
  }
  started->tangent = handle;
  started->slope = solved->offsets.slopeAt(handle.sphereFrame);
  started->anchor = tipWorld;
  session.begin("Bend the path");
  tool = std::move(started).value();
  return Success{};
}

Status startLimbGrab(app::Session& session, Tool& tool, const std::string& limbId, const GrabStart& start) {
  const Result<app::HeldLimb> held = app::holdLimb(session, limbId);
  if (!held) {
    return held.error();
  }
  session.begin("Pull the " + app::limbTitle(session.document(), limbId));
  session.preview(held->document);
  app::selectTrail(session, held->trailId);
  double frame = session.view().frame;
  const Result<app::Document> withSphere = app::withSphereAt(session, held->trailId, frame);
  if (withSphere) {
    session.preview(*withSphere);
    session.view().selection.editTrails().spheres = {frame};
  }
  const rig::Trail* const trail = app::selectedTrail(session);
  Result<GrabTool> started = !withSphere        ? Result<GrabTool>(withSphere.error())
                             : trail == nullptr ? Result<GrabTool>(app::missingTrail(held->trailId))
                                                : grabOf(session, *trail, start);
  if (!started) {
    session.cancel();
    return started.error();
  }
  tool = std::move(started).value();
  return Success{};
}

Status startControllerTool(app::Session& session, Tool& tool, const ControllerStart& start) {
  Result<ControllerTool> started = startControllers(session, start);
  if (!started) {
    return started.error();
  }
  tool = std::move(started).value();
  return Success{};
}

Status pressToolKey(app::Session& session, Tool& tool, const app::KeyPress& press) {
  app::ModalOutcome outcome = app::ModalOutcome::running;
  if (auto* exaggerate = std::get_if<ExaggerateTool>(&tool)) {
    const bool plain = !press.chord.ctrl && !press.chord.alt;
    if (plain && app::typedLetter(press) == 'n' && goToStroke(session, *exaggerate, !press.chord.shift)) {
      return Success{};
    }
    outcome = app::pressKey(exaggerate->modal, press);
  } else if (auto* grab = std::get_if<GrabTool>(&tool)) {
    outcome = app::pressKey(grab->modal, press);
  } else if (auto* keys = std::get_if<KeysTool>(&tool)) {
    outcome = app::pressKey(keys->modal, press);
  } else if (auto* controllers = std::get_if<ControllerTool>(&tool)) {
    outcome = app::pressKey(controllers->modal, press);
  }
  if (outcome != app::ModalOutcome::running) {
    finishTool(session, tool, outcome == app::ModalOutcome::keep);
    return Success{};
  }
  return previewTool(session, tool);
}

Status moveToolMouse(app::Session& session, Tool& tool, const View& view, const Vec2& mousePixels) {
  auto* const grab = std::get_if<GrabTool>(&tool);
  auto* const controllers = std::get_if<ControllerTool>(&tool);
  Pull* const pull = grab != nullptr ? static_cast<Pull*>(grab) : controllers;
  const Mat3 axes = controllers != nullptr ? controllers->held.back().placed.carrierAxesWorld : Mat3(1.0);
  if (pull == nullptr || !followMouse(*pull, axes, view, mousePixels)) {
    return Success{};
  }
  return grab != nullptr ? previewGrab(session, *grab) : previewControllers(session, *controllers);
}

Status turnFalloff(app::Session& session, Tool& tool, double steps) {
  auto* grab = std::get_if<GrabTool>(&tool);
  if (grab == nullptr || grab->tangent) {
    return Success{};
  }
  const double smallest = 0.02 * session.document().body.height;
  const double radius = std::max(grab->falloffRadius, smallest) * std::pow(1.2, steps);
  grab->falloffRadius = radius < smallest ? 0.0 : std::min(radius, 10.0 * session.document().body.height);
  return previewGrab(session, *grab);
}

bool goToStroke(app::Session& session, ExaggerateTool& tool, bool forwards) {
  const std::optional<Vec2> range = app::nextStroke(session, tool.targets, forwards);
  const Result<app::ExaggerateTargets> moved =
      range ? app::movedTo(session, tool.targets, *range) : Result<app::ExaggerateTargets>(Error{});
  if (!moved) {
    return false;
  }
  tool.targets = *moved;
  const rig::TrailSettings& there = app::findTrail(moved->document, moved->trailIds.front())->settings;
  tool.modal.settings.stopAt = there.stopAt;
  tool.modal.settings.space = there.space;
  if (!previewExaggerate(session, tool)) {
    return false;
  }
  tool.modal.defaultReleaseFrames = defaultRelease(session, moved->trailIds.front());
  return true;
}

std::optional<double> tipFrame(const app::Session& session, const Tool& tool) {
  const rig::Trail* const trail = app::selectedTrail(session);
  if (!std::holds_alternative<ExaggerateTool>(tool) || trail == nullptr) {
    return std::nullopt;
  }
  return rig::tipFrameOf(trail->settings);
}

void finishTool(app::Session& session, Tool& tool, bool keep) {
  if (!isRunning(tool)) {
    return;
  }
  const auto* const keys = std::get_if<KeysTool>(&tool);
  const app::KeySelection picked = keys != nullptr ? keys->picked : app::KeySelection{};
  if (const auto* controllers = std::get_if<ControllerTool>(&tool)) {
    endControllers(session, *controllers, keep);
  }
  tool = std::monostate{};
  if (!session.isDragging()) {
    return;
  }
  if (keep) {
    session.commit();
  } else {
    session.cancel();
    app::pickKeys(session, picked.empty() ? app::pickedKeys(session) : picked, false);
  }
}

void describeTool(const Tool& tool, EditorStatus& status) {
  std::vector<app::ModalHint> hints;
  if (const auto* exaggerate = std::get_if<ExaggerateTool>(&tool)) {
    status.modalText = app::modalText(exaggerate->modal, exaggerate->limbTitle);
    hints = app::modalHints(exaggerate->modal);
  } else if (const auto* grab = std::get_if<GrabTool>(&tool)) {
    const bool soft = grab->falloffRadius > 0.0 && !grab->tangent;
    const std::string spheres =
        grab->selected.size() == 1 ? "sphere" : fmt::format("{} spheres", grab->selected.size());
    status.modalText = app::modalText(grab->modal, grab->tangent ? "tangent" : spheres);
    status.modalText += soft ? fmt::format(", falloff {:.3f}", grab->falloffRadius) : "";
    hints = app::modalHints(grab->modal);
    hints.push_back({"Wheel", "falloff"});
  } else if (const auto* keys = std::get_if<KeysTool>(&tool)) {
    status.modalText = app::modalText(keys->modal, app::keyCount(keys->picked));
    hints = app::modalHints(keys->modal);
  } else if (const auto* controllers = std::get_if<ControllerTool>(&tool)) {
    status.modalText = app::modalText(controllers->modal, controllers->title);
    hints = app::modalHints(controllers->modal);
  }
  for (app::ModalHint& hint : hints) {
    status.keyHints.push_back({std::move(hint.key), std::move(hint.does)});
  }
}

} // namespace stretch::ui
