#include "app/auto/exaggerate_clip.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "app/auto/held_things.h"
#include "app/auto/loop_seam.h"
#include "app/auto/planned_trail.h"
#include "app/auto/whole_check.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/pops.h"
#include "app/named.h"
#include "app/things/place.h"
#include "core/base/check.h"
#include "rig/motion/solve_holds.h"

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
  things.holds = plan.holds;
  return things;
}

AutoClip unchanged(const Document& document, const std::vector<rig::Moment>& moments, const char* why) {
  AutoClip clip{document, {}, {}, false, {}};
  for (const rig::Moment& moment : moments) {
    clip.moments.push_back({moment, 0, 1.0, false, why});
  }
  return clip;
}

// What hangs on the body and carries nothing gives way.
AutoClip withWeights(const AutoSettings& settings, int clip, AutoClip made) {
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
      made.document = std::move(*changed); // with its limbs, so that `limb` is gone
      made.notes.push_back(fmt::format("{} gives way to its weight", weighted.limb));
    }
  }
  return made;
}

// Whether limbs that give way hang lower than they may, and lower than without, in any frame.
bool hangsLower(const ClipGround& ground, const Document& plain, const rig::MotionState& before,
                const Document& weighted, const rig::MotionState& after) {
  const double seen = 1e-3 * ground.document.body.height;
  for (double frame = 0.0; frame <= ground.lastFrame; frame += 1.0) {
    const double seconds = frame / ground.framesPerSecond;
    const std::optional<Vec3> without = ground.lowestVertexIn(evaluate(plain, before, seconds));
    const std::optional<Vec3> with = ground.lowestVertexIn(evaluate(weighted, after, seconds));
    if (with && without && with->y < std::min(ground.leastHeightAt(frame), without->y) - seen) {
      return true;
    }
  }
  return false;
}

// Empty where limbs that give way hang no lower and close a loop no worse than without.
std::string problemOfWeight(const ClipGround& ground, const Document& plain, const Document& weighted) {
  const rig::MotionState before = prepareMotion(plain, ground.clip);
  const rig::MotionState after = prepareMotion(weighted, ground.clip);
  if (hangsLower(ground, plain, before, weighted, after)) {
    return "it would hang through the floor";
  }
  const LoopSeam source = seamOfSource(ground);
  const LoopSeam now = seamOf(ground, weighted, after);
  for (std::size_t i = 0; ground.endsMeet && i < ground.limbs.size(); ++i) {
    if (closesWorse(ground, now, source, i)) {
      return textOf(FaultKind::seam);
    }
  }
  return {};
}

// Weight of a clip that ends as it begins goes on over its seam. None is given where something would hang
// through the floor, or the loop close worse.
void addWeights(const AutoSettings& settings, const ClipGround& ground, AutoClip& made) {
  if (settings.style.weight.amount <= 0.0) {
    return;
  }
  AutoClip weighted = withWeights(settings, ground.clip, made);
  if (weighted.notes.size() == made.notes.size()) {
    return;
  }
  if (ground.endsMeet && !isLooping(weighted.document, ground.clip)) {
    weighted.document = setLooping(weighted.document, ground.clip, true);
    weighted.madeLoop = true;
  }
  if (const std::string problem = problemOfWeight(ground, made.document, weighted.document);
      !problem.empty()) {
    made.notes.push_back("no limb gives way to its weight: " + problem);
    return;
  }
  made = std::move(weighted);
}

// Limbs that flip or pop in what was made.
void tellPops(int clip, AutoClip& made) {
  for (const LimbPop& pop : limbPops(made.document, prepareMotion(made.document, clip))) {
    made.notes.push_back(popWarning(pop));
  }
}

// The settled plan. What could not be done takes no room from others, and makes none of them weak: all are
// planned again without it.
AutoPlan settledPlan(const ClipGround& ground, const std::vector<rig::Moment>& moments,
                     const AutoSettings& settings) {
  std::map<std::size_t, std::string> refused;
  while (true) {
    AutoPlan plan = planTrails(ground, moments, settings, refused);
    const std::vector<PlannedTrail> tried = plan.trails;
    settle(ground, moments, settings, plan);
    const std::size_t before = refused.size();
    for (const PlannedTrail& planned : tried) {
      if (!plan.leftOut[planned.moment].empty()) {
        refused.emplace(planned.moment, plan.leftOut[planned.moment]);
      }
    }
    if (refused.size() == before) {
      return plan;
    }
  }
}

} // namespace

std::string remarkOn(bool isExaggerated, bool isLevel, const std::string& why) {
  if (!isExaggerated) {
    return why;
  }
  const std::string ground = isLevel ? "along the ground" : "";
  const std::string more = why.empty() ? "" : "with more " + why;
  return ground + (ground.empty() || more.empty() ? "" : ", ") + more;
}

AutoClip exaggerateClip(const Document& document, int clip, const std::vector<rig::Moment>& moments,
                        const AutoSettings& settings) {
  if (moments.empty() || settings.strength <= 0.0) {
    return unchanged(document, moments, "the strength is 0");
  }
  ClipGround ground = clipGround(document, clip);
  const auto goesRound = [](const rig::Moment& moment) { return moment.kind == rig::MomentKind::cycle; };
  if (ground.nearlyMeets &&
      (std::ranges::any_of(moments, goesRound) || std::ranges::any_of(settings.beside, goesRound))) {
    ground.closeLoop(); // though a foot is not quite back in its place
  }
  AutoPlan plan = settledPlan(ground, moments, settings);
  std::erase_if(plan.holds.props, [&](const rig::Prop& prop) {
    return std::ranges::none_of(
        plan.trails, [&](const PlannedTrail& planned) { return isHeldBy(prop, planned.trail.limb); });
  });
  plan.loops = plan.loops && std::ranges::any_of(plan.trails, [&](const PlannedTrail& planned) {
                 const rig::TrailSettings& own = planned.trail.settings;
                 return windowOf(own).y > ground.lastFrame || own.endFrame >= ground.lastFrame;
               });
  const Document looped = plan.loops ? setLooping(document, clip, true) : document;
  const Result<Placed> placed = place(looped, thingsOf(plan), Entry::request);
  if (!placed) {
    return unchanged(document, moments, placed.error().what.c_str());
  }
  AutoClip made{placed->document, {}, placed->trailIds, plan.loops && !isLooping(document, clip), {}};
  for (std::size_t i = 0; i < moments.size(); ++i) {
    made.moments.push_back({moments[i], 0, 1.0, false, plan.leftOut[i]});
  }
  for (std::size_t i = 0; i < plan.trails.size(); ++i) {
    const PlannedTrail& planned = plan.trails[i];
    if (planned.follows) {
      made.notes.push_back(
          fmt::format("the {} goes along with the {}", planned.trail.limb, moments[planned.moment].limb));
      continue;
    }
    const bool wasLevel = settings.style.axes == rig::AxesRule::level;
    made.moments[planned.moment] = {moments[planned.moment], placed->trailIds[i],
                                    planned.trail.settings.scale,
                                    !wasLevel && !planned.trail.settings.axes[1], planned.why};
  }
  for (const rig::Prop& prop : plan.holds.props) {
    const NodeIndex thing = rig::propNode(*document.scene, prop.node);
    made.notes.push_back(fmt::format("{} stays in hand", nodeTitle(document, thing)));
  }
  for (const rig::Grip& grip : plan.holds.grips) {
    made.notes.push_back(fmt::format("the hand of {} keeps to that of {}", grip.follower, grip.leader));
  }
  addWeights(settings, ground, made);
  tellPops(clip, made);
  return made;
}

} // namespace stretch::app
