#include "app/edits/rate_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"

namespace stretch::app {

namespace {

constexpr double sameRate = 1e-6; ///< Frames per second.

void setRate(Document& document, int clip, double framesPerSecond) {
  std::vector<Clip> clips = *document.clips;
  clips[static_cast<std::size_t>(clip)].framesPerSecond = framesPerSecond;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
}

/// What lies on a frame stays exactly there when it is counted to and fro.
double recounted(double frame, double factor) {
  const double moved = frame * factor;
  const double whole = std::round(moved);
  return std::abs(moved - whole) < 1e-6 ? whole : moved;
}

} // namespace

rig::Trail recounted(rig::Trail trail, double factor) {
  rig::TrailSettings& settings = trail.settings;
  settings.startFrame = recounted(settings.startFrame, factor);
  settings.endFrame = recounted(settings.endFrame, factor);
  if (settings.releaseFrames) {
    settings.releaseFrames = recounted(*settings.releaseFrames, factor);
  }
  for (rig::SphereOffset& sphere : settings.spheres) {
    sphere.frame = recounted(sphere.frame, factor);
    if (sphere.tangent) {
      *sphere.tangent /= factor; // A slope for each frame.
    }
  }
  for (double& frame : trail.controlFrames) {
    frame = recounted(frame, factor);
  }
  return trail;
}

rig::Adjustment recounted(rig::Adjustment adjustment, double factor) {
  if (adjustment.rangeFrames) {
    Vec2& range = *adjustment.rangeFrames;
    range = {recounted(range.x, factor), recounted(range.y, factor)};
  }
  for (rig::OffsetKey& key : adjustment.keys) {
    key.frame = recounted(key.frame, factor);
    key.moveSlope /= factor; // Slopes are for each frame.
    key.turnSlope /= factor;
    key.valueSlope /= factor;
  }
  return adjustment;
}

WeightedLimb recounted(WeightedLimb weight, double factor) {
  if (weight.settings.rangeFrames) {
    Vec2& range = *weight.settings.rangeFrames;
    range = {recounted(range.x, factor), recounted(range.y, factor)};
  }
  return weight;
}

double ownRate(const Document& document, int clip) {
  const auto chosen = std::find_if(document.rates.begin(), document.rates.end(),
                                   [&](const ClipRate& rate) { return rate.clip == clip; });
  return chosen == document.rates.end() ? clipOf(document, clip).framesPerSecond : chosen->own;
}

Document workAtRate(const Document& document, int clip, double framesPerSecond) {
  check(framesPerSecond > 0.0, "a rate is above 0");
  const double own = ownRate(document, clip);
  const double factor = framesPerSecond / clipOf(document, clip).framesPerSecond;
  Document changed = document;
  setRate(changed, clip, framesPerSecond);
  std::erase_if(changed.rates, [&](const ClipRate& rate) { return rate.clip == clip; });
  if (std::abs(framesPerSecond - own) > sameRate) {
    changed.rates.push_back({clip, framesPerSecond, own});
  }
  for (rig::Trail& trail : changed.trails) {
    trail = trail.clip == clip ? recounted(std::move(trail), factor) : std::move(trail);
  }
  for (rig::Adjustment& adjustment : changed.adjustments) {
    adjustment = adjustment.clip == clip ? recounted(std::move(adjustment), factor) : std::move(adjustment);
  }
  for (WeightedLimb& weight : changed.weights) {
    weight = weight.clip == clip ? recounted(std::move(weight), factor) : std::move(weight);
  }
  return changed;
}

void setFramesPerSecond(Document& document, double framesPerSecond) {
  for (int clip = 0; clip < static_cast<int>(document.clips->size()); ++clip) {
    document = workAtRate(document, clip, framesPerSecond);
  }
}

void countInChosenRates(Document& document) {
  for (ClipRate& rate : document.rates) {
    rate.own = clipOf(document, rate.clip).framesPerSecond;
    setRate(document, rate.clip, rate.framesPerSecond);
  }
}

} // namespace stretch::app
