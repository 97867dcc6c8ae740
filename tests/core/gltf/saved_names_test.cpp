// Names and lengths that the files of a save get, whatever stands beside them already.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/refusal.h"

using namespace stretch;
using gltf::Json;
using test::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

/// Buffers without a name, each of so many bytes of which the last two only pad.
gltf::Source unnamedBuffers(std::size_t count) {
  gltf::Source source;
  source.json = Json{{"asset", {{"version", "2.0"}}}};
  for (std::size_t i = 0; i < count; ++i) {
    (*source.json)["buffers"].push_back({{"byteLength", 6}});
    source.buffers.emplace_back(8, static_cast<std::uint8_t>(i + 1));
  }
  return source;
}

Json jsonIn(const fs::path& file) {
  const gltf::Bytes bytes = test::readBytes(file);
  return Json::parse(bytes.begin(), bytes.end());
}

std::string uriOf(const Json& json, std::size_t buffer) {
  return json["buffers"][buffer]["uri"].get<std::string>();
}

} // namespace

TEST_CASE("Buffers without a name are called after their file, and hold what they say they do") {
  const TemporaryFolder folder;
  REQUIRE(gltf::save(unnamedBuffers(3), folder / "a walk.gltf"));
  const Json json = jsonIn(folder / "a walk.gltf");
  CHECK(uriOf(json, 0) == "a%20walk.bin");
  CHECK(uriOf(json, 1) == "a%20walk_1.bin");
  CHECK(uriOf(json, 2) == "a%20walk_2.bin");
  CHECK(test::readBytes(folder / "a walk.bin") == gltf::Bytes(6, 1));
  CHECK(test::readBytes(folder / "a walk_1.bin") == gltf::Bytes(6, 2));
  CHECK(test::readBytes(folder / "a walk_2.bin") == gltf::Bytes(6, 3));
  CHECK(folder.fileCount() == 4);
}

TEST_CASE("A buffer takes no name that the file itself refers to, however that is spelt") {
  for (const char* const spelt : {"walk.bin", "./walk.bin", "in/../walk.bin"}) {
    CAPTURE(spelt);
    const TemporaryFolder folder;
    gltf::Source source = unnamedBuffers(1);
    source.path = folder / "source.gltf";
    (*source.json)["images"] = {{{"uri", spelt}}};
    folder.write("walk.bin", "picture");
    REQUIRE(gltf::save(source, folder / "walk.gltf"));
    CHECK(uriOf(jsonIn(folder / "walk.gltf"), 0) == "walk_1.bin");
    CHECK(test::readBytes(folder / "walk.bin").size() == 7);
    // In another folder the name is free.
    const TemporaryFolder other;
    source.path = other / "source.gltf";
    REQUIRE(gltf::save(source, folder / "run.gltf"));
    CHECK(uriOf(jsonIn(folder / "run.gltf"), 0) == "run.bin");
  }
}

TEST_CASE("A buffer takes no name that the file refers to, though nothing has that name or the output is "
          "that file") {
  const char* const spelt = GENERATE("walk.bin", "./walk.bin", "in/../walk.bin");
  CAPTURE(spelt);
  const TemporaryFolder folder;
  gltf::Source source = unnamedBuffers(1);
  (*source.json)["images"] = {{{"uri", spelt}}};
  source.path = folder / "source.gltf";
  REQUIRE(gltf::save(source, folder / "walk.gltf"));
  CHECK(uriOf(jsonIn(folder / "walk.gltf"), 0) == "walk_1.bin");
  CHECK_FALSE(fs::exists(folder / "walk.bin"));
  folder.write("walk.bin", "picture");
  source.path = folder / "walk.gltf"; // which names it, and may replace its own buffers
  REQUIRE(gltf::save(source, folder / "walk.gltf"));
  CHECK(uriOf(jsonIn(folder / "walk.gltf"), 0) == "walk_1.bin");
  CHECK(test::readBytes(folder / "walk.bin").size() == 7);
}

TEST_CASE("A buffer is written over the file that the output alone named before, and over that of no other") {
  struct Case {
    const char* says;
    bool outputNames;
    bool sourceNames;
    const char* source;
    const char* expected;
  };
  const Case cases[] = {{"nobody names it", false, false, "source.gltf", "walk_1.bin"},
                        {"the output names it", true, false, "source.gltf", "walk.bin"},
                        {"the source names it", false, true, "source.gltf", "walk_1.bin"},
                        {"both name it", true, true, "source.gltf", "walk_1.bin"},
                        {"the output is the source", true, true, "walk.gltf", "walk.bin"},
                        {"the source is no text", true, false, "source.glb", "walk.bin"}};
  for (const Case& one : cases) {
    CAPTURE(one.says);
    const TemporaryFolder folder;
    const std::string naming = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"walk.bin"}]})";
    folder.write("walk.bin", "mine");
    if (one.outputNames) {
      folder.write("walk.gltf", naming);
    }
    if (one.sourceNames) {
      folder.write(one.source, naming);
    }
    gltf::Source source = unnamedBuffers(1);
    source.path = folder / one.source;
    REQUIRE(gltf::save(source, folder / "walk.gltf"));
    CHECK(uriOf(jsonIn(folder / "walk.gltf"), 0) == one.expected);
    CHECK(test::readBytes(folder / one.expected) == gltf::Bytes(6, 1));
    const bool isWrittenOver = std::string(one.expected) == "walk.bin";
    CHECK(test::readBytes(folder / "walk.bin").size() == (isWrittenOver ? 6 : 4));
  }
}

TEST_CASE("While a .gltf and its .bin are replaced what lies beside them stays, and nothing is left over") {
  const TemporaryFolder folder;
  REQUIRE(gltf::save(unnamedBuffers(2), folder / "walk.gltf"));
  folder.write("walk.saving.bin", "mine");
  folder.write("walk.saving-1.bin", "mine, too");
  gltf::Source source = unnamedBuffers(2);
  source.buffers[0][0] = 9;
  source.buffers[1][5] = 8;
  REQUIRE(gltf::save(source, folder / "walk.gltf"));
  CHECK(test::readBytes(folder / "walk.bin") == gltf::Bytes{9, 1, 1, 1, 1, 1});
  CHECK(test::readBytes(folder / "walk_1.bin") == gltf::Bytes{2, 2, 2, 2, 2, 8});
  CHECK(uriOf(jsonIn(folder / "walk.gltf"), 0) == "walk.bin");
  CHECK(uriOf(jsonIn(folder / "walk.gltf"), 1) == "walk_1.bin");
  CHECK(test::readBytes(folder / "walk.saving.bin").size() == 4);
  CHECK(test::readBytes(folder / "walk.saving-1.bin").size() == 9);
  CHECK(folder.fileCount() == 5);
}

TEST_CASE(
    "The first buffer becomes the BIN chunk of a .glb, cut to what it holds, and others stay beside it") {
  const TemporaryFolder folder;
  REQUIRE(gltf::save(unnamedBuffers(2), folder / "WALK.GLB"));
  const Result<gltf::Glb> glb = gltf::readGlb(test::readBytes(folder / "WALK.GLB"));
  REQUIRE(glb);
  const Json json = Json::parse(glb->json);
  CHECK_FALSE(json["buffers"][0].contains("uri"));
  CHECK(uriOf(json, 1) == "WALK_1.bin");
  REQUIRE(glb->binary.size() >= 6);
  CHECK(gltf::Bytes(glb->binary.begin(), glb->binary.begin() + 6) == gltf::Bytes(6, 1));
  CHECK(test::readBytes(folder / "WALK_1.bin") == gltf::Bytes(6, 2));
}

TEST_CASE("Names of outputs end in one of four ways, in letters of either case") {
  const TemporaryFolder folder;
  for (const char* const name :
       {"a.glb", "b.GLB", "c.gltf", "d.GLTF", "e.vrm", "f.VRM", "g.vrma", "h.Vrma"}) {
    CAPTURE(name);
    REQUIRE(gltf::save(unnamedBuffers(1), folder / name));
    const bool isText = test::readBytes(folder / name)[0] == '{';
    CHECK(isText == (name[0] == 'c' || name[0] == 'd'));
  }
  for (const char* const name : {"a.obj", "b", "glb", "c.glb.txt", "d.[lb"}) {
    CHECK_THAT(test::refusal(gltf::save(unnamedBuffers(1), folder / name)),
               Catch::Contains("an output has to end in .glb or .gltf"));
  }
  CHECK_THAT(test::refusal(gltf::save(unnamedBuffers(1), folder / "gone/a.glb")),
             Catch::Contains("there is no such folder"));
}
