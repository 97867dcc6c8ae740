#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/modal.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/nudges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/commands/trail/spheres.h"
#include "app/edits/trail/sphere_edits.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

bool hasSpheres(const Session& session) {
  return hasSelectedTrail(session) && !session.view().selection.spheres().empty();
}

Need sphereNeeded() {
  return {hasSpheres, "select a control sphere first: click one, or go to it with Next sphere"};
}

Error noSphere() {
  return {"no control sphere is selected", "", "press Tab to select one, or click it"};
}

/// Of the last selected limb's trails the one that is nearest to the playhead; 0 for none.
int trailOfLimb(const Session& session) {
  const ViewState& view = session.view();
  int nearest = 0;
  double least = 0.0;
  for (const rig::Trail& trail : session.document().trails) {
    const double frame = std::clamp(view.frame, trail.settings.startFrame, trail.settings.endFrame);
    const double away = std::abs(frame - view.frame);
    if (!view.selection.limbs().empty() && trail.limb == view.selection.limbs().back() &&
        trail.clip == view.clip && (nearest == 0 || away < least)) {
      nearest = trail.id;
      least = away;
    }
  }
  return nearest;
}

Need trailToStepNeeded() {
  return {[](const Session& session) {
            return hasSelectedTrail(session) ||
                   (session.view().selection.controllers().empty() && trailOfLimb(session) != 0);
          },
          selectedTrailNeeded().text};
}

Status stepSphere(Session& session, bool forward) {
  if (!hasSelectedTrail(session)) {
    selectTrail(session, trailOfLimb(session));
  }
  const std::vector<double> frames = sphereFrames(session);
  if (frames.empty()) {
    return Error{"no trail with control spheres is selected", "", "select a limb and press T or E"};
  }
  ViewState& view = session.view();
  const bool started = !view.selection.spheres().empty();
  const double from = started ? view.selection.spheres().back() : view.frame;
  const auto count = static_cast<std::ptrdiff_t>(frames.size());
  std::ptrdiff_t index = 0;
  if (forward) {
    const auto next = std::find_if(frames.begin(), frames.end(), [&](double frame) {
      return started ? frame > from && !sameFrame(frame, from) : frame > from || sameFrame(frame, from);
    });
    index = next == frames.end() ? 0 : next - frames.begin();
  } else {
    const auto next = std::find_if(frames.rbegin(), frames.rend(), [&](double frame) {
      return started ? frame < from && !sameFrame(frame, from) : frame < from || sameFrame(frame, from);
    });
    index = next == frames.rend() ? count - 1 : count - 1 - (next - frames.rbegin());
  }
  view.selection.editTrails().spheres = {frames[static_cast<std::size_t>(index)]};
  // Key times are single precision: the playhead stands on the whole frame that they mean.
  const double whole = std::round(view.selection.spheres().front());
  view.frame = sameFrame(whole, view.selection.spheres().front()) ? whole : view.selection.spheres().front();
  return Success{};
}

Status selectAll(Session& session) {
  session.view().selection.editTrails().spheres = sphereFrames(session);
  return session.view().selection.spheres().empty() ? Status(noSphere()) : Status(Success{});
}

Status putBack(Session& session) {
  return finish(
      session,
      clearSpheres(session.document(), session.view().selection.trail(), session.view().selection.spheres()),
      "Put the spheres back");
}

/// Whether a selected sphere was pulled or turned, and `counts`.
template <typename Counts>
bool anySelected(const Session& session, Counts&& counts) {
  const rig::Trail* const trail = selectedTrail(session);
  if (trail == nullptr) {
    return false;
  }
  const std::vector<double>& selected = session.view().selection.spheres();
  return std::any_of(trail->settings.spheres.begin(), trail->settings.spheres.end(), [&](const auto& sphere) {
    return counts(sphere) &&
           std::ranges::any_of(selected, [&](double frame) { return sameFrame(frame, sphere.frame); });
  });
}

bool hasPulledSpheres(const Session& session) {
  return anySelected(session, [](const rig::SphereOffset&) { return true; });
}

bool hasTangents(const Session& session) {
  return anySelected(session, [](const rig::SphereOffset& sphere) { return sphere.tangent.has_value(); });
}

Status resetTangents(Session& session) {
  Document document = session.document();
  for (const double frame : session.view().selection.spheres()) {
    Result<Document> changed =
        setSphereTangent(document, session.view().selection.trail(), frame, std::nullopt);
    if (!changed) {
      return changed.error();
    }
    document = std::move(changed).value();
  }
  return finish(session, std::move(document), "Reset the tangents");
}

Status pull(Session& session, const std::vector<SphereMove>& moves, const char* label) {
  const rig::Trail* trail = selectedTrail(session);
  if (trail == nullptr || moves.empty()) {
    return noSphere();
  }
  return finish(session, moveSpheres(session.document(), trail->id, moves), label);
}

Status nudge(Session& session, const Chord& chord) {
  const rig::Trail* trail = selectedTrail(session);
  if (trail == nullptr) {
    return noSphere();
  }
  const Vec3 world = nudgeOf(chord, session.view().cameraAxes, nudgeUnits(session.document()));
  std::vector<SphereMove> moves;
  for (const double frame : session.view().selection.spheres()) {
    moves.push_back({frame, toTrailAxes(trail->settings, world)});
  }
  return pull(session, moves, "Nudge the spheres");
}

/// Direction of the path at one of its spheres, from neighbour to neighbour; zero where they coincide.
Vec3 pathDirection(const std::vector<PlacedSphere>& spheres, std::size_t index) {
  const std::size_t before = index == 0 ? 0 : index - 1;
  const std::size_t after = std::min(index + 1, spheres.size() - 1);
  const Vec3 chord = spheres[after].positionWorld - spheres[before].positionWorld;
  const double length = glm::length(chord);
  return length > 1e-12 ? chord / length : Vec3(0.0);
}

Status nudgeAlong(Session& session, double direction) {
  const rig::Trail* trail = selectedTrail(session);
  if (trail == nullptr) {
    return noSphere();
  }
  const std::vector<PlacedSphere> spheres = placedSpheres(session, trail->id);
  const double step = direction * nudgeUnits(session.document());
  std::vector<SphereMove> moves;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto& selected = session.view().selection.spheres();
    const bool isSelected =
        std::ranges::any_of(selected, [&](double frame) { return sameFrame(frame, spheres[i].frame); });
    if (isSelected) {
      moves.push_back({spheres[i].frame, toTrailAxes(trail->settings, step * pathDirection(spheres, i))});
    }
  }
  return pull(session, moves, "Slide the spheres along the path");
}

} // namespace

std::vector<DocumentCommand> sphereCommands() {
  std::vector<DocumentCommand> commands{
      orElse(
          entry(command::sphereNext, "Next sphere",
                "Selects the next control sphere of the selected limb; the playhead jumps there. Without a "
                "trail the next controller.",
                {"Tab"}, trailToStepNeeded(), [](Session& session) { return stepSphere(session, true); }),
          command::controllerNext),
      orElse(
          entry(command::spherePrevious, "Previous sphere",
                "Selects the control sphere before of the selected limb; the playhead jumps there. Without "
                "a trail the controller before.",
                {"Shift+Tab"}, trailToStepNeeded(),
                [](Session& session) { return stepSphere(session, false); }),
          command::controllerPrevious),
      orElse(entry(command::sphereAll, "All spheres",
                   "Selects every control sphere of the trail; without one every controller.", {"Ctrl+A"},
                   selectedTrailNeeded(), selectAll),
             command::controllersAll),
      entry(
          command::sphereAdd, "Add a sphere",
          "Adds a control sphere to the selected trail at the playhead; a double click on the trail adds one "
          "there.",
          {"Insert"}, selectedTrailNeeded(),
          [](Session& session) { return addSphere(session, session.view().frame); }),
      orElse(entry(command::sphereReset, "Put the spheres back",
                   "Takes pulls and tangents of the selected spheres back; the spheres stay. Of selected "
                   "controllers it takes "
                   "the offset at the playhead.",
                   {"Alt+G"}, {hasPulledSpheres, "select a sphere that was pulled"}, putBack),
             command::poseReset),
      entry(command::sphereSmooth, "Reset the tangents",
            "Lets the path run through the selected spheres as their neighbours say, without a tangent of "
            "their "
            "own.",
            {}, {hasTangents, "select a sphere with a tangent of its own"}, resetTangents),
      entry(command::sphereAlongBack, "Slide back along the path",
            "Moves the selected spheres back along the path: closer spacing "
            "before, wider after.",
            {"Alt+Left"}, sphereNeeded(), [](Session& session) { return nudgeAlong(session, -1.0); }),
      entry(command::sphereAlongForward, "Slide on along the path",
            "Moves the selected spheres on along the path: wider spacing "
            "before, closer after.",
            {"Alt+Right"}, sphereNeeded(), [](Session& session) { return nudgeAlong(session, 1.0); }),
  };
  for (DocumentCommand& command : nudgeCommands({.idPrefix = "sphere.nudge-",
                                  .words = "the selected spheres",
                                  .need = sphereNeeded(),
                                  .otherwisePrefix = controllerNudges,
                                  .nudge = nudge})) {
    commands.push_back(std::move(command));
  }
  return commands;
}

} // namespace stretch::app
