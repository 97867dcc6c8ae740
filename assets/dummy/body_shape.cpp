#include "assets/dummy/body_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "assets/dummy/distance_field.h"
#include "assets/dummy/head_shape.h"

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
  if (p.y < 0.68) {
    return farAway;
  }
  const double pelvis = ellipsoidDistance(p, {0.0, 0.925, -0.004}, {0.140, 0.105, 0.106});
  const double waist = roundConeDistance(p, {0.0, 1.00, 0.002}, {0.0, 1.12, 0.0}, 0.100, 0.108);
  const double chest = ellipsoidDistance(p, {0.0, 1.262, -0.008}, {0.176, 0.152, 0.122});
  const double seat = bothSides(p, 0.04, [](const Vec3& q) {
    return sphereDistance(q, {0.064, 0.890, -0.050}, 0.076);
  });
  const double pectorals = bothSides(p, 0.05, [](const Vec3& q) {
    return ellipsoidDistance(q, {0.072, 1.300, 0.058}, {0.090, 0.056, 0.052});
  });
  const double trapezius = bothSides(p, 0.03, [](const Vec3& q) {
    return roundConeDistance(q, {0.03, 1.415, -0.022}, {0.168, 1.372, -0.016}, 0.044, 0.048);
  });
  double distance = smoothUnion(smoothUnion(pelvis, waist, 0.10), chest, 0.12);
  distance = smoothUnion(distance, seat, 0.06);
  distance = smoothUnion(distance, pectorals, 0.055);
  return smoothUnion(distance, trapezius, 0.06);
}

double armDistance(const Vec3& p) {
  if (p.x < 0.04) {
    return farAway;
  }
  const Vec3 upper = elbow - shoulder;
  const Vec3 lower = wrist - elbow;
  const double deltoid = ellipsoidDistance(p, shoulder + Vec3(0.012, 0.0, 0.0), {0.071, 0.072, 0.070});
  const double bone = roundConeDistance(p, shoulder + 0.1 * upper, elbow, 0.057, 0.043);
  const Vec3 front(0.002, 0.0, 0.007);
  const double biceps =
      roundConeDistance(p, shoulder + 0.35 * upper + front, shoulder + 0.65 * upper + front, 0.049, 0.047);
  const double bulge = roundConeDistance(p, elbow, elbow + 0.38 * lower, 0.043, 0.051);
  const double tapering = roundConeDistance(p, elbow + 0.38 * lower, wrist, 0.051, 0.041);
  const double distance = smoothUnion(smoothUnion(deltoid, bone, 0.08), biceps, 0.06);
  return smoothUnion(distance, smoothUnion(bulge, tapering, 0.04), 0.05);
}

/// Columns point from the wrist to the knuckles, towards the thumb, out of the palm.
Mat3 gloveAxes() {
  const Vec3 along = glm::normalize(wrist - elbow);
  const Vec3 thumbwards = glm::normalize(Vec3(0.0, 0.0, 1.0) - along.z * along);
  return {along, thumbwards, glm::cross(along, thumbwards)};
}

double gloveDistance(const Vec3& p) {
  if (p.x < 0.30) {
    return farAway;
  }
  constexpr double scale = 1.14;
  const Vec3 q = glm::transpose(gloveAxes()) * (p - wrist) / scale;
  const double mitt = ellipsoidDistance(q, {0.106, 0.0, 0.0}, {0.094, 0.080, 0.068});
  const double fingers = ellipsoidDistance(q, {0.128, -0.004, 0.034}, {0.066, 0.073, 0.048});
  const double thumb = roundConeDistance(q, {0.040, 0.050, 0.026}, {0.128, 0.078, 0.048}, 0.037, 0.034);
  const double cuff = roundConeDistance(q, {-0.080, 0.0, 0.0}, {0.010, 0.0, 0.0}, 0.057, 0.050);
  const double open = cuffEnd / scale - q.x;
  const double hand = smoothUnion(smoothUnion(mitt, fingers, 0.04), thumb, 0.014);
  return scale * smoothUnion(hand, smoothIntersection(cuff, open, 0.012), 0.03);
}

double legDistance(const Vec3& p) {
  if (p.y > 1.10) {
    return farAway;
  }
  const Vec3 shin = ankle - knee;
  const double thigh = roundConeDistance(p, hip + Vec3(0.0, -0.02, -0.004), knee, 0.086, 0.057);
  const double kneecap = sphereDistance(p, knee + Vec3(0.0, 0.0, 0.005), 0.054);
  const double calf =
      ellipsoidDistance(p, knee + 0.32 * shin + Vec3(0.0, 0.0, -0.013), {0.058, 0.150, 0.059});
  const double bone = roundConeDistance(p, knee, ankle, 0.054, 0.046);
  return smoothUnion(smoothUnion(thigh, kneecap, 0.05), smoothUnion(calf, bone, 0.05), 0.06);
}

double bootDistance(const Vec3& p) {
  if (p.y > 0.42) {
    return farAway;
  }
  const double shaft = roundConeDistance(p, ankle, {0.116, 0.29, -0.014}, 0.056, 0.075);
  const double heel = ellipsoidDistance(p, {0.122, 0.054, -0.050}, {0.056, 0.060, 0.058});
  const double instep =
      roundConeDistance(p, ankle + Vec3(0.0, 0.004, 0.016), {0.137, 0.058, 0.088}, 0.053, 0.056);
  const double toes = ellipsoidDistance(p, ball + Vec3(0.003, 0.021, 0.030), {0.071, 0.058, 0.092});
  double distance = smoothUnion(smoothUnion(heel, instep, 0.05), toes, 0.04);
  const double arch = roundConeDistance(p, {0.124, 0.036, -0.040}, {0.139, 0.036, 0.090}, 0.050, 0.058);
  distance =
      smoothUnion(smoothUnion(distance, arch, 0.03), smoothIntersection(shaft, p.y - bootHem, 0.012), 0.04);
  return smoothIntersection(distance, -p.y, 0.014);
}

double trunksDistance(const Vec3& p, double torso) {
  if (p.y < 0.55 || p.y > 1.12) {
    return farAway;
  }
  const double pelvis = ellipsoidDistance(p, {0.0, 0.935, -0.008}, {0.166, 0.125, 0.128});
  const double legs = bothSides(p, 0.02, [](const Vec3& q) {
    return roundConeDistance(q, {0.098, 0.875, -0.006}, {0.129, 0.60, 0.006}, 0.094, 0.104);
  });
  const double cloth = smoothUnion(smoothUnion(pelvis, legs, 0.06), torso - 0.008, 0.02);
  return smoothIntersection(smoothIntersection(cloth, trunksHem - p.y, 0.012), p.y - 1.01, 0.010);
}

double waistbandDistance(const Vec3& p, double torso) {
  return smoothIntersection(torso - 0.015, std::abs(p.y - 1.008) - 0.024, 0.010);
}

double skinDistance(const Vec3& p, double torso) {
  double distance = smoothUnion(torso, bothSides(p, 0.03, legDistance), 0.05);
  distance = smoothUnion(distance, armDistance(leftSide(p)), 0.05);
  return smoothUnion(distance, p.y > 1.25 ? headDistance(p) : farAway, 0.04);
}

} // namespace

Layers layersAt(const Vec3& point) {
  const Vec3 left = leftSide(point);
  const double torso = torsoDistance(point);
  return {skinDistance(point, torso),   point.y > 1.40 ? hairDistance(point) : farAway,
          gloveDistance(left),          bootDistance(left),
          trunksDistance(point, torso), waistbandDistance(point, torso)};
}

double bodyDistance(const Vec3& point) {
  const Layers layers = layersAt(point);
  double distance = smoothUnion(layers.skin, layers.hair, 0.006);
  distance = smoothUnion(distance, layers.glove, 0.008);
  distance = smoothUnion(distance, layers.boot, 0.008);
  return smoothUnion(distance, smoothUnion(layers.trunks, layers.waistband, 0.006), 0.006);
}

Vec3 bodyNormal(const Vec3& point) {
  return glm::normalize(gradientOf(bodyDistance, point));
}

Vec3 layerNormal(double Layers::*layer, const Vec3& point) {
  return glm::normalize(gradientOf([&](const Vec3& p) { return layersAt(p).*layer; }, point));
}

Vec3 projectToBody(const Vec3& point) {
  Vec3 projected = point;
  for (int iteration = 0; iteration < 3; ++iteration) {
    const Vec3 gradient = gradientOf(bodyDistance, projected);
    projected -= gradient * (bodyDistance(projected) / std::max(glm::dot(gradient, gradient), 0.25));
  }
  return projected;
}

double gloveReach(const Vec3& point) {
  return glm::dot(gloveAxes()[0], leftSide(point) - wrist);
}

} // namespace stretch::assets
