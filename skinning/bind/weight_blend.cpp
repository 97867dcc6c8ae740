#include "skinning/bind/weight_blend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

using Neighbours = std::array<std::uint32_t, 6>; // the cell itself where nothing flows

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
    const auto at = [&](int i, int j, int k) {
      const std::int32_t beside = body.cellAt[body.grid.indexOf({i, j, k})];
      const bool isOpen =
          beside != VoxelBody::outside && borders.areOpen(cell, static_cast<std::size_t>(beside));
      return static_cast<std::uint32_t>(isOpen ? static_cast<std::size_t>(beside) : cell);
    };
    all[cell] = {at(x + 1, y, z), at(x - 1, y, z), at(x, y + 1, z),
                 at(x, y - 1, z), at(x, y, z + 1), at(x, y, z - 1)};
  }
  return all;
}

// Cells that a joint moves, ascending, and how much of each.
struct JointField {
  std::uint16_t joint = 0;
  std::vector<std::uint32_t> cells;
  std::vector<float> weights;
};

// All cells, for the field of one joint at a time; 0 between two fields.
struct FlowRoom {
  explicit FlowRoom(std::size_t cells) : now(cells), before(cells), isReached(cells) {}

  std::vector<float> now;
  std::vector<float> before;
  std::vector<char> isReached;
};

// `stages` evaluations are worth so many steps as remain stable (Runge-Kutta-Legendre; Meyer, Balsara, Aslam
// 2012, A second-order accurate Super TimeStepping formulation for anisotropic thermal conduction).
struct FlowSpan {
  int stages = 1;
  double steps = 1.0; // at most (stages^2 + stages) / 2
};

// The flow of one joint's weights, which no other joint's change. `rates`: the part of a cell's weights that
// goes to each of its neighbours in a step.
class Flow {
public:
  Flow(const VoxelBody& body, const Borders& borders, std::vector<float> rates)
      : neighbours_(faceNeighboursOf(body, borders)), rates_(std::move(rates)) {}

  void over(const FlowSpan& span, JointField& field, FlowRoom& room) const {
    std::vector<std::uint32_t> reached = std::move(field.cells);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      room.now[reached[i]] = field.weights[i];
      room.isReached[reached[i]] = 1;
    }
    const auto part = static_cast<float>(2.0 * span.steps / (span.stages * (span.stages + 1)));
    std::size_t rim = 0;
    for (int stage = 1; stage <= span.stages; ++stage) {
      rim = grow(rim, reached, room);
      const float carried = static_cast<float>(2 * stage - 1) / static_cast<float>(stage);
      for (const std::uint32_t cell : reached) {
        room.before[cell] = carried * (room.now[cell] + part * flowInto(cell, room.now)) +
                            (1.0F - carried) * room.before[cell];
      }
      std::swap(room.now, room.before);
    }
    takeOut(room, field);
  }

private:
  // Takes in the neighbours of the cells from `rim` on; answers where they begin.
  std::size_t grow(std::size_t rim, std::vector<std::uint32_t>& reached, FlowRoom& room) const {
    const std::size_t end = reached.size();
    for (std::size_t i = rim; i < end; ++i) {
      for (const std::uint32_t beside : neighbours_[reached[i]]) {
        if (room.isReached[beside] == 0) {
          room.isReached[beside] = 1;
          reached.push_back(beside);
        }
      }
    }
    return end;
  }

  [[nodiscard]] float flowInto(std::uint32_t cell, const std::vector<float>& now) const {
    float sum = 0.0F;
    for (const std::uint32_t beside : neighbours_[cell]) {
      sum += (rates_[cell] + rates_[beside]) * (now[beside] - now[cell]);
    }
    return 0.5F * sum;
  }

  static void takeOut(FlowRoom& room, JointField& field) {
    constexpr float unseen = 1e-6F;
    field.cells.clear();
    field.weights.clear();
    for (std::uint32_t cell = 0; cell < room.now.size(); ++cell) {
      if (room.isReached[cell] != 0) {
        if (room.now[cell] > unseen) {
          field.cells.push_back(cell);
          field.weights.push_back(room.now[cell]);
        }
        room.now[cell] = 0.0F;
        room.before[cell] = 0.0F;
        room.isReached[cell] = 0;
      }
    }
  }

  std::vector<Neighbours> neighbours_;
  std::vector<float> rates_;
};

// One field for each joint that owns a cell, ascending by joint.
std::vector<JointField> fieldsOf(const std::vector<BoneLine>& lines, const std::vector<CellOwner>& owners) {
  std::map<std::uint16_t, JointField> fields;
  for (std::uint32_t cell = 0; cell < owners.size(); ++cell) {
    const std::uint16_t joint = lines[owners[cell].line].joint;
    JointField& field = fields[joint];
    field.joint = joint;
    field.cells.push_back(cell);
    field.weights.push_back(1.0F);
  }
  std::vector<JointField> all;
  all.reserve(fields.size());
  for (auto& [joint, field] : fields) {
    all.push_back(std::move(field));
  }
  return all;
}

void add(std::uint16_t joint, float weight, CellWeights& row) {
  std::size_t slot = CellWeights::capacity;
  while (slot > 0 && row.weights[slot - 1] < weight) {
    --slot;
  }
  if (slot < CellWeights::capacity) {
    std::shift_right(row.joints.begin() + slot, row.joints.end(), 1);
    std::shift_right(row.weights.begin() + slot, row.weights.end(), 1);
    row.joints[slot] = joint;
    row.weights[slot] = weight;
  }
}

// The strongest joints of each cell.
std::vector<CellWeights> gathered(const std::vector<JointField>& fields, std::size_t cells) {
  std::vector<CellWeights> rows(cells);
  for (const JointField& field : fields) {
    for (std::size_t i = 0; i < field.cells.size(); ++i) {
      add(field.joint, field.weights[i], rows[field.cells[i]]);
    }
  }
  for (CellWeights& row : rows) {
    const float whole = std::accumulate(row.weights.begin(), row.weights.end(), 0.0F);
    for (float& weight : row.weights) {
      weight /= whole;
    }
  }
  return rows;
}

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
  std::vector<float> rates(owners.size());
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    const double part = radii[lines[owners[cell].line].joint] / widest;
    rates[cell] = static_cast<float>(fullRate * part * part);
  }
  const Flow flow(body, Borders(body, lines, ways, owners), std::move(rates));
  std::vector<JointField> fields = fieldsOf(lines, owners);
  tbb::enumerable_thread_specific<FlowRoom> rooms(owners.size());
  // A border that is hardly blended is blended step by step.
  constexpr int fewSteps = 60;
  const bool isFew = steps <= fewSteps;
  constexpr int stages = 5;
  constexpr double stepsOfStages = 0.5 * stages * (stages + 1);
  const int spans = isFew ? steps : static_cast<int>(std::ceil(steps / stepsOfStages));
  const FlowSpan span{isFew ? 1 : stages, static_cast<double>(steps) / spans};
  for (int done = 0; done < spans && (!proceed || proceed(static_cast<double>(done) / spans)); ++done) {
    tbb::parallel_for(std::size_t{0}, fields.size(),
                      [&](std::size_t i) { flow.over(span, fields[i], rooms.local()); });
  }
  return gathered(fields, owners.size());
}

} // namespace stretch::skinning
