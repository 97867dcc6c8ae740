#include "app/auto/whole_check.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/things/place.h"
#include "rig/motion/order.h"

namespace stretch::app {

namespace {

constexpr double margin = 0.004;          // of the height: less is not seen
constexpr double seamMetres = 0.008;      // of a person
constexpr double seamSpeed = 0.08;        // of a person, m/s
constexpr double shorter = 1.5;           // a limb that turns on its way may come nearer than it is squashed
constexpr double againstEachOther = -0.3; // cosine between the ways of two limbs of one chain

constexpr const char* throughFloor = "it would go through the floor";

double lengthOf(const std::vector<Vec3>& points) {
  return glm::length(points.back() - points.front());
}

class WholeCheck {
public:
  WholeCheck(const ClipGround& ground, const AutoSettings& settings, const AutoPlan& plan)
      : ground_(ground), settings_(settings), plan_(plan), trial_(withPlan()),
        motion_(prepareMotion(trial_, ground.clip)) {}

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
    for (const auto& [trail, why] : faults_) {
      faults.push_back({trail, why});
    }
    return faults;
  }

private:
  [[nodiscard]] Document withPlan() const {
    Document document = plan_.loops ? setLooping(ground_.document, ground_.clip, true) : ground_.document;
    document.weights.clear();
    int id = document.nextTrailId;
    for (const PlannedTrail& planned : plan_.trails) {
      document.trails.push_back(planned.trail);
      document.trails.back().id = id++;
    }
    document.holds.grips.insert(document.holds.grips.end(), plan_.grips.begin(), plan_.grips.end());
    return document;
  }

  [[nodiscard]] std::vector<std::size_t> actingAt(double frame) const {
    std::vector<std::size_t> acting;
    for (std::size_t i = 0; i < plan_.trails.size(); ++i) {
      const Vec2 window = windowOf(plan_.trails[i].trail.settings);
      const bool wraps = plan_.loops && frame + ground_.lastFrame <= window.y;
      if ((window.x <= frame && frame <= window.y) || wraps) {
        acting.push_back(i);
      }
    }
    return acting;
  }

  [[nodiscard]] bool moves(const PlannedTrail& planned, const rig::Limb& limb) const {
    const rig::Limb* const own = findLimb(ground_.document, planned.trail.limb);
    const bool grips = std::ranges::any_of(plan_.grips, [&](const rig::Grip& grip) {
      return grip.leader == planned.trail.limb && grip.follower == limb.id;
    });
    return planned.trail.limb == limb.id || grips ||
           (own != nullptr && rig::carries(*ground_.document.scene, *own, limb));
  }

  void blame(double frame, const rig::Limb& limb, const char* why) {
    for (const std::size_t place : actingAt(frame)) {
      if (moves(plan_.trails[place], limb)) {
        faults_.emplace(place, why);
      }
    }
  }

  void lookAt(double frame) {
    const FrameState shown = evaluate(trial_, motion_, frame / ground_.framesPerSecond);
    const LimbPlaces now = placesOf(ground_.limbs, shown);
    lookAtMesh(frame, shown, now);
    const LimbPlaces& source = ground_.placesAt(frame);
    for (std::size_t i = 0; i < ground_.limbs.size(); ++i) {
      lookAtLimb(frame, ground_.limbs[i], source[i], now[i]);
    }
  }

  // What lies below the floor hangs on the limb that it is nearest to.
  void lookAtMesh(double frame, const FrameState& shown, const LimbPlaces& now) {
    const std::optional<Vec3> vertex = lowestVertexOf(*ground_.surface, shown);
    if (!vertex || vertex->y >= ground_.lowestVertex - margin * ground_.document.body.height) {
      return;
    }
    std::optional<std::size_t> nearest;
    double least = 0.0;
    for (const std::size_t place : actingAt(frame)) {
      const auto limb = std::ranges::find(ground_.limbs, plan_.trails[place].trail.limb, &rig::Limb::id);
      for (const Vec3& point : now[static_cast<std::size_t>(limb - ground_.limbs.begin())]) {
        const double distance = glm::length(point - *vertex);
        if (!nearest || distance < least) {
          nearest = place;
          least = distance;
        }
      }
    }
    if (nearest) {
      faults_.emplace(*nearest, throughFloor);
    }
  }

  void lookAtLimb(double frame, const rig::Limb& limb, const std::vector<Vec3>& source,
                  const std::vector<Vec3>& now) {
    const double height = ground_.document.body.height;
    const rig::ScaleRange& range = rig::scalesOf(settings_.style, limb.kind);
    const double before = lengthOf(source);
    const double after = lengthOf(now);
    const double unseen = margin * height;
    if (after > range.most * std::max(before, limb.restLength) + unseen ||
        after < std::min(1.0, range.least) * before / shorter - unseen) {
      blame(frame, limb, "it would leave the style's lengths");
    }
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (now[k].y < std::min(source[k].y, ground_.lowest) - unseen) {
        blame(frame, limb, throughFloor);
      }
    }
    if (glm::length(now.back() - source.back()) > unseen &&
        std::ranges::any_of(ground_.standsOf(limb.id),
                            [&](const Vec2& stand) { return stand.x <= frame && frame <= stand.y; })) {
      blame(frame, limb, "the foot carries the body there");
    }
  }

  // The way of the limb's tip, from where the source has it.
  [[nodiscard]] Vec3 wayOf(std::size_t place) const {
    const int id = ground_.document.nextTrailId + static_cast<int>(place);
    const auto solved = std::ranges::find_if(
        motion_.trails, [&](const rig::SolvedTrail& trail) { return trail.trail.id == id; });
    const std::vector<rig::SphereOffset>& spheres = plan_.trails[place].trail.settings.spheres;
    return solved == motion_.trails.end() ? Vec3(0.0)
           : spheres.empty()              ? solved->tip.tip - solved->tip.originalTip
                                          : spheres.back().offset;
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
          faults_.emplace(std::max(inner, outer), "it would pull against a stronger limb of its chain");
        }
      }
    }
  }

  // Steps from the clip's last pose to its first, and what they change from one turn to the next.
  struct Seam {
    LimbPlaces first, afterFirst, beforeLast, last;
  };

  template <typename At>
  [[nodiscard]] Seam seamOf(const At& at) const {
    const Clip& clip = clipOf(ground_.document, ground_.clip);
    const double step = seamStep();
    const double start = std::min(0.0, clip.startSeconds);
    return {at(start), at(start + step), at(clip.endSeconds - step), at(clip.endSeconds)};
  }

  [[nodiscard]] double seamStep() const { return 1.0 / ground_.framesPerSecond; }

  void lookAtSeam() {
    const Seam now =
        seamOf([&](double seconds) { return placesOf(ground_.limbs, evaluate(trial_, motion_, seconds)); });
    const Seam source = seamOf([&](double seconds) {
      return placesOf(ground_.limbs, evaluateOriginal(ground_.document, ground_.clip, seconds));
    });
    const double metre = ground_.document.body.size / characterSizeMetres;
    for (std::size_t i = 0; i < ground_.limbs.size(); ++i) {
      for (std::size_t k = 0; k < now.first[i].size(); ++k) {
        const auto gap = [&](const Seam& seam) { return glm::length(seam.last[i][k] - seam.first[i][k]); };
        const auto turn = [&](const Seam& seam) {
          return glm::length((seam.last[i][k] - seam.beforeLast[i][k]) -
                             (seam.afterFirst[i][k] - seam.first[i][k])) /
                 seamStep();
        };
        if (gap(now) - gap(source) > seamMetres * metre || turn(now) - turn(source) > seamSpeed * metre) {
          for (const double frame : {0.0, 1.0, ground_.lastFrame - 1.0, ground_.lastFrame}) {
            blame(frame, ground_.limbs[i], "the loop would not close");
          }
        }
      }
    }
  }

  const ClipGround& ground_;
  const AutoSettings& settings_;
  const AutoPlan& plan_;
  Document trial_;
  rig::MotionState motion_;
  std::map<std::size_t, std::string> faults_;
};

} // namespace

std::vector<Fault> faultsOf(const ClipGround& ground, const AutoSettings& settings, const AutoPlan& plan) {
  return WholeCheck(ground, settings, plan).faults();
}

} // namespace stretch::app
