#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/import/primitive_parts.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

constexpr int trianglesMode = 4;

// Joints of the smallest skin that deforms the mesh; nothing when no skin does.
std::optional<std::size_t> jointsFor(const Scene& scene, std::size_t mesh) {
  std::optional<std::size_t> fewest;
  for (const Node& node : scene.nodes) {
    if (node.mesh == static_cast<int>(mesh) && node.skin >= 0) {
      const std::size_t joints = scene.skins[static_cast<std::size_t>(node.skin)].joints.size();
      fewest = std::min(fewest.value_or(joints), joints);
    }
  }
  return fewest;
}

class MeshImport {
public:
  MeshImport(const Source& source, const Scene& scene, Problems& problems)
      : source_(source), scene_(scene), problems_(problems), budget_(source) {}

  Mesh mesh(std::size_t index) {
    const Json& json = element(source_.json, "meshes", index);
    Mesh mesh;
    mesh.name = shownName(json);
    const std::optional<std::size_t> joints = jointsFor(scene_, index);
    for (std::size_t i = 0; i < sizeOf(json, "primitives"); ++i) {
      const std::string where = at(at("meshes", index) + ".primitives", i);
      if (std::optional<Primitive> made = primitive(element(json, "primitives", i), where, joints)) {
        mesh.primitives.push_back(*std::move(made));
      }
    }
    readMorphWeights(json, index, mesh);
    return mesh;
  }

private:
  std::optional<Primitive> primitive(const Json& json, const std::string& where,
                                     std::optional<std::size_t> joints) {
    if (!holdsTriangles(json)) {
      problems_.warning(where, findPath(json, {"attributes", "POSITION"}) == nullptr
                                   ? "has no POSITION and is left out"
                                   : "holds points or lines, which are not shown");
      return std::nullopt;
    }
    PrimitiveParts parts(source_, json, where, budget_, problems_);
    Primitive made;
    made.material = indexOr(json, "material");
    const int texCoord = baseColorTexCoord(source_, made.material).value_or(0);
    parts.readVertices(texCoord, emissiveTexCoord(source_, made.material).value_or(texCoord), made);
    parts.readInfluences(joints, made);
    parts.readTriangles(made);
    parts.spreadInfluences(made);
    parts.readMorphTargets(made);
    if (parts.failed()) {
      return std::nullopt;
    }
    parts.completeNormals(made);
    warnOfTexCoords(made, where);
    return made;
  }

  void warnOfTexCoords(const Primitive& made, const std::string& where) {
    const std::optional<int> texCoord = baseColorTexCoord(source_, made.material);
    if (made.texCoords.empty() && texCoord) {
      problems_.violation(where,
                          fmt::format("has no TEXCOORD_{}, which its material's texture needs", *texCoord));
    }
  }

  void readMorphWeights(const Json& json, std::size_t index, Mesh& mesh) {
    std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives.front().morphTargets.size();
    for (const Primitive& one : mesh.primitives) {
      if (one.morphTargets.size() != targets) {
        problems_.error(at("meshes", index), "has primitives with different numbers of morph targets");
        return;
      }
    }
    const std::vector<double> weights = numbersOf(json, "weights");
    if (!weights.empty() && weights.size() != targets && !mesh.primitives.empty()) {
      problems_.warning(at("meshes", index) + ".weights", "does not have one weight for each morph target");
    }
    mesh.morphWeights.assign(targets, 0.0F);
    for (std::size_t i = 0; i < std::min(targets, weights.size()); ++i) {
      mesh.morphWeights[i] = static_cast<float>(weights[i]);
    }
  }

  const Source& source_;
  const Scene& scene_;
  Problems& problems_;
  DecodeBudget budget_;
};

void checkSkinnedNodes(const Scene& scene, const std::vector<Mesh>& meshes, Problems& problems) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (node.mesh < 0) {
      continue;
    }
    const std::vector<Primitive>& primitives = meshes[static_cast<std::size_t>(node.mesh)].primitives;
    const bool isSkinnable =
        std::ranges::any_of(primitives, [](const Primitive& one) { return !one.influences.empty(); });
    if (node.skin >= 0 && !isSkinnable && !primitives.empty()) {
      problems.warning(at("nodes", i), "has a skin, but its mesh has no joints and weights");
    }
  }
}

} // namespace

bool holdsTriangles(const Json& primitive) {
  return findPath(primitive, {"attributes", "POSITION"}) != nullptr &&
         wholeOr(primitive, "mode", trianglesMode) >= trianglesMode;
}

std::vector<Mesh> importMeshes(const Source& source, const Scene& scene, Problems& problems) {
  MeshImport import(source, scene, problems);
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < sizeOf(source.json, "meshes"); ++i) {
    meshes.push_back(import.mesh(i));
  }
  if (!problems.hasErrors()) {
    checkSkinnedNodes(scene, meshes, problems);
  }
  return meshes;
}

std::map<int, std::size_t> trianglesByPlaces(const Json& mesh) {
  std::map<int, std::size_t> found;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < sizeOf(mesh, "primitives"); ++i) {
    const Json& primitive = element(mesh, "primitives", i);
    if (holdsTriangles(primitive)) {
      found.emplace(indexOr(*find(primitive, "attributes"), "POSITION"), shown++);
    }
  }
  return found;
}

} // namespace stretch::gltf
