#include "skinning/bind/bind_weights.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include "skinning/bind/mirrored_weights.h"
#include "skinning/bind/points_behind.h"
#include "skinning/bind/skeleton_ways.h"
#include "skinning/bind/stiff_shells.h"
#include "skinning/bind/strange_patches.h"
#include "skinning/bind/voxel_body.h"
#include "skinning/bind/weight_blend.h"
#include "skinning/bind/weight_row.h"
#include "skinning/bind/welded.h"
#include "skinning/weights/geodesic_weights.h"

namespace stretch::skinning {

namespace {

// Cells that no bone reaches inside, those of shells of their own, go to the bone that is nearest in space.
void giveTheRest(const VoxelBody& body, const std::vector<BoneLine>& lines, const std::vector<double>& radii,
                 double sections, std::vector<CellOwner>& owners) {
  tbb::parallel_for(std::size_t{0}, owners.size(), [&](std::size_t cell) {
    if (owners[cell].line != CellOwner::nobody) {
      return;
    }
    const Vec3 middle = body.middleOf(cell);
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double along = nearestAlong(lines[i], middle);
      const double distance = glm::distance(middle, glm::mix(lines[i].start, lines[i].end, along));
      if (distance - sections * radii[lines[i].joint] < nearest) {
        nearest = distance - sections * radii[lines[i].joint];
        owners[cell] = {static_cast<std::uint32_t>(i), static_cast<float>(along),
                        static_cast<float>(distance)};
      }
    }
  });
}

void addCell(const CellWeights& cell, double factor, WeightSum& sum) {
  for (std::size_t i = 0; i < CellWeights::capacity; ++i) {
    sum.add(cell.joints[i], factor * static_cast<double>(cell.weights[i]));
  }
}

// What a point follows: between the middles of cells, those around it mixed.
Influences weightsAt(const VoxelBody& body, const std::vector<CellWeights>& cells, const Vec3& point) {
  WeightSum sum;
  const Vec3 local = (point - body.grid.origin) / body.grid.size - 0.5;
  const Vec3 base = glm::floor(local);
  bool isMet = false;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> place{};
    double factor = 1.0;
    bool isWithin = true;
    for (int axis = 0; axis < 3; ++axis) {
      const int side = (corner >> axis) & 1;
      const double part = local[axis] - base[axis];
      const double along = base[axis] + side;
      const auto i = static_cast<std::size_t>(axis);
      isWithin = isWithin && along >= 0.0 && along < body.grid.counts[i];
      place[i] = isWithin ? static_cast<int>(along) : 0;
      factor *= side == 1 ? part : 1.0 - part;
    }
    const std::int32_t cell = isWithin ? body.cellAt[body.grid.indexOf(place)] : VoxelBody::outside;
    if (cell != VoxelBody::outside && factor > 0.0) {
      addCell(cells[static_cast<std::size_t>(cell)], factor, sum);
      isMet = true;
    }
  }
  if (!isMet) {
    // A vertex of no triangle: nothing was filled where it is.
    constexpr int cubesAround = 3;
    const std::int32_t cell = body.cellNear(point, cubesAround);
    if (cell != VoxelBody::outside) {
      addCell(cells[static_cast<std::size_t>(cell)], 1.0, sum);
    }
  }
  return sum.strongest(Influences::capacity);
}

Status checkBinding(const std::vector<Triangle>& triangles, const std::vector<BindJoint>& joints) {
  if (joints.empty()) {
    return Error{"there are no joints to bind to", "", "give a skeleton"};
  }
  if (joints.size() > std::numeric_limits<std::uint16_t>::max()) {
    return Error{"more joints than a skin can name", "", "bind to fewer"};
  }
  return triangles.empty() ? Status(Error{"there is no triangle to bind", "", "give a mesh with faces"})
                           : Status(Success{});
}

Error stopped() {
  return {"the binding was stopped", "", "start it again"};
}

// The strongest four. Of equal ones of which only some have room none, so that no side is preferred, where
// the others are more than half of the whole.
void keepFour(std::vector<Influences>& weights) {
  tbb::parallel_for(std::size_t{0}, weights.size(), [&](std::size_t v) {
    const Influences& row = weights[v];
    const float cut = row.weights[mostInfluences];
    std::size_t kept = mostInfluences;
    while (cut > 0.0F && kept > 0 && row.weights[kept - 1] <= cut) {
      --kept;
    }
    const float left = std::accumulate(row.weights.begin(), row.weights.begin() + kept, 0.0F);
    WeightSum sum;
    sum.add(row, 1.0);
    weights[v] = sum.strongest(left > 0.5F ? kept : mostInfluences);
  });
}

std::size_t bytesOf(const VoxelBody& body) {
  constexpr std::size_t surfaceReachedAndVotes = 3;
  constexpr std::size_t neighboursAndRates = 7 * sizeof(float);
  return body.grid.cubeCount() * (sizeof(std::int32_t) + surfaceReachedAndVotes) +
         body.cellCount() * (2 * sizeof(CellWeights) + sizeof(CellOwner) + neighboursAndRates +
                             sizeof(double) + sizeof(float) + sizeof(std::uint32_t));
}

// Whether two triangles meet at every edge, wound alike; how many edges are otherwise.
std::size_t unclosedEdges(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& welded) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> ways; // forth and back
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = welded[triangle[i]];
      const std::uint32_t to = welded[triangle[(i + 1) % 3]];
      if (from != to) {
        auto& [forth, back] = ways[{std::min(from, to), std::max(from, to)}];
        ++(from < to ? forth : back);
      }
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(ways, [](const auto& edge) { return edge.second != std::pair(1, 1); }));
}

} // namespace

Result<BoundBody> bindWeights(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                              const std::vector<BindJoint>& joints, const BindSettings& settings,
                              const Proceed& proceed) {
  if (Status usable = checkBinding(triangles, joints); !usable) {
    return usable.error();
  }
  const auto goesOn = [&](double share) { return !proceed || proceed(share); };
  const Result<VoxelBody> body = voxelBody(positions, triangles, settings.cubesAlong);
  if (!body) {
    return body.error();
  }
  constexpr double filled = 0.2; // of the work, about
  constexpr double blended = 0.8;
  if (!goesOn(filled)) {
    return stopped();
  }
  const std::vector<BoneLine> lines = boneLines(*body, joints);
  const SkeletonWays ways(joints, lines);
  const std::vector<BoneCell> bones = boneCells(*body, lines);
  const std::vector<double> radii = boneRadii(*body, lines, bones, joints.size());
  std::vector<CellOwner> owners = boneRegions(*body, lines, bones, radii, settings.sections);
  giveTheRest(*body, lines, radii, settings.sections, owners);
  const std::vector<CellWeights> cells =
      blendedRegions(*body, lines, ways, owners, radii, settings.blend,
                     [&](double share) { return goesOn(filled + share * (blended - filled)); });
  if (!goesOn(blended)) {
    return stopped();
  }
  BoundBody bound;
  bound.cubes = body->cellCount();
  bound.bytes = bytesOf(*body);
  bound.influences.resize(positions.size());
  const std::vector<std::uint32_t> welded = weldedVertices(positions);
  const std::vector<Vec3> behind = pointsBehind(*body, positions, triangles, welded);
  tbb::parallel_for(std::size_t{0}, positions.size(),
                    [&](std::size_t v) { bound.influences[v] = weightsAt(*body, cells, behind[v]); });
  dropStrangers(positions, lines, ways, bound.influences);
  takeInPatches(triangles, welded, joints, bound.influences);
  mirrorWeights(positions, joints, bound.influences);
  stiffenShells(positions, triangles, welded, lines, joints.size(), bound.influences); // each as one piece
  keepFour(bound.influences);
  return goesOn(1.0) ? Result<BoundBody>(std::move(bound)) : Result<BoundBody>(stopped());
}

Result<BoundBody> bindWeightsOnSurface(std::span<const glm::vec3> positions,
                                       const std::vector<Triangle>& triangles,
                                       const std::vector<BindJoint>& joints) {
  if (Status usable = checkBinding(triangles, joints); !usable) {
    return usable.error();
  }
  const std::vector<std::uint32_t> welded = weldedVertices(positions);
  if (const std::size_t edges = unclosedEdges(triangles, welded); edges > 0) {
    return Error{
        fmt::format("the surface is not closed: {} of its edges do not lie between two triangles", edges), "",
        "bind by the volume instead"};
  }
  std::vector<Triangle> whole;
  whole.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    whole.push_back({welded[t[0]], welded[t[1]], welded[t[2]]});
  }
  const std::vector<BoneLine> lines = boneLines(joints, [](const Vec3& place, const Vec3& along) {
    return place + 0.5 * along; // half as long as the bone before
  });
  std::vector<BoneSegment> segments;
  segments.reserve(lines.size());
  for (const BoneLine& line : lines) {
    segments.push_back({line.start, line.end});
  }
  const Result<std::vector<Influences>> byLine = geodesicWeights(positions, whole, segments);
  if (!byLine) {
    return byLine.error();
  }
  BoundBody bound;
  bound.influences.resize(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Influences& row = (*byLine)[welded[v]];
    WeightSum sum;
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      sum.add(lines[row.bones[i]].joint, static_cast<double>(row.weights[i]));
    }
    bound.influences[v] = sum.strongest(Influences::capacity);
  }
  mirrorWeights(positions, joints, bound.influences);
  keepFour(bound.influences);
  return bound;
}

} // namespace stretch::skinning
