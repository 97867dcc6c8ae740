#include "app/auto/whole_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "app/auto/held_things.h"
#include "app/auto/loop_seam.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/things/place.h"
#include "rig/motion/order.h"

namespace stretch::app {

namespace {

constexpr double margin = 0.004;          // of the height: less is not seen
constexpr double floorMargin = 0.001;     // of the height
constexpr double shorter = 1.5;           // a limb that turns on its way may come nearer than it is squashed
constexpr double besideEachOther = 0.5;   // of a limb: the ends of two that could meet
constexpr double againstEachOther = -0.3; // cosine between the ways of two limbs of one chain

// The clip with a plan's trails, or with all but one of them.
struct Attempt {
  Document document;
  rig::MotionState motion;
};

class WholeCheck {
public:
  WholeCheck(const ClipGround& ground, const AutoSettings& settings, const AutoPlan& plan)
      : ground_(ground), settings_(settings), plan_(plan), whole_(attemptWithout(plan.trails.size())) {}

  [[nodiscard]] std::vector<Fault> faults() {
    for (double frame = 0.0; frame <= ground_.lastFrame; frame += 1.0) {
      if (!actingAt(frame).empty()) {
        lookAt(frame);
      }
    }
    lookAtChains();
    if (ground_.endsMeet) {
      lookAtSeam();
    }
    std::vector<Fault> faults;
    for (const auto& [trail, kind] : faults_) {
      faults.push_back({trail, kind, depths_[trail]});
    }
    return faults;
  }

private:
  [[nodiscard]] Attempt attemptWithout(std::size_t left) const {
    Document document = plan_.loops ? setLooping(ground_.document, ground_.clip, true) : ground_.document;
    document.weights.clear();
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) {
      if (i != left) {
        document.trails.push_back(plan_.trails[i].trail);
        document.trails.back().id = ground_.document.nextTrailId + static_cast<int>(i);
      }
    }
    document.holds.grips.insert(document.holds.grips.end(), plan_.holds.grips.begin(),
                                plan_.holds.grips.end());
    document.holds.props.insert(document.holds.props.end(), plan_.holds.props.begin(),
                                plan_.holds.props.end());
    rig::MotionState motion = prepareMotion(document, ground_.clip);
    return {std::move(document), std::move(motion)};
  }

  [[nodiscard]] FrameState shown(const Attempt& attempt, double seconds) const {
    return evaluate(attempt.document, attempt.motion, seconds);
  }

  [[nodiscard]] std::vector<std::size_t> actingAt(double frame) const {
    std::vector<std::size_t> acting;
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) {
      const Vec2 window = windowOf(plan_.trails[i].trail.settings);
      const bool wraps = plan_.loops && ground_.aTurnLater(frame) <= window.y;
      if ((window.x <= frame && frame <= window.y) || wraps) {
        acting.push_back(i);
      }
    }
    return acting;
  }

  [[nodiscard]] bool moves(const PlannedTrail& planned, const rig::Limb& limb) const {
    const rig::Limb* const own = findLimb(ground_.document, planned.trail.limb);
    const bool grips = std::ranges::any_of(plan_.holds.grips, [&](const rig::Grip& grip) {
      return grip.leader == planned.trail.limb && grip.follower == limb.id;
    });
    const bool holds = std::ranges::any_of(plan_.holds.props, [&](const rig::Prop& prop) {
      return isHeldBy(prop, planned.trail.limb) && isHeldBy(prop, limb.id);
    });
    return planned.trail.limb == limb.id || grips || holds ||
           (own != nullptr && rig::carries(*ground_.document.scene, *own, limb));
  }

  // Those that move the limb on any of these frames: the last of the plan first, which are its weakest and
  // what goes along.
  [[nodiscard]] std::vector<std::size_t> suspects(const std::vector<double>& frames,
                                                  const rig::Limb& limb) const {
    std::vector<std::size_t> found;
    for (std::size_t place = plan_.trails.size(); place-- > 0;) {
      const bool acts = std::ranges::any_of(frames, [&](double frame) {
        const std::vector<std::size_t> acting = actingAt(frame);
        return std::ranges::find(acting, place) != acting.end();
      });
      if (acts && moves(plan_.trails[place], limb)) {
        found.push_back(place);
      }
    }
    return found;
  }

  // Trails of the limb that act at the frame.
  void deepen(double frame, const rig::Limb& limb, double depth) {
    for (const std::size_t place : actingAt(frame)) {
      if (plan_.trails[place].trail.limb == limb.id) {
        depths_[place] = std::max(depths_[place], depth);
      }
    }
  }

  // Of several trails it is the weakest without which nothing is wrong; all of them where none does it alone.
  template <typename IsWrong>
  void blame(const std::vector<double>& frames, const rig::Limb& limb, FaultKind kind,
             const IsWrong& isWrong) {
    const std::vector<std::size_t> asked = suspects(frames, limb);
    if (!judged_.emplace(limb.id, kind, asked).second) {
      return; // what is wrong on the frames beside has been looked into
    }
    const auto guilty =
        asked.size() < 2
            ? asked.begin()
            : std::ranges::find_if(asked, [&](std::size_t place) { return !isWrong(withoutTrail(place)); });
    for (auto place = asked.begin(); place != asked.end(); ++place) {
      if (guilty == asked.end() || place == guilty) {
        faults_.emplace(*place, kind);
      }
    }
  }

  [[nodiscard]] const Attempt& withoutTrail(std::size_t place) {
    const auto found = without_.find(place);
    return found != without_.end() ? found->second
                                   : without_.emplace(place, attemptWithout(place)).first->second;
  }

  void lookAt(double frame) {
    const FrameState frameState = shown(whole_, frame / ground_.framesPerSecond);
    const LimbPlaces now = placesOf(ground_.limbs, frameState);
    lookAtMesh(frame, frameState, now);
    for (std::size_t i = 0; i < ground_.limbs.size(); ++i) {
      if (const std::optional<FaultKind> problem = problemOf(frame, i, now)) {
        if (problem == FaultKind::floor) {
          deepen(frame, ground_.limbs[i], ground_.lowest - lowestOf({now[i]}));
        }
        blame({frame}, ground_.limbs[i], *problem, [&](const Attempt& attempt) {
          const FrameState other = shown(attempt, frame / ground_.framesPerSecond);
          return problemOf(frame, i, placesOf(ground_.limbs, other)).has_value();
        });
      }
    }
  }

  [[nodiscard]] bool isBelowFloor(double frame, const std::optional<Vec3>& vertex) const {
    return vertex && vertex->y < ground_.leastHeightAt(frame) - floorMargin * ground_.document.body.height;
  }

  // What lies below the floor hangs on the limb that it is nearest to.
  void lookAtMesh(double frame, const FrameState& frameState, const LimbPlaces& now) {
    const std::optional<Vec3> vertex = ground_.lowestVertexIn(frameState);
    if (!isBelowFloor(frame, vertex)) {
      return;
    }
    const rig::Limb* nearest = nullptr;
    double least = 0.0;
    for (const std::size_t place : actingAt(frame)) {
      const auto limb = std::ranges::find(ground_.limbs, plan_.trails[place].trail.limb, &rig::Limb::id);
      for (const Vec3& point : now[static_cast<std::size_t>(limb - ground_.limbs.begin())]) {
        const double distance = glm::length(point - *vertex);
        if (nearest == nullptr || distance < least) {
          nearest = &*limb;
          least = distance;
        }
      }
    }
    if (nearest != nullptr) {
      deepen(frame, *nearest, ground_.leastHeightAt(frame) - vertex->y);
      blame({frame}, *nearest, FaultKind::floor, [&](const Attempt& attempt) {
        return isBelowFloor(frame, ground_.lowestVertexIn(shown(attempt, frame / ground_.framesPerSecond)));
      });
    }
  }

  // Whether the ends of limbs of two sides, near each other, have changed sides along the line between their
  // bases. Hands that hold one thing do as that does.
  [[nodiscard]] bool changesSides(double frame, std::size_t place, const LimbPlaces& places) const {
    const rig::Limb& limb = ground_.limbs[place];
    const rig::Limb* const across = rig::limbAt(ground_.limbs, rig::mirrored(limb));
    if (limb.side == rig::LimbSide::middle || across == nullptr || areTogether(limb.id, across->id)) {
      return false;
    }
    const auto other = static_cast<std::size_t>(across - ground_.limbs.data());
    const LimbPlaces& source = ground_.placesAt(frame);
    const Vec3 bases = source[place].front() - source[other].front();
    const double length = glm::length(bases);
    const Vec3 before = source[place].back() - source[other].back();
    const Vec3 after = places[place].back() - places[other].back();
    const double unseen = margin * ground_.document.body.height * length;
    const bool changes = glm::dot(before, bases) > unseen && glm::dot(after, bases) < -unseen;
    return changes && glm::length(after - glm::dot(after, bases) / (length * length) * bases) <
                          besideEachOther * limb.restLength;
  }

  [[nodiscard]] bool areTogether(const std::string& arm, const std::string& other) const {
    const auto holds = [&](const rig::Grip& grip) {
      return (grip.leader == arm && grip.follower == other) || (grip.leader == other && grip.follower == arm);
    };
    return std::ranges::any_of(plan_.holds.grips, holds) ||
           std::ranges::any_of(plan_.holds.props, [&](const rig::Prop& prop) {
             return isHeldBy(prop, arm) && isHeldBy(prop, other);
           });
  }

  // A body without legs lies on the ground with some of it.
  [[nodiscard]] bool isLifted(double frame, const LimbPlaces& places) const {
    constexpr double lies = 0.1;  // of the height
    constexpr double seen = 0.02; // of the height
    const double source = lowestOf(ground_.placesAt(frame));
    const double height = ground_.document.body.height;
    return std::ranges::none_of(ground_.limbs, [](const rig::Limb& limb) { return isLeg(limb); }) &&
           source < ground_.lowest + lies * height && lowestOf(places) > source + seen * height;
  }

  // Nothing where the limb looks right.
  [[nodiscard]] std::optional<FaultKind> problemOf(double frame, std::size_t place,
                                                   const LimbPlaces& places) const {
    const rig::Limb& limb = ground_.limbs[place];
    const std::vector<Vec3>& source = ground_.placesAt(frame)[place];
    const std::vector<Vec3>& now = places[place];
    const double height = ground_.document.body.height;
    const rig::ScaleRange& range = rig::scalesOf(settings_.style, limb.kind);
    const double before = straightLength(source);
    const double after = straightLength(now);
    const double unseen = margin * height;
    if (after > range.most * std::max(before, limb.restLength) + unseen ||
        after < std::min(1.0, range.least) * before / shorter - unseen) {
      return FaultKind::lengths;
    }
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (now[k].y < std::min(source[k].y, ground_.lowest) - unseen) {
        return FaultKind::floor;
      }
    }
    if (changesSides(frame, place, places)) {
      return FaultKind::sides;
    }
    if (isTrunk(limb) && isLifted(frame, places)) {
      return FaultKind::lifted;
    }
    const bool stands = std::ranges::any_of(
        ground_.standsOf(limb.id), [&](const Vec2& stand) { return stand.x <= frame && frame <= stand.y; });
    return stands && glm::length(now.back() - source.back()) > unseen ? std::optional(FaultKind::stand)
                                                                      : std::nullopt;
  }

  // The way of the limb's tip, from where the source has it.
  [[nodiscard]] Vec3 wayOf(std::size_t place) const {
    const int id = ground_.document.nextTrailId + static_cast<int>(place);
    const auto solved = std::ranges::find_if(
        whole_.motion.trails, [&](const rig::SolvedTrail& trail) { return trail.trail.id == id; });
    const PlannedTrail& planned = plan_.trails[place];
    const std::vector<rig::SphereOffset>& spheres = planned.trail.settings.spheres;
    return solved == whole_.motion.trails.end() ? Vec3(0.0)
           : planned.trail.settings.scale == 1.0 && !spheres.empty()
               ? spheres.back().offset
               : solved->tip.tip - solved->tip.originalTip;
  }

  void lookAtChains() {
    for (std::size_t inner = 0; inner < plan_.trails.size(); ++inner) {
      const rig::Limb& carrier = *findLimb(ground_.document, plan_.trails[inner].trail.limb);
      for (std::size_t outer = 0; outer < plan_.trails.size(); ++outer) {
        const rig::Limb& limb = *findLimb(ground_.document, plan_.trails[outer].trail.limb);
        const Vec2 a = windowOf(plan_.trails[inner].trail.settings);
        const Vec2 b = windowOf(plan_.trails[outer].trail.settings);
        if (inner == outer || a.y <= b.x || b.y <= a.x ||
            !rig::carries(*ground_.document.scene, carrier, limb)) {
          continue;
        }
        const Vec3 first = wayOf(inner);
        const Vec3 second = wayOf(outer);
        const double lengths = glm::length(first) * glm::length(second);
        if (lengths > 0.0 && glm::dot(first, second) < againstEachOther * lengths) {
          faults_.emplace(std::max(inner, outer), FaultKind::chain);
        }
      }
    }
  }

  void lookAtSeam() {
    const auto seamWith = [&](const Attempt& attempt) {
      return seamOf(ground_, attempt.document, attempt.motion);
    };
    const LoopSeam source = seamOfSource(ground_);
    const LoopSeam now = seamWith(whole_);
    const std::vector<double> frames{0.0, 1.0, ground_.lastFrame - 1.0, ground_.lastFrame};
    for (std::size_t i = 0; i < ground_.limbs.size(); ++i) {
      if (closesWorse(ground_, now, source, i)) {
        blame(frames, ground_.limbs[i], FaultKind::seam,
              [&](const Attempt& attempt) { return closesWorse(ground_, seamWith(attempt), source, i); });
      }
    }
  }

  const ClipGround& ground_;
  const AutoSettings& settings_;
  const AutoPlan& plan_;
  Attempt whole_;
  std::map<std::size_t, Attempt> without_;
  std::set<std::tuple<std::string, FaultKind, std::vector<std::size_t>>> judged_;
  std::map<std::size_t, FaultKind> faults_;
  std::map<std::size_t, double> depths_; // of trails whose limb is below the floor
};

} // namespace

const char* textOf(FaultKind kind) {
  constexpr std::array<const char*, 7> texts{
      "it would leave the style's lengths", "it would go through the floor",
      "the foot carries the body there",    "it would pull against a stronger limb of its chain",
      "the loop would not close",           "it would pass through the limb on the other side",
      "the body would leave the ground"};
  return texts[static_cast<std::size_t>(kind)];
}

std::vector<Fault> faultsOf(const ClipGround& ground, const AutoSettings& settings, const AutoPlan& plan) {
  return WholeCheck(ground, settings, plan).faults();
}

} // namespace stretch::app
