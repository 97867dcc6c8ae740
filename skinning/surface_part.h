#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"

namespace stretch::skinning {

/// Whether the edges of a part of a surface are listed; where only places are asked for they are not.
enum class SurfaceEdges { all, none };

/// The part of a character's surface that follows some of its nodes, for looking at it on many frames: linear
/// blend skinning as skinnedPositions, of these vertices and their neighbours alone, in single precision.
/// Morph targets stand as the file's own weights have them, not as a clip animates them. The boxes around
/// what follows each joint tell where no vertex can be, so that most need not be looked at.
class SurfacePart {
public:
  /// An edge of a triangle of which `moved` follows the nodes; `other` may be a vertex that does not.
  struct Edge {
    std::uint32_t moved = 0;
    std::uint32_t other = 0;

    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  /// The part in one frame.
  struct Posed {
    std::vector<Mat4> matrices; ///< From mesh to world, of each slot.
    std::vector<glm::mat4> rounded;
    double rounding = 0.0; ///< What single precision may make of a place, world units, with room.
  };

  struct Slot { ///< A joint of a skin, or the node of a rigid mesh.
    NodeIndex node;
    Mat4 inverseBind{1.0};
    Vec3 centre{0.0};    ///< Of the box around the moved vertices that follow it, in their mesh.
    Vec3 half{0.0};      ///< Of that box.
    double radius = 0.0; ///< Of the ball around them at that centre.
  };
  struct Influence {
    std::uint32_t slot = 0;
    float weight = 0.0F;
  };

  /// `follows`: indexed by node. Without edges there are no still neighbours.
  SurfacePart(const Scene& scene, const std::vector<bool>& follows, SurfaceEdges edges = SurfaceEdges::all);
  /// All of the surface, without edges.
  [[nodiscard]] static SurfacePart whole(const Scene& scene);

  /// The nodes whose matrices the vertices are made with.
  [[nodiscard]] const std::vector<NodeIndex>& nodes() const { return nodes_; }
  /// The first so many vertices follow the nodes; their still neighbours come after.
  [[nodiscard]] std::size_t movedCount() const { return movedCount_; }
  /// Each once.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }

  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }
  [[nodiscard]] std::span<const Influence> influencesOf(std::size_t vertex) const {
    return {&influences_[vertices_[vertex].firstInfluence], vertices_[vertex].influences};
  }
  /// The moved vertices that follow a slot, in order.
  [[nodiscard]] std::span<const std::uint32_t> followersOf(std::size_t slot) const {
    return {followers_.data() + firstFollowers_[slot], firstFollowers_[slot + 1] - firstFollowers_[slot]};
  }
  /// Place of a vertex in its mesh.
  [[nodiscard]] const glm::vec3& placeInMesh(std::size_t vertex) const { return vertices_[vertex].position; }
  /// Whether weights are 0 or more and add up to 1 at each vertex, but for rounding: no vertex is outside of
  /// what its joints make of it.
  [[nodiscard]] bool areMeans() const { return areMeans_; }

  [[nodiscard]] Posed posed(const FrameState& frame) const;
  /// World position of a vertex.
  [[nodiscard]] glm::vec3 place(std::size_t vertex, const Posed& posed) const {
    const glm::vec3& position = vertices_[vertex].position;
    glm::vec4 sum(0.0F);
    for (const Influence& one : influencesOf(vertex)) {
      const glm::mat4& matrix = posed.rounded[one.slot];
      sum +=
          one.weight * (matrix[0] * position.x + matrix[1] * position.y + matrix[2] * position.z + matrix[3]);
    }
    return glm::vec3(sum);
  }
  /// World positions of all vertices.
  void positions(const FrameState& frame, std::vector<glm::vec3>& out) const;
  /// The lowest of the moved vertices along +Y, of several the first; nothing where none is below the limit.
  [[nodiscard]] std::optional<Vec3> lowest(const Posed& posed,
                                           double limit = std::numeric_limits<double>::infinity()) const;
  /// Length beyond which no moved vertex that follows a slot is away from its place in another frame, world
  /// units, with room for rounding, and the slot, the farthest first; infinite where weights are no means.
  [[nodiscard]] std::vector<std::pair<double, std::size_t>> farthestMoves(const Posed& from,
                                                                          const Posed& to) const;

private:
  struct Vertex {
    glm::vec3 position{0.0F}; // in its mesh
    std::uint32_t firstInfluence = 0;
    std::uint32_t influences = 0;
  };
  class Builder;

  [[nodiscard]] bool isMean(std::size_t vertex) const;
  void measureSlots();

  std::vector<NodeIndex> nodes_;
  std::vector<Slot> slots_;
  std::vector<Influence> influences_;
  std::vector<std::uint32_t> followers_;    // vertices of the first slot, of the second, ...
  std::vector<std::size_t> firstFollowers_; // by slot, and how many there are
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::size_t movedCount_ = 0;
  bool areMeans_ = true;
  double reach_ = 0.0; // from a mesh's origin to its farthest vertex
};

/// What no vector grows by more than under a matrix: near the truth where its columns stand square.
[[nodiscard]] double growthOf(const Mat4& matrix);

} // namespace stretch::skinning
