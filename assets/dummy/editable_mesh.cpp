#include "assets/dummy/editable_mesh.h"

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>

#include "core/base/check.h"

namespace stretch::assets {

namespace {

bool contains(const std::array<int, 3>& triangle, int vertex) {
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

/// The triangle's vertex that is on neither end of the edge.
int third(const std::array<int, 3>& triangle, const Edge& edge) {
  return *std::find_if(triangle.begin(), triangle.end(), [&](int v) { return v != edge[0] && v != edge[1]; });
}

/// Whether the triangle runs through the edge from its first vertex to its second.
bool runsAlong(const std::array<int, 3>& triangle, const Edge& edge) {
  const auto at =
      static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), edge[0]) - triangle.begin());
  return triangle[(at + 1) % 3] == edge[1];
}

} // namespace

EditableMesh::EditableMesh(const SurfaceMesh& mesh)
    : positions_(mesh.positions), triangles_(mesh.triangles), trianglesOf_(mesh.positions.size()) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    attach(static_cast<int>(t));
  }
}

void EditableMesh::attach(int triangle) {
  for (const int vertex : triangles_[index(triangle)]) {
    trianglesOf_[index(vertex)].push_back(triangle);
  }
}

void EditableMesh::detach(int triangle) {
  for (const int vertex : triangles_[index(triangle)]) {
    std::erase(trianglesOf_[index(vertex)], triangle);
  }
  triangles_[index(triangle)] = {-1, -1, -1};
}

void EditableMesh::replace(int triangle, int from, int to) {
  Triangle changed = triangles_[index(triangle)];
  std::replace(changed.begin(), changed.end(), from, to);
  detach(triangle);
  triangles_[index(triangle)] = changed;
  attach(triangle);
}

int EditableMesh::add(const Triangle& triangle) {
  triangles_.push_back(triangle);
  attach(static_cast<int>(triangles_.size()) - 1);
  return static_cast<int>(triangles_.size()) - 1;
}

SurfaceMesh EditableMesh::compact() const {
  SurfaceMesh mesh;
  std::vector<int> renumbered(positions_.size(), -1);
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    if (!trianglesOf_[v].empty()) {
      renumbered[v] = static_cast<int>(mesh.positions.size());
      mesh.positions.push_back(positions_[v]);
    }
  }
  for (const Triangle& triangle : triangles_) {
    if (triangle[0] >= 0) {
      mesh.triangles.push_back(
          {renumbered[index(triangle[0])], renumbered[index(triangle[1])], renumbered[index(triangle[2])]});
    }
  }
  return mesh;
}

std::vector<Edge> EditableMesh::edges() const {
  std::vector<Edge> all;
  for (const Triangle& triangle : triangles_) {
    for (std::size_t corner = 0; corner < 3 && triangle[0] >= 0; ++corner) {
      const int a = triangle[corner];
      const int b = triangle[(corner + 1) % 3];
      if (a < b) {
        all.push_back({a, b});
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

bool EditableMesh::isEdge(const Edge& edge) const {
  return !trianglesOfEdge(edge).empty();
}

double EditableMesh::length(const Edge& edge) const {
  return glm::length(position(edge[0]) - position(edge[1]));
}

std::vector<int> EditableMesh::neighbours(int vertex) const {
  std::vector<int> all;
  for (const int triangle : trianglesOf_[index(vertex)]) {
    for (const int other : triangles_[index(triangle)]) {
      if (other != vertex) {
        all.push_back(other);
      }
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<int> EditableMesh::trianglesOfEdge(const Edge& edge) const {
  std::vector<int> found;
  for (const int triangle : trianglesOf_[index(edge[0])]) {
    if (contains(triangles_[index(triangle)], edge[1])) {
      found.push_back(triangle);
    }
  }
  return found;
}

std::array<int, 2> EditableMesh::opposite(const Edge& edge) const {
  const std::vector<int> sides = trianglesOfEdge(edge);
  check(sides.size() == 2, "the mesh is not closed");
  return {third(triangles_[index(sides[0])], edge), third(triangles_[index(sides[1])], edge)};
}

Vec3 EditableMesh::areaVector(const Triangle& triangle) const {
  const Vec3& a = position(triangle[0]);
  return glm::cross(position(triangle[1]) - a, position(triangle[2]) - a);
}

int EditableMesh::split(const Edge& edge, const Vec3& position) {
  const int middle = vertexCount();
  positions_.push_back(position);
  trianglesOf_.emplace_back();
  for (const int triangle : trianglesOfEdge(edge)) {
    Triangle second = triangles_[index(triangle)];
    std::replace(second.begin(), second.end(), edge[0], middle);
    replace(triangle, edge[1], middle);
    add(second);
  }
  return middle;
}

bool EditableMesh::staysUpright(int moved, int other, const Vec3& position) const {
  for (const int t : trianglesOf_[index(moved)]) {
    const Triangle& triangle = triangles_[index(t)];
    if (contains(triangle, other)) {
      continue;
    }
    const auto corner =
        static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), moved) - triangle.begin());
    const Vec3& b = positions_[index(triangle[(corner + 1) % 3])];
    const Vec3& c = positions_[index(triangle[(corner + 2) % 3])];
    const Vec3 before = areaVector(triangle);
    const Vec3 after = glm::cross(b - position, c - position);
    const double turn = glm::dot(before, after);
    if (turn <= 0.5 * glm::length(before) * glm::length(after)) {
      return false;
    }
  }
  return true;
}

bool EditableMesh::canCollapse(const Edge& edge, const Vec3& position) const {
  const std::vector<int> first = neighbours(edge[0]);
  const std::vector<int> second = neighbours(edge[1]);
  std::vector<int> shared;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(shared));
  if (shared.size() != 2 || valence(shared[0]) <= 3 || valence(shared[1]) <= 3) {
    return false;
  }
  return staysUpright(edge[0], edge[1], position) && staysUpright(edge[1], edge[0], position);
}

void EditableMesh::collapse(const Edge& edge, const Vec3& position) {
  for (const int triangle : trianglesOfEdge(edge)) {
    detach(triangle);
  }
  const std::vector<int> rest = trianglesOf_[index(edge[1])];
  for (const int triangle : rest) {
    replace(triangle, edge[1], edge[0]);
  }
  positions_[index(edge[0])] = position;
}

bool EditableMesh::canFlip(const Edge& edge) const {
  const std::vector<int> sides = trianglesOfEdge(edge);
  const std::array<int, 2> across = opposite(edge);
  if (across[0] == across[1] || isEdge(across) || valence(edge[0]) <= 3 || valence(edge[1]) <= 3) {
    return false;
  }
  const Vec3 before = areaVector(triangles_[index(sides[0])]) + areaVector(triangles_[index(sides[1])]);
  const bool along = runsAlong(triangles_[index(sides[0])], edge);
  const int left = along ? across[0] : across[1];
  const int right = along ? across[1] : across[0];
  const Vec3 one = areaVector({left, edge[0], right});
  const Vec3 two = areaVector({right, edge[1], left});
  const auto upright = [&](const Vec3& area) {
    return glm::dot(area, before) > 0.5 * glm::length(area) * glm::length(before);
  };
  return upright(one) && upright(two);
}

void EditableMesh::flip(const Edge& edge) {
  const std::vector<int> sides = trianglesOfEdge(edge);
  const std::array<int, 2> across = opposite(edge);
  const bool along = runsAlong(triangles_[index(sides[0])], edge);
  const int left = along ? across[0] : across[1];
  const int right = along ? across[1] : across[0];
  detach(sides[0]);
  detach(sides[1]);
  add({left, edge[0], right});
  add({right, edge[1], left});
}

} // namespace stretch::assets
