#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/fit/alternate.h"

namespace stretch::skinning {

/// Place where a joint of a biped seems to be in a mesh.
struct FittedJoint {
  std::string name;        ///< Name in VRM's table of humanoid bones: "leftUpperArm".
  Vec3 position{0.0};      ///< In the space of the mesh.
  double confidence = 1.0; ///< 0..1; below 0.5 a guess by proportions.
};

struct FittedBiped {
  std::vector<FittedJoint> joints;
  std::vector<std::string> warnings; ///< One line each: what does not show in the mesh.
  std::string doubt;                 ///< Why this may be no biped; empty where nothing speaks against it.
  bool standsInScene = true;         ///< +Y of the scene is up.
};

/// Finds the joints of a biped in a mesh that has no skeleton (docs/from_a_mesh.md, How locators are found):
/// any triangles, in any units, standing, lying or upside down, arms sideways or hanging with a gap. What
/// does not show is placed by proportions, with a warning. Error: no triangle, nothing that has an extent,
/// places that are no numbers, a mesh that shows neither legs nor arms, told to stop.
[[nodiscard]] Result<FittedBiped> fitBiped(std::span<const Vec3> positions,
                                           const std::vector<Triangle>& triangles,
                                           const Proceed& proceed = {});

} // namespace stretch::skinning
