#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/compress/body_stretch.h"
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
  geodesic, ///< From the first frame alone, by inverse geodesic distance.
  fitted,   ///< By least squares over the frames.
};

struct CompressSettings {
  int bones = 30;
  StretchOption stretch = StretchOption::elastic;
  WeightOption weights = WeightOption::fitted;
  BodyStretchSettings body; ///< Its firstFittedFrame counts for the fit of the weights too.
  FitSettings fit;          ///< Rounds and candidates; the rest follows from the options above.

  friend bool operator==(const CompressSettings&, const CompressSettings&) = default;
};

/// A sequence as a skinned clip, and what is known of how well it fits.
struct CompressedSequence {
  SkinnedSequence skinned;
  SequenceMetrics metrics;                      ///< Against the source, all frames.
  std::optional<SequenceMetrics> fittedMetrics; ///< The frames from firstFittedFrame on; set when that is not
                                                ///< all.
  std::optional<BodyStretch> model;  ///< The fitted physics; for every body without branches, whatever the
                                     ///< option.
  std::vector<double> segmentWidths; ///< Mean shape diameter along the body; empty without a skeleton.
  std::size_t firstFittedFrame = 0;  ///< Frames from this one on were used in fits.
  std::vector<std::string> warnings;
};

/// The first frame becomes the bind pose. Bones hang together in a row for `none` and `elastic`, so that
/// their places need not be stored; `measured` moves them freely. A body that branches, or is in several
/// parts, can only be `measured` (or `none`, as rigid free parts) with `fitted` weights. Errors: fewer than
/// one bone, too many, no frames, no thickness, stopped by `proceed`.
[[nodiscard]] Result<CompressedSequence>
compress(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed = {});

} // namespace stretch::skinning
