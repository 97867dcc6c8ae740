#include "app/retarget/body_touch.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/vector_relational.hpp>

#include "app/retarget/body_parts.h"
#include "core/math/bounds.h"
#include "skinning/geometry/inside.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

std::optional<double> nearest(const std::vector<Vec3>& places, const std::vector<std::size_t>& vertices,
                              const std::vector<Triangle>& triangles) {
  if (vertices.empty() || triangles.empty()) {
    return std::nullopt;
  }
  double distance = std::numeric_limits<double>::infinity();
  for (const std::size_t vertex : vertices) {
    distance = skinning::distanceFrom({places, triangles}, places[vertex], distance);
  }
  return distance;
}

} // namespace

BodyTouch::BodyTouch(const rig::Skeleton& skeleton) : scene_(*skeleton.scene) {
  constexpr std::size_t mostOfLimbs = 600;
  constexpr std::size_t mostOfHand = 150;
  BodyParts parts = bodyPartsOf(skeleton);
  trunk_ = std::move(parts.trunk);
  std::vector<std::size_t> limbs = std::move(parts.lowerLegs);
  std::vector<std::size_t> held;
  for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
    ArmParts& arm = parts.arms[side];
    limbs.insert(limbs.end(), arm.forearm.begin(), arm.forearm.end());
    limbs.insert(limbs.end(), arm.hand.begin(), arm.hand.end());
    held.insert(held.end(), arm.held.begin(), arm.held.end());
    handVertices_[side] = thinned(arm.hand, mostOfHand);
    hands_[side] = std::move(arm.handTriangles);
  }
  std::ranges::sort(limbs);
  limbVertices_ = thinned(limbs, mostOfLimbs);
  heldVertices_ = thinned(held, mostOfLimbs);
}

HandDistances BodyTouch::handsAt(const FrameState& frame) const {
  const std::vector<Vec3> places = skinning::skinnedPositions(scene_, frame);
  HandDistances distances;
  for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
    distances.toTrunk[side] = nearest(places, handVertices_[side], trunk_);
  }
  distances.toOther = nearest(places, handVertices_[rig::leftSide], hands_[rig::rightSide]);
  return distances;
}

Inside BodyTouch::insideAt(const FrameState& frame) const {
  constexpr double isInside = 0.5; // of the winding number
  const std::vector<Vec3> places = skinning::skinnedPositions(scene_, frame);
  Bounds box;
  for (const Triangle& triangle : trunk_) {
    for (const std::uint32_t vertex : triangle) {
      box.add(places[vertex]);
    }
  }
  // 0 where it is outside.
  const auto depthOf = [&](std::size_t vertex) {
    const Vec3& place = places[vertex];
    const bool isNear =
        glm::all(glm::greaterThanEqual(place, box.low)) && glm::all(glm::lessThanEqual(place, box.high));
    return isNear && skinning::windingNumber({places, trunk_}, place) > isInside
               ? skinning::distanceFrom({places, trunk_}, place)
               : 0.0;
  };
  Inside inside;
  for (const std::size_t vertex : limbVertices_) {
    const double depth = depthOf(vertex);
    inside.share += depth > 0.0 ? 1.0 / static_cast<double>(limbVertices_.size()) : 0.0;
    inside.deepest = std::max(inside.deepest, depth);
  }
  for (const std::size_t vertex : heldVertices_) {
    inside.heldDeepest = std::max(inside.heldDeepest.value_or(0.0), depthOf(vertex));
  }
  return inside;
}

} // namespace stretch::app
