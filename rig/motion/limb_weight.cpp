#include "rig/motion/limb_weight.h"
#include "rig/limb.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/index.h"
#include "rig/ik/limb_shape.h"
#include "rig/motion/limb_deform.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

const Vec3 up(0.0, 1.0, 0.0);

double fadeAt(const LimbWeight& weight, double timeSeconds) {
  // Key times are stored in single precision: a time nearer than this to a border is at it.
  const double rounding = 1e-7 * std::max(1.0, std::abs(timeSeconds));
  if (timeSeconds < weight.startSeconds - rounding || timeSeconds > weight.endSeconds + rounding) {
    return 0.0;
  }
  const double in = weight.fadeInSeconds > 0.0
                        ? smoothstep((timeSeconds - weight.startSeconds) / weight.fadeInSeconds)
                        : 1.0;
  const double out = weight.fadeOutSeconds > 0.0
                         ? smoothstep((weight.endSeconds - timeSeconds) / weight.fadeOutSeconds)
                         : 1.0;
  return std::min(in, out);
}

WeightSample between(const WeightSample& a, const WeightSample& b, double timeSeconds) {
  const double length = b.timeSeconds - a.timeSeconds;
  const double t = length > 0.0 ? (timeSeconds - a.timeSeconds) / length : 0.0;
  WeightSample sample = a;
  sample.planted += t * (b.planted - a.planted);
  for (std::size_t i = 0; i < sample.strains.size(); ++i) {
    sample.strains[i] += (b.strains[i] - a.strains[i]) * t;
  }
  return sample;
}

bool isZero(const Mat3& matrix) {
  return matrix == Mat3(0.0);
}

// The part of a strain that has the bone as an axis: then K keeps the bone's direction, and K of a trail and
// this one are one symmetric matrix whichever comes first.
Mat3 alignedStretch(const Mat3& strain, const Vec3& unitAxis) {
  const Mat3 along = glm::outerProduct(unitAxis, unitAxis);
  const Mat3 across = Mat3(1.0) - along;
  return Mat3(1.0) + along * glm::dot(unitAxis, strain * unitAxis) + across * strain * across;
}

std::vector<Mat3> stretchesOf(const SolvedWeight& solved, const WeightSample& sample,
                              const FrameState& frame) {
  const std::vector<Vec3> points = limbPoints(solved.limb, frame);
  std::vector<Mat3> stretches;
  for (std::size_t i = 0; i < solved.limb.joints.size(); ++i) {
    const Mat4& world = frame.worlds[at(solved.limb.joints[i])];
    const Vec3 bone = points[i + 1] - points[i];
    const bool usable = glm::length(bone) > 0.0 && glm::determinant(Mat3(world)) != 0.0;
    stretches.push_back(
        usable ? alignedStretch(sample.strains[i], glm::normalize(transformVector(glm::inverse(world), bone)))
               : Mat3(1.0));
  }
  return stretches;
}

// A leg on its way through applyWeight.
struct Leg {
  const SolvedWeight* solved = nullptr;
  double planted = 0.0;
  Vec3 footBefore{0.0};
  Vec3 footMove{0.0}; // By its own strain alone.
};

void giveWay(const Scene& scene, const SolvedWeight& solved, const WeightSample& sample, FrameState& frame) {
  if (!std::all_of(sample.strains.begin(), sample.strains.end(), isZero)) {
    stretchLimb(scene, solved.limb, solved.topology, stretchesOf(solved, sample, frame), frame);
  }
}

// How far along +Y the hips move: what the legs that stand lost on average.
double hipsMove(const std::vector<Leg>& legs) {
  double lost = 0.0;
  double standing = 0.0;
  for (const Leg& leg : legs) {
    lost += leg.planted * glm::dot(leg.footMove, up);
    standing += leg.planted;
  }
  return standing > 0.0 ? -lost / standing * std::min(1.0, standing) : 0.0;
}

// Brings a leg onto its foot again, from wherever its hip went.
void putDown(const Scene& scene, const Leg& leg, FrameState& frame) {
  constexpr double shortestReachOfRest = 1e-3;
  LimbShapeProblem problem;
  problem.points = limbPoints(leg.solved->limb, frame);
  problem.target = leg.footBefore + (1.0 - leg.planted) * leg.footMove;
  problem.shortestReach = shortestReachOfRest * leg.solved->limb.restLength;
  problem.restLength = leg.solved->limb.restLength;
  if (glm::length(problem.target - problem.points.back()) <= 0.0) {
    return;
  }
  const LimbShape shape = solveLimbShape(problem);
  if (!shape.isIdentity()) {
    deformLimb(scene, leg.solved->limb, leg.solved->topology, shape, {}, frame);
  }
}

void moveHips(const Scene& scene, NodeIndex hips, double move, FrameState& frame) {
  if (!hips.exists() || move == 0.0) {
    return;
  }
  const Vec3 hipsWorld = positionOf(frame.worlds[at(hips)]) + move * up;
  moveNode(scene, hips, hipsWorld, frame);
}

} // namespace

WeightSample weightAt(const LimbWeight& weight, double timeSeconds) {
  const double fade = fadeAt(weight, timeSeconds);
  if (weight.samples.empty() || fade <= 0.0) {
    return {timeSeconds, {}, 0.0};
  }
  const auto after = std::lower_bound(
      weight.samples.begin(), weight.samples.end(), timeSeconds,
      [](const WeightSample& sample, double seconds) { return sample.timeSeconds < seconds; });
  WeightSample sample = weight.samples.back();
  if (after == weight.samples.begin()) {
    sample = weight.samples.front();
  } else if (after != weight.samples.end()) {
    sample = between(*(after - 1), *after, timeSeconds);
  }
  sample.timeSeconds = timeSeconds;
  for (Mat3& strain : sample.strains) {
    strain *= fade;
  }
  return sample;
}

void applyWeight(const Scene& scene, const std::vector<SolvedWeight>& weights, NodeIndex hips,
                 FrameState& frame) {
  std::vector<Leg> legs;
  for (const SolvedWeight& solved : weights) {
    const WeightSample sample = weightAt(solved.weight, frame.timeSeconds);
    const Vec3 before = endPosition(solved.limb, frame);
    giveWay(scene, solved, sample, frame);
    if (isLeg(solved.limb)) {
      legs.push_back({&solved, sample.planted, before, endPosition(solved.limb, frame) - before});
    }
  }
  moveHips(scene, hips, hipsMove(legs), frame);
  for (const Leg& leg : legs) {
    putDown(scene, leg, frame);
  }
}

} // namespace stretch::rig
