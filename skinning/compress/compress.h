#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/compress/body_stretch.h"
#include "skinning/compress/chain_stretch.h"
#include "skinning/fit/alternate.h"
#include "skinning/metrics.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

enum class StretchOption {
  none,     ///< Bones turn; the body keeps its length and thickness.
  elastic,  ///< Bones turn and are stretched by the physical model: a handful of parameters for all frames.
  measured, ///< Bones turn, move and stretch freely, fitted frame by frame: the best that scales can do.
};

enum class WeightOption {
  automatic, ///< Fitted where bones are free; in a row both are tried, and the one with the lower error
             ///< stays.
  geodesic,  ///< From the first frame alone, by inverse geodesic distance.
  fitted,    ///< By least squares over the frames.
};

/// How bones that move freely hang together in the clip; what the mesh does is the same.
enum class JointOption {
  tree, ///< Each hangs on another at the joint between them.
  free, ///< Side by side.
};

enum class InfluenceLimit { four, eight };

struct CompressSettings {
  int bones = 30;
  std::optional<double> tolerancePercent; ///< RMSE that the fewest bones have to meet, in percent of the
                                          ///< diagonal; `bones` does not count then.
  StretchOption stretch = StretchOption::elastic;
  WeightOption weights = WeightOption::automatic;
  JointOption joints = JointOption::tree;
  InfluenceLimit influences = InfluenceLimit::four;
  std::vector<SkinBone> skeleton; ///< Bones to take instead of own ones; see readSkeleton. `bones` does not
                                  ///< count then.
  BodyStretchSettings body;       ///< Its firstFittedFrame counts for the fit of the weights too.
  FitSettings fit;                ///< Rounds and candidates; the rest follows from the options above.

  friend bool operator==(const CompressSettings&, const CompressSettings&) = default;
};

/// Which weights were taken.
struct WeightChoice {
  WeightOption used = WeightOption::fitted; ///< Geodesic or fitted.
  std::optional<double> geodesicPercent;    ///< RMSE with either, in percent of the diagonal, where both were
  std::optional<double> fittedPercent;      ///< tried.
};

/// A sequence as a skinned clip, and what is known of how well it fits.
struct CompressedSequence {
  SkinnedSequence skinned;
  SequenceMetrics metrics;                      ///< Against the source, all frames.
  std::optional<SequenceMetrics> fittedMetrics; ///< The frames from firstFittedFrame on; set when that is not
                                                ///< all.
  std::optional<BodyStretch> model;  ///< The fitted physics; for every body without branches, whatever the
                                     ///< option.
  std::vector<ChainStretch> chains;  ///< Elastic stretch of a tree of bones: its rows.
  std::vector<double> segmentWidths; ///< Mean shape diameter along the body; empty without a skeleton.
  std::size_t firstFittedFrame = 0;  ///< Frames from this one on were used in fits.
  WeightChoice weights;
  std::vector<std::string> warnings;
};

/// The most bones that a tolerance is tried with.
inline constexpr int mostBonesOfTolerance = 128;

/// The first frame becomes the bind pose. Bones hang together in a row for `none` and `elastic`, so that
/// their places need not be stored; `measured` moves them freely. A body that branches, or is in several
/// parts, has clusters of motion as bones and needs weights that are not geodesic. A given skeleton has its
/// own places for the bones, on any body. Elastic stretch of either goes row by row of the tree of bones
/// (stretchRows), so parts have to hang together for it. Errors: fewer than
/// one bone, too many, no frames, no thickness, a skeleton that stands elsewhere, stopped by `proceed`.
[[nodiscard]] Result<CompressedSequence>
compress(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed = {});

} // namespace stretch::skinning
