#include "skinning/locate/leg_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "core/math/bounds.h"

namespace stretch::skinning {

namespace {

// The part of a region on one side of the middle; nothing where the two sides are one body and do not just
// touch each other.
std::optional<SliceRegion> sidePart(const StandingBody& body, const SliceRegion& region, double side) {
  if (side * (side > 0.0 ? region.low.x : region.high.x) > 0.0) {
    return region;
  }
  constexpr double touching = 0.5; // of the depth
  const double middle = 1.5 * body.cubes.grid.size;
  Bounds own;
  Bounds between;
  SliceRegion part;
  for (const std::uint32_t cell : region.cells) {
    const Vec3 place = body.middleOf(cell);
    if (std::abs(place.x) < middle) {
      between.add(place);
    }
    if (side * place.x > 0.0) {
      own.add(place);
      part.cells.push_back(cell);
      part.middle += place;
    }
  }
  const double depth = own.empty() ? 0.0 : own.high.z - own.low.z;
  if (own.empty() || (!between.empty() && between.high.z - between.low.z > touching * depth)) {
    return std::nullopt;
  }
  part.middle /= static_cast<double>(part.cells.size());
  part.low = own.low;
  part.high = own.high;
  return part;
}

LegSection sectionOf(const StandingBody& body, const SliceRegion& region) {
  const double size = body.cubes.grid.size;
  return {region.middle.y, region.middle, static_cast<double>(region.cells.size()) * size * size,
          region.high.z - region.middle.z, region.middle.z - region.low.z};
}

using Part = std::optional<SliceRegion>;

Part largestOnSide(const StandingBody& body, const std::vector<SliceRegion>& layer, double side) {
  Part best;
  for (const SliceRegion& region : layer) {
    Part part = sidePart(body, region, side);
    if (part && (!best || part->cells.size() > best->cells.size())) {
      best = std::move(part);
    }
  }
  return best;
}

double distanceAcross(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

// What goes on above a part of a leg: what lies over its middle, or else near it. Nothing where that has
// become one with the other leg.
Part above(const StandingBody& body, const SliceRegion& below, const std::vector<SliceRegion>& layer,
           double side, double near) {
  const SliceRegion* best = nullptr;
  double nearest = near;
  for (const SliceRegion& region : layer) {
    if (std::ranges::all_of(region.cells, [&](std::uint32_t cell) { return body.isBridge(cell); })) {
      continue;
    }
    const Vec3 within = glm::clamp(below.middle, region.low, region.high);
    const double distance =
        distanceAcross(below.middle, within) + 0.01 * distanceAcross(below.middle, region.middle);
    if (distance < nearest) {
      nearest = distance;
      best = &region;
    }
  }
  Part part = best == nullptr ? Part{} : sidePart(body, *best, side);
  return part && distanceAcross(part->middle, below.middle) < near ? std::move(part) : Part{};
}

using LegPair = std::pair<SliceRegion, SliceRegion>; // right, left

// Bones of a skeleton may have gaps between them, and thighs may touch each other: some layers may lack a
// leg.
std::vector<LegPair> risingFrom(const StandingBody& body, std::size_t first) {
  constexpr int widestGap = 14;
  constexpr double nearOnLeg = 0.06;
  constexpr double nearOverGap = 0.015;
  std::vector<LegPair> legs;
  Part right = largestOnSide(body, body.layers[first], -1.0);
  Part left = largestOnSide(body, body.layers[first], 1.0);
  if (!right || !left) {
    return legs;
  }
  legs.emplace_back(std::move(*right), std::move(*left));
  int gap = 0;
  for (std::size_t layer = first + 1; gap <= widestGap && layer < body.layers.size(); ++layer) {
    const double near = gap == 0 ? nearOnLeg : nearOverGap;
    right = above(body, legs.back().first, body.layers[layer], -1.0, near);
    left = above(body, legs.back().second, body.layers[layer], 1.0, near);
    gap = right && left ? 0 : gap + 1;
    if (right && left) {
      legs.emplace_back(std::move(*right), std::move(*left));
    }
  }
  return legs;
}

// Feet that touch each other: the half of a layer on each side.
LegPair halvesOf(const StandingBody& body, const std::vector<SliceRegion>& layer) {
  LegPair halves;
  for (SliceRegion* half : {&halves.first, &halves.second}) {
    const double side = half == &halves.first ? -1.0 : 1.0;
    Bounds box;
    for (const SliceRegion& region : layer) {
      for (const std::uint32_t cell : region.cells) {
        const Vec3 place = body.middleOf(cell);
        if (side * place.x > 0.0) {
          half->cells.push_back(cell);
          half->middle += place;
          box.add(place);
        }
      }
    }
    half->middle /= std::max<double>(1.0, static_cast<double>(half->cells.size()));
    half->low = box.low;
    half->high = box.high;
  }
  return halves;
}

std::vector<LegPair> withFeet(const StandingBody& body, std::size_t first, std::vector<LegPair> legs) {
  std::vector<LegPair> feet;
  for (std::size_t layer = 0; layer < first; ++layer) {
    LegPair halves = halvesOf(body, body.layers[layer]);
    if (!halves.first.cells.empty() && !halves.second.cells.empty()) {
      feet.push_back(std::move(halves));
    }
  }
  feet.insert(feet.end(), std::make_move_iterator(legs.begin()), std::make_move_iterator(legs.end()));
  return feet;
}

} // namespace

std::size_t legsUnder(const StandingBody& body) {
  constexpr double lowest = 0.04; // of the height: above feet and hoofs
  constexpr double highest = 0.15;
  constexpr double thin = 0.25; // of the cells of the thickest part
  std::vector<std::size_t> counts;
  for (const std::vector<SliceRegion>& layer : body.layers) {
    const double height = body.layerHeight(static_cast<std::size_t>(&layer - body.layers.data()));
    if (height < lowest || height > highest || layer.empty()) {
      continue;
    }
    std::vector<std::size_t> cells;
    cells.reserve(layer.size());
    for (const SliceRegion& region : layer) {
      cells.push_back(static_cast<std::size_t>(
          std::ranges::count_if(region.cells, [&](std::uint32_t cell) { return !body.isBridge(cell); })));
    }
    const auto least = thin * static_cast<double>(std::ranges::max(cells));
    counts.push_back(static_cast<std::size_t>(std::ranges::count_if(
        cells, [&](std::size_t count) { return static_cast<double>(count) >= least; })));
  }
  std::ranges::sort(counts);
  return counts.empty() ? 0 : counts[counts.size() / 2];
}

LegLines legLines(const StandingBody& body) {
  constexpr double highestStart = 0.12; // feet may touch each other, shins do not
  std::vector<LegPair> best;
  std::size_t lowest = 0;
  for (std::size_t layer = 0; layer < body.layers.size() && body.layerHeight(layer) < highestStart; ++layer) {
    std::vector<LegPair> legs = risingFrom(body, layer);
    if (legs.size() > best.size() + 2) {
      best = std::move(legs);
      lowest = layer;
    }
  }
  LegLines lines;
  lines.isLeg.assign(body.cubes.cellCount(), false);
  constexpr double shortest = 0.06;
  if (best.empty() || best.back().first.middle.y < shortest) {
    return lines;
  }
  best = withFeet(body, lowest, std::move(best));
  for (const auto& [right, left] : best) {
    lines.right.push_back(sectionOf(body, right));
    lines.left.push_back(sectionOf(body, left));
    for (const SliceRegion* region : {&right, &left}) {
      for (const std::uint32_t cell : region->cells) {
        lines.isLeg[cell] = true;
      }
    }
  }
  lines.crotch = lines.left.back().height + body.cubes.grid.size;
  return lines;
}

} // namespace stretch::skinning
