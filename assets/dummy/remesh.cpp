#include "assets/dummy/remesh.h"

#include <algorithm>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "assets/dummy/editable_mesh.h"

namespace stretch::assets {

namespace {

Vec3 middle(const EditableMesh& mesh, const Edge& edge) {
  return 0.5 * (mesh.position(edge[0]) + mesh.position(edge[1]));
}

void splitLongEdges(EditableMesh& mesh, const RemeshSettings& settings) {
  for (const Edge& edge : mesh.edges()) {
    const Vec3 center = middle(mesh, edge);
    if (mesh.length(edge) > 4.0 / 3.0 * settings.edgeLength(center)) {
      mesh.split(edge, settings.project(center));
    }
  }
}

/// Whether merging the edge would leave another edge that the next pass splits again.
bool makesLongEdge(const EditableMesh& mesh, const Edge& edge, const Vec3& merged, double longest) {
  for (const int end : edge) {
    for (const int neighbour : mesh.neighbours(end)) {
      if (glm::length(mesh.position(neighbour) - merged) > longest) {
        return true;
      }
    }
  }
  return false;
}

void collapseShortEdges(EditableMesh& mesh, const RemeshSettings& settings) {
  for (const Edge& edge : mesh.edges()) {
    if (!mesh.isAlive(edge[0]) || !mesh.isAlive(edge[1]) || !mesh.isEdge(edge)) {
      continue;
    }
    const Vec3 center = middle(mesh, edge);
    const double wanted = settings.edgeLength(center);
    if (mesh.length(edge) >= 4.0 / 5.0 * wanted) {
      continue;
    }
    const Vec3 merged = settings.project(center);
    if (!makesLongEdge(mesh, edge, merged, 4.0 / 3.0 * wanted) && mesh.canCollapse(edge, merged)) {
      mesh.collapse(edge, merged);
    }
  }
}

void evenOutValences(EditableMesh& mesh) {
  for (const Edge& edge : mesh.edges()) {
    if (!mesh.isEdge(edge)) {
      continue;
    }
    const std::array<int, 2> across = mesh.opposite(edge);
    const auto excess = [&](int vertex, int change) { return std::abs(mesh.valence(vertex) + change - 6); };
    const int before = excess(edge[0], 0) + excess(edge[1], 0) + excess(across[0], 0) + excess(across[1], 0);
    const int after = excess(edge[0], -1) + excess(edge[1], -1) + excess(across[0], 1) + excess(across[1], 1);
    if (after < before && mesh.canFlip(edge)) {
      mesh.flip(edge);
    }
  }
}

void relax(EditableMesh& mesh, const RemeshSettings& settings) {
  std::vector<Vec3> targets(static_cast<std::size_t>(mesh.vertexCount()));
  for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
    if (!mesh.isAlive(vertex)) {
      continue;
    }
    const std::vector<int> neighbours = mesh.neighbours(vertex);
    Vec3 center(0.0);
    for (const int neighbour : neighbours) {
      center += mesh.position(neighbour);
    }
    center /= static_cast<double>(neighbours.size());
    const Vec3& position = mesh.position(vertex);
    const Vec3 normal = settings.normal(position);
    const Vec3 pull = center - position;
    targets[static_cast<std::size_t>(vertex)] = position + 0.7 * (pull - glm::dot(pull, normal) * normal);
  }
  for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
    if (mesh.isAlive(vertex)) {
      mesh.setPosition(vertex, settings.project(targets[static_cast<std::size_t>(vertex)]));
    }
  }
}

} // namespace

SurfaceMesh remesh(const SurfaceMesh& mesh, const RemeshSettings& settings) {
  EditableMesh working(mesh);
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    splitLongEdges(working, settings);
    collapseShortEdges(working, settings);
    evenOutValences(working);
    relax(working, settings);
  }
  return EditableMesh(working.compact()).compact();
}

} // namespace stretch::assets
