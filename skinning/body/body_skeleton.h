#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// The centre line of a body without branches and how its surface lies along it; made from one pose, followed
/// through others.
struct BodySkeleton {
  std::vector<Vec3> joints; ///< segmentCount + 1 points of the pose it was made from; segments are equally
                            ///< long.
  std::vector<double> stations; ///< Places of the joints along the centre line, mesh units, ascending.
  std::vector<double> along;    ///< Places of the vertices along it.
  double length = 0.0;          ///< Sum of the segment lengths.

  [[nodiscard]] std::size_t segmentCount() const { return joints.size() - 1; }
};

/// Vertices are moved inwards by half their shape diameter, ordered by their distance over the surface from
/// the end that is farthest from everything, a smooth curve is fitted to them (least squares) and cut into
/// equal segments. An error for a body with branches, in several parts, or too small for the number of
/// segments.
[[nodiscard]] Result<BodySkeleton> skeletonOfBody(std::span<const glm::vec3> positions,
                                                  const std::vector<Triangle>& triangles,
                                                  const std::vector<double>& vertexDiameters,
                                                  int segmentCount);

/// The joints in any pose of the same mesh: each is a fixed weighted mean of the vertices of its
/// cross-section, the same material in every frame, so nothing drifts along or around the body.
class JointTracker {
public:
  /// `positions` are those that the skeleton was made of; in them the joints are the skeleton's.
  JointTracker(const BodySkeleton& skeleton, std::span<const glm::vec3> positions);

  [[nodiscard]] std::vector<Vec3> joints(std::span<const glm::vec3> positions) const;

private:
  struct Part {
    std::uint32_t vertex = 0;
    double weight = 0.0;
  };
  std::vector<std::vector<Part>> parts_; ///< One list for each joint; its weights sum to 1.
};

/// Index of the segment that a place along the body belongs to.
[[nodiscard]] std::size_t segmentAt(const BodySkeleton& skeleton, double along);

/// Segment of every triangle: that of its corners' mean place.
[[nodiscard]] std::vector<int> segmentsOfTriangles(const BodySkeleton& skeleton,
                                                   const std::vector<Triangle>& triangles);

/// Sum of the angles between neighbouring segments (radians): Eq. 7 of the paper.
[[nodiscard]] double totalCurvature(const std::vector<Vec3>& joints);

} // namespace stretch::skinning
