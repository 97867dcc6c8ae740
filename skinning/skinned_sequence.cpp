#include "skinning/skinned_sequence.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

namespace stretch::skinning {

std::string nameOfBone(const SkinnedSequence& sequence, std::size_t bone) {
  const std::string& name = sequence.bones[bone].name;
  return name.empty() ? "bone_" + std::to_string(bone) : name;
}

ScaleRange scaleRangeOf(const SkinnedSequence& sequence, std::size_t bone) {
  ScaleRange range;
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    const Vec3& scale = sequence.pose(k, bone).scale;
    const auto [least, most] = std::minmax({scale.x, scale.y, scale.z});
    if (least < range.least) {
      range.least = least;
      range.leastFrame = k;
    }
    if (most > range.most) {
      range.most = most;
      range.mostFrame = k;
    }
  }
  return range;
}

Mat4 skinMatrix(const SkinBone& bone, const BonePose& pose) {
  const Mat3 axes = glm::mat3_cast(pose.stretchAxes);
  const Mat3 scaled(axes[0] * pose.scale.x, axes[1] * pose.scale.y, axes[2] * pose.scale.z);
  const Mat3 linear = glm::mat3_cast(pose.rotation) * scaled * glm::transpose(axes);
  Mat4 matrix(linear);
  matrix[3] = Vec4(pose.position - linear * bone.pivot, 1.0);
  return matrix;
}

void skinFrame(const SkinnedSequence& sequence, std::size_t frame, std::span<glm::vec3> out) {
  std::vector<Mat4> matrices;
  matrices.reserve(sequence.bones.size());
  for (std::size_t b = 0; b < sequence.bones.size(); ++b) {
    matrices.push_back(skinMatrix(sequence.bones[b], sequence.pose(frame, b)));
  }
  for (std::size_t v = 0; v < sequence.bindPositions.size(); ++v) {
    const Vec4 bind(Vec3(sequence.bindPositions[v]), 1.0);
    const Influences& influences = sequence.influences[v];
    Vec3 posed(0.0);
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      if (influences.weights[i] != 0.0F) {
        posed += static_cast<double>(influences.weights[i]) * Vec3(matrices[influences.bones[i]] * bind);
      }
    }
    out[v] = glm::vec3(posed);
  }
}

SkinnedSequence withoutBones(const MeshSequence& sequence) {
  SkinnedSequence skinned;
  const std::span<const glm::vec3> bind = sequence.frame(0);
  skinned.name = sequence.name;
  skinned.clipName = sequence.clipName;
  skinned.bindPositions.assign(bind.begin(), bind.end());
  skinned.triangles = sequence.triangles;
  skinned.framesPerSecond = sequence.framesPerSecond;
  skinned.surface = sequence.surface;
  return skinned;
}

MeshSequence skinAllFrames(const SkinnedSequence& sequence) {
  MeshSequence result;
  result.name = sequence.name;
  result.vertexCount = sequence.bindPositions.size();
  result.triangles = sequence.triangles;
  result.framesPerSecond = sequence.framesPerSecond;
  result.positions.resize(result.vertexCount * sequence.frameCount());
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    skinFrame(sequence, k, result.frame(k));
    result.frameNames.push_back("frame " + std::to_string(k));
  }
  return result;
}

} // namespace stretch::skinning
