#include "rig/reach/limb_deform.h"
#include "rig/limb.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include "core/base/index.h"
#include "core/math/rotation.h"
#include "rig/reach/pose_writer.h"

namespace stretch::rig {

namespace {

// A linear map of the joint's space seen from the space of a node below it.
Mat3 inSpaceOf(const PoseWriter& writer, NodeIndex joint, NodeIndex node, const Mat3& stretch) {
  const Mat3 toJoint = inverseOf(Mat3(writer.worldBefore(joint))) * Mat3(writer.worldBefore(node));
  return inverseOf(toJoint) * stretch * toJoint;
}

// What hangs on the bone moves by K; on the path K goes through the frames of the nodes between.
void moveByStretch(PoseWriter& writer, const BoneTopology& bone, const Mat3& stretch) {
  NodeIndex parent = bone.joint;
  for (const NodeIndex node : bone.pathNodes) {
    Transform& local = writer.local(node);
    local.translation = inSpaceOf(writer, bone.joint, parent, stretch) * local.translation;
    parent = node;
  }
  for (const NodeIndex node : bone.hanging) {
    Transform& local = writer.local(node);
    local.translation = stretch * local.translation;
  }
}

// Nested twist joints (children of twist joints) move by K as well; those that hang directly or lie on the
// path did already.
void moveNestedTwists(PoseWriter& writer, const Scene& scene, const BoneTopology& bone, const Mat3& stretch) {
  for (const NodeIndex node : bone.twistNodes) {
    const NodeIndex parent = scene.nodes[at(node)].parent;
    const bool onPath = std::find(bone.pathNodes.begin(), bone.pathNodes.end(), node) != bone.pathNodes.end();
    if (parent != bone.joint && !onPath) {
      writer.local(node).translation =
          inSpaceOf(writer, bone.joint, parent, stretch) * writer.local(node).translation;
    }
    // Seen from a node that is scaled unevenly K would shear: the bind leaf of a rigid mesh cannot tell that.
    const Mat3 seen = inSpaceOf(writer, bone.joint, node, stretch);
    writer.addStretch(node, 0.5 * (seen + glm::transpose(seen)));
  }
}

// What lies on the bone. Its last node is the next joint or the limb's end, which turn before anything asks
// where they are.
void refreshBetween(PoseWriter& writer, const BoneTopology& bone) {
  for (std::size_t i = 1; i < bone.pathNodes.size(); ++i) {
    writer.refresh(bone.pathNodes[i - 1]);
  }
}

// The joint and what rides on its bone, stretched.
void stretchBone(PoseWriter& writer, const Scene& scene, const BoneTopology& bone, const Mat3& stretch) {
  moveByStretch(writer, bone, stretch);
  moveNestedTwists(writer, scene, bone, stretch);
  writer.addStretch(bone.joint, stretch);
}

struct KeptTransform {
  NodeIndex node;
  Mat4 world{1.0};
};

// What stands at the limb's end moves with the end joint as one piece.
void moveWithEnd(PoseWriter& writer, NodeIndex node, const Mat4& endBefore, const Mat4& endNow) {
  const Quat turn = rotationOf(endNow) * glm::inverse(rotationOf(endBefore));
  const Vec3 offset = positionOf(writer.worldBefore(node)) - positionOf(endBefore);
  writer.turnInWorld(node, turn);
  writer.setWorldPosition(node, positionOf(endNow) + turn * offset);
  writer.refreshSubtree(node);
}

// An end that hangs elsewhere is brought to its place, after the companions that carry it.
void moveDetachedEnd(PoseWriter& writer, const Scene& scene, const Limb& limb, const LimbTopology& topology,
                     const Vec3& endWorld) {
  const Mat4 endBefore = writer.worldBefore(limb.endNode);
  Mat4 endNow = endBefore;
  endNow[3] = Vec4(endWorld, 1.0);
  for (const NodeIndex node : topology.companions) {
    if (isAncestorOrSelf(scene, node, limb.endNode)) {
      moveWithEnd(writer, node, endBefore, endNow);
    }
  }
  writer.setWorldPosition(limb.endNode, endWorld);
}

void moveCompanions(PoseWriter& writer, const Scene& scene, const Limb& limb, const LimbTopology& topology) {
  for (const NodeIndex node : topology.companions) {
    if (!isAncestorOrSelf(scene, node, limb.endNode)) {
      moveWithEnd(writer, node, writer.worldBefore(limb.endNode), writer.world(limb.endNode));
    }
  }
}

// Whether a joint of the limb hangs from elsewhere than from the one before: deforming joints under masters.
bool isDetached(const LimbTopology& topology, std::size_t bone) {
  return bone > 0 && topology.bones[bone - 1].pathNodes.empty();
}

// Whether a linear map changes angles or ratios of lengths by more than a thousandth. One that makes a body
// all but flat does not count: no turn of a joint makes up for that.
bool isUneven(const Mat3& map) {
  constexpr double unseen = 2e-3; // of squares
  constexpr double flat = 0.0025; // of squares: a twentieth
  const Vec3 squares(glm::dot(map[0], map[0]), glm::dot(map[1], map[1]), glm::dot(map[2], map[2]));
  const double most = std::max({squares.x, squares.y, squares.z});
  const double least = std::min({squares.x, squares.y, squares.z});
  const double sheared = std::max({std::abs(glm::dot(map[0], map[1])), std::abs(glm::dot(map[1], map[2])),
                                   std::abs(glm::dot(map[2], map[0]))});
  return least > flat * most && std::max(most - least, sheared) > unseen * most;
}

// Under an uneven scale a turn in the world is no turn of the joint: brings the bone, `offset` in the joint's
// space, to the direction that is wanted. Returns the stretch by which it comes to its length there.
double pointBone(PoseWriter& writer, NodeIndex joint, const Vec3& offset, const Vec3& wantedWorld) {
  const Mat3 toParent = inverseOf(Mat3(writer.parentWorld(joint)));
  const Vec3 now = toParent * (Mat3(writer.world(joint)) * offset);
  const Vec3 wanted = toParent * wantedWorld;
  Transform& local = writer.local(joint);
  local.rotation = glm::normalize(shortestArc(now, wanted) * local.rotation);
  writer.refresh(joint);
  return glm::length(now) > 0.0 ? glm::length(wanted) / glm::length(now) : 1.0;
}

// What a pose makes of a bone.
struct PosedBone {
  Vec3 before{0.0}; // from its joint to the next one, world
  Quat turn{1.0, 0.0, 0.0, 0.0};
  double stretch = 1.0;
};

// Stretches a bone that was turned; below an uneven scale it is turned on, and comes to its length there.
void stretchPosed(PoseWriter& writer, const Scene& scene, const BoneTopology& bone, PosedBone posed,
                  double volume) {
  constexpr double unseen = 1e-9; // of the bone
  const Vec3 offset = inverseOf(Mat3(writer.worldBefore(bone.joint))) * posed.before;
  if (isUneven(Mat3(writer.parentWorld(bone.joint)))) {
    posed.stretch = pointBone(writer, bone.joint, offset, posed.stretch * (posed.turn * posed.before));
  }
  if (glm::length(offset) > 0.0 && std::abs(posed.stretch - 1.0) > unseen) {
    stretchBone(writer, scene, bone, boneStretch(glm::normalize(offset), posed.stretch, volume));
  }
}

// What hangs on the limb, wherever its joints hang.
void refreshLimb(PoseWriter& writer, const Limb& limb, const LimbTopology& topology) {
  for (std::size_t i = 0; i < topology.bones.size(); ++i) {
    if (i == 0 || isDetached(topology, i)) {
      writer.refreshSubtree(topology.bones[i].joint);
    }
  }
  if (topology.leader.exists()) {
    writer.refreshSubtree(topology.leader);
  }
  if (!topology.endIsDescendant) {
    writer.refreshSubtree(limb.endNode);
  }
}

// The head of a serpent, and all that it carries, by as much as the pose moves it; the rest of the limb is
// placed from there.
void moveLeader(PoseWriter& writer, NodeIndex leader, const Vec3& lead, const LimbPose& shape, bool turns) {
  const Quat turn = turns ? shape.turns.front() : Quat(1.0, 0.0, 0.0, 0.0);
  const Vec3 offset = positionOf(writer.worldBefore(leader)) - lead;
  writer.turnInWorld(leader, turn);
  writer.setWorldPosition(leader, lead + shape.baseMove + turn * offset);
  writer.refreshSubtree(leader);
}

// Where a node goes that is carried by one above it, without a look at its own transforms.
void carrySubtree(const Scene& scene, NodeIndex node, const Mat4& changeWorld, FrameState& frame) {
  Mat4& world = frame.worlds[at(node)];
  world = changeWorld * world;
  for (const NodeIndex child : scene.nodes[at(node)].children) {
    carrySubtree(scene, child, changeWorld, frame);
  }
}

// As carrySubtree, where nothing turns: what only moves keeps its turn to the last bit.
void moveSubtree(const Scene& scene, NodeIndex node, const Vec3& moveWorld, FrameState& frame) {
  frame.worlds[at(node)][3] += Vec4(moveWorld, 0.0);
  for (const NodeIndex child : scene.nodes[at(node)].children) {
    moveSubtree(scene, child, moveWorld, frame);
  }
}

} // namespace

Mat3 boneStretch(const Vec3& unitAxis, double stretch, double volume) {
  const double across = std::pow(stretch, -0.5 * volume);
  return Mat3(across) + (stretch - across) * glm::outerProduct(unitAxis, unitAxis);
}

LimbPose limbPose(const LimbShape& shape) {
  LimbPose pose;
  pose.turns = shape.turns;
  pose.stretches.assign(shape.turns.size(), shape.stretch);
  pose.end = shape.end;
  return pose;
}

LimbPose poseToLead(const Limb& limb, const LimbShape& shape, const FrameState& frame) {
  LimbPose pose = limbPose(shape);
  if (limb.ledByFirst) {
    pose.leads = true;
    std::ranges::reverse(pose.turns);
    pose.baseMove = shape.end - leadingPosition(limb, frame);
    pose.end = endPosition(limb, frame);
  }
  return pose;
}

void deformLimb(const Scene& scene, const Limb& limb, const LimbTopology& topology, const LimbPose& shape,
                const DeformOptions& options, FrameState& frame) {
  PoseWriter writer(scene, frame);
  // Asked for where a bone is stretched, hangs elsewhere or is below an uneven scale alone.
  const Vec3 end = endPosition(limb, frame.worlds);
  const auto pointBefore = [&](std::size_t point) {
    return point < limb.joints.size() ? positionOf(writer.worldBefore(limb.joints[point])) : end;
  };
  std::vector<KeptTransform> kept;
  for (const NodeIndex node : topology.staying) {
    kept.push_back({node, frame.worlds[at(node)]});
  }
  const bool isLed = shape.leads && topology.leader.exists();
  if (isLed) {
    moveLeader(writer, topology.leader, pointBefore(0), shape, options.turnEnd);
  }
  for (std::size_t i = isLed ? 1 : 0; i < topology.bones.size(); ++i) {
    const BoneTopology& bone = topology.bones[i];
    const bool isPlaced = isDetached(topology, i) || (isLed && i == 1);
    // A joint that turns exactly as its parent bone does keeps its local rotation, if it can.
    if (i == 0 || isPlaced || shape.turns[i] != shape.turns[i - 1]) {
      writer.turnInWorld(bone.joint, shape.turns[i]);
    }
    if (isPlaced) {
      const Vec3 start = positionOf(writer.world(topology.bones[i - 1].joint));
      writer.setWorldPosition(bone.joint,
                              start + shape.stretches[i - 1] *
                                          (shape.turns[i - 1] * (pointBefore(i) - pointBefore(i - 1))));
    } else if (i == 0 && shape.baseMove != Vec3(0.0)) {
      writer.setWorldPosition(bone.joint, pointBefore(0) + shape.baseMove);
    }
    writer.refresh(bone.joint);
    if (shape.stretches[i] != 1.0 || isUneven(Mat3(writer.parentWorld(bone.joint)))) {
      stretchPosed(writer, scene, bone,
                   {pointBefore(i + 1) - pointBefore(i), shape.turns[i], shape.stretches[i]}, options.volume);
    }
    refreshBetween(writer, bone);
  }
  if (limb.endNode.exists()) {
    if (!topology.endIsDescendant) {
      moveDetachedEnd(writer, scene, limb, topology, shape.end);
    }
    if (!options.turnEnd && !isLed) {
      writer.turnInWorld(limb.endNode, options.endTurn);
    }
  }
  for (const KeptTransform& keep : kept) {
    writer.turnInWorld(keep.node, Quat(1.0, 0.0, 0.0, 0.0));
    writer.setWorldPosition(keep.node, positionOf(keep.world));
  }
  refreshLimb(writer, limb, topology);
  moveCompanions(writer, scene, limb, topology);
}

void stretchLimb(const Scene& scene, const Limb& limb, const LimbTopology& topology,
                 const std::vector<Mat3>& stretches, FrameState& frame) {
  PoseWriter writer(scene, frame);
  const Vec3 end = endPosition(limb, frame);
  // Where a point that hangs elsewhere comes to with the bone before it.
  const auto carried = [&](std::size_t bone, const Vec3& point) {
    const NodeIndex joint = topology.bones[bone].joint;
    const Vec3 offset = transformPoint(inverseOf(writer.worldBefore(joint)), point);
    return transformPoint(writer.world(joint), stretches[bone] * offset);
  };
  for (std::size_t i = 0; i < topology.bones.size(); ++i) {
    const BoneTopology& bone = topology.bones[i];
    if (isDetached(topology, i)) {
      writer.setWorldPosition(bone.joint, carried(i - 1, positionOf(writer.worldBefore(bone.joint))));
    }
    writer.refresh(bone.joint);
    stretchBone(writer, scene, bone, stretches[i]);
    refreshBetween(writer, bone);
  }
  if (!topology.endIsDescendant) {
    moveDetachedEnd(writer, scene, limb, topology, carried(topology.bones.size() - 1, end));
  }
  refreshLimb(writer, limb, topology);
  moveCompanions(writer, scene, limb, topology);
}

void moveNode(const Scene& scene, NodeIndex node, const Vec3& positionWorld, FrameState& frame) {
  PoseWriter writer(scene, frame);
  writer.setWorldPosition(node, positionWorld);
  writer.refreshSubtree(node);
}

void placeNode(const Scene& scene, NodeIndex node, const Quat& turnWorld, const Vec3& positionWorld,
               FrameState& frame) {
  PoseWriter writer(scene, frame);
  if (turnWorld != Quat(1.0, 0.0, 0.0, 0.0)) {
    writer.turnInWorld(node, turnWorld);
  }
  const Mat4 before = writer.world(node);
  if (positionWorld != positionOf(before)) {
    writer.setWorldPosition(node, positionWorld);
  }
  if (glm::determinant(Mat3(before)) == 0.0) { // scaled to nothing: what it carries cannot tell how it moved
    writer.refreshSubtree(node);
    return;
  }
  writer.refresh(node);
  const Mat4& now = writer.world(node);
  if (Mat3(now) == Mat3(before)) {
    const Vec3 moveWorld = positionOf(now) - positionOf(before);
    for (const NodeIndex child : scene.nodes[at(node)].children) {
      moveSubtree(scene, child, moveWorld, frame);
    }
    return;
  }
  const Mat4 change = now * glm::inverse(before);
  for (const NodeIndex child : scene.nodes[at(node)].children) {
    carrySubtree(scene, child, change, frame);
  }
}

} // namespace stretch::rig
