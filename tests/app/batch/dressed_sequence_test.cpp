// What a mesh sequence looks like, beyond its shape, is in the clip that it becomes.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/source.h"
#include "core/gltf/source/uri.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;

namespace {

Bytes pngBytes() {
  return gltf::decodeDataUri(test::onePixelUri)->bytes;
}

// A vertex by what it shows, rounded so that values out of files compare.
using Corner = std::array<int, 8>;

Corner cornerOf(const glm::vec3& place, const glm::vec3& normal, const glm::vec2& texCoord) {
  const std::array<float, 8> values{place.x,  place.y,  place.z,    normal.x,
                                    normal.y, normal.z, texCoord.x, texCoord.y};
  Corner rounded{};
  std::ranges::transform(values, rounded.begin(),
                         [](float value) { return static_cast<int>(std::lround(1000.0F * value)); });
  return rounded;
}

// A square bar along x that bends in the middle: hard edges between its four sides, a seam of the texture
// along one of them, ends of another material.
class PaintedBar {
public:
  static constexpr int rings = 9;

  explicit PaintedBar(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "frames");
    for (int frame = 0; frame < 5; ++frame) {
      write(folder / "frames" / fmt::format("bar_{}.obj", frame), 0.2 * frame);
    }
    std::ofstream(folder / "frames" / "bar.mtl")
        << "newmtl paint\nKd 0 0 0\nmap_Kd -s 1 1 1 my paint.png\nNs 250\n"
        << "newmtl ends\nKd 0.25 0.5 0.75\nd 0.5\nKe 1 0 0\n";
    const Bytes png = pngBytes();
    test::writeBytes(folder / "frames" / "my paint.png", png);
  }

  // Of the straight bar of the first frame.
  [[nodiscard]] static std::set<Corner> corners() {
    std::set<Corner> all;
    for (int ring = 0; ring < rings; ++ring) {
      for (int side = 0; side < 4; ++side) {
        for (const int end : {side, side + 1}) {
          const glm::vec2 texCoord(ring / (rings - 1.0), 1.0 - end / 4.0);
          all.insert(cornerOf(place(ring, end, 0.0), normal(side), texCoord));
        }
      }
    }
    for (const int ring : {0, rings - 1}) {
      for (int corner = 0; corner < 4; ++corner) {
        all.insert(cornerOf(place(ring, corner, 0.0), {ring == 0 ? -1.0F : 1.0F, 0, 0}, {0, 1}));
      }
    }
    return all;
  }

private:
  static glm::vec3 place(int ring, int corner, double bend) {
    const std::array<glm::vec2, 4> square{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    const glm::vec2 across = square[static_cast<std::size_t>(corner % 4)];
    const double along = ring - 4.0;
    const double angle = along > 0.0 ? bend : 0.0;
    return {along * std::cos(angle) - across.x * std::sin(angle),
            along * std::sin(angle) + across.x * std::cos(angle), across.y};
  }

  static glm::vec3 normal(int side) {
    const std::array<glm::vec3, 4> normals{{{0, 0, 1}, {0, -1, 0}, {0, 0, -1}, {0, 1, 0}}};
    return normals[static_cast<std::size_t>(side)];
  }

  static void write(const std::filesystem::path& path, double bend) {
    std::ofstream out(path);
    out << "mtllib bar.mtl\no bar\n";
    for (int ring = 0; ring < rings; ++ring) {
      for (int corner = 0; corner < 5; ++corner) {
        out << fmt::format("vt {} {}\n", ring / (rings - 1.0), corner / 4.0);
        if (corner < 4) {
          const glm::vec3 at = place(ring, corner, bend);
          out << fmt::format("v {} {} {}\n", at.x, at.y, at.z);
        }
      }
    }
    for (int side = 0; side < 4; ++side) {
      out << fmt::format("vn {} {} {}\n", normal(side).x, normal(side).y, normal(side).z);
    }
    out << "vn -1 0 0\nvn 1 0 0\nvt 0 0\nusemtl paint\n";
    for (int ring = 0; ring + 1 < rings; ++ring) {
      for (int side = 0; side < 4; ++side) {
        const auto corner = [&](int r, int end) {
          return fmt::format("{}/{}/{}", 4 * r + end % 4 + 1, 5 * r + end + 1, side + 1);
        };
        out << "f " << corner(ring, side) << ' ' << corner(ring, side + 1) << ' '
            << corner(ring + 1, side + 1) << ' ' << corner(ring + 1, side) << '\n';
      }
    }
    const int uv = 5 * rings + 1;
    const int last = 4 * (rings - 1) + 1;
    out << "usemtl ends\n"
        << fmt::format("f 4/{0}/5 3/{0}/5 2/{0}/5 1/{0}/5\n", uv)
        << fmt::format("f {1}/{0}/6 {2}/{0}/6 {3}/{0}/6 {4}/{0}/6\n", uv, last, last + 1, last + 2, last + 3);
  }
};

gltf::Loaded compressed(const std::string& source, const std::filesystem::path& output,
                        const char* bones = "1") {
  const test::VerbAnswer answer =
      test::runVerb({"compress", source, "-o", output.string(), "--stretch", "measured", "--bones", bones});
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  Result<gltf::Loaded> loaded = gltf::load(output);
  REQUIRE(loaded);
  return std::move(loaded).value();
}

Bytes imageOf(const gltf::Loaded& file, std::size_t image) {
  return gltf::encodedImage(*file.source, (*file.source->json)["images"][image]).value();
}

} // namespace

TEST_CASE("an OBJ sequence keeps its seams, hard edges and the materials of its MTL file") {
  const test::TemporaryFolder folder;
  const PaintedBar bar(folder.path());
  const gltf::Loaded file = compressed((folder / "frames").string(), folder / "bar.glb", "3");

  std::set<Corner> found;
  for (const Primitive& primitive : file.scene->meshes.at(0).primitives) {
    REQUIRE(primitive.texCoords.size() == primitive.positions.size());
    for (const std::uint32_t v : primitive.indices) {
      found.insert(cornerOf(primitive.positions[v], primitive.normals[v], primitive.texCoords[v]));
    }
  }
  CHECK(found == PaintedBar::corners());

  REQUIRE(file.scene->materials.size() == 2);
  const Material& paint = file.scene->materials[0];
  CHECK(paint.name == "paint");
  CHECK(paint.baseColor == glm::vec4(1.0F)); // Black under a picture stands for the picture.
  CHECK(paint.baseColorTexture.image == 0);
  CHECK(imageOf(file, 0) == pngBytes());
  CHECK(file.scene->images.at(0).width == 1);
  const Material& ends = file.scene->materials[1];
  CHECK(ends.baseColor == glm::vec4(0.25F, 0.5F, 0.75F, 0.5F));
  CHECK(ends.alphaMode == AlphaMode::blend);
  CHECK(ends.emissive == glm::vec3(1, 0, 0));
}

TEST_CASE("an OBJ whose names are in an older encoding than UTF-8 is compressed, its materials' names made "
          "readable") {
  const test::TemporaryFolder folder;
  const PaintedBar bar(folder.path());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "frames")) {
    const Result<Bytes> bytes = readFile(entry.path());
    REQUIRE(bytes);
    std::string text(bytes->begin(), bytes->end());
    for (std::size_t at = text.find("paint\n"); at != std::string::npos; at = text.find("paint\n", at)) {
      text.replace(at, 5,
                   "l\xE4"
                   "der"); // Latin-1
    }
    REQUIRE((entry.path().extension() == ".png" || writeText(entry.path(), text)));
  }
  const gltf::Loaded file = compressed((folder / "frames").string(), folder / "bar.glb", "3");
  CHECK(file.scene->materials.at(0).name == "l\xEF\xBF\xBD"
                                            "der");
}

TEST_CASE("a sequence with seams compares with its compression place by place") {
  const test::TemporaryFolder folder;
  const PaintedBar bar(folder.path());
  const std::string frames = (folder / "frames").string();
  const std::string output = (folder / "bar.glb").string();
  REQUIRE(
      test::runVerb({"compress", frames, "-o", output, "--stretch", "measured", "--bones", "2"}).exitCode ==
      0);
  const test::VerbAnswer answer = test::runVerb({"compare", frames, output, "--json"});
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  CHECK(Json::parse(answer.output)["rmse_percent"].get<double>() < 0.01);
}

TEST_CASE("an OBJ whose material file or picture is missing is told and compressed all the same") {
  const test::TemporaryFolder folder;
  const PaintedBar bar(folder.path());
  const bool library = GENERATE(true, false);
  std::filesystem::remove(folder.path() / "frames" / (library ? "bar.mtl" : "my paint.png"));
  const std::string output = (folder / "bar.glb").string();
  const test::VerbAnswer answer = test::runVerb({"compress", (folder / "frames").string(), "-o", output,
                                                 "--stretch", "measured", "--bones", "2", "--json"});
  REQUIRE(answer.exitCode == 0);
  CHECK_THAT(answer.output,
             Catch::Contains(library ? "bar.mtl cannot be read" : "my paint.png is not beside"));
  const Result<gltf::Loaded> file = gltf::load(output);
  REQUIRE(file);
  CHECK(file->scene->materials.at(0).name == "paint");
  CHECK(file->scene->materials.at(0).baseColorTexture.image == -1);
}

TEST_CASE("a glTF sequence keeps meshes, materials, pictures, all texture coordinates, colours and names") {
  const test::TemporaryFolder folder;
  test::twoSheets().write(folder / "sheets.glb");
  const gltf::Loaded file = compressed((folder / "sheets.glb").string(), folder / "out.glb");
  const Json& json = file.source->json;

  REQUIRE(file.scene->meshes.size() == 2);
  CHECK(file.scene->meshes[0].name == "sail");
  CHECK(file.scene->meshes[1].name == "flag");
  CHECK(file.clips.at(0).name == "flutter");
  const Primitive& sail = file.scene->meshes[0].primitives.at(0);
  CHECK(sail.texCoords == std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const int second = json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"].get<int>();
  CHECK(gltf::readFloats(*file.source, second) == std::vector<float>{.5F, 0, .75F, 0, .75F, .5F, .5F, .5F});
  const Primitive& flag = file.scene->meshes[1].primitives.at(0);
  CHECK(flag.colors.at(1) == glm::vec4(0, 1, 0, 1));
  CHECK(flag.positions.at(0) == glm::vec3(5, 0, 0));

  CHECK(json["materials"][1]["name"] == "cloth");
  CHECK(json["materials"][1]["alphaCutoff"] == 0.25);
  CHECK(json["materials"][1]["pbrMetallicRoughness"]["roughnessFactor"] == 0.375);
  CHECK(json["materials"][1]["occlusionTexture"]["texCoord"] == 1);
  CHECK(json["samplers"][0]["wrapS"] == 33071);
  CHECK(json["images"][0]["name"] == "weave");
  CHECK(json["extensionsUsed"] == Json{"KHR_materials_unlit"});
  CHECK(imageOf(file, 0) == pngBytes());
  CHECK(sail.material == 1);
  CHECK(flag.material == 0);
}

TEST_CASE("a PLY sequence keeps the colours of its vertices") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "frames");
  for (int frame = 0; frame < 3; ++frame) {
    std::ofstream(folder / "frames" / fmt::format("f{}.ply", frame))
        << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        << "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        << fmt::format("0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 {0} 0 0 255\n0 1 {0} 188 188 188\n", 0.5 * frame)
        << "3 0 1 2\n3 0 2 3\n";
  }
  const gltf::Loaded file = compressed((folder / "frames").string(), folder / "out.glb");
  const std::vector<glm::vec4>& colors = file.scene->meshes.at(0).primitives.at(0).colors;
  REQUIRE(colors.size() == 4);
  CHECK(colors[0] == glm::vec4(1, 0, 0, 1));
  CHECK(colors[3].x == Approx(0.503).margin(0.002)); // sRGB 188 is half as bright as white.
}
