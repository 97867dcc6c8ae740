#include <catch2/catch.hpp>

#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/json/json.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::skinning;
using gltf::Json;
using test::GlbBuilder;
using test::TemporaryFolder;

namespace {

/// A file of two sheets as a sequence; see twoSheets.
struct Sheets {
  explicit Sheets(const GlbBuilder& glb = test::twoSheets()) { glb.write(path); }

  Result<MeshSequence> read(const std::string& clip = {}, double framesPerSecond = 0.0,
                            const Progress& progress = {}) const {
    return readAnimatedGltf(path, clip, progress, framesPerSecond);
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "sheets.glb";
};

GlbBuilder withClips(const std::vector<std::string>& names) {
  GlbBuilder glb = test::twoSheets();
  const Json clip = glb.json["animations"][0];
  glb.json["animations"] = Json::array();
  for (const std::string& name : names) {
    Json copy = clip;
    copy["name"] = name;
    if (name.empty()) {
      copy.erase("name");
    }
    glb.json["animations"].push_back(copy);
  }
  return glb;
}

MeshSequence sequenceOf(std::size_t vertices, std::vector<glm::vec3> positions) {
  MeshSequence sequence;
  sequence.vertexCount = vertices;
  sequence.positions = std::move(positions);
  return sequence;
}

} // namespace

TEST_CASE("A glTF is a sequence of what it shows, frame by frame, mesh after mesh, in the world") {
  const Sheets sheets;
  const auto sequence = sheets.read({}, 4.0);
  REQUIRE(sequence);
  CHECK(sequence->name == "sheets");
  CHECK(sequence->clipName == "flutter");
  CHECK(sequence->framesPerSecond == 4.0);
  CHECK(sequence->vertexCount == 8);
  REQUIRE(sequence->frameCount() == 5);
  CHECK(sequence->frameNames ==
        std::vector<std::string>{"frame 0", "frame 1", "frame 2", "frame 3", "frame 4"});
  CHECK(sequence->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  // The weight goes from 0 to 1 in half a second and back; the target lifts two corners by 2.
  const std::vector<float> lifts{0.0F, 1.0F, 2.0F, 1.0F, 0.0F};
  for (std::size_t k = 0; k < 5; ++k) {
    INFO(k);
    CHECK(sequence->frame(k)[1] == glm::vec3(1, 0, 0));
    CHECK(sequence->frame(k)[2] == glm::vec3(1, 1, lifts[k]));
    CHECK(sequence->frame(k)[4] == glm::vec3(5, 0, 0));
    CHECK(sequence->frame(k)[7] == glm::vec3(5, 1, lifts[k]));
  }
  CHECK(sequence->warnings.empty());
}

TEST_CASE("A clip that begins late is read from there, its frames by their numbers") {
  GlbBuilder glb = test::twoSheets();
  const int times = glb.floats({0.5F, 0.75F, 1}, "SCALAR", 1);
  glb.json["accessors"][static_cast<std::size_t>(times)]["min"] = {0.5};
  glb.json["accessors"][static_cast<std::size_t>(times)]["max"] = {1};
  glb.json["animations"][0]["samplers"][0]["input"] = times;
  const auto sequence = Sheets(glb).read({}, 4.0);
  REQUIRE(sequence);
  CHECK(sequence->frameNames == std::vector<std::string>{"frame 2", "frame 3", "frame 4"});
  CHECK(sequence->frame(1)[2] == glm::vec3(1, 1, 2));
}

TEST_CASE("Reading tells how far it is, up to the whole") {
  std::vector<double> shares;
  REQUIRE(Sheets().read({}, 4.0, [&](double share) { shares.push_back(share); }));
  CHECK(shares == std::vector<double>{0.2, 0.4, 0.6, 0.8, 1.0});
}

TEST_CASE("Looks of a glTF's meshes lie side by side, filled up where one has none") {
  const auto sequence = Sheets().read();
  REQUIRE(sequence);
  REQUIRE(sequence->surface != nullptr);
  const gltf::MeshSurface& looks = *sequence->surface;
  REQUIRE(looks.texCoords.size() == 2);
  REQUIRE(looks.texCoords[0].size() == 8);
  REQUIRE(looks.texCoords[1].size() == 8);
  CHECK(looks.texCoords[0][2] == glm::vec2(1, 1));
  CHECK(looks.texCoords[1][2] == glm::vec2(0.75F, 0.5F));
  CHECK(looks.texCoords[0][5] == glm::vec2(0.0F));
  REQUIRE(looks.colors.size() == 8);
  CHECK(looks.colors[1] == glm::vec4(1.0F));
  CHECK(looks.colors[5] == glm::vec4(0, 1, 0, 1));
  REQUIRE(looks.parts.size() == 2);
  CHECK(looks.parts[0].name == "sail");
  CHECK(looks.parts[0].material == 1);
  CHECK(looks.parts[1].name == "flag");
  CHECK(looks.parts[1].firstTriangle == 2);
  CHECK(looks.parts[1].triangleCount == 2);
  CHECK(looks.normals.size() == 8);
  CHECK(looks.places == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK((*looks.materials->json)["materials"].size() == 2);
}

TEST_CASE("Looks that the last mesh of a glTF lacks are filled up as those that an earlier one does") {
  GlbBuilder glb = test::twoSheets();
  std::swap(glb.json["nodes"][0]["mesh"], glb.json["nodes"][1]["mesh"]);
  const auto sequence = Sheets(glb).read();
  REQUIRE(sequence);
  const gltf::MeshSurface& looks = *sequence->surface;
  REQUIRE(looks.colors.size() == 8);
  CHECK(looks.colors[1] == glm::vec4(0, 1, 0, 1));
  CHECK(looks.colors[5] == glm::vec4(1.0F));
  REQUIRE(looks.texCoords.size() == 2);
  CHECK(looks.texCoords[1][1] == glm::vec2(0.0F));
  CHECK(looks.texCoords[1][6] == glm::vec2(0.75F, 0.5F));
}

TEST_CASE(
    "A clip is chosen by its name or its number, and one that is not there is refused with those that are") {
  const Sheets sheets(withClips({"rest", "", "flutter"}));
  CHECK(sheets.read("flutter")->clipName == "flutter");
  CHECK(sheets.read("#1")->clipName.empty());
  CHECK(sheets.read("flutter")->warnings.empty());
  const auto first = sheets.read();
  REQUIRE(first);
  CHECK(first->clipName == "rest");
  CHECK(first->warnings == std::vector<std::string>{"the first of 3 clips was taken, 'rest'"});
  const std::string told = test::refusal(sheets.read("jump"));
  CHECK(told.find("there is no clip 'jump'") != std::string::npos);
  CHECK(told.find("clips of this file: 'rest', #1, 'flutter'") != std::string::npos);
  CHECK(told.find("more") == std::string::npos);
  const Sheets many(withClips({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"}));
  CHECK(test::refusal(many.read("jump")).find("'7', '8' and 2 more") != std::string::npos);
  const Sheets eight(withClips({"1", "2", "3", "4", "5", "6", "7", "8"}));
  CHECK(test::refusal(eight.read("jump")).find("'7', '8'") != std::string::npos);
  CHECK(test::refusal(eight.read("jump")).find("more") == std::string::npos);
}

TEST_CASE("A glTF without a clip, without a mesh, or of too many frames is refused by what it lacks") {
  const auto refused = [](const auto& change) {
    GlbBuilder glb = test::twoSheets();
    change(glb.json);
    return test::refusal(Sheets(glb).read());
  };
  CHECK(refused([](Json& json) { json.erase("animations"); }).find("the file holds no clip") !=
        std::string::npos);
  CHECK(refused([](Json& json) {
          json["scenes"][0]["nodes"] = Json::array();
        }).find("the file shows no mesh") != std::string::npos);
  const std::string many = test::refusal(Sheets().read({}, 1e8));
  CHECK(many.find("8 vertices in 100000001 frames are too many") != std::string::npos);
  CHECK(many.find("give a shorter clip") != std::string::npos);
  const TemporaryFolder folder;
  CHECK(test::refusal(readAnimatedGltf(folder.path() / "none.glb")) != "accepted");
}

TEST_CASE("A clip that moves a vertex beyond all measure is refused") {
  GlbBuilder glb = test::twoSheets();
  glb.json["nodes"][1]["scale"] = {1e20, 1, 1};
  CHECK(test::refusal(Sheets(glb).read()).find("moves a vertex to no finite place, or beyond 1e+15") !=
        std::string::npos);
}

TEST_CASE(
    "A single glTF is joined along its seams, and says so, and other words than paths of one sequence are "
    "refused") {
  const Sheets sheets;
  const auto whole = readSequence({sheets.path});
  REQUIRE(whole);
  CHECK(whole->vertexCount == 8);
  GlbBuilder glb = test::twoSheets();
  glb.json["nodes"][1].erase("translation");
  const Sheets same(glb);
  const auto joined = readSequence({same.path});
  REQUIRE(joined);
  CHECK(joined->vertexCount == 4);
  CHECK(std::ranges::find(joined->warnings,
                          "4 vertices that lie on another one in every frame were joined with it") !=
        joined->warnings.end());
  CHECK(readSequence({sheets.path}, {}, "#0")->clipName == "flutter");
  CHECK(test::refusal(readSequence({})).find("is one folder or file, or a base mesh and its cache") !=
        std::string::npos);
  CHECK(test::refusal(readSequence({"a", "b", "c"})).find("name one or two paths") != std::string::npos);
  CHECK(test::refusal(readSequence({"a.obj"}, {}, "walk")).find("only a glTF has clips to choose from") !=
        std::string::npos);
  CHECK(test::refusal(readSequence({sheets.path, "b.pc2"}, {}, "walk")).find("clip 'walk'") !=
        std::string::npos);
  CHECK(test::refusal(readSequence({sheets.path, "b.obj"})).find("is not a point cache") !=
        std::string::npos);
  CHECK(test::refusal(readSequence({sheets.folder.path() / "no.glb"}))
            .find("there is no such file or folder") != std::string::npos);
}

TEST_CASE("Only vertices that lie together in every frame are joined, and the first of them stays") {
  MeshSequence sequence =
      sequenceOf(4, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {2, 0, 0}, {2, 0, 0}, {0, 0, 0}});
  sequence.triangles = {{0, 1, 3}, {2, 3, 0}};
  CHECK(joinDuplicates(sequence) == 1);
  CHECK(sequence.vertexCount == 3);
  CHECK(sequence.positions ==
        std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {2, 0, 0}, {0, 0, 0}});
  CHECK(sequence.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 2, 0}});
  CHECK(joinDuplicates(sequence) == 0);
  CHECK(sequence.vertexCount == 3);
}

TEST_CASE("Two sequences are joined where that makes their vertices agree, and else left alone") {
  const std::vector<glm::vec3> split{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  const std::vector<glm::vec3> whole{{5, 0, 0}, {6, 0, 0}};
  MeshSequence a = sequenceOf(3, split);
  MeshSequence b = sequenceOf(2, whole);
  joinUntilAlike(a, b);
  CHECK(a.vertexCount == 2);
  CHECK(a.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}});
  CHECK(b.positions == whole);
  MeshSequence c = sequenceOf(3, split);
  MeshSequence d = sequenceOf(1, {{5, 0, 0}});
  joinUntilAlike(c, d);
  CHECK(c.vertexCount == 3);
  MeshSequence e = sequenceOf(3, split);
  MeshSequence f = sequenceOf(3, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  joinUntilAlike(e, f);
  CHECK(e.vertexCount == 3); // they agree as they are
}

TEST_CASE("What a glTF shows beside triangles, and what it does not show, is left out and told") {
  GlbBuilder glb = test::twoSheets();
  const Json sheet = glb.json["meshes"][0]["primitives"][0];
  for (const int mode : {0, 1, 3}) {
    Json other = sheet;
    other["mode"] = mode;
    glb.json["meshes"][0]["primitives"].push_back(other);
  }
  glb.json["nodes"].push_back({{"mesh", 0}});
  glb.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  glb.json["extensionsUsed"] = {"KHR_lights_punctual"};
  glb.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}, {{"type", "point"}}};
  const Sheets sheets(glb);
  const auto sequence = sheets.read();
  REQUIRE(sequence);
  CHECK(sequence->vertexCount == Sheets().read()->vertexCount);
  REQUIRE_FALSE(sequence->warnings.empty());
  CHECK(sequence->warnings.front() ==
        "left out: 1 primitive of points, 2 primitives of lines, 1 mesh of another "
        "scene, 1 camera, 2 lights");
  CHECK(Sheets().read()->warnings.empty());
}

TEST_CASE("A rate that is asked for changes how many frames of a glTF are read, not how long it lasts") {
  const Sheets sheets;
  const auto sequence = readSequence({sheets.path}, {}, {}, 4.0);
  REQUIRE(sequence);
  CHECK(sequence->framesPerSecond == 4.0);
  CHECK(sequence->frameCount() == 5); // a second
}
