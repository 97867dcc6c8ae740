#include "skinning/fit/motion_clusters.h"

#include <algorithm>

#include "skinning/fit/sequence_state.h"
#include "skinning/fit/split_part.h"

namespace stretch::skinning {
namespace {

using fit::BoneMatrix;
using fit::FitState;
using fit::MotionCluster;

/// Gives a piece of a part to another bone; false when the part is too small for that.
bool split(FitState& state, const MotionCluster& cluster, std::size_t target,
           const std::vector<double>& errors) {
  constexpr std::size_t smallest = 8;
  if (cluster.vertices.size() < smallest) {
    return false;
  }
  const std::vector<std::size_t> moved = fit::bestHalf(state, cluster, errors);
  for (const std::size_t v : moved) {
    state.influences[v].bones[0] = static_cast<std::uint16_t>(target);
  }
  return !moved.empty();
}

/// More bones, all new ones at rest.
void growTo(FitState& state, std::size_t bones) {
  std::vector<BoneMatrix> matrices(state.frameCount * bones, BoneMatrix::Identity());
  for (std::size_t k = 0; k < state.frameCount; ++k) {
    for (std::size_t b = 0; b < state.boneCount; ++b) {
      matrices[k * bones + b] = state.matrix(k, b);
    }
  }
  state.matrices = std::move(matrices);
  state.boneCount = bones;
  state.axes.resize(bones, Eigen::Matrix3d::Identity());
}

/// Splits the parts that are followed worst, at most doubling them; bones that lost all vertices are used
/// again first. False when nothing was split.
bool splitWorst(FitState& state, std::size_t wanted) {
  const std::vector<double> errors = fit::vertexErrors(state);
  const std::vector<MotionCluster> clusters = fit::partsOf(state, errors);
  std::vector<std::size_t> order;
  std::vector<std::size_t> targets;
  for (std::size_t b = 0; b < clusters.size(); ++b) {
    (clusters[b].vertices.empty() ? targets : order).push_back(b);
  }
  const std::size_t before = state.boneCount;
  for (std::size_t b = before; b < std::min(wanted, before + order.size()); ++b) {
    targets.push_back(b);
  }
  if (targets.empty()) {
    return false;
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return clusters[a].error != clusters[b].error ? clusters[a].error > clusters[b].error
                                                  : clusters[a].vertices.size() > clusters[b].vertices.size();
  });
  std::size_t used = 0;
  for (const std::size_t b : order) {
    if (used < targets.size() && split(state, clusters[b], targets[used], errors)) {
      ++used;
    }
  }
  const std::size_t grown = used == 0 ? before : std::max(before, targets[used - 1] + 1);
  growTo(state, grown);
  return used > 0;
}

/// Whether more bones could not be told from those that there are.
bool isExact(const FitState& state) {
  constexpr double exact = 1e-6; // Of the diagonal, at every vertex.
  const std::vector<double> errors = fit::vertexErrors(state);
  return std::ranges::all_of(
      errors, [&](double error) { return error < exact * exact * static_cast<double>(state.frameCount); });
}

/// Bones in the middle of their parts, those without vertices left out.
void writeClusters(const FitState& state, const fit::MeshFrame& frame, SkinnedSequence& skinned) {
  const std::vector<MotionCluster> clusters =
      fit::partsOf(state, std::vector<double>(state.vertexCount(), 0.0));
  skinned.bones.clear();
  for (const MotionCluster& cluster : clusters) {
    for (const std::size_t v : cluster.vertices) {
      skinned.influences[v] = {};
      skinned.influences[v].bones[0] = static_cast<std::uint16_t>(skinned.bones.size());
      skinned.influences[v].weights[0] = 1.0F;
    }
    if (!cluster.vertices.empty()) {
      SkinBone bone;
      bone.pivot = bone.end = frame.out(cluster.centre);
      skinned.bones.push_back(bone);
    }
  }
}

} // namespace

SkinnedSequence clustersOfMotion(const MeshSequence& sequence, int boneCount, std::size_t firstFrame) {
  constexpr int roundsWhileGrowing = 2;
  constexpr int roundsAtTheEnd = 3;
  SkinnedSequence skinned = withoutBones(sequence);
  const fit::MeshFrame frame = fit::frameOf(skinned.bindPositions);
  Influences whole;
  whole.weights[0] = 1.0F;
  skinned.influences.assign(sequence.vertexCount, whole);
  skinned.bones.emplace_back();
  FitState state = fit::makeState(sequence, skinned, frame, std::min(firstFrame, sequence.frameCount() - 1));
  const auto wanted = static_cast<std::size_t>(std::max(boneCount, 1));
  fit::settleParts(state, 0);
  const int mostRounds = 2 * boneCount + 8;
  for (int round = 0; round < mostRounds && !isExact(state) && splitWorst(state, wanted); ++round) {
    fit::settleParts(state, state.boneCount < wanted ? roundsWhileGrowing : roundsAtTheEnd);
  }
  writeClusters(state, frame, skinned);
  return skinned;
}

} // namespace stretch::skinning
