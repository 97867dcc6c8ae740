#include "app/evaluate/pops.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/math/rotation.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

// Three frames in a row of what a limb is made of.
using ThreeFrames = std::array<std::vector<Vec3>, 3>;

double secondDifference(const ThreeFrames& points, std::size_t joint) {
  return glm::length(points[0][joint] - 2.0 * points[1][joint] + points[2][joint]);
}

// How hard a limb is moved at one frame, world units for each frame and frame.
struct Jolt {
  double joint = 0.0; // the hardest of the joints between base and end
  double ends = 0.0;  // the harder of base and end
};

Jolt joltOf(const ThreeFrames& points) {
  const std::size_t last = points[0].size() - 1;
  Jolt jolt{0.0, std::max(secondDifference(points, 0), secondDifference(points, last))};
  for (std::size_t joint = 1; joint < last; ++joint) {
    jolt.joint = std::max(jolt.joint, secondDifference(points, joint));
  }
  return jolt;
}

// The angle by which the bone turns that turns most from one frame to the next.
double turnOf(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < std::min(before.size(), after.size()); ++i) {
    most = std::max(most, angleBetween(before[i + 1] - before[i], after[i + 1] - after[i]));
  }
  return most * 180.0 / pi;
}

// One limb over the clip, frame by frame; jolts[k] is that of frame k + 1, turns[k] that from frame k to the
// next.
class Jolts {
public:
  void add(std::vector<Vec3> points) {
    std::rotate(last_.begin(), last_.begin() + 1, last_.end());
    last_.back() = std::move(points);
    if (!last_[1].empty()) {
      turns_.push_back(turnOf(last_[1], last_[2]));
    }
    if (!last_.front().empty()) {
      jolts_.push_back(joltOf(last_));
    }
  }
  // The hardest around a place: what comes a frame earlier or later belongs to the same movement.
  [[nodiscard]] double around(std::size_t place, double Jolt::*of) const {
    double most = 0.0;
    for (std::size_t i = place > 0 ? place - 1 : 0; i < std::min(place + 2, jolts_.size()); ++i) {
      most = std::max(most, jolts_[i].*of);
    }
    return most;
  }
  [[nodiscard]] const std::vector<Jolt>& all() const { return jolts_; }
  [[nodiscard]] const std::vector<double>& turns() const { return turns_; }
  [[nodiscard]] double turnAround(std::size_t place) const {
    const auto first = turns_.begin() + static_cast<std::ptrdiff_t>(place > 0 ? place - 1 : 0);
    const auto end = turns_.begin() + static_cast<std::ptrdiff_t>(std::min(place + 2, turns_.size()));
    return *std::max_element(first, end);
  }

private:
  ThreeFrames last_;
  std::vector<Jolt> jolts_;
  std::vector<double> turns_; // degrees
};

std::optional<LimbPop> worstPop(const rig::Limb& limb, const Jolts& source, const Jolts& moved) {
  constexpr double told = 4.0;         // times the ends
  constexpr double ofSource = 2.0;     // times what the joint does in the source
  constexpr double smallest = 0.01;    // of the limb: less is not seen
  constexpr double smallestEnd = 1e-3; // of the limb: ends that rest are not divided by
  std::optional<LimbPop> worst;
  for (std::size_t k = 0; k < moved.all().size(); ++k) {
    const double joint = moved.all()[k].joint;
    const double ends = std::max(moved.around(k, &Jolt::ends), smallestEnd * limb.restLength);
    const bool isOurs = joint > ofSource * source.around(k, &Jolt::joint);
    if (isOurs && joint > smallest * limb.restLength && joint > told * ends &&
        joint / ends > (worst ? worst->times : 0.0)) {
      worst = LimbPop{limb.id, static_cast<double>(k + 1), joint / ends};
    }
  }
  return worst;
}

std::optional<LimbPop> worstTurn(const rig::Limb& limb, const Jolts& source, const Jolts& moved,
                                 double framesPerSecond) {
  constexpr double ofSource = 2.0;
  constexpr double more = 45.0;      // degrees: less looks like haste
  constexpr double usualRate = 24.0; // of a slower clip each frame holds more
  std::optional<LimbPop> worst;
  double most = more * std::max(1.0, usualRate / framesPerSecond);
  for (std::size_t k = 0; k < moved.turns().size(); ++k) {
    const double turned = moved.turns()[k];
    const double before = source.turnAround(k);
    if (turned - ofSource * before > most) {
      most = turned - ofSource * before;
      worst = LimbPop{limb.id, static_cast<double>(k + 1), 0.0, turned, before};
    }
  }
  return worst;
}

} // namespace

std::vector<LimbPop> limbPops(const Document& document, const rig::MotionState& motion,
                              const FrameSpan& frames) {
  std::vector<rig::Limb> limbs;
  std::ranges::copy_if(document.body.limbs, std::back_inserter(limbs), rig::hasElbowOrKnee);
  std::vector<Jolts> source(limbs.size());
  std::vector<Jolts> moved(limbs.size());
  const Clip& clip = clipOf(document, motion.clip);
  const std::int64_t first = std::max<std::int64_t>(frames.first, 0);
  for (std::int64_t frame = first; frame <= std::min(frames.last, frameCount(clip) - 1); ++frame) {
    const double seconds = static_cast<double>(frame) / clip.framesPerSecond;
    const FrameState before = rig::sampledFrame(*document.scene, clip, seconds);
    const FrameState after = rig::evaluateMotion(*document.scene, clip, motion, seconds);
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      source[i].add(rig::limbPoints(limbs[i], before));
      moved[i].add(rig::limbPoints(limbs[i], after));
    }
  }
  std::vector<LimbPop> pops;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    std::optional<LimbPop> pop = worstPop(limbs[i], source[i], moved[i]);
    if (pop = pop ? pop : worstTurn(limbs[i], source[i], moved[i], clip.framesPerSecond); pop) {
      pop->frame += static_cast<double>(first);
      pops.push_back(*pop);
    }
  }
  return pops;
}

std::string popWarning(const LimbPop& pop) {
  std::string limb = pop.limb;
  std::ranges::replace(limb, '-', ' ');
  if (pop.turnDegrees > 0.0) {
    return fmt::format("the {} flips at frame {:g}: it turns by {:.0f} degrees within a frame, {:.0f} in the "
                       "clip; one that is folded until its end passes its base does so: let it fold less far",
                       limb, pop.frame, pop.turnDegrees, pop.sourceDegrees);
  }
  return fmt::format("the {} pops at frame {:g} as it straightens: its middle joint moves {:.0f} times as "
                     "abruptly as its ends; "
                     "give it some softness, such as 0.1, or let it reach less far",
                     limb, pop.frame, pop.times);
}

} // namespace stretch::app
