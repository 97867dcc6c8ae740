#include "assets/dummy/body_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "assets/dummy/distance_field.h"

namespace stretch::assets {

namespace {

constexpr Vec3 shoulder{0.182, 1.366, -0.012};
constexpr Vec3 elbow{0.386, 1.186, -0.030};
constexpr Vec3 wrist{0.570, 1.020, 0.022};
constexpr Vec3 hip{0.092, 0.895, 0.0};
constexpr Vec3 knee{0.112, 0.492, 0.016};
constexpr Vec3 ankle{0.124, 0.098, -0.022};
constexpr Vec3 ball{0.138, 0.030, 0.100};

Vec3 mirror(const Vec3& p) {
  return {-p.x, p.y, p.z};
}
Vec3 leftSide(const Vec3& p) {
  return {std::abs(p.x), p.y, p.z};
}

/// A shape of the left side and its mirror image, with the crease between them filled.
template <typename Shape>
double bothSides(const Vec3& p, double width, Shape shape) {
  return smoothUnion(shape(p), shape(mirror(p)), width);
}

double torsoDistance(const Vec3& p) {
  const double pelvis = ellipsoidDistance(p, {0.0, 0.925, -0.004}, {0.142, 0.105, 0.108});
  const double waist = roundConeDistance(p, {0.0, 1.00, 0.0}, {0.0, 1.12, -0.002}, 0.096, 0.100);
  const double chest = ellipsoidDistance(p, {0.0, 1.258, -0.008}, {0.172, 0.150, 0.122});
  const double seat = bothSides(p, 0.04, [](const Vec3& q) {
    return sphereDistance(q, {0.066, 0.885, -0.052}, 0.078);
  });
  const double pectorals = bothSides(p, 0.03, [](const Vec3& q) {
    return ellipsoidDistance(q, {0.074, 1.282, 0.062}, {0.082, 0.062, 0.056});
  });
  const double trapezius = bothSides(p, 0.03, [](const Vec3& q) {
    return roundConeDistance(q, {0.03, 1.425, -0.022}, {0.168, 1.372, -0.016}, 0.046, 0.048);
  });
  double distance = smoothUnion(smoothUnion(pelvis, waist, 0.09), chest, 0.09);
  distance = smoothUnion(distance, seat, 0.06);
  distance = smoothUnion(distance, pectorals, 0.035);
  return smoothUnion(distance, trapezius, 0.06);
}

double armDistance(const Vec3& p) {
  const Vec3 upper = elbow - shoulder;
  const Vec3 lower = wrist - elbow;
  const double deltoid = ellipsoidDistance(p, shoulder + Vec3(0.012, 0.0, 0.0), {0.070, 0.072, 0.070});
  const double bone = roundConeDistance(p, shoulder + 0.1 * upper, elbow, 0.056, 0.042);
  const double biceps = sphereDistance(p, shoulder + 0.55 * upper + Vec3(0.004, 0.0, 0.012), 0.049);
  const double bulge = roundConeDistance(p, elbow, elbow + 0.36 * lower, 0.042, 0.052);
  const double tapering = roundConeDistance(p, elbow + 0.36 * lower, wrist, 0.052, 0.038);
  double distance = smoothUnion(deltoid, bone, 0.06);
  distance = smoothUnion(distance, biceps, 0.05);
  return smoothUnion(distance, smoothUnion(bulge, tapering, 0.03), 0.035);
}

double gloveDistance(const Vec3& p) {
  const Vec3 q = glm::transpose(gloveAxes()) * (p - wrist);
  const double mitt = ellipsoidDistance(q, {0.108, 0.0, 0.0}, {0.096, 0.080, 0.066});
  const double fingers = ellipsoidDistance(q, {0.130, -0.004, 0.036}, {0.066, 0.072, 0.046});
  const double thumb = roundConeDistance(q, {0.040, 0.050, 0.026}, {0.130, 0.078, 0.050}, 0.036, 0.032);
  const double cuff = roundConeDistance(q, {-0.062, 0.0, 0.0}, {0.010, 0.0, 0.0}, 0.055, 0.050);
  const double cuffEnd = -(q.x + 0.070);
  const double hand = smoothUnion(smoothUnion(mitt, fingers, 0.04), thumb, 0.014);
  return smoothUnion(hand, smoothIntersection(cuff, cuffEnd, 0.014), 0.03);
}

double legDistance(const Vec3& p) {
  const Vec3 shin = ankle - knee;
  const double thigh = roundConeDistance(p, hip + Vec3(0.0, 0.0, -0.004), knee, 0.092, 0.058);
  const double kneecap = sphereDistance(p, knee + Vec3(0.0, -0.005, 0.008), 0.056);
  const double calf =
      ellipsoidDistance(p, knee + 0.30 * shin + Vec3(0.0, 0.0, -0.016), {0.060, 0.125, 0.060});
  const double bone = roundConeDistance(p, knee, ankle, 0.054, 0.042);
  return smoothUnion(smoothUnion(thigh, kneecap, 0.04), smoothUnion(calf, bone, 0.04), 0.045);
}

double bootDistance(const Vec3& p) {
  const double shaft = roundConeDistance(p, ankle, {0.117, 0.285, -0.014}, 0.055, 0.073);
  const double heel = ellipsoidDistance(p, {0.122, 0.052, -0.050}, {0.054, 0.058, 0.056});
  const double instep =
      roundConeDistance(p, ankle + Vec3(0.0, 0.004, 0.016), {0.137, 0.056, 0.088}, 0.052, 0.054);
  const double toes = ellipsoidDistance(p, ball + Vec3(0.003, 0.018, 0.028), {0.067, 0.053, 0.088});
  const double hem = p.y - 0.258;
  double distance = smoothUnion(heel, instep, 0.05);
  distance = smoothUnion(distance, toes, 0.04);
  distance = smoothUnion(distance, smoothIntersection(shaft, hem, 0.016), 0.04);
  const double sole = smoothIntersection(distance - 0.005, p.y - 0.026, 0.010);
  return smoothIntersection(smoothUnion(distance, sole, 0.004), -p.y, 0.014);
}

double trunksDistance(const Vec3& p) {
  const double pelvis = ellipsoidDistance(p, {0.0, 0.93, -0.008}, {0.155, 0.125, 0.128});
  const double legs = bothSides(p, 0.03, [](const Vec3& q) {
    return roundConeDistance(q, {0.090, 0.875, -0.006}, {0.116, 0.60, 0.006}, 0.100, 0.106);
  });
  const double cloth = smoothUnion(smoothUnion(pelvis, legs, 0.05), torsoDistance(p) - 0.008, 0.02);
  return smoothIntersection(smoothIntersection(cloth, 0.655 - p.y, 0.014), p.y - 1.01, 0.010);
}

double waistbandDistance(const Vec3& p) {
  return smoothIntersection(torsoDistance(p) - 0.015, std::abs(p.y - 1.008) - 0.024, 0.016);
}

double faceDistance(const Vec3& p) {
  const double cranium = ellipsoidDistance(p, {0.0, 1.622, -0.012}, {0.122, 0.132, 0.130});
  const double jaw = ellipsoidDistance(p, {0.0, 1.535, 0.026}, {0.086, 0.072, 0.084});
  const double cheeks = bothSides(p, 0.0, [](const Vec3& q) {
    return sphereDistance(q, {0.052, 1.553, 0.066}, 0.042);
  });
  const double nose = ellipsoidDistance(p, {0.0, 1.580, 0.124}, {0.024, 0.022, 0.026});
  const double ears = ellipsoidDistance(leftSide(p), {0.126, 1.588, -0.010}, {0.018, 0.040, 0.028});
  const double skull = smoothUnion(smoothUnion(cranium, jaw, 0.08), cheeks, 0.05);
  return smoothUnion(smoothUnion(skull, nose, 0.018), ears, 0.014);
}

double headDistance(const Vec3& p) {
  const double neck = roundConeDistance(p, {0.0, 1.36, -0.020}, {0.0, 1.50, -0.010}, 0.058, 0.054);
  return smoothUnion(faceDistance(p), neck, 0.03);
}

double hairDistance(const Vec3& p) {
  const double cap = ellipsoidDistance(p, {0.0, 1.634, -0.020}, {0.127, 0.134, 0.131});
  const double hairline = 1.672 + 0.55 * (p.z - 0.06) - p.y;
  const double sides = smoothIntersection(cap, hairline, 0.012);
  const double quiff = roundConeDistance(p, {0.012, 1.742, 0.020}, {-0.020, 1.762, 0.098}, 0.046, 0.026);
  const double sweep = roundConeDistance(p, {0.040, 1.735, -0.030}, {0.012, 1.742, 0.030}, 0.040, 0.042);
  return smoothUnion(smoothUnion(sides, sweep, 0.02), quiff, 0.03);
}

double skinDistance(const Vec3& p) {
  double distance = smoothUnion(torsoDistance(p), bothSides(p, 0.03, legDistance), 0.05);
  distance = smoothUnion(distance, armDistance(leftSide(p)), 0.05);
  return smoothUnion(distance, headDistance(p), 0.04);
}

Vec3 bodyGradient(const Vec3& p) {
  constexpr double step = 1e-4;
  const auto slope = [&](const Vec3& offset) { return bodyDistance(p + offset) - bodyDistance(p - offset); };
  return Vec3(slope({step, 0.0, 0.0}), slope({0.0, step, 0.0}), slope({0.0, 0.0, step})) / (2.0 * step);
}

} // namespace

Mat3 gloveAxes() {
  const Vec3 along = glm::normalize(wrist - elbow);
  const Vec3 thumbwards = glm::normalize(Vec3(0.0, 0.0, 1.0) - along.z * along);
  return {along, thumbwards, glm::cross(along, thumbwards)};
}

Layers layersAt(const Vec3& point) {
  const Vec3 left = leftSide(point);
  return {skinDistance(point), hairDistance(point),   gloveDistance(left),
          bootDistance(left),  trunksDistance(point), waistbandDistance(point)};
}

double gloveReach(const Vec3& point) {
  return glm::dot(gloveAxes()[0], leftSide(point) - wrist);
}

double bodyDistance(const Vec3& point) {
  const Layers layers = layersAt(point);
  double distance = smoothUnion(layers.skin, layers.hair, 0.006);
  distance = smoothUnion(distance, layers.glove, 0.008);
  distance = smoothUnion(distance, layers.boot, 0.008);
  return smoothUnion(distance, smoothUnion(layers.trunks, layers.waistband, 0.006), 0.006);
}

Vec3 bodyNormal(const Vec3& point) {
  return glm::normalize(bodyGradient(point));
}

Vec3 projectToBody(const Vec3& point) {
  Vec3 projected = point;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Vec3 gradient = bodyGradient(projected);
    projected -= gradient * (bodyDistance(projected) / std::max(glm::dot(gradient, gradient), 0.25));
  }
  return projected;
}

} // namespace stretch::assets
