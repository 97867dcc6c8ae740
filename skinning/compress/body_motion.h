#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/body/body_skeleton.h"

namespace stretch::skinning {

/// How one segment of the body moved since the first frame: x -> rotation * stretch * x, stretch symmetric.
/// Measured on the segment's own vertices, so that turns about the axis are the material's and neither flip
/// nor drift.
struct SegmentMotion {
  Quat rotation{1.0, 0.0, 0.0, 0.0};
  Mat3 stretch{1.0};
};

/// A body without branches through all its frames; the first is the pose that everything is measured against.
struct BodyMotion {
  BodySkeleton skeleton;
  std::vector<double> widths;            ///< Mean shape diameter of each segment.
  std::vector<double> volumes;           ///< Volume of each segment; they sum to the body's.
  std::vector<std::vector<Vec3>> joints; ///< Joints in each frame.
  std::vector<SegmentMotion> segments;   ///< Frame after frame, one for each segment.

  [[nodiscard]] std::size_t segmentCount() const { return skeleton.segmentCount(); }
  [[nodiscard]] const SegmentMotion& motion(std::size_t frame, std::size_t segment) const {
    return segments[frame * segmentCount() + segment];
  }
};

/// Shape diameters, centre line and the motion of `segmentCount` segments. Errors: see skeletonOfBody and
/// shapeDiameters.
[[nodiscard]] Result<BodyMotion> analyseBody(const MeshSequence& sequence, int segmentCount);

} // namespace stretch::skinning
