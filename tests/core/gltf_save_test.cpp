#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::armBuilder;
using test::GlbBuilder;
using test::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

std::shared_ptr<const gltf::Source> sourceAt(const fs::path& path) {
  const Result<gltf::Loaded> file = gltf::load(path);
  if (!file) {
    FAIL(file.error().line());
  }
  return file->source;
}

// The JSON but for the place of the first buffer, which differs between .glb and .gltf.
std::string textWithoutPlace(Json json) {
  json["buffers"][0].erase("uri");
  return json.dump();
}

void saveOrFail(const gltf::Source& source, const fs::path& path) {
  if (const Status saved = gltf::save(source, path); !saved) {
    FAIL(saved.error().line());
  }
}

// A .gltf with its .bin and an image beside.
void writeSeparateFiles(const fs::path& folder) {
  fs::create_directories(folder / "textures");
  GlbBuilder glb = armBuilder();
  glb.json["buffers"] = {{{"uri", "my%20data.bin"}, {"byteLength", glb.binary.size()}}};
  glb.json["images"] = {{{"uri", "textures/skin.png"}}};
  const std::string text = glb.json.dump();
  test::writeBytes(folder / "model.gltf", {text.begin(), text.end()});
  test::writeBytes(folder / "my data.bin", glb.binary);
  test::writeBytes(folder / "textures" / "skin.png", {1, 2, 3});
}

} // namespace

TEST_CASE("Saving without an edit keeps every property in its order and every byte") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "model.glb");
  const auto source = sourceAt(folder / "model.glb");
  saveOrFail(*source, folder / "again.glb");
  const auto again = sourceAt(folder / "again.glb");
  CHECK(again->json->dump() == source->json->dump());
  CHECK(again->buffers == source->buffers);
  CHECK(test::readBytes(folder / "again.glb") == test::readBytes(folder / "model.glb"));
}

TEST_CASE("Between .glb and .gltf only the place of the first buffer changes") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "model.glb");
  const auto source = sourceAt(folder / "model.glb");
  saveOrFail(*source, folder / "text.gltf");
  CHECK(fs::is_regular_file(folder / "text.bin"));
  const auto text = sourceAt(folder / "text.gltf");
  CHECK((*text->json)["buffers"][0]["uri"] == "text.bin");
  CHECK(textWithoutPlace(text->json) == textWithoutPlace(source->json));
  CHECK(text->buffers == source->buffers);
  saveOrFail(*text, folder / "back.glb");
  CHECK(test::readBytes(folder / "back.glb") == test::readBytes(folder / "model.glb"));
}

TEST_CASE("Chunks that nobody knows stay in the GLB") {
  const TemporaryFolder folder;
  Result<gltf::Glb> glb = gltf::readGlb(armBuilder().bytes());
  glb->others.push_back({0x58585858, {1, 2, 3, 4}});
  test::writeBytes(folder / "model.glb", gltf::writeGlb(*glb).value());
  saveOrFail(*sourceAt(folder / "model.glb"), folder / "again.glb");
  CHECK(test::readBytes(folder / "again.glb") == test::readBytes(folder / "model.glb"));
}

TEST_CASE("Files beside a .gltf come along into another folder") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path() / "in");
  fs::create_directories(folder / "out/deep");
  saveOrFail(*sourceAt(folder / "in/model.gltf"), folder / "out/deep/copy.gltf");
  CHECK(test::readBytes(folder / "out/deep/my data.bin") == armBuilder().binary);
  CHECK(test::readBytes(folder / "out/deep/textures/skin.png") == gltf::Bytes{1, 2, 3});
  CHECK(folder.fileCount() == 6);
}

TEST_CASE("The files that an output in another folder needs are known, but for its first buffer") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path() / "in");
  const auto source = sourceAt(folder / "in/model.gltf");
  CHECK((gltf::filesBeside(*source, folder / "out.glb") == std::vector<fs::path>{"textures/skin.png"}));
  CHECK(gltf::filesBeside(*source, folder / "in/out.glb").empty());
  fs::remove(folder / "in/textures/skin.png");
  CHECK(gltf::filesBeside(*source, folder / "out.glb").empty());
}

TEST_CASE("Of the files that an output needs each is told once, by the order of their names") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path() / "in");
  test::writeBytes(folder / "in/textures/hair.png", {4});
  gltf::Source source = *sourceAt(folder / "in/model.gltf");
  (*source.json)["images"] = Json::parse(
      R"([{"uri": "textures/skin.png"}, {"uri": "textures/hair.png"}, {"uri": "./textures/skin.png"}])");
  CHECK((gltf::filesBeside(source, folder / "out.glb") ==
         std::vector<fs::path>{"textures/hair.png", "textures/skin.png"}));
}

TEST_CASE("Saving over the source leaves its files whole") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path());
  const auto source = sourceAt(folder / "model.gltf");
  saveOrFail(*source, folder / "model.gltf");
  CHECK(folder.fileCount() == 3);
  CHECK(sourceAt(folder / "model.gltf")->json->dump() == source->json->dump());
}

TEST_CASE("An image outside the folder is refused when it would have to be copied out of it") {
  const TemporaryFolder folder;
  GlbBuilder glb = armBuilder();
  glb.json["images"] = {{{"uri", "../skin.png"}}};
  fs::create_directories(folder / "in");
  glb.write(folder / "in/model.glb");
  test::writeBytes(folder / "skin.png", {1, 2, 3});
  const auto source = sourceAt(folder / "in/model.glb");
  CHECK(gltf::save(*source, folder / "in/beside.glb").ok());
  fs::create_directories(folder / "elsewhere/deep");
  const Status refused = gltf::save(*source, folder / "elsewhere/deep/model.glb");
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().where == "images[0]");
  CHECK(fs::is_empty(folder / "elsewhere/deep"));
}

TEST_CASE("A folder that is not there is told and not made") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path());
  const Status refused = gltf::save(*sourceAt(folder / "model.gltf"), folder / "mistyped/copy.glb");
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().where == (folder / "mistyped").string());
  CHECK_FALSE(fs::exists(folder / "mistyped"));
}

TEST_CASE("A file of another model with the same name is not overwritten") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path() / "in");
  fs::create_directories(folder / "out/textures");
  test::writeBytes(folder / "out/textures/skin.png", {9});
  const Status refused = gltf::save(*sourceAt(folder / "in/model.gltf"), folder / "out/model.gltf");
  CHECK_THAT(test::refusal(refused), Catch::Contains("is already there with other content"));
  CHECK(test::readBytes(folder / "out/textures/skin.png") == gltf::Bytes{9});
  CHECK(folder.fileCount() == 4);
}

TEST_CASE("A save that fails leaves nothing behind and the old file as it was") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "model.glb");
  const auto source = sourceAt(folder / "model.glb");
  fs::create_directories(folder / "taken.gltf/inside");
  const auto reason = [&](const char* name) { return test::refusal(gltf::save(*source, folder / name)); };
  CHECK_THAT(reason("taken.gltf"), Catch::StartsWith((folder / "taken.gltf").string()));
  CHECK_THAT(reason("model.obj"), Catch::Contains("an output has to end in .glb or .gltf"));
  CHECK_THAT(reason("model.glb/below.glb"), Catch::StartsWith((folder / "model.glb").string()));
  CHECK(folder.fileCount() == 1);
  CHECK(test::readBytes(folder / "model.glb") == armBuilder().bytes());
}

TEST_CASE("When the last of several files finds no place, the others are as they were") {
  const TemporaryFolder folder;
  writeSeparateFiles(folder.path() / "in");
  fs::create_directories(folder / "out/taken.gltf/inside");
  CHECK_FALSE(gltf::save(*sourceAt(folder / "in/model.gltf"), folder / "out/taken.gltf").ok());
  CHECK(folder.fileCount() == 3);
  CHECK_FALSE(fs::exists(folder / "out/textures"));
  armBuilder().write(folder / "model.glb");
  test::writeBytes(folder / "out/taken.bin", {7});
  CHECK_FALSE(gltf::save(*sourceAt(folder / "model.glb"), folder / "out/taken.gltf").ok());
  CHECK(test::readBytes(folder / "out/taken.bin") == gltf::Bytes{7});
  CHECK(folder.fileCount() == 5);
}

TEST_CASE("A BIN chunk that no buffer refers to stays") {
  const TemporaryFolder folder;
  gltf::Glb glb;
  glb.json =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"data:application/octet-stream;base64,AA=="}]})";
  glb.hasBinary = true;
  glb.binary = {4, 3, 2, 1};
  test::writeBytes(folder / "model.glb", gltf::writeGlb(glb).value());
  saveOrFail(*sourceAt(folder / "model.glb"), folder / "again.glb");
  const Result<gltf::Glb> again = gltf::readGlb(test::readBytes(folder / "again.glb"));
  REQUIRE(again.ok());
  CHECK(again->binary == glb.binary);
  CHECK(Json::parse(again->json) == Json::parse(glb.json));
}

TEST_CASE("A save keeps the link, the permissions and the files of others") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "model.glb");
  const auto source = sourceAt(folder / "model.glb");
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder.write("real.glb", "old"), own);
  fs::create_symlink("real.glb", folder / "link.glb");
  folder.write("link.glb.partial", "mine");
  saveOrFail(*source, folder / "link.glb");
  CHECK(fs::is_symlink(folder / "link.glb"));
  CHECK(fs::status(folder / "real.glb").permissions() == own);
  CHECK(test::readBytes(folder / "real.glb") == test::readBytes(folder / "model.glb"));
  CHECK(folder.fileCount() == 4);
}

TEST_CASE("The .bin of a .gltf that cannot be replaced stays") {
  const TemporaryFolder folder;
  armBuilder().write(folder / "model.glb");
  folder.write("text.bin", "old");
  fs::create_directories(folder / "text.gltf/inside");
  CHECK_FALSE(gltf::save(*sourceAt(folder / "model.glb"), folder / "text.gltf").ok());
  CHECK(test::readBytes(folder / "text.bin") == gltf::Bytes{'o', 'l', 'd'});
  CHECK(folder.fileCount() == 2);
}
