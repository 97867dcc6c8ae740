#include "app/forecast/body_touch.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/vector_relational.hpp>

#include "core/math/bounds.h"
#include "skinning/geometry/inside.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

enum class Part { elsewhere, trunk, upperLimb, lowerLimb, leftHand, rightHand };

constexpr std::array<Part, 2> handOf{Part::leftHand, Part::rightHand};

// The first bone of a limb is its upper one, also where it is the only one.
void assign(const rig::Limb& limb, Part end, std::vector<std::optional<Part>>& parts) {
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    parts[at(limb.joints[i])] = i == 0 ? Part::upperLimb : Part::lowerLimb;
  }
  if (limb.endNode.exists()) {
    parts[at(limb.endNode)] = end;
  }
}

std::vector<Part> partsOfNodes(const rig::Skeleton& skeleton) {
  const Scene& scene = *skeleton.scene;
  std::vector<std::optional<Part>> own(scene.nodes.size());
  own[at(skeleton.carrier)] = Part::trunk;
  for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
    assign(skeleton.legs[side].limb, Part::lowerLimb, own);
    if (skeleton.arms[side]) {
      assign(skeleton.arms[side]->limb, handOf[side], own);
    }
  }
  std::vector<Part> parts(scene.nodes.size(), Part::elsewhere);
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    parts[at(node)] = own[at(node)].value_or(parent.exists() ? parts[at(parent)] : Part::elsewhere);
  }
  return parts;
}

void thin(std::vector<std::size_t>& vertices, std::size_t most) {
  const std::size_t step = (vertices.size() + most - 1) / most;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < vertices.size(); i += step) {
    kept.push_back(vertices[i]);
  }
  vertices = std::move(kept);
}

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
  const std::vector<Part> partOf = partsOfNodes(skeleton);
  std::vector<Part> parts;
  for (const NodeIndex node : skinning::strongestNodes(scene_)) {
    parts.push_back(node.exists() ? partOf[at(node)] : Part::elsewhere);
  }
  for (std::size_t vertex = 0; vertex < parts.size(); ++vertex) {
    for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
      if (parts[vertex] == handOf[side]) {
        handVertices_[side].push_back(vertex);
      }
    }
    if (parts[vertex] >= Part::lowerLimb) {
      limbVertices_.push_back(vertex);
    }
  }
  for (const Triangle& triangle : skinning::drawnTriangles(scene_)) {
    const auto isAll = [&](auto fits) {
      return std::ranges::all_of(triangle, [&](std::uint32_t vertex) { return fits(parts[vertex]); });
    };
    const bool hasTrunk =
        std::ranges::any_of(triangle, [&](std::uint32_t vertex) { return parts[vertex] == Part::trunk; });
    if (hasTrunk && isAll([](Part part) { return part == Part::trunk || part == Part::upperLimb; })) {
      trunk_.push_back(triangle);
    }
    for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
      if (isAll([&](Part part) { return part == handOf[side]; })) {
        hands_[side].push_back(triangle);
      }
    }
  }
  constexpr std::size_t mostOfLimbs = 600;
  constexpr std::size_t mostOfHand = 150;
  thin(limbVertices_, mostOfLimbs);
  thin(handVertices_[rig::leftSide], mostOfHand);
  thin(handVertices_[rig::rightSide], mostOfHand);
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
  Inside inside;
  for (const std::size_t vertex : limbVertices_) {
    const Vec3& place = places[vertex];
    const bool isNear =
        glm::all(glm::greaterThanEqual(place, box.low)) && glm::all(glm::lessThanEqual(place, box.high));
    if (isNear && skinning::windingNumber({places, trunk_}, place) > isInside) {
      inside.share += 1.0 / static_cast<double>(limbVertices_.size());
      inside.deepest = std::max(inside.deepest, skinning::distanceFrom({places, trunk_}, place));
    }
  }
  return inside;
}

} // namespace stretch::app
