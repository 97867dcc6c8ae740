#include <catch2/catch.hpp>

#include "core/gltf/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

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

gltf::Loaded loaded(const GlbBuilder& glb) {
  Result<gltf::Loaded> result = test::loadBytes(glb.bytes());
  if (!result) {
    FAIL(result.error().line());
  }
  return std::move(result.value());
}

} // namespace

TEST_CASE("A material arrives with its texture, transform and flags") {
  const gltf::Loaded file = loaded(texturedArm(picture));
  CHECK(file.warnings.empty());
  const Material& material = file.scene->materials[0];
  CHECK(material.baseColor == glm::vec4(0.5F, 0.25F, 1.0F, 0.75F));
  CHECK(material.baseColorImage == 0);
  CHECK(material.uvTransform == std::array<float, 4>{2.0F, 3.0F, 0.1F, 0.2F});
  CHECK(material.nearestFilter);
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

TEST_CASE("A texture in a format of an extension is a warning") {
  GlbBuilder glb = texturedArm(picture);
  glb.json["textures"] = {{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
  const gltf::Loaded file = loaded(glb);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.scene->materials[0].baseColorImage == -1);
}
