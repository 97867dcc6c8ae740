#include "tests/support/ui/heavy_scene.h"

#include <array>

#include "ui/render/scene/thinned_meshes.h"

namespace stretch::test {

namespace {

template <typename Value>
void addMiddle(std::vector<Value>& values, std::size_t a, std::size_t b) {
  if (!values.empty()) {
    values.push_back(0.5F * (values[a] + values[b]));
  }
}

std::uint32_t middleOf(Primitive& primitive, std::uint32_t a, std::uint32_t b) {
  addMiddle(primitive.positions, a, b);
  addMiddle(primitive.normals, a, b);
  addMiddle(primitive.texCoords, a, b);
  addMiddle(primitive.emissiveTexCoords, a, b);
  addMiddle(primitive.colors, a, b);
  for (MorphTarget& target : primitive.morphTargets) {
    addMiddle(target.positions, a, b);
    addMiddle(target.normals, a, b);
  }
  if (!primitive.influences.empty()) {
    primitive.influences.push_back(primitive.influences[a]);
  }
  return static_cast<std::uint32_t>(primitive.positions.size() - 1);
}

void divide(Primitive& primitive) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::array corners{primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
    const std::array middles{middleOf(primitive, corners[0], corners[1]),
                             middleOf(primitive, corners[1], corners[2]),
                             middleOf(primitive, corners[2], corners[0])};
    for (const std::array<std::uint32_t, 3>& piece :
         {std::array{corners[0], middles[0], middles[2]}, std::array{middles[0], corners[1], middles[1]},
          std::array{middles[2], middles[1], corners[2]}, middles}) {
      indices.insert(indices.end(), piece.begin(), piece.end());
    }
  }
  primitive.indices = std::move(indices);
}

} // namespace

Scene withTriangles(Scene scene, std::size_t triangles) {
  while (ui::triangleCount(scene.meshes) <= triangles) {
    for (Mesh& mesh : scene.meshes) {
      for (Primitive& primitive : mesh.primitives) {
        divide(primitive);
      }
    }
  }
  return scene;
}

} // namespace stretch::test
