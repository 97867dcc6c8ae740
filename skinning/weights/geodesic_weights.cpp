#include "skinning/weights/geodesic_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "skinning/geometry/geodesic_distance.h"

namespace stretch::skinning {
namespace {

double squaredDistance(const Vec3& point, const BoneSegment& bone) {
  const Vec3 along = bone.end - bone.start;
  const double square = glm::dot(along, along);
  const double t = square > 0.0 ? std::clamp(glm::dot(point - bone.start, along) / square, 0.0, 1.0) : 0.0;
  const Vec3 away = point - bone.start - t * along;
  return glm::dot(away, away);
}

std::size_t nearestBone(const Vec3& point, const std::vector<BoneSegment>& bones) {
  std::size_t best = 0;
  for (std::size_t b = 1; b < bones.size(); ++b) {
    best = squaredDistance(point, bones[b]) < squaredDistance(point, bones[best]) ? b : best;
  }
  return best;
}

/// Vertices of the faces that are nearest to each bone.
std::vector<std::vector<std::uint32_t>> patches(std::span<const glm::vec3> positions,
                                                const std::vector<Triangle>& triangles,
                                                const std::vector<BoneSegment>& bones) {
  std::vector<std::vector<std::uint32_t>> seeds(bones.size());
  for (const Triangle& t : triangles) {
    const Vec3 centre = (Vec3(positions[t[0]]) + Vec3(positions[t[1]]) + Vec3(positions[t[2]])) / 3.0;
    auto& patch = seeds[nearestBone(centre, bones)];
    patch.insert(patch.end(), t.begin(), t.end());
  }
  for (auto& patch : seeds) {
    std::sort(patch.begin(), patch.end());
    patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
  }
  return seeds;
}

/// How far from a patch a bone can still matter: beyond it the weight would be below a thousandth.
double reachOf(const GeodesicWeightSettings& settings, double boneLength) {
  return boneLength * (settings.offset * std::pow(1000.0, 1.0 / settings.power) + 1.0);
}

} // namespace

Influences strongestFour(const std::vector<double>& weights) {
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t kept = std::min(order.size(), std::size_t{4});
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return weights[a] > weights[b] || (weights[a] == weights[b] && a < b);
                    });
  double sum = 0.0;
  for (std::size_t i = 0; i < kept; ++i) {
    sum += weights[order[i]];
  }
  Influences influences;
  if (!(sum > 0.0)) {
    influences.weights[0] = 1.0F;
    return influences;
  }
  for (std::size_t i = 0; i < kept && weights[order[i]] > 0.0; ++i) {
    influences.bones[i] = static_cast<std::uint16_t>(order[i]);
    influences.weights[i] = static_cast<float>(weights[order[i]] / sum);
  }
  return influences;
}

Result<std::vector<Influences>> geodesicWeights(std::span<const glm::vec3> positions,
                                                const std::vector<Triangle>& triangles,
                                                const std::vector<BoneSegment>& bones,
                                                const GeodesicWeightSettings& settings) {
  if (bones.empty() || triangles.empty() || bones.size() > 65535) {
    return Error{"weights need bones (at most 65535) and triangles", "",
                 "give a mesh with faces and a skeleton"};
  }
  const GeodesicSolver solver(positions, triangles);
  const auto seeds = patches(positions, triangles, bones);
  const double smallest = 1e-6 * boxDiagonal(positions);
  std::vector<std::vector<std::pair<std::uint32_t, double>>> found(bones.size()); // Of each bone: vertex and
                                                                                  // weight.
  tbb::parallel_for(std::size_t{0}, bones.size(), [&](std::size_t b) {
    if (seeds[b].empty()) {
      return;
    }
    const double length = std::max(glm::length(bones[b].end - bones[b].start), smallest);
    const std::vector<double> distances = solver.distances(seeds[b], reachOf(settings, length));
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
      if (std::isfinite(distances[v])) {
        found[b].emplace_back(v, std::pow(distances[v] / length + settings.offset, -settings.power));
      }
    }
  });
  std::vector<std::vector<std::pair<std::size_t, double>>> ofVertex(positions.size());
  for (std::size_t b = 0; b < bones.size(); ++b) {
    for (const auto& [vertex, weight] : found[b]) {
      ofVertex[vertex].emplace_back(b, weight);
    }
  }
  std::vector<Influences> result(positions.size());
  tbb::parallel_for(std::size_t{0}, positions.size(), [&](std::size_t v) {
    std::vector<double> weights(bones.size(), 0.0);
    for (const auto& [bone, weight] : ofVertex[v]) {
      weights[bone] = weight;
    }
    if (ofVertex[v].empty()) {
      weights[nearestBone(Vec3(positions[v]), bones)] = 1.0;
    }
    result[v] = strongestFour(weights);
  });
  return result;
}

} // namespace stretch::skinning
