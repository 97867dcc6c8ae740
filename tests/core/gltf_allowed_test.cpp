#include <limits>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/source.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using namespace stretch::test;
using gltf::Json;

namespace {

Json& channelOf(GlbBuilder& file, std::size_t clip, std::size_t channel) {
  return file.json["animations"][clip]["channels"][channel];
}

// Drives what a channel drives through a pointer.
void pointAt(GlbBuilder& file, std::size_t channel, const std::string& pointer) {
  channelOf(file, 0, channel)["target"] = {
      {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
  file.json["extensionsUsed"].push_back("KHR_animation_pointer");
}

} // namespace

TEST_CASE("A channel that points to a property of a node plays as one that names the node") {
  GlbBuilder file = armBuilder();
  const Result<gltf::Loaded> plain = loadBytes(file.bytes());
  REQUIRE(plain);
  const Track track = *plain->clips[0].tracks[0];
  const std::string path = channelOf(file, 0, 0)["target"]["path"];
  pointAt(file, 0, "/nodes/" + std::to_string(track.node.value) + "/" + path);
  const Result<gltf::Loaded> pointed = loadBytes(file.bytes());
  REQUIRE(pointed);
  REQUIRE(pointed->clips[0].tracks.size() == plain->clips[0].tracks.size());
  CHECK(*pointed->clips[0].tracks[0] == track);

  // What is keyed anew takes the place of what the pointer drove.
  gltf::Edits edits;
  edits.clips.push_back({0, {track}});
  const Result<gltf::Source> saved = gltf::patched(*pointed->source, edits);
  REQUIRE(saved);
  CHECK((*saved->json)["animations"][0]["channels"].size() == file.json["animations"][0]["channels"].size());
}

TEST_CASE("A channel that points to something that is not shown is told") {
  GlbBuilder file = armBuilder();
  pointAt(file, 0, "/materials/0/pbrMetallicRoughness/baseColorFactor");
  const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
  REQUIRE(loaded);
  CHECK(warnsOf(*loaded, "drives '/materials/0/pbrMetallicRoughness/baseColorFactor', which is not shown"));
}

TEST_CASE("Data that glTF allows are read: data written out, zeros without data, columns without padding") {
  GlbBuilder file = armBuilder();
  SECTION("a buffer as text that is not base64") {
    file.json["buffers"] = Json::array();
    std::string uri = "data:application/octet-stream,";
    for (const std::uint8_t byte : file.binary) {
      constexpr const char* digits = "0123456789abcdef";
      uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
    }
    Json document = file.json;
    document["buffers"] = {{{"byteLength", file.binary.size()}, {"uri", uri}}};
    const TemporaryFolder folder;
    const Result<gltf::Loaded> loaded = gltf::load(folder.write("model.gltf", document.dump()));
    REQUIRE(loaded);
    CHECK(loaded->scene->meshes.size() == 2);
  }
  SECTION("key times without data") {
    file.json["accessors"].push_back(
        {{"componentType", 5126}, {"count", 2}, {"type", "SCALAR"}, {"min", {0}}, {"max", {0}}});
    Json& sampler = file.json["animations"][0]["samplers"][0];
    const std::size_t output = sampler["output"];
    const std::size_t keys = file.json["accessors"][output]["count"];
    file.json["accessors"].back()["count"] = keys;
    sampler["input"] = file.json["accessors"].size() - 1;
    const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
    REQUIRE(loaded);
    CHECK(warnsOf(*loaded, "all its keys are at 0"));
  }
  SECTION("inverse bind matrices without data") {
    file.json["accessors"].push_back({{"componentType", 5126}, {"count", 3}, {"type", "MAT4"}});
    file.json["skins"][0]["inverseBindMatrices"] = file.json["accessors"].size() - 1;
    const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
    REQUIRE(loaded);
    CHECK(warnsOf(*loaded, "all its matrices are zero"));
    Mat4 point(0.0);
    point[3][3] = 1.0;
    CHECK(loaded->scene->skins[0].inverseBind == std::vector<Mat4>(3, point));
  }
  SECTION("the padding of a matrix's last column is missing at the end of the data") {
    file.accessor(std::vector<std::uint8_t>{1, 2, 0, 0, 3, 4}, 5121, "SCALAR", 1);
    Json& accessor = file.json["accessors"].back();
    accessor["type"] = "MAT2";
    accessor["count"] = 1;
    CHECK(loadBytes(file.bytes()).ok());
  }
}

TEST_CASE("Normals that are off unit length, a little or by far, are repaired with a warning") {
  GlbBuilder file = armBuilder();
  for (const auto& [length, words] :
       {std::pair(1.05F, "normals a little off unit length"),
        std::pair(3.0F, "normals that are not of unit length; they are repaired"),
        std::pair(0.0F, "normals that are not of unit length; they are repaired")}) {
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    const std::size_t position = attributes["POSITION"];
    const std::size_t count = file.json["accessors"][position]["count"];
    std::vector<float> normals;
    for (std::size_t i = 0; i < count; ++i) {
      normals.insert(normals.end(), {0.0F, 0.0F, length});
    }
    attributes["NORMAL"] = file.floats(normals, "VEC3", 3);
    const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
    REQUIRE(loaded);
    CHECK(warnsOf(*loaded, words));
    for (const glm::vec3& normal : loaded->scene->meshes[0].primitives[0].normals) {
      CHECK(glm::length(normal) == Approx(1.0F));
    }
  }
}

TEST_CASE("Normals of next to no length are those of the faces, longer ones keep their direction") {
  for (const auto& [length, isKept] :
       {std::pair(2e-5F, true), std::pair(2e-6F, true), std::pair(5e-7F, false)}) {
    CAPTURE(length);
    GlbBuilder file = armBuilder();
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    const std::size_t count = file.json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
    const glm::vec3 aside = glm::normalize(glm::vec3(1.0F, 2.0F, 3.0F));
    std::vector<float> normals;
    for (std::size_t i = 0; i < count; ++i) {
      normals.insert(normals.end(), {length * aside.x, length * aside.y, length * aside.z});
    }
    attributes["NORMAL"] = file.floats(normals, "VEC3", 3);
    const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
    REQUIRE(loaded);
    for (const glm::vec3& normal : loaded->scene->meshes[0].primitives[0].normals) {
      CHECK((glm::distance(normal, aside) < 1e-3F) == isKept);
    }
  }
}

TEST_CASE("Vertices whose weights are no numbers follow their neighbours, with a warning") {
  // Two triangles that share an edge, and a third one that shares a place with them alone.
  GlbBuilder file = armBuilder();
  file.json["meshes"][0]["primitives"][0].erase("mode");
  Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  attributes = Json::object();
  attributes["POSITION"] =
      file.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 1, 0, 2, 1, 0, 2, 2, 0}, "VEC3", 3);
  file.json["accessors"].back()["min"] = {0, 0, 0};
  file.json["accessors"].back()["max"] = {2, 2, 0};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  attributes["JOINTS_0"] = file.accessor(std::vector<std::uint8_t>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0,
                                                                   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                         5121, "VEC4", 4);
  std::vector<float> weights;
  for (int vertex = 0; vertex < 7; ++vertex) {
    const float weight = vertex < 3 ? 1.0F : nan;
    weights.insert(weights.end(), {weight, vertex < 3 ? 0.0F : nan, 0.0F, 0.0F});
  }
  attributes["WEIGHTS_0"] = file.floats(weights, "VEC4", 4);
  file.json["meshes"][0]["primitives"][0]["indices"] =
      file.accessor(std::vector<std::uint16_t>{0, 1, 2, 2, 1, 3, 4, 5, 6}, 5123, "SCALAR", 1);
  const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
  INFO((loaded ? std::string() : loaded.error().line()));
  REQUIRE(loaded);
  CHECK(warnsOf(*loaded, "4 vertices have no numbers for weights; such vertices follow their neighbours"));
  const std::vector<VertexInfluences>& influences = loaded->scene->meshes[0].primitives[0].influences;
  REQUIRE(influences.size() == 7);
  for (const VertexInfluences& vertex : influences) {
    CHECK(vertex.joints[0] == 1);
    CHECK(vertex.weights[0] == 1.0F);
  }
}

TEST_CASE(
    "A file opens for readers of glTF 2, whatever comes behind the point, and is refused for those of 3") {
  struct Case {
    const char* version;
    const char* least; ///< That a reader needs; "": nothing is said of it.
    bool isRead;
  };
  for (const Case& one : {Case{"2.0", "", true},
                          {"2.1", "", true},
                          {"2.0", "2.1", true},
                          {"2.0", "3.0", false},
                          {"3.0", "", false}}) {
    CAPTURE(one.version, one.least);
    GlbBuilder file = armBuilder();
    file.json["asset"]["version"] = one.version;
    if (*one.least != '\0') {
      file.json["asset"]["minVersion"] = one.least;
    }
    const Result<gltf::Loaded> loaded = loadBytes(file.bytes());
    CHECK(loaded.ok() == one.isRead);
    CHECK((loaded || loaded.error().where == "asset.version"));
  }
}
