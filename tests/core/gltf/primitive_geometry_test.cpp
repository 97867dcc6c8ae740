#include <limits>

#include <catch2/catch.hpp>

#include "core/gltf/import/primitive_parts.h"
#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

namespace {

constexpr int list = 4;
constexpr int strip = 5;
constexpr int fan = 6;

/// A mesh of these corners at one node.
GlbBuilder meshOf(const std::vector<float>& places, const std::vector<std::uint16_t>& corners) {
  GlbBuilder glb;
  glb.json = Json::parse(
      R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}]})");
  const int accessor = glb.floats(places, "VEC3", 3);
  std::vector<float> low{places[0], places[1], places[2]};
  std::vector<float> high = low;
  for (std::size_t i = 3; i < places.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], places[i]);
    high[i % 3] = std::max(high[i % 3], places[i]);
  }
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["min"] = low;
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["max"] = high;
  const int indices = glb.accessor(corners, 5123, "SCALAR", 1);
  glb.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", accessor}}}, {"indices", indices}}}}}};
  return glb;
}

const Primitive& primitiveOf(const gltf::Loaded& file) {
  return file.scene->meshes.at(0).primitives.at(0);
}

/// A row of places along x that hang together by thin triangles, one vertex of weight on each joint; vertices
/// of which `lost` tells that their weights are no numbers.
GlbBuilder rowOfVertices(std::size_t count, const std::vector<std::size_t>& lost,
                         const std::vector<std::uint16_t>& corners) {
  std::vector<float> places;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const bool isLost = std::ranges::find(lost, i) != lost.end();
    places.insert(places.end(), {static_cast<float>(i), static_cast<float>(i % 2), 0.0F});
    joints.insert(joints.end(), {static_cast<std::uint8_t>(i), 0, 0, 0});
    weights.insert(weights.end(),
                   {isLost ? std::numeric_limits<float>::quiet_NaN() : 1.0F, 0.0F, 0.0F, 0.0F});
  }
  GlbBuilder glb = meshOf(places, corners);
  Json& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = glb.accessor(joints, 5121, "VEC4", 4);
  attributes["WEIGHTS_0"] = glb.floats(weights, "VEC4", 4);
  Json names = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    glb.json["nodes"].push_back({{"name", "joint"}});
    glb.json["scenes"][0]["nodes"].push_back(i + 1);
    names.push_back(i + 1);
  }
  glb.json["skins"] = {{{"joints", names}}};
  glb.json["nodes"][0]["skin"] = 0;
  return glb;
}

std::vector<int> jointsOf(const GlbBuilder& glb) {
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  std::vector<int> joints;
  for (const VertexInfluences& vertex : primitiveOf(*file).influences) {
    CHECK(vertex.weights[0] == 1.0F);
    joints.push_back(vertex.joints[0]);
  }
  return joints;
}

} // namespace

TEST_CASE("A list of corners is its triangles, without those that are not whole") {
  using Corners = std::vector<std::uint32_t>;
  CHECK(gltf::unrolledTriangles({1, 2, 3, 4, 5, 6}, list) == Corners{1, 2, 3, 4, 5, 6});
  CHECK(gltf::unrolledTriangles({1, 2, 3, 4, 5}, list) == Corners{1, 2, 3});
  CHECK(gltf::unrolledTriangles({1, 2, 3, 4}, list) == Corners{1, 2, 3});
  CHECK(gltf::unrolledTriangles({1, 2}, list).empty());
  CHECK(gltf::unrolledTriangles({1, 2, 3, 4, 5}, strip) == Corners{1, 2, 3, 2, 4, 3, 3, 4, 5});
  CHECK(gltf::unrolledTriangles({1, 2, 3, 4, 5}, fan) == Corners{1, 2, 3, 1, 3, 4, 1, 4, 5});
  for (const int mode : {strip, fan}) {
    CHECK(gltf::unrolledTriangles({1, 2}, mode).empty());
    CHECK(gltf::unrolledTriangles({1, 2, 3}, mode) == Corners{1, 2, 3});
  }
}

TEST_CASE("Weights of a vertex are made to sum to one, and what has none hangs on its first joint") {
  const auto normalized = [](std::array<float, 8> weights) {
    std::vector<VertexInfluences> vertices(2);
    vertices[0].weights[0] = 1.0F;
    vertices[1].weights = weights;
    const bool wasOff = gltf::normalizeWeights(vertices);
    CHECK(vertices[0].weights == std::array<float, 8>{1.0F});
    return std::pair(vertices[1].weights, wasOff);
  };
  using Row = std::array<float, 8>;
  CHECK(normalized({0.5F, 0.5F}) == std::pair(Row{0.5F, 0.5F}, false));
  CHECK(normalized({1.0F, 0, 0, 0, 0, 0, 0, 3.0F}) == std::pair(Row{0.25F, 0, 0, 0, 0, 0, 0, 0.75F}, true));
  CHECK(normalized({0.25F, 0.25F}) == std::pair(Row{0.5F, 0.5F}, true));
  CHECK(normalized({}) == std::pair(Row{1.0F}, true));
  CHECK(normalized({0.0F, -2.0F}) == std::pair(Row{1.0F}, true));
  CHECK(normalized({std::numeric_limits<float>::infinity()}) == std::pair(Row{1.0F}, true));
  // What bytes round is not told.
  CHECK_FALSE(normalized({0.9961F}).second);
  CHECK(normalized({0.9959F}).second);
  CHECK_FALSE(normalized({1.0039F}).second);
  CHECK(normalized({1.0041F}).second);
}

TEST_CASE("Normals that a file lacks are those of the triangles around, larger ones counting more") {
  // A large triangle in the plane z = 0 and a small one that stands on it, at the edge they share.
  const gltf::Loaded file =
      test::loaded(meshOf({0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0, 1, 9, 9, 9}, {0, 1, 2, 0, 1, 3}));
  const Primitive& made = primitiveOf(file);
  const glm::vec3 flat(0, 0, 1);
  const glm::vec3 upright(0, -1, 0);
  const auto checkNear = [](const glm::vec3& is, const glm::vec3& wanted) {
    CHECK(glm::distance(is, wanted) < 1e-6F);
  };
  checkNear(made.normals[2], flat);
  checkNear(made.normals[3], upright);
  checkNear(made.normals[0], glm::normalize(4.0F * flat + upright));
  checkNear(made.normals[1], glm::normalize(4.0F * flat + upright));
  checkNear(made.normals[4], glm::vec3(0, 1, 0)); // of no triangle
  CHECK_FALSE(made.hasNormals);
}

TEST_CASE("Of normals that a file has only those without length are replaced") {
  GlbBuilder glb = meshOf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2});
  glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      glb.floats({1, 0, 0, 0, 0, 0, 0, 1, 0}, "VEC3", 3);
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  CHECK(primitiveOf(*file).normals == std::vector<glm::vec3>{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}});
  CHECK(primitiveOf(*file).hasNormals);
}

TEST_CASE("How far normals are off unit length is told in two steps") {
  const auto toldOf = [](float length) {
    GlbBuilder glb = meshOf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2});
    glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        glb.floats({0, 0, 1, 0, 0, length, 0, 0, 1}, "VEC3", 3);
    const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
    REQUIRE(file);
    CHECK(primitiveOf(*file).normals[1] == glm::vec3(0, 0, 1));
    return test::warnsOf(*file, "are repaired")               ? 2
           : test::warnsOf(*file, "a little off unit length") ? 1
                                                              : 0;
  };
  CHECK(toldOf(1.0F) == 0);
  CHECK(toldOf(1.019F) == 0);
  CHECK(toldOf(1.021F) == 1);
  CHECK(toldOf(0.979F) == 1);
  CHECK(toldOf(1.099F) == 1);
  CHECK(toldOf(1.101F) == 2);
  CHECK(toldOf(0.5F) == 2);
}

TEST_CASE("A vertex without weights follows the nearest one with some, over each side of a triangle") {
  // Of two at the same distance it is the one that comes first, over whichever side of the triangle.
  std::vector<std::uint16_t> corners{0, 1, 2};
  do {
    CAPTURE(corners);
    CHECK(jointsOf(rowOfVertices(3, {2}, corners)) == std::vector<int>{0, 1, 0});
  } while (std::ranges::next_permutation(corners).found);
  CHECK(jointsOf(rowOfVertices(3, {1}, {0, 1, 0})) == std::vector<int>{0, 0, 2});
  CHECK(jointsOf(rowOfVertices(3, {2}, {1, 1, 2})) == std::vector<int>{0, 1, 1});
  CHECK(jointsOf(rowOfVertices(3, {0}, {0, 0, 2})) == std::vector<int>{2, 1, 2});
  CHECK(jointsOf(rowOfVertices(3, {2}, {2, 1, 1})) == std::vector<int>{0, 1, 1});
  // Step by step along a row, from either end.
  CHECK(jointsOf(rowOfVertices(7, {1, 2, 3, 4, 5}, {0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6})) ==
        std::vector<int>{0, 0, 0, 0, 6, 6, 6});
  // What hangs on nothing with weights follows the joint that it names first.
  CHECK(jointsOf(rowOfVertices(4, {2, 3}, {0, 1, 1, 2, 3, 3})) == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("A vertex without weights follows one that lies where it lies") {
  GlbBuilder glb = rowOfVertices(4, {3}, {0, 1, 2});
  const auto view = glb.json["bufferViews"][0]["byteOffset"].get<std::size_t>();
  std::memcpy(glb.binary.data() + view + 36, glb.binary.data() + view + 12, 12); // the last where the second
                                                                                 // is
  glb.json["accessors"][0]["max"] = {2, 1, 0};
  CHECK(jointsOf(glb) == std::vector<int>{0, 1, 2, 1});
}
