#include "app/commands/trail/applied.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/core.h>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"

namespace stretch::app {

namespace {

/// In frames: range and release.
Vec2 windowOf(const rig::SolvedTrail& solved, double framesPerSecond) {
  return {solved.windowStartSeconds * framesPerSecond, solved.windowEndSeconds * framesPerSecond};
}

/// Frames of the limb's keys in the window, on a loop those past the seam as well.
std::set<double> keysInside(Session& session, const rig::SolvedTrail& solved) {
  const rig::MotionState& motion = session.motion();
  constexpr double rounding = 0.01; // frames
  const Vec2 window = windowOf(solved, motion.framesPerSecond);
  const double turn = motion.loops ? (motion.endSeconds - motion.startSeconds) * motion.framesPerSecond : 0.0;
  std::set<double> keys;
  for (const double frame : shownKeyFrames(session, {solved.trail.limb})) {
    for (const double seen : {frame, frame + turn, frame - turn}) {
      if (window.x - rounding <= seen && seen <= window.y + rounding) {
        keys.insert(frame);
      }
    }
  }
  return keys;
}

bool isBetweenFrames(double frame) {
  constexpr double rounding = 0.01; // frames
  return std::abs(frame - std::round(frame)) > rounding;
}

std::string keysText(std::size_t count) {
  return fmt::format("{} key{}", count, count == 1 ? "" : "s");
}

} // namespace

std::string appliedText(Session& session, const std::vector<int>& trailIds) {
  std::string limbs;
  Vec2 frames(0.0);
  std::size_t keys = 0;
  std::size_t between = 0;
  std::size_t count = 0;
  for (const int id : trailIds) {
    const rig::SolvedTrail* const solved = solvedTrail(session, id);
    if (solved == nullptr) {
      continue;
    }
    const Vec2 window = windowOf(*solved, session.motion().framesPerSecond);
    frames = count == 0 ? window : Vec2(std::min(frames.x, window.x), std::max(frames.y, window.y));
    limbs += (count == 0 ? "" : ", ") + trailTitle(session.document(), solved->trail);
    const std::set<double> inside = keysInside(session, *solved);
    keys += inside.size();
    between += static_cast<std::size_t>(std::count_if(inside.begin(), inside.end(), isBetweenFrames));
    ++count;
  }
  const std::string who = count > 3 ? fmt::format("{} trails", count) : limbs;
  return fmt::format("{}, frames {:.4g} to {:.4g}: {}{}", who, frames.x, frames.y, keysText(keys),
                     between == 0 ? "" : fmt::format(", {} of them between frames", between));
}

std::vector<int> waitingTrails(const Session& session) {
  std::vector<int> waiting;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.clip == session.view().clip && trail.connected && !trail.applied) {
      waiting.push_back(trail.id);
    }
  }
  return waiting;
}

} // namespace stretch::app
