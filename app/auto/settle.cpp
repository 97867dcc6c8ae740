#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/auto/held_things.h"
#include "app/auto/planned_trail.h"
#include "app/auto/remedies.h"
#include "app/auto/whole_check.h"
#include "app/edits/trail/place_trails.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/stopped.h"
#include "app/evaluate/trail_look.h"
#include "app/evaluate/way_back.h"
#include "core/anim/frames.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

constexpr std::array<double, 5> shares{1.0, 0.75, 0.5, 0.35, 0.2}; // of the exaggeration that is wanted
constexpr double bothLead = 0.8; // of the stronger one: both sides do the same

// Degrees: the limb gets longer, and still goes where it went. Along the ground it gets longer by its turn
// alone. What a neck or a spine carries reaches far beyond it, and would be swung.
double turnLimitFor(const rig::TrailSettings& settings, bool isTrunk) {
  constexpr double most = 8.0;
  constexpr double mostLevel = 25.0;
  return !settings.axes[1] ? mostLevel : isTrunk ? 0.0 : most;
}

// What an animator would stumble over, in a few words; empty where there is nothing.
std::string problemOf(const Findings& findings) {
  return findings.lengths.any()                            ? textOf(FaultKind::lengths)
         : findings.turns.any()                            ? "it would point away from where it goes"
         : findings.vertices.any() || findings.edges.any() ? "the mesh would tear"
         : findings.swings.any() || findings.jumps.any()   ? "it would be carried away where it stops"
         : findings.elbows.any()                           ? "the elbow would rise above the head"
         : findings.bends.any()                            ? "a joint would bend the other way"
         : findings.ends.any() || findings.lows.any() || findings.floors.any() ? textOf(FaultKind::floor)
                                                                               : "";
}

// One trail by itself on the clip: solved with other settings until nothing is found.
class Trial {
public:
  Trial(const ClipGround& ground, bool loops) : ground_(ground), loops_(loops), facts_(ground.facts) {}

  // Lowers the trail until it looks right; answers why it cannot be done at all. A limb that the ground stops
  // is as long as it was: better less of it, or along the ground, than that.
  [[nodiscard]] std::string calm(PlannedTrail& planned) {
    rig::TrailSettings wanted = planned.trail.settings;
    const bool isTrunk = rig::isTrunk(*findLimb(ground_.document, planned.trail.limb));
    std::string first;
    for (const bool mayBeStopped : {false, true}) {
      for (const double share : shares) {
        for (const Variant& variant : variantsFor(planned, wanted)) {
          rig::TrailSettings tried = wanted;
          for (bool again = true; again; again = share == 1.0 && letGo(ground_, tried)) {
            planned.trail.settings = settingsOf(tried, share, variant, isTrunk);
            const std::string problem = problemWith(planned, mayBeStopped);
            first = first.empty() ? problem : first;
            if (problem.empty()) {
              planned.why = share < 1.0 && planned.why.empty() ? first : planned.why;
              planned.looked = planned.trail.settings;
              return {};
            }
          }
        }
        letGo(ground_, wanted); // less of it is not held
      }
    }
    return first;
  }

private:
  // What an animator would try before making it smaller.
  struct Variant {
    rig::TrailSpace space = rig::TrailSpace::world;
    bool stops = false;
    std::array<bool, 3> axes = allAxes;
    rig::Bend bend = rig::Bend::keep;
  };

  [[nodiscard]] static rig::TrailSettings settingsOf(const rig::TrailSettings& wanted, double share,
                                                     const Variant& variant, bool isTrunk) {
    rig::TrailSettings settings = withShare(wanted, share);
    settings.space = variant.space;
    settings.stopAt = variant.stops ? wanted.stopAt : std::nullopt;
    settings.axes = variant.axes;
    settings.bend = variant.bend;
    settings.turnLimitDegrees = turnLimitFor(settings, isTrunk);
    return settings;
  }

  // A leg stops at the ground where it can; another limb is stopped only where it would go through it. What
  // stays wrong is tried without the way up and down, then with its bend kept, or given up where it is bent
  // at the tip.
  [[nodiscard]] std::vector<Variant> variantsFor(const PlannedTrail& planned,
                                                 const rig::TrailSettings& wanted) const {
    const bool stopsFirst = isLeg(*findLimb(ground_.document, planned.trail.limb));
    std::vector<rig::TrailSpace> spaces{wanted.space};
    if (wanted.space != rig::TrailSpace::base) {
      spaces.push_back(rig::TrailSpace::base);
    }
    std::vector<std::array<bool, 3>> axes{wanted.axes};
    if (wanted.axes == allAxes) {
      axes.push_back(levelAxes);
    }
    std::vector<rig::Bend> bends{rig::Bend::keep};
    if (wanted.bend != rig::Bend::keep) {
      bends.insert(planned.isBent ? bends.end() : bends.begin(), wanted.bend);
    }
    std::vector<Variant> variants;
    for (const rig::Bend bend : bends) {
      for (const std::array<bool, 3>& active : axes) {
        for (const bool stops : {stopsFirst, !stopsFirst}) {
          for (const rig::TrailSpace space : spaces) {
            variants.push_back({space, stops, active, bend});
          }
        }
      }
    }
    return variants;
  }

  // Spheres go along with a range that has changed.
  static void pullAgain(PlannedTrail& planned) {
    if (const std::vector<rig::SphereOffset>& spheres = planned.trail.settings.spheres; !spheres.empty()) {
      pullAlong(planned, Vec3(spheres.back().offset));
    }
  }

  // A path that comes back on itself ends where it is farthest.
  [[nodiscard]] std::string problemWith(PlannedTrail& planned, bool mayBeStopped) {
    pullAgain(planned);
    std::shared_ptr<const rig::MotionState> alone = solved(planned.trail);
    if (alone->trails.empty()) {
      return "its range holds no frame";
    }
    if (!planned.follows && alone->trails.front().tip.moved &&
        endsFarther(alone->trails.front(), planned.trail.settings)) {
      pullAgain(planned);
      alone = solved(planned.trail);
    }
    if (!planned.follows && isCutShort(alone->trails.front().tip)) {
      const rig::TipSolution& tip = alone->trails.front().tip;
      planned.trail.settings.scale *= tip.reachedLength / tip.wantedLength;
      alone = solved(planned.trail);
    }
    const rig::SolvedTrail& trail = alone->trails.front();
    if (!planned.follows && trail.tip.outcome == rig::TipOutcome::nothingToScale) {
      return "the limb's end does not move along the active axes";
    }
    if (!planned.follows && !trail.warnings.empty()) {
      return "its path comes back on itself";
    }
    constexpr double largestOfPath = 1.5 * rig::largestScale;
    if (!planned.follows && trail.tip.trailScale && *trail.tip.trailScale > largestOfPath) {
      return "its path is too short for it";
    }
    if (!mayBeStopped && isStoppedAtTip(ground_.document, *alone, trail)) {
      return textOf(FaultKind::floor);
    }
    if (wayBackProblem(ground_.document, *alone, trail)) {
      return "there is no room for the way back";
    }
    if (!planned.follows && isAsLong(*alone, trail)) {
      return "hardly anything of it would be seen";
    }
    if (look_ == nullptr || limb_ != trail.limb.id) {
      look_ = std::make_unique<TrailLook>(facts_, trail, LookAt::limbAndMesh);
      limb_ = trail.limb.id;
    }
    return problemOf(look_->findings(*alone));
  }

  // Along the ground, by the limit of its turn.
  [[nodiscard]] static bool isCutShort(const rig::TipSolution& tip) {
    return tip.outcome == rig::TipOutcome::closest && tip.reachedLength < tip.wantedLength;
  }

  // As at the tip before, by what axes, ground and the turn's limit leave of it.
  [[nodiscard]] bool isAsLong(const rig::MotionState& alone, const rig::SolvedTrail& trail) const {
    const double before =
        rig::limbLength(trail.limb, evaluateOriginal(ground_.document, ground_.clip, trail.tipSeconds));
    const double after = rig::limbLength(trail.limb, evaluate(ground_.document, alone, trail.tipSeconds));
    return std::abs(after - before) < leastExcess * before;
  }

  [[nodiscard]] bool endsFarther(const rig::SolvedTrail& trail, rig::TrailSettings& settings) const {
    const auto farthest = static_cast<std::size_t>(std::max(0, trail.tip.farthestSample));
    const double frame = std::round(trail.path.samples[farthest].timeSeconds * ground_.framesPerSecond);
    if (frame - settings.startFrame < 2.0 || frame >= settings.endFrame) {
      return false;
    }
    const double earlier = settings.endFrame - frame;
    if (settings.releaseFrames) {
      settings.releaseFrames = *settings.releaseFrames + earlier;
      settings.lingerFrames += settings.lingerFrames > 0.0 ? earlier : 0.0;
    }
    settings.endFrame = frame;
    return true;
  }

  [[nodiscard]] std::shared_ptr<const rig::MotionState> solved(const rig::Trail& trail) {
    Document only = ground_.document;
    only.trails = {trail};
    only.trails.front().id = 1;
    only.weights.clear();
    only.holds = {};
    EvaluationInput input = evaluationInput(only, ground_.clip);
    input.ground.loops = input.ground.loops || loops_;
    rig::MotionInput wanted = motionInput(input);
    wanted.places = facts_->places();
    wanted.sameClip = last_.get();
    last_ = std::make_shared<const rig::MotionState>(rig::solveMotion(wanted));
    return last_;
  }

  const ClipGround& ground_;
  bool loops_ = false;
  std::shared_ptr<ClipFacts> facts_;
  std::shared_ptr<const rig::MotionState> last_; // solved
  std::unique_ptr<TrailLook> look_;
  std::string limb_; // that it looks at
};

// Way that the limb's end goes in a moment, seen from its base.
Vec3 wayOf(const ClipGround& ground, const rig::Moment& moment) {
  return ground.reachOf(moment.limb, moment.tipFrame) - ground.reachOf(moment.limb, moment.startFrame);
}

// Whether a limb does what that on the other side does, as a mirror shows it.
bool isMirrored(const ClipGround& ground, const rig::Moment& one, const rig::Moment& other) {
  constexpr double alike = 0.5; // cosine
  Vec3 apart(0.0);              // of both times: a torso is turned back and forth
  for (const double frame : {one.startFrame, other.startFrame}) {
    apart += ground.pointsOf(one.limb, frame).front() - ground.pointsOf(other.limb, frame).front();
  }
  const Vec3 way = wayOf(ground, one);
  const Vec3 across = wayOf(ground, other);
  const double square = glm::dot(apart, apart);
  const Vec3 mirrored = square > 0.0 ? way - 2.0 * glm::dot(way, apart) / square * apart : way;
  return glm::dot(mirrored, across) > alike * glm::length(way) * glm::length(across);
}

bool areAtOnce(const ClipGround& ground, const rig::Moment& one, const rig::Moment& other) {
  const double near = ground.framesPerSecond / 12.0;
  const double shared = std::min(one.tipFrame, other.tipFrame) - std::max(one.startFrame, other.startFrame);
  return std::abs(one.startFrame - other.startFrame) <= near &&
         (std::abs(one.tipFrame - other.tipFrame) <= near ||
          2.0 * shared >= std::max(one.tipFrame - one.startFrame, other.tipFrame - other.startFrame));
}

bool swingOneThing(const AutoPlan& plan, const PlannedTrail& one, const PlannedTrail& other) {
  const rig::TrailSettings& settings = one.trail.settings;
  return settings.startFrame == other.trail.settings.startFrame &&
         areOnProp(plan, one.trail.limb, other.trail.limb, settings.endFrame);
}

// A step on one side alone limps: each has one on the other side that goes the same way, and no larger one,
// where the other side steps at all. What both sides do at once, as arms that are thrown up, is as large on
// both.
void pairSides(const ClipGround& ground, const std::vector<rig::Moment>& moments,
               const AutoSettings& settings, AutoPlan& plan) {
  for (std::size_t i = plan.trails.size(); i-- > 0;) {
    PlannedTrail& one = plan.trails[i];
    const rig::Limb& limb = *findLimb(ground.document, one.trail.limb);
    const rig::Limb* const across = rig::limbAt(ground.document.body.limbs, rig::mirrored(limb));
    if (one.follows || limb.side == rig::LimbSide::middle || across == nullptr) {
      continue;
    }
    const bool goesRound = moments[one.moment].kind == rig::MomentKind::cycle;
    double most = 0.0;
    for (const PlannedTrail& other : plan.trails) {
      if (other.trail.limb == across->id && !other.follows &&
          (arePartners(ground, moments[one.moment], moments[other.moment]) ||
           swingOneThing(plan, one, other))) {
        most = std::max(most, excessOf(ground, other));
        one.trail.settings.bend =
            other.trail.settings.bend == rig::Bend::keep ? rig::Bend::keep : one.trail.settings.bend;
        one.trail.settings.axes[1] = one.trail.settings.axes[1] && other.trail.settings.axes[1];
      }
    }
    const auto goesRoundAcross = [&](const rig::Moment& other) {
      return other.limb == across->id && other.kind == rig::MomentKind::cycle;
    };
    const bool isAlone = isLeg(limb) && !goesRound && std::ranges::any_of(moments, [&](const auto& other) {
                           return std::min(other.strength, moments[one.moment].strength) >=
                                      bothLead * std::max(other.strength, moments[one.moment].strength) &&
                                  other.kind == moments[one.moment].kind &&
                                  arePartners(ground, moments[one.moment], other) &&
                                  overlappingTrail(ground.document, other.limb, ground.clip, other.startFrame,
                                                   other.endFrame) == nullptr;
                         });
    if (most <= 0.0 && (isAlone || (goesRound && (std::ranges::any_of(moments, goesRoundAcross) ||
                                                  std::ranges::any_of(settings.beside, goesRoundAcross))))) {
      leaveOut(plan, i, "the limb on the other side cannot do the same");
    } else if (most > 0.0 && excessOf(ground, one) > most) {
      one.trail.settings = withShare(one.trail.settings, most / excessOf(ground, one));
    }
  }
}

// What a limb does over and over, as a beat of wings or the steps of a cycle, is as large each time.
void evenRepeats(const ClipGround& ground, const std::vector<rig::Moment>& moments, AutoPlan& plan) {
  constexpr double same = 0.8; // cosine
  const auto doesTheSame = [&](const PlannedTrail& one, const PlannedTrail& other) {
    const Vec3 way = wayOf(ground, moments[one.moment]);
    const Vec3 again = wayOf(ground, moments[other.moment]);
    return one.trail.limb == other.trail.limb && !one.follows && !other.follows &&
           moments[one.moment].kind == rig::MomentKind::cycle &&
           moments[other.moment].kind == rig::MomentKind::cycle &&
           glm::dot(way, again) > same * std::max(glm::dot(way, way), glm::dot(again, again));
  };
  for (PlannedTrail& one : plan.trails) {
    for (const PlannedTrail& other : plan.trails) {
      const double least = excessOf(ground, other);
      // What is too little to be seen will be left out.
      if (least >= leastExcess && doesTheSame(one, other) && excessOf(ground, one) > least) {
        one.trail.settings = withShare(one.trail.settings, least / excessOf(ground, one));
      }
    }
  }
}

// What only goes along gains so many times as much, at most, as what leads beside it.
template <typename Leads, typename Follows>
void keepBeside(AutoPlan& plan, double most, const Leads& leads, const Follows& follows) {
  double led = 0.0;
  for (const PlannedTrail& planned : plan.trails) {
    led = std::max(led, !planned.follows && leads(planned) ? planned.trail.settings.scale - 1.0 : 0.0);
  }
  for (PlannedTrail& planned : plan.trails) {
    const double gain = planned.trail.settings.scale - 1.0;
    if (led >= leastExcess && gain > most * led && !planned.follows && follows(planned)) {
      planned.trail.settings = withShare(planned.trail.settings, most * led / gain);
    }
  }
}

// In a walk or a run the steps are the action, and arms swing along; where wings beat, it is what the body
// does, and they carry it.
void keepBesideAction(const ClipGround& ground, const std::vector<rig::Moment>& moments, AutoPlan& plan) {
  constexpr double armsBesideSteps = 2.0;
  const auto limbOf = [&](const PlannedTrail& planned) -> const rig::Limb& {
    return *findLimb(ground.document, planned.trail.limb);
  };
  const auto goesRound = [&](const PlannedTrail& planned) {
    return moments[planned.moment].kind == rig::MomentKind::cycle;
  };
  keepBeside(
      plan, armsBesideSteps, [&](const auto& step) { return goesRound(step) && isLeg(limbOf(step)); },
      [&](const auto& swing) { return goesRound(swing) && isArm(limbOf(swing)); });
  keepBeside(
      plan, 1.0, [&](const auto& act) { return isAct(limbOf(act), moments[act.moment]); },
      [&](const auto& beat) { return isBeat(limbOf(beat), moments[beat.moment]); });
}

// As Trial::calm; what is too little to be seen cannot be done.
std::string calmed(const ClipGround& ground, Trial& trial, PlannedTrail& planned) {
  return excessOf(ground, planned) >= leastExcess ? trial.calm(planned) : "the style hardly stretches it";
}

// Each trail that is not as it was looked at last, by itself; answers whether any is another one then.
bool calmEach(const ClipGround& ground, Trial& trial, AutoPlan& plan) {
  bool isChanged = false;
  for (std::size_t i = plan.trails.size(); i-- > 0;) {
    if (i >= plan.trails.size() || plan.trails[i].looked == plan.trails[i].trail.settings) {
      continue; // it went along with one that was left out, or nothing is new
    }
    const rig::TrailSettings before = plan.trails[i].trail.settings;
    const std::optional<rig::TrailSettings> looked = plan.trails[i].looked;
    std::string problem = calmed(ground, trial, plan.trails[i]);
    PlannedTrail less = plan.trails[i];
    less.trail.settings = withShare(looked.value_or(before), lowered);
    if (looked && looked->axes == allAxes && before.axes != allAxes &&
        (!problem.empty() || (before.axes[1] && excessOf(ground, plan.trails[i]) < excessOf(ground, less)))) {
      less.why = less.why.empty() && before.axes[1] ? textOf(FaultKind::sides) : less.why;
      plan.trails[i] = less; // without that axis it cannot be done, or much less of it
      problem = calmed(ground, trial, plan.trails[i]).empty() ? "" : problem;
    }
    isChanged = isChanged || !problem.empty() || !(plan.trails[i].trail.settings == before);
    if (!problem.empty()) {
      plan.trails[i].trail.settings = before;
      leaveOut(plan, i, problem);
    }
  }
  return isChanged;
}

} // namespace

bool arePartners(const ClipGround& ground, const rig::Moment& one, const rig::Moment& other) {
  constexpr double asStrong = 3.0;
  const rig::Limb* const limb = findLimb(ground.document, one.limb);
  const rig::Limb* const across =
      limb == nullptr ? nullptr : rig::limbAt(ground.document.body.limbs, rig::mirrored(*limb));
  if (across == nullptr || across == limb || across->id != other.limb) {
    return false;
  }
  const double ratio = one.strength / other.strength;
  const bool goRound = one.kind == rig::MomentKind::cycle;
  return ratio < asStrong && asStrong * ratio > 1.0 && (goRound || areAtOnce(ground, one, other)) &&
         isMirrored(ground, one, other);
}

void settle(const ClipGround& ground, const std::vector<rig::Moment>& moments, const AutoSettings& settings,
            AutoPlan& plan) {
  constexpr int mostRounds = 20; // of lowering; then each takes at least one trail out
  Trial trial(ground, plan.loops);
  for (int round = 0; !plan.trails.empty(); ++round) {
    pairSides(ground, moments, settings, plan);
    evenRepeats(ground, moments, plan);
    keepBesideAction(ground, moments, plan);
    const bool isChanged = calmEach(ground, trial, plan);
    const std::vector<Fault> faults = faultsOf(ground, settings, plan);
    if (faults.empty() && (!isChanged || round >= mostRounds)) {
      return;
    }
    std::set<std::size_t, std::greater<>> places;
    for (const Fault& fault : faults) {
      places.insert(fault.trail);
    }
    for (const std::size_t place : places) {
      if (place >= plan.trails.size()) {
        continue; // likewise
      }
      const auto fault = std::ranges::find(faults, place, &Fault::trail);
      if (round + 1 >= mostRounds) {
        leaveOut(plan, place, textOf(fault->kind));
      } else {
        lower(ground, plan, *fault);
      }
    }
  }
}

} // namespace stretch::app
