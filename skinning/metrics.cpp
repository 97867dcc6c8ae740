#include "skinning/metrics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

namespace stretch::skinning {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Edge> edgesOf(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (t[c] != t[(c + 1) % 3]) {
        edges.emplace_back(std::minmax(t[c], t[(c + 1) % 3]));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Edges of the triangles that touch a vertex within so many rings, a sorted list for each vertex.
std::vector<std::vector<std::uint32_t>> neighbourhoods(const MeshSequence& sequence,
                                                       const std::vector<Edge>& edges, int rings) {
  std::vector<std::vector<std::uint32_t>> around(sequence.vertexCount);
  for (const Triangle& t : sequence.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (t[c] == t[(c + 1) % 3]) {
        continue;
      }
      const Edge edge = std::minmax(t[c], t[(c + 1) % 3]);
      const auto index =
          static_cast<std::uint32_t>(std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin());
      for (const std::uint32_t corner : t) {
        around[corner].push_back(index);
      }
    }
  }
  const auto tidy = [](std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  std::for_each(around.begin(), around.end(), tidy);
  const auto firstRing = around;
  for (int ring = 1; ring < rings; ++ring) {
    const auto before = around;
    for (std::size_t v = 0; v < around.size(); ++v) {
      for (const std::uint32_t e : before[v]) {
        for (const std::uint32_t end : {edges[e].first, edges[e].second}) {
          around[v].insert(around[v].end(), firstRing[end].begin(), firstRing[end].end());
        }
      }
      tidy(around[v]);
    }
  }
  return around;
}

double lengthOf(std::span<const glm::vec3> frame, const Edge& edge) {
  return glm::length(Vec3(frame[edge.first]) - Vec3(frame[edge.second]));
}

double relativeDifference(double reference, double other) {
  return reference > 0.0 ? std::abs(reference - other) / reference : 0.0;
}

/// Standard deviation with weights.
class Deviation {
public:
  void add(double value, double weight) {
    weight_ += weight;
    sum_ += weight * value;
    square_ += weight * value * value;
  }
  [[nodiscard]] double value() const {
    if (!(weight_ > 0.0)) {
      return 0.0;
    }
    const double mean = sum_ / weight_;
    return std::sqrt(std::max(0.0, square_ / weight_ - mean * mean));
  }

private:
  double weight_ = 0.0;
  double sum_ = 0.0;
  double square_ = 0.0;
};

double spatialPart(const MeshSequence& a, const MeshSequence& b, const std::vector<Edge>& edges,
                   const std::vector<std::vector<std::uint32_t>>& around) {
  std::vector<double> sums(a.frameCount(), 0.0);
  tbb::parallel_for(std::size_t{0}, a.frameCount(), [&](std::size_t k) {
    std::vector<double> lengths(edges.size());
    std::vector<double> differences(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      lengths[e] = lengthOf(a.frame(k), edges[e]);
      differences[e] = relativeDifference(lengths[e], lengthOf(b.frame(k), edges[e]));
    }
    for (const auto& list : around) {
      Deviation deviation;
      for (const std::uint32_t e : list) {
        deviation.add(differences[e], lengths[e]);
      }
      sums[k] += deviation.value();
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(a.frameCount() * a.vertexCount);
}

/// Length of the virtual edge that joins a vertex to itself one frame on.
double virtualLength(const MeshSequence& s, std::size_t vertex, std::size_t step, double timeStep) {
  return std::hypot(glm::length(Vec3(s.frame(step + 1)[vertex]) - Vec3(s.frame(step)[vertex])), timeStep);
}

double temporalPart(const MeshSequence& a, const MeshSequence& b, const StedSettings& settings) {
  const std::size_t steps = a.frameCount() - 1;
  const auto half = static_cast<std::size_t>(std::max(settings.window, 1) / 2);
  std::vector<double> sums(a.vertexCount, 0.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, a.vertexCount, 64), [&](const auto& range) {
    std::vector<double> differences(steps);
    std::vector<double> lengths(steps);
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      for (std::size_t k = 0; k < steps; ++k) {
        lengths[k] = virtualLength(a, v, k, settings.timeStep);
        differences[k] = relativeDifference(lengths[k], virtualLength(b, v, k, settings.timeStep));
      }
      for (std::size_t k = 0; k < steps; ++k) {
        Deviation deviation;
        for (std::size_t i = k - std::min(k, half); i <= std::min(k + half, steps - 1); ++i) {
          deviation.add(differences[i], lengths[i]);
        }
        sums[v] += deviation.value();
      }
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(steps * a.vertexCount);
}

void measureSted(const MeshSequence& a, const MeshSequence& b, SequenceMetrics& metrics) {
  const std::vector<Edge> edges = edgesOf(a.triangles);
  if (metrics.stedSettings.timeStep <= 0.0) {
    double sum = 0.0;
    for (const Edge& edge : edges) {
      sum += lengthOf(a.frame(0), edge);
    }
    metrics.stedSettings.timeStep = edges.empty() ? 1.0 : 0.1 * sum / static_cast<double>(edges.size());
  }
  metrics.stedSpatial = spatialPart(a, b, edges, neighbourhoods(a, edges, metrics.stedSettings.rings));
  metrics.stedTemporal = a.frameCount() > 1 ? temporalPart(a, b, metrics.stedSettings) : 0.0;
  metrics.sted = std::hypot(metrics.stedSpatial, metrics.stedSettings.c * metrics.stedTemporal);
}

struct FrameSums {
  double squared = 0.0; ///< Of the distances.
  double spread = 0.0;  ///< Squared distances of the reference from its centroid.
  double largest = 0.0; ///< Distance.
};

FrameSums sumFrame(const MeshSequence& a, const MeshSequence& b, std::size_t frame) {
  Vec3 sum(0.0);
  for (std::size_t v = 0; v < a.vertexCount; ++v) {
    sum += Vec3(a.frame(frame)[v]);
  }
  const Vec3 centroid = sum / static_cast<double>(a.vertexCount); // One place of all is exactly that.
  FrameSums sums;
  for (std::size_t v = 0; v < a.vertexCount; ++v) {
    const Vec3 position(a.frame(frame)[v]);
    const Vec3 off = position - Vec3(b.frame(frame)[v]);
    sums.squared += glm::dot(off, off);
    sums.spread += glm::dot(position - centroid, position - centroid);
    sums.largest = std::max(sums.largest, glm::length(off));
  }
  return sums;
}

} // namespace

SequenceMetrics distancesOf(const MeshSequence& reference, const MeshSequence& other) {
  std::vector<FrameSums> frames(reference.frameCount());
  tbb::parallel_for(std::size_t{0}, frames.size(),
                    [&](std::size_t k) { frames[k] = sumFrame(reference, other, k); });
  FrameSums total;
  for (const FrameSums& frame : frames) {
    total.squared += frame.squared;
    total.spread += frame.spread;
    total.largest = std::max(total.largest, frame.largest);
  }
  const SequenceExtent extent = extentOf(reference);
  // Without any extent there is nothing to be a part of: what is off is off by all of it.
  const auto percentOf = [](double distance, double whole) {
    return whole > 0.0 ? 100.0 * distance / whole : distance > 0.0 ? 100.0 : 0.0;
  };
  SequenceMetrics metrics;
  metrics.mse = total.squared / static_cast<double>(reference.positions.size());
  metrics.rmsePercent = percentOf(std::sqrt(metrics.mse), extent.diagonal);
  metrics.largestPercent = percentOf(total.largest, extent.diagonal);
  metrics.kgError =
      total.spread > 0.0 ? 100.0 * std::sqrt(total.squared / total.spread) : percentOf(total.squared, 0.0);
  return metrics;
}

std::string frameOfErrors(const MeshSequence& reference) {
  const std::size_t frame = extentOf(reference).frame;
  return frame == 0 ? std::string()
                    : fmt::format("errors are parts of the diagonal of frame {}: before it the body has no "
                                  "extent, or less than a hundredth of its largest",
                                  frame);
}

Result<SequenceMetrics> compareSequences(const MeshSequence& reference, const MeshSequence& other,
                                         const StedSettings& settings) {
  const std::string place = reference.name + " against " + other.name;
  if (reference.vertexCount != other.vertexCount || reference.vertexCount == 0) {
    return Error{fmt::format("{} vertices against {}", reference.vertexCount, other.vertexCount), place,
                 "compare sequences of one mesh"};
  }
  if (reference.frameCount() != other.frameCount() || reference.frameCount() == 0) {
    return Error{fmt::format("{} frames against {}", reference.frameCount(), other.frameCount()), place,
                 "compare the same range of frames"};
  }
  if (reference.triangles.size() != other.triangles.size()) {
    return Error{fmt::format("{} triangles against {}", reference.triangles.size(), other.triangles.size()),
                 place, "compare sequences of one mesh"};
  }
  SequenceMetrics metrics = distancesOf(reference, other);
  metrics.stedSettings = settings;
  measureSted(reference, other, metrics);
  return metrics;
}

} // namespace stretch::skinning
