#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "skinning/bind/bone_lines.h"
#include "skinning/fit/alternate.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

struct BindSettings {
  int cubesAlong = 110;  ///< Along the longest side of the mesh's box.
  double blend = 0.6;    ///< How far two bones share the mesh about their border, in radii of the body there.
  double sections = 0.1; ///< How much a bone's radius counts against a thinner one's (boneRegions).
};

/// Weights and what making them took.
struct BoundBody {
  std::vector<Influences> influences; ///< One for each vertex: at most four, sum 1.
  std::size_t cubes = 0;              ///< That the body was filled with; 0: it was not.
  std::size_t bytes = 0;              ///< That the cubes took at most, about.
};

/// Skin weights of a body that was never bound, by the way inside it (after O. Dionne and M. de Lasa,
/// "Geodesic Voxel Binding for Production Character Meshes", 2013): the body is filled with cubes, each goes
/// to the bone that is nearest to it inside, borders between two bones are blended over a part of the body's
/// thickness there, and shells that hold one bone follow it as one piece. Parts that touch, a hand on a
/// thigh, follow their own bones. Space of the mesh; any triangles will do (voxelBody). Error: no joints, no
/// triangles, more joints than weights can name, told to stop.
[[nodiscard]] Result<BoundBody> bindWeights(std::span<const glm::vec3> positions,
                                            const std::vector<Triangle>& triangles,
                                            const std::vector<BindJoint>& joints,
                                            const BindSettings& settings = {}, const Proceed& proceed = {});

/// Binds by distance on the surface (geodesicWeights) for a surface that is closed: every edge lies
/// between two triangles that are wound alike. Error, one line: one that is not, and those of bindWeights.
[[nodiscard]] Result<BoundBody> bindWeightsOnSurface(std::span<const glm::vec3> positions,
                                                     const std::vector<Triangle>& triangles,
                                                     const std::vector<BindJoint>& joints);

} // namespace stretch::skinning
