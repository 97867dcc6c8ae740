#include "skinning/locate/creature/body_branches.h"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.h"
#include "skinning/bind/voxel_ways.h"

namespace stretch::skinning {

namespace {

constexpr int noEnd = -1;    // grows on what it touches
constexpr int severals = -2; // where what belongs to several ends has met

// What a cell belongs to that touches others.
int together(int one, int other) {
  return one == noEnd ? other : other == noEnd || one == other ? one : severals;
}

} // namespace

std::vector<BodyBranch> branchesOf(const StandingBody& body, const std::vector<double>& ways,
                                   const std::vector<BodyEnd>& ends) {
  const InwardOrder inwards = inwardOrder(ways); // the farthest cell leads a heap
  const std::vector<std::size_t>& order = inwards.cells;
  const std::vector<std::size_t>& places = inwards.places;
  std::vector<int> owners(order.size(), noEnd); // of the leaders of heaps, by their places in the order
  for (std::size_t end = 0; end < ends.size(); ++end) {
    owners[places[ends[end].cell]] = static_cast<int>(end);
  }
  DisjointSets heaps(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    std::vector<std::size_t> touched;
    int owner = owners[place];
    eachNeighbour(body.cubes, order[place], [&](std::size_t next, std::size_t) {
      if (places[next] < place) {
        touched.push_back(heaps.leaderOf(places[next]));
        owner = together(owner, owners[touched.back()]);
      }
    });
    owners[place] = owner;
    for (const std::size_t heap : touched) {
      if (owner != severals) {
        heaps.join(place, heap);
      }
    }
    owners[heaps.leaderOf(place)] = owner;
  }
  std::vector<BodyBranch> branches(ends.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    if (const int owner = owners[heaps.leaderOf(place)]; owner >= 0) {
      branches[static_cast<std::size_t>(owner)].cells.push_back(static_cast<std::uint32_t>(order[place]));
    }
  }
  for (std::size_t end = 0; end < ends.size(); ++end) {
    branches[end].tip = ends[end].cell;
  }
  return branches;
}

std::vector<BranchSection> sectionsOf(const StandingBody& body, const std::vector<std::uint32_t>& cells,
                                      const std::vector<double>& fromTip) {
  const double size = body.cubes.grid.size;
  const double step = 2.0 * size;
  std::vector<BranchSection> sections;
  std::vector<double> counts;
  for (const std::uint32_t cell : cells) {
    const auto section = static_cast<std::size_t>(std::max(fromTip[cell], 0.0) / step);
    sections.resize(std::max(sections.size(), section + 1));
    counts.resize(sections.size(), 0.0);
    sections[section].middle += body.middleOf(cell);
    counts[section] += 1.0;
  }
  std::vector<BranchSection> filled;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (counts[i] > 0.0) {
      filled.push_back(
          {sections[i].middle / counts[i], std::sqrt(counts[i] * size * size * size / step / pi)});
    }
  }
  return filled;
}

} // namespace stretch::skinning
