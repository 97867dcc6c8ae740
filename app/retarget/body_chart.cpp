#include "app/retarget/body_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/index.h"
#include "rig/limb.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

constexpr double firstSlice = -0.5; // along the body
constexpr double sliceStep = 0.25;

double heightOfBases(const rig::Skeleton& skeleton, const rig::Limb& left, const rig::Limb& right) {
  const auto of = [&](const rig::Limb& limb) {
    return glm::dot(skeleton.axes[1], positionOf(skeleton.bind[at(limb.joints.front())]));
  };
  return 0.5 * (of(left) + of(right));
}

std::array<double, 3> levelsOf(const rig::Skeleton& skeleton) {
  const double least = 0.02 * skeleton.height; // between two levels
  const double usual = 0.3 * skeleton.height;  // from hips to shoulders
  std::array<double, 3> levels{};
  levels[0] = heightOfBases(skeleton, skeleton.legs[rig::leftSide].limb, skeleton.legs[rig::rightSide].limb);
  levels[1] = levels[0] + usual;
  if (skeleton.arms[rig::leftSide] && skeleton.arms[rig::rightSide]) {
    levels[1] =
        heightOfBases(skeleton, skeleton.arms[rig::leftSide]->limb, skeleton.arms[rig::rightSide]->limb);
  }
  levels[1] = std::max(levels[1], levels[0] + least);
  levels[2] = skeleton.head.exists()
                  ? glm::dot(skeleton.axes[1], positionOf(skeleton.bind[at(skeleton.head)]))
                  : levels[1];
  levels[2] = std::max(levels[2], levels[1] + least);
  return levels;
}

Vec3 middleOf(const Bounds& box) {
  return 0.5 * (box.low + box.high);
}

Vec3 halfOf(const Bounds& box) {
  return 0.5 * (box.high - box.low);
}

} // namespace

BodyChart::BodyChart(const rig::Skeleton& skeleton, const BodyParts& parts)
    : parts_(parts), levels_(levelsOf(skeleton)) {
  const FrameState bind{0.0, restPose(*skeleton.scene), skeleton.bind, {}};
  for (const Vec3& place : skinning::skinnedPositions(*skeleton.scene, bind)) {
    places_.push_back(glm::transpose(skeleton.axes) * place);
  }
  for (std::size_t i = 0; i < parts.trunk.size(); ++i) {
    for (const std::uint32_t vertex : parts.trunk[i]) {
      const Vec3& place = places_[vertex];
      if (parts.isOfHead[i]) {
        head_.add(place);
        continue;
      }
      const double slice = std::clamp((alongOf(place.y) - firstSlice) / sliceStep, -2.0, sliceCount + 1.0);
      for (int near = static_cast<int>(std::ceil(slice - 1.0));
           near <= static_cast<int>(std::floor(slice + 1.0)); ++near) {
        slices_[at(std::clamp(near, 0, sliceCount - 1))].add(place);
      }
    }
  }
}

double BodyChart::alongOf(double height) const {
  const int part = height < levels_[1] ? 0 : 1;
  return part + (height - levels_[at(part)]) / (levels_[at(part + 1)] - levels_[at(part)]);
}

double BodyChart::heightOf(double along) const {
  const int part = along < 1.0 ? 0 : 1;
  return levels_[at(part)] + (along - part) * (levels_[at(part + 1)] - levels_[at(part)]);
}

BodyChart::Widths BodyChart::widthsAt(double along) const {
  const double slice = std::clamp((along - firstSlice) / sliceStep, 0.0, sliceCount - 1.0);
  // The nearest slice that holds anything.
  const auto filled = [&](int wanted) {
    int nearest = -1;
    for (int i = 0; i < sliceCount; ++i) {
      const bool isNearer = nearest < 0 || std::abs(i - wanted) < std::abs(nearest - wanted);
      nearest = !slices_[at(i)].empty() && isNearer ? i : nearest;
    }
    return nearest;
  };
  const int lower = filled(static_cast<int>(slice));
  const int upper = filled(std::min(static_cast<int>(slice) + 1, sliceCount - 1));
  if (lower < 0) {
    return {};
  }
  const double share = slice - std::floor(slice);
  return {glm::mix(middleOf(slices_[at(lower)]), middleOf(slices_[at(upper)]), share),
          glm::mix(halfOf(slices_[at(lower)]), halfOf(slices_[at(upper)]), share)};
}

ChartPlace BodyChart::placeOf(const skinning::SurfacePoint& point) const {
  const Vec3 place = skinning::placeOf({places_, parts_.trunk}, point);
  const bool isOfHead = parts_.isOfHead[point.triangle];
  const double along = alongOf(place.y);
  const Widths widths = isOfHead ? Widths{middleOf(head_), halfOf(head_)} : widthsAt(along);
  Vec3 shares(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    shares[axis] = widths.half[axis] > 0.0 ? (place[axis] - widths.middle[axis]) / widths.half[axis] : 0.0;
  }
  shares.y = isOfHead ? shares.y : along;
  return {isOfHead, shares};
}

std::optional<skinning::SurfacePoint> BodyChart::pointAt(const ChartPlace& place) const {
  constexpr double lowest = 0.0; // of the axis that rays start from, along the body
  constexpr double highest = 1.0;
  Vec3 start;
  Vec3 goal;
  if (place.isOfHead) {
    if (head_.empty()) {
      return std::nullopt;
    }
    start = middleOf(head_);
    goal = start + halfOf(head_) * place.place;
  } else {
    const double along = std::clamp(place.place.y, lowest, highest);
    const Widths there = widthsAt(place.place.y);
    start = widthsAt(along).middle;
    start.y = heightOf(along);
    goal = there.middle + there.half * place.place;
    goal.y = heightOf(place.place.y);
  }
  const skinning::PlacedSurface surface{places_, parts_.trunk};
  std::optional<skinning::SurfacePoint> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const skinning::SurfacePoint& point : skinning::crossedBy(surface, start, goal - start)) {
    const double far = glm::length(skinning::placeOf(surface, point) - goal);
    if (parts_.isOfHead[point.triangle] == place.isOfHead && far < distance) {
      nearest = point;
      distance = far;
    }
  }
  return nearest ? nearest : skinning::nearestOn(surface, goal);
}

} // namespace stretch::app
