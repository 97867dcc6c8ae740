#include "assets/dummy/paint.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/dummy/body_shape.h"
#include "assets/dummy/head_shape.h"
#include "core/math/srgb.h"

namespace stretch::assets {

namespace {

unsigned paletteHex(Region region) {
  switch (region) {
  case Region::skin:
    return skinHex;
  case Region::hair:
    return hairHex;
  case Region::glove:
    return 0xD9342B;
  case Region::cuff:
  case Region::stripe:
  case Region::waistband:
  case Region::bootTrim:
  case Region::sole:
    return 0xF6EEDF;
  case Region::trunks:
    return 0x1C7C86;
  case Region::boot:
    return 0xC22F2A;
  }
  return 0xFFFFFF;
}

/// How open the surroundings of a surface point are: 1 in the open, towards 0 in a crease.
double openness(const Vec3& point, const Vec3& normal) {
  double blocked = 0.0;
  double weight = 1.0;
  for (int step = 1; step <= 5; ++step) {
    const double reach = 0.012 * step;
    blocked += weight * std::max(0.0, reach - bodyDistance(point + reach * normal));
    weight *= 0.7;
  }
  return std::clamp(1.0 - 9.0 * blocked, 0.0, 1.0);
}

/// 1 at a place of the face (left side, the head's drawing space), falling smoothly to 0 at `radius`.
double bump(const Vec3& point, const Vec3& place, double radius) {
  const Vec3 offset = Vec3(std::abs(point.x), point.y, point.z) - headToModel(place);
  const double square = glm::dot(offset, offset) / (radius * radius);
  const double inside = std::max(0.0, 1.0 - square);
  return inside * inside;
}

} // namespace

Vec3 linearColor(unsigned hex) {
  const auto channel = [&](unsigned shift) {
    return linearFromSrgb(static_cast<double>((hex >> shift) & 0xFFU) / 255.0);
  };
  return {channel(16U), channel(8U), channel(0U)};
}

Vec3 paintedColor(Region region, const Vec3& point, const Vec3& normal) {
  Vec3 color = linearColor(paletteHex(region));
  if (region == Region::skin) {
    const double blush = bump(point, {0.062, 1.553, 0.09}, 0.045) +
                         0.9 * bump(point, {0.0, 1.580, 0.14}, 0.04) +
                         0.6 * bump(point, {0.135, 1.588, -0.01}, 0.05);
    color = glm::mix(color, linearColor(0xE88F72), 0.55 * std::min(1.0, blush));
  }
  const double open = openness(point, normal);
  const Vec3 shade = glm::mix(Vec3(0.50, 0.38, 0.40), Vec3(1.0), open);
  return color * shade;
}

} // namespace stretch::assets
