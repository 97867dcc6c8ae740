#include "app/recount.h"

#include <cmath>

namespace stretch::app {

namespace {

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

WeightedLimb recounted(WeightedLimb weight, double factor) {
  if (weight.settings.rangeFrames) {
    Vec2& range = *weight.settings.rangeFrames;
    range = {recounted(range.x, factor), recounted(range.y, factor)};
  }
  return weight;
}

} // namespace stretch::app
