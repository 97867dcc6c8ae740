// Meshes by chance: what is odd about them, how they are wound and what they enclose, counted the slow way.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "skinning/sequence/topology.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

bool isProper(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// For each edge the triangles that have it, as +1 where they run from the smaller vertex on.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<int>>
edgesOf(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<int>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3 && isProper(t); ++c) {
      const std::uint32_t from = t[c];
      const std::uint32_t to = t[(c + 1) % 3];
      edges[std::minmax(from, to)].push_back(from < to ? 1 : -1);
    }
  }
  return edges;
}

std::size_t partsOf(std::size_t vertices, const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> part(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    part[v] = v;
  }
  std::set<std::size_t> used;
  for (std::size_t round = 0; round < vertices; ++round) {
    for (const Triangle& t : triangles) {
      const std::size_t least = std::min({part[t[0]], part[t[1]], part[t[2]]});
      part[t[0]] = part[t[1]] = part[t[2]] = least;
    }
  }
  for (const Triangle& t : triangles) {
    used.insert(part[t[0]]);
  }
  return used.size();
}

} // namespace

TEST_CASE("What is odd about the triangles of a mesh is counted as by going over all pairs") {
  std::mt19937 chance(51);
  for (int round = 0; round < 60; ++round) {
    const std::size_t vertices = 4 + chance() % 12;
    std::vector<glm::vec3> places;
    for (std::size_t v = 0; v < vertices; ++v) {
      places.emplace_back(chance() % 3, chance() % 3, chance() % 2);
    }
    std::vector<Triangle> triangles;
    for (std::size_t t = chance() % 20; t > 0; --t) {
      triangles.push_back({static_cast<std::uint32_t>(chance() % vertices),
                           static_cast<std::uint32_t>(chance() % vertices),
                           static_cast<std::uint32_t>(chance() % vertices)});
    }
    const TopologyReport report = inspectTopology(places, triangles);
    std::size_t open = 0;
    std::size_t crowded = 0;
    std::size_t unlike = 0;
    for (const auto& [edge, runs] : edgesOf(triangles)) {
      open += runs.size() == 1 ? 1 : 0;
      crowded += runs.size() > 2 ? 1 : 0;
      unlike += runs.size() == 2 && runs[0] == runs[1] ? 1 : 0;
    }
    std::size_t duplicates = 0;
    std::size_t loose = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
      duplicates += std::find(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(v), places[v]) !=
                            places.begin() + static_cast<std::ptrdiff_t>(v)
                        ? 1
                        : 0;
      loose +=
          std::ranges::none_of(triangles, [&](const Triangle& t) { return std::ranges::count(t, v) > 0; })
              ? 1
              : 0;
    }
    CAPTURE(round);
    CHECK(report.boundaryEdges == open);
    CHECK(report.crowdedEdges == crowded);
    CHECK(report.unlikeEdges == unlike);
    CHECK(report.degenerateTriangles == static_cast<std::size_t>(std::ranges::count_if(
                                            triangles, [](const Triangle& t) { return !isProper(t); })));
    CHECK(report.duplicatePositions == duplicates);
    CHECK(report.looseVertices == loose);
    CHECK(report.components == partsOf(vertices, triangles));
  }
}

TEST_CASE("Each oddity of a mesh has its line, in one order, and a single part none") {
  TopologyReport report;
  CHECK(report.warnings().empty());
  report.components = 1;
  report.unlikeEdges = 9;
  CHECK(report.warnings().empty());
  report = {2, 3, 4, 0, 5, 6, 7};
  CHECK(report.warnings() ==
        std::vector<std::string>{
            "2 separate parts in the mesh: distances over the surface stop at their borders",
            "3 boundary edges: the surface is open, volumes and shape diameters near them are estimates",
            "4 edges with more than two triangles: the surface is cut open there",
            "5 triangles with a repeated corner are left out of all measures",
            "6 vertices at the place of another vertex", "7 vertices of no triangle"});
}

TEST_CASE("Triangles that were turned by chance are wound outwards again, each part by itself") {
  std::mt19937 chance(52);
  test::Shape body = test::sphere(2);
  const test::Shape box = test::box({2, 3, 1}, 0.5);
  const auto first = static_cast<std::uint32_t>(body.positions.size());
  for (const glm::vec3& place : box.positions) {
    body.positions.push_back(place + glm::vec3(5.0F, 1.0F, 0.0F));
  }
  for (const Triangle& t : box.triangles) {
    body.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const double volume = enclosedVolume(body.positions, body.triangles);
  CHECK(volume == Approx(0.75 + 4.0 / 3.0 * pi).epsilon(0.06));
  for (int round = 0; round < 10; ++round) {
    std::vector<Triangle> triangles = body.triangles;
    std::size_t turned = 0;
    for (Triangle& t : triangles) {
      if (chance() % 2 == 0 || round == 0) {
        std::swap(t[1], t[2]);
        ++turned;
      }
    }
    CHECK(orientOutwards(body.positions, triangles) == turned);
    CHECK(enclosedVolume(body.positions, triangles) == Approx(volume));
    CHECK(inspectTopology(body.positions, triangles).unlikeEdges == 0);
  }
  std::vector<Triangle> sound = body.triangles;
  CHECK(orientOutwards(body.positions, sound) == 0);
  CHECK(sound == body.triangles);
}

TEST_CASE("An open surface encloses what it would, closed towards its middle") {
  const test::Shape box = test::box({2, 2, 2}, 1.0);
  std::vector<Triangle> open = box.triangles;
  std::erase_if(open, [&](const Triangle& t) { // without its lid
    return box.positions[t[0]].y == 2.0F && box.positions[t[1]].y == 2.0F && box.positions[t[2]].y == 2.0F;
  });
  Vec3 middle(0.0);
  for (const Triangle& t : open) {
    for (const std::uint32_t corner : t) {
      middle += Vec3(box.positions[corner]) / (3.0 * static_cast<double>(open.size()));
    }
  }
  CHECK(middle.y < 1.0);
  CHECK(enclosedVolume(box.positions, open) == Approx(8.0 - 4.0 * (2.0 - middle.y) / 3.0));
  CHECK(enclosedVolume(box.positions, {}) == 0.0);
}
