#include "assets/dummy/head_shape.h"

#include <algorithm>
#include <cmath>

#include "assets/dummy/distance_field.h"

namespace stretch::assets {

namespace {

constexpr Vec3 drawnPivot{0.0, 1.485, -0.006}; ///< Where the head turns on the neck.
constexpr Vec3 modelPivot{0.0, 1.463, -0.006};

Vec3 modelToHead(const Vec3& point) {
  return drawnPivot + (point - modelPivot) / headScale;
}

double faceDistance(const Vec3& p) {
  const Vec3 left(std::abs(p.x), p.y, p.z);
  const double cranium = ellipsoidDistance(p, {0.0, 1.622, -0.012}, {0.122, 0.132, 0.130});
  const double jaw = ellipsoidDistance(p, {0.0, 1.535, 0.026}, {0.088, 0.072, 0.084});
  const double cheeks = sphereDistance(left, {0.052, 1.553, 0.066}, 0.042);
  const double nose = ellipsoidDistance(p, {0.0, 1.580, 0.127}, {0.025, 0.022, 0.026});
  const double ears = ellipsoidDistance(left, {0.126, 1.588, -0.010}, {0.019, 0.040, 0.029});
  const double skull = smoothUnion(smoothUnion(cranium, jaw, 0.08), cheeks, 0.05);
  return smoothUnion(smoothUnion(skull, nose, 0.020), ears, 0.014);
}

} // namespace

Vec3 headToModel(const Vec3& point) {
  return modelPivot + (point - drawnPivot) * headScale;
}

double headDistance(const Vec3& point) {
  const double neck = roundConeDistance(point, {0.0, 1.36, -0.020}, {0.0, 1.48, -0.010}, 0.060, 0.056);
  return smoothUnion(headScale * faceDistance(modelToHead(point)), neck, 0.03);
}

double hairDistance(const Vec3& point) {
  const Vec3 p = modelToHead(point);
  const double cap = ellipsoidDistance(p, {0.0, 1.634, -0.020}, {0.127, 0.134, 0.131});
  const double hairline = 1.668 + 0.62 * (p.z - 0.06) - p.y;
  const double sides = smoothIntersection(cap, hairline, 0.012);
  const double quiff = roundConeDistance(p, {0.012, 1.742, 0.020}, {-0.020, 1.762, 0.098}, 0.046, 0.026);
  const double sweep = roundConeDistance(p, {0.040, 1.735, -0.030}, {0.012, 1.742, 0.030}, 0.040, 0.042);
  return headScale * smoothUnion(smoothUnion(sides, sweep, 0.02), quiff, 0.03);
}

} // namespace stretch::assets
