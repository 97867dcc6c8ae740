#include "rig/body/reading/stance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <glm/geometric.hpp>

namespace stretch::rig::body {

namespace {

constexpr double leastElevation = 0.55; // sine: flatter than this the trunk of a four-legged body lies

double elevation(const Vec3& offset) {
  const double length = glm::length(offset);
  return length > 0.0 ? std::abs(offset.y) / length : 1.0;
}

class Stance {
public:
  Stance(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading)
      : view_(view), plane_(plane), reading_(reading), low_(static_cast<std::size_t>(view.count())),
        high_(low_.size()) {
    std::vector<int> deepestFirst(low_.size());
    double lowest = floor_;
    for (int joint = 0; joint < view.count(); ++joint) {
      const auto index = static_cast<std::size_t>(joint);
      deepestFirst[index] = joint;
      low_[index] = lowestOf(joint);
      high_[index] = view.at(joint).y;
      if (view.movesMesh(joint)) {
        // A tail or a cape may hang through the ground: nothing stands on it.
        floor_ = view.name(joint).accessory ? floor_ : std::min(floor_, low_[index]);
        lowest = std::min(lowest, low_[index]);
        top_ = std::max(top_, high_[index]);
      }
    }
    floor_ = floor_ > top_ ? lowest : floor_;
    std::ranges::stable_sort(deepestFirst, std::ranges::greater{},
                             [&](int joint) { return view.depth[static_cast<std::size_t>(joint)]; });
    for (const int joint : deepestFirst) {
      const auto index = static_cast<std::size_t>(joint);
      const int parent = view.parentOf(joint);
      if (parent >= 0) {
        const auto above = static_cast<std::size_t>(parent);
        low_[above] = std::min(low_[above], low_[index]);
        high_[above] = std::max(high_[above], high_[index]);
      }
    }
  }

  [[nodiscard]] int legs() const {
    const bool upright = isUpright();
    int left = 0;
    int right = 0;
    for (int joint = 0; joint < view_.count(); ++joint) {
      if (isBranch(joint) && reachesGround(joint) && !(upright && belongsToUpright(joint))) {
        ++(plane_.lateral(view_.at(joint)) > 0.0 ? left : right);
      }
    }
    return 2 * std::min(left, right);
  }

private:
  [[nodiscard]] double lowestOf(int joint) const {
    const auto index = static_cast<std::size_t>(joint);
    double low = view_.at(joint).y;
    for (const std::vector<Vec3>* points : {&view_.points[index], &view_.tips[index]}) {
      for (const Vec3& point : *points) {
        low = std::min(low, point.y);
      }
    }
    return low;
  }

  [[nodiscard]] bool isOff(int joint) const {
    return std::abs(plane_.lateral(view_.at(joint))) > 0.02 * view_.size;
  }

  [[nodiscard]] bool isBranch(int joint) const {
    const int parent = view_.parentOf(joint);
    const NameEvidence& name = view_.name(joint);
    return isOff(joint) && (parent < 0 || !isOff(parent)) && view_.movesMesh(joint) && !name.accessory &&
           !name.control && !view_.childrenOf(joint).empty();
  }

  [[nodiscard]] bool reachesGround(int joint) const {
    const double height = top_ - floor_;
    const double low = low_[static_cast<std::size_t>(joint)];
    const double high = high_[static_cast<std::size_t>(joint)];
    return low < floor_ + 0.08 * height && high - low > 0.2 * height;
  }

  [[nodiscard]] bool isUpright() const {
    return reading_.arms && reading_.legs &&
           elevation(startOf(*reading_.arms) - startOf(*reading_.legs)) > leastElevation;
  }

  // Where a pair's rows of joints leave the middle: a limb may have been read from its knee on.
  [[nodiscard]] Vec3 startOf(const LimbPair& pair) const {
    Vec3 sum(0.0);
    double count = 0.0;
    for (const std::optional<LimbGuess>* limb : {&pair.negative, &pair.positive}) {
      int joint = *limb ? (*limb)->base : -1;
      while (joint >= 0 && view_.parentOf(joint) >= 0 && isOff(view_.parentOf(joint))) {
        joint = view_.parentOf(joint);
      }
      sum += joint >= 0 ? view_.at(joint) : Vec3(0.0);
      count += joint >= 0 ? 1.0 : 0.0;
    }
    return sum / std::max(count, 1.0);
  }

  [[nodiscard]] static bool holds(const BodyView& view, int branch, const std::optional<LimbPair>& pair) {
    return (pair->negative && view.isAboveOrSelf(branch, pair->negative->base)) ||
           (pair->positive && view.isAboveOrSelf(branch, pair->positive->base));
  }

  // Its arms, and what hangs beside its legs without being one.
  [[nodiscard]] bool belongsToUpright(int joint) const {
    if (holds(view_, joint, reading_.arms)) {
      return true;
    }
    Vec3 offset = view_.at(joint) - meanBase(view_, *reading_.legs);
    offset.y = 0.0;
    offset -= plane_.normal * glm::dot(offset, plane_.normal);
    const double legHeight = meanBase(view_, *reading_.legs).y - floor_;
    return !holds(view_, joint, reading_.legs) && glm::length(offset) < 0.4 * legHeight;
  }

  const BodyView& view_;
  const MirrorPlane& plane_;
  const BipedReading& reading_;
  std::vector<double> low_;  // y of the lowest point of each joint and what hangs on it
  std::vector<double> high_; // of the highest joint
  double floor_ = std::numeric_limits<double>::max();
  double top_ = std::numeric_limits<double>::lowest();
};

bool isCalled(const KindredPair& pair, std::initializer_list<PartWord> words) {
  return std::ranges::any_of(words, [&](PartWord word) { return pair.pair.word(word) > 0.0; });
}

} // namespace

int standingLegs(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading) {
  return Stance(view, plane, reading).legs();
}

bool areLegsNamed(const std::vector<KindredPair>& pairs) {
  return std::ranges::all_of(
      pairs, [](const KindredPair& one) { return !one.stands || isCalled(one, {PartWord::leg}); });
}

void dropStrayLegs(std::vector<KindredPair>& pairs) {
  const auto named = std::ranges::count_if(
      pairs, [](const KindredPair& one) { return one.stands && isCalled(one, {PartWord::leg}); });
  for (KindredPair& one : pairs) {
    if (named >= 2 && one.kind == LimbKind::leg && one.stands &&
        !isCalled(one, {PartWord::leg, PartWord::arm, PartWord::claw, PartWord::front, PartWord::back})) {
      one.kind = LimbKind::chain;
      one.stands = false;
    }
  }
}

bool isBesideNamedLegs(const BodyView& view, const PlanParts& parts, const KindredPair& pair) {
  constexpr double some = 0.5;
  const bool isArm = std::ranges::any_of(pair.pair.positive.path, [&](int joint) {
    return std::ranges::any_of(std::array{Role::clavicle, Role::upperArm, Role::foreArm, Role::wrist},
                               [&](Role role) { return view.name(joint).role(role) >= some; });
  });
  return parts.axis.headIsNamed && parts.standingLegs() >= 4 && areLegsNamed(parts.pairs) && !isArm &&
         !isCalled(pair, {PartWord::leg, PartWord::arm, PartWord::wing, PartWord::feeler, PartWord::claw});
}

std::vector<Vec3> leaningUps(const MirrorPlane& plane) {
  const Vec3 upwards(0.0, 1.0, 0.0);
  const Vec3 across = upwards - plane.normal * glm::dot(upwards, plane.normal);
  if (glm::length(across) < 0.8) {
    return {};
  }
  const Vec3 up = glm::normalize(across);
  const Vec3 ahead = glm::cross(plane.normal, up);
  std::vector<Vec3> ups;
  for (const double lean : {0.0, 0.12, -0.12, 0.24, -0.24}) { // tangents
    ups.push_back(glm::normalize(up + lean * ahead));
  }
  return ups;
}

std::vector<Vec3> otherUps(const MirrorPlane& plane) {
  std::vector<Vec3> ups{Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(-1, 0, 0)};
  std::erase_if(ups, [&](const Vec3& up) { return std::abs(glm::dot(up, plane.normal)) > 0.5; });
  return ups;
}

} // namespace stretch::rig::body
