#include "tests/support/assets/dummy_fixture.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"

namespace stretch::assets {

std::filesystem::path committedDummyPath() {
  return std::filesystem::path(STRETCH_SOURCE_DIR) / "assets/dummy.glb";
}

std::vector<std::uint8_t> committedDummy() {
  std::ifstream file(committedDummyPath(), std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return {bytes.begin(), bytes.end()};
}

gltf::Loaded loadedDummy() {
  Result<gltf::Loaded> loaded = gltf::load(committedDummyPath());
  REQUIRE(loaded.ok());
  return *loaded;
}

int nodeNamed(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].name == name) {
      return static_cast<int>(i);
    }
  }
  FAIL("no node named " << name);
  return -1;
}

std::vector<Vec3> bent(const Scene& scene, const Primitive& body, int joint, double degrees) {
  const std::vector<Mat4> worlds = worldMatrices(scene, restPose(scene));
  const auto place = [&](int node) { return positionOf(worlds[static_cast<std::size_t>(node)]); };
  const Node& node = scene.nodes[static_cast<std::size_t>(joint)];
  const Vec3 pivot = place(joint);
  const Vec3 axis =
      glm::normalize(glm::cross(pivot - place(node.parent), place(node.children.front()) - pivot));
  const Quat turn = glm::angleAxis(degrees * pi / 180.0, axis);
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < body.positions.size(); ++v) {
    const Vec3 still(body.positions[v]);
    const Vec3 turned = pivot + turn * (still - pivot);
    double share = 0.0;
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      const int follows = scene.skins[0].joints[body.influences[v].joints[i]];
      share +=
          isAncestorOrSelf(scene, joint, follows) ? static_cast<double>(body.influences[v].weights[i]) : 0.0;
    }
    positions.push_back(still + share * (turned - still));
  }
  return positions;
}

} // namespace stretch::assets
