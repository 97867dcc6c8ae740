#include "rig/body/reading/limb_end.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"

namespace stretch::rig::body {

namespace {

constexpr std::size_t fanSize = 3;

// Beside the bone to another child, as joints that twist its mesh are.
bool liesOnBone(const BodyView& view, int candidate, int child) {
  constexpr double aside = 0.04;
  const Vec3 there = view.at(child) - view.at(candidate);
  return std::ranges::any_of(view.childrenOf(candidate), [&](int other) {
    const Vec3 bone = view.at(other) - view.at(candidate);
    const double length = glm::length(bone);
    const double along = length > 0.0 ? glm::dot(there, bone) / length : 0.0;
    return other != child && along > 0.0 && along < 0.95 * length &&
           glm::length(there - bone * (along / length)) < aside * length;
  });
}

std::vector<int> fanChildren(const BodyView& view, int candidate) {
  std::vector<int> children;
  for (const int child : view.childrenOf(candidate)) {
    const bool isTwist = view.name(child).twist || liesOnBone(view, candidate, child);
    if (!view.name(child).accessory && !isTwist) {
      children.push_back(child);
    }
  }
  return children;
}

Vec3 meanPosition(const BodyView& view, const std::vector<int>& candidates) {
  Vec3 sum(0.0);
  for (const int candidate : candidates) {
    sum += view.at(candidate);
  }
  return sum / static_cast<double>(candidates.size());
}

std::vector<int> palmsOf(const BodyView& view, int last) {
  std::vector<int> palms;
  const std::vector<int> fan = fanChildren(view, last);
  std::ranges::copy_if(fan, std::back_inserter(palms), [&](int child) { return view.name(child).palm; });
  return palms.empty() && fan.size() >= fanSize ? fan : palms;
}

std::optional<Vec3> farEndOfVertices(const BodyView& view, int last) {
  const std::vector<Vec3>& points = view.points[static_cast<std::size_t>(last)];
  if (points.empty()) {
    return std::nullopt;
  }
  const Vec3 joint = view.at(last);
  Vec3 sum(0.0);
  for (const Vec3& point : points) {
    sum += point - joint;
  }
  const double length = glm::length(sum);
  if (!(length > 1e-9 * view.size * static_cast<double>(points.size()))) {
    return std::nullopt;
  }
  const Vec3 along = sum / length;
  double farthest = 0.0;
  for (const Vec3& point : points) {
    farthest = std::max(farthest, glm::dot(point - joint, along));
  }
  return joint + along * farthest;
}

// Whether what lies beyond a joint goes along the ground and not down to it: toes.
bool toesFollow(const Extremity& leg, std::size_t joint, const Vec3& up, double near) {
  constexpr double flattest = 0.6; // sine
  const Vec3 on = leg.points[joint + 1] - leg.points[joint];
  const auto below = [&](const Vec3& point) { return glm::dot(leg.points[joint] - point, up) >= near; };
  return -glm::dot(on, up) < flattest * glm::length(on) && std::ranges::none_of(leg.points, below);
}

// Whether a leg's last joint is a knee: well above the ground, which its mesh reaches.
bool standsOnMesh(const BodyView& view, const Extremity& leg, const Vec3& up, double floor) {
  constexpr double wellAbove = 0.3; // of the height of its base
  constexpr double reached = 0.1;
  const double height = glm::dot(leg.points.front(), up) - floor;
  const bool isLast = leg.points.size() == leg.path.size();
  return isLast && glm::dot(leg.points.back(), up) - floor > wellAbove * height &&
         std::ranges::any_of(view.points[static_cast<std::size_t>(leg.path.back())], [&](const Vec3& point) {
           return glm::dot(point, up) - floor < reached * height;
         });
}

constexpr std::array limbWords{PartWord::leg, PartWord::arm, PartWord::wing, PartWord::fin};

bool isCalledLimb(const Extremity& row) {
  return row.word(PartWord::tail) <= 0.0 && // a feather of a tail
         std::ranges::any_of(limbWords, [&](PartWord word) { return row.word(word) > 0.0; });
}

bool isLone(const Extremity& row) {
  return row.path.size() == 1 && !row.tip.exists();
}

} // namespace

bool isFan(const BodyView& view, int candidate) {
  const std::vector<int> children = fanChildren(view, candidate);
  const auto palms = std::ranges::count_if(children, [&](int child) { return view.name(child).palm; });
  return children.size() >= fanSize || palms >= 2;
}

std::optional<EstimatedEnd> estimateEnd(const BodyView& view, int last) {
  const std::vector<int> palms = palmsOf(view, last);
  if (!palms.empty()) {
    return EstimatedEnd{meanPosition(view, palms), true};
  }
  const std::optional<Vec3> farEnd = farEndOfVertices(view, last);
  return farEnd ? std::optional(EstimatedEnd{*farEnd, false}) : std::nullopt;
}

Extremity withEstimatedEnd(const BodyView& view, Extremity row) {
  const std::optional<EstimatedEnd> end =
      isLone(row) && isCalledLimb(row) ? estimateEnd(view, row.path.back()) : std::nullopt;
  if (end) {
    row.points.push_back(end->position);
    row.length = polylineLength(row.points);
  }
  return row;
}

void dropLoneJoints(std::vector<Extremity>& left, std::vector<Extremity>& right) {
  for (const PartWord word : limbWords) {
    const auto isCalled = [&](const Extremity& row) { return row.word(word) > 0.0; };
    const auto isLimb = [&](const Extremity& row) { return !isLone(row) && isCalled(row); };
    if (std::ranges::any_of(left, isLimb) || std::ranges::any_of(right, isLimb)) {
      for (std::vector<Extremity>* const side : {&left, &right}) {
        std::erase_if(*side, [&](const Extremity& row) { return isLone(row) && isCalled(row); });
      }
    }
  }
}

std::size_t endOfLeg(const BodyView& view, const Extremity& leg, const Vec3& up, double floor) {
  constexpr double nearGround = 0.1; // of the height of its base
  const double near = nearGround * (glm::dot(leg.points.front(), up) - floor);
  const std::size_t last = leg.points.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    if (i < leg.path.size() && view.isDetached[static_cast<std::size_t>(leg.path[i])]) {
      return i;
    }
    const bool isLow = glm::dot(leg.points[i], up) - floor < near; // a thick sole lies below every joint
    if (i >= 2 && (isLow || toesFollow(leg, i, up, near))) {
      return i;
    }
  }
  return last + (standsOnMesh(view, leg, up, floor) ? 1 : 0);
}

} // namespace stretch::rig::body
