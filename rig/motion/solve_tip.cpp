#include "rig/motion/solve_steps.h"

#include <cmath>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rig/motion/range_offset.h"

namespace stretch::rig {

namespace {

// Of two frames, beyond the rounding of key times.
bool differs(double frame, double other) {
  return std::abs(frame - other) > 0.01;
}

// The clip may end between its last frame and the one before: a range to the last frame is not cut.
bool endsInLastFrame(const SolvedTrail& solved) {
  const double beyond = solved.trail.settings.endFrame - solved.settings.endFrame;
  return beyond >= 0.0 && beyond <= 0.5;
}

// The camera in the trail's space.
std::optional<SightWish> sightOf(const SolvedTrail& solved, const LimbSample& tip) {
  const Sight& sight = solved.settings.sight;
  if (!solved.camera) {
    return std::nullopt;
  }
  const CameraPlace& camera = *solved.camera;
  const Mat3 toSpace = glm::transpose(solved.path.axes);
  const CameraPlace inSpace{camera.kind, solved.path.toSpace(tip, camera.position), toSpace * camera.right,
                            toSpace * camera.up, toSpace * camera.forward};
  return SightWish{inSpace, sight.asSeen, sight.keepDepth, sight.turnDegrees * pi / 180.0};
}

std::string seenProblem(const SolvedTrail& solved) {
  const LimbSample& tip = tipSample(solved);
  if (!(seenLength(*solved.camera, tip.base, tip.end).value_or(0.0) > 1e-12)) {
    return "not reachable as seen: the limb points straight at the camera, or is not in front of it";
  }
  return fmt::format("not reachable as seen: x{:.3g} of x{:g}", solved.tip.seen->seen, solved.settings.scale);
}

} // namespace

void solveTipOf(SolvedTrail& solved) {
  const LimbSample& tip = tipSample(solved);
  TipProblem problem;
  for (const LimbSample& sample : solved.path.samples) {
    problem.points.push_back(solved.path.toSpace(sample, sample.end));
  }
  for (const LimbSample& sample : solved.path.between) {
    problem.between.push_back(solved.path.toSpace(sample, sample.end));
  }
  const double poseLength = glm::length(tip.end - tip.base);
  problem.basePosition = solved.path.toSpace(tip, tip.base);
  problem.limbLength = solved.settings.reference == Reference::pose ? poseLength : solved.limb.restLength;
  problem.scale = solved.settings.scale;
  problem.axes = solved.settings.axes;
  problem.pivot = solved.settings.pivot;
  problem.pull = solved.settings.pull;
  problem.turnLimitRadians = solved.settings.turnLimitDegrees * pi / 180.0;
  problem.sight = sightOf(solved, tip);
  solved.tip = solveTip(problem);
}

void explainTip(SolvedTrail& solved, double framesPerSecond) {
  const TipSolution& tip = solved.tip;
  if (solved.trail.settings.scale < smallestScale) {
    solved.warnings.push_back(
        fmt::format("scale {:g} is taken as {:g}", solved.trail.settings.scale, smallestScale));
  }
  if (solved.settings.endFrame - solved.settings.startFrame >= longestFrames) {
    solved.warnings.push_back(fmt::format("the range is cut to {:g} frames", longestFrames));
  } else if (differs(solved.settings.startFrame, solved.trail.settings.startFrame) ||
             (differs(solved.settings.endFrame, solved.trail.settings.endFrame) &&
              !endsInLastFrame(solved))) {
    solved.warnings.push_back(fmt::format("the range is cut to the frames {:g} to {:g}, which the clip has",
                                          solved.settings.startFrame, solved.settings.endFrame));
  }
  if (!solved.camera && solved.settings.sight.hasCamera()) {
    solved.warnings.push_back(
        fmt::format("there is no camera '{}' to look through{}", solved.settings.sight.camera,
                    solved.settings.sight.asSeen ? ": the scale counts in the limb's own length" : ""));
  }
  if (solved.settings.scale == 1.0 && !solved.settings.spheres.empty()) {
    return; // pulled alone: no length was asked for
  }
  if (tip.outcome == TipOutcome::nothingToScale) {
    solved.warnings.emplace_back(
        "nothing to scale: the limb's end does not move along the active axes in this range");
  } else if (tip.seen && !tip.reached()) {
    solved.warnings.push_back(seenProblem(solved));
  } else if (!tip.reached()) {
    solved.warnings.push_back(
        fmt::format("not reachable: the limb gets to {:.4g} of {:.4g}", tip.reachedLength, tip.wantedLength));
  }
  const std::size_t tipIndex =
      solved.settings.pivot == Pivot::start ? solved.path.samples.size() - 1 : std::size_t{0};
  if (tip.moved && at(tip.farthestSample) == tipIndex) {
    solved.warnings.emplace_back(
        "the limb's end strays between the frames from where it is on them: its path is moved as a whole");
  } else if (tip.moved) {
    const double frame = solved.path.samples[at(tip.farthestSample)].timeSeconds * framesPerSecond;
    solved.warnings.push_back(
        fmt::format("the path comes back on itself and is moved as a whole; a range that ends at frame "
                    "{:g}, where the limb's end is farthest from the pivot, would be scaled",
                    frame));
  }
}

} // namespace stretch::rig
