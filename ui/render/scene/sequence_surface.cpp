#include "ui/render/scene/sequence_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "core/gltf/import/material_library.h"
#include "ui/render/scene/sequence_scene.h"

namespace stretch::ui {

namespace {

/// The surface of a sequence that says nothing of how it looks.
gltf::MeshSurface bareSurface(const MeshSequence& sequence) {
  gltf::MeshSurface surface;
  surface.places.resize(sequence.vertexCount);
  std::iota(surface.places.begin(), surface.places.end(), 0U);
  surface.triangles = sequence.triangles;
  surface.parts = {{sequence.name, -1, 0, sequence.triangles.size()}};
  return surface;
}

/// Vertices at one place whose normals agree shade as one, whatever splits them: a seam of a texture does not
/// show in the light, a hard edge does.
std::vector<std::uint32_t> smoothGroups(const gltf::MeshSurface& surface) {
  if (surface.normals.empty()) {
    return surface.places;
  }
  constexpr float steps = 1000.0F;
  std::map<std::array<long, 4>, std::uint32_t> known;
  std::vector<std::uint32_t> groups;
  for (std::size_t v = 0; v < surface.places.size(); ++v) {
    const glm::vec3 normal = steps * surface.normals[v];
    const std::array<long, 4> key{static_cast<long>(surface.places[v]), std::lround(normal.x),
                                  std::lround(normal.y), std::lround(normal.z)};
    groups.push_back(known.try_emplace(key, static_cast<std::uint32_t>(known.size())).first->second);
  }
  return groups;
}

std::size_t groupCount(const std::vector<std::uint32_t>& groups) {
  return groups.empty() ? 0 : 1 + *std::max_element(groups.begin(), groups.end());
}

/// `normal` turned by the shortest way that brings `from` to `to`; all of unit length.
glm::vec3 turned(const glm::vec3& normal, const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine < -0.9999F) {
    return -normal;
  }
  const glm::vec3 axis = glm::cross(from, to);
  return cosine * normal + glm::cross(axis, normal) + (glm::dot(axis, normal) / (1.0F + cosine)) * axis;
}

template <typename Value>
std::vector<Value> chosen(const std::vector<Value>& all, const std::vector<std::uint32_t>& which) {
  std::vector<Value> values;
  values.reserve(which.size());
  for (const std::uint32_t index : which) {
    values.push_back(all[index]);
  }
  return values;
}

} // namespace

SequenceSurface::SequenceSurface(const MeshSequence& sequence)
    : surface_(sequence.surface != nullptr
                   ? sequence.surface
                   : std::make_shared<const gltf::MeshSurface>(bareSurface(sequence))),
      smoothed_(smoothGroups(*surface_)),
      firstPositions_(sequence.frame(0).begin(), sequence.frame(0).end()) {
  firstNormals_ = smoothNormals(firstPositions_);
  for (const gltf::SurfacePart& part : surface_->parts) {
    parts_.push_back(partOf(part));
  }
}

SequenceSurface::Part SequenceSurface::partOf(const gltf::SurfacePart& triangles) const {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> own(surface_->places.size(), none);
  Part part;
  part.material = triangles.material;
  for (std::size_t t = 0; t < triangles.triangleCount; ++t) {
    for (const std::uint32_t vertex : surface_->triangles[triangles.firstTriangle + t]) {
      if (own[vertex] == none) {
        own[vertex] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(vertex);
      }
      part.indices.push_back(own[vertex]);
    }
  }
  return part;
}

std::vector<glm::vec3> SequenceSurface::smoothNormals(std::span<const glm::vec3> places) const {
  std::vector<glm::vec3> sums(groupCount(smoothed_), glm::vec3(0.0F));
  for (const Triangle& t : surface_->triangles) {
    const glm::vec3 area = triangleArea(places[surface_->places[t[0]]], places[surface_->places[t[1]]],
                                        places[surface_->places[t[2]]]);
    for (const std::uint32_t corner : t) {
      sums[smoothed_[corner]] += area;
    }
  }
  for (glm::vec3& sum : sums) {
    sum = normalOfAreas(sum);
  }
  return sums;
}

std::vector<glm::vec3> SequenceSurface::normalsAt(std::span<const glm::vec3> places) const {
  const std::vector<glm::vec3> now = smoothNormals(places);
  std::vector<glm::vec3> normals;
  normals.reserve(smoothed_.size());
  for (std::size_t v = 0; v < smoothed_.size(); ++v) {
    const std::uint32_t group = smoothed_[v];
    normals.push_back(surface_->normals.empty()
                          ? now[group]
                          : turned(surface_->normals[v], firstNormals_[group], now[group]));
  }
  return normals;
}

PrimitiveShape SequenceSurface::shapeOf(const Part& part, std::span<const glm::vec3> places,
                                        const std::vector<glm::vec3>& normals) const {
  PrimitiveShape shape;
  shape.positions.reserve(part.vertices.size());
  for (const std::uint32_t vertex : part.vertices) {
    shape.positions.push_back(places[surface_->places[vertex]]);
  }
  shape.normals = chosen(normals, part.vertices);
  return shape;
}

SceneShape SequenceSurface::shapeAt(std::span<const glm::vec3> places) const {
  const std::vector<glm::vec3> normals = normalsAt(places);
  SceneShape shape;
  for (const Part& part : parts_) {
    shape.push_back(shapeOf(part, places, normals));
  }
  return shape;
}

void SequenceSurface::addLook(Primitive& primitive, const Part& part, std::size_t baseColorSet,
                              std::size_t emissiveSet) const {
  const auto coordinates = [&](std::size_t set) {
    return set < surface_->texCoords.size() ? chosen(surface_->texCoords[set], part.vertices)
                                            : std::vector<glm::vec2>();
  };
  primitive.texCoords = coordinates(baseColorSet);
  if (emissiveSet != baseColorSet) {
    primitive.emissiveTexCoords = coordinates(emissiveSet);
  }
  if (!surface_->colors.empty()) {
    primitive.colors = chosen(surface_->colors, part.vertices);
  }
}

Scene SequenceSurface::scene() const {
  gltf::ShownMaterials shown;
  if (surface_->materials != nullptr) {
    shown = gltf::shownMaterials(*surface_->materials);
  }
  Scene scene;
  scene.images = std::move(shown.images);
  for (const gltf::ShownMaterial& each : shown.materials) {
    scene.materials.push_back(each.material);
  }
  const bool painted = !surface_->colors.empty() || surface_->materials != nullptr;
  const int otherMaterial = static_cast<int>(scene.materials.size());
  scene.materials.push_back(plainSurface(painted ? glm::vec4(1.0F) : clayColor()));
  const SceneShape first = shapeAt(firstPositions_);
  Mesh mesh;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Primitive primitive;
    primitive.positions = first[i].positions;
    primitive.normals = first[i].normals;
    primitive.indices = parts_[i].indices;
    const int material = parts_[i].material;
    const bool known = material >= 0 && material < otherMaterial;
    primitive.material = known ? material : otherMaterial;
    const gltf::ShownMaterial sets =
        known ? shown.materials[static_cast<std::size_t>(material)] : gltf::ShownMaterial{};
    addLook(primitive, parts_[i], sets.baseColorSet, sets.emissiveSet);
    mesh.primitives.push_back(std::move(primitive));
  }
  addMeshNode(scene, std::move(mesh));
  return scene;
}

} // namespace stretch::ui
