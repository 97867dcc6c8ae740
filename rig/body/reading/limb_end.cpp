#include "rig/body/reading/limb_end.h"

#include <algorithm>

#include <glm/geometric.hpp>

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

} // namespace stretch::rig::body
