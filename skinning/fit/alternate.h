#pragma once

#include <cstddef>
#include <functional>

#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Told the share of the work that is done, 0..1; answers whether to go on. May be empty: nobody listens.
using Proceed = std::function<bool(double)>;

/// How the fit goes about it; the defaults suit bodies of some thousand vertices and a hundred frames.
struct FitSettings {
  int rounds = 80;         ///< Rounds of weights and bones in turn, at most.
  double leastGain = 5e-4; ///< Stops early when a round lowers the error by less than this share.
  int candidates = 8;      ///< Bones that are tried for a vertex; at least twice as many as it may have.
  int influences = 4;      ///< Bones that a vertex may hang on, at most Influences::capacity.
  bool fitWeights = true;  ///< False keeps the influences as they are.
  bool bonesMove = false;  ///< Bones have neither a place nor a direction that must stay: those that others
                           ///< can stand in for are used elsewhere, and axes turn to where bones stretch.
  bool fitStretch = true;  ///< Free bones only: fit scale factors along each bone's axes; false keeps them
                           ///< rigid.
  double largestScale = 10.0; ///< Free bones are scaled by no more along any axis, and by no less than 1 over
                              ///< it; at least 1.
  std::size_t firstWeightFrame = 0; ///< Frames before it do not count for the weights.

  friend bool operator==(const FitSettings&, const FitSettings&) = default;
};

/// Lowers the squared distance between what `skinned` shows and the frames of `sequence`: influences by least
/// squares (not negative, sum 1) and poses of free bones in turn, as solvers of linear blend
/// skinning do. `skinned` holds the start: bind positions, bones, influences; its poses are used as the start
/// too where there are any. Told to stop, the fit ends with what it has reached.
void fitFreeBones(const MeshSequence& sequence, SkinnedSequence& skinned, const FitSettings& settings,
                  const Proceed& proceed = {});

/// How firmly the bones of a row are held to the rotations of the material around them.
enum class RowHold {
  loose, ///< For a row as long as the body.
  firm,  ///< For one that is not: it would fold up in the body, each frame in another way.
};

/// Poses of bones that hang together (SkinnedSequence::chained), influences given: their stretches stay, the
/// place of the first bone and the rotations are fitted, the latter held near those of the poses, which
/// should be measured ones.
void fitChainedBones(const MeshSequence& sequence, SkinnedSequence& skinned, RowHold hold);

} // namespace stretch::skinning
