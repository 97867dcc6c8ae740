#include "app/retarget/touch_shifts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/retarget/smooth_course.h"
#include "app/retarget/touch_body.h"
#include "core/math/finite.h"
#include "rig/trail/release.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

using rig::ArmShift;
using rig::ArmShifts;
using rig::leftSide;
using rig::rightSide;

constexpr double contactAt = 0.01; // of the height: a hand touches
constexpr double drawnAt = 0.03;   // nearer than this it is drawn to what it comes to
constexpr double trusted = 50.0;   // confidence of a place that is touched, against 1 of one that is not
constexpr double unseen = 0.002;   // of the height
constexpr std::array<std::size_t, 2> sides{leftSide, rightSide};

// A point of the source's hand and what it is beside: the trunk, or a point of the other hand.
struct TouchPoint {
  Vec3 onHand{0.0};                              // from the wrist, in the character's directions, hand sizes
  Vec3 onOther{0.0};                             // the same of the other hand
  std::optional<skinning::SurfacePoint> onTrunk; // of the character
  Vec3 apart{0.0}; // from what is touched to the hand, in the character's proportions
  double weight = 0.0;
};

struct Touch {
  double share = 0.0; // 0..1: 1 where it touches, 0 where it is far
  std::vector<TouchPoint> points;
};

// What the source does at one frame.
struct TouchSample {
  std::size_t frame = 0;
  std::array<Touch, 2> trunk;      // by its hands
  Touch hands;                     // of the left hand by the right one
  std::array<double, 2> allowed{}; // how deep the character's arms may be in its trunk, of the height
  std::array<double, 2> lowest{};  // how far down they may go, to the floor: at most 0
};

// How far an arm is to go at a sample.
struct Wish {
  Vec3 wrist{0.0};
  double swivel = 0.0;
  double pull = 0.0;       // how much the arm itself has to go there
  double confidence = 1.0; // the same, and for the sake of the other hand
};
using Wishes = std::array<Wish, 2>;

Touch touchOf(const std::vector<NearVertex>& near, double height) {
  Touch touch;
  if (near.empty()) {
    return touch;
  }
  const double nearest = std::ranges::min_element(near, {}, &NearVertex::distance)->distance / height;
  touch.share = 1.0 - rig::smoothstep((nearest - contactAt) / (drawnAt - contactAt));
  for (const NearVertex& one : near) {
    touch.points.push_back({});
    touch.points.back().weight = std::max(0.0, 1.0 - (one.distance / height - nearest) / contactAt);
  }
  return touch;
}

class SourceTouch {
public:
  SourceTouch(const PlayedClip& source, const TouchBody& own, const Quat& world)
      : source_(source), from_(source.skeleton), own_(own), world_(world),
        ratio_(own.skeleton.height / source.skeleton.height) {}

  [[nodiscard]] TouchSample at(std::size_t frame, double seconds) const {
    TouchSample sample{frame, {}, {}, {}};
    if (!from_.hasSurface()) {
      return sample;
    }
    const FrameState state = stateAt(seconds);
    const std::vector<Vec3> places = skinning::skinnedPositions(*source_.skeleton.scene, state);
    for (const std::size_t side : sides) {
      if (canTouch(side)) {
        sample.trunk[side] = trunkTouch(places, state.worlds, side);
      }
    }
    if (canTouch(leftSide) && canTouch(rightSide)) {
      sample.hands = handsTouch(places, state.worlds);
    }
    return sample;
  }

  // How deep an arm is in the trunk, of the height.
  [[nodiscard]] double depthAt(double seconds, std::size_t side) const {
    return from_.hasSurface() && source_.skeleton.arms[side]
               ? from_.depthOf(skinning::skinnedPositions(*source_.skeleton.scene, stateAt(seconds)), side)
               : 0.0;
  }

private:
  // Whether both bodies show the hand.
  [[nodiscard]] bool canTouch(std::size_t side) const {
    return source_.skeleton.arms[side] && own_.skeleton.arms[side] && !from_.hands[side].empty() &&
           !own_.hands[side].empty();
  }

  [[nodiscard]] FrameState stateAt(double seconds) const {
    const Scene& scene = *source_.skeleton.scene;
    return frameOf(scene, samplePose(scene, source_.clip, seconds), seconds);
  }

  [[nodiscard]] Vec3 onHand(const Vec3& place, const std::vector<Mat4>& worlds, std::size_t side) const {
    return world_ * (place - from_.wrist(worlds, side)) / from_.handSizes[side];
  }

  [[nodiscard]] Touch trunkTouch(const std::vector<Vec3>& places, const std::vector<Mat4>& worlds,
                                 std::size_t side) const {
    const double height = source_.skeleton.height;
    const std::vector<NearVertex> near = from_.nearTrunk(places, side, drawnAt * height);
    Touch touch = touchOf(near, height);
    for (std::size_t i = 0; i < near.size(); ++i) {
      TouchPoint& point = touch.points[i];
      const Vec3 place = skinning::placeOf({places, from_.parts.trunk}, near[i].point);
      point.onHand = onHand(places[near[i].vertex], worlds, side);
      point.apart = ratio_ * (world_ * (places[near[i].vertex] - place));
      if (point.weight > 0.0) {
        point.onTrunk = own_.chart.pointAt(from_.chart.placeOf(near[i].point));
      }
    }
    return touch;
  }

  [[nodiscard]] Touch handsTouch(const std::vector<Vec3>& places, const std::vector<Mat4>& worlds) const {
    const double height = source_.skeleton.height;
    const std::vector<Triangle>& other = from_.parts.arms[rightSide].handTriangles;
    const std::vector<NearVertex> near =
        nearVertices({places, other}, from_.hands[leftSide], drawnAt * height);
    Touch touch = touchOf(near, height);
    for (std::size_t i = 0; i < near.size(); ++i) {
      TouchPoint& point = touch.points[i];
      const Vec3 place = skinning::placeOf({places, other}, near[i].point);
      point.onHand = onHand(places[near[i].vertex], worlds, leftSide);
      point.onOther = onHand(place, worlds, rightSide);
      point.apart = ratio_ * (world_ * (places[near[i].vertex] - place));
    }
    return touch;
  }

  const PlayedClip& source_;
  TouchBody from_;
  const TouchBody& own_;
  Quat world_;
  double ratio_;
};

// An arm of the character at one frame.
struct ArmPlace {
  Vec3 base{0.0};
  Vec3 elbow{0.0};
  Vec3 wrist{0.0};
  double length = 0.0;
};

ArmPlace armPlaceOf(const rig::Limb& limb, const std::vector<Mat4>& worlds) {
  const std::vector<Vec3> points = rig::limbPoints(limb, worlds);
  ArmPlace arm{points.front(), points.size() > 2 ? points[1] : points.front(), points.back(), 0.0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    arm.length += glm::length(points[i + 1] - points[i]);
  }
  return arm;
}

// How a vertex of an arm moves by the wrist's way and by the elbow's about the line from shoulder to wrist,
// in a direction.
glm::dvec4 leverOf(const ArmPlace& arm, const Vec3& place, const Vec3& direction) {
  constexpr double carried = 0.5; // of the wrist's way, at the elbow
  const Vec3 forearm = arm.wrist - arm.elbow;
  const double size = glm::dot(forearm, forearm);
  const double along = size > 0.0 ? std::clamp(glm::dot(place - arm.elbow, forearm) / size, 0.0, 1.0) : 1.0;
  const Vec3 line = arm.wrist - arm.base;
  const Vec3 round = glm::cross(line, arm.elbow - arm.base);
  const double far = glm::length(round);
  const double turned = far > 0.0 ? (1.0 - along) * glm::dot(round / far, direction) : 0.0;
  return {(along + carried * (1.0 - along)) * direction, turned};
}

class ShiftFinding {
public:
  ShiftFinding(const PlayedClip& source, const rig::Skeleton& own, const rig::FollowedClip& clip)
      : own_(own), clip_(clip), source_(source, own_, clip.world) {}

  std::vector<ArmShifts> run() {
    if (!own_.hasSurface() || clip_.seconds.size() < 2) {
      return {};
    }
    if (!findSamples()) {
      return {};
    }
    wishes_.resize(samples_.size());
    bool isNeeded = false;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      isNeeded_.push_back(bringToTouch(i));
      isNeeded = isNeeded || isNeeded_.back();
      if (!goesOn(0.25, i)) {
        return {};
      }
    }
    if (!isNeeded) {
      return {};
    }
    shifts_.resize(clip_.seconds.size());
    if (!findPaths()) {
      return {};
    }
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
      smoothOut();
      bool isMended = false;
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        isMended = mend(i) || isMended;
        if (!goesOn(0.4 + 0.15 * round, i)) {
          return {};
        }
      }
      if (!isMended) {
        break;
      }
    }
    smoothOut();
    const bool isSound = std::ranges::all_of(shifts_, [](const ArmShifts& both) {
      return std::ranges::all_of(
          both, [](const ArmShift& shift) { return isFinite(shift.wrist) && std::isfinite(shift.swivel); });
    });
    return isSound ? shifts_ : std::vector<ArmShifts>();
  }

private:
  [[nodiscard]] bool goesOn(double before, std::size_t index) const {
    constexpr double part = 0.15;
    return clip_.proceed(before + part * static_cast<double>(index) / static_cast<double>(samples_.size()));
  }

  [[nodiscard]] double step() const {
    return (clip_.seconds.back() - clip_.seconds.front()) / static_cast<double>(clip_.seconds.size() - 1);
  }

  /// False when it was stopped.
  bool findSamples() {
    constexpr double often = 1.0 / 15.0; // seconds
    constexpr std::size_t most = 900;
    const std::size_t frames = clip_.seconds.size();
    const auto fine = static_cast<std::size_t>(std::max(1.0, std::floor(often / step() + 1e-6)));
    const std::size_t every = std::max(fine, (frames + most - 1) / most);
    for (std::size_t frame = 0; frame < frames; frame += every) {
      samples_.push_back(source_.at(frame, clip_.seconds[frame]));
      if (!clip_.proceed(0.25 * static_cast<double>(frame) / static_cast<double>(frames))) {
        return false;
      }
    }
    if (samples_.back().frame + 1 < frames) {
      samples_.push_back(source_.at(frames - 1, clip_.seconds.back()));
    }
    return true;
  }

  /// False when it was stopped.
  bool findPaths() {
    constexpr std::size_t often = 64;
    for (std::size_t frame = 0; frame < clip_.seconds.size(); ++frame) {
      if (frame % often == 0 && !clip_.proceed(0.4)) {
        return false;
      }
      paths_[leftSide].push_back({});
      paths_[rightSide].push_back({});
      const std::vector<Mat4> worlds = clip_.worlds(frame, {});
      for (const std::size_t side : sides) {
        if (own_.skeleton.arms[side]) {
          paths_[side].back() = own_.wrist(worlds, side);
        }
      }
    }
    return true;
  }

  // How much both hands go together: where they work together for less than a half, either goes by itself.
  [[nodiscard]] double joinedAt(std::size_t frame) const {
    return clip_.joined.empty() ? 0.0 : rig::smoothstep(2.0 * clip_.joined[frame] - 1.0);
  }

  // The point of a hand that is where the source's is.
  [[nodiscard]] Vec3 ownPoint(const std::vector<Vec3>& places, const std::vector<Mat4>& worlds,
                              std::size_t side, const Vec3& onHand) const {
    const Vec3 wanted = own_.wrist(worlds, side) + own_.handSizes[side] * onHand;
    Vec3 nearest = wanted;
    double distance = std::numeric_limits<double>::infinity();
    for (const std::size_t vertex : own_.hands[side]) {
      const double far = glm::length(places[vertex] - wanted);
      if (far < distance) {
        distance = far;
        nearest = places[vertex];
      }
    }
    return nearest;
  }

  [[nodiscard]] double lowestOf(const std::vector<Vec3>& places, std::size_t side) const {
    double lowest = own_.skeleton.height;
    for (const std::size_t vertex : own_.arms[side]) {
      lowest = std::min(lowest, places[vertex].y);
    }
    return lowest;
  }

  // Whether there is anything to do.
  bool bringToTouch(std::size_t index) {
    TouchSample& sample = samples_[index];
    const std::vector<Mat4> worlds = clip_.worlds(sample.frame, {});
    const std::vector<Vec3> places = own_.placesOf(worlds);
    bool isNeeded = sample.hands.share > 0.0;
    for (const std::size_t side : sides) {
      const double depth = own_.skeleton.arms[side] ? own_.depthOf(places, side) : 0.0;
      sample.allowed[side] =
          unseen +
          (depth > unseen ? std::min(depth, source_.depthAt(clip_.seconds[sample.frame], side)) : 0.0);
      sample.lowest[side] = std::min(0.0, -lowestOf(places, side));
      isNeeded = isNeeded || sample.trunk[side].share > 0.0 || depth > sample.allowed[side];
    }
    if (!isNeeded) {
      return false;
    }
    for (const std::size_t side : sides) {
      Vec3 sum(0.0);
      double weight = 0.0;
      for (const TouchPoint& point : sample.trunk[side].points) {
        if (point.onTrunk) {
          const Vec3 there = skinning::placeOf({places, own_.parts.trunk}, *point.onTrunk) + point.apart;
          sum += point.weight * (there - ownPoint(places, worlds, side, point.onHand));
          weight += point.weight;
        }
      }
      if (weight > 0.0) {
        wish(index, side, worlds, sum / weight, sample.trunk[side].share);
      }
    }
    bringTogether(index, worlds, places);
    joinWishes(index, worlds);
    return true;
  }

  // Hands that touch each other, half by each; what both hold keeps them apart by itself.
  void bringTogether(std::size_t index, const std::vector<Mat4>& worlds, const std::vector<Vec3>& places) {
    const TouchSample& sample = samples_[index];
    Vec3 sum(0.0);
    double weight = 0.0;
    for (const TouchPoint& point : sample.hands.points) {
      if (point.weight > 0.0) {
        sum += point.weight * (ownPoint(places, worlds, rightSide, point.onOther) + point.apart -
                               ownPoint(places, worlds, leftSide, point.onHand));
        weight += point.weight;
      }
    }
    const double share = sample.hands.share * (1.0 - joinedAt(sample.frame));
    if (weight > 0.0 && share > 0.0) {
      const Vec3 apart = sum / weight + wishes_[index][rightSide].wrist - wishes_[index][leftSide].wrist;
      wish(index, leftSide, worlds, wishes_[index][leftSide].wrist + 0.5 * apart, share);
      wish(index, rightSide, worlds, wishes_[index][rightSide].wrist - 0.5 * apart, share);
    }
  }

  // As far as the arm reaches; what is much farther is given up.
  void wish(std::size_t index, std::size_t side, const std::vector<Mat4>& worlds, const Vec3& way,
            double share) {
    constexpr double straight = 0.998; // of the length
    constexpr double givenUp = 1.25;
    const ArmPlace arm = armPlaceOf(own_.skeleton.arms[side]->limb, worlds);
    const double far = glm::length(arm.wrist + way - arm.base) / std::max(arm.length, 1e-12);
    const double kept = share * (1.0 - rig::smoothstep((far - 1.0) / (givenUp - 1.0)));
    Wish& wish = wishes_[index][side];
    wish.wrist =
        kept *
        (far > straight ? arm.base + (arm.wrist + way - arm.base) * (straight / far) - arm.wrist : way);
    wish.wrist.y = std::max(wish.wrist.y, samples_[index].lowest[side]);
    wish.pull = std::max(wish.pull, trusted * kept * kept);
    wish.confidence = 1.0 + wish.pull;
  }

  // What two hands hold together goes where either is drawn to, as far as both reach.
  void joinWishes(std::size_t index, const std::vector<Mat4>& worlds) {
    const double joined = joinedAt(samples_[index].frame);
    Wishes& both = wishes_[index];
    const double pull = both[leftSide].pull + both[rightSide].pull;
    if (joined <= 0.0 || pull <= 0.0) {
      return;
    }
    Vec3 mean = glm::mix(both[rightSide].wrist, both[leftSide].wrist, both[leftSide].pull / pull);
    const auto reaches = [&](std::size_t side) {
      const ArmPlace arm = armPlaceOf(own_.skeleton.arms[side]->limb, worlds);
      return glm::length(arm.wrist + mean - arm.base) < 0.999 * arm.length;
    };
    constexpr int most = 16;
    for (int i = 0; i < most && !(reaches(leftSide) && reaches(rightSide)); ++i) {
      mean *= 0.8;
    }
    const std::array<double, 2>& lowest = samples_[index].lowest;
    mean.y = std::max({mean.y, lowest[leftSide], lowest[rightSide]});
    for (Wish& wish : both) {
      wish.wrist += joined * (mean - wish.wrist);
      wish.confidence =
          1.0 + glm::mix(wish.pull, std::max(both[leftSide].pull, both[rightSide].pull), joined);
    }
  }

  // Whether anything was still in the trunk.
  bool mend(std::size_t index) {
    const TouchSample& sample = samples_[index];
    const ArmShifts& shifts = shifts_[sample.frame];
    const bool isMoved = std::ranges::any_of(shifts, [&](const ArmShift& shift) {
      return glm::length(shift.wrist) > 1e-4 * own_.skeleton.height || std::abs(shift.swivel) > 1e-4;
    });
    if (!isMoved && !isNeeded_[index]) {
      return false;
    }
    const std::vector<Mat4> worlds = clip_.worlds(sample.frame, shifts);
    const std::vector<Vec3> places = own_.placesOf(worlds);
    bool isMended = false;
    for (const std::size_t side : sides) {
      if (own_.skeleton.arms[side]) {
        isMended = pushOut(index, side, worlds, places) || isMended;
      }
    }
    joinWishes(index, clip_.worlds(sample.frame, {}));
    return isMended;
  }

  // The least way of wrist and elbow that brings out what is deeper inside than in the source.
  bool pushOut(std::size_t index, std::size_t side, const std::vector<Mat4>& worlds,
               const std::vector<Vec3>& places) {
    constexpr double stiffness = 0.02;
    const double height = own_.skeleton.height;
    const double allowed = samples_[index].allowed[side] * height;
    const ArmPlace arm = armPlaceOf(own_.skeleton.arms[side]->limb, worlds);
    glm::dmat4 levers(0.0);
    glm::dvec4 ways(0.0);
    double sum = 0.0;
    for (const NearVertex& inside : own_.inTrunk(places, side)) {
      const double excess = inside.distance - allowed;
      if (excess <= 0.0) {
        continue;
      }
      const Vec3 out = skinning::placeOf({places, own_.parts.trunk}, inside.point) - places[inside.vertex];
      const glm::dvec4 lever = leverOf(arm, places[inside.vertex], out / inside.distance);
      levers += excess * glm::outerProduct(lever, lever);
      ways += excess * (excess + unseen * height) * lever;
      sum += excess;
    }
    if (sum <= 0.0) {
      return false;
    }
    const glm::dvec4 way = glm::inverse(levers / sum + stiffness * glm::dmat4(1.0)) * (ways / sum);
    const Vec3 line = arm.wrist - arm.base;
    const double far = glm::length(line);
    const double radius = far > 0.0 ? glm::length(glm::cross(line, arm.elbow - arm.base)) / far : 0.0;
    Wish& wish = wishes_[index][side];
    const ArmShift& shift = shifts_[samples_[index].frame][side];
    constexpr double mostSwivel = 1.0;  // radians
    constexpr double leastRadius = 0.1; // of the arm
    wish.swivel = std::clamp(shift.swivel + (radius > leastRadius * arm.length ? way.w / radius : 0.0),
                             -mostSwivel, mostSwivel);
    wish.wrist = shift.wrist + Vec3(way);
    wish.wrist.y = std::max(wish.wrist.y, samples_[index].lowest[side]);
    wish.pull = trusted;
    wish.confidence = 1.0 + trusted;
    return true;
  }

  // The wishes over all frames, as quick as the clip's own hands at most.
  void smoothOut() {
    constexpr double shortest = 0.06; // seconds
    constexpr double longest = 0.5;
    for (const std::size_t side : sides) {
      const double limit = mostBend(side);
      for (double seconds = shortest; seconds < longest; seconds *= 1.3) {
        smoothOut(side, std::pow(seconds / step(), 4.0));
        if (largestBend(side) <= limit) {
          break;
        }
      }
    }
    for (std::size_t frame = 0; frame < shifts_.size(); ++frame) {
      const double joined = joinedAt(frame);
      const double left =
          confidences_[leftSide][frame] / (confidences_[leftSide][frame] + confidences_[rightSide][frame]);
      const Vec3 mean = glm::mix(shifts_[frame][rightSide].wrist, shifts_[frame][leftSide].wrist, left);
      for (ArmShift& shift : shifts_[frame]) {
        shift.wrist += joined * (mean - shift.wrist);
      }
    }
  }

  void smoothOut(std::size_t side, double stiffness) {
    const std::size_t frames = shifts_.size();
    std::array<std::vector<double>, 4> wanted;
    std::vector<double>& confidences = confidences_[side];
    confidences.clear();
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
      const Wish& here = wishes_[i][side];
      const Wish& next = wishes_[i + 1][side];
      const bool isLast = i + 2 == samples_.size();
      const std::size_t count = samples_[i + 1].frame - samples_[i].frame;
      for (std::size_t j = 0; j < count + (isLast ? 1 : 0); ++j) {
        const double share = static_cast<double>(j) / static_cast<double>(count);
        const Vec3 wrist = glm::mix(here.wrist, next.wrist, share);
        for (int axis = 0; axis < 3; ++axis) {
          wanted[at(axis)].push_back(wrist[axis]);
        }
        wanted[3].push_back(glm::mix(here.swivel, next.swivel, share));
        confidences.push_back(glm::mix(here.confidence, next.confidence, share));
      }
    }
    for (std::size_t value = 0; value < 4; ++value) {
      const std::vector<double> course = smoothCourse(wanted[value], confidences, stiffness);
      for (std::size_t frame = 0; frame < frames; ++frame) {
        ArmShift& shift = shifts_[frame][side];
        (value == 3 ? shift.swivel : shift.wrist[static_cast<int>(value)]) = course[frame];
      }
    }
  }

  template <typename Place>
  [[nodiscard]] double largestBendOf(Place place) const {
    double largest = 0.0;
    for (std::size_t frame = 1; frame + 1 < shifts_.size(); ++frame) {
      largest = std::max(largest, glm::length(place(frame - 1) - 2.0 * place(frame) + place(frame + 1)));
    }
    return largest;
  }

  [[nodiscard]] double largestBend(std::size_t side) const {
    return largestBendOf([&](std::size_t frame) { return shifts_[frame][side].wrist; });
  }

  // Second difference that shifts may add to the wrist's way.
  [[nodiscard]] double mostBend(std::size_t side) const {
    constexpr double quick = 0.0025; // of the height in a frame of a 24th of a second
    const double frames = 24.0 * step();
    return 0.5 * largestBendOf([&](std::size_t frame) { return paths_[side][frame]; }) +
           quick * frames * frames * own_.skeleton.height;
  }

  TouchBody own_;
  const rig::FollowedClip& clip_;
  SourceTouch source_;
  std::vector<TouchSample> samples_;
  std::vector<Wishes> wishes_;                     // at each sample
  std::vector<bool> isNeeded_;                     // whether something touches or is inside there
  std::vector<ArmShifts> shifts_;                  // at each frame
  std::array<std::vector<double>, 2> confidences_; // of either arm's wishes, at each frame
  std::array<std::vector<Vec3>, 2> paths_;         // of the wrists as they were, at each frame
};

} // namespace

rig::ShiftArms touchShifts(const PlayedClip& source, const rig::Skeleton& own, double amount) {
  if (amount <= 0.0) {
    return {};
  }
  return [source, &own, amount](const rig::FollowedClip& clip) {
    std::vector<ArmShifts> shifts = ShiftFinding(source, own, clip).run();
    for (ArmShifts& both : shifts) {
      for (ArmShift& shift : both) {
        shift = {amount * shift.wrist, amount * shift.swivel};
      }
    }
    return shifts;
  };
}

} // namespace stretch::app
