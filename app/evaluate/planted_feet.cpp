#include "app/evaluate/planted_feet.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "app/evaluate/evaluate.h"
#include "app/standing_floor.h"
#include "app/weight/sample_clip.h"
#include "core/anim/frames.h"
#include "skinning/elastic/limb_elasticity.h"

namespace stretch::app {

namespace {

constexpr double shortestFrames = 2.0;
constexpr double blendFrames = 2.0;

// Of all feet, height along +Y, metres.
std::optional<double> groundOf(const SampledClip& sampled) {
  std::optional<double> ground;
  for (const SampledClip::OfLimb& one : sampled.limbs) {
    for (const double height : one.lowest) {
      ground = std::min(ground.value_or(height), height);
    }
  }
  return ground;
}

// How high a block under a place is, metres.
using BlockTop = std::function<std::optional<double>(const Vec3& place)>;

// Whether the foot stands, sample by sample: it keeps its place, and its lowest joint is near the ground or
// a block.
std::vector<bool> standsOf(const SampledClip& sampled, const SampledClip::OfLimb& leg, double legLength,
                           const BlockTop& blockTop) {
  const Vec3 up(0.0, 1.0, 0.0);
  const double nearGround = 0.1 * legLength;
  std::vector<Vec3> ends;
  for (const std::vector<Vec3>& joints : leg.joints) {
    ends.push_back(joints.back());
  }
  skinning::PlantedSettings settings;
  settings.height = 1e6; // the lowest joint tells below
  settings.fadeSeconds = 0.0;
  const std::vector<double> still =
      skinning::plantedWeights(ends, sampled.samplesPerSecond, legLength, up, settings);
  const double ground = groundOf(sampled).value_or(0.0);
  std::vector<bool> stands;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool isStill = still[i] > 0.5;
    const double under =
        isStill ? std::max(ground, blockTop({ends[i].x, leg.lowest[i], ends[i].z}).value_or(ground)) : ground;
    stands.push_back(isStill && leg.lowest[i] < under + nearGround);
  }
  return stands;
}

rig::Pin pinOver(const SampledClip::OfLimb& leg, int clip, double first, double last) {
  rig::Pin pin;
  pin.limb = leg.limb.id;
  pin.clip = clip;
  pin.time = {{first, last}, {blendFrames, blendFrames}};
  pin.atFrame = std::floor(0.5 * (first + last));
  pin.turns = false;
  return pin;
}

void addPins(const SampledClip& sampled, const SampledClip::OfLimb& leg, double legLength, int clip,
             double framesPerSecond, const Vec2& frames, const BlockTop& blockTop,
             std::vector<rig::Pin>& pins) {
  const std::vector<bool> stands = standsOf(sampled, leg, legLength, blockTop);
  const auto frameOfSample = [&](std::size_t i) { return sampled.seconds[i] * framesPerSecond; };
  for (std::size_t i = 0; i < stands.size(); ++i) {
    if (!stands[i]) {
      continue;
    }
    const std::size_t start = i;
    while (i + 1 < stands.size() && stands[i + 1]) {
      ++i;
    }
    const double first = std::max(wholeFrameAtLeast(frameOfSample(start)), std::ceil(frames.x));
    const double last = std::min(wholeFrameAtMost(frameOfSample(i)), std::floor(frames.y));
    if (last - first >= shortestFrames) {
      pins.push_back(pinOver(leg, clip, first, last));
    }
  }
}

// Where a foot is pinned again soon after, both share the frames between them.
void shareBlends(std::vector<rig::Pin>& pins) {
  for (std::size_t i = 1; i < pins.size(); ++i) {
    const double between = pins[i].time.rangeFrames.x - pins[i - 1].time.rangeFrames.y;
    if (pins[i].limb == pins[i - 1].limb && between < 2.0 * blendFrames) {
      pins[i - 1].time.blendFrames.y = 0.5 * between;
      pins[i].time.blendFrames.x = 0.5 * between;
    }
  }
}

} // namespace

rig::Holds plantedFeet(const Document& document, int clip, const Vec2& frames) {
  Document adjusted = document;
  adjusted.trails.clear();
  adjusted.holds = {};
  adjusted.weights.clear();
  const EvaluationInput input = evaluationInput(adjusted, clip);
  const WeightInput weight = weightInput(input);
  const SampledClip sampled = sampleClip(weight, prepareMotion(adjusted, clip));
  const double unit = weight.metresPerUnit();
  const std::vector<Bounds> blocks = blocksOf(adjusted, clip);
  const BlockTop blockTop = [&](const Vec3& place) {
    const std::optional<double> top = blockTopUnder(blocks, place / unit);
    return top ? std::optional(*top * unit) : std::nullopt;
  };
  rig::Holds found;
  for (const SampledClip::OfLimb& leg : sampled.limbs) {
    addPins(sampled, leg, leg.limb.restLength * unit, clip, clipOf(document, clip).framesPerSecond, frames,
            blockTop, found.pins);
  }
  shareBlends(found.pins);
  return found;
}

} // namespace stretch::app
