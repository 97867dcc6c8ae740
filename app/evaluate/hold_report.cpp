#include "app/evaluate/hold_report.h"

#include <algorithm>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/motion/apply_holds.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

HoldReport& reportOf(std::vector<HoldReport>& reports, const rig::HeldGoal& goal, const std::string& limb) {
  const auto known = std::ranges::find_if(reports, [&](const HoldReport& report) {
    return report.kind == goal.kind && report.index == goal.index && report.limb == limb;
  });
  return known != reports.end() ? *known : reports.emplace_back(HoldReport{goal.kind, goal.index, limb});
}

// What a hold that holds fully is missed by at a frame.
void noteMiss(const rig::HeldGoal& goal, double frame, double miss, double seen, HoldReport& report) {
  double& farthest = goal.overriddenBy ? report.farthestOverridden : report.farthest;
  farthest = std::max(farthest, miss);
  if (miss <= seen) {
    return;
  }
  if (goal.overriddenBy) {
    report.framesOverridden.push_back(frame);
    report.overriddenBy = *goal.overriddenBy;
  } else {
    report.framesFallShort.push_back(frame);
  }
}

} // namespace

std::vector<double> halfFramesOf(const rig::MotionState& motion) {
  constexpr double most = 20000.0;
  const double last = std::min(motion.endSeconds * motion.framesPerSecond, most);
  std::vector<double> frames;
  for (double frame = 0.0; frame <= last + frameTolerance; frame += 0.5) {
    frames.push_back(frame);
  }
  return frames;
}

std::vector<HoldReport> holdReports(const Document& document, const rig::MotionState& motion) {
  constexpr double seen = 1e-3; // of the height
  std::vector<HoldReport> reports;
  if (motion.holds.empty()) {
    return reports;
  }
  const Clip& clip = clipOf(document, motion.clip);
  for (const double frame : halfFramesOf(motion)) {
    FrameState state = rig::adjustedFrame(*document.scene, clip, motion, frame / clip.framesPerSecond);
    std::vector<rig::HeldGoal> goals = rig::applyTrailsAndHolds(*document.scene, motion, state);
    rig::applyAfterHolds(*document.scene, motion, goals, state);
    for (const rig::HeldGoal& goal : goals) {
      const rig::Limb& limb = motion.holds.limbs[goal.limb].limb;
      HoldReport& report = reportOf(reports, goal, limb.id);
      report.strength = std::max(report.strength, goal.strength);
      if (goal.strength >= 1.0) {
        const double miss = glm::length(rig::endPosition(limb, state) - goal.wanted);
        noteMiss(goal, frame, miss, seen * document.body.height, report);
      }
    }
  }
  return reports;
}

std::string holdWarning(const HoldReport& report) {
  if (report.framesFallShort.empty()) {
    return {};
  }
  return fmt::format(
      "the {} of {} falls short at frames {:g} to {:g} by up to {:.4g}: let it stretch, or move "
      "what it holds to",
      holdWord(report.kind), report.limb, report.framesFallShort.front(), report.framesFallShort.back(),
      report.farthest);
}

std::string overrideWarning(const HoldReport& report) {
  if (report.framesOverridden.empty()) {
    return {};
  }
  return fmt::format("the {} of {} is left by up to {:.4g} at frames {:g} to {:g}: {} {} decides there",
                     holdWord(report.kind), report.limb, report.farthestOverridden,
                     report.framesOverridden.front(), report.framesOverridden.back(),
                     report.overriddenBy == report.kind ? "another" : "the", holdWord(report.overriddenBy));
}

const char* holdWord(rig::HoldKind kind) {
  switch (kind) {
  case rig::HoldKind::pin:
    return "pin";
  case rig::HoldKind::grip:
    return "grip";
  case rig::HoldKind::prop:
    return "prop";
  }
  return "";
}

} // namespace stretch::app
