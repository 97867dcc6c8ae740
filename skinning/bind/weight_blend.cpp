#include "skinning/bind/weight_blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

using Neighbours = std::array<std::int32_t, 6>;

std::vector<Neighbours> faceNeighboursOf(const VoxelBody& body) {
  std::vector<Neighbours> all(body.cellCount());
  for (std::size_t cell = 0; cell < all.size(); ++cell) {
    const auto [x, y, z] = body.grid.placeOfIndex(body.cubeOf[cell]);
    const auto at = [&](int i, int j, int k) { return body.cellAt[body.grid.indexOf({i, j, k})]; };
    all[cell] = {at(x + 1, y, z), at(x - 1, y, z), at(x, y + 1, z),
                 at(x, y - 1, z), at(x, y, z + 1), at(x, y, z - 1)};
  }
  return all;
}

// Weights that come together in one cell: at most those of seven cells.
class Gathered {
public:
  void add(const CellWeights& cell, float factor) {
    for (std::size_t i = 0; i < CellWeights::capacity && cell.weights[i] > 0.0F; ++i) {
      add(cell.joints[i], factor * cell.weights[i]);
    }
  }

  [[nodiscard]] CellWeights strongest() {
    CellWeights kept;
    float total = 0.0F;
    for (std::size_t slot = 0; slot < CellWeights::capacity && slot < count_; ++slot) {
      const auto from = entries_.begin() + static_cast<std::ptrdiff_t>(slot);
      const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(count_);
      std::iter_swap(from, std::max_element(from, end, [](const Entry& a, const Entry& b) {
                       return a.weight < b.weight || (a.weight == b.weight && a.joint > b.joint);
                     }));
      kept.joints[slot] = from->joint;
      kept.weights[slot] = from->weight;
      total += from->weight;
    }
    for (float& weight : kept.weights) {
      weight /= total;
    }
    return kept;
  }

private:
  struct Entry {
    std::uint16_t joint = 0;
    float weight = 0.0F;
  };

  void add(std::uint16_t joint, float weight) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (entries_[i].joint == joint) {
        entries_[i].weight += weight;
        return;
      }
    }
    entries_[count_++] = {joint, weight};
  }

  std::array<Entry, 7 * CellWeights::capacity> entries_{};
  std::size_t count_ = 0;
};

// One step of the flow. `rates`: the part of a cell's weights that goes to each of its neighbours.
class Flow {
public:
  Flow(const VoxelBody& body, std::vector<float> rates)
      : neighbours_(faceNeighboursOf(body)), rates_(std::move(rates)) {}

  void step(const std::vector<CellWeights>& now, std::vector<CellWeights>& next) const {
    constexpr std::size_t atOnce = 1024;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, now.size(), atOnce), [&](const auto& range) {
      for (std::size_t cell = range.begin(); cell < range.end(); ++cell) {
        next[cell] = isSettled(now, cell) ? now[cell] : flowed(now, cell);
      }
    });
  }

private:
  // All around follow the same joint alone.
  [[nodiscard]] bool isSettled(const std::vector<CellWeights>& now, std::size_t cell) const {
    return std::all_of(neighbours_[cell].begin(), neighbours_[cell].end(), [&](std::int32_t beside) {
      const CellWeights& other = now[beside == VoxelBody::outside ? cell : static_cast<std::size_t>(beside)];
      return other.joints[0] == now[cell].joints[0] && other.weights[0] == 1.0F;
    });
  }

  [[nodiscard]] CellWeights flowed(const std::vector<CellWeights>& now, std::size_t cell) const {
    Gathered gathered;
    float kept = 1.0F;
    for (const std::int32_t beside : neighbours_[cell]) {
      if (beside != VoxelBody::outside) {
        const auto other = static_cast<std::size_t>(beside);
        const float rate = 0.5F * (rates_[cell] + rates_[other]);
        gathered.add(now[other], rate);
        kept -= rate;
      }
    }
    gathered.add(now[cell], kept);
    return gathered.strongest();
  }

  std::vector<Neighbours> neighbours_;
  std::vector<float> rates_;
};

} // namespace

std::vector<std::uint16_t> boneRegions(const VoxelBody& body, const std::vector<BoneCell>& cells,
                                       const std::vector<double>& radii, double sections) {
  std::vector<double> distances(body.cellCount(), std::numeric_limits<double>::max());
  std::vector<std::uint16_t> owners(body.cellCount(), nobody);
  CellQueue open;
  for (const BoneCell& seed : cells) {
    const double distance = seed.distance - sections * radii[seed.joint];
    if (distance < distances[seed.cell]) {
      distances[seed.cell] = distance;
      owners[seed.cell] = seed.joint;
      open.emplace(distance, static_cast<std::uint32_t>(seed.cell));
    }
  }
  spread(body, distances, open, [&](std::size_t from, std::size_t to) { owners[to] = owners[from]; });
  return owners;
}

std::vector<CellWeights> blendedRegions(const VoxelBody& body, const std::vector<std::uint16_t>& owners,
                                        const std::vector<double>& radii, double blend) {
  double widest = 0.0;
  for (const std::uint16_t owner : owners) {
    widest = std::max(widest, radii[owner]);
  }
  // A step with rate a spreads by the variance 2 a (in cubes); a below 1/6 keeps weights positive.
  constexpr double stepsOfVariance = 3.5;
  constexpr int mostSteps = 400;
  const double spreadCubes = blend * widest / body.grid.size;
  const int steps =
      std::clamp(static_cast<int>(std::ceil(stepsOfVariance * spreadCubes * spreadCubes)), 1, mostSteps);
  const double fullRate = std::min(spreadCubes * spreadCubes / (2.0 * steps), 1.0 / 6.5);
  std::vector<CellWeights> now(owners.size());
  std::vector<float> rates(owners.size());
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    const double part = radii[owners[cell]] / widest;
    rates[cell] = static_cast<float>(fullRate * part * part);
    now[cell].joints[0] = owners[cell];
    now[cell].weights[0] = 1.0F;
  }
  const Flow flow(body, std::move(rates));
  std::vector<CellWeights> next(owners.size());
  for (int step = 0; step < steps; ++step) {
    flow.step(now, next);
    std::swap(now, next);
  }
  return now;
}

} // namespace stretch::skinning
