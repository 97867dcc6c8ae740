#include "app/edits/keys/rate_edits.h"

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
double recountedFrame(double frame, double factor) {
  const double moved = frame * factor;
  const double whole = std::round(moved);
  return std::abs(moved - whole) < 1e-6 ? whole : moved;
}

void recountTime(rig::HoldTime& time, double factor) {
  time.rangeFrames = {recountedFrame(time.rangeFrames.x, factor), recountedFrame(time.rangeFrames.y, factor)};
  time.blendFrames = {recountedFrame(time.blendFrames.x, factor), recountedFrame(time.blendFrames.y, factor)};
}

void recountKeys(std::vector<rig::OffsetKey>& keys, double factor) {
  for (rig::OffsetKey& key : keys) {
    key.frame = recountedFrame(key.frame, factor);
    key.moveSlope /= factor; // Slopes are for each frame.
    key.turnSlope /= factor;
    key.valueSlope /= factor;
  }
}

template <typename OfClip>
void recountAll(std::vector<OfClip>& all, int clip, double factor) {
  for (OfClip& one : all) {
    one = one.clip == clip ? recounted(std::move(one), factor) : std::move(one);
  }
}

} // namespace

rig::Trail recounted(rig::Trail trail, double factor) {
  rig::TrailSettings& settings = trail.settings;
  settings.startFrame = recountedFrame(settings.startFrame, factor);
  settings.endFrame = recountedFrame(settings.endFrame, factor);
  if (settings.releaseFrames) {
    settings.releaseFrames = recountedFrame(*settings.releaseFrames, factor);
  }
  for (rig::SphereOffset& sphere : settings.spheres) {
    sphere.frame = recountedFrame(sphere.frame, factor);
    if (sphere.tangent) {
      *sphere.tangent /= factor; // A slope for each frame.
    }
  }
  for (double& frame : trail.controlFrames) {
    frame = recountedFrame(frame, factor);
  }
  return trail;
}

rig::Adjustment recounted(rig::Adjustment adjustment, double factor) {
  if (adjustment.rangeFrames) {
    Vec2& range = *adjustment.rangeFrames;
    range = {recountedFrame(range.x, factor), recountedFrame(range.y, factor)};
  }
  recountKeys(adjustment.keys, factor);
  return adjustment;
}

rig::Pin recounted(rig::Pin pin, double factor) {
  recountTime(pin.time, factor);
  pin.atFrame = recountedFrame(pin.atFrame, factor);
  return pin;
}

rig::Grip recounted(rig::Grip grip, double factor) {
  recountTime(grip.time, factor);
  if (grip.relationFrame) {
    grip.relationFrame = recountedFrame(*grip.relationFrame, factor);
  }
  return grip;
}

rig::Prop recounted(rig::Prop prop, double factor) {
  if (prop.time) {
    recountTime(*prop.time, factor);
  }
  if (prop.boundFrame) {
    prop.boundFrame = recountedFrame(*prop.boundFrame, factor);
  }
  for (rig::PropHand& hand : prop.hands) {
    recountKeys(hand.keys, factor);
  }
  return prop;
}

WeightedLimb recounted(WeightedLimb weight, double factor) {
  if (weight.settings.rangeFrames) {
    Vec2& range = *weight.settings.rangeFrames;
    range = {recountedFrame(range.x, factor), recountedFrame(range.y, factor)};
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
  recountAll(changed.trails, clip, factor);
  recountAll(changed.adjustments, clip, factor);
  recountAll(changed.holds.pins, clip, factor);
  recountAll(changed.holds.grips, clip, factor);
  recountAll(changed.holds.props, clip, factor);
  recountAll(changed.weights, clip, factor);
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
