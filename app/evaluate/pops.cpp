#include "app/evaluate/pops.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluation_input.h"
#include "app/evaluate/free_turns.h"
#include "core/base/index.h"
#include "core/math/rotation.h"
#include "rig/controllers/controller.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/solved_holds.h"

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

// Of a slow clip each frame holds more.
double inFrames(double degrees, double framesPerSecond) {
  constexpr double usualRate = 24.0;
  return degrees * std::max(1.0, usualRate / framesPerSecond);
}

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
      worst = LimbPop{limb.id, static_cast<double>(k + 1), joint / ends, 0.0, 0.0, {}, {}};
    }
  }
  return worst;
}

// Every flip, told by the worst one; frames as worstPop counts them.
LimbPop limbFlips(const rig::Limb& limb, const Jolts& source, const Jolts& moved, double framesPerSecond) {
  constexpr double ofSource = 2.0;
  constexpr double more = 45.0; // degrees: less looks like haste
  const double least = inFrames(more, framesPerSecond);
  LimbPop flips{limb.id, 0.0, 0.0, 0.0, 0.0, {}, {}};
  double most = 0.0;
  for (std::size_t k = 0; k < moved.turns().size(); ++k) {
    const double turned = moved.turns()[k];
    const double before = source.turnAround(k);
    const double excess = turned - ofSource * before;
    if (excess <= least) {
      continue;
    }
    flips.flipFrames.push_back(static_cast<std::int64_t>(k + 1));
    if (excess > most) {
      most = excess;
      flips.frame = static_cast<double>(k + 1);
      flips.turnDegrees = turned;
      flips.sourceDegrees = before;
    }
  }
  return flips;
}

// Whether a limb is turned on purpose between two times, by its pole, or by a trail of its own as far as no
// hold takes it from that.
class Meant {
public:
  Meant(const rig::Limb& limb, const rig::MotionState& motion)
      : limb_(limb), motion_(motion), pole_(rig::poleController(limb)) {}
  [[nodiscard]] bool between(double startSeconds, double endSeconds) const {
    const auto poleAt = [&](double seconds) {
      return rig::offsetAt(motion_.adjustments.curves, pole_, seconds).move;
    };
    const auto isHeld = [&](double seconds) { return rig::isFullyHeld(motion_.holds, limb_, seconds); };
    return poleAt(startSeconds) != poleAt(endSeconds) ||
           (isTrailed(startSeconds, endSeconds) && !(isHeld(startSeconds) && isHeld(endSeconds)));
  }

private:
  // On a loop a trail's window goes on across the seam.
  [[nodiscard]] bool isTrailed(double startSeconds, double endSeconds) const {
    const double turn = motion_.loops ? motion_.endSeconds - motion_.startSeconds : 0.0;
    return std::ranges::any_of(motion_.trails, [&](const rig::SolvedTrail& trail) {
      return trail.active && trail.limb.id == limb_.id &&
             std::ranges::any_of(std::array{-turn, 0.0, turn}, [&](double shift) {
               return trail.windowStartSeconds <= endSeconds + shift &&
                      startSeconds + shift <= trail.windowEndSeconds;
             });
    });
  }

  const rig::Limb& limb_;
  const rig::MotionState& motion_;
  std::string pole_;
};

// What hips and chest carry goes along with them even where it hangs elsewhere.
std::vector<NodeIndex> carriersOf(const Scene& scene, const rig::Limb& limb, const rig::MotionState& motion) {
  std::vector<NodeIndex> nodes{scene.nodes[at(limb.joints.front())].parent, motion.hips};
  if (motion.adjustments.body) {
    nodes.push_back(motion.adjustments.body->chest);
  }
  std::erase(nodes, NodeIndex::none);
  return nodes;
}

// One limb over the frames that are looked at, in the clip and as it is moved.
class Watched {
public:
  Watched(const Scene& scene, const rig::Limb& limb, const rig::MotionState& motion)
      : limb_(limb), carriers_(carriersOf(scene, limb, motion)), meant_(limb, motion),
        framesPerSecond_(motion.framesPerSecond) {}

  void add(std::int64_t frame, const FrameState& before, const FrameState& after) {
    constexpr double most = 5.0; // degrees
    TurnedLimb source = turnedLimb(limb_, carriers_, before);
    TurnedLimb moved = turnedLimb(limb_, carriers_, after);
    source_.add(source.points);
    moved_.add(moved.points);
    if (!lastMoved_.points.empty()) {
      const auto seconds = [&](std::int64_t of) { return static_cast<double>(of) / framesPerSecond_; };
      const FreeTurn turn =
          freeTurn({lastSource_, source}, {lastMoved_, moved}, inFrames(most, framesPerSecond_));
      if (turn.degrees > 0.0 && !meant_.between(seconds(frame - 1), seconds(frame))) {
        turns_.emplace_back(frame, turn);
      }
    } else {
      first_ = frame;
    }
    lastSource_ = std::move(source);
    lastMoved_ = std::move(moved);
  }

  // Its pop, its flips, and its turns at other frames.
  void tell(std::vector<LimbPop>& pops) const {
    std::vector<std::int64_t> told;
    if (std::optional<LimbPop> pop = worstPop(limb_, source_, moved_)) {
      pop->frame += static_cast<double>(first_);
      told.push_back(static_cast<std::int64_t>(pop->frame));
      pops.push_back(*std::move(pop));
    }
    if (LimbPop flips = limbFlips(limb_, source_, moved_, framesPerSecond_); !flips.flipFrames.empty()) {
      flips.frame += static_cast<double>(first_);
      std::ranges::for_each(flips.flipFrames, [&](std::int64_t& frame) { frame += first_; });
      told.insert(told.end(), flips.flipFrames.begin(), flips.flipFrames.end());
      pops.push_back(std::move(flips));
    }
    if (LimbPop turns = freeTurns(told); !turns.freeFrames.empty()) {
      pops.push_back(std::move(turns));
    }
  }

private:
  [[nodiscard]] LimbPop freeTurns(const std::vector<std::int64_t>& told) const {
    LimbPop all{limb_.id, 0.0, 0.0, 0.0, 0.0, {}, {}};
    double most = 0.0;
    for (const auto& [frame, turn] : turns_) {
      if (std::ranges::find(told, frame) != told.end()) {
        continue;
      }
      all.freeFrames.push_back(frame);
      if (turn.excess() > most) {
        most = turn.excess();
        all.frame = static_cast<double>(frame);
        all.turnDegrees = turn.degrees;
        all.sourceDegrees = turn.sourceDegrees;
      }
    }
    return all;
  }

  const rig::Limb& limb_;
  std::vector<NodeIndex> carriers_;
  Meant meant_;
  double framesPerSecond_ = 0.0;
  std::int64_t first_ = 0; // frame
  Jolts source_;
  Jolts moved_;
  TurnedLimb lastSource_;
  TurnedLimb lastMoved_;
  std::vector<std::pair<std::int64_t, FreeTurn>> turns_; // by the frame that each comes to
};

// "frame 3", "frames 3 to 5 and 9"; at least one, in order.
std::string framesInWords(const std::vector<std::int64_t>& frames) {
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t last = i;
    while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) {
      ++last;
    }
    runs.push_back(last == i
                       ? fmt::format("{}", frames[i])
                       : fmt::format("{} {} {}", frames[i], last == i + 1 ? "and" : "to", frames[last]));
    i = last + 1;
  }
  return fmt::format("{} {}", frames.size() == 1 ? "frame" : "frames", fmt::join(runs, ", "));
}

std::string turnWarning(const std::string& limb, const LimbPop& pop) {
  const std::string worst =
      pop.freeFrames.size() > 1 ? fmt::format(" within frame {:g}", pop.frame) : " within it";
  return fmt::format("the {} turns at {} though its ends do not make it: by {:.0f} degrees{}, {:.0f} in the "
                     "clip; move its pole there, or let it reach less far",
                     limb, framesInWords(pop.freeFrames), pop.turnDegrees, worst, pop.sourceDegrees);
}

} // namespace

std::vector<LimbPop> limbPops(const Document& document, const rig::MotionState& motion,
                              const FrameSpan& frames) {
  std::vector<rig::Limb> limbs;
  std::ranges::copy_if(document.body.limbs, std::back_inserter(limbs), rig::hasElbowOrKnee);
  const Scene& scene = *document.scene;
  std::vector<Watched> watched;
  std::ranges::transform(limbs, std::back_inserter(watched),
                         [&](const rig::Limb& limb) { return Watched(scene, limb, motion); });
  const Clip& clip = clipOrStill(*document.clips, motion.clip);
  const std::int64_t first = std::max<std::int64_t>(frames.first, 0);
  for (std::int64_t frame = first; frame <= std::min(frames.last, frameCount(clip) - 1); ++frame) {
    const double seconds = static_cast<double>(frame) / clip.framesPerSecond;
    const FrameState before = rig::sampledFrame(scene, clip, seconds);
    const FrameState after = rig::evaluateMotion(scene, clip, motion, seconds);
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      watched[i].add(frame, before, after);
    }
  }
  std::vector<LimbPop> pops;
  for (const Watched& limb : watched) {
    limb.tell(pops);
  }
  return pops;
}

std::string popWarning(const LimbPop& pop) {
  std::string limb = pop.limb;
  std::ranges::replace(limb, '-', ' ');
  if (!pop.freeFrames.empty()) {
    return turnWarning(limb, pop);
  }
  if (!pop.flipFrames.empty()) {
    const std::string worst =
        pop.flipFrames.size() > 1 ? fmt::format("frame {:g}", pop.frame) : std::string("a frame");
    return fmt::format("the {} flips at {}: it turns by {:.0f} degrees within {}, {:.0f} in the "
                       "clip; one that is folded until its end passes its base does so: let it fold less far",
                       limb, framesInWords(pop.flipFrames), pop.turnDegrees, worst, pop.sourceDegrees);
  }
  return fmt::format("the {} pops at frame {:g} as it straightens: its middle joint moves {:.0f} times as "
                     "abruptly as its ends; "
                     "give it some softness, such as 0.1, or let it reach less far",
                     limb, pop.frame, pop.times);
}

} // namespace stretch::app
