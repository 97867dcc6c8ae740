// Which node of a file carries a skeleton that its meshes are bound to.
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/added_skeleton.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;

namespace {

constexpr NodeIndex topOfCarriers(0);
constexpr NodeIndex innerCarrier(1);

/// A node over another one that holds two meshes side by side, with what the inner one says of itself.
gltf::Loaded twoMeshesUnder(const char* property, const std::vector<double>& numbers) {
  test::GlbBuilder glb = test::armBuilder();
  glb.json.erase("animations");
  glb.json["nodes"] = Json::parse(R"([{"name": "model", "scale": [0.1, 0.1, 0.1], "children": [1]},
      {"name": "group", "children": [2, 3]}, {"name": "left", "mesh": 1}, {"name": "right", "mesh": 1}])");
  glb.json["nodes"][1][property] = numbers;
  glb.json.erase("skins");
  glb.json["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  return test::loaded(glb);
}

NodeIndex carrierUnder(const char* property, const std::vector<double>& numbers) {
  return gltf::carrierOfSkeleton(*twoMeshesUnder(property, numbers).scene, {NodeIndex(2), NodeIndex(3)});
}

} // namespace

TEST_CASE("The lowest node over all meshes carries their skeleton, unless it stretches, mirrors or shears") {
  CHECK(carrierUnder("scale", {3, 3, 3}) == innerCarrier);
  CHECK(carrierUnder("rotation", {0.6, 0, 0, 0.8}) == innerCarrier);
  CHECK(carrierUnder("translation", {100, 0, 0}) == innerCarrier);
  CHECK(carrierUnder("scale", {2, 1, 1}) == topOfCarriers);
  CHECK(carrierUnder("scale", {1, 2, 1}) == topOfCarriers);
  CHECK(carrierUnder("scale", {1, 1, 2}) == topOfCarriers);
  CHECK(carrierUnder("scale", {-1, 1, 1}) == topOfCarriers);
  CHECK(carrierUnder("scale", {0, 0, 0}) == topOfCarriers);
  // Columns of unit length, two of which lean towards each other: y to x, z to y and z to x.
  CHECK(carrierUnder("matrix", {1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}) == topOfCarriers);
  CHECK(carrierUnder("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1}) == topOfCarriers);
  CHECK(carrierUnder("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0.6, 0, 0.8, 0, 0, 0, 0, 1}) == topOfCarriers);
}

TEST_CASE("A node that holds one of the meshes carries no skeleton, though the others hang below it") {
  test::GlbBuilder glb = test::armBuilder();
  glb.json["nodes"][2]["mesh"] = 1; // over node 3, which holds that mesh as well
  const gltf::Loaded file = test::loaded(glb);
  CHECK(gltf::carrierOfSkeleton(*file.scene, {NodeIndex(3)}) == NodeIndex(2));
  CHECK(gltf::carrierOfSkeleton(*file.scene, {NodeIndex(3), NodeIndex(2)}) == NodeIndex(1));
  CHECK_FALSE(gltf::carrierOfSkeleton(*file.scene, {}).exists());
}
