#include "tests/support/assets/dummy_fixture.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"

namespace stretch::assets {

std::filesystem::path bundledPath(const std::string& name) {
  return std::filesystem::path(STRETCH_SOURCE_DIR) / "assets" / name;
}

std::vector<std::uint8_t> bundledBytes(const std::string& name) {
  std::ifstream file(bundledPath(name), std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return {bytes.begin(), bytes.end()};
}

gltf::Loaded loadedDummy() {
  Result<gltf::Loaded> loaded = gltf::load(bundledPath("dummy.glb"));
  REQUIRE(loaded.ok());
  return *loaded;
}

NodeIndex nodeNamed(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].name == name) {
      return NodeIndex(i);
    }
  }
  FAIL("no node named " << name);
  return NodeIndex::none;
}

std::vector<Vec3> bent(const Scene& scene, const Primitive& body, NodeIndex joint, double degrees) {
  const std::vector<Mat4> worlds = worldMatrices(scene, restPose(scene));
  const auto place = [&](NodeIndex node) { return positionOf(worlds[at(node)]); };
  const Node& node = scene.nodes[at(joint)];
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
      const NodeIndex follows = scene.skins[0].joints[body.influences[v].joints[i]];
      share +=
          isAncestorOrSelf(scene, joint, follows) ? static_cast<double>(body.influences[v].weights[i]) : 0.0;
    }
    positions.push_back(still + share * (turned - still));
  }
  return positions;
}

} // namespace stretch::assets
