#include "skinning/fit/split_part.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

#include "skinning/fit/solve_bones.h"

namespace stretch::skinning::fit {
namespace {

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

} // namespace

std::vector<MotionCluster> partsOf(const FitState& state, const std::vector<double>& errors) {
  std::vector<MotionCluster> clusters(state.boneCount);
  for (std::size_t v = 0; v < state.vertexCount(); ++v) {
    const Influences& influences = state.influences[v];
    const auto most = std::ranges::max_element(influences.weights) - influences.weights.begin();
    MotionCluster& cluster = clusters[influences.bones[static_cast<std::size_t>(most)]];
    cluster.vertices.push_back(v);
    cluster.centre += state.bind[v];
    cluster.error += errors[v];
  }
  for (MotionCluster& cluster : clusters) {
    cluster.centre /= static_cast<double>(std::max<std::size_t>(cluster.vertices.size(), 1));
  }
  return clusters;
}

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

void settleParts(FitState& state, int rounds) {
  std::vector<Eigen::Vector3d> scales(state.matrices.size(), Eigen::Vector3d::Ones());
  for (int round = 0; round < rounds; ++round) {
    fitBones(state, scales, StretchFit::free, 1);
    solveWeights(state, 1, 1);
  }
  fitBones(state, scales, StretchFit::free, 1);
}

std::vector<std::size_t> bestHalf(const FitState& state, const MotionCluster& cluster,
                                  const std::vector<double>& errors) {
  constexpr int rounds = 2;
  constexpr std::size_t fewest = 4;
  std::vector<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<std::size_t>& beginning : beginningsOf(state, cluster, errors)) {
    FitState part = partInTwo(state, cluster, beginning);
    settleParts(part, rounds);
    std::vector<std::size_t> second;
    for (std::size_t i = 0; i < cluster.vertices.size(); ++i) {
      if (part.influences[i].bones[0] == 1) {
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

} // namespace stretch::skinning::fit
