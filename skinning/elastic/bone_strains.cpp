#include "skinning/elastic/bone_strains.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"

namespace stretch::skinning {

namespace {

Vec3 unitOr(const Vec3& v, const Vec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : otherwise;
}

Vec3 perpendicularTo(const Vec3& axis, const Vec3& direction) {
  return unitOr(direction - glm::dot(direction, axis) * axis, anyPerpendicular(axis));
}

// The flattening of one bone at one time: log(1 - q), and the direction across the bone that it has.
struct BoneFlattening {
  Vec3 axis{1.0, 0.0, 0.0};
  double along = 1.0;
  double logarithm = 0.0;
  Vec3 direction{0.0, 1.0, 0.0};
};

BoneFlattening boneFlatteningOf(const LimbStretch& stretch, const Mat3& toJoint) {
  BoneFlattening f;
  f.axis = unitOr(toJoint * stretch.along, f.axis);
  f.along = stretch.factors.along;
  // combine() of cylinder.h: with the load (1 - q) / sqrt(along), sideways 1 / (1 - q) / sqrt(along).
  f.logarithm = 0.5 * std::log(stretch.factors.withLoad / stretch.factors.sideways);
  f.direction = perpendicularTo(f.axis, toJoint * stretch.withLoad);
  return f;
}

// A flattening across the bone as a vector of twice its angle, so that opposite directions are one and
// perpendicular ones cancel.
Vec2 doubleAngle(const BoneFlattening& f, const Vec3& reference) {
  const Vec3 first = perpendicularTo(f.axis, reference);
  const double angle =
      std::atan2(glm::dot(f.direction, glm::cross(f.axis, first)), glm::dot(f.direction, first));
  return f.logarithm * Vec2(std::cos(2.0 * angle), std::sin(2.0 * angle));
}

// Twice the angle of the axes that hold most of the flattening over all times.
double mainDoubleAngle(const std::vector<BoneFlattening>& times, const Vec3& reference) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const BoneFlattening& f : times) {
    const Vec2 v = doubleAngle(f, reference);
    xx += v.x * v.x;
    xy += v.x * v.y;
    yy += v.y * v.y;
  }
  return 0.5 * std::atan2(2.0 * xy, xx - yy);
}

Mat3 strainOf(const BoneFlattening& f, const Vec3& reference, double mainAngle) {
  const Vec2 v = doubleAngle(f, reference);
  const double kept = v.x * std::cos(mainAngle) + v.y * std::sin(mainAngle);
  const Vec3 flat = axisAngle(f.axis, 0.5 * mainAngle) * perpendicularTo(f.axis, reference);
  const Vec3 wide = glm::cross(f.axis, flat);
  const double across = 1.0 / std::sqrt(f.along);
  return (f.along - 1.0) * glm::outerProduct(f.axis, f.axis) +
         (std::exp(kept) * across - 1.0) * glm::outerProduct(flat, flat) +
         (std::exp(-kept) * across - 1.0) * glm::outerProduct(wide, wide);
}

} // namespace

std::vector<std::vector<Mat3>> boneStrains(const std::vector<std::vector<LimbStretch>>& stretches,
                                           const std::vector<std::vector<Mat3>>& toJoint) {
  std::vector<std::vector<Mat3>> strains(stretches.size());
  const std::size_t bones = stretches.empty() ? 0 : stretches.front().size();
  for (std::size_t bone = 0; bone < bones; ++bone) {
    std::vector<BoneFlattening> times;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      times.push_back(boneFlatteningOf(stretches[k][bone], toJoint[k][bone]));
    }
    const Vec3 reference = anyPerpendicular(times.front().axis);
    const double mainAngle = mainDoubleAngle(times, reference);
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      strains[k].push_back(strainOf(times[k], reference, mainAngle));
    }
  }
  return strains;
}

} // namespace stretch::skinning
