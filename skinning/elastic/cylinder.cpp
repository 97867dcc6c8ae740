#include "skinning/elastic/cylinder.h"

#include <algorithm>
#include <cmath>

#include "core/math/types.h"

namespace stretch::skinning {

double gravityDisplacement(const Cylinder& cylinder, double gravityAcross) {
  const double stiffness = 2.0 * cylinder.youngModulus * cylinder.length;
  return stiffness > 0.0 ? cylinder.mass * std::abs(gravityAcross) * pi / stiffness : 0.0;
}

double compressionFactor(const Cylinder& cylinder, double gravityAcross) {
  if (!(cylinder.width > 0.0)) {
    return 0.0;
  }
  return std::clamp(gravityDisplacement(cylinder, gravityAcross) / cylinder.width, 0.0, largestCompression);
}

double axialScale(double axialForce, double youngModulus, double volume, double length) {
  constexpr double shortest = 0.5;
  constexpr double longest = 2.0;
  if (!(volume > 0.0 && length > 0.0 && youngModulus > 0.0)) {
    return 1.0;
  }
  const double area = volume / length;
  return std::clamp(1.0 + axialForce / (youngModulus * area), shortest, longest);
}

StretchFactors combine(double compression, double along, double volume, double crossVolume) {
  const double across = std::pow(along, -0.5 * crossVolume);
  return {along, (1.0 - compression) * across, std::pow(1.0 - compression, -volume) * across};
}

} // namespace stretch::skinning
