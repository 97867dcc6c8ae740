#include "rig/trail/sphere_offsets.h"

#include <algorithm>
#include <cmath>

#include "core/anim/frames.h"

namespace stretch::rig {

namespace {

// Slope of the parabola through three neighbours; one-sided at the ends.
Vec3 neighbourSlope(const std::vector<double>& x, const std::vector<Vec3>& y, std::size_t i) {
  const std::size_t last = x.size() - 1;
  if (i == 0) {
    return (y[1] - y[0]) / (x[1] - x[0]);
  }
  if (i == last) {
    return (y[last] - y[last - 1]) / (x[last] - x[last - 1]);
  }
  const double h0 = x[i] - x[i - 1];
  const double h1 = x[i + 1] - x[i];
  return ((y[i] - y[i - 1]) / h0 * h1 + (y[i + 1] - y[i]) / h1 * h0) / (h0 + h1);
}

std::vector<double> mergedFrames(const std::vector<double>& controlFrames,
                                 const std::vector<SphereOffset>& pulled) {
  std::vector<double> frames = controlFrames;
  for (const SphereOffset& sphere : pulled) {
    frames.push_back(sphere.frame);
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end(), sameFrame), frames.end());
  return frames;
}

} // namespace

SphereOffsets::SphereOffsets(const std::vector<double>& controlFrames,
                             const std::vector<SphereOffset>& pulled) {
  if (pulled.empty()) {
    return;
  }
  frames_ = mergedFrames(controlFrames, pulled);
  values_.assign(frames_.size(), Vec3(0.0));
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    for (const SphereOffset& sphere : pulled) {
      if (sameFrame(sphere.frame, frames_[i])) {
        values_[i] = sphere.offset;
      }
    }
  }
  slopes_.assign(frames_.size(), Vec3(0.0));
  for (std::size_t i = 0; i < frames_.size() && frames_.size() > 1; ++i) {
    slopes_[i] = neighbourSlope(frames_, values_, i);
  }
  for (const SphereOffset& sphere : pulled) {
    if (sphere.tangent) {
      const auto place = std::lower_bound(frames_.begin(), frames_.end(), sphere.frame - frameTolerance);
      slopes_[static_cast<std::size_t>(place - frames_.begin())] = *sphere.tangent;
    }
  }
}

Vec3 SphereOffsets::at(double frame) const {
  if (frames_.empty()) {
    return Vec3(0.0);
  }
  if (frame <= frames_.front()) {
    return values_.front();
  }
  if (frame >= frames_.back()) {
    return values_.back();
  }
  const auto next = std::upper_bound(frames_.begin(), frames_.end(), frame);
  const auto i = static_cast<std::size_t>(next - frames_.begin()) - 1;
  const double h = frames_[i + 1] - frames_[i];
  const double t = (frame - frames_[i]) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return values_[i] * (2 * t3 - 3 * t2 + 1) + slopes_[i] * (h * (t3 - 2 * t2 + t)) +
         values_[i + 1] * (3 * t2 - 2 * t3) + slopes_[i + 1] * (h * (t3 - t2));
}

Vec3 SphereOffsets::slopeAt(double frame) const {
  if (frames_.empty() || frame < frames_.front() - frameTolerance ||
      frame > frames_.back() + frameTolerance) {
    return Vec3(0.0);
  }
  const auto next = std::upper_bound(frames_.begin(), frames_.end(), frame + frameTolerance);
  const auto i = static_cast<std::size_t>(next - frames_.begin()) - 1;
  if (next == frames_.end()) {
    return slopes_.back();
  }
  const double h = frames_[i + 1] - frames_[i];
  const double t = std::max(0.0, (frame - frames_[i]) / h);
  return (values_[i + 1] - values_[i]) * (6.0 * t * (1.0 - t) / h) +
         slopes_[i] * ((1.0 - t) * (1.0 - 3.0 * t)) + slopes_[i + 1] * (t * (3.0 * t - 2.0));
}

} // namespace stretch::rig
