#include "skinning/bind/skeleton_ways.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace stretch::skinning {

double nearestAlong(const BoneLine& line, const Vec3& place) {
  const Vec3 along = line.end - line.start;
  const double squared = glm::dot(along, along);
  return squared > 0.0 ? std::clamp(glm::dot(place - line.start, along) / squared, 0.0, 1.0) : 0.0;
}

std::pair<OnBone, double> nearestOnBones(const std::vector<BoneLine>& lines,
                                         const std::vector<std::size_t>& among, const Vec3& place) {
  OnBone best;
  double nearest = std::numeric_limits<double>::max();
  for (const std::size_t index : among) {
    const BoneLine& line = lines[index];
    const double along = nearestAlong(line, place);
    const double distance = glm::distance(place, glm::mix(line.start, line.end, along));
    if (distance < nearest) {
      nearest = distance;
      best = {index, along};
    }
  }
  return {best, nearest};
}

SkeletonWays::SkeletonWays(const std::vector<BindJoint>& joints, const std::vector<BoneLine>& lines)
    : lines_(lines), generations_(joints.size(), 0), fromRoots_(joints.size(), 0.0) {
  for (const BindJoint& joint : joints) {
    parents_.push_back(joint.parent);
    places_.push_back(joint.place);
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (std::size_t above = i; joints[above].parent >= 0;) {
      const auto parent = static_cast<std::size_t>(joints[above].parent);
      fromRoots_[i] += glm::distance(places_[above], places_[parent]);
      ++generations_[i];
      above = parent;
    }
  }
}

Vec3 SkeletonWays::pointOf(const OnBone& on) const {
  return glm::mix(lines_[on.line].start, lines_[on.line].end, on.along);
}

double SkeletonWays::betweenJoints(int a, int b) const {
  const double both = fromRoots_[static_cast<std::size_t>(a)] + fromRoots_[static_cast<std::size_t>(b)];
  while (a != b) {
    int& lower =
        generations_[static_cast<std::size_t>(a)] > generations_[static_cast<std::size_t>(b)] ? a : b;
    if (parents_[static_cast<std::size_t>(lower)] < 0) { // two roots: straight from one to the other
      return both + glm::distance(places_[static_cast<std::size_t>(a)], places_[static_cast<std::size_t>(b)]);
    }
    lower = parents_[static_cast<std::size_t>(lower)];
  }
  return both - 2.0 * fromRoots_[static_cast<std::size_t>(a)];
}

double SkeletonWays::between(const OnBone& a, const OnBone& b) const {
  const Vec3 pointA = pointOf(a);
  const Vec3 pointB = pointOf(b);
  if (a.line == b.line) {
    return glm::distance(pointA, pointB);
  }
  double shortest = std::numeric_limits<double>::max();
  const BoneLine& lineA = lines_[a.line];
  const BoneLine& lineB = lines_[b.line];
  using End = std::pair<int, Vec3>;
  for (const End& endA : {End{lineA.joint, lineA.start}, End{lineA.endJoint, lineA.end}}) {
    for (const End& endB : {End{lineB.joint, lineB.start}, End{lineB.endJoint, lineB.end}}) {
      if (endA.first >= 0 && endB.first >= 0) {
        shortest =
            std::min(shortest, glm::distance(pointA, endA.second) + betweenJoints(endA.first, endB.first) +
                                   glm::distance(pointB, endB.second));
      }
    }
  }
  return shortest;
}

double SkeletonWays::kinship(const OnBone& a, const OnBone& b, double across) const {
  constexpr double kin = 2.5; // times as far along the skeleton as across
  constexpr double strangers = 4.0;
  const double ratio = between(a, b) / std::max(across, std::numeric_limits<double>::min());
  const double part = std::clamp((strangers - ratio) / (strangers - kin), 0.0, 1.0);
  return part * part * (3.0 - 2.0 * part);
}

} // namespace stretch::skinning
