#include "skinning/fit/motion_clusters.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "skinning/fit/sequence_state.h"
#include "skinning/fit/solve_bones.h"

namespace stretch::skinning {
namespace {

using fit::BoneMatrix;
using fit::FitState;

std::uint16_t boneOf(const FitState& state, std::size_t vertex) {
  return state.influences[vertex].bones[0];
}

/// What a part is and how badly its bone follows it.
struct MotionCluster {
  std::vector<std::size_t> vertices;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< In the bind pose.
  double error = 0.0;                               ///< Squared, over vertices and frames.
};

/// Squared distance of every vertex to where its bone puts it, over all frames.
std::vector<double> vertexErrors(const FitState& state) {
  std::vector<double> errors(state.vertexCount(), 0.0);
  const auto frames = static_cast<Eigen::Index>(state.frameCount);
  tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t v) {
    const Eigen::Vector4d point(state.bind[v].x(), state.bind[v].y(), state.bind[v].z(), 1.0);
    const auto column = static_cast<Eigen::Index>(v);
    for (Eigen::Index k = 0; k < frames; ++k) {
      const Eigen::Vector3f seen(state.observed(k, column), state.observed(frames + k, column),
                                 state.observed(2 * frames + k, column));
      const Eigen::Vector3d shown = state.matrix(static_cast<std::size_t>(k), boneOf(state, v)) * point;
      errors[v] += (shown - seen.cast<double>()).squaredNorm();
    }
  });
  return errors;
}

std::vector<MotionCluster> clustersOf(const FitState& state, const std::vector<double>& errors) {
  std::vector<MotionCluster> clusters(state.boneCount);
  for (std::size_t v = 0; v < state.vertexCount(); ++v) {
    MotionCluster& cluster = clusters[boneOf(state, v)];
    cluster.vertices.push_back(v);
    cluster.centre += state.bind[v];
    cluster.error += errors[v];
  }
  for (MotionCluster& cluster : clusters) {
    cluster.centre /= static_cast<double>(std::max<std::size_t>(cluster.vertices.size(), 1));
  }
  return clusters;
}

/// The vertex that a new bone starts from: far from the middle of its part, and followed badly. Where all is
/// followed well, the farthest.
std::size_t seedOf(const FitState& state, const MotionCluster& cluster, const std::vector<double>& errors) {
  constexpr double still = 1e-12; // Squared diagonals for each frame.
  const auto worth = [&](std::size_t v) {
    return (errors[v] + still * static_cast<double>(state.frameCount)) *
           (state.bind[v] - cluster.centre).squaredNorm();
  };
  return *std::ranges::max_element(cluster.vertices,
                                   [&](std::size_t a, std::size_t b) { return worth(a) < worth(b); });
}

/// Gives the half of a part around its seed to another bone; false when that would leave one of them with
/// hardly a vertex.
bool split(FitState& state, const MotionCluster& cluster, std::size_t target,
           const std::vector<double>& errors) {
  constexpr std::size_t fewest = 4;
  const Eigen::Vector3d seed = state.bind[seedOf(state, cluster, errors)];
  std::vector<std::size_t> moved;
  for (const std::size_t v : cluster.vertices) {
    if ((state.bind[v] - seed).squaredNorm() < (state.bind[v] - cluster.centre).squaredNorm()) {
      moved.push_back(v);
    }
  }
  if (moved.size() < fewest || cluster.vertices.size() - moved.size() < fewest) {
    return false;
  }
  for (const std::size_t v : moved) {
    state.influences[v].bones[0] = static_cast<std::uint16_t>(target);
  }
  return true;
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
  const std::vector<double> errors = vertexErrors(state);
  const std::vector<MotionCluster> clusters = clustersOf(state, errors);
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

void settle(FitState& state, int rounds) {
  std::vector<Eigen::Vector3d> scales(state.matrices.size(), Eigen::Vector3d::Ones());
  for (int round = 0; round < rounds; ++round) {
    fit::fitBones(state, scales, fit::StretchFit::free, 1);
    fit::solveWeights(state, 1, 1);
  }
  fit::fitBones(state, scales, fit::StretchFit::free, 1);
}

/// Bones in the middle of their parts, those without vertices left out.
void writeClusters(const FitState& state, const fit::MeshFrame& frame, SkinnedSequence& skinned) {
  const std::vector<MotionCluster> clusters =
      clustersOf(state, std::vector<double>(state.vertexCount(), 0.0));
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
  settle(state, 0);
  const int mostRounds = 2 * boneCount + 8;
  for (int round = 0; round < mostRounds && splitWorst(state, wanted); ++round) {
    settle(state, state.boneCount < wanted ? roundsWhileGrowing : roundsAtTheEnd);
  }
  writeClusters(state, frame, skinned);
  return skinned;
}

} // namespace stretch::skinning
