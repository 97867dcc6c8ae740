#include "skinning/elastic/limb_elasticity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/finite.h"
#include "core/math/rotation.h"

namespace stretch::skinning {
namespace {

using Path = std::vector<Vec3>;

/// The path a little beyond its ends goes on straight, so that it neither starts nor stops with a jolt.
Vec3 extended(const Path& path, std::ptrdiff_t frame) {
  const auto last = static_cast<std::ptrdiff_t>(path.size()) - 1;
  const auto at = [&](std::ptrdiff_t i) {
    return path[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  };
  if (frame < 0) {
    return at(0) + static_cast<double>(-frame) * (at(0) - at(1));
  }
  if (frame > last) {
    return at(last) + static_cast<double>(frame - last) * (at(last) - at(last - 1));
  }
  return at(frame);
}

/// Weights of the frames around one that smooth a path, the frame itself in the middle. Single keys that are
/// a hair off would otherwise shake the limb. The second difference smooths too, by a sixth of a frame's
/// variance: what is left for the weights makes the two together last as long at every frame rate.
std::vector<double> smoothingWeights(double framesPerSecond) {
  constexpr double smoothedSeconds = 0.0423; // standard deviation of the two together
  constexpr double ofSecondDifference = 1.0 / 6.0;
  constexpr double least = 0.1;
  const double frames = smoothedSeconds * framesPerSecond;
  const double variance = std::max(least, frames * frames - ofSecondDifference);
  const auto reach = static_cast<int>(std::ceil(3.5 * std::sqrt(variance)));
  std::vector<double> weights;
  for (int d = -reach; d <= reach; ++d) {
    weights.push_back(std::exp(-0.5 * d * d / variance));
  }
  return weights;
}

/// Second derivative of the path, smoothed.
Path accelerationOf(const Path& path, double framesPerSecond) {
  const std::vector<double> weights = smoothingWeights(framesPerSecond);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto reach = static_cast<std::ptrdiff_t>(weights.size() / 2);
  Path smooth;
  for (std::ptrdiff_t k = -1; k <= static_cast<std::ptrdiff_t>(path.size()); ++k) {
    Vec3 sum(0.0);
    for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
      sum += weights[static_cast<std::size_t>(d + reach)] * extended(path, k + d);
    }
    smooth.push_back(sum / total);
  }
  Path acceleration;
  for (std::size_t k = 1; k + 1 < smooth.size(); ++k) {
    acceleration.push_back((smooth[k + 1] - 2.0 * smooth[k] + smooth[k - 1]) *
                           (framesPerSecond * framesPerSecond));
  }
  return acceleration;
}

/// The load after a damped spring that starts at rest under the first one. Exact for a load that is constant
/// between frames would need cases by damping; small implicit steps are stable for all of them.
Path throughSpring(const Path& load, double framesPerSecond, const LimbElasticity& settings) {
  constexpr double baseFrequencyHz = 6.0;
  constexpr double stepsPerSecond = 1920.0;
  const auto stepsPerFrame = std::max(1, static_cast<int>(std::ceil(stepsPerSecond / framesPerSecond)));
  const double omega = 2.0 * pi * baseFrequencyHz * std::sqrt(settings.stiffness);
  const double dt = 1.0 / (framesPerSecond * stepsPerFrame);
  Path result;
  Vec3 value = load.front();
  Vec3 velocity(0.0);
  for (std::size_t k = 0; k < load.size(); ++k) {
    for (int step = 1; step <= stepsPerFrame && k > 0; ++step) {
      const Vec3 target = load[k - 1] + (load[k] - load[k - 1]) * (static_cast<double>(step) / stepsPerFrame);
      velocity = (velocity + dt * omega * omega * (target - value)) /
                 (1.0 + 2.0 * settings.damping * omega * dt + omega * omega * dt * dt);
      value += dt * velocity;
    }
    result.push_back(value);
  }
  return result;
}

/// Gravity less the acceleration of a path, through the spring.
Path loadOn(const Path& path, double framesPerSecond, const LimbElasticity& settings) {
  Path load = accelerationOf(path, framesPerSecond);
  for (Vec3& value : load) {
    value = settings.gravity - settings.inertia * value;
  }
  return throughSpring(load, framesPerSecond, settings);
}

/// The limb with its loads, ready to be asked frame by frame.
class LoadedLimb {
public:
  LoadedLimb(const std::vector<LimbSegment>& segments, const LimbMotion& motion,
             const LimbElasticity& settings)
      : segments_(segments), motion_(motion), settings_(settings) {
    Path base;
    for (const auto& joints : motion.joints) {
      base.push_back(joints.front());
    }
    baseLoad_ = loadOn(base, motion.framesPerSecond, settings);
    for (std::size_t s = 0; s < segments.size(); ++s) {
      Path middle;
      for (const auto& joints : motion.joints) {
        middle.push_back(0.5 * (joints[s] + joints[s + 1]));
      }
      loads_.push_back(loadOn(middle, motion.framesPerSecond, settings));
    }
  }

  [[nodiscard]] LimbStretch at(std::size_t frame, std::size_t segment) const {
    LimbStretch stretch;
    const Vec3 bone = motion_.joints[frame][segment + 1] - motion_.joints[frame][segment];
    const double length = glm::length(bone);
    stretch.along = length > 0.0 ? bone / length : stretch.along;
    const double modulus = settings_.moduli.at(segment, settings_.youngModulus) * settings_.stiffness;
    const LimbSegment& shape = segments_[segment];
    const double axial = axialScale(settings_.amount * axialForce(frame, segment, stretch.along), modulus,
                                    shape.volume, shape.length);
    const Vec3 load = loads_[segment][frame];
    const Vec3 across = load - glm::dot(load, stretch.along) * stretch.along;
    const double size = glm::length(across);
    stretch.withLoad = size > 1e-9 ? across / size : anyPerpendicular(stretch.along);
    const double q =
        settings_.amount * compressionFactor({shape.length, shape.width, massOf(segment), modulus}, size);
    stretch.factors = combine(q, axial);
    return stretch;
  }

private:
  [[nodiscard]] double massOf(std::size_t segment) const {
    return settings_.density * segments_[segment].volume;
  }

  /// Force along the segment, positive when it pulls.
  [[nodiscard]] double axialForce(std::size_t frame, std::size_t segment, const Vec3& along) const {
    const double own = 0.5 * massOf(segment) * glm::dot(loads_[segment][frame], along);
    double hanging = own;
    for (std::size_t s = segment + 1; s < segments_.size(); ++s) {
      hanging += massOf(s) * glm::dot(loads_[s][frame], along);
    }
    const double planted = motion_.planted.empty() ? 0.0 : motion_.planted[frame];
    const double carried = motion_.carriedMass.empty() ? 0.0 : motion_.carriedMass[frame];
    double standing = own + carried * glm::dot(baseLoad_[frame], along);
    for (std::size_t s = 0; s < segment; ++s) {
      standing += massOf(s) * glm::dot(loads_[s][frame], along);
    }
    return (1.0 - planted) * hanging - planted * standing;
  }

  const std::vector<LimbSegment>& segments_;
  const LimbMotion& motion_;
  const LimbElasticity& settings_;
  Path baseLoad_;
  std::vector<Path> loads_;
};

/// Seconds between the two frames by which the speed of an end is measured.
constexpr double speedSeconds = 1.0 / 30.0;

std::ptrdiff_t framesOf(double seconds, double framesPerSecond, std::ptrdiff_t fewest) {
  return std::max(fewest, static_cast<std::ptrdiff_t>(std::lround(seconds * framesPerSecond)));
}

std::vector<bool> lowFrames(const std::vector<Vec3>& end, double limbLength, const Vec3& up,
                            const PlantedSettings& settings) {
  double lowest = end.empty() ? 0.0 : glm::dot(end.front(), up);
  for (const Vec3& position : end) {
    lowest = std::min(lowest, glm::dot(position, up));
  }
  lowest = settings.ground.value_or(lowest);
  std::vector<bool> low;
  low.reserve(end.size());
  for (const Vec3& position : end) {
    low.push_back(glm::dot(position, up) - lowest <= settings.height * limbLength);
  }
  return low;
}

/// Means over as many frames before as after each.
std::vector<double> meanAround(const std::vector<double>& values, std::ptrdiff_t reach) {
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  std::vector<double> means;
  for (std::ptrdiff_t k = 0; k <= last; ++k) {
    double sum = 0.0;
    for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
      sum += values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k + d, 0, last))];
    }
    means.push_back(sum / static_cast<double>(2 * reach + 1));
  }
  return means;
}

Status checkMotion(const std::vector<LimbSegment>& segments, const LimbMotion& motion) {
  const std::size_t frames = motion.joints.size();
  const bool listsFit = (motion.planted.empty() || motion.planted.size() == frames) &&
                        (motion.carriedMass.empty() || motion.carriedMass.size() == frames);
  if (segments.empty() || frames == 0 || !listsFit || !(motion.framesPerSecond > 0.0)) {
    return Error{"the limb has no segments, no frames, or lists of different lengths", "limb",
                 "give one value for each frame"};
  }
  for (std::size_t k = 0; k < frames; ++k) {
    const auto& joints = motion.joints[k];
    if (joints.size() != segments.size() + 1 ||
        !std::all_of(joints.begin(), joints.end(), [](const Vec3& joint) { return isFinite(joint); })) {
      return Error{fmt::format("{} finite joints are needed", segments.size() + 1),
                   fmt::format("limb, frame {}", k), "give one joint more than segments"};
    }
  }
  return Success{};
}

Status checkSettings(const LimbElasticity& s) {
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  constexpr double largest = 1e30;
  if (!within(s.youngModulus, 1e-12, largest) || !within(s.density, 0.0, largest) ||
      !within(s.stiffness, 1e-3, 1e6)) {
    return Error{"Young's modulus, density and stiffness must be positive", "elastic",
                 "use the defaults as a start"};
  }
  if (!within(s.inertia, 0.0, 1.0) || !within(s.amount, 0.0, 1.0) || !within(s.damping, 0.0, 100.0) ||
      !isFinite(s.gravity)) {
    return Error{"inertia and amount lie in 0..1, damping is not negative", "elastic",
                 "use the defaults as a start"};
  }
  return Success{};
}

} // namespace

std::vector<LimbSegment> limbSegments(const std::vector<double>& lengths, const std::vector<double>& widths) {
  check(lengths.size() == widths.size(), "a limb has one width for each segment");
  std::vector<LimbSegment> segments;
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    segments.push_back({lengths[s], widths[s], 0.25 * pi * widths[s] * widths[s] * lengths[s]});
  }
  return segments;
}

Result<std::vector<std::vector<LimbStretch>>> limbElasticity(const std::vector<LimbSegment>& segments,
                                                             const LimbMotion& motion,
                                                             const LimbElasticity& settings) {
  const auto motionFits = checkMotion(segments, motion);
  const auto settingsFit = checkSettings(settings);
  if (!motionFits || !settingsFit) {
    return motionFits ? settingsFit.error() : motionFits.error();
  }
  const LoadedLimb limb(segments, motion, settings);
  std::vector<std::vector<LimbStretch>> frames(motion.joints.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    for (std::size_t s = 0; s < segments.size(); ++s) {
      frames[k].push_back(limb.at(k, s));
    }
  }
  return frames;
}

std::vector<double> plantedWeights(const std::vector<Vec3>& end, double framesPerSecond, double limbLength,
                                   const Vec3& up, const PlantedSettings& settings) {
  const auto frames = static_cast<std::ptrdiff_t>(end.size());
  const std::vector<bool> low = lowFrames(end, limbLength, up, settings);
  const std::ptrdiff_t step = framesOf(speedSeconds, framesPerSecond, 1);
  std::vector<double> stands;
  for (std::ptrdiff_t k = 0; k < frames; ++k) {
    const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(k - step, 0));
    const auto after = static_cast<std::size_t>(std::min(k + step, frames - 1));
    const double seconds = static_cast<double>(std::max<std::size_t>(after - before, 1)) / framesPerSecond;
    const bool slow = glm::length(end[after] - end[before]) / seconds <= settings.speed * limbLength;
    stands.push_back(slow && low[static_cast<std::size_t>(k)] ? 1.0 : 0.0);
  }
  return meanAround(stands, framesOf(settings.fadeSeconds, framesPerSecond, 0));
}

std::vector<double> touchingWeights(const std::vector<Vec3>& end, double framesPerSecond, double limbLength,
                                    const Vec3& up, const PlantedSettings& settings) {
  const std::vector<bool> low = lowFrames(end, limbLength, up, settings);
  const auto frames = static_cast<std::ptrdiff_t>(end.size());
  const std::ptrdiff_t fade = framesOf(settings.fadeSeconds, framesPerSecond, 0);
  std::vector<double> near(end.size(), 0.0);
  for (std::ptrdiff_t k = 0; k < frames; ++k) {
    for (std::ptrdiff_t d = -fade; d <= fade && low[static_cast<std::size_t>(k)]; ++d) {
      near[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k + d, 0, frames - 1))] = 1.0;
    }
  }
  return meanAround(near, fade);
}

std::vector<std::vector<double>> sharedMass(const std::vector<std::vector<double>>& planted,
                                            double bodyMass) {
  std::vector<std::vector<double>> masses = planted;
  for (std::size_t k = 0; !planted.empty() && k < planted.front().size(); ++k) {
    double sum = 0.0;
    for (const auto& weights : planted) {
      sum += weights[k];
    }
    for (auto& limb : masses) {
      limb[k] = sum > 0.0 ? bodyMass * limb[k] / sum : 0.0;
    }
  }
  return masses;
}

} // namespace stretch::skinning
