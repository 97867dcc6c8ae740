#pragma once

#include <cstddef>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/gltf/patch/edits.h"
#include "core/scene/scene.h"
#include "rig/rekey/bind_leaves.h"

namespace stretch::rig {

struct CornerOptions {
  std::size_t mostInfluences = 8; ///< Most of a vertex; 1 to 8.
  double height = 1.0;            ///< Height of the character, world units.
  /// Moments at which a vertex with too many influences is fitted, the stretched ones among them.
  std::vector<FrameState> moments;
};

/// Cost of fitting: distances of vertices from where the scale of leaves would have them, those on corners of
/// the file from where these have them, as shares of the height, at the moments that were looked at.
struct CornerFit {
  std::size_t joints = 0;   ///< Joints that corners carry.
  std::size_t corners = 0;  ///< Corners in use.
  std::size_t vertices = 0; ///< Vertices that new ones move, or that are fitted.
  std::size_t fitted = 0;   ///< Vertices with more influences than allowed, which are fitted.
  double median = 0.0;
  double percentile99 = 0.0;
  double worst = 0.0;
};

/// Adds corners to what is saved (docs/rig.md, Corners): under each stretched joint J nodes at the corners
/// c_k of a tetrahedron that holds what J moves, which the stretch moves to K c_k; a vertex's weight for J
/// becomes that of the corners by its affine coordinates. A bone that only lengthens has one or two ends.
/// A vertex with too many influences, and far from its place by any fit, has corners of its own.
/// Corners that the file has already are used again. A mesh that hangs on J rigidly becomes a skinned one.
CornerFit addBindCorners(const Scene& scene, const std::vector<ClipStretches>& clips,
                         const CornerOptions& options, gltf::Edits& edits);

} // namespace stretch::rig
