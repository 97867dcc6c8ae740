#include "skinning/sequence/topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/disjoint_sets.h"

namespace stretch::skinning {
namespace {

/// A side of a triangle, with the smaller vertex first.
struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  bool forward = false; ///< The triangle runs from low to high.
};

bool sameEdge(const Side& a, const Side& b) {
  return a.low == b.low && a.high == b.high;
}

bool isDegenerate(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// The sides of all proper triangles, sorted so that those of one edge stand together.
std::vector<Side> sortedSides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3 && !isDegenerate(triangles[t]); ++c) {
      const std::uint32_t from = triangles[t][c];
      const std::uint32_t to = triangles[t][(c + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(t), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

/// Calls use(first, last) for the run of sides of each edge.
template <typename Use>
void forEachEdge(const std::vector<Side>& sides, Use&& use) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sameEdge(sides[first], sides[last])) {
      ++last;
    }
    use(first, last);
    first = last;
  }
}

void countParts(std::size_t vertexCount, const std::vector<Triangle>& triangles, TopologyReport& report) {
  DisjointSets parts(vertexCount);
  std::vector<bool> used(vertexCount, false);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      used[corner] = true;
      parts.join(corner, triangle[0]);
    }
  }
  for (std::uint32_t v = 0; v < vertexCount; ++v) {
    report.looseVertices += used[v] ? 0 : 1;
    report.components += used[v] && parts.leaderOf(v) == v ? 1 : 0;
  }
}

std::size_t countDuplicates(std::span<const glm::vec3> positions) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t v) { return std::tie(positions[v].x, positions[v].y, positions[v].z); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t duplicates = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    duplicates += key(order[i]) == key(order[i - 1]) ? 1 : 0;
  }
  return duplicates;
}

struct Neighbour {
  std::uint32_t triangle = 0;
  bool windsAlike = false; ///< The two triangles run along their common edge in opposite directions, as they
                           ///< should.
};

std::vector<std::vector<Neighbour>> neighboursOf(const std::vector<Triangle>& triangles) {
  std::vector<std::vector<Neighbour>> neighbours(triangles.size());
  const std::vector<Side> sides = sortedSides(triangles);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2) {
      const Side& a = sides[first];
      const Side& b = sides[first + 1];
      neighbours[a.triangle].push_back({b.triangle, a.forward != b.forward});
      neighbours[b.triangle].push_back({a.triangle, a.forward != b.forward});
    }
  });
  return neighbours;
}

double signedVolume(std::span<const glm::vec3> positions, const Triangle& triangle, const Vec3& centre) {
  const Vec3 a = Vec3(positions[triangle[0]]) - centre;
  const Vec3 b = Vec3(positions[triangle[1]]) - centre;
  const Vec3 c = Vec3(positions[triangle[2]]) - centre;
  return glm::dot(a, glm::cross(b, c)) / 6.0;
}

/// Mean of the triangles' corners: the point towards which an open surface is closed.
Vec3 middleOf(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  Vec3 sum(0.0);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      sum += Vec3(positions[corner]);
    }
  }
  return triangles.empty() ? sum : sum / (3.0 * static_cast<double>(triangles.size()));
}

void line(std::vector<std::string>& lines, std::size_t count, const char* text) {
  if (count > 0) {
    lines.push_back(std::to_string(count) + " " + text);
  }
}

} // namespace

std::vector<std::string> TopologyReport::warnings() const {
  std::vector<std::string> lines;
  line(lines, components > 1 ? components : 0,
       "separate parts in the mesh: distances over the surface stop at their borders");
  line(lines, boundaryEdges,
       "boundary edges: the surface is open, volumes and shape diameters near them are estimates");
  line(lines, crowdedEdges, "edges with more than two triangles: the surface is cut open there");
  line(lines, degenerateTriangles, "triangles with a repeated corner are left out of all measures");
  line(lines, duplicatePositions, "vertices at the place of another vertex");
  line(lines, looseVertices, "vertices of no triangle");
  return lines;
}

std::vector<std::uint32_t> usedVertices(const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> used;
  for (const Triangle& triangle : triangles) {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

TopologyReport inspectTopology(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  TopologyReport report;
  const std::vector<Side> sides = sortedSides(triangles);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    report.boundaryEdges += last - first == 1 ? 1 : 0;
    report.crowdedEdges += last - first > 2 ? 1 : 0;
    report.unlikeEdges += last - first == 2 && sides[first].forward == sides[first + 1].forward ? 1 : 0;
  });
  report.degenerateTriangles =
      static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), isDegenerate));
  report.duplicatePositions = countDuplicates(positions);
  countParts(positions.size(), triangles, report);
  return report;
}

std::size_t orientOutwards(std::span<const glm::vec3> positions, std::vector<Triangle>& triangles) {
  const auto neighbours = neighboursOf(triangles);
  const Vec3 centre = middleOf(positions, triangles);
  std::vector<int> turned(triangles.size(), -1); // -1: not reached yet.
  std::size_t count = 0;
  for (std::uint32_t start = 0; start < triangles.size(); ++start) {
    if (turned[start] >= 0) {
      continue;
    }
    std::vector<std::uint32_t> part{start};
    turned[start] = 0;
    double volume = 0.0;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const std::uint32_t t = part[next];
      volume += (turned[t] == 1 ? -1.0 : 1.0) * signedVolume(positions, triangles[t], centre);
      for (const Neighbour& neighbour : neighbours[t]) {
        if (turned[neighbour.triangle] < 0) {
          turned[neighbour.triangle] = neighbour.windsAlike ? turned[t] : 1 - turned[t];
          part.push_back(neighbour.triangle);
        }
      }
    }
    for (const std::uint32_t t : part) {
      if ((turned[t] == 1) != (volume < 0.0)) {
        std::swap(triangles[t][1], triangles[t][2]);
        ++count;
      }
    }
  }
  return count;
}

double enclosedVolume(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  const Vec3 centre = middleOf(positions, triangles);
  double volume = 0.0;
  for (const Triangle& triangle : triangles) {
    volume += signedVolume(positions, triangle, centre);
  }
  return volume;
}

} // namespace stretch::skinning
