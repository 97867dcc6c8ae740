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
