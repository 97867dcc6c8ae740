#include "app/auto/exaggerate_clip.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/auto/planned_trail.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/things/place.h"
#include "core/base/check.h"

namespace stretch::app {

namespace {

// Colours in turn, as trails that are made by hand have them.
Things thingsOf(const AutoPlan& plan) {
  Things things;
  for (const PlannedTrail& planned : plan.trails) {
    rig::Trail trail = planned.trail;
    trail.colour = static_cast<int>(things.trails.size()) % dealtColours;
    things.trails.push_back(std::move(trail));
  }
  things.holds.grips = plan.grips;
  return things;
}

AutoClip unchanged(const Document& document, const std::vector<rig::Moment>& moments, const char* why) {
  AutoClip clip{document, {}, {}, false, {}};
  for (const rig::Moment& moment : moments) {
    clip.moments.push_back({moment, 0, 1.0, why});
  }
  return clip;
}

// What hangs on the body and carries nothing gives way.
void addWeights(const AutoSettings& settings, int clip, AutoClip& made) {
  if (settings.style.weight.amount <= 0.0 || settings.strength <= 0.0) {
    return;
  }
  for (const int id : made.trailIds) {
    const rig::Limb& limb = *findLimb(made.document, findTrail(made.document, id)->limb);
    if (!reachesOut(limb) || isLeg(limb) || findWeight(made.document, limb.id, clip) != nullptr) {
      continue;
    }
    WeightedLimb weighted{limb.id, clip, true, {}};
    weighted.settings.amount = std::min(1.0, settings.strength * settings.style.weight.amount);
    weighted.settings.stiffness = settings.style.weight.stiffness;
    weighted.settings.damping = settings.style.weight.damping;
    if (Result<Document> changed = setWeight(made.document, weighted)) {
      made.document = std::move(*changed);
      made.notes.push_back(fmt::format("{} gives way to its weight", limb.id));
    }
  }
}

} // namespace

AutoClip exaggerateClip(const Document& document, int clip, const std::vector<rig::Moment>& moments,
                        const AutoSettings& settings) {
  if (moments.empty() || settings.strength <= 0.0) {
    return unchanged(document, moments, "the strength is 0");
  }
  const ClipGround ground = clipGround(document, clip);
  AutoPlan plan = planTrails(ground, moments, settings);
  settle(ground, moments, settings, plan);
  const Document looped = plan.loops ? setLooping(document, clip, true) : document;
  const Result<Placed> placed = place(looped, thingsOf(plan), Entry::request);
  if (!placed) {
    return unchanged(document, moments, placed.error().what.c_str());
  }
  AutoClip made{placed->document, {}, placed->trailIds, plan.loops && !isLooping(document, clip), {}};
  for (std::size_t i = 0; i < moments.size(); ++i) {
    made.moments.push_back({moments[i], 0, 1.0, plan.leftOut[i]});
  }
  for (std::size_t i = 0; i < plan.trails.size(); ++i) {
    const PlannedTrail& planned = plan.trails[i];
    if (planned.follows) {
      made.notes.push_back(
          fmt::format("the {} goes along with the {}", planned.trail.limb, moments[planned.moment].limb));
      continue;
    }
    made.moments[planned.moment] = {moments[planned.moment], placed->trailIds[i],
                                    planned.trail.settings.scale, planned.why};
  }
  for (const rig::Grip& grip : plan.grips) {
    made.notes.push_back(fmt::format("the hand of {} keeps to that of {}", grip.follower, grip.leader));
  }
  addWeights(settings, clip, made);
  return made;
}

} // namespace stretch::app
