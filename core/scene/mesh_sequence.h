#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/math/types.h"

namespace stretch {

namespace gltf {
struct MeshSurface;
}

using Triangle = std::array<std::uint32_t, 3>; ///< Vertex indices, counter-clockwise seen from outside.

/// An animated mesh whose topology never changes: one position for each vertex and frame, one list of
/// triangles. Positions are in the units of their source; memory is 12 bytes for each vertex and frame.
struct MeshSequence {
  std::string name;
  std::string clipName; ///< Name of the motion in the source; empty where it has no name for it.
  std::size_t vertexCount = 0;
  std::vector<Triangle> triangles;
  std::vector<glm::vec3> positions;    ///< Frame after frame, vertexCount each.
  std::vector<std::string> frameNames; ///< Name of each frame in the source (a file, a sample), for messages.
  double framesPerSecond = 30.0;
  std::shared_ptr<const gltf::MeshSurface> surface; ///< Its looks; null: nothing but its shape.
  std::vector<std::string> warnings; ///< One line each: what is odd about the source and what was made of it.

  [[nodiscard]] std::size_t frameCount() const {
    return vertexCount == 0 ? 0 : positions.size() / vertexCount;
  }
  [[nodiscard]] std::span<const glm::vec3> frame(std::size_t index) const {
    return {positions.data() + index * vertexCount, vertexCount};
  }
  [[nodiscard]] std::span<glm::vec3> frame(std::size_t index) {
    return {positions.data() + index * vertexCount, vertexCount};
  }
};

/// Length of the diagonal of the box around the positions; 0 for none.
[[nodiscard]] double boxDiagonal(std::span<const glm::vec3> positions);

/// What errors of a sequence are told in parts of.
struct SequenceExtent {
  double diagonal = 0.0; ///< Of the box around `frame`; 0 where no frame has an extent.
  std::size_t frame = 0; ///< The first one whose diagonal is at least a hundredth of the largest.
};
[[nodiscard]] SequenceExtent extentOf(const MeshSequence& sequence);

/// The sequence from `firstFrame` on (settling frames left out). At least one frame is kept.
[[nodiscard]] MeshSequence withoutFirstFrames(const MeshSequence& sequence, std::size_t firstFrame);

} // namespace stretch
