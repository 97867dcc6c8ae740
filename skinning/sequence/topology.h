#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Counts of what is odd about the triangles of a mesh.
struct TopologyReport {
  std::size_t components = 0;    ///< Parts that no shared vertex joins; vertices of no triangle are left out.
  std::size_t boundaryEdges = 0; ///< Edges of one triangle.
  std::size_t crowdedEdges = 0;  ///< Edges of three or more triangles.
  std::size_t unlikeEdges = 0; ///< Edges of two triangles that are wound against each other; no oddity where
                               ///< triangles are oriented anyway.
  std::size_t degenerateTriangles = 0; ///< With a repeated corner.
  std::size_t duplicatePositions = 0;  ///< Vertices at the very place of an earlier one.
  std::size_t looseVertices = 0;       ///< Vertices of no triangle.

  /// One line for each oddity; empty for a closed surface in one piece.
  [[nodiscard]] std::vector<std::string> warnings() const;
};

[[nodiscard]] TopologyReport inspectTopology(std::span<const glm::vec3> positions,
                                             const std::vector<Triangle>& triangles);

/// Vertices of triangles, ascending.
[[nodiscard]] std::vector<std::uint32_t> usedVertices(const std::vector<Triangle>& triangles);

/// Winds all triangles of each connected part alike (over edges of exactly two triangles), and outwards: the
/// volume that the part encloses is made positive (an open part counts against the middle of the whole).
/// Returns how many triangles were turned.
std::size_t orientOutwards(std::span<const glm::vec3> positions, std::vector<Triangle>& triangles);

/// Volume that the triangles enclose (for an open surface: closed towards its middle); positive when wound
/// outwards.
[[nodiscard]] double enclosedVolume(std::span<const glm::vec3> positions,
                                    const std::vector<Triangle>& triangles);

} // namespace stretch::skinning
