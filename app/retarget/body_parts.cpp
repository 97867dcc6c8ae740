#include "app/retarget/body_parts.h"

#include <algorithm>
#include <optional>
#include <set>

#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

enum class Part {
  elsewhere,
  trunk,
  head,
  upperLimb,
  lowerLeg,
  leftForearm,
  rightForearm,
  leftHand,
  rightHand,
  leftHeld,
  rightHeld
};

constexpr std::array<Part, 2> forearmOf{Part::leftForearm, Part::rightForearm};
constexpr std::array<Part, 2> handOf{Part::leftHand, Part::rightHand};
constexpr std::array<Part, 2> heldOf{Part::leftHeld, Part::rightHeld};

// The first bone of a limb is its upper one, also where it is the only one.
void assign(const rig::Limb& limb, Part lower, Part end, std::vector<std::optional<Part>>& parts) {
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    parts[at(limb.joints[i])] = i == 0 ? Part::upperLimb : lower;
  }
  if (limb.endNode.exists()) {
    parts[at(limb.endNode)] = end;
  }
}

std::vector<Part> partsOfNodes(const rig::Skeleton& skeleton) {
  const Scene& scene = *skeleton.scene;
  std::vector<std::optional<Part>> own(scene.nodes.size());
  own[at(skeleton.carrier)] = Part::trunk;
  if (skeleton.head.exists()) {
    own[at(skeleton.head)] = Part::head;
  }
  for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
    assign(skeleton.legs[side].limb, Part::lowerLeg, Part::lowerLeg, own);
    if (skeleton.arms[side]) {
      assign(skeleton.arms[side]->limb, forearmOf[side], handOf[side], own);
    }
  }
  std::vector<Part> parts(scene.nodes.size(), Part::elsewhere);
  for (const NodeIndex node : parentsFirst(scene)) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    parts[at(node)] = own[at(node)].value_or(parent.exists() ? parts[at(parent)] : Part::elsewhere);
  }
  return parts;
}

// Rigid meshes on a hand that has skinned vertices are held by it.
std::vector<Part> partsOfVertices(const rig::Skeleton& skeleton) {
  const Scene& scene = *skeleton.scene;
  const std::vector<Part> partOf = partsOfNodes(skeleton);
  const std::vector<NodeIndex> nodes = skinning::strongestNodes(scene);
  const std::set<NodeIndex> joints = skinJoints(scene);
  std::vector<Part> parts;
  std::set<Part> skinned;
  for (const NodeIndex node : nodes) {
    parts.push_back(node.exists() ? partOf[at(node)] : Part::elsewhere);
    if (joints.contains(node)) {
      skinned.insert(parts.back());
    }
  }
  for (std::size_t vertex = 0; vertex < parts.size(); ++vertex) {
    for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
      if (parts[vertex] == handOf[side] && skinned.contains(handOf[side]) &&
          !joints.contains(nodes[vertex])) {
        parts[vertex] = heldOf[side];
      }
    }
  }
  return parts;
}

} // namespace

BodyParts bodyPartsOf(const rig::Skeleton& skeleton) {
  const std::vector<Part> parts = partsOfVertices(skeleton);
  BodyParts body;
  for (std::size_t vertex = 0; vertex < parts.size(); ++vertex) {
    for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
      if (parts[vertex] == handOf[side]) {
        body.arms[side].hand.push_back(vertex);
      } else if (parts[vertex] == heldOf[side]) {
        body.arms[side].held.push_back(vertex);
      } else if (parts[vertex] == forearmOf[side]) {
        body.arms[side].forearm.push_back(vertex);
      }
    }
    if (parts[vertex] == Part::lowerLeg) {
      body.lowerLegs.push_back(vertex);
    }
  }
  for (const Triangle& triangle : skinning::drawnTriangles(*skeleton.scene)) {
    const auto count = [&](Part part) {
      return std::ranges::count_if(triangle, [&](std::uint32_t vertex) { return parts[vertex] == part; });
    };
    const auto middle = count(Part::trunk) + count(Part::head);
    if (middle > 0 && middle + count(Part::upperLimb) == 3) {
      body.trunk.push_back(triangle);
      body.isOfHead.push_back(count(Part::head) == 3);
    }
    for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
      if (count(handOf[side]) == 3) {
        body.arms[side].handTriangles.push_back(triangle);
      }
    }
  }
  return body;
}

std::vector<std::size_t> thinned(const std::vector<std::size_t>& vertices, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (vertices.size() + most - 1) / most);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < vertices.size(); i += step) {
    kept.push_back(vertices[i]);
  }
  return kept;
}

} // namespace stretch::app
