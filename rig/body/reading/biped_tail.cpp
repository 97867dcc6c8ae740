#include "rig/body/reading/biped_tail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <glm/geometric.hpp>

#include "rig/body/evidence/name_text.h"
#include "rig/body/reading/extremities.h"
#include "rig/body/reading/middle_parts.h"

namespace stretch::rig::body {

namespace {

constexpr std::array<std::string_view, 20> worn{
    "coat", "cape", "cloak", "robe", "skirt", "dress", "cloth",  "shirt",  "scarf",    "sash",
    "belt", "rope", "hair",  "pony", "sword", "blade", "sheath", "weapon", "scabbard", "quiver"};

const std::string& nameOf(const BodyView& view, int joint) {
  return view.called[static_cast<std::size_t>(joint)];
}

bool isWorn(const std::string& name) {
  return std::ranges::any_of(nameChunks(name), [](const NameChunk& chunk) {
    return std::ranges::any_of(
        worn, [&](std::string_view word) { return chunk.whole.find(word) != std::string::npos; });
  });
}

double lengthOf(const BodyView& view, const std::vector<int>& row) {
  double length = 0.0;
  for (std::size_t i = 1; i < row.size(); ++i) {
    length += glm::distance(view.at(row[i - 1]), view.at(row[i]));
  }
  return length;
}

// Whether a joint is one of two that stand on either side of what carries them, as the flukes of a fin do.
bool isOfPair(const BodyView& view, const MirrorPlane& plane, int joint) {
  constexpr double aside = 0.01; // of the body
  const Vec3 image = plane.mirrored(view.at(joint));
  return std::abs(plane.lateral(view.at(joint))) > aside * view.size &&
         std::ranges::any_of(view.childrenOf(view.parentOf(joint)), [&](int other) {
           return glm::distance(view.at(other), image) < aside * view.size;
         });
}

// From a joint on to what reaches farthest, and to where it parts in two.
std::vector<int> rowFrom(const BodyView& view, const MirrorPlane& plane, int joint) {
  std::vector<int> row{joint};
  while (!view.childrenOf(row.back()).empty()) {
    const int next = *std::ranges::max_element(view.childrenOf(row.back()), {}, [&](int child) {
      return glm::distance(view.at(child), view.at(row.back())) + view.reach[static_cast<std::size_t>(child)];
    });
    if (isOfPair(view, plane, next)) {
      break;
    }
    row.push_back(next);
  }
  return row;
}

// Goes back and stays in the middle, one joint after the other. A body without legs may coil on its tail.
bool hasShape(const BodyView& view, const MirrorPlane& plane, const Sides& sides, bool hasLegs,
              const std::vector<int>& row) {
  constexpr double aside = 0.01;    // of the body
  constexpr double shortest = 0.2;  // of the body
  constexpr double leastBack = 0.6; // cosine
  const Vec3 back = glm::cross(Vec3(0, 1, 0), sides.leftIsPositive ? plane.normal : -plane.normal);
  const Vec3 way = view.at(row.back()) - view.at(row.front());
  return row.size() > 3 && lengthOf(view, row) > shortest * view.size &&
         glm::dot(way, back) > leastBack * glm::length(way) && std::ranges::all_of(row, [&](int joint) {
           return view.childrenOf(joint).size() < 2 &&
                  (!hasLegs || std::abs(plane.lateral(view.at(joint))) < aside * view.size);
         });
}

} // namespace

bool isNamedTail(const BodyView& view, const std::vector<int>& row) {
  return std::ranges::any_of(row, [&](int joint) { return isCalledTail(view, joint); });
}

std::vector<int> tailOfBiped(const BodyView& view, const MirrorPlane& plane, const Sides& sides,
                             const Trunk& trunk, const std::vector<Limb>& limbs) {
  constexpr double aside = 0.02;    // of the body, of the first joint
  constexpr double shortest = 0.03; // of the body
  std::vector<int> taken{trunk.head};
  for (const Limb& limb : limbs) {
    std::ranges::transform(limb.joints, std::back_inserter(taken),
                           [&](NodeIndex node) { return view.candidateOfNode[at(node)]; });
  }
  std::set<int> carriers(trunk.spine.begin(), trunk.spine.end());
  for (int joint = trunk.hips; joint >= 0; joint = view.parentOf(joint)) {
    carriers.insert(joint);
  }
  const bool hasLegs = std::ranges::any_of(limbs, isLeg);
  std::vector<int> named;
  std::vector<std::vector<int>> shaped;
  for (int joint = 0; joint < view.count(); ++joint) {
    const auto carries = [&](int other) { return other >= 0 && view.isAboveOrSelf(joint, other); };
    if (!carriers.contains(view.parentOf(joint)) || !view.movesMesh(joint) ||
        std::ranges::any_of(taken, carries) || std::abs(plane.lateral(view.at(joint))) > aside * view.size) {
      continue;
    }
    const std::vector<int> row = rowFrom(view, plane, joint);
    if (row.size() < 2 || std::ranges::any_of(row, [&](int one) { return isWorn(nameOf(view, one)); })) {
      continue;
    }
    const std::size_t rump = jointsOfRump(view, row);
    const bool isLeft = rump + 1 < row.size(); // a bone of the tail
    const std::vector<int> tail(row.begin() + static_cast<std::ptrdiff_t>(isLeft ? rump : 0), row.end());
    if (isNamedTail(view, row) &&
        lengthOf(view, tail) > std::max(shortest * view.size, lengthOf(view, named))) {
      named = tail;
    }
    if (hasShape(view, plane, sides, hasLegs, row)) {
      shaped.push_back(row);
    }
  }
  return !named.empty() || shaped.size() != 1 ? named : shaped.front();
}

} // namespace stretch::rig::body
