#include "skinning/fit/sequence_state.h"

#include <span>

#include <Eigen/Geometry>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace stretch::skinning::fit {

MeshFrame frameOf(const std::vector<glm::vec3>& positions) {
  MeshFrame frame;
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

namespace {

BoneMatrix toMatrix(const SkinBone& bone, const BonePose& pose, const MeshFrame& frame) {
  BoneMatrix matrix;
  matrix.leftCols<3>() = toEigen(pose.rotation) * stretchMatrix(pose);
  matrix.col(3) = frame.in(pose.position) - matrix.leftCols<3>() * frame.in(bone.pivot);
  return matrix;
}

} // namespace

FitState makeState(const MeshSequence& sequence, const SkinnedSequence& skinned, const MeshFrame& frame,
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

void alignHemispheres(SkinnedSequence& skinned) {
  const std::size_t bones = skinned.bones.size();
  for (std::size_t i = bones; i < skinned.poses.size(); ++i) {
    for (Quat BonePose::*which : {&BonePose::rotation, &BonePose::stretchAxes}) {
      Quat& q = skinned.poses[i].*which;
      q = glm::dot(q, skinned.poses[i - bones].*which) < 0.0 ? -q : q;
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

void writeFreePoses(const FitState& state, const std::vector<Eigen::Vector3d>& scales, const MeshFrame& frame,
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

} // namespace stretch::skinning::fit
