#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Shape diameter function (Shapira, Shamir and Cohen-Or 2008): how thick the body is under each place of its
/// surface.
struct ShapeDiameterSettings {
  double coneDegrees = 120.0; ///< Full opening angle of the cone of rays around the inward normal; (0, 180).
  int rays = 64; ///< For each face, spread evenly over the cone's solid angle, one in each of as many equal
                 ///< parts.
  int smoothingRounds = 1; ///< Averages over the neighbouring faces; 0 leaves the measured values.
};

struct ShapeDiameters {
  std::vector<double> faces;    ///< One for each triangle, mesh units. Faces whose rays hit nothing take over
                                ///< their neighbours'.
  std::vector<double> vertices; ///< Area-weighted mean of the faces around each vertex; 0 for a vertex of no
                                ///< triangle.
  std::size_t facesWithoutHit = 0;
};

/// Rays start at the face's centre; lengths farther than one standard deviation from their median are
/// dropped, the rest is averaged with weights 1 / max(angle to the normal, 1 degree). Triangles are wound
/// outwards on a copy first. An error when no ray hits anything (a flat or empty mesh).
[[nodiscard]] Result<ShapeDiameters> shapeDiameters(std::span<const glm::vec3> positions,
                                                    const std::vector<Triangle>& triangles,
                                                    const ShapeDiameterSettings& settings = {});

/// Area-weighted mean of the face values over each group; `groupOf` names the group of every triangle (-1:
/// none). A group without area gets 0.
[[nodiscard]] std::vector<double> meanByGroup(std::span<const glm::vec3> positions,
                                              const std::vector<Triangle>& triangles,
                                              const std::vector<double>& faceValues,
                                              const std::vector<int>& groupOf, std::size_t groupCount);

} // namespace stretch::skinning
