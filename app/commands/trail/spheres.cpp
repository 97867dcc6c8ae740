#include "app/commands/trail/spheres.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "core/anim/frames.h"
#include "rig/motion/paths.h"

namespace stretch::app {

namespace {

/// Nearer than this to a sphere there is no room for another one.
constexpr double leastGapFrames = 0.3;
constexpr double slopeStepFrames = 0.02;

} // namespace

std::vector<double> sphereFrames(Session& session) {
  const rig::Trail* const trail = selectedTrail(session);
  const rig::SolvedTrail* const solved = trail == nullptr ? nullptr : solvedTrail(session, trail->id);
  return solved == nullptr ? std::vector<double>{} : solved->controlFrames;
}

Status addSphere(Session& session, double frame) {
  const rig::Trail* const trail = selectedTrail(session);
  std::vector<double> frames = sphereFrames(session);
  if (trail == nullptr || frames.empty()) {
    return Error{"no trail is selected", "", "select a limb and press T or E to make one"};
  }
  if (frame < frames.front() || frame > frames.back()) {
    return Error{"the frame lies outside the trail's range", "", "move the playhead into the range"};
  }
  const auto near =
      std::ranges::find_if(frames, [&](double other) { return std::abs(other - frame) < leastGapFrames; });
  if (near != frames.end()) {
    session.view().selection.editTrails().spheres = {*near};
    return Success{};
  }
  frames.push_back(frame);
  Result<Document> changed = setControlFrames(session.document(), trail->id, std::move(frames));
  if (!changed) {
    return changed.error();
  }
  session.edit(std::move(changed).value(), "Add a sphere");
  session.view().selection.editTrails().spheres = {frame};
  return Success{};
}

Status removeSelectedSpheres(Session& session) {
  const std::vector<double> present = sphereFrames(session);
  const std::vector<double> selected = session.view().selection.spheres();
  const auto stays = [&](double frame) {
    return sameFrame(frame, present.front()) || sameFrame(frame, present.back());
  };
  const bool onlyBack = present.empty() || std::all_of(selected.begin(), selected.end(), stays);
  Result<Document> changed =
      removeSpheres(session.document(), session.view().selection.trail(), present, selected);
  if (!changed) {
    return changed.error();
  }
  session.edit(std::move(changed).value(), onlyBack ? "Put the spheres back" : "Remove the spheres");
  if (!onlyBack) {
    session.view().selection.dropSpheres();
  }
  return Success{};
}

std::vector<TangentHandle> tangentHandles(Session& session, double sphereFrame) {
  const rig::Trail* const trail = selectedTrail(session);
  const std::vector<double> frames = sphereFrames(session);
  const auto sphere =
      std::find_if(frames.begin(), frames.end(), [&](double frame) { return sameFrame(frame, sphereFrame); });
  if (trail == nullptr || !trail->exaggerated || sphere == frames.end()) {
    return {};
  }
  const double before = sphere == frames.begin() ? *sphere - 1.0 : *std::prev(sphere);
  const double after = std::next(sphere) == frames.end() ? *sphere + 1.0 : *std::next(sphere);
  const rig::MotionState& motion = session.motion();
  const Document& document = session.document();
  const rig::DrawnTrail drawn = rig::pathsAt(
      *document.scene, clipOf(document, session.view().clip), motion, *rig::placeOfTrail(motion, trail->id),
      {before, *sphere - slopeStepFrames, *sphere, *sphere + slopeStepFrames, after});
  const std::vector<Vec3>& path = drawn.exaggerated;
  std::vector<TangentHandle> handles;
  const auto add = [&](double neighbour, const Vec3& there, const Vec3& slope) {
    const double reach = (neighbour - *sphere) / 3.0;
    const Vec3 chord = there - path[2];
    const double length = glm::length(chord);
    handles.push_back({*sphere, reach, path[2], path[2] + reach * slope,
                       length > 0.0 ? chord / length : Vec3(1.0, 0.0, 0.0)});
  };
  if (sphere != frames.begin()) {
    add(before, path[0], (path[2] - path[1]) / slopeStepFrames);
  }
  if (std::next(sphere) != frames.end()) {
    add(after, path[4], (path[3] - path[2]) / slopeStepFrames);
  }
  return handles;
}

} // namespace stretch::app
