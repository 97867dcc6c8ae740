#include <array>
#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include <glm/geometric.hpp>
#include <webp/encode.h>

#include "core/gltf/json/json.h"
#include "core/gltf/source/pictures.h"
#include "core/gltf/source/uri.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;
using test::loaded;

namespace {

// Two by two pixels: red, half-transparent green, blue, and one with the bytes 1 2 3 4.
constexpr const char* picture =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAF0lEQVR4nGP4z8DwHwgbGID0f0Ym"
    "ZhYAOvAFhmzG3xIAAAAASUVORK5CYII=";
// Claims to be 60000 by 60000 pixels and holds none.
constexpr const char* hugePicture =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAA6mAAAOpgCAYAAACA0nVCAAAAC0lEQVR4nGNggAEAAAoAAX+A"
    "dF4AAAAASUVORK5CYII=";

GlbBuilder texturedArm(const char* uri) {
  GlbBuilder glb = test::armBuilder();
  glb.json["images"] = {{{"uri", uri}}};
  glb.json["samplers"] = {{{"magFilter", 9728}}};
  glb.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  glb.json["materials"] = Json::parse(R"([{
    "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 0.75],
      "baseColorTexture": {"index": 0, "texCoord": 0,
        "extensions": {"KHR_texture_transform": {"offset": [0.1, 0.2], "scale": [2, 3], "texCoord": 1}}}},
    "alphaMode": "MASK", "alphaCutoff": 0.3, "emissiveFactor": [1, 0, 0.5], "extensions": {"KHR_materials_unlit": {}}}])");
  const int coordinates = glb.floats({0, 0, 1, 0, 0, 1, 1, 1, 0, 2, 1, 2}, "VEC2", 2);
  glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = coordinates;
  return glb;
}

std::string webpUri(const std::vector<std::uint8_t>& rgba, int width, int height) {
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, width * 4, &encoded);
  const gltf::Bytes bytes(encoded, encoded + size);
  WebPFree(encoded);
  return "data:image/webp;base64," + gltf::encodeBase64(bytes);
}

// The same numbers for each of the arm's vertices.
template <typename Number>
std::vector<Number> sixTimes(const std::array<Number, 4>& numbers) {
  std::vector<Number> all;
  for (int vertex = 0; vertex < 6; ++vertex) {
    for (const Number number : numbers) {
      all.push_back(number);
    }
  }
  return all;
}

} // namespace

TEST_CASE("A material arrives with its texture, transform and flags") {
  const gltf::Loaded file = loaded(texturedArm(picture));
  CHECK(file.warnings.empty());
  const Material& material = file.scene->materials[0];
  CHECK(material.baseColor == glm::vec4(0.5F, 0.25F, 1.0F, 0.75F));
  CHECK(material.baseColorTexture.image == 0);
  CHECK(material.baseColorTexture.uvTransform == glm::mat3x2(2.0F, 0.0F, 0.0F, 3.0F, 0.1F, 0.2F));
  CHECK(material.baseColorTexture.nearestFilter);
  CHECK(material.alphaMode == AlphaMode::mask);
  CHECK(material.alphaCutoff == 0.3F);
  CHECK(material.emissive == glm::vec3(1.0F, 0.0F, 0.5F));
  CHECK(material.unlit);
  CHECK(file.scene->meshes[0].primitives[0].texCoords[3] == glm::vec2(1.0F, 1.0F)); // the set that the
                                                                                    // transform names
}

TEST_CASE("Pixels are decoded row by row from the top") {
  const gltf::Loaded file = loaded(texturedArm(picture));
  const Image& image = file.scene->images[0];
  CHECK(image.width == 2);
  CHECK(image.height == 2);
  CHECK(image.rgba == std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 255, 1, 2, 3, 4});
}

TEST_CASE("A texture that cannot be shown is a warning, the model opens") {
  const char* const uri = GENERATE(as<const char*>(), "gone.png", "data:image/png;base64,AAAA", hugePicture,
                                   "../../../etc/passwd");
  const gltf::Loaded file = loaded(texturedArm(uri));
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::StartsWith("images[0]: "));
  CHECK(file.scene->images[0].rgba.empty());
}

TEST_CASE("A texture of an extension that names none of the file's is not shown") {
  GlbBuilder glb = texturedArm(picture);
  const Json texture = GENERATE(Json::object(), Json{{"index", 1}}, Json{{"index", -1}});
  glb.json["materials"][0] = {
      {"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseTexture", texture}}}}}};
  glb.json["extensionsUsed"].push_back("KHR_materials_pbrSpecularGlossiness");
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  CHECK(file->scene->materials[0].baseColorTexture.image == -1);
}

TEST_CASE("Where nothing is drawn a picture's header is looked at alone, and told of as before") {
  const test::TemporaryFolder folder;
  const auto opened = [&](const char* uri, gltf::Pictures pictures) {
    texturedArm(uri).write(folder / "arm.glb");
    return *gltf::load(folder / "arm.glb", gltf::Tolerance::refuse, pictures);
  };
  for (const char* const uri : {picture, "gone.png", "data:image/png;base64,AAAA", hugePicture}) {
    CAPTURE(uri);
    const gltf::Loaded shown = opened(uri, gltf::Pictures::decoded);
    const gltf::Loaded unshown = opened(uri, gltf::Pictures::headers);
    CHECK(unshown.warnings == shown.warnings);
    REQUIRE(unshown.scene->images.size() == shown.scene->images.size());
    CHECK(unshown.scene->images[0].rgba.empty());
    CHECK(shown.scene->images[0].rgba.empty() == (uri != picture));
  }
}

TEST_CASE("A KTX2 texture is told once and its material shown plain") {
  GlbBuilder glb = texturedArm(picture);
  glb.json["textures"] = {{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
  glb.json["extensionsUsed"].push_back("KHR_texture_basisu");
  glb.json["extensionsRequired"] = {"KHR_texture_basisu"};
  glb.json["materials"].push_back(glb.json["materials"][0]);
  const gltf::Loaded file = loaded(glb);
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::Contains("KTX2"));
  CHECK(file.scene->materials[0].baseColorTexture.image == -1);
  CHECK(file.scene->materials[0].baseColor == glm::vec4(0.5F, 0.25F, 1.0F, 0.75F));
}

TEST_CASE("A WebP texture is decoded and goes before the one for other readers") {
  GlbBuilder glb = texturedArm(picture);
  const std::vector<std::uint8_t> pixels{255, 0, 0, 255, 0, 255, 0, 255, 9, 8, 7, 255};
  glb.json["images"].push_back({{"uri", webpUri(pixels, 3, 1)}});
  glb.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 1;
  const gltf::Loaded file = loaded(glb);
  CHECK(file.warnings.empty());
  CHECK(file.scene->materials[0].baseColorTexture.image == 1);
  CHECK(file.scene->images[1].width == 3);
  CHECK(file.scene->images[1].rgba == pixels);

  glb.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 44;
  CHECK(loaded(glb).scene->materials[0].baseColorTexture.image == 0);
}

TEST_CASE("A WebP texture that is cut short is a warning, the model opens") {
  GlbBuilder glb = texturedArm(picture);
  const std::string whole = webpUri(std::vector<std::uint8_t>(64 * 64 * 4, 77), 64, 64);
  glb.json["images"].push_back({{"uri", whole.substr(0, whole.size() / 8 * 4)}});
  glb.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 1;
  const gltf::Loaded file = loaded(glb);
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::StartsWith("images[1]: "));
}

TEST_CASE("A texture is turned as viewers turn it: scaled first, moved last") {
  GlbBuilder glb = texturedArm(picture);
  glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
          ["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}};
  glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"];
  const gltf::Loaded file = loaded(glb);
  CHECK(file.warnings.empty());
  const glm::mat3x2& transform = file.scene->materials[0].baseColorTexture.uvTransform;
  const glm::vec2 alongU = transform * glm::vec3(1.0F, 0.0F, 1.0F);
  const glm::vec2 alongV = transform * glm::vec3(0.0F, 1.0F, 1.0F);
  CHECK(glm::distance(alongU, {0.5F, 0.25F - 2.0F}) < 1e-5F);
  CHECK(glm::distance(alongV, {0.5F + 3.0F, 0.25F}) < 1e-5F);
}

TEST_CASE("Texture coordinates may be whole numbers where these stand for 0 to 1") {
  GlbBuilder glb = texturedArm(picture);
  const std::vector<std::uint16_t> numbers{0, 0, 65535, 0, 0, 65535, 65535, 65535, 0, 13107, 65535, 26214};
  const int coordinates = glb.accessor(numbers, 5123, "VEC2", 2);
  Json& accessor = glb.json["accessors"][coordinates];
  accessor["normalized"] = true;
  glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = coordinates;
  const gltf::Loaded file = loaded(glb);
  CHECK(file.warnings.empty());
  CHECK(file.scene->meshes[0].primitives[0].texCoords[1] == glm::vec2(1.0F, 0.0F));
  CHECK(glm::distance(file.scene->meshes[0].primitives[0].texCoords[5], {1.0F, 0.4F}) < 1e-6F);
  accessor.erase("normalized");
  const auto counted = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(counted.ok());
  CHECK(counted.error().what == "its accessor has a type that TEXCOORD_1 cannot have");
}

TEST_CASE("A sampler says how a texture goes on beyond its edges") {
  GlbBuilder glb = texturedArm(picture);
  CHECK(loaded(glb).scene->materials[0].baseColorTexture.wrapU == TextureWrap::repeat);
  glb.json["samplers"][0]["wrapS"] = 33071;
  glb.json["samplers"][0]["wrapT"] = 33648;
  const TextureUse use = loaded(glb).scene->materials[0].baseColorTexture;
  CHECK(use.wrapU == TextureWrap::clamp);
  CHECK(use.wrapV == TextureWrap::mirror);
}

TEST_CASE("Light of its own has a factor, a strength and a texture with coordinates of its own") {
  GlbBuilder glb = texturedArm(picture);
  Json& material = glb.json["materials"][0];
  material["emissiveFactor"] = {1, 0.5, 0};
  material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 4;
  glb.json["images"].push_back({{"uri", picture}});
  glb.json["textures"].push_back({{"source", 1}});
  material["emissiveTexture"] = {{"index", 1}, {"texCoord", 0}};
  const int coordinates = glb.floats({0, 0, .1F, 0, 0, .1F, .1F, .1F, 0, .2F, .1F, .2F}, "VEC2", 2);
  glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = coordinates;
  const gltf::Loaded file = loaded(glb);
  CHECK(file.warnings.empty());
  CHECK(file.scene->materials[0].emissive == glm::vec3(4.0F, 2.0F, 0.0F));
  CHECK(file.scene->materials[0].emissiveTexture.image == 1);
  CHECK(file.scene->images[1].width == 2);
  CHECK(file.scene->meshes[0].primitives[0].texCoords[3] == glm::vec2(1.0F, 1.0F));
  CHECK(file.scene->meshes[0].primitives[0].emissiveTexCoords[3] == glm::vec2(0.1F, 0.1F));
}

TEST_CASE("What glows by a texture that cannot be shown does not glow all over") {
  GlbBuilder glb = texturedArm(picture);
  glb.json["textures"].push_back({{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
  glb.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
  glb.json["materials"][0]["emissiveTexture"] = {{"index", 1}, {"texCoord", 1}};
  const gltf::Loaded file = loaded(glb);
  CHECK(file.warnings.size() == 1);
  CHECK(file.scene->materials[0].emissive == glm::vec3(0.0F));
}

TEST_CASE("Colours of vertices are read from floats and from normalised integers, with alpha and without") {
  GlbBuilder glb = test::armBuilder();
  int colors = -1;
  SECTION("bytes without alpha, padded to four") {
    const auto bytes = sixTimes<std::uint8_t>({255, 51, 0, 0});
    colors = glb.accessor(bytes, 5121, "VEC4", 4);
    glb.json["accessors"].back()["type"] = "VEC3";
    glb.json["bufferViews"].back()["byteStride"] = 4;
    glb.json["accessors"].back()["normalized"] = true;
  }
  SECTION("shorts") {
    const auto shorts = sixTimes<std::uint16_t>({65535, 13107, 0, 65535});
    colors = glb.accessor(shorts, 5123, "VEC4", 4);
    glb.json["accessors"].back()["normalized"] = true;
  }
  SECTION("floats") {
    const auto floats = sixTimes<float>({1.0F, 0.2F, 0.0F, 1.0F});
    colors = glb.floats(floats, "VEC4", 4);
  }
  glb.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colors;
  const gltf::Loaded file = loaded(glb);
  REQUIRE(file.scene->meshes[0].primitives[0].colors.size() == 6);
  CHECK(glm::distance(file.scene->meshes[0].primitives[0].colors[5], {1.0F, 0.2F, 0.0F, 1.0F}) < 1e-5F);
}

TEST_CASE("The WebP picture of a texture may be the first one of the file") {
  GlbBuilder glb = texturedArm(webpUri({9, 8, 7, 255}, 1, 1).c_str());
  glb.json["images"].push_back({{"uri", picture}});
  glb.json["textures"][0] = {{"source", 1}, {"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  const gltf::Loaded file = loaded(glb);
  CHECK(file.scene->materials[0].baseColorTexture.image == 0);
  CHECK(file.scene->images[0].rgba == std::vector<std::uint8_t>{9, 8, 7, 255});
  CHECK(file.scene->images[1].rgba.empty());
}

TEST_CASE("A strength of light below 0 is none") {
  GlbBuilder glb = texturedArm(picture);
  glb.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = -2;
  CHECK(loaded(glb).scene->materials[0].emissive == glm::vec3(0.0F));
}
