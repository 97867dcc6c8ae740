#include "app/weight/report.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/limb.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

std::vector<double> boneLengths(const rig::Limb& limb, const FrameState& frame) {
  const std::vector<Vec3> points = rig::limbPoints(limb, frame);
  std::vector<double> lengths;
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths.push_back(glm::length(points[i] - points[i - 1]));
  }
  return lengths;
}

// Factors that a limb and its bones reach in one frame.
struct Ratio {
  double frame = 0.0;
  double limb = 1.0;
  double farthestBone = 1.0; // from 1
};

Ratio ratioOf(double frame, const std::vector<double>& before, const std::vector<double>& after) {
  const double was = std::accumulate(before.begin(), before.end(), 0.0);
  Ratio ratio{frame, was > 0.0 ? std::accumulate(after.begin(), after.end(), 0.0) / was : 1.0, 1.0};
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double bone = before[i] > 0.0 ? after[i] / before[i] : 1.0;
    ratio.farthestBone =
        std::abs(bone - 1.0) > std::abs(ratio.farthestBone - 1.0) ? bone : ratio.farthestBone;
  }
  return ratio;
}

void note(const std::vector<Ratio>& ratios, WeightReport& report) {
  if (ratios.empty()) {
    return;
  }
  const auto byLimb = [](const Ratio& a, const Ratio& b) { return a.limb < b.limb; };
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end(), byLimb);
  report.shortest = least->limb;
  report.shortestFrame = least->frame;
  report.longest = most->limb;
  report.longestFrame = most->frame;
  const auto worst = std::max_element(ratios.begin(), ratios.end(), [](const Ratio& a, const Ratio& b) {
    return std::abs(a.farthestBone - 1.0) < std::abs(b.farthestBone - 1.0);
  });
  if (!report.held && std::abs(worst->farthestBone - 1.0) > skinning::largestSmallStrain) {
    report.warnings.push_back(
        fmt::format("{}: a bone is {:.3g} times its length at frame {:.4g}; past a change of {:g} the model "
                    "no longer holds: make it stiffer",
                    report.limb, worst->farthestBone, worst->frame, skinning::largestSmallStrain));
  }
}

// The weight that a report tells of, and what it came to frame by frame.
struct Measured {
  const rig::SolvedWeight* solved = nullptr;
  WeightReport* report = nullptr;
  std::vector<Ratio> ratios;
};

std::vector<Measured> measuredOf(const rig::MotionState& motion, std::vector<WeightReport>& reports) {
  std::vector<Measured> all;
  for (WeightReport& report : reports) {
    const auto solved = std::ranges::find_if(
        motion.weights, [&](const rig::SolvedWeight& one) { return one.limb.id == report.limb; });
    if (solved != motion.weights.end()) {
      all.push_back({&*solved, &report, {}});
    }
  }
  return all;
}

void measureAt(const WeightInput& input, const rig::MotionState& motion, double frame,
               std::vector<Measured>& all) {
  const double seconds = frame / input.clip->framesPerSecond;
  FrameState pose = rig::adjustedFrame(*input.scene, *input.clip, motion, seconds);
  std::vector<rig::HeldGoal> held = rig::applyTrailsAndHolds(*input.scene, motion, pose);
  std::vector<std::vector<double>> before;
  before.reserve(all.size());
  for (const Measured& one : all) {
    before.push_back(boneLengths(one.solved->limb, pose));
  }
  rig::applyAfterHolds(*input.scene, motion, held, pose);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const rig::LimbWeight& weight = all[i].solved->weight;
    constexpr double rounding = 1e-6;
    if (seconds >= weight.startSeconds - rounding && seconds <= weight.endSeconds + rounding) {
      all[i].ratios.push_back(ratioOf(frame, before[i], boneLengths(all[i].solved->limb, pose)));
    }
  }
}

} // namespace

void ReportWriter::add(double seconds, const std::vector<skinning::LimbStretch>& bones) {
  for (const skinning::LimbStretch& bone : bones) {
    judge(seconds * framesPerSecond_, bone.factors);
  }
}

void ReportWriter::finish() {
  if (flattest_ > skinning::largestSmallStrain) {
    report_.warnings.push_back(fmt::format(
        "{}: flattened by {:.3g} at frame {:.4g}{}; past {:g} the model no longer holds: make it stiffer",
        report_.limb, flattest_, flattestFrame_,
        flattest_ > skinning::largestCompression - 1e-6 ? ", which is the most allowed" : "",
        skinning::largestSmallStrain));
  }
  if (clampedFrame_ >= 0.0) {
    report_.held = true;
    report_.warnings.push_back(
        fmt::format("{}: the stretch along a bone is held at {:g} from frame {:.4g} on: make it stiffer",
                    report_.limb, clampedAt_, clampedFrame_));
  }
}

void ReportWriter::judge(double frame, const skinning::StretchFactors& factors) {
  const double flattened = 1.0 - factors.withLoad * std::sqrt(factors.along);
  if (flattened > flattest_) {
    flattest_ = flattened;
    flattestFrame_ = frame;
  }
  if ((factors.along <= 0.5 || factors.along >= 2.0) && clampedFrame_ < 0.0) {
    clampedFrame_ = frame;
    clampedAt_ = factors.along;
  }
}

void measureLengths(const WeightInput& input, const rig::MotionState& motion,
                    std::vector<WeightReport>& reports) {
  constexpr double fewestPerSecond = 24.0;
  constexpr double mostFrames = 100000.0;
  const Clip& clip = *input.clip;
  std::vector<Measured> all = measuredOf(motion, reports);
  const double perFrame = std::max(1.0, std::ceil(fewestPerSecond / clip.framesPerSecond));
  const double first = std::max(0.0, std::floor(clip.startSeconds * clip.framesPerSecond + 1e-6));
  const double last = std::min(endInFrames(clip), first + mostFrames);
  for (double step = 0.0; !all.empty() && first + step / perFrame <= last + frameTolerance; step += 1.0) {
    measureAt(input, motion, std::min(first + step / perFrame, last), all);
  }
  for (const Measured& one : all) {
    note(one.ratios, *one.report);
  }
}

} // namespace stretch::app
