#include "rig/body/reading/long_row.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace stretch::rig::body {

bool isEven(const Extremity& row) {
  constexpr double shortest = 0.01; // of the row: joints that stand on one another have no bone between
                                    // them
  double longest = 0.0;
  double bones = 0.0;
  for (std::size_t i = 1; i < row.points.size(); ++i) {
    const double bone = glm::distance(row.points[i - 1], row.points[i]);
    longest = std::max(longest, bone);
    bones += bone > shortest * row.length ? 1.0 : 0.0;
  }
  return longest < std::max(0.45, 1.5 / bones) * row.length;
}

bool hasNamedLegs(const BodyView& view) {
  constexpr double clear = 0.8;
  const auto isNamed = [&](Side side) {
    return std::ranges::any_of(view.names, [&](const NameEvidence& name) {
      return name.side == side && std::max(name.role(Role::thigh), name.role(Role::shin)) >= clear;
    });
  };
  return isNamed(Side::left) && isNamed(Side::right);
}

bool startsAtAnchor(const BodyView& view, const Extremity& row) {
  constexpr double longer = 1.5; // than any other bone
  if (!view.points[static_cast<std::size_t>(row.path.front())].empty()) {
    return false;
  }
  const Vec3 first = row.points[1] - row.points[0];
  double longest = 0.0;
  for (std::size_t i = 2; i < row.points.size(); ++i) {
    longest = std::max(longest, glm::distance(row.points[i - 1], row.points[i]));
  }
  // Where nothing tells which joints move vertices, only a bone far shorter than the others is no bone.
  const double meanBone = row.length / static_cast<double>(row.points.size() - 1);
  const double shortBone = 0.06 * row.length;
  const double hardlyABone = view.hasVertices ? shortBone : std::min(shortBone, 0.3 * meanBone);
  const bool turnsBack = glm::dot(first, row.points[2] - row.points[1]) < 0.0;
  const bool isOff = view.hasVertices && (glm::length(first) > longer * longest || turnsBack);
  return glm::length(first) < hardlyABone || isOff;
}

} // namespace stretch::rig::body
