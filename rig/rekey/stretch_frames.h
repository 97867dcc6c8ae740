#pragma once

#include <vector>

#include "rig/rekey/exact_motion.h"

namespace stretch::rig {

/// A stretch K = A diag(factors) A^T as a bind leaf holds it.
struct StretchFrame {
  Quat axes{1.0, 0.0, 0.0, 0.0}; ///< A.
  Vec3 factors{1.0};

  [[nodiscard]] Mat3 matrix() const;
};

/// The frame of a symmetric K whose axes are turned as little as possible from `near` (Jacobi's method
/// started there): where K has no axes of its own, those of `near` stand.
[[nodiscard]] StretchFrame frameNear(const Mat3& stretch, const Quat& near);

/// The frame of K whose x axis is the one that its factor tells apart from the other two most: the bone's.
[[nodiscard]] StretchFrame mainFrame(const Mat3& stretch);

/// Between two frames as a player interpolates the leaf's scale and rotation, t in [0, 1].
[[nodiscard]] Mat3 between(const StretchFrame& a, const StretchFrame& b, double t);

/// Frames of one node's stretch over time, continuous: told from the strongest stretch outwards, so that the
/// identity takes the axes of what comes next to it. Where one set of axes does for all times (no point of
/// the bone is off by more than 1e-5 of it), there is only that one.
class StretchFrames {
public:
  /// `times` ascending, at least one; the stretch K of the node at each.
  StretchFrames(NodeIndex node, std::vector<double> times, const std::vector<Mat3>& stretches);

  [[nodiscard]] StretchFrame at(ExactMotion& exact, double timeSeconds) const;
  [[nodiscard]] bool axesAreFixed() const { return axes_.size() == 1; }

private:
  NodeIndex node_;
  std::vector<double> times_;
  std::vector<Quat> axes_; // one for each time, or one for all
};

} // namespace stretch::rig
