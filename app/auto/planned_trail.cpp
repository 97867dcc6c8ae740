#include "app/auto/planned_trail.h"

#include "rig/trail/release.h"

namespace stretch::app {

bool isChain(const rig::Limb& limb) {
  return rig::isTrunk(limb) || limb.kind == rig::LimbKind::tail || limb.kind == rig::LimbKind::feeler;
}

double fullStrengthOf(const rig::Limb& limb) {
  return isChain(limb) ? fullChain : fullStrength;
}

Vec2 windowOf(const rig::TrailSettings& settings) {
  const double range = settings.endFrame - settings.startFrame;
  return {settings.startFrame, settings.endFrame + settings.releaseFrames.value_or(range)};
}

bool isBeat(const rig::Limb& limb, const rig::Moment& moment) {
  return limb.kind == rig::LimbKind::wing && moment.kind == rig::MomentKind::cycle;
}

bool isAct(const rig::Limb& limb, const rig::Moment& moment) {
  constexpr double least = 0.4; // of what is full for its kind: less is a nod
  return moment.kind == rig::MomentKind::stroke && limb.kind != rig::LimbKind::wing && !isChain(limb) &&
         moment.strength >= least * fullStrength;
}

rig::TrailSettings withShare(rig::TrailSettings wanted, double share) {
  wanted.scale = 1.0 + share * (wanted.scale - 1.0);
  for (rig::SphereOffset& sphere : wanted.spheres) {
    sphere.offset *= share;
  }
  return wanted;
}

void pullAlong(PlannedTrail& planned, const Vec3& pull) {
  constexpr int spheres = 4;
  rig::TrailSettings& settings = planned.trail.settings;
  settings.spheres.clear();
  planned.trail.controlFrames.clear();
  for (int i = 0; i <= spheres; ++i) {
    const double part = static_cast<double>(i) / spheres;
    const double frame = settings.startFrame + part * (settings.endFrame - settings.startFrame);
    settings.spheres.push_back({frame, rig::smoothstep(part) * pull, {}});
    planned.trail.controlFrames.push_back(frame);
  }
}

void leaveOut(AutoPlan& plan, std::size_t place, const std::string& why) {
  const PlannedTrail planned = plan.trails[place];
  plan.trails.erase(plan.trails.begin() + static_cast<std::ptrdiff_t>(place));
  if (planned.follows) {
    return;
  }
  plan.leftOut[planned.moment] = why;
  std::erase_if(plan.trails, [&](const PlannedTrail& other) { return other.moment == planned.moment; });
  std::erase_if(plan.holds.grips, [&](const rig::Grip& grip) {
    return grip.leader == planned.trail.limb && grip.time.rangeFrames.x == planned.trail.settings.startFrame;
  });
}

} // namespace stretch::app
