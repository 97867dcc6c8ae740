#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/retarget/body_parts.h"
#include "core/math/bounds.h"
#include "skinning/geometry/inside.h"

namespace stretch::app {

/// A place on trunk or head by what bodies have in common: how far it is to the left (x) and to the front (z)
/// from the middle of the body there, in half widths of it, and along the body (y): 0 at the hips, 1 at the
/// shoulders, 2 at the head's joint. On the head y is from its middle, in half heights.
struct ChartPlace {
  bool isOfHead = false;
  Vec3 place{0.0};
};

/// The surface of a body's trunk and head in its bind pose, by which a place on it is found on another's.
class BodyChart {
public:
  /// The parts have to outlive it.
  BodyChart(const rig::Skeleton& skeleton, const BodyParts& parts);

  /// `point`: on the triangles of the trunk.
  [[nodiscard]] ChartPlace placeOf(const skinning::SurfacePoint& point) const;

  /// The point of the trunk's triangles where a ray from the body's axis to the place goes through them,
  /// nearest to it; nothing where this body lacks the part.
  [[nodiscard]] std::optional<skinning::SurfacePoint> pointAt(const ChartPlace& place) const;

private:
  static constexpr int sliceCount = 12;

  struct Widths {
    Vec3 middle{0.0};
    Vec3 half{0.0};
  };

  [[nodiscard]] double alongOf(double height) const;
  [[nodiscard]] double heightOf(double along) const;
  [[nodiscard]] Widths widthsAt(double along) const;

  const BodyParts& parts_;
  std::vector<Vec3> places_;     // to the left, up, to the front
  std::array<double, 3> levels_; // heights of hips, shoulders, head's joint, rising
  std::array<Bounds, sliceCount> slices_;
  Bounds head_;
};

} // namespace stretch::app
