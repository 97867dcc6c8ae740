#include "skinning/bind/mirrored_weights.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>

#include "core/scene/mesh_sequence.h"
#include "skinning/bind/weight_row.h"
#include "skinning/bind/welded.h"

namespace stretch::skinning {

namespace {

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

/// The plane between two sides, across an axis of the mesh's space.
struct Mirror {
  glm::length_t axis = 0;
  double middle = 0.0;

  [[nodiscard]] Vec3 other(Vec3 place) const {
    place[axis] = 2.0 * middle - place[axis];
    return place;
  }
};

Mirror mirrorOf(const std::vector<BindJoint>& joints, glm::length_t axis) {
  const auto [low, high] =
      std::ranges::minmax(joints, {}, [&](const BindJoint& joint) { return joint.place[axis]; });
  return {axis, 0.5 * (low.place[axis] + high.place[axis])};
}

// For each joint that on the other side; nothing where the skeleton is not the same on both, or has none
// aside. Of several at one place the first goes with the first.
std::vector<std::uint32_t> otherJoints(const std::vector<BindJoint>& joints, const Mirror& mirror,
                                       double tolerance) {
  std::vector<std::uint32_t> others(joints.size(), nothing);
  std::vector<bool> isTaken(joints.size(), false);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Vec3 wanted = mirror.other(joints[i].place);
    for (std::size_t j = 0; j < joints.size() && others[i] == nothing; ++j) {
      if (!isTaken[j] && glm::distance(joints[j].place, wanted) <= tolerance) {
        isTaken[j] = true;
        others[i] = static_cast<std::uint32_t>(j);
      }
    }
    if (others[i] == nothing) {
      return {};
    }
  }
  bool hasSides = false;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int parent = joints[i].parent;
    const int above = joints[others[i]].parent;
    const bool sameTree = (parent < 0) == (above < 0) &&
                          (parent < 0 || static_cast<int>(others[static_cast<std::size_t>(parent)]) == above);
    if (!sameTree || others[others[i]] != i) {
      return {};
    }
    hasSides = hasSides || others[i] != i;
  }
  return hasSides ? others : std::vector<std::uint32_t>();
}

// For each vertex one at its mirrored place, or nothing.
std::vector<std::uint32_t> otherVertices(std::span<const glm::vec3> positions, const Mirror& mirror) {
  const std::size_t count = positions.size();
  std::vector<glm::vec3> both(positions.begin(), positions.end());
  for (const glm::vec3& place : positions) {
    both.emplace_back(mirror.other(Vec3(place)));
  }
  const std::vector<std::uint32_t> leaders = weldedVertices(both);
  std::vector<std::uint32_t> firstOf(both.size(), nothing);
  std::vector<std::uint32_t> others(count);
  for (std::size_t v = count; v-- > 0;) {
    firstOf[leaders[v]] = static_cast<std::uint32_t>(v);
  }
  for (std::size_t v = 0; v < count; ++v) {
    others[v] = firstOf[leaders[count + v]];
  }
  return others;
}

} // namespace

void mirrorWeights(std::span<const glm::vec3> positions, const std::vector<BindJoint>& joints,
                   std::vector<Influences>& weights) {
  constexpr double together = 1e-4; // of the box
  std::vector<std::uint32_t> ofJoints;
  Mirror mirror;
  for (glm::length_t axis = 0; axis < 3 && ofJoints.empty() && !joints.empty(); ++axis) {
    mirror = mirrorOf(joints, axis);
    ofJoints = otherJoints(joints, mirror, together * boxDiagonal(positions));
  }
  if (ofJoints.empty()) {
    return;
  }
  const std::vector<std::uint32_t> ofVertices = otherVertices(positions, mirror);
  const std::vector<Influences> before = weights;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    if (ofVertices[v] == nothing) {
      continue;
    }
    WeightSum sum;
    sum.add(before[v], 1.0);
    const Influences& other = before[ofVertices[v]];
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      sum.add(static_cast<std::uint16_t>(ofJoints[other.bones[i]]), static_cast<double>(other.weights[i]));
    }
    weights[v] = sum.strongest(Influences::capacity);
  }
}

} // namespace stretch::skinning
