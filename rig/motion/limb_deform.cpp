#include "rig/motion/limb_deform.h"
#include "rig/limb.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include "core/base/index.h"

namespace stretch::rig {

namespace {

// The inverse, or the identity for what is scaled to nothing: there is no space to speak of then.
Mat4 inverseOf(const Mat4& matrix) {
  return glm::determinant(Mat3(matrix)) != 0.0 ? glm::inverse(matrix) : Mat4(1.0);
}

// Writes local transforms of a frame while knowing the pose it started from.
class PoseWriter {
public:
  PoseWriter(const Scene& scene, FrameState& frame) : scene_(scene), frame_(frame), before_(frame.worlds) {}

  [[nodiscard]] const Mat4& world(NodeIndex node) const { return frame_.worlds[at(node)]; }
  [[nodiscard]] const Mat4& worldBefore(NodeIndex node) const { return before_[at(node)]; }

  // World matrix of the node's parent as it stands, parents of it having been written before.
  [[nodiscard]] Mat4 parentWorld(NodeIndex node) const {
    const NodeIndex parent = scene_.nodes[at(node)].parent;
    return !parent.exists() ? Mat4(1.0) : frame_.worlds[at(parent)];
  }

  [[nodiscard]] Mat4 parentWorldBefore(NodeIndex node) const {
    const NodeIndex parent = scene_.nodes[at(node)].parent;
    return !parent.exists() ? Mat4(1.0) : before_[at(parent)];
  }

  Transform& local(NodeIndex node) {
    frame_.pose.usesMatrix[at(node)] = false;
    return frame_.pose.locals[at(node)];
  }

  // Recomputes the node's own world matrix; its children follow when they are written or at the end.
  void refresh(NodeIndex node) {
    frame_.worlds[at(node)] = parentWorld(node) * localMatrix(scene_, frame_.pose, node);
  }

  void refreshSubtree(NodeIndex node) {
    refresh(node);
    for (const NodeIndex child : scene_.nodes[at(node)].children) {
      refreshSubtree(child);
    }
  }

  // Turns the node's orientation in the world, as it was before, by `turn`, under the parent as it stands.
  // Seen from the parents, which may be mirrored: their world rotations alone would not tell.
  void turnInWorld(NodeIndex node, const Quat& turn) {
    const Mat4 seen = inverseOf(parentWorld(node)) * glm::mat4_cast(turn) * parentWorldBefore(node);
    Transform& transform = local(node);
    transform.rotation = glm::normalize(rotationOf(seen) * transform.rotation);
  }

  void setWorldPosition(NodeIndex node, const Vec3& positionWorld) {
    local(node).translation = transformPoint(inverseOf(parentWorld(node)), positionWorld);
  }

  void addStretch(NodeIndex node, const Mat3& stretch) {
    if (frame_.stretch.empty()) {
      frame_.stretch.assign(scene_.nodes.size(), Mat3(1.0));
    }
    frame_.stretch[at(node)] = stretch * frame_.stretch[at(node)];
  }

private:
  const Scene& scene_;
  FrameState& frame_;
  std::vector<Mat4> before_;
};

// A linear map of the joint's space seen from the space of a node below it.
Mat3 inSpaceOf(const PoseWriter& writer, NodeIndex joint, NodeIndex node, const Mat3& stretch) {
  const Mat3 toJoint = Mat3(inverseOf(writer.worldBefore(joint)) * writer.worldBefore(node));
  return Mat3(inverseOf(Mat4(toJoint))) * stretch * toJoint;
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

// The joint and what rides on its bone, stretched; the nodes on the path are up to date then.
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
  const Mat4& endBefore = writer.worldBefore(limb.endNode);
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

// What hangs on the limb, wherever its joints hang.
void refreshLimb(PoseWriter& writer, const Limb& limb, const LimbTopology& topology) {
  for (std::size_t i = 0; i < topology.bones.size(); ++i) {
    if (i == 0 || isDetached(topology, i)) {
      writer.refreshSubtree(topology.bones[i].joint);
    }
  }
  if (!topology.endIsDescendant) {
    writer.refreshSubtree(limb.endNode);
  }
}

bool sameTurn(const Quat& a, const Quat& b) {
  return a == b;
}

} // namespace

Mat3 boneStretch(const Vec3& unitAxis, double stretch, double volume) {
  const double across = std::pow(stretch, -0.5 * volume);
  return Mat3(across) + (stretch - across) * glm::outerProduct(unitAxis, unitAxis);
}

void deformLimb(const Scene& scene, const Limb& limb, const LimbTopology& topology, const LimbShape& shape,
                const DeformOptions& options, FrameState& frame) {
  PoseWriter writer(scene, frame);
  const std::vector<Vec3> points = limbPoints(limb, frame.worlds);
  const Quat still(1.0, 0.0, 0.0, 0.0);
  std::vector<KeptTransform> kept;
  for (const NodeIndex node : topology.staying) {
    kept.push_back({node, frame.worlds[at(node)]});
  }
  for (std::size_t i = 0; i < topology.bones.size(); ++i) {
    const BoneTopology& bone = topology.bones[i];
    // A joint that turns exactly as its parent bone does keeps its local rotation.
    if (i == 0 || isDetached(topology, i) || !sameTurn(shape.turns[i], shape.turns[i - 1])) {
      writer.turnInWorld(bone.joint, shape.turns[i]);
    }
    if (isDetached(topology, i)) {
      const Vec3 start = positionOf(writer.world(topology.bones[i - 1].joint));
      writer.setWorldPosition(bone.joint,
                              start + shape.stretch * (shape.turns[i - 1] * (points[i] - points[i - 1])));
    }
    writer.refresh(bone.joint);
    const Vec3 offset = transformVector(inverseOf(writer.worldBefore(bone.joint)), points[i + 1] - points[i]);
    if (glm::length(offset) > 0.0) {
      const Mat3 stretch = boneStretch(glm::normalize(offset), shape.stretch, options.volume);
      stretchBone(writer, scene, bone, stretch);
    }
    for (const NodeIndex node : bone.pathNodes) {
      writer.refresh(node);
    }
  }
  if (limb.endNode.exists()) {
    if (!topology.endIsDescendant) {
      moveDetachedEnd(writer, scene, limb, topology, shape.end);
    }
    if (!options.turnEnd) {
      writer.turnInWorld(limb.endNode, still);
    }
  }
  for (const KeptTransform& keep : kept) {
    writer.turnInWorld(keep.node, still);
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
    for (const NodeIndex node : bone.pathNodes) {
      writer.refresh(node);
    }
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

} // namespace stretch::rig
