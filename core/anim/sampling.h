#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"

namespace stretch {

/// Local transforms of every node at one time, and the morph weights that the clip drives.
struct Pose {
  std::vector<Transform> locals; ///< One for each node.
  std::vector<bool> usesMatrix;  ///< Node keeps the file's matrix (not animated): locals[i] is only its
                                 ///< nearest TRS.
  std::vector<std::vector<float>> weights; ///< One for each node: morph weights; empty = the mesh's defaults.
};

/// Value of a track at a time, as the glTF 2.0 specification says (Appendix C): held before the first and
/// after the last key; STEP holds; LINEAR lerps, rotations slerp along the shorter arc; CUBICSPLINE is the
/// Hermite spline with tangents scaled by the key distance, rotations normalised. Writes track.width numbers
/// to `out`.
void sampleTrack(const Track& track, double timeSeconds, double* out);

/// Every node at rest.
[[nodiscard]] Pose restPose(const Scene& scene);

/// The clip's pose; what it does not animate is at rest.
[[nodiscard]] Pose samplePose(const Scene& scene, const Clip& clip, double timeSeconds);

/// The local matrix of a node in a pose: the file's own matrix where it is in use, else TRS.
[[nodiscard]] Mat4 localMatrix(const Scene& scene, const Pose& pose, int node);

/// World matrix of every node.
[[nodiscard]] std::vector<Mat4> worldMatrices(const Scene& scene, const Pose& pose);

} // namespace stretch
