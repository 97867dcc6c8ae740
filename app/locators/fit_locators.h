#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "rig/body/locators/locators.h"
#include "skinning/fit/alternate.h"

namespace stretch::app {

/// All that a file draws, where it stands at rest.
struct MeshesInWorld {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};
[[nodiscard]] MeshesInWorld meshesAtRest(const Scene& scene);

struct FittedLocators {
  rig::Locators locators;
  bool isOfSkeleton = false;         ///< They stand at the limbs that were found: no joint is to be made.
  std::vector<std::string> warnings; ///< One line each: what could not be told, and what to set by hand.
};

/// Locators at the limbs of the character where it has a skeleton, else fitted to its meshes as they stand
/// (docs/from_a_mesh.md, Locators), as those of the plan (rig/body/locators/locator_plans.h), or of the one
/// that its shape shows where `plan` is empty. Error, one line: a skeleton that is no biped's, a mesh that
/// shows no body, one whose plan is not clear, one that has not what the given plan needs.
[[nodiscard]] Result<FittedLocators> fitLocators(const Document& document, const std::string& plan = {},
                                                 const skinning::Proceed& proceed = {});

/// Names of the locators that are guessed rather than found.
[[nodiscard]] std::vector<std::string> unsureLocators(const rig::Locators& locators);

} // namespace stretch::app
