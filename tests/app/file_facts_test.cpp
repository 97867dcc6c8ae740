#include <cstdint>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "app/files/file_facts.h"
#include "app/files/save.h"
#include "tests/support/app/boxer.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A file tells its joints and clips before it is opened") {
  const FileFacts facts = factsOf(std::filesystem::path(STRETCH_SOURCE_DIR) / "assets/dummy.glb");
  CHECK(facts.kind == "Binary glTF");
  REQUIRE(facts.isScene);
  CHECK(facts.joints == 26);
  CHECK(facts.meshes >= 1);
  REQUIRE_FALSE(facts.clips.empty());
  CHECK(facts.clips.front().name == "One-two punch");
  CHECK(facts.clips.front().seconds == Approx(2.5));
  CHECK_FALSE(facts.carriesWork);
  CHECK(facts.problem.empty());
}

TEST_CASE("What is no glTF behind its name is said, and odd JSON is no trouble") {
  const test::TemporaryFolder folder;
  const auto facts = [&](const char* name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
    return factsOf(folder.path() / name);
  };
  CHECK(facts("text.glb", "no scene at all").problem == "is no glTF");
  CHECK(facts("short.glb", "glTF").problem == "cannot be read");
  CHECK(facts("lies.glb", std::string("glTF\2\0\0\0\xff\0\0\0\xff\0\0\0JSON", 20)).problem ==
        "is shorter than it says");
  CHECK(facts("other.glb", std::string("glTF\2\0\0\0\x18\0\0\0\4\0\0\0BIN\0----", 24)).problem ==
        "cannot be read");
  CHECK(facts("mesh.obj", "v 0 0 0").kind == "OBJ mesh");
  const FileFacts odd =
      facts("odd.gltf", R"({"skins": {"joints": 3}, "animations": [7, {"samplers": [{"input": 9},
      {"input": -1}, 4]}], "meshes": "x", "accessors": [{"max": ["late"]}], "extras": 1})");
  CHECK(odd.isScene);
  CHECK(odd.joints == 0);
  CHECK(odd.clips.size() == 2);
  CHECK(factsOf(folder.path() / "missing.glb").kind.empty());
}

TEST_CASE(
    "Joints of several skins count once, a clip is as long as its latest key, and work in a file is told") {
  const test::TemporaryFolder folder;
  const FileFacts facts = factsOf(folder.write("HERO.GLTF", R"({"meshes": [{}, {}],
      "skins": [{"joints": [1, 2, 3]}, {"joints": [3, 4]}],
      "accessors": [{"max": [0.5]}, {"max": [2.25]}, {"max": [1.0]}],
      "animations": [{"name": "walk", "samplers": [{"input": 0}, {"input": 1}, {"input": 2}]},
                     {"samplers": [{"input": 2}]}],
      "extras": {"stretch_engine": {}}})"));
  CHECK(facts.kind == "glTF with files beside it");
  CHECK(facts.problem.empty());
  CHECK(facts.isScene);
  CHECK(facts.meshes == 2);
  CHECK(facts.joints == 4);
  REQUIRE(facts.clips.size() == 2);
  CHECK(facts.clips[0].name == "walk");
  CHECK(facts.clips[0].seconds == 2.25);
  CHECK(facts.clips[1].name.empty());
  CHECK(facts.clips[1].seconds == 1.0);
  CHECK(facts.carriesWork);
}

TEST_CASE("A file of more than 32 MiB of text is not read for a preview") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("long.gltf", "{");
  constexpr std::uintmax_t longest = 32U << 20U;
  std::filesystem::resize_file(file, longest + 1);
  CHECK(factsOf(file).problem == "is too long for a preview");
  CHECK(factsOf(file).bytes == longest + 1);
  std::filesystem::resize_file(file, longest);
  CHECK(factsOf(file).problem == "is no glTF");
}
