// Things of other files that have what few have: nodes below nodes, sparse values, pictures by extensions.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/added_file.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

namespace {

/// The scene of an arm with a thing of this file beside it.
std::shared_ptr<const Scene> withThing(const GlbBuilder& glb, gltf::Thing* taken = nullptr) {
  const test::TemporaryFolder folder;
  glb.write(folder.path() / "thing.glb");
  const Result<gltf::Thing> thing = gltf::readThing(folder.path() / "thing.glb");
  INFO(test::refusal(thing));
  REQUIRE(thing);
  if (taken != nullptr) {
    *taken = *thing;
  }
  const gltf::Loaded arm = test::loaded(test::armBuilder());
  const gltf::AddedFile file{
      "thing.glb", "thing", {Vec3(1.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)}, thing->source};
  CHECK(gltf::addedNodeCount(file) == (*thing->source->json)["nodes"].size() + 1);
  const auto scene = gltf::sceneWith(*arm.source, {file});
  INFO(test::refusal(scene));
  REQUIRE(scene);
  CHECK((*scene)->nodes.size() == arm.scene->nodes.size() + gltf::addedNodeCount(file));
  return *scene;
}

Vec3 worldOf(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  REQUIRE(found != scene.nodes.end());
  return positionOf(
      worldMatrices(scene, restPose(scene))[static_cast<std::size_t>(found - scene.nodes.begin())]);
}

const Mesh& meshCalled(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.meshes, name, &Mesh::name);
  REQUIRE(found != scene.meshes.end());
  return *found;
}

} // namespace

TEST_CASE("Nodes of a thing keep what hangs on them, and where") {
  GlbBuilder glb = test::twoSheets();
  glb.json["nodes"][0]["name"] = "mast";
  glb.json["nodes"][0]["translation"] = {0, 2, 0};
  glb.json["nodes"][0]["children"] = {1};
  glb.json["nodes"][1]["name"] = "boom";
  glb.json["nodes"].push_back({{"name", "tip"}, {"translation", {0, 0, 3}}});
  glb.json["nodes"][1]["children"] = {2};
  glb.json["scenes"][0]["nodes"] = {0};
  const auto scene = withThing(glb);
  CHECK(worldOf(*scene, "mast") == Vec3(1.0, 2.0, 0.0));
  CHECK(worldOf(*scene, "boom") == Vec3(6.0, 2.0, 0.0));
  CHECK(worldOf(*scene, "tip") == Vec3(6.0, 2.0, 3.0));
}

TEST_CASE("Values of a thing that are written sparsely come along") {
  GlbBuilder glb = test::twoSheets();
  const int indices = glb.accessor<std::uint16_t>({2}, 5123, "SCALAR", 1);
  const int values = glb.floats({7, 8, 9}, "VEC3", 3);
  const auto viewOf = [&](int accessor) {
    return glb.json["accessors"][static_cast<std::size_t>(accessor)]["bufferView"];
  };
  const auto places = glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
  glb.json["accessors"][places]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", viewOf(indices)}, {"componentType", 5123}}},
      {"values", {{"bufferView", viewOf(values)}}}};
  glb.json["accessors"][places]["max"] = {7, 8, 9};
  glb.json["accessors"][places]["min"] = {0, 0, 0};
  const auto scene = withThing(glb);
  const std::vector<glm::vec3>& sail = meshCalled(*scene, "sail").primitives[0].positions;
  CHECK(sail == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {7, 8, 9}, {0, 1, 0}});
  CHECK(meshCalled(*scene, "flag").primitives[0].positions[2] == glm::vec3(1, 1, 0));
}

TEST_CASE(
    "A texture of a thing may have pictures by its extensions, and goes where one of them cannot be read") {
  GlbBuilder glb = test::twoSheets();
  glb.json["images"].push_back({{"uri", "gone.webp"}});
  glb.json["textures"].push_back({{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
  glb.json["textures"].push_back({{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}});
  glb.json["extensionsUsed"].push_back("EXT_texture_webp");
  glb.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
  glb.json["materials"][0]["normalTexture"] = {{"index", 2}};
  gltf::Thing thing;
  const auto scene = withThing(glb, &thing);
  REQUIRE(thing.warnings.size() == 1);
  CHECK(thing.warnings[0].find("its picture 'gone.webp' cannot be read and is left out") !=
        std::string::npos);
  const Json& json = thing.source->json;
  CHECK(json["images"].size() == 1);
  const auto plain =
      std::ranges::find_if(json["materials"], [](const Json& one) { return one["name"] == "plain"; });
  REQUIRE(plain != json["materials"].end());
  CHECK_FALSE(plain->contains("normalTexture"));
  const Json& texture = json["textures"][(*plain)["emissiveTexture"]["index"].get<std::size_t>()];
  CHECK(texture["source"] == 0);
  CHECK(texture["extensions"]["EXT_texture_webp"]["source"] == 0);
  CHECK(std::ranges::count_if(scene->images, [](const Image& image) { return !image.rgba.empty(); }) > 0);
}

TEST_CASE("A texture that an extension names, or whose extension names its picture, goes where that is not "
          "there") {
  GlbBuilder glb = test::twoSheets();
  glb.json["textures"].push_back({{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 7}}}}}});
  glb.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
  glb.json["materials"][0]["extensions"] = {
      {"KHR_materials_clearcoat", {{"clearcoatTexture", {{"index", 99}}}}}};
  gltf::Thing thing;
  withThing(glb, &thing);
  REQUIRE(thing.warnings.size() == 2);
  CHECK(thing.warnings[0].find("its picture '' cannot be read and is left out") != std::string::npos);
  CHECK(thing.warnings[1].find("its texture 99 is not there and is left out") != std::string::npos);
  const Json& materials = (*thing.source->json)["materials"];
  const auto plain = std::ranges::find_if(materials, [](const Json& one) { return one["name"] == "plain"; });
  REQUIRE(plain != materials.end());
  CHECK_FALSE(plain->contains("emissiveTexture"));
  CHECK((*plain)["extensions"]["KHR_materials_clearcoat"].empty());
}

TEST_CASE("Values of a thing in a buffer without bytes are zeros, which is told") {
  GlbBuilder glb = test::twoSheets();
  glb.json["buffers"] = {Json::object(), {{"byteLength", 64}}};
  glb.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 64}});
  const std::size_t view = glb.json["bufferViews"].size() - 1;
  const auto placesOf = [&](std::size_t mesh) -> Json& {
    Json& primitive = glb.json["meshes"][mesh]["primitives"][0];
    return glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  };
  placesOf(0)["bufferView"] = view;
  placesOf(1)["sparse"] = {{"count", 2},
                           {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                           {"values", {{"bufferView", view}}}};
  gltf::Thing thing;
  const auto scene = withThing(glb, &thing);
  REQUIRE(thing.warnings.size() == 1);
  CHECK(thing.warnings[0].find("values of its meshes are not in the file") != std::string::npos);
  CHECK(meshCalled(*scene, "sail").primitives[0].positions == std::vector<glm::vec3>(4, glm::vec3(0.0F)));
  CHECK(meshCalled(*scene, "flag").primitives[0].positions[2] == glm::vec3(1, 1, 0));
}

TEST_CASE("Extensions of nodes, meshes and their parts stay behind when a thing is taken, those of materials "
          "come") {
  GlbBuilder glb = test::twoSheets();
  for (const char* const list : {"nodes", "meshes"}) {
    for (Json& entry : glb.json[list]) {
      entry["extensions"] = {{"EXT_foo", Json::object()}};
    }
  }
  for (Json& mesh : glb.json["meshes"]) {
    for (Json& part : mesh["primitives"]) {
      part["extensions"] = {{"EXT_foo", Json::object()}};
    }
  }
  glb.json["extensionsUsed"].push_back("EXT_foo");
  gltf::Thing thing;
  withThing(glb, &thing);
  const Json& json = thing.source->json;
  for (const char* const list : {"nodes", "meshes"}) {
    CAPTURE(list);
    REQUIRE(json[list].size() == 2);
    CHECK(std::ranges::none_of(json[list], [](const Json& entry) { return entry.contains("extensions"); }));
  }
  for (const Json& mesh : json["meshes"]) {
    CHECK_FALSE(mesh["primitives"][0].contains("extensions"));
  }
  CHECK(std::ranges::any_of(json["materials"], [](const Json& one) { return one.contains("extensions"); }));
  CHECK(json.value("extensionsUsed", Json::array()) == Json::array({"KHR_materials_unlit"})); // not what
                                                                                              // stayed behind
}

TEST_CASE("A file that shows no scene is no thing") {
  GlbBuilder glb = test::twoSheets();
  glb.json.erase("scene");
  glb.json.erase("scenes");
  const test::TemporaryFolder folder;
  glb.write(folder.path() / "none.glb");
  CHECK(test::refusal(gltf::readThing(folder.path() / "none.glb")).find("has no scene") != std::string::npos);
}

TEST_CASE("A node that is added says its place, its turn and its scale where they are not those of rest, and "
          "what it is") {
  const gltf::Loaded arm = test::loaded(test::armBuilder());
  gltf::Edits edits;
  const Transform rest;
  Transform scaled;
  scaled.scale = Vec3(1.0, 2.0, 3.0);
  Transform moved;
  moved.translation = Vec3(4.0, 5.0, 6.0);
  edits.addedNodes = {{"plain", NodeIndex(0), rest, NodeIndex::none, false},
                      {"", NodeIndex(0), scaled, NodeIndex::none, true},
                      {"corner", NodeIndex(1), moved, NodeIndex::none, true, true}};
  const Result<gltf::Source> patched = gltf::patched(*arm.source, edits);
  REQUIRE(patched);
  const Json& nodes = (*patched->json)["nodes"];
  const std::size_t first = arm.scene->nodes.size();
  CHECK(nodes[first] == Json{{"name", "plain"}});
  CHECK(nodes[first + 1] ==
        Json::parse(R"({"scale": [1.0, 2.0, 3.0], "extras": {"stretch_engine": {"bind": true}}})"));
  CHECK(nodes[first + 2] == Json::parse(R"({"name": "corner", "translation": [4.0, 5.0, 6.0],
      "extras": {"stretch_engine": {"bind": true, "corner": true}}})"));
}

TEST_CASE("Joints that a skin gets stand behind its own, each with its matrix") {
  const gltf::Loaded arm = test::loaded(test::armBuilder());
  const Skin& before = arm.scene->skins[0];
  gltf::Edits edits;
  Mat4 first(1.0);
  first[3] = Vec4(1.0, 2.0, 3.0, 1.0);
  edits.addedSlots = {{0, NodeIndex(3), first}, {0, NodeIndex(5), Mat4(2.0)}};
  Result<gltf::Source> patched = gltf::patched(*arm.source, edits);
  REQUIRE(patched);
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(*patched, folder.path() / "grown.glb"));
  const Result<gltf::Loaded> grown = gltf::load(folder.path() / "grown.glb", gltf::Tolerance::warn);
  INFO(test::refusal(grown));
  REQUIRE(grown);
  const Skin& skin = grown->scene->skins[0];
  const std::size_t own = before.joints.size();
  REQUIRE(skin.joints.size() == own + 2);
  for (std::size_t i = 0; i < own; ++i) {
    CHECK(skin.joints[i] == before.joints[i]);
    CHECK(skin.inverseBind[i] == before.inverseBind[i]);
  }
  CHECK(skin.joints[own] == NodeIndex(3));
  CHECK(skin.joints[own + 1] == NodeIndex(5));
  CHECK(skin.inverseBind[own] == first);
  for (const auto& [skinIndex, node] : {std::pair(1, 0), {0, 6}, {-1, 0}, {0, -1}}) {
    gltf::Edits unfit;
    unfit.addedSlots = {{skinIndex, NodeIndex(node), Mat4(1.0)}};
    CHECK(test::refusal(gltf::patched(*arm.source, unfit))
              .find("a joint that skin " + std::to_string(skinIndex) + " gets") != std::string::npos);
  }
}

TEST_CASE("A joint that a skin gets has its own matrix where the file has more matrices than joints") {
  GlbBuilder glb = test::armBuilder();
  std::vector<float> numbers;
  for (int matrix = 0; matrix < 5; ++matrix) {
    numbers.insert(numbers.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, static_cast<float>(matrix), 0, 0, 1});
  }
  glb.json["skins"][0]["inverseBindMatrices"] = glb.floats(numbers, "MAT4", 16);
  const gltf::Loaded arm = test::loaded(glb);
  Mat4 own(1.0);
  own[3] = Vec4(7.0, 8.0, 9.0, 1.0);
  gltf::Edits edits;
  edits.addedSlots = {{0, NodeIndex(3), own}};
  const Result<gltf::Source> patched = gltf::patched(*arm.source, edits);
  REQUIRE(patched);
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(*patched, folder.path() / "grown.glb"));
  const Result<gltf::Loaded> grown = gltf::load(folder.path() / "grown.glb", gltf::Tolerance::warn);
  INFO(test::refusal(grown));
  REQUIRE(grown);
  const Skin& skin = grown->scene->skins[0];
  REQUIRE(skin.inverseBind.size() == 4);
  CHECK(skin.inverseBind[2] == arm.scene->skins[0].inverseBind[2]);
  CHECK(skin.inverseBind[3] == own);
}

TEST_CASE("Instances of a thing's mesh are left out, and told once for all of its nodes") {
  GlbBuilder glb = test::twoSheets();
  const Json instances{{"attributes", {{"TRANSLATION", glb.floats({0, 0, 0, 1, 0, 0, 2, 0, 0}, "VEC3", 3)}}}};
  for (Json& node : glb.json["nodes"]) {
    node["extensions"]["EXT_mesh_gpu_instancing"] = instances;
  }
  glb.json["extensionsUsed"].push_back("EXT_mesh_gpu_instancing");
  gltf::Thing thing;
  (void)withThing(glb, &thing);
  REQUIRE(thing.warnings.size() == 1);
  CHECK(thing.warnings[0].find("thing.glb: what its nodes have by 'EXT_mesh_gpu_instancing' is left out") !=
        std::string::npos);
}
