#include "ui/render/scene/sequence_scene.h"

#include <utility>

#include <glm/geometric.hpp>

#include "ui/render/scene/value_colors.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

namespace {

std::vector<glm::vec3> normalsOf(const PlainMesh& mesh) {
  std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0.0F));
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 area = triangleArea(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
    for (const std::uint32_t corner : t) {
      normals[corner] += area;
    }
  }
  for (glm::vec3& normal : normals) {
    normal = normalOfAreas(normal);
  }
  return normals;
}

Primitive primitiveOf(const PlainMesh& mesh) {
  Primitive primitive;
  primitive.positions = mesh.positions;
  primitive.normals = normalsOf(mesh);
  primitive.colors = mesh.colors;
  if (mesh.colors.size() == 1) {
    primitive.colors.assign(mesh.positions.size(), mesh.colors.front());
  }
  primitive.indices.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    primitive.indices.insert(primitive.indices.end(), t.begin(), t.end());
  }
  primitive.material = 0;
  return primitive;
}

} // namespace

Scene sceneOfMeshes(std::span<const PlainMesh> meshes) {
  Scene scene;
  scene.materials.push_back(plainSurface(glm::vec4(1.0F)));
  for (const PlainMesh& mesh : meshes) {
    addMeshNode(scene, {"frame", {primitiveOf(mesh)}, {}});
  }
  return scene;
}

SceneShape shapeOfMeshes(std::span<const PlainMesh> meshes) {
  SceneShape shape;
  for (const PlainMesh& mesh : meshes) {
    const bool each = mesh.colors.size() == mesh.positions.size();
    shape.push_back({mesh.positions, normalsOf(mesh), each ? mesh.colors : std::vector<glm::vec4>()});
  }
  return shape;
}

FrameState restOf(const Scene& scene) {
  return frameOf(scene, restPose(scene), 0.0);
}

void addMeshNode(Scene& scene, Mesh mesh) {
  Node node;
  node.mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back(std::move(node));
  scene.roots.emplace_back(scene.nodes.size() - 1);
}

Material plainSurface(const glm::vec4& baseColor) {
  Material material;
  material.name = "surface";
  material.baseColor = baseColor;
  material.doubleSided = true;
  return material;
}

glm::vec4 clayColor() {
  return linearLight(rgba(0xB9B4AC));
}

glm::vec3 triangleArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::cross(b - a, c - a);
}

glm::vec3 normalOfAreas(const glm::vec3& sum) {
  const float length = glm::length(sum);
  return length > 0.0F ? sum / length : glm::vec3(0.0F, 1.0F, 0.0F);
}

} // namespace stretch::ui
