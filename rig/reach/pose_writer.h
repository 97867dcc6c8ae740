#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include <glm/matrix.hpp>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"

namespace stretch::rig {

/// The inverse, or the identity for what is scaled to nothing: there is no space to speak of then.
[[nodiscard]] inline Mat4 inverseOf(const Mat4& matrix) {
  return glm::determinant(Mat3(matrix)) != 0.0 ? glm::inverse(matrix) : Mat4(1.0);
}

/// Returns the inverse of a linear map in the same way.
[[nodiscard]] inline Mat3 inverseOf(const Mat3& linear) {
  return glm::determinant(linear) != 0.0 ? glm::inverse(linear) : Mat3(1.0);
}

/// Writes local transforms of a frame while knowing the pose it started from.
class PoseWriter {
public:
  PoseWriter(const Scene& scene, FrameState& frame)
      : scene_(scene), frame_(frame), marks_(scene.nodes.size(), &memory_) {
    kept_.reserve(8); // as many as most limbs have
  }

  [[nodiscard]] const Mat4& world(NodeIndex node) const { return frame_.worlds[at(node)]; }
  /// World matrix of the node in the pose that the frame started from.
  [[nodiscard]] Mat4 worldBefore(NodeIndex node) const {
    const std::uint32_t kept = marks_[at(node)].kept;
    return kept == 0 ? frame_.worlds[at(node)] : kept_[kept - 1];
  }

  /// World matrix of the node's parent as it stands, parents of it having been written before.
  [[nodiscard]] Mat4 parentWorld(NodeIndex node) const {
    const NodeIndex parent = scene_.nodes[at(node)].parent;
    return parent.exists() ? world(parent) : Mat4(1.0);
  }

  Transform& local(NodeIndex node) {
    frame_.pose.usesMatrix[at(node)] = false;
    marks_[at(node)].refreshed = 0;
    return frame_.pose.locals[at(node)];
  }

  /// Recomputes the node's own world matrix; its children follow when they are written or at the end.
  void refresh(NodeIndex node) {
    Mark& mark = marks_[at(node)];
    mark.refreshed = ++refreshes_;
    if (mark.kept == 0) {
      kept_.push_back(world(node));
      mark.kept = static_cast<std::uint32_t>(kept_.size());
    }
    frame_.worlds[at(node)] = parentWorld(node) * localMatrix(scene_, frame_.pose, node);
  }

  /// The node and all below it, but for what has not changed since it was refreshed.
  void refreshSubtree(NodeIndex node) {
    const NodeIndex parent = scene_.nodes[at(node)].parent;
    if (marks_[at(node)].refreshed <= (parent.exists() ? marks_[at(parent)].refreshed : 0)) {
      refresh(node);
    }
    for (const NodeIndex child : scene_.nodes[at(node)].children) {
      refreshSubtree(child);
    }
  }

  /// Turns the node's orientation in the world, as it was before, by `turn`, under the parent as it stands.
  /// Seen from the parents, which may be mirrored: their world rotations alone would not tell.
  void turnInWorld(NodeIndex node, const Quat& turn) {
    const Mat3 now = inverseOf(Mat3(parentWorld(node)));
    const Mat3 seen = now * glm::mat3_cast(turn) * Mat3(parentWorldBefore(node));
    Transform& transform = local(node);
    transform.rotation = glm::normalize(rotationOf(Mat4(seen)) * transform.rotation);
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
  [[nodiscard]] Mat4 parentWorldBefore(NodeIndex node) const {
    const NodeIndex parent = scene_.nodes[at(node)].parent;
    return parent.exists() ? worldBefore(parent) : Mat4(1.0);
  }

  struct Mark {
    std::uint32_t kept = 0;      // place in kept_, from 1; 0: not there
    std::uint32_t refreshed = 0; // how many were before it, from 1; 0: not since it was written
  };

  const Scene& scene_;
  FrameState& frame_;
  // One is made for each limb at each time: that of a body of usual size takes none from the heap.
  std::array<std::byte, 4096> firstMemory_;
  std::pmr::monotonic_buffer_resource memory_{firstMemory_.data(), firstMemory_.size()};
  std::pmr::vector<Mark> marks_;          // of each node
  std::pmr::vector<Mat4> kept_{&memory_}; // world matrices of what was written, as they were
  std::uint32_t refreshes_ = 0;
};

} // namespace stretch::rig
