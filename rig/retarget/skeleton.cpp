#include "rig/retarget/skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/lower_case.h"
#include "core/math/finite.h"
#include "core/math/polyline.h"
#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "rig/adjust/foot_roll.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/controllers/finger_joints.h"
#include "rig/reach/bind_places.h"
#include "rig/reach/limb_topology.h"

namespace stretch::rig {

namespace {

const Vec3 skyward(0.0, 1.0, 0.0);

// The joint between the trunk and the arm's base that is farthest up: none of the other arm hangs on it.
NodeIndex shoulderOf(const Scene& scene, const Limb& arm, const Limb* other, const Skeleton& skeleton,
                     const std::string& side) {
  if (const NodeIndex named = humanoidNode(scene, side + "Shoulder"); named.exists()) {
    return named;
  }
  const std::set<NodeIndex> joints = skinJoints(scene);
  NodeIndex shoulder;
  for (NodeIndex node = scene.nodes[at(arm.joints.front())].parent; node.exists();
       node = scene.nodes[at(node)].parent) {
    const bool isTrunk =
        node == skeleton.hips || std::ranges::find(skeleton.spine, node) != skeleton.spine.end();
    const bool carriesOther = other != nullptr && isAncestorOrSelf(scene, node, other->joints.front());
    if (isTrunk || carriesOther || other == nullptr) {
      break;
    }
    shoulder = joints.empty() || joints.contains(node) ? node : shoulder;
  }
  return shoulder;
}

// What a node's name, or its entry in the humanoid table, says of a finger; empty: nothing.
std::string fingerNamed(const std::string& text) {
  constexpr std::array<std::pair<const char*, const char*>, 6> words{{{"thumb", "thumb"},
                                                                      {"index", "index"},
                                                                      {"middle", "middle"},
                                                                      {"ring", "ring"},
                                                                      {"pinky", "little"},
                                                                      {"little", "little"}}};
  const std::string low = lowerCase(text);
  for (const auto& [word, finger] : words) {
    if (low.find(word) != std::string::npos) {
      return finger;
    }
  }
  return {};
}

std::string tableName(const Scene& scene, NodeIndex node) {
  const auto entry =
      std::ranges::find_if(scene.humanoid, [&](const auto& bone) { return bone.second == node; });
  return entry == scene.humanoid.end() ? std::string() : entry->first;
}

bool isOfPalm(const Scene& scene, NodeIndex node) {
  const std::string low = lowerCase(scene.nodes[at(node)].name);
  return low.find("metacarpal") != std::string::npos || low.find("palm") != std::string::npos;
}

Fingers fingersOf(const Scene& scene, const Limb& arm) {
  Fingers fingers;
  for (std::vector<NodeIndex>& chain : fingerChains(scene, arm)) {
    const std::string listed = tableName(scene, chain.front());
    const std::string finger = fingerNamed(listed.empty() ? scene.nodes[at(chain.front())].name : listed);
    if (finger.empty()) {
      continue;
    }
    if (finger != "thumb" && listed.empty() && chain.size() > 1 && isOfPalm(scene, chain.front())) {
      chain.erase(chain.begin());
    }
    fingers.emplace(finger, std::move(chain));
  }
  return fingers;
}

void addTrunk(const Scene& scene, const Body& biped, Skeleton& skeleton) {
  const Limb* const neck = limbAt(biped.limbs, biped::neck);
  if (neck != nullptr) {
    skeleton.neck = neck->joints;
  }
  skeleton.head = biped.head.exists() || neck == nullptr ? biped.head : neck->endNode;
  std::erase(skeleton.neck, skeleton.head);
  if (const Limb* const spine = limbAt(biped.limbs, biped::spine)) {
    skeleton.spine = spine->joints;
    const NodeIndex end = spine->endNode;
    const bool isAbove = end == skeleton.head || std::ranges::find(skeleton.neck, end) != skeleton.neck.end();
    if (end.exists() && !isAbove) {
      skeleton.spine.push_back(end);
    }
  }
  std::erase(skeleton.spine, skeleton.hips);
  // What bears both legs and the trunk travels; a pelvis beside the spine does not.
  skeleton.carrier = commonAncestor(scene, skeleton.legs[leftSide].limb.joints.front(),
                                    skeleton.legs[rightSide].limb.joints.front());
  for (const NodeIndex other :
       {skeleton.hips, skeleton.spine.empty() ? NodeIndex::none : skeleton.spine.front()}) {
    if (other.exists() && skeleton.carrier.exists()) {
      const NodeIndex common = commonAncestor(scene, skeleton.carrier, other);
      skeleton.carrier = common.exists() ? common : skeleton.carrier;
    }
  }
}

void addArms(const Scene& scene, const Body& biped, Skeleton& skeleton) {
  const std::array<const Limb*, 2> limbs{limbAt(biped.limbs, biped::leftArm),
                                         limbAt(biped.limbs, biped::rightArm)};
  for (const std::size_t side : {leftSide, rightSide}) {
    if (limbs[side] == nullptr) {
      continue;
    }
    const Limb& limb = *limbs[side];
    skeleton.arms[side] = SkeletonArm{
        limb, shoulderOf(scene, limb, limbs[1 - side], skeleton, side == leftSide ? "left" : "right"),
        fingersOf(scene, limb)};
  }
}

std::optional<double> soleHeight(const Scene& scene, const SkeletonLeg& leg, const BindPlaces& places) {
  std::optional<double> lowest;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Bounds& mesh = places.meshes[i];
    if (!mesh.empty() && isAncestorOrSelf(scene, leg.footing, NodeIndex(i))) {
      lowest = std::min(lowest.value_or(mesh.low.y), mesh.low.y);
    }
  }
  return lowest;
}

// Many bind poses stand a little off the floor that the clips are made for.
double groundOf(const Skeleton& skeleton) {
  constexpr double nearFloor = 0.1; // of the height
  const std::optional<double>& left = skeleton.legs[leftSide].sole;
  const std::optional<double>& right = skeleton.legs[rightSide].sole;
  if (!left || !right) {
    return 0.0;
  }
  const double ground = 0.5 * (*left + *right);
  return std::abs(ground) < nearFloor * skeleton.height ? ground : 0.0;
}

SkeletonLeg legOf(const Scene& scene, const Body& biped, const Limb& limb, const BindPlaces& places) {
  SkeletonLeg leg;
  leg.limb = limb;
  leg.footing = limb.endNode.exists() ? limb.endNode : limb.joints.back();
  leg.ballInFooting = limb.endNode.exists() ? Vec3(0.0) : limb.endOffset;
  const LimbTopology topology = limbTopology(scene, limb, biped.limbs, places);
  const FootRoll roll = footRoll(scene, limb, topology, places);
  leg.toes = roll.toes;
  if (glm::length(roll.axis) > 0.0) {
    leg.ballInFooting = roll.ball;
  }
  leg.sole = soleHeight(scene, leg, places);
  leg.length = polylineLength(limbPoints(limb, places.worlds));
  return leg;
}

// From the middle of the feet to the middle of the hips, or on to the head.
Vec3 bodyUp(const std::array<const Limb*, 2>& legs, NodeIndex head, const std::vector<Mat4>& worlds) {
  const auto base = [&](const Limb& leg) { return positionOf(worlds[at(leg.joints.front())]); };
  const Vec3 top = head.exists() ? positionOf(worlds[at(head)]) : 0.5 * (base(*legs[0]) + base(*legs[1]));
  return top - 0.5 * (endPosition(*legs[0], worlds) + endPosition(*legs[1], worlds));
}

Vec3 bodyLeft(const Skeleton& skeleton) {
  const auto base = [&](const Limb& limb) { return positionOf(skeleton.bind[at(limb.joints.front())]); };
  Vec3 left = base(skeleton.legs[leftSide].limb) - base(skeleton.legs[rightSide].limb);
  if (skeleton.arms[leftSide] && skeleton.arms[rightSide]) {
    left += base(skeleton.arms[leftSide]->limb) - base(skeleton.arms[rightSide]->limb);
  }
  return left;
}

// The world axis nearest to a direction, where it is near at all; else the direction.
Vec3 snapped(const Vec3& direction) {
  constexpr double near = 5.0 * pi / 180.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 unit(0.0);
    unit[static_cast<int>(axis)] = direction[static_cast<int>(axis)] < 0.0 ? -1.0 : 1.0;
    if (glm::dot(unit, direction) > std::cos(near)) {
      return unit;
    }
  }
  return direction;
}

bool addAxes(Skeleton& skeleton) {
  const Vec3 up =
      bodyUp({&skeleton.legs[leftSide].limb, &skeleton.legs[rightSide].limb}, skeleton.head, skeleton.bind);
  const Vec3 left = bodyLeft(skeleton);
  if (!(glm::length(up) > 0.0) || !(glm::length(glm::cross(left, up)) > 1e-9 * glm::length(up))) {
    return false;
  }
  constexpr double leastUpright = 0.7; // cosine
  skeleton.isUpright = glm::dot(glm::normalize(up), skyward) > leastUpright;
  const Vec3 axis = skeleton.isUpright ? skyward : glm::normalize(up);
  const Vec3 across = left - axis * glm::dot(left, axis);
  if (!(glm::length(across) > 0.0)) {
    return false;
  }
  const Vec3 side = snapped(glm::normalize(across));
  skeleton.axes = Mat3(side, axis, glm::normalize(glm::cross(side, axis)));
  return std::isfinite(skeleton.axes[2].x + skeleton.axes[2].y + skeleton.axes[2].z);
}

// The topmost joint of the skin that holds the hips.
std::pair<NodeIndex, const Skin*> anchorOfSkin(const Scene& scene, NodeIndex hips) {
  for (const Skin& skin : scene.skins) {
    const auto isJoint = [&](NodeIndex node) {
      return std::ranges::find(skin.joints, node) != skin.joints.end();
    };
    NodeIndex anchor = isJoint(hips) ? hips : NodeIndex::none;
    while (anchor.exists() && scene.nodes[at(anchor)].parent.exists() &&
           isJoint(scene.nodes[at(anchor)].parent)) {
      anchor = scene.nodes[at(anchor)].parent;
    }
    if (anchor.exists()) {
      return {anchor, &skin};
    }
  }
  return {NodeIndex::none, nullptr};
}

// How far a bind pose is from standing upright on the floor: radians and heights.
double offStance(const Scene& scene, const Body& biped, const std::array<const Limb*, 2>& legs,
                 const BindPlaces& places) {
  const Vec3 up = bodyUp(legs, biped.head, places.worlds);
  double lowest = 0.0;
  for (const Limb* const leg : legs) {
    SkeletonLeg foot;
    foot.footing = leg->endNode.exists() ? leg->endNode : leg->joints.back();
    const std::optional<double> sole = soleHeight(scene, foot, places);
    lowest = std::max(lowest, std::abs(sole.value_or(0.0)) / biped.height);
  }
  return angleBetween(up, skyward) + lowest;
}

// The bind pose stands where its topmost joint stands at rest. Where that joint rests in the middle of a
// motion, it stands as its parent does: upright and on the floor.
BindPlaces stancePlaces(const Scene& scene, const Body& biped, NodeIndex hips,
                        const std::array<const Limb*, 2>& legs) {
  body::BindPose pose = body::placeBindPose(scene);
  BindPlaces places = bindPlaces(scene, pose);
  const auto [anchor, skin] = anchorOfSkin(scene, hips);
  const NodeIndex above = anchor.exists() ? scene.nodes[at(anchor)].parent : NodeIndex::none;
  if (skin == nullptr) {
    return places;
  }
  const auto slot = static_cast<std::size_t>(std::ranges::find(skin->joints, anchor) - skin->joints.begin());
  const Mat4 parent = above.exists() ? pose.worlds[at(above)] : Mat4(1.0);
  const Mat4 model =
      slot < skin->inverseBind.size() ? pose.worlds[at(anchor)] * skin->inverseBind[slot] : parent;
  const Mat4 moved = parent * glm::inverse(model);
  if (!isFinite(moved) || std::abs(std::cbrt(std::abs(glm::determinant(Mat3(moved)))) - 1.0) > 0.01) {
    return places;
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (isAncestorOrSelf(scene, anchor, NodeIndex(i))) {
      pose.worlds[i] = moved * pose.worlds[i];
    }
  }
  for (std::size_t i = 0; i < scene.skins.size(); ++i) {
    const std::vector<NodeIndex>& joints = scene.skins[i].joints;
    const bool isBelow = !joints.empty() && isAncestorOrSelf(scene, anchor, joints.front());
    pose.placements[i] = isBelow ? moved * pose.placements[i] : pose.placements[i];
  }
  BindPlaces settled = bindPlaces(scene, pose);
  constexpr double clearlyBetter = 0.02;
  const bool isBetter =
      offStance(scene, biped, legs, settled) + clearlyBetter < offStance(scene, biped, legs, places);
  return isBetter ? settled : places;
}

NodeIndex hipsOf(const Scene& scene, const Body& biped, const Limb& leg) {
  return biped.hips.exists() ? biped.hips : scene.nodes[at(leg.joints.front())].parent;
}

} // namespace

Vec3 SkeletonLeg::ball(const std::vector<Mat4>& worlds) const {
  return transformPoint(worlds[at(footing)], ballInFooting);
}

std::optional<Skeleton> skeletonOf(const Scene& scene, const Body& biped) {
  const Limb* const left = limbAt(biped.limbs, biped::leftLeg);
  const Limb* const right = limbAt(biped.limbs, biped::rightLeg);
  if (!biped.isBiped || left == nullptr || right == nullptr) {
    return std::nullopt;
  }
  Skeleton skeleton;
  skeleton.scene = &scene;
  skeleton.height = biped.height;
  skeleton.hips = hipsOf(scene, biped, *left);
  const BindPlaces places = stancePlaces(scene, biped, skeleton.hips, {left, right});
  skeleton.bind = places.worlds;
  for (const Mat4& world : skeleton.bind) {
    skeleton.bindTurns.push_back(rotationOf(world));
  }
  skeleton.legs = {legOf(scene, biped, *left, places), legOf(scene, biped, *right, places)};
  skeleton.groundHeight = groundOf(skeleton);
  addTrunk(scene, biped, skeleton);
  addArms(scene, biped, skeleton);
  const bool isSound = skeleton.legs[leftSide].length > 0.0 && skeleton.legs[rightSide].length > 0.0 &&
                       skeleton.carrier.exists() && addAxes(skeleton);
  return isSound ? std::optional(std::move(skeleton)) : std::nullopt;
}

} // namespace stretch::rig
