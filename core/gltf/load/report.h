#pragma once

#include <filesystem>
#include <vector>

#include "core/gltf/read/extensions.h"
#include "core/gltf/source/problems.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

struct Diagnosis {
  std::vector<Problem> problems;
  std::vector<ExtensionUse> extensions; ///< None of a file whose JSON cannot be read.
};

/// Everything that is wrong or odd in a file, in the order in which it was found: what `load` refuses or
/// warns of, all of it and not just the first error, and what other programs may show differently. Looks at
/// the file as it stands: a file of ours with its stretched limbs, not the source that it can be restored to.
/// A file that cannot be read is one error.
[[nodiscard]] Diagnosis diagnose(const std::filesystem::path& path);

/// Shear of a node that a mesh follows: world matrices of which translation, rotation and scale cannot be
/// told apart.
struct Shear {
  NodeIndex node;
  int clip = -1; ///< Index of the clip in which it is worst; -1: at rest.
  double timeSeconds = 0.0;
  double cosine = 0.0; ///< Largest |cosine| of an angle between two axes of the node: 0 without
                       ///< shear.
};

/// Nodes whose composed matrices shear by more than `tolerance` (a cosine), at rest or at the keys of a clip;
/// at most 64 times in each clip are looked at, evenly among its keys.
[[nodiscard]] std::vector<Shear> residualShear(const Scene& scene, const std::vector<Clip>& clips,
                                               double tolerance = 1e-3);

} // namespace stretch::gltf
