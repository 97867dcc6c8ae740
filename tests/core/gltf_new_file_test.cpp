#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <dlfcn.h>

#include <stb/stb_image.h>
#include <tiny_gltf.h>

#include "core/gltf/import/material_library.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/write/new_file.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Bytes;
using gltf::Json;
using gltf::NewFile;
using gltf::Source;
using gltf::ViewTarget;

namespace {

const Bytes png{0x89, 'P', 'N', 'G', 1, 2, 3};
const Bytes jpeg{0xFF, 0xD8, 0xFF, 0xE0, 7};
const Bytes webp{'R', 'I', 'F', 'F', 4, 0, 0, 0, 'W', 'E', 'B', 'P'};

std::size_t addTriangle(NewFile& file, std::optional<std::size_t> material = {}) {
  const std::size_t mesh = file.addMesh("flag");
  gltf::NewPrimitive primitive;
  primitive.attributes["POSITION"] =
      file.addAccessor(std::vector<float>{0, 0, 0, 2, 0, 0, 0, 3, -1},
                       {.width = 3, .target = ViewTarget::vertices, .bounds = true});
  primitive.attributes["JOINTS_0"] =
      file.addAccessor(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
                       {.width = 4, .target = ViewTarget::vertices});
  primitive.attributes["WEIGHTS_0"] = file.addAccessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
                                                       {.width = 4, .target = ViewTarget::vertices});
  primitive.indices = file.addAccessor(std::vector<std::uint16_t>{0, 1, 2}, {.target = ViewTarget::indices});
  primitive.material = material;
  file.addPrimitive(mesh, primitive);
  return mesh;
}

std::vector<float> matricesOf(float x) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1};
}

/// A flag on two joints with a clip that moves, turns and scales the second one.
Source flag() {
  NewFile file({"a test", "nobody", "field"});
  const std::size_t material = file.addMaterial(
      {.name = "cloth", .baseColor = {0.5, 0.25, 1.0, 0.75}, .emissive = {0.0, 0.5, 0.0}, .isBlended = true});
  const std::size_t mesh = addTriangle(file, material);
  const std::size_t pole = file.addNode("pole");
  const std::size_t tip = file.addNode("tip", pole);
  file.setNode(tip, Channel::translation, {1.0, 2.0, 3.0});
  file.setNode(tip, Channel::rotation, {0.0, 1.0, 0.0, 0.0});
  file.setNode(tip, Channel::scale, {1.0, 0.5, 2.0});
  std::vector<float> matrices = matricesOf(0.0F);
  const std::vector<float> second = matricesOf(-4.0F);
  matrices.insert(matrices.end(), second.begin(), second.end());
  const std::size_t skin =
      file.addSkin("cloth", file.addAccessor(matrices, {.width = 16}), pole, {pole, tip});
  file.setMesh(file.addNode("shown"), mesh, skin);
  file.addClip("never"); // without a channel
  const std::size_t wave = file.addClip("wave");
  file.setRate(wave, 12.5);
  const std::size_t times = file.addAccessor(std::vector<float>{0.0F, 0.5F}, {.bounds = true});
  const std::size_t places = file.addAccessor(std::vector<float>{0, 0, 0, 4, 0, 0}, {.width = 3});
  const std::size_t turns = file.addAccessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0},
                                             {.width = 4, .normalised = true});
  file.addChannel(wave, file.addSampler(wave, times, places), tip, Channel::translation);
  file.addChannel(wave, file.addSampler(wave, times, turns, Interpolation::step), tip, Channel::rotation);
  return file.finish();
}

/// The file on the disk and back.
gltf::Loaded reopened(const Source& source) {
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(source, folder.path() / "new.glb"));
  auto loaded = gltf::load(folder.path() / "new.glb");
  if (!loaded) {
    FAIL(loaded.error().line());
  }
  return std::move(loaded).value();
}

/// Name of the file that holds the code at an address.
std::string libraryOf(const void* address) {
  Dl_info info{};
  REQUIRE(dladdr(address, &info) != 0);
  return info.dli_fname;
}

} // namespace

TEST_CASE("A new file opens as it was made: nodes, skin, mesh, material and the clip that has channels") {
  const gltf::Loaded loaded = reopened(flag());
  CHECK(loaded.warnings.empty());
  const Scene& scene = *loaded.scene;
  REQUIRE(scene.nodes.size() == 3);
  CHECK(scene.roots == std::vector<NodeIndex>{NodeIndex(0), NodeIndex(2)});
  CHECK(scene.nodes[1].parent == NodeIndex(0));
  CHECK(scene.nodes[1].name == "tip");
  CHECK(scene.nodes[1].rest.translation == Vec3(1.0, 2.0, 3.0));
  CHECK(scene.nodes[1].rest.rotation == Quat(0.0, 0.0, 1.0, 0.0));
  CHECK(scene.nodes[1].rest.scale == Vec3(1.0, 0.5, 2.0));
  REQUIRE(scene.skins.size() == 1);
  CHECK(scene.skins[0].joints == std::vector<NodeIndex>{NodeIndex(0), NodeIndex(1)});
  CHECK(scene.skins[0].inverseBind[1][3].x == -4.0);
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].primitives[0].positions[2] == glm::vec3(0, 3, -1));
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].baseColor == glm::vec4(0.5F, 0.25F, 1.0F, 0.75F));
  CHECK(scene.materials[0].emissive == glm::vec3(0.0F, 0.5F, 0.0F));
  CHECK(scene.materials[0].alphaMode == AlphaMode::blend);
  CHECK_FALSE(scene.materials[0].doubleSided);
  REQUIRE(loaded.clips.size() == 1);
  CHECK(loaded.clips[0].name == "wave");
  REQUIRE(loaded.clips[0].tracks.size() == 2);
  CHECK(loaded.clips[0].tracks[0]->interpolation == Interpolation::linear);
  CHECK(loaded.clips[0].tracks[1]->interpolation == Interpolation::step);
  CHECK(loaded.clips[0].tracks[0]->times == std::vector<float>{0.0F, 0.5F});
}

TEST_CASE(
    "A new file holds its labels, the rate of a clip, bounds where they were asked for, and nothing that "
    "goes without saying") {
  const Source source = flag();
  const Json& json = source.json;
  CHECK(json["asset"] == Json({{"copyright", "nobody"}, {"generator", "a test"}, {"version", "2.0"}}));
  CHECK(json["scenes"][0]["name"] == "field");
  CHECK(json["skins"][0]["skeleton"] == 0);
  CHECK(json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] == 0.0);
  CHECK(json["animations"][0]["extras"]["stretch_engine"]["frames_per_second"] == 12.5);
  CHECK(json["accessors"][0]["min"] == Json({0.0, 0.0, -1.0}));
  CHECK(json["accessors"][0]["max"] == Json({2.0, 3.0, 0.0}));
  CHECK_FALSE(json["accessors"][1].contains("min"));
  CHECK(json["bufferViews"][3]["target"] == 34963);
  CHECK_FALSE(json["bufferViews"][4].contains("target"));
  CHECK_FALSE(json["meshes"][0]["primitives"][0].contains("mode"));
  REQUIRE(source.buffers.size() == 1);
  CHECK(json["buffers"][0]["byteLength"] == source.buffers[0].size());
  CHECK(source.buffers[0].size() % 4 == 0);
  for (const Json& view : json["bufferViews"]) {
    CHECK(view.value("byteOffset", 0) % 4 == 0);
  }
}

TEST_CASE(
    "Numbers that are stored farther apart than they are wide say so, and bounds leave out what is between") {
  NewFile file;
  const std::size_t accessor =
      file.addAccessor(std::vector<std::int16_t>{1, -2, 3, 99, 4, 5, -6, 99, 2, 2, 2, 99, 2, 2, 2, 99},
                       {.width = 3, .normalised = true, .bounds = true, .stored = 4});
  const Source source = file.finish();
  const Json& told = (*source.json)["accessors"][accessor];
  CHECK(told["count"] == 4);
  CHECK(told["type"] == "VEC3");
  CHECK(told["normalized"] == true);
  CHECK(told["min"] == Json({1, -2, -6}));
  CHECK(told["max"] == Json({4, 5, 3}));
  CHECK((*source.json)["bufferViews"][0]["byteStride"] == 8);
}

TEST_CASE("Each kind of number is told by its type") {
  NewFile file;
  file.addAccessor(std::vector<std::int8_t>{1}, {});
  file.addAccessor(std::vector<std::uint8_t>{1, 2}, {.width = 2});
  file.addAccessor(std::vector<std::int16_t>{1}, {});
  file.addAccessor(std::vector<std::uint16_t>{1}, {});
  file.addAccessor(std::vector<std::uint32_t>{1}, {});
  file.addAccessor(std::vector<float>{1}, {});
  const Source source = file.finish();
  std::vector<int> types;
  for (const Json& accessor : (*source.json)["accessors"]) {
    types.push_back(accessor["componentType"].get<int>());
    CHECK_FALSE(accessor.contains("normalized"));
  }
  CHECK(types == std::vector<int>{5120, 5121, 5122, 5123, 5125, 5126});
  CHECK((*source.json)["accessors"][1]["type"] == "VEC2");
}

TEST_CASE("Images are told by how they begin, and a WebP picture by its extension, once") {
  NewFile file;
  CHECK(file.addTexture(png, "a.png") == 0);
  CHECK(file.addTexture(jpeg, "b") == 1);
  CHECK(file.addTexture(webp, "c") == 2);
  CHECK(file.addTexture(webp, "d") == 3);
  file.addMaterial({.name = "m", .baseColorTexture = 1, .normalTexture = 0, .emissiveTexture = 2});
  const Source source = file.finish();
  const Json& json = source.json;
  CHECK(json["images"][0] == Json({{"bufferView", 0}, {"mimeType", "image/png"}, {"name", "a.png"}}));
  CHECK(json["images"][1]["mimeType"] == "image/jpeg");
  CHECK(json["images"][2]["mimeType"] == "image/webp");
  CHECK(json["textures"][1] == Json({{"source", 1}}));
  CHECK(json["textures"][2]["extensions"]["EXT_texture_webp"]["source"] == 2);
  CHECK_FALSE(json["textures"][2].contains("source"));
  CHECK(json["extensionsUsed"] == Json::array({"EXT_texture_webp"}));
  CHECK_FALSE(json.contains("extensionsRequired"));
  const Json& material = json["materials"][0];
  CHECK(material["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 1);
  CHECK(material["normalTexture"]["index"] == 0);
  CHECK(material["emissiveTexture"]["index"] == 2);
  CHECK_FALSE(json.contains("scenes"));
  CHECK_FALSE(json.contains("scene"));
  CHECK(gltf::mediaTypeOf(Bytes{'G', 'I', 'F', '8'}) == std::nullopt);
  CHECK(gltf::mediaTypeOf(Bytes{'R', 'I', 'F', 'F', 4, 0, 0, 0, 'W', 'A', 'V', 'E'}) == std::nullopt);
}

TEST_CASE(
    "Materials of another file come over with properties that no library knows, and with their images") {
  Source library;
  library.json = Json::parse(R"({"materials": [{"name": "skin", "unheardOf": [1.5, null]}],
    "textures": [{"source": 0}], "images": [{"mimeType": "image/png", "bufferView": 1}],
    "bufferViews": [{"buffer": 0, "byteLength": 4}, {"buffer": 0, "byteOffset": 4, "byteLength": 7}],
    "extensionsUsed": ["KHR_materials_unlit", "X_b"], "extensionsRequired": ["X_b"]})");
  library.buffers = {{9, 9, 9, 9}};
  library.buffers[0].insert(library.buffers[0].end(), png.begin(), png.end());
  NewFile file;
  file.addAccessor(std::vector<float>{1.0F}, {});
  file.takeMaterials(library);
  file.requireExtension("KHR_mesh_quantization");
  file.requireExtension("X_b");
  file.setMesh(file.addNode("n"), addTriangle(file, 0), std::nullopt);
  const Source source = file.finish();
  const Json& json = source.json;
  CHECK(json["materials"] == (*library.json)["materials"]);
  CHECK(json["textures"] == (*library.json)["textures"]);
  CHECK(json["images"][0]["bufferView"] == 1);
  const Json& view = json["bufferViews"][1];
  const auto first = source.buffers[0].begin() + view["byteOffset"].get<std::ptrdiff_t>();
  CHECK(Bytes(first, first + view["byteLength"].get<std::ptrdiff_t>()) == png);
  CHECK(json["extensionsUsed"] == Json({"KHR_materials_unlit", "X_b", "KHR_mesh_quantization"}));
  CHECK(json["extensionsRequired"] == Json({"X_b", "KHR_mesh_quantization"}));
}

TEST_CASE("Names that are no valid UTF-8 become such, and the file opens") {
  NewFile file;
  file.setMesh(file.addNode("caf\xE9"), addTriangle(file, file.addMaterial({.name = "\xFF"})), std::nullopt);
  const gltf::Loaded loaded = reopened(file.finish());
  CHECK(loaded.scene->nodes[0].name == "caf\xEF\xBF\xBD");
}

TEST_CASE("tinygltf and stb answer from their own libraries, not from the copies in Debian's libdraco, which "
          "assimp loads") {
  CHECK_THAT(libraryOf(reinterpret_cast<const void*>(&tinygltf::FileExists)), Catch::Contains("libtinygltf"));
  CHECK_THAT(libraryOf(reinterpret_cast<const void*>(&stbi_load_from_memory)), Catch::Contains("libstb"));
  const void* const first = dlsym(RTLD_DEFAULT, "stbi_load_from_memory"); // as a library would find it
  CHECK_THAT(libraryOf(first), Catch::Contains("libstb"));
}
