#include "skinning/compress/body_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/polyline.h"
#include "core/math/rotation.h"

namespace stretch::skinning {
namespace {

Vec3 axisOf(const BodyMotion& body, std::size_t segment) {
  const Vec3 along = body.skeleton.joints[segment + 1] - body.skeleton.joints[segment];
  const double length = glm::length(along);
  return length > 0.0 ? along / length : Vec3(1.0, 0.0, 0.0);
}

/// Gravity as the segment's bind pose sees it in a frame, its part across the axis.
Vec3 loadAcross(const BodyMotion& body, const Vec3& gravity, std::size_t frame, std::size_t segment) {
  const Vec3 seen = glm::conjugate(body.motion(frame, segment).rotation) * gravity;
  const Vec3 axis = axisOf(body, segment);
  return seen - glm::dot(seen, axis) * axis;
}

/// The numbers that the fit of the parameters turns: specific compliance and how far volume is kept.
struct Parameters {
  double compliance = 0.0; ///< 1 / E; 0: gravity has no effect.
  double gravityVolume = 1.0;
  double muscleVolume = 1.0;
};

/// One measured cross-section: what the model has to explain.
struct Sample {
  double loading = 0.0; ///< q for a compliance of 1, or q itself where the segment has a modulus of its own.
  bool ownModulus = false;
  double along = 1.0; ///< Length over rest length, by the length function.
  double withLoad = 1.0;
  double sideways = 1.0;
  double weight = 1.0;
};

double misfit(const std::vector<Sample>& samples, const Parameters& p) {
  double sum = 0.0;
  for (const Sample& s : samples) {
    const double q = std::clamp(s.ownModulus ? s.loading : p.compliance * s.loading, 0.0, largestCompression);
    const StretchFactors factors = combine(q, s.along, p.gravityVolume, p.muscleVolume);
    const double down = factors.withLoad - s.withLoad;
    const double side = factors.sideways - s.sideways;
    sum += s.weight * (down * down + side * side);
  }
  return sum;
}

/// Least point of a function of one number between two limits, by golden sections.
template <typename Function>
double minimise(double low, double high, Function&& f) {
  constexpr double golden = 0.61803398874989485;
  for (int i = 0; i < 40; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    (f(a) <= f(b) ? high : low) = f(a) <= f(b) ? b : a;
  }
  return 0.5 * (low + high);
}

Parameters fitParameters(const std::vector<Sample>& samples, Parameters p, const std::array<bool, 3>& open,
                         double largestLoading) {
  const double highest = largestLoading > 0.0 ? largestCompression / largestLoading : 0.0;
  const auto descend = [&](double Parameters::*which, double high) {
    p.*which = minimise(0.0, high, [&](double value) {
      Parameters tried = p;
      tried.*which = value;
      return misfit(samples, tried);
    });
  };
  for (int round = 0; round < 8; ++round) {
    if (open[2]) {
      descend(&Parameters::muscleVolume, 1.0);
    }
    if (open[0] && highest > 0.0) {
      descend(&Parameters::compliance, highest);
    }
    if (open[1]) {
      descend(&Parameters::gravityVolume, 1.0);
    }
  }
  return p;
}

class BodyModel {
public:
  BodyModel(const BodyMotion& body, const BodyStretchSettings& settings)
      : body_(body), settings_(settings), moduli_(settings.moduli) {
    moduli_.youngModulus.reset(); // Of the body as a whole: a parameter of the fit, or what it is given.
    double volume = 0.0;
    for (const double v : body.volumes) {
      volume += v;
    }
    constexpr double waterDensity = 1000.0;
    mass_ = settings.mass.value_or(waterDensity * volume * std::pow(settings.metresPerUnit, 3.0));
    density_ = volume > 0.0 ? mass_ / volume : 0.0;
  }

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] bool hasOwnModulus(std::size_t segment) const { return moduli_.at(segment, 0.0) > 0.0; }

  /// q of a segment that is as stiff as `modulus`, or as its own modulus where the settings name one.
  [[nodiscard]] double loading(std::size_t segment, double acceleration, double modulus) const {
    const double unit = settings_.metresPerUnit;
    const Cylinder cylinder{body_.skeleton.length / static_cast<double>(body_.segmentCount()) * unit,
                            body_.widths[segment] * unit, density_ * body_.volumes[segment],
                            moduli_.at(segment, modulus)};
    return cylinder.width > 0.0 ? gravityDisplacement(cylinder, acceleration) / cylinder.width : 0.0;
  }

private:
  const BodyMotion& body_;
  const BodyStretchSettings& settings_;
  SegmentModuli moduli_;
  double mass_ = 0.0;
  double density_ = 0.0;
};

std::vector<Sample> samplesOf(const BodyMotion& body, const BodyStretchSettings& settings,
                              const BodyStretch& result, const BodyModel& model) {
  constexpr std::size_t mostSamples = 4000;
  const std::size_t frames = body.joints.size();
  const std::size_t used = frames - std::min(settings.firstFittedFrame, frames - 1);
  const std::size_t stride = std::max<std::size_t>(1, used * body.segmentCount() / mostSamples);
  std::vector<Sample> samples;
  for (std::size_t k = frames - used; k < frames; k += stride) {
    for (std::size_t s = 0; s < body.segmentCount(); ++s) {
      const std::size_t i = k * body.segmentCount() + s;
      const Vec3 down = result.loadDirections[i];
      const Vec3 side = glm::cross(axisOf(body, s), down);
      const Mat3& stretch = body.segments[i].stretch;
      Sample sample;
      sample.loading = model.loading(s, glm::length(loadAcross(body, settings.gravity, k, s)), 1.0);
      sample.ownModulus = model.hasOwnModulus(s);
      sample.along = result.factors[i].along;
      sample.withLoad = glm::dot(down, stretch * down);
      sample.sideways = glm::dot(side, stretch * side);
      sample.weight = body.volumes[s];
      samples.push_back(sample);
    }
  }
  return samples;
}

void measureLength(const BodyMotion& body, const BodyStretchSettings& settings, BodyStretch& result) {
  for (const auto& joints : body.joints) {
    result.measured.push_back({totalCurvature(joints), polylineLength(joints)});
  }
  result.restLength = result.measured.front().length;
  const std::size_t first = std::min(settings.firstFittedFrame, result.measured.size() - 1);
  std::vector<CurvatureLength> used;
  for (std::size_t k = first; k < result.measured.size(); ++k) {
    used.push_back(result.measured[k]);
  }
  result.length = fitLength(used, settings.lengthModel);
  if (!result.length.remark.empty()) {
    result.warnings.push_back(result.length.remark);
  }
  constexpr double shortest = 0.5;
  constexpr double longest = 2.0;
  result.factors.assign(body.segments.size(), StretchFactors{});
  // The first frame is the bind pose: as long as it is, whatever the curve says of it.
  for (std::size_t i = body.segmentCount(); i < result.factors.size(); ++i) {
    const double curvature = result.measured[i / body.segmentCount()].curvatureRadians;
    result.factors[i].along = std::clamp(result.length.at(curvature) / result.restLength, shortest, longest);
  }
}

/// q of every segment and frame. A load that hardly changes counts with its mean over the fitted frames: soft
/// bodies do not follow each tremor, and what is constant need not be stored.
std::vector<double> compressionsOf(const BodyMotion& body, const BodyStretchSettings& settings,
                                   const BodyModel& model, double modulus, BodyStretch& result) {
  constexpr double steadyWithin = 0.005;
  const std::size_t frames = body.joints.size();
  const std::size_t segments = body.segmentCount();
  const std::size_t first = std::min(settings.firstFittedFrame, frames - 1);
  std::vector<double> q(frames * segments);
  result.compressions.assign(segments, 0.0);
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double acceleration = glm::length(loadAcross(body, settings.gravity, i / segments, i % segments));
    q[i] = std::min(model.loading(i % segments, acceleration, modulus), largestCompression);
    result.compressions[i % segments] +=
        i / segments >= first ? q[i] / static_cast<double>(frames - first) : 0.0;
  }
  double change = 0.0;
  for (std::size_t i = first * segments; i < q.size(); ++i) {
    change = std::max(change, std::abs(q[i] - result.compressions[i % segments]));
  }
  for (std::size_t i = 0; i < q.size() && change < steadyWithin && !result.loadTurns; ++i) {
    q[i] = result.compressions[i % segments];
  }
  return q;
}

void applyGravity(const BodyMotion& body, const BodyStretchSettings& settings, const BodyModel& model,
                  const Parameters& p, BodyStretch& result) {
  const double modulus = p.compliance > 0.0 ? 1.0 / p.compliance : 0.0;
  const std::vector<double> q = compressionsOf(body, settings, model, modulus, result);
  for (std::size_t i = 0; i < q.size(); ++i) {
    result.factors[i] = combine(q[i], result.factors[i].along, p.gravityVolume, p.muscleVolume);
  }
  const double largest = *std::max_element(q.begin(), q.end());
  if (largest > largestSmallStrain) {
    result.warnings.push_back(
        fmt::format("gravity compresses a segment by {:.2f}: past {:.1f} the model's small "
                    "deformations no longer hold",
                    largest, largestSmallStrain));
  }
}

bool usable(const std::optional<double>& value) {
  return !value || (std::isfinite(*value) && *value > 0.0);
}

} // namespace

BodyStretch loadOfBody(const BodyMotion& body, const Vec3& gravity) {
  BodyStretch result;
  const std::size_t frames = body.joints.size();
  result.loadDirections.assign(body.segments.size(), Vec3(0.0));
  for (std::size_t s = 0; s < body.segmentCount(); ++s) {
    Vec3 sum(0.0);
    double size = 0.0;
    for (std::size_t k = 0; k < frames; ++k) {
      sum += loadAcross(body, gravity, k, s);
      size += glm::length(loadAcross(body, gravity, k, s));
    }
    const Vec3 axis = axisOf(body, s);
    // A load that keeps pointing the same way adds up; one that turns cancels itself out.
    constexpr double steady = 0.9;
    result.loadTurns = result.loadTurns || (size > 0.0 && glm::length(sum) < steady * size);
    const Vec3 mean =
        glm::length(sum) > 1e-9 * size && size > 0.0 ? glm::normalize(sum) : anyPerpendicular(axis);
    result.loadAxes.push_back(-mean);
  }
  for (std::size_t i = 0; i < result.loadDirections.size(); ++i) {
    const std::size_t segment = i % body.segmentCount();
    const Vec3 across = loadAcross(body, gravity, i / body.segmentCount(), segment);
    const bool turned = result.loadTurns && glm::length(across) > 1e-6 * glm::length(gravity);
    result.loadDirections[i] = turned ? -glm::normalize(across) : result.loadAxes[segment];
  }
  return result;
}

Result<BodyStretch> stretchOfBody(const BodyMotion& body, const BodyStretchSettings& settings) {
  if (!usable(settings.youngModulus) || !usable(settings.mass) || !(settings.metresPerUnit > 0.0)) {
    return Error{"Young's modulus, mass and scale must be positive numbers", "",
                 "leave them out to have them fitted"};
  }
  BodyStretch result = loadOfBody(body, settings.gravity);
  measureLength(body, settings, result);
  const BodyModel model(body, settings);
  const std::vector<Sample> samples = samplesOf(body, settings, result, model);
  double largestLoading = 0.0;
  for (const Sample& sample : samples) {
    largestLoading = std::max(largestLoading, sample.ownModulus ? 0.0 : sample.loading);
  }
  const std::optional<double> given =
      settings.youngModulus ? settings.youngModulus : settings.moduli.youngModulus;
  const Parameters start{given ? 1.0 / *given : 0.0, settings.gravityVolume.value_or(1.0),
                         settings.muscleVolume.value_or(1.0)};
  const Parameters fitted = fitParameters(
      samples, start, {!given, !settings.gravityVolume, !settings.muscleVolume}, largestLoading);
  result.mass = model.mass();
  result.modulusFitted = !given;
  result.youngModulus = fitted.compliance > 0.0 && largestLoading > 0.0 ? 1.0 / fitted.compliance : 0.0;
  result.gravityVolume = fitted.gravityVolume;
  result.muscleVolume = fitted.muscleVolume;
  applyGravity(body, settings, model, fitted, result);
  return result;
}

} // namespace stretch::skinning
