#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"

namespace stretch::skinning {

/// Whether the edges of a part of a surface are listed; where only places are asked for they are not.
enum class SurfaceEdges { all, none };

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

  /// `follows`: indexed by node. Without edges there are no still neighbours.
  SurfacePart(const Scene& scene, const std::vector<bool>& follows, SurfaceEdges edges = SurfaceEdges::all);

  /// The nodes whose matrices the vertices are made with.
  [[nodiscard]] const std::vector<NodeIndex>& nodes() const { return nodes_; }
  /// The first so many vertices follow the nodes; their still neighbours come after.
  [[nodiscard]] std::size_t movedCount() const { return movedCount_; }
  /// Each once.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }

  /// World positions of all vertices.
  void positions(const FrameState& frame, std::vector<glm::vec3>& out) const;
  /// Places of the moved ones alone, in the first movedCount() of `out`, and of their neighbours, after
  /// those.
  void movedPositions(const FrameState& frame, std::vector<glm::vec3>& out) const;
  void stillPositions(const FrameState& frame, std::vector<glm::vec3>& out) const;

  /// What no moved vertex is farther than from its place in another frame, world units: by the balls around
  /// the vertices of each joint. Rounding of positions is not in it.
  [[nodiscard]] double farthestMove(const FrameState& from, const FrameState& to) const;

private:
  struct Slot { // a joint of a skin, or the node of a rigid mesh
    NodeIndex node;
    Mat4 inverseBind{1.0};
    Vec3 centre{0.0};     // of a ball around the moved vertices that follow it, in their mesh
    double radius = -1.0; // negative: none does
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

  void measureSlots();
  // Of the vertices from the first to before the last, into their places in `out`.
  void positions(const FrameState& frame, std::size_t first, std::size_t last,
                 std::vector<glm::vec3>& out) const;

  std::vector<NodeIndex> nodes_;
  std::vector<Slot> slots_;
  std::vector<Influence> influences_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::size_t movedCount_ = 0;
  double largestWeight_ = 1.0; // sum of the weights of a vertex
};

} // namespace stretch::skinning
