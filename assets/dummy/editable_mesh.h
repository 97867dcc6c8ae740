#pragma once

#include "assets/dummy/surface_mesh.h"

namespace stretch::assets {

/// An edge by its two vertices, the smaller index first.
using Edge = std::array<int, 2>;

/// A closed manifold triangle mesh whose connectivity can be edited in place. Triangles that an operation
/// removes stay in the list, dead, until `compact`.
class EditableMesh {
public:
  explicit EditableMesh(const SurfaceMesh& mesh);

  [[nodiscard]] SurfaceMesh compact() const;

  [[nodiscard]] std::vector<Edge> edges() const; ///< Each once, ascending.
  [[nodiscard]] bool isEdge(const Edge& edge) const;
  [[nodiscard]] int vertexCount() const { return static_cast<int>(positions_.size()); }
  [[nodiscard]] bool isAlive(int vertex) const { return !trianglesOf_[index(vertex)].empty(); }
  [[nodiscard]] const Vec3& position(int vertex) const { return positions_[index(vertex)]; }
  void setPosition(int vertex, const Vec3& position) { positions_[index(vertex)] = position; }
  [[nodiscard]] double length(const Edge& edge) const;
  [[nodiscard]] int valence(int vertex) const { return static_cast<int>(trianglesOf_[index(vertex)].size()); }
  [[nodiscard]] std::vector<int> neighbours(int vertex) const; ///< Ascending.

  /// The two vertices across an edge.
  [[nodiscard]] std::array<int, 2> opposite(const Edge& edge) const;

  /// Puts a vertex on the edge; the two triangles become four. Returns the new vertex.
  int split(const Edge& edge, const Vec3& position);

  /// Whether merging the edge's ends to `position` keeps the mesh manifold and turns no triangle over.
  [[nodiscard]] bool canCollapse(const Edge& edge, const Vec3& position) const;
  /// Merges the second end into the first, placed at `position`.
  void collapse(const Edge& edge, const Vec3& position);

  /// Whether the edge may be replaced by the one between its opposite vertices without folding the surface.
  [[nodiscard]] bool canFlip(const Edge& edge) const;
  void flip(const Edge& edge);

private:
  using Triangle = std::array<int, 3>;

  [[nodiscard]] static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] std::vector<int> trianglesOfEdge(const Edge& edge) const;
  [[nodiscard]] Vec3 areaVector(const Triangle& triangle) const;
  [[nodiscard]] bool staysUpright(int moved, int other, const Vec3& position) const;
  void attach(int triangle);
  void detach(int triangle);
  void replace(int triangle, int from, int to);
  int add(const Triangle& triangle);

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<int>> trianglesOf_; ///< Of each vertex.
};

} // namespace stretch::assets
