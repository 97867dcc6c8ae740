#include "ui/render/scene/thinned_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

double areaOf(const Primitive& primitive) {
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const glm::vec3& a = primitive.positions[primitive.indices[i]];
    const glm::vec3& b = primitive.positions[primitive.indices[i + 1]];
    const glm::vec3& c = primitive.positions[primitive.indices[i + 2]];
    area += 0.5 * static_cast<double>(glm::length(glm::cross(b - a, c - a)));
  }
  return std::isfinite(area) ? area : 0.0;
}

std::uint32_t leadingJoint(const Primitive& primitive, std::size_t vertex) {
  if (primitive.influences.empty()) {
    return 0;
  }
  const VertexInfluences& influences = primitive.influences[vertex];
  const auto most = std::ranges::max_element(influences.weights) - influences.weights.begin();
  return influences.joints[static_cast<std::size_t>(most)];
}

// Names of cells mix their numbers: two that share a name only look coarser.
std::uint64_t mixed(std::uint64_t name, std::int64_t number) {
  name ^= static_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15ULL + (name << 6U) + (name >> 2U);
  return name * 0xff51afd7ed558ccdULL;
}

// No cell ends at 0, where halves of a body meet and are rounded to either side.
std::int64_t cellOf(float place, double size) {
  constexpr double farthest = 1e15;
  const double cell = std::floor(static_cast<double>(place) / size + 0.5);
  return std::isfinite(cell) ? static_cast<std::int64_t>(std::clamp(cell, -farthest, farthest)) : 0;
}

// Which vertex of the source stands for each: the first of its cell.
class Thinning {
public:
  Thinning(const Primitive& source, double cellSize) : source_(source), cellSize_(cellSize) {}

  [[nodiscard]] Primitive thinned() {
    Primitive made;
    made.hasNormals = source_.hasNormals;
    made.material = source_.material;
    made.morphTargets.resize(source_.morphTargets.size());
    newOf_.assign(source_.positions.size(), none);
    constexpr std::size_t usualCells = 65536;
    standsIn_.reserve(usualCells);
    madeOf_.reserve(usualCells);
    for (std::size_t i = 0; i + 2 < source_.indices.size(); i += 3) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t side = 0; side < corners.size(); ++side) {
        corners[side] = newVertex(source_.indices[i + side], made);
      }
      const std::array<std::uint32_t, 3> places{placeOf_[corners[0]], placeOf_[corners[1]],
                                                placeOf_[corners[2]]};
      if (places[0] != places[1] && places[1] != places[2] && places[2] != places[0]) {
        made.indices.insert(made.indices.end(), corners.begin(), corners.end());
      }
    }
    return made;
  }

private:
  std::uint32_t newVertex(std::uint32_t vertex, Primitive& made) {
    if (newOf_[vertex] != none) {
      return newOf_[vertex];
    }
    const glm::vec3& place = source_.positions[vertex];
    std::uint64_t cell = mixed(0, leadingJoint(source_, vertex));
    for (int axis = 0; axis < 3; ++axis) {
      cell = mixed(cell, cellOf(place[axis], cellSize_));
    }
    const std::uint32_t stands = standsIn_.try_emplace(cell, vertex).first->second;
    const auto [found, isNew] =
        madeOf_.try_emplace(mixed(cell, islandOf(vertex)), static_cast<std::uint32_t>(placeOf_.size()));
    if (isNew) {
      addVertex(stands, vertex, made);
      placeOf_.push_back(stands);
    }
    return newOf_[vertex] = found->second;
  }

  // Coarsely where on the texture a vertex lies: what is cut apart there must not be drawn across it.
  [[nodiscard]] std::int64_t islandOf(std::uint32_t vertex) const {
    constexpr double coarse = 1.0 / 16.0;
    if (vertex >= source_.texCoords.size()) {
      return 0;
    }
    const glm::vec2& place = source_.texCoords[vertex];
    return static_cast<std::int64_t>(
        mixed(static_cast<std::uint64_t>(cellOf(place.x, coarse)), cellOf(place.y, coarse)));
  }

  template <typename Value>
  static void copy(const std::vector<Value>& from, std::uint32_t vertex, std::vector<Value>& to) {
    if (vertex < from.size()) {
      to.push_back(from[vertex]);
    }
  }

  void addVertex(std::uint32_t stands, std::uint32_t looks, Primitive& made) const {
    copy(source_.positions, stands, made.positions);
    copy(source_.normals, stands, made.normals);
    copy(source_.influences, stands, made.influences);
    for (std::size_t i = 0; i < made.morphTargets.size(); ++i) {
      copy(source_.morphTargets[i].positions, stands, made.morphTargets[i].positions);
      copy(source_.morphTargets[i].normals, stands, made.morphTargets[i].normals);
    }
    copy(source_.texCoords, looks, made.texCoords);
    copy(source_.emissiveTexCoords, looks, made.emissiveTexCoords);
    copy(source_.colors, looks, made.colors);
  }

  const Primitive& source_;
  double cellSize_ = 1.0;
  std::vector<std::uint32_t> newOf_;   // of each vertex of the source
  std::vector<std::uint32_t> placeOf_; // of each new vertex: the one of the source that it stands at
  std::unordered_map<std::uint64_t, std::uint32_t> standsIn_;
  std::unordered_map<std::uint64_t, std::uint32_t> madeOf_;
};

} // namespace

std::size_t triangleCount(const std::vector<Mesh>& meshes) {
  std::size_t count = 0;
  for (const Mesh& mesh : meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      count += primitive.indices.size() / 3;
    }
  }
  return count;
}

std::vector<Mesh> thinnedMeshes(const std::vector<Mesh>& meshes, std::size_t triangles) {
  constexpr double trianglesOfCell = 2.0; // of a surface that crosses cells squarely
  const auto all = static_cast<double>(triangleCount(meshes));
  if (all <= static_cast<double>(triangles)) {
    return meshes;
  }
  std::vector<Mesh> made;
  for (const Mesh& mesh : meshes) {
    Mesh& thin = made.emplace_back();
    thin.name = mesh.name;
    thin.morphWeights = mesh.morphWeights;
    for (const Primitive& primitive : mesh.primitives) {
      const std::size_t own = primitive.indices.size() / 3;
      // Each keeps its share of the triangles, whatever its unit.
      const double kept = static_cast<double>(triangles) * static_cast<double>(own) / all;
      const double size = std::sqrt(trianglesOfCell * areaOf(primitive) / std::max(kept, 1.0));
      thin.primitives.push_back(size > 0.0 ? Thinning(primitive, size).thinned() : primitive);
    }
  }
  return made;
}

} // namespace stretch::ui
