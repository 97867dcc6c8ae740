#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/added_file.h"
#include "core/gltf/source/fields.h"
#include "tests/support/core/two_sheets.h"

using namespace stretch;
using gltf::Json;
using test::armBuilder;
using test::GlbBuilder;
using test::TemporaryFolder;
using test::twoSheets;

namespace {

// A thing of another file beside the nodes of a source.

constexpr std::size_t armNodes = 6;

gltf::Thing thingOf(const TemporaryFolder& folder, const GlbBuilder& glb,
                    const std::string& name = "sheets.glb") {
  glb.write(folder / name);
  Result<gltf::Thing> thing = gltf::readThing(folder / name);
  INFO((thing ? std::string() : thing.error().line()));
  REQUIRE(thing);
  return *thing;
}

gltf::AddedFile addedSheets(const TemporaryFolder& folder, const GlbBuilder& glb = twoSheets(),
                            const std::string& node = "sheets") {
  return {"sheets.glb",
          node,
          {Vec3(1, 2, 3), Quat(0.8, 0.0, 0.36, 0.48), Vec3(2, 3, 4)},
          thingOf(folder, glb).source};
}

std::string refusal(const std::filesystem::path& path) {
  const Result<gltf::Thing> thing = gltf::readThing(path);
  return thing ? "read" : thing.error().line();
}

gltf::Source withFiles(const gltf::Source& source, const std::vector<gltf::AddedFile>& files,
                       const Json& work) {
  gltf::Edits edits;
  edits.addedFiles = files;
  edits.work = work;
  Result<gltf::Source> changed = gltf::patched(source, edits);
  INFO((changed ? std::string() : changed.error().line()));
  REQUIRE(changed);
  return *changed;
}

gltf::Loaded savedAndLoaded(const TemporaryFolder& folder, const gltf::Source& source) {
  REQUIRE(gltf::save(source, folder / "saved.glb"));
  Result<gltf::Loaded> file = gltf::load(folder / "saved.glb");
  INFO((file ? std::string() : file.error().line()));
  REQUIRE(file);
  return std::move(*file);
}

const Mesh& meshNamed(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.meshes, name, &Mesh::name);
  REQUIRE(found != scene.meshes.end());
  return *found;
}

const Material& materialNamed(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.materials, name, &Material::name);
  REQUIRE(found != scene.materials.end());
  return *found;
}

} // namespace

TEST_CASE(
    "a thing of another file stands behind the nodes of the source, with its meshes, materials and picture") {
  const TemporaryFolder folder;
  const gltf::Loaded arm = test::loaded(armBuilder());
  const gltf::Loaded sheets = test::loaded(twoSheets());
  const gltf::Loaded both = savedAndLoaded(folder, withFiles(*arm.source, {addedSheets(folder)}, {}));
  REQUIRE(both.scene->nodes.size() == armNodes + 3);
  const Node& carrier = both.scene->nodes.back();
  CHECK(carrier.name == "sheets");
  CHECK(carrier.rest.translation == Vec3(1, 2, 3));
  CHECK(carrier.rest.rotation == Quat(0.8, 0.0, 0.36, 0.48));
  CHECK(carrier.rest.scale == Vec3(2, 3, 4));
  CHECK(both.scene->nodes[armNodes].parent == NodeIndex(armNodes + 2));
  CHECK(both.scene->nodes[armNodes + 1].rest.translation == Vec3(5, 0, 0));
  const Primitive& sail = meshNamed(*both.scene, "sail").primitives.front();
  const Primitive& ownSail = meshNamed(*sheets.scene, "sail").primitives.front();
  CHECK(sail.positions == ownSail.positions);
  CHECK(sail.texCoords == ownSail.texCoords);
  CHECK(sail.indices == ownSail.indices);
  const Material& cloth = materialNamed(*both.scene, "cloth");
  REQUIRE(cloth.baseColorTexture.image >= 0);
  const auto picture = static_cast<std::size_t>(cloth.baseColorTexture.image);
  CHECK(both.scene->images[picture].rgba == sheets.scene->images[0].rgba);
  CHECK(gltf::listsText(both.source->json, "extensionsUsed", "KHR_materials_unlit"));
  // What the source has keeps its place.
  for (std::size_t i = 0; i < armNodes; ++i) {
    CHECK(both.scene->nodes[i].name == arm.scene->nodes[i].name);
  }
  CHECK(meshNamed(*both.scene, "skin").primitives.front().positions ==
        meshNamed(*arm.scene, "skin").primitives.front().positions);
  CHECK(both.clips.size() == arm.clips.size());
}

TEST_CASE("a file with work gives back its source by bytes and the things that were added to it") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "arm.glb");
  const gltf::Loaded arm = gltf::load(folder / "arm.glb").value();
  REQUIRE(gltf::save(*arm.source, folder / "plain.glb"));
  const std::vector<gltf::AddedFile> files{addedSheets(folder), addedSheets(folder, twoSheets(), "other")};
  const gltf::Loaded again = savedAndLoaded(folder, withFiles(*arm.source, files, {{"version", 1}}));
  CHECK(again.warnings.empty());
  REQUIRE(gltf::save(*again.source, folder / "restored.glb"));
  CHECK(test::readBytes(folder / "restored.glb") == test::readBytes(folder / "plain.glb"));
  REQUIRE(again.added.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(again.added[i].file == files[i].file);
    CHECK(again.added[i].name == files[i].name);
    CHECK(again.added[i].place == files[i].place);
    CHECK(again.added[i].thing->json == files[i].thing->json);
    CHECK(again.added[i].thing->buffers == files[i].thing->buffers);
  }
  CHECK(again.scene->nodes.size() == armNodes + 6);
  // Saved once more the same bytes come out.
  REQUIRE(gltf::save(withFiles(*again.source, again.added, {{"version", 1}}), folder / "second.glb"));
  CHECK(test::readBytes(folder / "second.glb") == test::readBytes(folder / "saved.glb"));
}

TEST_CASE("an added thing and edited keys stand beside each other as each does alone") {
  const TemporaryFolder folder;
  const gltf::Loaded arm = test::loaded(armBuilder());
  REQUIRE_FALSE(arm.clips.empty());
  const auto edited = [&](bool addsThing, bool editsKeys) {
    gltf::Edits edits;
    if (addsThing) {
      edits.addedFiles = {addedSheets(folder)};
      edits.addedNodes.push_back({"on a sheet", NodeIndex(armNodes + 1), {}, NodeIndex::none});
    }
    if (editsKeys) {
      std::vector<Track> tracks;
      for (const CopyOnWrite<Track>& track : arm.clips[0].tracks) {
        tracks.push_back(*track);
        for (float& value : tracks.back().values) {
          value = 0.5F * value + 0.125F;
        }
      }
      edits.clips = {{0, tracks}};
    }
    const Result<gltf::Source> changed = gltf::patched(*arm.source, edits);
    INFO((changed ? std::string() : changed.error().line()));
    REQUIRE(changed);
    return savedAndLoaded(folder, *changed);
  };
  const gltf::Loaded both = edited(true, true);
  const gltf::Loaded keys = edited(false, true);
  const gltf::Loaded thing = edited(true, false);
  REQUIRE(both.clips.size() == keys.clips.size());
  REQUIRE(both.clips[0].tracks.size() == keys.clips[0].tracks.size());
  for (std::size_t i = 0; i < keys.clips[0].tracks.size(); ++i) {
    CHECK(both.clips[0].tracks[i]->values == keys.clips[0].tracks[i]->values);
    CHECK(both.clips[0].tracks[i]->times == keys.clips[0].tracks[i]->times);
    CHECK(both.clips[0].tracks[i]->values != arm.clips[0].tracks[i]->values);
  }
  REQUIRE(both.scene->nodes.size() == thing.scene->nodes.size());
  CHECK(both.scene->nodes.back().parent == NodeIndex(armNodes + 1));
  REQUIRE(both.scene->meshes.size() == thing.scene->meshes.size());
  for (std::size_t i = 0; i < thing.scene->meshes.size(); ++i) {
    CHECK(both.scene->meshes[i].name == thing.scene->meshes[i].name);
    CHECK(both.scene->meshes[i].primitives[0].positions == thing.scene->meshes[i].primitives[0].positions);
    CHECK(both.scene->meshes[i].primitives[0].indices == thing.scene->meshes[i].primitives[0].indices);
  }
}

TEST_CASE("added things come back from text of their own") {
  const TemporaryFolder folder;
  const gltf::AddedFile file = addedSheets(folder);
  const std::vector<gltf::AddedFile> back = gltf::addedFromJson(gltf::addedToJson({file, file}));
  REQUIRE(back.size() == 2);
  CHECK(back[1].name == file.name);
  CHECK(back[1].thing->json == file.thing->json);
  CHECK(back[1].thing->buffers == file.thing->buffers);
}

TEST_CASE("what no hand can hold is refused with one line that names the file") {
  const TemporaryFolder folder;
  CHECK_THAT(refusal(folder / "gone.glb"), Catch::Contains("gone.glb"));
  folder.write("broken.glb", "glTF and no more");
  CHECK_THAT(refusal(folder / "broken.glb"), Catch::Contains("broken.glb"));
  armBuilder().write(folder / "arm.glb");
  CHECK_THAT(refusal(folder / "arm.glb"), Catch::Contains("skinned mesh") && Catch::Contains("arm.glb"));
  GlbBuilder empty = twoSheets();
  for (Json& node : empty.json["nodes"]) {
    node.erase("mesh");
  }
  empty.json.erase("animations");
  empty.write(folder / "empty.glb");
  CHECK_THAT(refusal(folder / "empty.glb"), Catch::Contains("holds no mesh") && Catch::Contains("empty.glb"));
  for (const char* const name : {"gone.glb", "broken.glb", "arm.glb", "empty.glb"}) {
    CHECK(refusal(folder / name).find('\n') == std::string::npos);
  }
  CHECK_FALSE(gltf::looksLikeThing(folder / "arm.glb"));
  CHECK_FALSE(gltf::looksLikeThing(folder / "broken.glb"));
  twoSheets().write(folder / "sheets.glb");
  CHECK(gltf::looksLikeThing(folder / "sheets.glb"));
}

TEST_CASE("a picture that cannot be read is left out with its texture, and told") {
  const TemporaryFolder folder;
  const gltf::Thing thing = thingOf(folder, twoSheets("gone.png"));
  REQUIRE(thing.warnings.size() == 1);
  CHECK_THAT(thing.warnings[0], Catch::Contains("gone.png") && Catch::Contains("sheets.glb"));
  const Json& cloth = thing.source->json->at("materials")[0];
  CHECK_FALSE(cloth["pbrMetallicRoughness"].contains("baseColorTexture"));
  CHECK_FALSE(cloth.contains("occlusionTexture"));
  CHECK(cloth["pbrMetallicRoughness"]["roughnessFactor"] == 0.375);
  CHECK_FALSE(thing.source->json->contains("images"));
}

TEST_CASE("a picture beside the file comes along inside, one outside of its folder is left out") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "things");
  const gltf::Loaded inside = test::loaded(twoSheets());
  const Json image{{"uri", test::onePixelUri}};
  const gltf::Bytes picture = gltf::encodedImage(*inside.source, image).value();
  test::writeBytes(folder / "red.png", picture);
  const gltf::Thing without = thingOf(folder, twoSheets("../red.png"), "things/outside.glb");
  CHECK(without.warnings.size() == 1);
  CHECK_FALSE(without.source->json->contains("images"));
  test::writeBytes(folder / "things" / "red.png", picture);
  const gltf::Thing thing = thingOf(folder, twoSheets("red.png"), "things/sheets.glb");
  CHECK(thing.warnings.empty());
  const Json& json = thing.source->json;
  REQUIRE(json["images"].size() == 1);
  CHECK(gltf::encodedImage(*thing.source, json["images"][0]) == picture);
  CHECK(json["images"][0]["mimeType"] == "image/png");
}

TEST_CASE("a damaged record of a thing never does more than leave it out") {
  const TemporaryFolder folder;
  const gltf::Loaded arm = test::loaded(armBuilder());
  const gltf::Source saved = withFiles(*arm.source, {addedSheets(folder)}, {{"version", 1}});
  const Json::json_pointer record("/extras/stretch_engine/restore/added/0");
  REQUIRE(saved.json->contains(record));
  const Json flat = saved.json->at(record).flatten();
  std::mt19937 random(5);
  std::size_t leftOut = 0;
  for (int i = 0; i < 400; ++i) {
    gltf::Source damaged = saved;
    auto entry = flat.begin();
    std::advance(entry, static_cast<std::ptrdiff_t>(random() % flat.size()));
    const Json values{-1,    3,      65536,   9007199254740991U, 0.5,
                      1e300, "text", nullptr, Json::array(),     Json::object()};
    damaged.json->at(record)[Json::json_pointer(entry.key())] = values[random() % values.size()];
    REQUIRE(gltf::save(damaged, folder / "damaged.glb"));
    const Result<gltf::Loaded> file = gltf::load(folder / "damaged.glb");
    if (file) {
      leftOut += file->added.empty() ? 1 : 0;
      CHECK_FALSE((file->added.empty() && file->warnings.empty()));
    } else {
      CHECK_FALSE(file.error().line().empty());
    }
  }
  CHECK(leftOut > 100);
}
