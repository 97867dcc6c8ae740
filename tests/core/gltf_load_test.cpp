#include <catch2/catch.hpp>

#include <functional>
#include <limits>

#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/source/problems.h"
#include "core/gltf/source/uri.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::armBuilder;
using test::GlbBuilder;
using test::loadBytes;
using test::loaded;
using test::TemporaryFolder;
using test::warnsOf;

namespace {

Json& primitive(GlbBuilder& glb) {
  return glb.json["meshes"][0]["primitives"][0];
}

} // namespace

TEST_CASE("A file's nodes, skin and clips arrive as the file says") {
  const gltf::Loaded file = loaded(armBuilder());
  const Scene& scene = *file.scene;
  CHECK(file.warnings.empty());
  REQUIRE(scene.nodes.size() == 6);
  CHECK(scene.nodes[1].parent == NodeIndex(0));
  CHECK(scene.nodes[1].rest.translation == Vec3(0, 1, 0));
  REQUIRE(scene.nodes[5].matrix.has_value());
  CHECK(glm::length(scene.nodes[5].rest.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)) < 1e-12);
  CHECK(scene.roots == std::vector{NodeIndex(0), NodeIndex(5)});
  CHECK(scene.skins[0].inverseBind[2][3] == Vec4(0, -2, 0, 1));
  REQUIRE(file.clips.size() == 2);
  CHECK(file.clips[0].tracks.size() == 3);
  CHECK(file.clips[0].tracks[1]->interpolation == Interpolation::cubicSpline);
  CHECK(file.clips[0].tracks[1]->sourceChannel == 1);
  CHECK(file.clips[0].endSeconds == 1.0);
  CHECK(file.clips[1].endSeconds == 0.0);
}

TEST_CASE("A skin without inverse bind matrices has identities") {
  GlbBuilder glb = armBuilder();
  glb.json["skins"][0].erase("inverseBindMatrices");
  CHECK(loaded(glb).scene->skins[0].inverseBind == std::vector<Mat4>(3, Mat4(1.0)));
}

TEST_CASE("Rounding in the last row of an inverse bind matrix is taken out, more is told") {
  for (const float rounding : {0.0009F, 0.0011F}) {
    for (const std::size_t column : {0U, 1U, 2U, 3U}) {
      GlbBuilder glb = armBuilder();
      const std::size_t accessor = glb.json["skins"][0]["inverseBindMatrices"];
      const std::size_t view = glb.json["accessors"][accessor]["bufferView"];
      const std::size_t first = glb.json["bufferViews"][view]["byteOffset"];
      const float value = (column == 3 ? 1.0F : 0.0F) + rounding;
      std::memcpy(glb.binary.data() + first + 16 * column + 12, &value, sizeof value);
      const auto file = test::loadBytes(glb.bytes());
      CAPTURE(rounding, column);
      CHECK(file.ok() == (rounding < 0.001F));
      if (file) {
        CHECK(file->scene->skins[0].inverseBind[0][0][3] == 0.0);
        CHECK(file->scene->skins[0].inverseBind[0][1][3] == 0.0);
        CHECK(file->scene->skins[0].inverseBind[0][2][3] == 0.0);
        CHECK(file->scene->skins[0].inverseBind[0][3][3] == 1.0);
      }
    }
  }
}

TEST_CASE("Strips and fans become triangles that face the same way") {
  GlbBuilder glb = armBuilder();
  SECTION("strip") {
    const gltf::Loaded file = loaded(glb);
    const Primitive& made = file.scene->meshes[0].primitives[0];
    CHECK(made.indices == std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4});
    for (const glm::vec3& normal : made.normals) {
      CHECK(glm::length(normal - glm::vec3(0, 0, 1)) < 1e-6F); // computed, since the file has none
    }
  }
  SECTION("fan") {
    primitive(glb)["mode"] = 6;
    CHECK(loaded(glb).scene->meshes[0].primitives[0].indices ==
          std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5});
  }
  SECTION("list without indices") {
    primitive(glb).erase("indices");
    primitive(glb).erase("mode");
    CHECK(loaded(glb).scene->meshes[0].primitives[0].indices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  }
}

TEST_CASE("Weights are made to sum to one, with one warning") {
  GlbBuilder glb = armBuilder();
  const std::vector<float> weights{2, 0, 0, 0, 0,   0,   0, 0, .5F, .5F, 0, 0,
                                   1, 3, 0, 0, .5F, .5F, 0, 0, 1,   0,   0, 0};
  primitive(glb)["attributes"]["WEIGHTS_0"] = glb.floats(weights, "VEC4", 4);
  const gltf::Loaded file = loaded(glb);
  const std::vector<VertexInfluences>& influences = file.scene->meshes[0].primitives[0].influences;
  CHECK(influences[0].weights[0] == 1.0F);
  CHECK(influences[1].weights[0] == 1.0F); // no weight at all: the first joint
  CHECK(influences[3].weights[1] == 0.75F);
  CHECK(warnsOf(file, "do not sum to 1"));
}

TEST_CASE("A joint that the skin lacks is tolerated with weight 0 and refused with another") {
  GlbBuilder glb = armBuilder();
  std::vector<std::uint8_t> joints(24, 0);
  joints[3] = 200;
  SECTION("weight 0") {
    primitive(glb)["attributes"]["JOINTS_0"] = glb.accessor(joints, 5121, "VEC4", 4);
    CHECK(warnsOf(loaded(glb), "does not have, with weight 0"));
  }
  SECTION("weight 1") {
    joints[0] = 200;
    primitive(glb)["attributes"]["JOINTS_0"] = glb.accessor(joints, 5121, "VEC4", 4);
    CHECK(loadBytes(glb.bytes()).error().where == "meshes[0].primitives[0].attributes.JOINTS_0");
  }
}

TEST_CASE("Normalised integers stand for fractions") {
  GlbBuilder glb = armBuilder();
  const std::vector<std::int16_t> turns{0, 0, 0, 32767, 0, 0, 32767, 0, 0, 0, -32768, 0};
  glb.json["animations"][0]["samplers"][0]["output"] = glb.accessor(turns, 5122, "VEC4", 4);
  glb.json["accessors"].back()["normalized"] = true;
  const gltf::Loaded file = loaded(glb);
  const Track& track = *file.clips[0].tracks[0];
  CHECK(track.values[3] == 1.0F);
  CHECK(track.values[10] == -1.0F);
}

TEST_CASE("Sparse values replace those of the accessor") {
  GlbBuilder glb = armBuilder();
  glb.accessor(std::vector<std::uint16_t>{1, 5}, 5123, "SCALAR", 1);
  const std::size_t indexView = glb.json["bufferViews"].size() - 1;
  glb.floats({7, 8, 9, 4, 5, 6}, "VEC3", 3);
  const std::size_t valueView = glb.json["bufferViews"].size() - 1;
  Json& positions = glb.json["accessors"][0];
  positions["min"] = {0, 0, 0};
  positions["max"] = {7, 8, 9};
  positions["sparse"] = {{"count", 2},
                         {"indices", {{"bufferView", indexView}, {"componentType", 5123}}},
                         {"values", {{"bufferView", valueView}}}};
  const gltf::Loaded file = loaded(glb);
  const std::vector<glm::vec3>& read = file.scene->meshes[0].primitives[0].positions;
  CHECK(read[0] == glm::vec3(0, 0, 0));
  CHECK(read[1] == glm::vec3(7, 8, 9));
  CHECK(read[5] == glm::vec3(4, 5, 6));
}

TEST_CASE("What breaks the specification but can be read is refused, unless it is tolerated") {
  GlbBuilder glb = armBuilder();
  std::string place;
  SECTION("a rotation that is no unit quaternion") {
    glb.json["nodes"][2]["rotation"] = {0, 0, 1, 1};
    place = "nodes[2].rotation";
  }
  SECTION("bounds that the values do not have") {
    glb.json["accessors"][0]["max"] = {1, 1, 1};
    place = "accessors[0]";
  }
  SECTION("values that are no finite numbers") {
    const int unused = glb.floats({0, std::numeric_limits<float>::infinity(), 0}, "VEC3", 3);
    place = "accessors[" + std::to_string(unused) + "]";
  }
  SECTION("positions without bounds") {
    glb.json["accessors"][0].erase("min");
    place = "meshes[0].primitives[0].attributes.POSITION";
  }
  SECTION("attributes that share a view without a stride") {
    glb.json["accessors"].push_back(glb.json["accessors"][0]);
    glb.json["meshes"][0]["primitives"][0]["attributes"]["_OTHER"] = glb.json["accessors"].size() - 1;
    place = "bufferViews[0]";
  }
  SECTION("an empty array") {
    glb.json["textures"] = Json::array();
    place = "textures";
  }
  const Result<gltf::Loaded> refused = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().where, Catch::Contains(place));
  CHECK_THAT(refused.error().line(), Catch::Contains("--tolerant"));
  const Result<gltf::Loaded> tolerated = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(tolerated);
  CHECK_FALSE(tolerated->warnings.empty());
}

TEST_CASE("Strided accessors are read with their stride") {
  GlbBuilder glb = armBuilder();
  const std::vector<float> interleaved{0, -1, .5F, -1, 1, -1};
  glb.json["animations"][0]["samplers"][0]["input"] = glb.floats(interleaved, "SCALAR", 1);
  glb.json["accessors"].back()["count"] = 3;
  glb.json["bufferViews"].back()["byteStride"] = 8;
  const gltf::Loaded file = loaded(glb);
  CHECK(file.clips[0].tracks[0]->times == std::vector<float>{0, .5F, 1});
  CHECK(warnsOf(file, "strided"));
}

TEST_CASE(
    "Primitives of a small file that share one list of vertices are refused before they fill the memory") {
  const auto [primitives, isTaken] = GENERATE(table<std::size_t, bool>({{100, true}, {600, false}}));
  GlbBuilder glb;
  glb.json = {{"asset", {{"version", "2.0"}}}, {"nodes", {{{"mesh", 0}}}}};
  std::vector<float> places(29997, 0.5F);
  const int accessor = glb.floats(places, "VEC3", 3);
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["min"] = {0.5, 0.5, 0.5};
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["max"] = {0.5, 0.5, 0.5};
  for (std::size_t i = 0; i < primitives; ++i) {
    glb.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", accessor}}}});
  }
  const auto file = test::loadBytes(glb.bytes());
  CHECK(file.ok() == isTaken);
  if (!isTaken) {
    CHECK_THAT(file.error().line(), Catch::Contains("more data than the program takes into memory"));
  }
}

TEST_CASE("Keys at one time are moved apart, keys that go back are refused") {
  GlbBuilder glb = armBuilder();
  SECTION("equal") {
    glb.json["animations"][0]["samplers"][0]["input"] = glb.floats({0, .5F, .5F}, "SCALAR", 1);
    CHECK_FALSE(test::loadBytes(glb.bytes()));
    const gltf::Loaded file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn).value();
    const std::vector<float>& times = file.clips[0].tracks[0]->times;
    CHECK(times[1] < times[2]);
    CHECK(times[2] == Approx(0.5));
    CHECK(warnsOf(file, "moved apart"));
  }
  SECTION("backwards") {
    glb.json["animations"][0]["samplers"][0]["input"] = glb.floats({0, 1, .5F}, "SCALAR", 1);
    CHECK(loadBytes(glb.bytes()).error().where == "animations[0].samplers[0].input");
  }
}

TEST_CASE("Channels that drive nothing we know are left out, the others stay") {
  GlbBuilder glb = armBuilder();
  Json& channels = glb.json["animations"][0]["channels"];
  channels[0]["target"] = {{"path", "pointer"},
                           {"extensions", {{"KHR_animation_pointer", {{"pointer", "/x"}}}}}};
  const gltf::Loaded file = loaded(glb);
  REQUIRE(file.clips[0].tracks.size() == 2);
  CHECK(file.clips[0].tracks[0]->sourceChannel == 1);
}

TEST_CASE("The humanoid table of VRM 0 is read with the names of VRM 1") {
  GlbBuilder glb = armBuilder();
  glb.json["extensions"]["VRM"] = Json::parse(
      R"({"humanoid": {"humanBones": [{"bone": "leftUpperArm", "node": 1}, {"bone": "leftThumbProximal", "node": 2}]}})");
  const std::map<std::string, NodeIndex> expected{{"leftUpperArm", NodeIndex(1)},
                                                  {"leftThumbMetacarpal", NodeIndex(2)}};
  CHECK(loaded(glb).scene->humanoid == expected);
}

TEST_CASE("The humanoid table of VRM 1 and its animations is read") {
  const char* const extension = GENERATE("VRMC_vrm", "VRMC_vrm_animation");
  GlbBuilder glb = armBuilder();
  glb.json["extensions"][extension] =
      Json::parse(R"({"humanoid": {"humanBones": {"hips": {"node": 0}, "spine": {"node": 99}}}})");
  const gltf::Loaded file = loaded(glb);
  CHECK(file.scene->humanoid == std::map<std::string, NodeIndex>{{"hips", NodeIndex(0)}});
  CHECK(warnsOf(file, "'spine'"));
}

TEST_CASE("Required extensions that hide geometry are named, others are warned of") {
  GlbBuilder glb = armBuilder();
  glb.json["extensionsRequired"] = {"KHR_meshopt_compression", "KHR_materials_volume"};
  CHECK(loadBytes(glb.bytes()).error().line() == "extensionsRequired: needs KHR_meshopt_compression, which "
                                                 "cannot be read; export it without compression");
  glb.json["extensionsRequired"] = {"KHR_materials_volume"};
  CHECK(warnsOf(loaded(glb), "KHR_materials_volume"));
}

namespace {

struct Fault {
  const char* name;
  std::function<void(GlbBuilder&)> make;
  const char* where;
};

// glTF files that no reading makes sense of, and the place that the error has to name: how their parts refer
// to each other.
std::vector<Fault> structuralFaults() {
  return {
      {"no asset", [](GlbBuilder& g) { g.json.erase("asset"); }, "asset"},
      {"version 1", [](GlbBuilder& g) { g.json["asset"]["version"] = "1.0"; }, "asset.version"},
      {"child missing", [](GlbBuilder& g) { g.json["nodes"][0]["children"] = {77}; }, "nodes[0].children[0]"},
      {"loop", [](GlbBuilder& g) { g.json["nodes"][3]["children"] = {1}; }, "nodes[1]"},
      {"own child", [](GlbBuilder& g) { g.json["nodes"][5]["children"] = {5}; }, "nodes[5]"},
      {"scene lists a child",
       [](GlbBuilder& g) {
         g.json["scenes"][0]["nodes"] = {0, 1};
       },
       "scenes[0]"},
      {"matrix and parts",
       [](GlbBuilder& g) {
         g.json["nodes"][5]["scale"] = {1, 1, 1};
       },
       "nodes[5]"},
      {"a place beyond single precision",
       [](GlbBuilder& g) {
         g.json["nodes"][2]["translation"] = {0, 1e300, 0};
       },
       "nodes[2].translation"},
      {"index is text", [](GlbBuilder& g) { g.json["nodes"][4]["skin"] = "0"; }, "nodes[4].skin"},
      {"index is negative", [](GlbBuilder& g) { g.json["nodes"][4]["mesh"] = -1; }, "nodes[4].mesh"},
      {"index is a fraction", [](GlbBuilder& g) { g.json["nodes"][4]["mesh"] = 0.5; }, "nodes[4].mesh"},
      {"index is out of all range", [](GlbBuilder& g) { g.json["nodes"][4]["mesh"] = 1e300; },
       "nodes[4].mesh"},
      {"primitives are no array", [](GlbBuilder& g) { g.json["meshes"][0]["primitives"] = 3; },
       "meshes[0].primitives"},
      {"nodes are no objects", [](GlbBuilder& g) { g.json["nodes"][1] = 4; }, "nodes[1]"},
      {"no joints", [](GlbBuilder& g) { g.json["skins"][0]["joints"] = Json::array(); }, "skins[0].joints"},
      {"sampler missing", [](GlbBuilder& g) { g.json["animations"][0]["channels"][0]["sampler"] = 9; },
       "animations[0].channels[0].sampler"},
      {"target twice",
       [](GlbBuilder& g) {
         Json& channels = g.json["animations"][0]["channels"];
         channels.push_back(channels[0]);
       },
       "animations[0].channels[3]"},
  };
}

// The same of what their numbers say.
std::vector<Fault> faultsOfData() {
  return {
      {"count is huge", [](GlbBuilder& g) { g.json["accessors"][0]["count"] = 4000000000U; }, "accessors[0]"},
      {"count without data",
       [](GlbBuilder& g) {
         g.json["accessors"][0].erase("bufferView");
         g.json["accessors"][0]["count"] = 4000000000U;
       },
       "accessors[0]"},
      {"offset overflows", [](GlbBuilder& g) { g.json["accessors"][0]["byteOffset"] = 9007199254740992U; },
       "accessors[0]"},
      {"view too long", [](GlbBuilder& g) { g.json["bufferViews"][0]["byteLength"] = 1U << 30U; },
       "bufferViews[0]"},
      {"stride below the element", [](GlbBuilder& g) { g.json["bufferViews"][0]["byteStride"] = 4; },
       "accessors[0]"},
      {"vertex index too large",
       [](GlbBuilder& g) {
         primitive(g)["indices"] = g.accessor(std::vector<std::uint16_t>{0, 1, 6}, 5123, "SCALAR", 1);
       },
       "meshes[0].primitives[0].indices"},
      {"indices are floats",
       [](GlbBuilder& g) {
         primitive(g)["indices"] = g.floats({0, 1, 2}, "SCALAR", 1);
       },
       "meshes[0].primitives[0].indices"},
      {"attributes of different counts",
       [](GlbBuilder& g) {
         primitive(g)["attributes"]["NORMAL"] = g.floats({0, 0, 1}, "VEC3", 3);
       },
       "meshes[0].primitives[0].attributes.NORMAL"},
      {"position is no number",
       [](GlbBuilder& g) {
         const float nan = std::numeric_limits<float>::quiet_NaN();
         g.json["meshes"][1]["primitives"][0]["attributes"]["POSITION"] = g.floats({0, 0, nan}, "VEC3", 3);
       },
       "meshes[1].primitives[0].attributes.POSITION"},
      {"inverse bind matrices too few",
       [](GlbBuilder& g) {
         g.json["skins"][0]["inverseBindMatrices"] = g.floats(std::vector<float>(16, 1), "MAT4", 16);
       },
       "skins[0].inverseBindMatrices"},
      {"values too few",
       [](GlbBuilder& g) {
         g.json["animations"][0]["samplers"][0]["output"] = g.floats({0, 0, 0, 1}, "VEC4", 4);
       },
       "animations[0].samplers[0].output"},
  };
}

std::vector<Fault> faults() {
  std::vector<Fault> all = structuralFaults();
  const std::vector<Fault> further = faultsOfData();
  all.insert(all.end(), further.begin(), further.end());
  return all;
}

} // namespace

TEST_CASE("What breaks a file is refused with its place") {
  const std::size_t index = GENERATE(range(std::size_t{0}, faults().size()));
  const Fault fault = faults()[index];
  INFO(fault.name);
  GlbBuilder glb = armBuilder();
  fault.make(glb);
  const Result<gltf::Loaded> result = loadBytes(glb.bytes());
  REQUIRE_FALSE(result.ok());
  CHECK_THAT(result.error().where, Catch::StartsWith(fault.where));
  CHECK(result.error().line().find('\n') == std::string::npos);
}

TEST_CASE("Warnings that differ only in their place share a line") {
  gltf::Problems problems;
  problems.warning("nodes[1]", "is odd");
  problems.warning("nodes[4]", "is odd");
  problems.warning("", "the file is odd");
  CHECK(problems.warningLines() ==
        std::vector<std::string>{"nodes[1] and 1 more: is odd", "the file is odd"});
  CHECK_FALSE(problems.hasErrors());
}

TEST_CASE("A data file that the model needs is named when it is missing") {
  const test::TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["buffers"] = {{{"uri", "gone%20away.bin"}, {"byteLength", glb.binary.size()}}};
  const std::string text = glb.json.dump();
  test::writeBytes(folder / "model.gltf", {text.begin(), text.end()});
  const Result<gltf::Loaded> missing = gltf::load(folder / "model.gltf");
  REQUIRE_FALSE(missing.ok());
  CHECK(missing.error().line().find("gone%20away.bin") != std::string::npos);
  test::writeBytes(folder / "gone away.bin", glb.binary);
  CHECK(gltf::load(folder / "model.gltf").ok());
}

TEST_CASE("A data file that the model does not need may be missing, whatever is said of its values") {
  const test::TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["buffers"] = {{{"uri", "here.bin"}, {"byteLength", glb.binary.size()}},
                         {{"uri", "gone.bin"}, {"byteLength", 24}}};
  glb.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 24}});
  glb.json["accessors"].push_back({{"bufferView", glb.json["bufferViews"].size() - 1},
                                   {"componentType", 5126},
                                   {"count", 2},
                                   {"type", "VEC3"},
                                   {"min", {1, 1, 1}},
                                   {"max", {2, 2, 2}}});
  const std::string text = glb.json.dump();
  test::writeBytes(folder / "model.gltf", {text.begin(), text.end()});
  test::writeBytes(folder / "here.bin", glb.binary);
  const Result<gltf::Loaded> file = gltf::load(folder / "model.gltf");
  REQUIRE(file.ok());
  CHECK(file->scene->meshes.size() == 2);
}

TEST_CASE("A file that is read as it stands is named in what refuses it, once") {
  const TemporaryFolder folder;
  const std::filesystem::path broken = folder.write("broken.gltf", "{\"asset\":");
  const Result<gltf::Loaded> loaded = gltf::loadAsItStands(broken);
  REQUIRE_FALSE(loaded);
  CHECK(loaded.error().where == broken.string() + ": JSON");
  const std::filesystem::path missing = folder / "missing.gltf";
  const Result<gltf::Loaded> nothing = gltf::loadAsItStands(missing);
  REQUIRE_FALSE(nothing);
  CHECK(nothing.error().where == missing.string());
}

TEST_CASE("A sparse index may be that of the last element, and not one behind it") {
  const int last = GENERATE(5, 6);
  GlbBuilder glb = test::armBuilder();
  const int position = glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>();
  REQUIRE(glb.json["accessors"][static_cast<std::size_t>(position)]["count"] == 6);
  const int indices =
      glb.accessor(std::vector<std::uint16_t>{0, static_cast<std::uint16_t>(last)}, 5123, "SCALAR", 1);
  const int values = glb.floats({7, 8, 9, 4, 5, 6}, "VEC3", 3);
  const auto viewOf = [&](int accessor) {
    return glb.json["accessors"][static_cast<std::size_t>(accessor)]["bufferView"];
  };
  Json& positions = glb.json["accessors"][static_cast<std::size_t>(position)];
  positions["min"] = {-9, -9, -9};
  positions["max"] = {9, 9, 9};
  positions["sparse"] = {{"count", 2},
                         {"indices", {{"bufferView", viewOf(indices)}, {"componentType", 5123}}},
                         {"values", {{"bufferView", viewOf(values)}}}};
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  CHECK(file.ok() == (last == 5));
  if (file) {
    const Primitive& strip = file->scene->meshes[0].primitives[0];
    CHECK(strip.positions.front() == glm::vec3(7, 8, 9));
    CHECK(strip.positions[5] == glm::vec3(4, 5, 6));
  } else {
    CHECK(test::refusal(file).find("are not increasing or point past the last element") != std::string::npos);
  }
}

TEST_CASE("Weights that are no numbers are mended from the neighbours, told and noted, others are not") {
  GlbBuilder glb = test::armBuilder();
  const bool isBroken = GENERATE(true, false);
  if (isBroken) {
    const auto weights = static_cast<std::size_t>(
        glb.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"].get<int>());
    const auto view = glb.json["accessors"][weights]["bufferView"].get<std::size_t>();
    const auto offset = glb.json["bufferViews"][view]["byteOffset"].get<std::size_t>();
    const float none = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(glb.binary.data() + offset, &none, sizeof(none));
  }
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  CHECK(file->scene->meshes[0].primitives[0].areInfluencesMended == isBroken);
  CHECK(test::warnsOf(*file, "no numbers for weights") == isBroken);
  for (const VertexInfluences& vertex : file->scene->meshes[0].primitives[0].influences) {
    float sum = 0.0F;
    for (const float weight : vertex.weights) {
      sum += weight;
    }
    CHECK(sum == Approx(1.0F));
  }
}

TEST_CASE("A picture may lie in any view of the buffer, the first one among them") {
  GlbBuilder glb = test::twoSheets();
  const std::string uri = test::onePixelUri;
  const gltf::Bytes picture = gltf::decodeDataUri(uri)->bytes;
  for (Json& accessor : glb.json["accessors"]) {
    accessor["bufferView"] = accessor["bufferView"].get<int>() + 1;
  }
  const std::size_t offset = (glb.binary.size() + 3) / 4 * 4;
  glb.binary.resize(offset);
  glb.binary.insert(glb.binary.end(), picture.begin(), picture.end());
  Json views = Json::array();
  views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", picture.size()}});
  for (const Json& view : glb.json["bufferViews"]) {
    views.push_back(view);
  }
  glb.json["bufferViews"] = views;
  glb.json["images"][0] = {{"bufferView", 0}, {"mimeType", "image/png"}};
  const gltf::Loaded file = test::loaded(glb);
  REQUIRE(file.scene->images.size() == 1);
  CHECK(file.scene->images[0].width == 1);
  CHECK(file.scene->images[0].rgba == test::loaded(test::twoSheets()).scene->images[0].rgba);
}

TEST_CASE("A channel of nothing that is shown is told and left out, whatever keeps it from being shown") {
  struct Case {
    Json target;
    const char* told;
  };
  const auto odd = GENERATE(values<Case>({{{{"path", "rotation"}}, "drives 'rotation' of no node"},
                                          {{{"path", "colour"}, {"node", 1}}, "drives 'colour' of no node"},
                                          {{{"path", "weights"}, {"node", 1}}, "without morph targets"}}));
  GlbBuilder glb = armBuilder();
  CAPTURE(odd.told);
  glb.json["animations"][0]["channels"][0]["target"] = odd.target;
  const gltf::Loaded file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn).value();
  REQUIRE(file.clips[0].tracks.size() == 2);
  CHECK(file.clips[0].tracks[0]->sourceChannel == 1);
  CHECK(file.clips[0].tracks[1]->sourceChannel == 2);
  CHECK(warnsOf(file, odd.told));
}

TEST_CASE("Keys that have not one value each are refused with their place") {
  GlbBuilder glb = armBuilder();
  const bool isEven = GENERATE(true, false);
  const std::vector<float> turns = isEven ? std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}
                                          : std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1};
  glb.json["animations"][0]["samplers"][0]["output"] = glb.floats(turns, "VEC4", 4);
  const Result<gltf::Loaded> file = loadBytes(glb.bytes(), gltf::Tolerance::warn);
  CHECK(file.ok() == isEven);
  if (!file) {
    CHECK(file.error().where == "animations[0].samplers[0].output");
    CHECK(file.error().what == "has 2 values for 3 keys, which need 3");
  }
}
