#include "skinning/sequence/gltf_surface.h"

#include <algorithm>
#include <numeric>

#include <fmt/core.h>

#include "core/gltf/import/material_library.h"
#include "core/gltf/import/texture_sets.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::skinning {
namespace {

using gltf::MeshSurface;

/// Texture coordinates and colours of the surface are as long as it has vertices; what a primitive lacks is
/// filled up.
class SurfaceMaker {
public:
  explicit SurfaceMaker(const gltf::Loaded& loaded) : scene_(*loaded.scene), sets_(loaded) {}

  MeshSurface make() {
    for (const NodeIndex node : drawnMeshNodes(scene_)) {
      const auto mesh = static_cast<std::size_t>(scene_.nodes[at(node)].mesh);
      for (std::size_t p = 0; p < scene_.meshes[mesh].primitives.size(); ++p) {
        addTextureSets(mesh, p);
        add(scene_.meshes[mesh].primitives[p], scene_.meshes[mesh].name);
      }
    }
    for (std::vector<glm::vec2>& set : surface_.texCoords) {
      set.resize(vertexCount_, glm::vec2(0.0F));
    }
    if (!surface_.colors.empty()) {
      surface_.colors.resize(vertexCount_, glm::vec4(1.0F));
    }
    surface_.places.resize(vertexCount_);
    std::iota(surface_.places.begin(), surface_.places.end(), 0U);
    return std::move(surface_);
  }

private:
  void addTextureSets(std::size_t mesh, std::size_t primitive) {
    std::vector<std::vector<glm::vec2>> sets = sets_.of(mesh, primitive);
    surface_.texCoords.resize(std::max(surface_.texCoords.size(), sets.size()));
    for (std::size_t i = 0; i < sets.size(); ++i) {
      std::vector<glm::vec2>& all = surface_.texCoords[i];
      all.resize(vertexCount_, glm::vec2(0.0F));
      all.insert(all.end(), sets[i].begin(), sets[i].end());
    }
  }

  void add(const Primitive& primitive, const std::string& name) {
    const auto first = static_cast<std::uint32_t>(vertexCount_);
    if (!primitive.colors.empty()) {
      surface_.colors.resize(vertexCount_, glm::vec4(1.0F));
      surface_.colors.insert(surface_.colors.end(), primitive.colors.begin(), primitive.colors.end());
    }
    const std::size_t firstTriangle = surface_.triangles.size();
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      surface_.triangles.push_back(
          {first + primitive.indices[i], first + primitive.indices[i + 1], first + primitive.indices[i + 2]});
    }
    surface_.parts.push_back(
        {name, primitive.material, firstTriangle, surface_.triangles.size() - firstTriangle});
    vertexCount_ += primitive.positions.size();
  }

  const Scene& scene_;
  gltf::TextureSets sets_;
  MeshSurface surface_;
  std::size_t vertexCount_ = 0;
};

/// "1 primitive of points, 2 cameras": what the file holds beside the triangles that it shows.
std::string leftOut(const gltf::Loaded& loaded) {
  constexpr int points = 0;
  constexpr int triangles = 4;
  const gltf::Json& json = *loaded.source->json;
  const std::vector<NodeIndex> drawn = drawnMeshNodes(*loaded.scene);
  std::size_t ofPoints = 0;
  std::size_t ofLines = 0;
  for (const NodeIndex node : drawn) {
    const gltf::Json& mesh =
        gltf::element(json, "meshes", static_cast<std::size_t>(loaded.scene->nodes[at(node)].mesh));
    for (std::size_t p = 0; p < gltf::sizeOf(mesh, "primitives"); ++p) {
      const auto mode = gltf::wholeOr(gltf::element(mesh, "primitives", p), "mode", triangles);
      ofPoints += mode == points ? 1 : 0;
      ofLines += mode > points && mode < triangles ? 1 : 0;
    }
  }
  const auto withMesh =
      std::ranges::count_if(loaded.scene->nodes, [](const Node& node) { return node.mesh >= 0; });
  const gltf::Json* const lights = gltf::findPath(json, {"extensions", "KHR_lights_punctual", "lights"});
  std::string list;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) {
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, count == 1 ? one : many);
    }
  };
  add(ofPoints, "primitive of points", "primitives of points");
  add(ofLines, "primitive of lines", "primitives of lines");
  add(static_cast<std::size_t>(withMesh) - drawn.size(), "mesh of another scene", "meshes of other scenes");
  add(gltf::sizeOf(json, "cameras"), "camera", "cameras");
  add(lights == nullptr ? 0 : lights->size(), "light", "lights");
  return list;
}

} // namespace

gltf::MeshSurface surfaceOf(const gltf::Loaded& loaded, const FrameState& first,
                            std::vector<std::string>& warnings) {
  if (const std::string left = leftOut(loaded); !left.empty()) {
    warnings.push_back("left out: " + left);
  }
  MeshSurface surface = SurfaceMaker(loaded).make();
  const std::vector<Vec3> normals = skinnedNormals(*loaded.scene, first);
  surface.normals.assign(normals.begin(), normals.end());
  surface.materials = std::make_shared<const gltf::Source>(gltf::materialsOf(*loaded.source, warnings));
  return surface;
}

} // namespace stretch::skinning
