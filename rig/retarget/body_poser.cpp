#include "rig/retarget/body_poser.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "rig/retarget/thin_keys.h"

namespace stretch::rig {

namespace {

Mat4 worldAbove(NodeIndex parent, const std::vector<Mat4>& worlds) {
  return parent.exists() ? worlds[at(parent)] : Mat4(1.0);
}

// From a turn of the space below a parent to the turn that it is beside the parent's in the world, and back:
// below a mirror, which rotationOf takes for one of the x axis, turns about y and z go the other way.
Quat mirroredBelow(const Mat4& parent, const Quat& turn) {
  return glm::determinant(Mat3(parent)) < 0.0 ? Quat(turn.w, turn.x, -turn.y, -turn.z) : turn;
}

} // namespace

BodyPoser::BodyPoser(const Skeleton& skeleton, const std::vector<JointPair>& pairs)
    : skeleton_(skeleton), order_(parentsFirst(*skeleton.scene)), pairOf_(skeleton.scene->nodes.size(), -1) {
  const Scene& scene = *skeleton.scene;
  bindLocals_.resize(scene.nodes.size());
  bindMatrices_.resize(scene.nodes.size());
  reach_.resize(scene.nodes.size(), 0.0);
  for (const NodeIndex node : order_) {
    const Mat4 parent = worldAbove(scene.nodes[at(node)].parent, skeleton.bind);
    bindMatrices_[at(node)] = glm::inverse(parent) * skeleton.bind[at(node)];
    bindLocals_[at(node)] = toTransform(bindMatrices_[at(node)]);
    const Vec3 place = positionOf(skeleton.bind[at(node)]);
    for (NodeIndex above = scene.nodes[at(node)].parent; above.exists();
         above = scene.nodes[at(above)].parent) {
      reach_[at(above)] =
          std::max(reach_[at(above)], glm::length(place - positionOf(skeleton.bind[at(above)])));
    }
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairOf_[at(pairs[i].joint)] = static_cast<int>(i);
  }
  for (const std::size_t side : {leftSide, rightSide}) {
    const Limb& limb = skeleton.legs[side].limb;
    const bool isLoose = limb.endNode.exists() && !isAncestorOrSelf(scene, limb.joints.back(), limb.endNode);
    loose_[side] = isLoose ? limb.endNode : NodeIndex::none;
  }
}

std::optional<std::size_t> BodyPoser::placedFoot(NodeIndex node) const {
  for (const std::size_t side : {leftSide, rightSide}) {
    if (loose_[side].exists() && loose_[side] == node) {
      return side;
    }
  }
  return std::nullopt;
}

BodyPose BodyPoser::pose(const std::vector<Quat>& turns, const Vec3& shift, const FootPlaces& feet) const {
  const Scene& scene = *skeleton_.scene;
  BodyPose pose{bindLocals_, std::vector<Mat4>(scene.nodes.size(), Mat4(1.0))};
  std::vector<Quat> worldTurns(scene.nodes.size(), Quat(1.0, 0.0, 0.0, 0.0));
  for (const NodeIndex node : order_) {
    const std::size_t index = at(node);
    const NodeIndex above = scene.nodes[index].parent;
    const Mat4 parent = worldAbove(above, pose.worlds);
    const Quat parentTurn = above.exists() ? worldTurns[at(above)] : Quat(1.0, 0.0, 0.0, 0.0);
    Transform& local = pose.locals[index];
    const std::optional<std::size_t> foot = placedFoot(node);
    const bool isPlaced = foot && feet[*foot];
    const bool isMoved = node == skeleton_.carrier;
    if (pairOf_[index] >= 0) {
      local.rotation =
          mirroredBelow(parent, glm::normalize(glm::inverse(parentTurn) * turns[at(pairOf_[index])]));
    }
    if (isMoved) {
      local.translation += glm::inverse(Mat3(parent)) * shift;
    } else if (isPlaced) {
      local.translation = transformPoint(glm::inverse(parent), *feet[*foot]);
    }
    const bool isChanged = pairOf_[index] >= 0 || isMoved || isPlaced;
    worldTurns[index] = parentTurn * mirroredBelow(parent, local.rotation);
    pose.worlds[index] = parent * (isChanged ? toMatrix(local) : bindMatrices_[index]);
  }
  return pose;
}

// World units in one unit of the space that a node moves in.
double BodyPoser::scaleAbove(NodeIndex node) const {
  constexpr double smallest = 1e-12;
  const NodeIndex above = skeleton_.scene->nodes[at(node)].parent;
  return above.exists() ? std::max(glm::length(Vec3(skeleton_.bind[at(above)][0])), smallest) : 1.0;
}

// What the clip does not move stands as in the bind pose, which may not be how the file has it at rest.
void BodyPoser::addStill(NodeIndex node, float time, double tolerance, std::vector<Track>& tracks) const {
  const Transform& rest = skeleton_.scene->nodes[at(node)].rest;
  const Transform& bind = bindLocals_[at(node)];
  const double scale = scaleAbove(node);
  if (pairOf_[at(node)] < 0 && angleBetween(rest.rotation, bind.rotation) > 1e-3) {
    tracks.push_back(thinTurns(node, {time}, {bind.rotation}, 1.0));
  }
  const bool isMoved = node == skeleton_.carrier || placedFoot(node).has_value();
  if (!isMoved && glm::length(rest.translation - bind.translation) * scale > tolerance) {
    tracks.push_back(thinPlaces(node, {time}, {bind.translation}, 1.0));
  }
}

std::vector<Track> BodyPoser::tracks(const std::vector<float>& times, const std::vector<BodyPose>& poses,
                                     double tolerance) const {
  std::vector<Track> tracks;
  const std::set<NodeIndex> joints = skinJoints(*skeleton_.scene);
  for (const NodeIndex node : order_) {
    if (pairOf_[at(node)] >= 0) {
      std::vector<Quat> turns;
      turns.reserve(poses.size());
      for (const BodyPose& pose : poses) {
        turns.push_back(pose.locals[at(node)].rotation);
      }
      const double reach = std::max(reach_[at(node)], 0.05 * skeleton_.height);
      tracks.push_back(thinTurns(node, times, std::move(turns), tolerance / reach));
    }
    if (node == skeleton_.carrier || placedFoot(node)) {
      std::vector<Vec3> places;
      places.reserve(poses.size());
      for (const BodyPose& pose : poses) {
        places.push_back(pose.locals[at(node)].translation);
      }
      tracks.push_back(thinPlaces(node, times, places, tolerance / scaleAbove(node)));
    }
    if (joints.contains(node)) {
      addStill(node, times.front(), tolerance, tracks);
    }
  }
  return tracks;
}

} // namespace stretch::rig
