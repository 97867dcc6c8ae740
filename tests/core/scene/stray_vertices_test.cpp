#include "core/scene/stray_vertices.h"

#include <catch2/catch.hpp>

using namespace stretch;

namespace {

/// A unit cube full of vertices in another place, and as many strays, `away` from its middle along +X.
Scene cubeWithStrays(int strays, float away, int side = 5) {
  Primitive cube;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        cube.positions.emplace_back(glm::vec3(x, y, z) / static_cast<float>(side - 1) + glm::vec3(7.0F));
      }
    }
  }
  cube.positions.insert(cube.positions.begin(), static_cast<std::size_t>(strays),
                        glm::vec3(7.5F + away, 7.5F, 7.5F));
  Scene scene;
  scene.meshes = {{"hat", {}, {}}, {"body", {cube}, {}}};
  return scene;
}

} // namespace

TEST_CASE("A vertex more than ten times as far out as the others is told with its mesh and its place") {
  const std::vector<std::string> told = strayVertexWarnings(cubeWithStrays(1, 12.0F));
  REQUIRE(told.size() == 1);
  CHECK_THAT(told.front(),
             Catch::Contains("meshes[1]: 1 of 126 vertices") && Catch::Contains("one at (19.5, 7.5, 7.5)"));
  CHECK(strayVertexWarnings(cubeWithStrays(1, 10.0F)).empty()); // 9.5 from the cube.
  CHECK(strayVertexWarnings(cubeWithStrays(0, 0.0F)).empty());
  CHECK(strayVertexWarnings(cubeWithStrays(1, 1e30F)).size() == 1);
}

TEST_CASE("More than a hundredth of a mesh, and what has less than a hundred vertices, is no stray") {
  CHECK(strayVertexWarnings(cubeWithStrays(2, 12.0F)).empty());
  CHECK(strayVertexWarnings(cubeWithStrays(7, 12.0F, 9)).size() == 1); // 7 of 736.
  CHECK(strayVertexWarnings(cubeWithStrays(8, 12.0F, 9)).empty());
  CHECK(strayVertexWarnings(cubeWithStrays(1, 12.0F, 4)).empty());
}
