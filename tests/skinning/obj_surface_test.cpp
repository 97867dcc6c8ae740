// Looks of an OBJ and of its MTL files: what a texture lies on, which way the surface faces, how it shines.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/source.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/obj_surface.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using Catch::Contains;

namespace {

using SurfacePointer = std::shared_ptr<const gltf::MeshSurface>;

SurfacePointer surfaceIn(const std::string& text, const std::filesystem::path& path = "a.obj") {
  const auto mesh = parseObj(text, "a.obj");
  REQUIRE(mesh);
  std::vector<std::string> warnings;
  return surfaceOfObj(text, *mesh, path, warnings);
}

constexpr const char* corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Two halves of a square that share the corners 1 and 3, with another texture coordinate at 1, and a vertex
/// of no face.
std::string dressedSquare() {
  std::string text = corners;
  text += "v 5 5 5\nvt 0 0\nvt 1 0\nvt 1 0.75\nvt 0 1\nvt 0.5 0.25\nvn 0 0 2\nvn 0 3 0\n"
          "mtllib some.mtl\no Front\nusemtl Red\nf 1/1/1 2/2/1 3/3/1\n"
          "g Back\nusemtl Blue\nf 1/5/1 3/3/1 4/4/2\n";
  return text;
}

/// What glTF says of each material that an MTL file describes, in the order of the names.
struct Shine {
  gltf::Json materials;
  gltf::Json whole;
  std::vector<std::string> warnings;
};

Shine shineOf(const test::TemporaryFolder& folder, const std::string& text,
              const std::vector<std::string>& names) {
  Shine shine;
  const gltf::Source made = materialsOfMtl({folder.write("some.mtl", text)}, names, shine.warnings);
  shine.whole = *made.json;
  shine.materials = shine.whole.at("materials");
  REQUIRE(shine.materials.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(shine.materials[i]["name"] == names[i]);
  }
  return shine;
}

std::vector<double> numbersOf(const gltf::Json& material, const char* key, std::vector<double> standard) {
  if (!material.contains(key)) {
    return standard;
  }
  return material[key].get<std::vector<double>>();
}

void checkNumbers(const std::vector<double>& found, const std::vector<double>& wanted) {
  REQUIRE(found.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(found[i] == Approx(wanted[i]).margin(1e-6));
  }
}

void checkColour(const gltf::Json& material, const std::vector<double>& wanted) {
  checkNumbers(numbersOf(material["pbrMetallicRoughness"], "baseColorFactor", {1.0, 1.0, 1.0, 1.0}), wanted);
}

double roughnessIn(const gltf::Json& material) {
  return material["pbrMetallicRoughness"].value("roughnessFactor", 1.0);
}

double metallicIn(const gltf::Json& material) {
  return material["pbrMetallicRoughness"].value("metallicFactor", 1.0);
}

} // namespace

TEST_CASE("vertices of an OBJ are split where the corners of its faces differ, and none is lost") {
  const SurfacePointer surface = surfaceIn(dressedSquare());
  REQUIRE(surface);
  CHECK(surface->places == std::vector<std::uint32_t>{0, 0, 1, 2, 3, 4});
  CHECK(surface->triangles == std::vector<Triangle>{{0, 2, 3}, {1, 3, 4}});
  REQUIRE(surface->texCoords.size() == 1);
  // glTF counts v downwards.
  CHECK(surface->texCoords[0] ==
        std::vector<glm::vec2>{
            {0.0F, 1.0F}, {0.5F, 0.75F}, {1.0F, 1.0F}, {1.0F, 0.25F}, {0.0F, 0.0F}, {0.0F, 0.0F}});
  const glm::vec3 front(0.0F, 0.0F, 1.0F);
  const glm::vec3 up(0.0F, 1.0F, 0.0F);
  CHECK(surface->normals == std::vector<glm::vec3>{front, front, front, front, up, up});
}

TEST_CASE(
    "triangles of an OBJ are parts by material and name, and a polygon is several triangles of one part") {
  const auto partsOf = [](const std::string& text) {
    const SurfacePointer surface = surfaceIn(text);
    REQUIRE(surface);
    std::string told;
    for (const gltf::SurfacePart& part : surface->parts) {
      told += part.name + ":" + std::to_string(part.material) + ":" + std::to_string(part.firstTriangle) +
              "+" + std::to_string(part.triangleCount) + " ";
    }
    return told;
  };
  CHECK(partsOf(dressedSquare()) == "Front:0:0+1 Back:1:1+1 ");
  const std::string start = corners;
  CHECK(partsOf(start + "usemtl A\nf 1 2 3 4\nf 1 2 3\n") == ":0:0+3 ");
  CHECK(partsOf(start + "f 1 2 3\nusemtl A\nf 1 3 4\nusemtl B\nf 1 2 4\nusemtl A\nf 2 3 4\n") ==
        ":-1:0+1 :0:1+1 :1:2+1 :0:3+1 ");
  CHECK(partsOf(start + "vn 0 0 1\no One\nf 1//1 2//1 3//1\ng Two\nf 1//1 3//1 4//1\n") ==
        "One:-1:0+1 Two:-1:1+1 ");
}

TEST_CASE("an OBJ has texture coordinates where any corner does, and normals where every corner does") {
  const std::string start = corners;
  CHECK(surfaceIn(start + "f 1 2 3 4\n") == nullptr);
  const SurfacePointer named = surfaceIn(start + "usemtl A\nf 1 2 3 4\n");
  REQUIRE(named);
  CHECK(named->texCoords.empty());
  CHECK(named->normals.empty());
  const SurfacePointer textured = surfaceIn(start + "vt 0.25 0.5\nf 1/1 2/1 3\nf 1/1 3 4\n");
  REQUIRE(textured);
  CHECK(textured->normals.empty());
  REQUIRE(textured->texCoords.size() == 1);
  CHECK(textured->texCoords[0] ==
        std::vector<glm::vec2>{{0.25F, 0.5F}, {0.25F, 0.5F}, {0.0F, 0.0F}, {0.0F, 0.0F}});
  const SurfacePointer shaded = surfaceIn(start + "vn 0 0 -1\nf 1//1 2//1 3//1 4//1\n");
  REQUIRE(shaded);
  CHECK(shaded->texCoords.empty());
  CHECK(shaded->normals == std::vector<glm::vec3>(4, glm::vec3(0.0F, 0.0F, -1.0F)));
  const SurfacePointer partly = surfaceIn(start + "vn 0 0 -1\nf 1//1 2//1 3//1 4\n");
  REQUIRE(partly);
  CHECK(partly->normals.empty());
  CHECK(partly->places.size() == 4);
}

TEST_CASE("an OBJ has colours where every vertex has three numbers behind its place") {
  const std::string faces = "vn 0 0 1\nf 1//1 2//1 3//1\n";
  const SurfacePointer painted = surfaceIn("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 2\nv 1 1 0 1 1 1\nf 1 2 3\n");
  REQUIRE(painted);
  REQUIRE(painted->colors.size() == 3);
  CHECK(painted->colors[0] == glm::vec4(1.0F, 0.0F, 0.0F, 1.0F));
  CHECK(painted->colors[1].y == Approx(0.2140411)); // sRGB as linear light
  CHECK(painted->colors[1].z == 1.0F);
  CHECK(painted->normals.empty());
  const std::string three = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  for (const std::string& places :
       {three, "v 5 5 5 1 0 0\n" + three, std::string("v 0 0 0 1\nv 1 0 0 1\nv 1 1 0 1\n")}) {
    const SurfacePointer surface = surfaceIn(places + faces);
    REQUIRE(surface);
    CHECK(surface->colors.empty());
  }
  CHECK(surfaceIn("v 0 0 0 1\nv 1 0 0 1\nv 1 1 0 1\nf 1 2 3\n") == nullptr);
}

TEST_CASE("indices of looks count from the end where they are negative, and what they miss is left out") {
  const std::string start = std::string(corners) + "vt 0.25 1\nvt 0.75 1\n";
  const auto firstOf = [&](const std::string& corner) {
    const SurfacePointer surface = surfaceIn(start + "f " + corner + " 2/1 3/1\n");
    REQUIRE(surface);
    return static_cast<double>(surface->texCoords[0][0].x);
  };
  CHECK(firstOf("1/2") == 0.75);
  CHECK(firstOf("1/-1") == 0.75);
  CHECK(firstOf("1/-2") == 0.25);
  CHECK(firstOf("-4/-2") == 0.25);
  for (const char* const nothing : {"1/3", "1/-3", "1/0", "1/x", "1"}) {
    CHECK(firstOf(nothing) == 0.0);
  }
}

TEST_CASE("a material of an MTL file is as it says, within what glTF allows, and else grey") {
  const test::TemporaryFolder folder;
  const Shine shine = shineOf(folder,
                              "newmtl Red\nKd 0.5 0.25 0.125\nKe 0.1 0.2 0.3\nd 0.5\nNs 250\nPm 0.75\n"
                              "newmtl Grey\nKd 0.5\nTr 0.25\nNs 10\nPr 0.3\n"
                              "newmtl Bare\n"
                              "newmtl Wild\nKd 2 -1 0.5\nKe -3 0.5 7\nd 1.5\nPr 2\nPm -1\n"
                              "newmtl Glass\nTr 3\nNs 5000\nPm 8\n"
                              "newmtl Broken\nKd red\nKe blue\nd half\nPm much\nNs some\n",
                              {"Red", "Grey", "Bare", "Wild", "Glass", "Broken", "Nowhere"});
  const gltf::Json& made = shine.materials;
  CHECK(shine.warnings.empty());
  checkColour(made[0], {0.5, 0.25, 0.125, 0.5});
  checkColour(made[1], {0.5, 0.5, 0.5, 0.75});
  checkColour(made[2], {0.8, 0.8, 0.8, 1.0});
  checkColour(made[3], {1.0, 0.0, 0.5, 1.0});
  checkColour(made[4], {0.8, 0.8, 0.8, 0.0});
  checkColour(made[5], {0.8, 0.8, 0.8, 1.0});
  checkColour(made[6], {0.8, 0.8, 0.8, 1.0});
  const auto glow = [&](std::size_t i) { return numbersOf(made[i], "emissiveFactor", {0.0, 0.0, 0.0}); };
  checkNumbers(glow(0), {0.1, 0.2, 0.3});
  checkNumbers(glow(1), {0.0, 0.0, 0.0});
  checkNumbers(glow(3), {0.0, 0.5, 1.0});
  checkNumbers(glow(5), {0.0, 0.0, 0.0});
  // Ns is 1000 (1 - roughness)^2, and Pr counts before it.
  CHECK(roughnessIn(made[0]) == Approx(0.5));
  CHECK(roughnessIn(made[1]) == Approx(0.3));
  CHECK(roughnessIn(made[2]) == Approx(0.8));
  CHECK(roughnessIn(made[3]) == Approx(1.0));
  CHECK(roughnessIn(made[4]) == Approx(0.0));
  CHECK(metallicIn(made[0]) == Approx(0.75));
  CHECK(metallicIn(made[1]) == Approx(0.0));
  CHECK(metallicIn(made[3]) == Approx(0.0));
  CHECK(metallicIn(made[4]) == Approx(1.0));
  CHECK(metallicIn(made[5]) == Approx(0.0));
  for (std::size_t i = 0; i < made.size(); ++i) {
    const bool isClear = i == 0 || i == 1 || i == 4;
    CHECK(made[i].value("alphaMode", "OPAQUE") == (isClear ? "BLEND" : "OPAQUE"));
    CHECK(made[i].value("doubleSided", false));
  }
}

TEST_CASE(
    "a picture that an MTL file names is found beside it or below, taken once, and told where it is not "
    "there") {
  const test::TemporaryFolder folder;
  folder.write("skin.png", "\x89PNG\r\n\x1a\nskin");
  folder.write("my bumps.jpg", "\xFF\xD8\xFF bumps");
  folder.write("words.png", "no picture");
  const Shine shine = shineOf(folder,
                              "newmtl Skin\nKd 0 0 0\nmap_Kd skin.png\nnorm -bm 0.5 my bumps.jpg\n"
                              "newmtl Same\nKd 0.5 0.25 0.125\nmap_Kd -s 1 1 1 -clamp on C:\\far\\skin.png\n"
                              "newmtl Lamp\nmap_Ke skin.png\n"
                              "newmtl Tinted\nKe 0.5 0 0\nmap_Ke ../skin.png\n"
                              "newmtl Lost\nmap_Kd gone.png\n"
                              "newmtl Words\nKd 0 0 0\nmap_Kd words.png\n",
                              {"Skin", "Same", "Lamp", "Tinted", "Lost", "Words"});
  const gltf::Json& made = shine.materials;
  const auto baseOf = [&](std::size_t i) {
    const gltf::Json& surface = made[i]["pbrMetallicRoughness"];
    return surface.contains("baseColorTexture") ? surface["baseColorTexture"]["index"].get<int>() : -1;
  };
  const auto pictureOf = [&](int texture) {
    const gltf::Json& image =
        shine.whole["images"][shine.whole["textures"][texture]["source"].get<std::size_t>()];
    return image["mimeType"].get<std::string>();
  };
  REQUIRE(baseOf(0) >= 0);
  CHECK(pictureOf(baseOf(0)) == "image/png");
  CHECK(pictureOf(made[0]["normalTexture"]["index"].get<int>()) == "image/jpeg");
  checkColour(made[0], {1.0, 1.0, 1.0, 1.0}); // black under a texture means the texture as it is
  REQUIRE(baseOf(1) >= 0);
  CHECK(pictureOf(baseOf(1)) == "image/png");
  checkColour(made[1], {0.5, 0.25, 0.125, 1.0});
  CHECK(made[2]["emissiveTexture"]["index"] == baseOf(0));
  checkNumbers(numbersOf(made[2], "emissiveFactor", {0.0, 0.0, 0.0}), {1.0, 1.0, 1.0});
  checkNumbers(numbersOf(made[3], "emissiveFactor", {0.0, 0.0, 0.0}), {0.5, 0.0, 0.0});
  CHECK(made[3].contains("emissiveTexture"));
  CHECK(baseOf(4) == -1);
  CHECK(baseOf(5) == -1);
  checkColour(made[4], {0.8, 0.8, 0.8, 1.0});
  checkColour(made[5], {0.0, 0.0, 0.0, 1.0});
  CHECK(shine.warnings == std::vector<std::string>{
                              "the image gone.png is not beside its material file: its texture is left out",
                              "the image words.png is no PNG, JPEG or WebP: its texture is left out"});
}

TEST_CASE(
    "an OBJ takes the MTL files that it names, one with blanks in its name or several, and tells of one "
    "that is gone") {
  const test::TemporaryFolder folder;
  folder.write("one.mtl", "newmtl A\nKd 1 0 0\n");
  folder.write("two.mtl", "newmtl B\nKd 0 1 0\n");
  folder.write("with blank.mtl", "newmtl C\nKd 0 0 1\n");
  const std::string text =
      std::string(corners) +
      "mtllib one.mtl two.mtl\nmtllib with blank.mtl\nmtllib gone.mtl\nusemtl A\nf 1 2 3\n"
      "usemtl B\nf 1 3 4\nusemtl C\nf 1 2 4\nusemtl D\nf 2 3 4\n";
  const auto mesh = parseObj(text, "a.obj");
  REQUIRE(mesh);
  std::vector<std::string> warnings;
  const SurfacePointer surface = surfaceOfObj(text, *mesh, folder / "a.obj", warnings);
  REQUIRE(surface);
  REQUIRE(surface->materials);
  const gltf::Json made = (*surface->materials->json)["materials"];
  REQUIRE(made.size() == 4);
  checkColour(made[0], {1.0, 0.0, 0.0, 1.0});
  checkColour(made[1], {0.0, 1.0, 0.0, 1.0});
  checkColour(made[2], {0.0, 0.0, 1.0, 1.0});
  checkColour(made[3], {0.8, 0.8, 0.8, 1.0});
  CHECK(made[3]["name"] == "D");
  CHECK(warnings == std::vector<std::string>{"gone.mtl cannot be read: its materials are grey"});
}

TEST_CASE("looks of a PLY are those of its vertices, with v turned downwards") {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                            "float y\nproperty float z\nproperty float nx\nproperty float "
                            "ny\nproperty float nz\nproperty float s\nproperty float t\nelement "
                            "face 1\nproperty list uchar int vertex_indices\nend_header\n"
                            "0 0 0 0 0 1 0.25 0.125\n1 0 0 0 1 0 0.5 0.25\n0 1 0 1 0 0 0.75 1\n"
                            "3 0 1 2\n");
  const auto mesh = readMeshFile(path);
  REQUIRE(mesh);
  std::vector<std::string> warnings;
  const SurfacePointer surface = surfaceOfMeshFile(path, *mesh, warnings);
  REQUIRE(surface);
  CHECK(surface->places == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(surface->triangles == std::vector<Triangle>{{0, 1, 2}});
  REQUIRE(surface->parts.size() == 1);
  CHECK(surface->parts[0].material == -1);
  CHECK(surface->parts[0].firstTriangle == 0);
  CHECK(surface->parts[0].triangleCount == 1);
  REQUIRE(surface->texCoords.size() == 1);
  CHECK(surface->texCoords[0] == std::vector<glm::vec2>{{0.25F, 0.875F}, {0.5F, 0.75F}, {0.75F, 0.0F}});
  CHECK(surface->normals ==
        std::vector<glm::vec3>{{0.0F, 0.0F, 1.0F}, {0.0F, 1.0F, 0.0F}, {1.0F, 0.0F, 0.0F}});
}

TEST_CASE("a picture below an MTL file is taken from there, and none from anywhere else") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "body/maps");
  const std::string png = "\x89PNG\r\n\x1a\n";
  const std::string secret = folder.write("private.png", png + "not to be taken").string();
  folder.write("body/skin.png", png + "beside");
  folder.write("body/maps/skin.png", png + "some way below");
  const auto file = folder.write("body/some.mtl", "Kd 1 0 0\nmap_Kd skin.png\n"
                                                  "newmtl Below\nmap_Kd maps\\skin.png\n"
                                                  "newmtl Beside\nmap_Kd skin.png\n"
                                                  "newmtl Above\nmap_Kd ../private.png\n"
                                                  "newmtl Far\nmap_Kd " +
                                                      secret + "\nnewmtl Nameless\nmap_Kd\n");
  std::vector<std::string> warnings;
  const gltf::Source made = materialsOfMtl({file}, {"Below", "Beside", "Above", "Far", "Nameless"}, warnings);
  const gltf::Json& whole = *made.json;
  const auto bytesOfPicture = [&](std::size_t material) {
    const gltf::Json& look = whole["materials"][material]["pbrMetallicRoughness"];
    if (!look.contains("baseColorTexture")) {
      return std::size_t{0};
    }
    const gltf::Json& texture = whole["textures"][look["baseColorTexture"]["index"].get<std::size_t>()];
    const gltf::Json& image = whole["images"][texture["source"].get<std::size_t>()];
    return whole["bufferViews"][image["bufferView"].get<std::size_t>()]["byteLength"].get<std::size_t>();
  };
  CHECK(bytesOfPicture(0) == 8 + 14);
  CHECK(bytesOfPicture(1) == 8 + 6);
  CHECK(bytesOfPicture(2) == 0);
  CHECK(bytesOfPicture(3) == 0);
  CHECK(bytesOfPicture(4) == 0);
  const std::string gone = " is not beside its material file: its texture is left out";
  CHECK(warnings ==
        std::vector<std::string>{"the image ../private.png" + gone, "the image " + secret + gone});
  checkColour(whole["materials"][2], {0.8, 0.8, 0.8, 1.0}); // what stands before all materials is of none
}
