// Parts of a thing that is added to a file: what it needs, what only looks like a texture, and what is
// damaged.
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/packed/meshopt_view.h"
#include "core/gltf/source/added_file.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_source.h"
#include "core/gltf/write/new_file.h"
#include "tests/support/core/compressed_files.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

namespace {

gltf::AddedFile addedThing(const test::TemporaryFolder& folder, const GlbBuilder& glb) {
  glb.write(folder / "thing.glb");
  Result<gltf::Thing> thing = gltf::readThing(folder / "thing.glb");
  REQUIRE(thing);
  return {"thing.glb", "thing", {}, thing->source};
}

/// A source that has a texture of its own before those of the thing.
gltf::Source joinedWith(const test::TemporaryFolder& folder, const GlbBuilder& glb) {
  const Result<gltf::Source> joined =
      gltf::withAddedFiles(*test::loaded(test::twoSheets()).source, {addedThing(folder, glb)});
  REQUIRE(joined);
  return *joined;
}

} // namespace

TEST_CASE("Textures of a thing are counted behind those of the file") {
  const test::TemporaryFolder folder;
  const GlbBuilder glb = test::twoSheets();
  const gltf::Source joined = joinedWith(folder, glb);
  const Json& added = (*joined.json)["materials"][glb.json["materials"].size()];
  CHECK(added["pbrMetallicRoughness"]["baseColorTexture"]["index"] == glb.json["textures"].size());
}

TEST_CASE("What a thing requires to be read the file requires since, and no more often than once") {
  const test::TemporaryFolder folder;
  GlbBuilder glb = test::twoSheets();
  glb.json["extensionsRequired"] = {"KHR_materials_unlit"};
  const gltf::Source joined = joinedWith(folder, glb);
  CHECK(gltf::listsText(joined.json, "extensionsUsed", "KHR_materials_unlit"));
  CHECK(gltf::listsText(joined.json, "extensionsRequired", "KHR_materials_unlit"));
  CHECK((*joined.json)["extensionsRequired"].size() == 1);
  CHECK((*joined.json)["extensionsUsed"].size() == glb.json["extensionsUsed"].size());
}

TEST_CASE("Things of an autosave are read as long as all of their bytes are there, and none where none are") {
  const test::TemporaryFolder folder;
  const Json whole = gltf::addedToJson({addedThing(folder, test::twoSheets())});
  REQUIRE(gltf::addedFromJson(whole).size() == 1);
  Json longer = whole;
  Json& entry = longer["files"][0];
  entry["byteLength"] = entry["byteLength"].get<std::size_t>() + 8;
  CHECK(gltf::addedFromJson(longer).empty());
  Json later = whole;
  later["files"][0]["byteOffset"] = 8;
  CHECK(gltf::addedFromJson(later).empty());
  CHECK(gltf::addedFromJson(Json::object()).empty());
  CHECK(gltf::addedFromJson({{"files", whole["files"]}}).empty());
  CHECK(gltf::addedFromJson({{"bytes", whole["bytes"]}}).empty());
  CHECK(gltf::addedFromJson({{"files", whole["files"]}, {"bytes", "no data"}}).empty());
}

TEST_CASE("A thing of an autosave that says no length, no place or no file of its own is left out") {
  // One byte, of which its mesh needs none.
  const Json thing = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"componentType": 5126, "type": "VEC3", "count": 3, "min": [0, 0, 0], "max": [0, 0, 0]}],
    "buffers": [{"byteLength": 1}]})");
  gltf::Source source;
  source.json = Json(thing);
  source.buffers = {{7}};
  const Json whole =
      gltf::addedToJson({{"thing.glb", "thing", {}, std::make_shared<const gltf::Source>(source)}});
  REQUIRE(gltf::addedFromJson(whole).size() == 1);
  for (const char* const needed : {"byteLength", "translation", "rotation", "scale", "json"}) {
    CAPTURE(needed);
    Json without = whole;
    REQUIRE(without["files"][0].erase(needed) == 1);
    CHECK(gltf::addedFromJson(without).empty());
  }
  for (const char* const first : {"buffer", "byteOffset"}) { // the first where nothing is said
    CAPTURE(first);
    Json without = whole;
    REQUIRE(without["files"][0].erase(first) == 1);
    CHECK(gltf::addedFromJson(without).size() == 1);
  }
}

TEST_CASE(
    "A thing hangs in the scene that the file opens with: the named one, else the first, else in none") {
  const test::TemporaryFolder folder;
  const gltf::AddedFile thing = addedThing(folder, test::twoSheets());
  const auto rootsWith = [&](const Json& scenes, int named) {
    gltf::Source source = *test::loaded(test::twoSheets()).source;
    Json& json = *source.json;
    json.erase("scene");
    json.erase("scenes");
    if (!scenes.empty()) {
      json["scenes"] = scenes;
    }
    if (named >= 0) {
      json["scene"] = named;
    }
    const Result<gltf::Source> joined = gltf::withAddedFiles(source, {thing});
    REQUIRE(joined);
    std::vector<std::size_t> counts;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      counts.push_back((*joined->json)["scenes"][i]["nodes"].size());
    }
    return counts;
  };
  const Json three = {{{"nodes", {0}}}, {{"nodes", {1}}}, {{"nodes", {0}}}};
  CHECK(rootsWith(three, -1) == std::vector<std::size_t>{2, 1, 1});
  CHECK(rootsWith(three, 0) == std::vector<std::size_t>{2, 1, 1});
  CHECK(rootsWith(three, 1) == std::vector<std::size_t>{1, 2, 1});
  CHECK(rootsWith(three, 2) == std::vector<std::size_t>{1, 1, 2});
  CHECK(rootsWith(Json::array(), -1).empty());
}

TEST_CASE("Values that were packed with a filter count as rounded, those without one as they are") {
  const GlbBuilder plain = test::tubeBuilder();
  for (const test::Filters filters : {test::Filters::none, test::Filters::all}) {
    const gltf::Loaded file = test::loaded(test::packedByMeshopt(plain, filters));
    gltf::Problems problems;
    const auto opened = gltf::plainSource(*file.source, problems);
    REQUIRE(opened);
    std::set<std::size_t> rounded;
    const Json& json = file.source->json;
    for (std::size_t i = 0; i < json["accessors"].size(); ++i) {
      const Json& view = json["bufferViews"][json["accessors"][i]["bufferView"].get<std::size_t>()];
      if (view["extensions"]["EXT_meshopt_compression"].value("filter", "NONE") != "NONE") {
        rounded.insert(i);
      }
    }
    CHECK(rounded.empty() == (filters == test::Filters::none));
    CHECK(opened->roundedAccessors == rounded);
  }
}

TEST_CASE("A material of a new file keeps its name") {
  gltf::NewFile file;
  gltf::NewMaterial material;
  material.name = "cloth";
  CHECK(file.addMaterial(material) == 0);
  CHECK((*file.finish().json)["materials"][0]["name"] == "cloth");
}
