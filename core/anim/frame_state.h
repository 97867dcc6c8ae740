#pragma once

#include <vector>

#include "core/anim/sampling.h"

namespace stretch {

/// Everything that drawing, batch and tests need to know of one moment.
struct FrameState {
  double timeSeconds = 0.0;
  Pose pose;
  std::vector<Mat4> worlds; ///< World matrix of every node.
  /// What the bind chain adds (of the file's own clip, too): a stretch in the joint's own space that its mesh
  /// follows and its children do not inherit. One for each node, or empty when nothing is stretched.
  std::vector<Mat3> stretch;
};

/// The clip as it is, without any limb stretched.
[[nodiscard]] FrameState frameOf(const Scene& scene, Pose pose, double timeSeconds);

/// Stretch that a bind chain of the file gives its joint in a pose; only the chain's leaves are looked at.
[[nodiscard]] Mat3 stretchOf(const Scene& scene, const Pose& pose, const BindChain& chain);

/// World matrix that a mesh hanging rigidly on `node` is drawn with, its stretch included.
[[nodiscard]] Mat4 meshMatrix(const FrameState& frame, NodeIndex node);

/// Skinning matrices (bind-pose model space to world), one for each joint of the skin. The transform of the
/// node that holds the skinned mesh plays no part, as glTF demands.
[[nodiscard]] std::vector<Mat4> skinMatrices(const Skin& skin, const FrameState& frame);

} // namespace stretch
