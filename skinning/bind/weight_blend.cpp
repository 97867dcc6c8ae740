#include "skinning/bind/weight_blend.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

using Neighbours = std::array<std::int32_t, 6>;

// Whether what one cell follows may flow to another one beside it.
class Borders {
public:
  Borders(const VoxelBody& body, const std::vector<BoneLine>& lines, const SkeletonWays& ways,
          const std::vector<CellOwner>& owners)
      : size_(body.grid.size), lines_(lines), ways_(ways), owners_(owners) {}

  [[nodiscard]] bool areOpen(std::size_t cell, std::size_t beside) const {
    const CellOwner& a = owners_[cell];
    const CellOwner& b = owners_[beside];
    if (lines_[a.line].joint == lines_[b.line].joint) {
      return true;
    }
    const double across = static_cast<double>(a.distance) + static_cast<double>(b.distance) + size_;
    constexpr double half = 0.5;
    return ways_.kinship({a.line, static_cast<double>(a.along)}, {b.line, static_cast<double>(b.along)},
                         across) > half;
  }

private:
  double size_;
  const std::vector<BoneLine>& lines_;
  const SkeletonWays& ways_;
  const std::vector<CellOwner>& owners_;
};

std::vector<Neighbours> faceNeighboursOf(const VoxelBody& body, const Borders& borders) {
  std::vector<Neighbours> all(body.cellCount());
  for (std::size_t cell = 0; cell < all.size(); ++cell) {
    const auto [x, y, z] = body.grid.placeOfIndex(body.cubeOf[cell]);
    const auto at = [&](int i, int j, int k) { return body.cellAt[body.grid.indexOf({i, j, k})]; };
    all[cell] = {at(x + 1, y, z), at(x - 1, y, z), at(x, y + 1, z),
                 at(x, y - 1, z), at(x, y, z + 1), at(x, y, z - 1)};
    for (std::int32_t& beside : all[cell]) {
      if (beside != VoxelBody::outside && !borders.areOpen(cell, static_cast<std::size_t>(beside))) {
        beside = VoxelBody::outside;
      }
    }
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
      const std::span<Entry> left = std::span(entries_).subspan(slot, count_ - slot);
      std::swap(left.front(), *std::ranges::max_element(left, [](const Entry& a, const Entry& b) {
                  return a.weight < b.weight || (a.weight == b.weight && a.joint > b.joint);
                }));
      kept.joints[slot] = left.front().joint;
      kept.weights[slot] = left.front().weight;
      total += left.front().weight;
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
  Flow(const VoxelBody& body, const Borders& borders, std::vector<float> rates)
      : neighbours_(faceNeighboursOf(body, borders)), rates_(std::move(rates)) {}

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

std::vector<CellOwner> boneRegions(const VoxelBody& body, const std::vector<BoneLine>& lines,
                                   const std::vector<BoneCell>& cells, const std::vector<double>& radii,
                                   double sections) {
  std::vector<double> distances(body.cellCount(), std::numeric_limits<double>::max());
  std::vector<CellOwner> owners(body.cellCount());
  CellQueue open;
  for (const BoneCell& seed : cells) {
    const double distance = seed.distance - sections * radii[lines[seed.line].joint];
    if (distance < distances[seed.cell]) {
      distances[seed.cell] = distance;
      owners[seed.cell] = {seed.line, seed.along, 0.0F};
      open.emplace(distance, static_cast<std::uint32_t>(seed.cell));
    }
  }
  spread(body, distances, open, [&](std::size_t from, std::size_t to) { owners[to] = owners[from]; });
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    if (owners[cell].line != CellOwner::nobody) {
      owners[cell].distance =
          static_cast<float>(distances[cell] + sections * radii[lines[owners[cell].line].joint]);
    }
  }
  return owners;
}

std::vector<CellWeights> blendedRegions(const VoxelBody& body, const std::vector<BoneLine>& lines,
                                        const SkeletonWays& ways, const std::vector<CellOwner>& owners,
                                        const std::vector<double>& radii, double blend,
                                        const Proceed& proceed) {
  double widest = 0.0;
  for (const CellOwner& owner : owners) {
    widest = std::max(widest, radii[lines[owner.line].joint]);
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
    const std::uint16_t joint = lines[owners[cell].line].joint;
    const double part = radii[joint] / widest;
    rates[cell] = static_cast<float>(fullRate * part * part);
    now[cell].joints[0] = joint;
    now[cell].weights[0] = 1.0F;
  }
  const Flow flow(body, Borders(body, lines, ways, owners), std::move(rates));
  std::vector<CellWeights> next(owners.size());
  for (int step = 0; step < steps && (!proceed || proceed(static_cast<double>(step) / steps)); ++step) {
    flow.step(now, next);
    std::swap(now, next);
  }
  return now;
}

} // namespace stretch::skinning
