#include "skinning/fit/motion_clusters.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

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

void settle(FitState& state, int rounds) {
  std::vector<Eigen::Vector3d> scales(state.matrices.size(), Eigen::Vector3d::Ones());
  for (int round = 0; round < rounds; ++round) {
    fit::fitBones(state, scales, fit::StretchFit::free, 1);
    fit::solveWeights(state, 1, 1);
  }
  fit::fitBones(state, scales, fit::StretchFit::free, 1);
}

/// A part by itself, on two bones: its vertices at `second` on the second one.
FitState partInTwo(const FitState& state, const MotionCluster& cluster,
                   const std::vector<std::size_t>& second) {
  FitState part;
  part.frameCount = state.frameCount;
  part.boneCount = 2;
  part.axes.assign(2, Eigen::Matrix3d::Identity());
  part.matrices.assign(2 * state.frameCount, BoneMatrix::Identity());
  part.observed.resize(state.observed.rows(), static_cast<Eigen::Index>(cluster.vertices.size()));
  part.influences.resize(cluster.vertices.size());
  for (std::size_t i = 0; i < cluster.vertices.size(); ++i) {
    part.bind.push_back(state.bind[cluster.vertices[i]]);
    part.observed.col(static_cast<Eigen::Index>(i)) =
        state.observed.col(static_cast<Eigen::Index>(cluster.vertices[i]));
    part.influences[i].weights[0] = 1.0F;
  }
  for (const std::size_t i : second) {
    part.influences[i].bones[0] = 1;
  }
  return part;
}

/// Two ways to begin: the half around the seed, which suits a body that bends, and what is nearest to it,
/// which finds a small piece that moves by itself. Indices into the part's vertices.
std::vector<std::vector<std::size_t>> beginningsOf(const FitState& state, const MotionCluster& cluster,
                                                   const std::vector<double>& errors) {
  constexpr std::size_t nearestShare = 16;
  constexpr std::size_t fewestNearest = 4;
  const Eigen::Vector3d seed = state.bind[seedOf(state, cluster, errors)];
  std::vector<std::size_t> half;
  std::vector<std::size_t> nearest(cluster.vertices.size());
  std::iota(nearest.begin(), nearest.end(), std::size_t{0});
  const auto away = [&](std::size_t i) { return (state.bind[cluster.vertices[i]] - seed).squaredNorm(); };
  std::ranges::copy_if(nearest, std::back_inserter(half), [&](std::size_t i) {
    return away(i) < (state.bind[cluster.vertices[i]] - cluster.centre).squaredNorm();
  });
  std::ranges::stable_sort(nearest, [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
  nearest.resize(std::min(nearest.size(), std::max(fewestNearest, nearest.size() / nearestShare)));
  return {half, nearest};
}

/// Vertices of a part that go to a second bone, the better of both beginnings; empty where either would leave
/// one of the two with hardly a vertex.
std::vector<std::size_t> bestHalf(const FitState& state, const MotionCluster& cluster,
                                  const std::vector<double>& errors) {
  constexpr int rounds = 2;
  constexpr std::size_t fewest = 4;
  std::vector<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<std::size_t>& beginning : beginningsOf(state, cluster, errors)) {
    FitState part = partInTwo(state, cluster, beginning);
    settle(part, rounds);
    std::vector<std::size_t> second;
    for (std::size_t i = 0; i < cluster.vertices.size(); ++i) {
      if (boneOf(part, i) == 1) {
        second.push_back(cluster.vertices[i]);
      }
    }
    const std::vector<double> left = vertexErrors(part);
    const double error = std::accumulate(left.begin(), left.end(), 0.0);
    if (error < least && second.size() >= fewest && cluster.vertices.size() - second.size() >= fewest) {
      least = error;
      best = std::move(second);
    }
  }
  return best;
}

/// Gives a piece of a part to another bone; false when the part is too small for that.
bool split(FitState& state, const MotionCluster& cluster, std::size_t target,
           const std::vector<double>& errors) {
  constexpr std::size_t smallest = 8;
  if (cluster.vertices.size() < smallest) {
    return false;
  }
  const std::vector<std::size_t> moved = bestHalf(state, cluster, errors);
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

/// Whether more bones could not be told from those that there are.
bool isExact(const FitState& state) {
  constexpr double exact = 1e-6; // Of the diagonal, at every vertex.
  const std::vector<double> errors = vertexErrors(state);
  return std::ranges::all_of(
      errors, [&](double error) { return error < exact * exact * static_cast<double>(state.frameCount); });
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
  for (int round = 0; round < mostRounds && !isExact(state) && splitWorst(state, wanted); ++round) {
    settle(state, state.boneCount < wanted ? roundsWhileGrowing : roundsAtTheEnd);
  }
  writeClusters(state, frame, skinned);
  return skinned;
}

} // namespace stretch::skinning
