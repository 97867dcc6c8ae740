#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "skinning/elastic/curvature_length.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// A row of bones between two branchings of a skeleton, and how its length follows its curvature.
struct ChainStretch {
  std::vector<std::size_t> bones;        ///< Base first.
  std::vector<std::string> names;        ///< Names of the bones.
  double restLength = 0.0;               ///< In the bind pose, mesh units.
  LengthFunction length;                 ///< Length function of the fitted frames.
  std::vector<CurvatureLength> measured; ///< Every frame.
  double least = 1.0;                    ///< Stretch of its bones over the frames.
  double most = 1.0;
};

/// The rows of a tree of bones: a bone with one child goes on in it, one with several ends its row. Every
/// bone is in one of them; parents' rows come first.
[[nodiscard]] std::vector<std::vector<std::size_t>> rowsOfTree(const std::vector<SkinBone>& bones);

/// The paper's model limb by limb (as it proposes for characters): measures each row of bones as `skinned`
/// poses it, fits its length to its curvature, and gives its bones the stretch that this makes of the
/// curvature, volume kept, along the axis of theirs that lies nearest to the bone. The first frame is the
/// bind pose. Every scale that there was is replaced.
std::vector<ChainStretch> stretchRows(SkinnedSequence& skinned, LengthModel model,
                                      std::size_t firstFittedFrame);

} // namespace stretch::skinning
