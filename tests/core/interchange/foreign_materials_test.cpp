#include <cmath>

#include <assimp/material.h>
#include <catch2/catch.hpp>

#include "core/gltf/source/glb.h"
#include "tests/support/core/foreign_scene.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Bytes;
using gltf::Json;
using test::ForeignScene;
using test::MadeOfForeign;

namespace {

const Bytes pngHead{0x89, 'P', 'N', 'G', 1, 2, 3};
const Bytes jpegHead{0xFF, 0xD8, 0xFF, 0xE0, 9};

/// A TGA of two pixels: opaque red, then green that is half seen through.
Bytes targa() {
  Bytes bytes(18, 0);
  bytes[2] = 2;  // true colour
  bytes[12] = 2; // wide
  bytes[14] = 1; // high
  bytes[16] = 32;
  bytes[17] = 0x28; // from the top
  const Bytes pixels{0, 0, 255, 255, 0, 255, 0, 128};
  bytes.insert(bytes.end(), pixels.begin(), pixels.end());
  return bytes;
}

void setColour(aiMaterial& material, float r, float g, float b) {
  const aiColor3D colour(r, g, b);
  material.AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
}

void setTexture(aiMaterial& material, aiTextureType type, const std::string& name) {
  const aiString path(name);
  material.AddProperty(&path, AI_MATKEY_TEXTURE(type, 0));
}

/// The glTF material of one that `change` makes; the file lies in `folder`.
struct One {
  template <typename Change>
  explicit One(const Change& change, const std::filesystem::path& file = "none.dae") {
    ForeignScene scene;
    change(scene, scene.addMaterial("skin"));
    const aiScene& from = scene.scene();
    interchange::GlbParts parts;
    indices = interchange::addMaterials(from, file, parts, warnings);
    const Result<Bytes> glb = parts.finish();
    REQUIRE(glb);
    const Result<gltf::Glb> opened = gltf::readGlb(*glb);
    REQUIRE(opened);
    json = Json::parse(opened->json);
    binary = opened->binary;
    material = json["materials"][0];
    surface = material["pbrMetallicRoughness"];
  }

  Bytes pictureOf(std::size_t texture) const {
    const Json& image = json["images"][json["textures"][texture]["source"].get<std::size_t>()];
    const Json& view = json["bufferViews"][image["bufferView"].get<std::size_t>()];
    const auto start = binary.begin() + view["byteOffset"].get<std::ptrdiff_t>();
    return {start, start + view["byteLength"].get<std::ptrdiff_t>()};
  }

  std::vector<int> indices;
  std::vector<std::string> warnings;
  Json material;
  Json surface;
  Json json;
  Bytes binary;
};

float numberOf(const Json& json) {
  return json.get<float>();
}

} // namespace

TEST_CASE("A material without a word is light grey, rough, seen from both sides") {
  const One made([](ForeignScene&, aiMaterial&) {});
  CHECK(made.indices == std::vector<int>{0});
  CHECK(made.material["name"] == "skin");
  CHECK(made.material["doubleSided"] == true);
  CHECK(made.surface["metallicFactor"] == 0);
  CHECK(numberOf(made.surface["roughnessFactor"]) == 1.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(numberOf(made.surface["baseColorFactor"][i]) == Approx(0.8F));
  }
  CHECK(numberOf(made.surface["baseColorFactor"][3]) == 1.0F);
  for (const char* const never : {"normalTexture", "emissiveTexture", "emissiveFactor", "alphaMode"}) {
    CHECK_FALSE(made.material.contains(never));
  }
  CHECK_FALSE(made.surface.contains("baseColorTexture"));
  CHECK(made.warnings.empty());
}

TEST_CASE("A colour is kept within 0 and 1, and one that is no number is full") {
  const One made([](ForeignScene&, aiMaterial& material) { setColour(material, 0.25F, 3.0F, -1.0F); });
  CHECK(numberOf(made.surface["baseColorFactor"][0]) == 0.25F);
  CHECK(numberOf(made.surface["baseColorFactor"][1]) == 1.0F);
  CHECK(numberOf(made.surface["baseColorFactor"][2]) == 0.0F);
  const One odd([](ForeignScene&, aiMaterial& material) { setColour(material, std::nanf(""), 0.0F, 0.5F); });
  CHECK(numberOf(odd.surface["baseColorFactor"][0]) == 1.0F);
  CHECK(numberOf(odd.surface["baseColorFactor"][2]) == 0.5F);
}

TEST_CASE("What is half opaque is blended, and what is said to be wholly transparent is not") {
  const auto [opacity, alpha, isBlended] = GENERATE(table<float, float, bool>({{0.25F, 0.25F, true},
                                                                               {1.0F, 1.0F, false},
                                                                               {0.0F, 1.0F, false},
                                                                               {-2.0F, 1.0F, false},
                                                                               {5.0F, 1.0F, false}}));
  CAPTURE(opacity);
  const float said = opacity;
  const One made(
      [&](ForeignScene&, aiMaterial& material) { material.AddProperty(&said, 1, AI_MATKEY_OPACITY); });
  CHECK(numberOf(made.surface["baseColorFactor"][3]) == alpha);
  CHECK(made.material.contains("alphaMode") == isBlended);
  CHECK(made.material.value("alphaMode", "BLEND") == "BLEND");
}

TEST_CASE("The shinier a material, the smoother it is: one less the root of a hundredth, 0.3 at least") {
  const auto [shininess, roughness] = GENERATE(table<float, float>({{0.0F, 1.0F},
                                                                    {4.0F, 0.8F},
                                                                    {25.0F, 0.5F},
                                                                    {49.0F, 0.3F},
                                                                    {100.0F, 0.3F},
                                                                    {1000.0F, 0.3F},
                                                                    {-9.0F, 1.0F}}));
  CAPTURE(shininess);
  const float said = shininess;
  const One made(
      [&](ForeignScene&, aiMaterial& material) { material.AddProperty(&said, 1, AI_MATKEY_SHININESS); });
  CHECK(numberOf(made.surface["roughnessFactor"]) == Approx(roughness));
}

TEST_CASE("A picture inside the file stands in place of the colour, and keeps how opaque it is") {
  const One made([](ForeignScene& scene, aiMaterial& material) {
    scene.addPicture("C:\\work\\cloth.png", pngHead);
    setColour(material, 0.5F, 0.5F, 0.5F);
    const float opacity = 0.5F;
    material.AddProperty(&opacity, 1, AI_MATKEY_OPACITY);
    setTexture(material, aiTextureType_DIFFUSE, "C:\\work\\cloth.png");
  });
  CHECK(made.surface["baseColorFactor"] == Json{1, 1, 1, 0.5F});
  CHECK(made.surface["baseColorTexture"] == Json{{"index", 0}});
  CHECK(made.json["images"][0]["name"] == "cloth.png");
  CHECK(made.json["images"][0]["mimeType"] == "image/png");
  CHECK(made.pictureOf(0) == pngHead);
  CHECK(made.warnings.empty());
}

TEST_CASE("Pictures of colour, relief and glow go each to its own place, and one that several name is "
          "written once") {
  const One made([](ForeignScene& scene, aiMaterial& material) {
    scene.addPicture("a.png", pngHead);
    scene.addPicture("b.jpg", jpegHead);
    setTexture(material, aiTextureType_BASE_COLOR, "a.png");
    setTexture(material, aiTextureType_NORMALS, "b.jpg");
    setTexture(material, aiTextureType_EMISSIVE, "a.png");
  });
  const auto relief = made.material["normalTexture"]["index"].get<std::size_t>();
  const auto colour = made.surface["baseColorTexture"]["index"].get<std::size_t>();
  CHECK(made.material["emissiveTexture"]["index"] == colour);
  CHECK(made.material["emissiveFactor"] == Json{1, 1, 1});
  CHECK(made.pictureOf(relief) == jpegHead);
  CHECK(made.pictureOf(colour) == pngHead);
  CHECK(made.json["images"].size() == 2);
  CHECK(made.json["images"][made.json["textures"][relief]["source"].get<std::size_t>()]["mimeType"] ==
        "image/jpeg");
  CHECK_FALSE(made.material.contains("alphaMode"));
}

TEST_CASE("A diffuse picture goes before one of the base colour") {
  const One made([](ForeignScene& scene, aiMaterial& material) {
    scene.addPicture("old.png", pngHead);
    scene.addPicture("new.jpg", jpegHead);
    setTexture(material, aiTextureType_BASE_COLOR, "new.jpg");
    setTexture(material, aiTextureType_DIFFUSE, "old.png");
  });
  CHECK(made.pictureOf(made.surface["baseColorTexture"]["index"].get<std::size_t>()) == pngHead);
}

TEST_CASE("A picture of another kind is made a PNG with the same pixels, one that is none is left out") {
  const One made([](ForeignScene& scene, aiMaterial& material) {
    scene.addPicture("a.tga", targa());
    setTexture(material, aiTextureType_DIFFUSE, "a.tga");
  });
  CHECK(made.json["images"][0]["mimeType"] == "image/png");
  const Bytes png = made.pictureOf(0);
  REQUIRE(png.size() > 8);
  CHECK(std::string(png.begin() + 1, png.begin() + 4) == "PNG");
  const One none([](ForeignScene& scene, aiMaterial& material) {
    scene.addPicture("a.dds", {'D', 'D', 'S', ' ', 1, 2, 3, 4});
    setTexture(material, aiTextureType_DIFFUSE, "a.dds");
  });
  CHECK(none.warnings ==
        std::vector<std::string>{"the texture 'a.dds' is of a kind that is not read, and is left out"});
  CHECK_FALSE(none.surface.contains("baseColorTexture"));
}

TEST_CASE("Pixels inside the file are shown as they lie there") {
  ForeignScene scene;
  aiTexture& picture = scene.addPicture("raw", Bytes(8));
  picture.mWidth = 1;
  picture.mHeight = 2;
  picture.pcData[0].r = 255;
  picture.pcData[0].a = 255;
  picture.pcData[1].b = 200;
  picture.pcData[1].g = 30;
  picture.pcData[1].a = 255;
  setTexture(scene.addMaterial("skin"), aiTextureType_DIFFUSE, "raw");
  scene.show(scene.addNode(scene.root(), "cloth"), 0);
  scene.addTriangle("cloth", {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)});
  const MadeOfForeign made = test::madeOfForeign(scene);
  REQUIRE(made.file.scene->images.size() == 1);
  const Image& image = made.file.scene->images[0];
  CHECK(image.width == 1);
  CHECK(image.height == 2);
  CHECK(image.rgba == std::vector<std::uint8_t>{255, 0, 0, 255, 0, 30, 200, 255});
}

TEST_CASE(
    "A picture beside the file is found by its path, by its name, and in the folders that programs make") {
  const auto [said, lies] = GENERATE(table<std::string, std::string>({
      {"cloth.png", "cloth.png"},
      {"maps/cloth.png", "maps/cloth.png"},
      {"maps\\cloth.png", "maps/cloth.png"},
      {"C:\\Users\\someone\\cloth.png", "cloth.png"},
      {"/anywhere/cloth.png", "cloth.png"},
      {"../../cloth.png", "cloth.png"},
      {"elsewhere/cloth.png", "textures/cloth.png"},
      {"elsewhere/cloth.png", "Textures/cloth.png"},
      {"elsewhere/cloth.png", "dancer.fbm/cloth.png"},
  }));
  CAPTURE(said, lies);
  const test::TemporaryFolder folder;
  const std::filesystem::path place = folder.path() / lies;
  std::filesystem::create_directories(place.parent_path());
  test::writeBytes(place, pngHead);
  const std::string name = said;
  const One made(
      [&](ForeignScene&, aiMaterial& material) { setTexture(material, aiTextureType_DIFFUSE, name); },
      folder.path() / "dancer.fbx");
  CHECK(made.warnings.empty());
  REQUIRE(made.surface.contains("baseColorTexture"));
  CHECK(made.pictureOf(0) == pngHead);
  CHECK(made.json["images"][0]["name"] == "cloth.png");
}

TEST_CASE(
    "A picture where the file says goes before one of its name elsewhere, and none is taken from outside") {
  const test::TemporaryFolder folder;
  const std::filesystem::path inner = folder.path() / "work";
  std::filesystem::create_directories(inner / "maps");
  test::writeBytes(inner / "maps/cloth.png", jpegHead);
  test::writeBytes(inner / "cloth.png", pngHead);
  test::writeBytes(folder.path() / "secret.png", pngHead);
  const auto named = [&](const std::string& name) {
    return One(
        [&](ForeignScene&, aiMaterial& material) { setTexture(material, aiTextureType_DIFFUSE, name); },
        inner / "dancer.fbx");
  };
  CHECK(named("maps/cloth.png").pictureOf(0) == jpegHead);
  CHECK(named("cloth.png").pictureOf(0) == pngHead);
  for (const std::string& outside : {std::string("../secret.png"), (folder.path() / "secret.png").string()}) {
    const One made = named(outside);
    CHECK(made.warnings ==
          std::vector<std::string>{"the texture 'secret.png' is not beside the file, and is left out"});
    CHECK_FALSE(made.surface.contains("baseColorTexture"));
    CHECK(numberOf(made.surface["baseColorFactor"][0]) == Approx(0.8F));
  }
}

TEST_CASE("A texture that cannot be read is told once, however often it is named") {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "a.dds", {'D', 'D', 'S', ' '});
  const One made(
      [&](ForeignScene& scene, aiMaterial& material) {
        setTexture(material, aiTextureType_DIFFUSE, "a.dds");
        setTexture(material, aiTextureType_NORMALS, "a.dds");
        setTexture(scene.addMaterial("other"), aiTextureType_EMISSIVE, "a.dds");
      },
      folder.path() / "dancer.fbx");
  CHECK(made.warnings ==
        std::vector<std::string>{"the texture 'a.dds' is of a kind that is not read, and is left out"});
  CHECK(made.indices == std::vector<int>{0, 1});
  CHECK_FALSE(made.json["materials"][1].contains("emissiveFactor"));
  CHECK_FALSE(made.json.contains("textures"));
}
