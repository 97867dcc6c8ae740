#include "skinning/long_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/transform.h"

namespace stretch::skinning {

namespace {

constexpr double mostTimes = 8.0; // an edge that is not seen is looked at as if it were allowed no more

} // namespace

LongEdges::LongEdges(const SurfacePart& part, const FrameState& bind, double seen)
    : seen_(seen), areMeans_(part.areMeans()), longest_(part.slots().size(), 0.0) {
  const SurfacePart::Posed posed = part.posed(bind);
  lengths_.reserve(part.edges().size());
  for (const SurfacePart::Edge& edge : part.edges()) {
    const glm::vec3 between = part.place(edge.moved, posed) - part.place(edge.other, posed);
    lengths_.push_back(std::sqrt(static_cast<double>(glm::dot(between, between))));
  }
  measure(part);
}

void LongEdges::measure(const SurfacePart& part) {
  constexpr double least = 1e-6; // of weight, what rounding may leave
  std::map<std::pair<std::size_t, std::size_t>, std::pair<Blend, Bounds>> blends;
  for (std::uint32_t edge = 0; edge < lengths_.size(); ++edge) {
    const auto [first, second] = part.edges()[edge];
    const std::array ends{Vec3(part.placeInMesh(first)), Vec3(part.placeInMesh(second))};
    const double length = std::max(lengths_[edge], seen_ / mostTimes);
    std::vector<std::pair<std::size_t, double>> passed; // by slot
    for (const std::uint32_t end : {first, second}) {
      for (const SurfacePart::Influence& one : part.influencesOf(end)) {
        const auto known = std::ranges::find(passed, one.slot, &std::pair<std::size_t, double>::first);
        double& sum = known != passed.end() ? known->second : passed.emplace_back(one.slot, 0.0).second;
        sum += (end == first ? 1.0 : -1.0) * static_cast<double>(one.weight);
        longest_[one.slot] = std::max(longest_[one.slot], glm::distance(ends[0], ends[1]) / length);
      }
    }
    const double all = std::accumulate(passed.begin(), passed.end(), 0.0, [](double sum, const auto& one) {
      return sum + 0.5 * std::abs(one.second);
    });
    for (const auto& [from, given] : passed) {
      for (const auto& [to, taken] : passed) {
        if (given > least && taken < -least) {
          auto& [blend, box] = blends[std::minmax(from, to)];
          blend.edges.push_back(
              {std::nextafter(static_cast<float>(all / length), std::numeric_limits<float>::max()), edge});
          box.add(ends[0]);
          box.add(ends[1]);
        }
      }
    }
  }
  for (auto& [slots, measured] : blends) {
    auto& [blend, box] = measured;
    std::ranges::sort(blend.edges, std::greater(), &Passing::share);
    blend.edges.shrink_to_fit();
    blends_.push_back({slots.first, slots.second, 0.5 * (box.low + box.high),
                       0.5 * glm::length(box.high - box.low), std::move(blend.edges)});
  }
}

std::vector<std::uint32_t> LongEdges::among(const SurfacePart& part, const SurfacePart::Posed& posed,
                                            double times) const {
  double carried = 0.0;
  for (std::size_t slot = 0; slot < longest_.size(); ++slot) {
    carried = std::max(carried, longest_[slot] * growthOf(posed.matrices[slot]));
  }
  const double left = std::min(times, mostTimes) - carried - mostTimes * posed.rounding / seen_;
  std::vector<std::uint32_t> edges;
  if (!areMeans_ || !(left > 0.0)) {
    edges.resize(lengths_.size());
    std::iota(edges.begin(), edges.end(), 0U);
    return edges;
  }
  for (const Blend& blend : blends_) {
    const Mat4 apart = posed.matrices[blend.from] - posed.matrices[blend.to];
    const double farthest = glm::length(transformPoint(apart, blend.centre)) + growthOf(apart) * blend.radius;
    for (const Passing& one : blend.edges) {
      const double share = one.share;
      if (share * farthest <= left) {
        break;
      }
      const Vec3 end(part.placeInMesh(part.edges()[one.edge].other));
      if (share * glm::length(transformPoint(apart, end)) > left) {
        edges.push_back(one.edge);
      }
    }
  }
  return edges;
}

} // namespace stretch::skinning
