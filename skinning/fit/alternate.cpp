#include "skinning/fit/alternate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <Eigen/Geometry>
#include <glm/geometric.hpp>

#include "skinning/fit/fit_state.h"
#include "skinning/fit/solve_bones.h"
#include "skinning/fit/solve_chain.h"

namespace stretch::skinning {
namespace {

using fit::BoneMatrix;
using fit::FitState;

/// Moves the mesh so that the bind pose's centre is the origin and its diagonal 1.
struct Frame {
  Vec3 centre{0.0};
  double scale = 1.0;

  [[nodiscard]] Eigen::Vector3d in(const Vec3& p) const {
    const Vec3 q = (p - centre) / scale;
    return {q.x, q.y, q.z};
  }
  [[nodiscard]] Vec3 out(const Eigen::Vector3d& q) const {
    return centre + scale * Vec3(q.x(), q.y(), q.z());
  }
};

Frame frameOf(const std::vector<glm::vec3>& positions) {
  Frame frame;
  for (const glm::vec3& p : positions) {
    frame.centre += Vec3(p) / static_cast<double>(positions.size());
  }
  const double diagonal = boxDiagonal(positions);
  frame.scale = diagonal > 0.0 ? diagonal : 1.0;
  return frame;
}

Eigen::Matrix3d toEigen(const Quat& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

Quat toQuat(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  return {q.w(), q.x(), q.y(), q.z()};
}

Eigen::Matrix3d stretchMatrix(const BonePose& pose) {
  const Eigen::Matrix3d axes = toEigen(pose.stretchAxes);
  return axes * Eigen::Vector3d(pose.scale.x, pose.scale.y, pose.scale.z).asDiagonal() * axes.transpose();
}

BoneMatrix toMatrix(const SkinBone& bone, const BonePose& pose, const Frame& frame) {
  BoneMatrix matrix;
  matrix.leftCols<3>() = toEigen(pose.rotation) * stretchMatrix(pose);
  matrix.col(3) = frame.in(pose.position) - matrix.leftCols<3>() * frame.in(bone.pivot);
  return matrix;
}

/// The state over the frames from `firstFrame` on, with the bone matrices of the poses where there are any.
FitState makeState(const MeshSequence& sequence, const SkinnedSequence& skinned, const Frame& frame,
                   std::size_t firstFrame) {
  FitState state;
  state.frameCount = sequence.frameCount() - firstFrame;
  state.boneCount = skinned.bones.size();
  state.influences = skinned.influences;
  for (const glm::vec3& p : skinned.bindPositions) {
    state.bind.push_back(frame.in(Vec3(p)));
  }
  for (const SkinBone& bone : skinned.bones) {
    state.axes.push_back(toEigen(bone.axes));
  }
  const auto frames = static_cast<Eigen::Index>(state.frameCount);
  state.observed.resize(3 * frames, static_cast<Eigen::Index>(sequence.vertexCount));
  for (std::size_t k = 0; k < state.frameCount; ++k) {
    const std::span<const glm::vec3> positions = sequence.frame(firstFrame + k);
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      const Eigen::Vector3d p = frame.in(Vec3(positions[v]));
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        state.observed(axis * frames + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) =
            static_cast<float>(p(axis));
      }
    }
  }
  state.matrices.assign(state.frameCount * state.boneCount, BoneMatrix::Identity());
  for (std::size_t i = 0; i < state.matrices.size() && !skinned.poses.empty(); ++i) {
    const std::size_t bone = i % state.boneCount;
    state.matrices[i] = toMatrix(skinned.bones[bone], skinned.poses[firstFrame * state.boneCount + i], frame);
  }
  return state;
}

/// Quaternions q and -q are one rotation: successive frames are put on one hemisphere, so that interpolation
/// goes the short way.
void alignHemispheres(SkinnedSequence& skinned) {
  const std::size_t bones = skinned.bones.size();
  for (std::size_t i = bones; i < skinned.poses.size(); ++i) {
    for (Quat BonePose::*which : {&BonePose::rotation, &BonePose::stretchAxes}) {
      Quat& q = skinned.poses[i].*which;
      q = glm::dot(q, skinned.poses[i - bones].*which) < 0.0 ? -q : q;
    }
  }
}

/// Rounds of `bones` and weights until the error settles.
template <typename FitBones>
void alternate(FitState& state, const FitSettings& settings, const Proceed& proceed, FitBones&& bones) {
  bones();
  double before = fit::rootMeanSquare(state);
  int idle = 0;
  for (int round = 0; round < settings.rounds && idle < 2; ++round) {
    if (settings.fitWeights) {
      fit::solveWeights(state, settings.candidates);
    }
    bones();
    const double error = fit::rootMeanSquare(state);
    idle = error > before * (1.0 - settings.leastGain) ? idle + 1 : 0;
    before = error;
    if (proceed && !proceed(static_cast<double>(round + 1) / settings.rounds)) {
      return;
    }
  }
}

std::vector<Eigen::Vector3d> scalesOf(const SkinnedSequence& skinned, std::size_t firstFrame,
                                      std::size_t count) {
  std::vector<Eigen::Vector3d> scales(count, Eigen::Vector3d::Ones());
  for (std::size_t i = 0; i < count && !skinned.poses.empty(); ++i) {
    const Vec3& s = skinned.poses[firstFrame * skinned.bones.size() + i].scale;
    scales[i] = {s.x, s.y, s.z};
  }
  return scales;
}

void writeFreePoses(const FitState& state, const std::vector<Eigen::Vector3d>& scales, const Frame& frame,
                    SkinnedSequence& skinned) {
  skinned.poses.resize(state.matrices.size());
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    const SkinBone& bone = skinned.bones[i % state.boneCount];
    const Eigen::Matrix3d& axes = state.axes[i % state.boneCount];
    const BoneMatrix& matrix = state.matrices[i];
    BonePose& pose = skinned.poses[i];
    const Eigen::Vector3d inverse = scales[i].cwiseInverse();
    pose.rotation = toQuat(matrix.leftCols<3>() * axes * inverse.asDiagonal() * axes.transpose());
    pose.scale = {scales[i].x(), scales[i].y(), scales[i].z()};
    pose.stretchAxes = bone.axes;
    pose.position = frame.out(matrix.leftCols<3>() * frame.in(bone.pivot) + matrix.col(3));
  }
}

fit::Chain makeChain(const SkinnedSequence& skinned, const Frame& frame) {
  fit::Chain chain;
  const std::size_t bones = skinned.bones.size();
  for (const SkinBone& bone : skinned.bones) {
    chain.pivots.push_back(frame.in(bone.pivot));
  }
  chain.pivots.push_back(frame.in(skinned.bones.back().end));
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    chain.stretches.push_back(stretchMatrix(skinned.poses[i]));
    chain.rotations.push_back(toEigen(skinned.poses[i].rotation));
    if (i % bones == 0) {
      chain.roots.push_back(frame.in(skinned.poses[i].position));
    }
  }
  return chain;
}

void writeChainedPoses(const FitState& state, const fit::Chain& chain, const Frame& frame,
                       SkinnedSequence& skinned) {
  for (std::size_t i = 0; i < skinned.poses.size(); ++i) {
    const SkinBone& bone = skinned.bones[i % state.boneCount];
    skinned.poses[i].rotation = toQuat(chain.rotations[i]);
    skinned.poses[i].position =
        frame.out(state.matrices[i].leftCols<3>() * frame.in(bone.pivot) + state.matrices[i].col(3));
  }
}

} // namespace

void fitFreeBones(const MeshSequence& sequence, SkinnedSequence& skinned, const FitSettings& settings,
                  const Proceed& proceed) {
  constexpr int sweeps = 3;
  constexpr int sweepsForPosesAlone = 12;
  const Frame frame = frameOf(skinned.bindPositions);
  const auto stretch = settings.fitStretch ? fit::StretchFit::free : fit::StretchFit::fixed;
  const std::size_t first = std::min(settings.firstWeightFrame, sequence.frameCount() - 1);
  if (settings.fitWeights) {
    FitState state = makeState(sequence, skinned, frame, first);
    auto scales = scalesOf(skinned, first, state.matrices.size());
    alternate(state, settings, proceed, [&] { fit::fitBones(state, scales, stretch, sweeps); });
    skinned.influences = state.influences;
    if (first == 0) {
      writeFreePoses(state, scales, frame, skinned);
      alignHemispheres(skinned);
      return;
    }
  }
  FitState state = makeState(sequence, skinned, frame, 0);
  auto scales = scalesOf(skinned, 0, state.matrices.size());
  fit::fitBones(state, scales, stretch, sweepsForPosesAlone);
  writeFreePoses(state, scales, frame, skinned);
  alignHemispheres(skinned);
}

void fitChainedBones(const MeshSequence& sequence, SkinnedSequence& skinned, RowHold hold) {
  constexpr int steps = 12;
  constexpr double loose = 0.5;
  constexpr double firm = 128.0; // A row that is an eighth too long turns a tenth more than the body.
  const Frame frame = frameOf(skinned.bindPositions);
  FitState state = makeState(sequence, skinned, frame, 0);
  fit::Chain chain = makeChain(skinned, frame);
  chain.hold = hold == RowHold::firm ? firm : loose;
  fit::fitChain(state, chain, steps);
  writeChainedPoses(state, chain, frame, skinned);
  alignHemispheres(skinned);
}

SkinnedSequence partsOfMesh(const MeshSequence& sequence, int boneCount) {
  SkinnedSequence skinned = withoutBones(sequence);
  const std::span<const glm::vec3> positions = sequence.frame(0);
  skinned.influences.resize(sequence.vertexCount);
  std::vector<double> nearest(sequence.vertexCount, std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  for (int b = 0; b < boneCount; ++b) {
    SkinBone bone;
    bone.pivot = bone.end = Vec3(positions[next]);
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      const Vec3 away = Vec3(positions[v]) - bone.pivot;
      if (glm::dot(away, away) < nearest[v]) {
        nearest[v] = glm::dot(away, away);
        skinned.influences[v].bones[0] = static_cast<std::uint16_t>(b);
        skinned.influences[v].weights[0] = 1.0F;
      }
    }
    skinned.bones.push_back(bone);
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  return skinned;
}

} // namespace stretch::skinning
