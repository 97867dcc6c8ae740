#include "app/edits/trail/starting_settings.h"

#include "app/standing_floor.h"
#include "rig/body/reading/planned_body.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

rig::LimbManner mannerOf(const Document& document, const std::string& limb) {
  const rig::PlannedLimb* const planned = plannedLimb(planOf(document.body), limb);
  return planned != nullptr ? planned->manner : rig::LimbManner{};
}

} // namespace

rig::TrailSettings usualTrail(const Document& document, const rig::Limb& limb) {
  const rig::LimbManner manner = mannerOf(document, limb.id);
  rig::TrailSettings settings;
  settings.overshoot = manner.overshoot;
  settings.turnEnd = manner.turnEnd;
  return settings;
}

rig::TrailSettings startingTrail(const Document& document, int clip, const rig::Limb& limb,
                                 const Vec2& rangeFrames) {
  rig::TrailSettings settings = usualTrail(document, limb);
  settings.startFrame = rangeFrames.x;
  settings.endFrame = rangeFrames.y;
  settings.space =
      rig::startingSpace(*document.scene, clipOf(document, clip), limb, document.body.hips, rangeFrames);
  if (mannerOf(document, limb.id).stands) {
    settings.stopAt = floorForLeg(document, clip, limb, rangeFrames.y);
  }
  return settings;
}

WeightSettings usualWeight(const Document& document, const std::string& limb) {
  const rig::LimbManner manner = mannerOf(document, limb);
  WeightSettings settings;
  settings.stiffness = manner.stiffness;
  settings.damping = manner.damping;
  return settings;
}

} // namespace stretch::app
