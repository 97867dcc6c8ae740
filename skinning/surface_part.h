#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"

namespace stretch::skinning {

/// The part of a character's surface that follows some of its nodes, for looking at it on many frames: linear
/// blend skinning as skinnedPositions, of these vertices and their neighbours alone, in single precision.
/// Morph targets stand as the file's own weights have them, not as a clip animates them.
class SurfacePart {
public:
  /// An edge of a triangle of which `moved` follows the nodes; `other` may be a vertex that does not.
  struct Edge {
    std::uint32_t moved = 0;
    std::uint32_t other = 0;

    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  /// `follows`: indexed by node.
  SurfacePart(const Scene& scene, const std::vector<bool>& follows);

  /// The nodes whose matrices the vertices are made with.
  [[nodiscard]] const std::vector<NodeIndex>& nodes() const { return nodes_; }
  /// The first so many vertices follow the nodes; their still neighbours come after.
  [[nodiscard]] std::size_t movedCount() const { return movedCount_; }
  /// Each once.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }

  /// World positions of the first `count` vertices.
  void positions(const FrameState& frame, std::size_t count, std::vector<glm::vec3>& out) const;
  /// Places of all of them.
  void positions(const FrameState& frame, std::vector<glm::vec3>& out) const;

private:
  struct Slot { // a joint of a skin, or the node of a rigid mesh
    NodeIndex node;
    Mat4 inverseBind{1.0};
  };
  struct Influence {
    std::uint32_t slot = 0;
    float weight = 0.0F;
  };
  struct Vertex {
    glm::vec3 position{0.0F}; // in its mesh
    std::uint32_t firstInfluence = 0;
    std::uint32_t influences = 0;
  };
  class Builder;

  std::vector<NodeIndex> nodes_;
  std::vector<Slot> slots_;
  std::vector<Influence> influences_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::size_t movedCount_ = 0;
};

} // namespace stretch::skinning
