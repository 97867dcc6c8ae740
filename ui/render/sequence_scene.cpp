#include "ui/render/sequence_scene.h"

#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

std::vector<glm::vec3> normalsOf(const PlainMesh& mesh) {
  std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0.0F));
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3& a = mesh.positions[t[0]];
    const glm::vec3 area = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (const std::uint32_t corner : t) {
      normals[corner] += area;
    }
  }
  for (glm::vec3& normal : normals) {
    const float length = glm::length(normal);
    normal = length > 0.0F ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F);
  }
  return normals;
}

Primitive primitiveOf(const PlainMesh& mesh) {
  Primitive primitive;
  primitive.positions.assign(mesh.positions.begin(), mesh.positions.end());
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
  Material material;
  material.name = "surface";
  material.doubleSided = true;
  scene.materials.push_back(material);
  for (const PlainMesh& mesh : meshes) {
    const int index = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({"frame", {primitiveOf(mesh)}, {}});
    Node node;
    node.mesh = index;
    scene.nodes.push_back(node);
    scene.roots.emplace_back(scene.nodes.size() - 1);
  }
  return scene;
}

FrameState restOf(const Scene& scene) {
  return frameOf(scene, restPose(scene), 0.0);
}

} // namespace stretch::ui
