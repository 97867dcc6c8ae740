#include "skinning/geometry/geodesic_distance.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/check.h"

#include "skinning/geometry/half_edge_mesh.h"

namespace stretch::skinning {

namespace {

/// `target` can be reached from the edge between `first` and `second`, all laid into one plane.
struct Stencil {
  std::uint32_t target = 0;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  double toFirst = 0.0;  ///< |target - first|
  double toSecond = 0.0; ///< |target - second|
  double base = 0.0;     ///< |first - second|
};

} // namespace

struct GeodesicSolver::Stencils {
  std::size_t vertexCount = 0;
  std::vector<Stencil> all;
  std::vector<std::uint32_t> firstOf; ///< Range of `uses` of each vertex.
  std::vector<std::uint32_t> uses;    ///< Indices of the stencils that a vertex feeds.
};

namespace {

Vec3 toVec3(const HalfEdges::Point& p) {
  return {p[0], p[1], p[2]};
}

/// A point of the plane into which triangles are unfolded: the vertex to be split at the origin.
struct Flat {
  HalfEdges::VertexHandle vertex;
  Vec2 at{0.0};
};

/// Where the far corner of a triangle lies beyond the edge a-b, seen from the origin.
Vec2 unfold(const Vec2& a, const Vec2& b, double toA, double toB) {
  const Vec2 along = b - a;
  const double base = glm::length(along);
  const double x = (toA * toA - toB * toB + base * base) / (2.0 * base);
  const double y = std::sqrt(std::max(0.0, toA * toA - x * x));
  const Vec2 direction = along / base;
  const Vec2 normal(direction.y,
                    -direction.x); // To the right of a -> b: away from the origin when it lies to the left.
  const double side = glm::dot(normal, a) >= 0.0 ? 1.0 : -1.0;
  return a + x * direction + side * y * normal;
}

Stencil makeStencil(const HalfEdgeMesh& mesh, HalfEdges::VertexHandle target, const Flat& a, const Flat& b) {
  const auto name = [&](HalfEdges::VertexHandle v) {
    return mesh.original[static_cast<std::size_t>(v.idx())];
  };
  return {name(target),      name(a.vertex),    name(b.vertex),
          glm::length(a.at), glm::length(b.at), glm::length(a.at - b.at)};
}

/// For an obtuse corner: unfolds the triangles beyond its far edge until a vertex lies within the right
/// angles of both sides, and adds the two stencils that this vertex makes. Gives up at a boundary or after a
/// few triangles.
void addUnfolded(const HalfEdgeMesh& mesh, HalfEdges::VertexHandle target, HalfEdges::HalfedgeHandle farEdge,
                 Flat a, Flat b, std::vector<Stencil>& stencils) {
  constexpr int mostTriangles = 24;
  const Flat firstSide = a;
  const Flat secondSide = b;
  for (int i = 0; i < mostTriangles; ++i) {
    const HalfEdges::HalfedgeHandle beyond = mesh.edges.opposite_halfedge_handle(farEdge);
    if (mesh.edges.is_boundary(beyond)) {
      return;
    }
    Flat c{mesh.edges.to_vertex_handle(mesh.edges.next_halfedge_handle(beyond)), {}};
    const Vec3 corner = toVec3(mesh.edges.point(c.vertex));
    c.at = unfold(a.at, b.at, glm::length(corner - toVec3(mesh.edges.point(a.vertex))),
                  glm::length(corner - toVec3(mesh.edges.point(b.vertex))));
    const bool insideFirst = glm::dot(c.at, firstSide.at) > 0.0;
    const bool insideSecond = glm::dot(c.at, secondSide.at) > 0.0;
    if (insideFirst && insideSecond) {
      stencils.push_back(makeStencil(mesh, target, firstSide, c));
      stencils.push_back(makeStencil(mesh, target, c, secondSide));
      return;
    }
    // farEdge runs a -> b, so beyond runs b -> a and its triangle continues a -> c -> b.
    const HalfEdges::HalfedgeHandle fromA = mesh.edges.next_halfedge_handle(beyond);
    if (insideFirst) {
      farEdge = mesh.edges.next_halfedge_handle(fromA); // c lies too near the first side: on through c -> b.
      a = c;
    } else {
      farEdge = fromA; // a -> c.
      b = c;
    }
  }
}

std::vector<Stencil> makeStencils(const HalfEdgeMesh& mesh) {
  std::vector<Stencil> stencils;
  for (const HalfEdges::FaceHandle face : mesh.edges.faces()) {
    for (const HalfEdges::HalfedgeHandle edge : mesh.edges.fh_range(face)) {
      const HalfEdges::VertexHandle from = mesh.edges.from_vertex_handle(edge);
      const HalfEdges::VertexHandle to = mesh.edges.to_vertex_handle(edge);
      const HalfEdges::VertexHandle target =
          mesh.edges.to_vertex_handle(mesh.edges.next_halfedge_handle(edge));
      const Vec3 origin = toVec3(mesh.edges.point(target));
      const Vec3 toFrom = toVec3(mesh.edges.point(from)) - origin;
      const Vec3 toTo = toVec3(mesh.edges.point(to)) - origin;
      const double lengthFrom = glm::length(toFrom);
      const double lengthTo = glm::length(toTo);
      if (!(lengthFrom > 0.0 && lengthTo > 0.0 && glm::length(toTo - toFrom) > 0.0)) {
        continue;
      }
      const double cosine = std::clamp(glm::dot(toFrom, toTo) / (lengthFrom * lengthTo), -1.0, 1.0);
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const Flat a{from, Vec2(lengthFrom, 0.0)};
      const Flat b{to, lengthTo * Vec2(cosine, sine)};
      stencils.push_back(makeStencil(mesh, target, a, b));
      if (cosine < -1e-9 && sine > 1e-6) {
        addUnfolded(mesh, target, edge, a, b, stencils);
      }
    }
  }
  return stencils;
}

/// Distance at the target that the distances at both ends of the base lead to.
double throughBase(const Stencil& s, double first, double second) {
  const double alongEdges = std::min(first + s.toFirst, second + s.toSecond);
  const double base = s.base;
  // The target above the base line: first end at the origin, second at (base, 0).
  const double x = (s.toFirst * s.toFirst - s.toSecond * s.toSecond + base * base) / (2.0 * base);
  const double y = std::sqrt(std::max(0.0, s.toFirst * s.toFirst - x * x));
  if (std::abs(first - second) >= base) {
    return alongEdges;
  }
  if (first + second <= base * (1.0 + 1e-9)) {
    // No single point explains two such small distances: a straight front that leaves the base at its own
    // slope.
    const double slope = (second - first) / base;
    const double rise = std::sqrt(1.0 - slope * slope);
    const double foot = x - y * slope / rise;
    return foot >= 0.0 && foot <= base ? first + slope * x + rise * y : alongEdges;
  }
  const double sourceX = (first * first - second * second + base * base) / (2.0 * base);
  const double sourceY = -std::sqrt(std::max(0.0, first * first - sourceX * sourceX));
  const double crossing = sourceX + (x - sourceX) * (-sourceY) / (y - sourceY);
  if (!(y - sourceY > 0.0) || crossing < 0.0 || crossing > base) {
    return alongEdges;
  }
  return std::hypot(x - sourceX, y - sourceY);
}

} // namespace

GeodesicSolver::GeodesicSolver(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  const HalfEdgeMesh mesh = buildHalfEdges(positions, triangles);
  auto stencils = std::make_unique<Stencils>();
  stencils->vertexCount = positions.size();
  stencils->all = makeStencils(mesh);
  stencils->firstOf.assign(positions.size() + 1, 0);
  for (const Stencil& s : stencils->all) {
    ++stencils->firstOf[s.first + 1];
    ++stencils->firstOf[s.second + 1];
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    stencils->firstOf[v + 1] += stencils->firstOf[v];
  }
  stencils->uses.resize(stencils->firstOf.back());
  std::vector<std::uint32_t> next(stencils->firstOf.begin(), stencils->firstOf.end() - 1);
  for (std::uint32_t i = 0; i < stencils->all.size(); ++i) {
    stencils->uses[next[stencils->all[i].first]++] = i;
    stencils->uses[next[stencils->all[i].second]++] = i;
  }
  stencils_ = std::move(stencils);
}

GeodesicSolver::~GeodesicSolver() = default;
GeodesicSolver::GeodesicSolver(GeodesicSolver&&) noexcept = default;
GeodesicSolver& GeodesicSolver::operator=(GeodesicSolver&&) noexcept = default;

std::vector<double> GeodesicSolver::distances(const std::vector<std::uint32_t>& sources, double limit) const {
  constexpr double unreached = std::numeric_limits<double>::infinity();
  const Stencils& stencils = *stencils_;
  std::vector<double> distance(stencils.vertexCount, unreached);
  std::vector<bool> settled(stencils.vertexCount, false);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::uint32_t source : sources) {
    check(source < stencils.vertexCount, "a source of distances is a vertex of the mesh");
    distance[source] = 0.0;
    queue.emplace(0.0, source);
  }
  while (!queue.empty()) {
    const auto [reached, vertex] = queue.top();
    queue.pop();
    if (settled[vertex] || reached > distance[vertex]) {
      continue;
    }
    settled[vertex] = true;
    for (std::uint32_t i = stencils.firstOf[vertex]; i < stencils.firstOf[vertex + 1]; ++i) {
      const Stencil& s = stencils.all[stencils.uses[i]];
      if (settled[s.target]) {
        continue;
      }
      const bool isFirst = s.first == vertex;
      const std::uint32_t other = isFirst ? s.second : s.first;
      const double found = settled[other] ? throughBase(s, distance[s.first], distance[s.second])
                                          : reached + (isFirst ? s.toFirst : s.toSecond);
      if (found < distance[s.target] && found <= limit) {
        distance[s.target] = found;
        queue.emplace(found, s.target);
      }
    }
  }
  for (std::size_t v = 0; v < distance.size(); ++v) {
    distance[v] = settled[v] ? distance[v] : unreached;
  }
  return distance;
}

} // namespace stretch::skinning
