#include "app/weight/standing.h"

#include <algorithm>
#include <iterator>

#include "skinning/elastic/limb_elasticity.h"

namespace stretch::app {

Standing standingOf(const SampledClip& sampled, double metresPerUnit) {
  const Vec3 up(0.0, 1.0, 0.0);
  Standing standing;
  skinning::PlantedSettings settings;
  settings.speed = 4.0;
  settings.height = 0.1;
  for (const SampledClip::OfLimb& one : sampled.limbs) {
    if (isLeg(one.limb)) {
      const double lowest = *std::min_element(one.lowest.begin(), one.lowest.end());
      settings.ground = std::min(settings.ground.value_or(lowest), lowest);
    }
  }
  for (const SampledClip::OfLimb& one : sampled.limbs) {
    if (!isLeg(one.limb)) {
      continue;
    }
    std::vector<Vec3> heights;
    std::transform(one.lowest.begin(), one.lowest.end(), std::back_inserter(heights),
                   [&](double height) { return height * up; });
    const double length = one.limb.restLength * metresPerUnit;
    const double rate = sampled.samplesPerSecond;
    standing.legs.push_back(one.limb.id);
    standing.planted.push_back(skinning::plantedWeights(heights, rate, length, up, settings));
    standing.kept.push_back(skinning::touchingWeights(heights, rate, length, up, settings));
  }
  standing.shares = skinning::sharedMass(standing.planted, 1.0);
  return standing;
}

} // namespace stretch::app
