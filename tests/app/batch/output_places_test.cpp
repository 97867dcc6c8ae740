// Outputs that cannot be written are refused before there is any work, and nothing is written then.
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/tube_person.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using test::runVerb;
using test::TemporaryFolder;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

namespace {

/// Each of the verbs that write a character, with its own words and without an output.
std::vector<Words> writers(const TemporaryFolder& inputs) {
  const std::string dummy = test::posedCharacter;
  test::writeObjFrames(test::shorteningTube(3, 0.1, 0.2, 0.1), inputs / "tube", "tube");
  return {{"exaggerate", dummy, "--limb", "left-arm", "--scale", "2"},
          {"pose", dummy, "--pin-feet"},
          {"elastic", dummy},
          {"import-clip", dummy, "--from", STRETCH_SOURCE_DIR "/assets/dummy_swing.glb"},
          {"resave", dummy},
          {"rig", dummy},
          {"bind", dummy, "--keep-joints"},
          {"compress", (inputs / "tube").string(), "--bones", "3", "--stream", (inputs / "stream").string()}};
}

test::VerbAnswer writtenTo(Words words, const fs::path& output) {
  words.insert(words.end(), {"-o", output.string()});
  return runVerb(words);
}

} // namespace

TEST_CASE("An output of another ending, in no folder or of a folder's name is refused by every verb",
          "[output]") {
  const TemporaryFolder inputs;
  const TemporaryFolder outputs;
  fs::create_directories(outputs / "taken.glb");
  for (const Words& words : writers(inputs)) {
    INFO(words.front());
    for (const auto& [name, reason, exitCode] :
         {std::tuple("out.obj", "out.obj: an output has to end in .glb or .gltf", 2),
          std::tuple("out.vrm", "out.vrm: an output has to end in .glb or .gltf", 1), // an avatar stays one
          std::tuple("missing/out.glb", "missing: there is no such folder; make it", 1),
          std::tuple("taken.glb", "taken.glb: is a folder", 1)}) {
      INFO(name);
      const test::VerbAnswer answer = writtenTo(words, outputs / name);
      CHECK(answer.exitCode == exitCode);
      CHECK_THAT(answer.told, Catch::Contains(reason));
    }
  }
  CHECK(outputs.fileCount() == 0);
  CHECK_FALSE(fs::exists(inputs / "stream"));
}

TEST_CASE("Locators are written as .json and a style as well, where their folder is", "[output]") {
  const TemporaryFolder folder;
  const auto told = [&](Words words, const char* name, int exitCode = 1) {
    const test::VerbAnswer answer = writtenTo(std::move(words), folder / name);
    CHECK(answer.exitCode == exitCode);
    return answer.told;
  };
  const Words locators{"rig", test::posedCharacter, "--locators-only"};
  CHECK_THAT(told(locators, "places.glb", 2), Catch::Contains("places.glb: an output has to end in .json"));
  CHECK_THAT(told({"rig", test::posedCharacter}, "places.json", 2),
             Catch::Contains("places.json: an output has to end in .glb or .gltf"));
  CHECK_THAT(told(locators, "missing/places.json"), Catch::Contains("there is no such folder"));
  const Words style{"styles", "--style", "Subtle"};
  CHECK_THAT(told(style, "subtle.glb", 2), Catch::Contains("subtle.glb: an output has to end in .json"));
  CHECK_THAT(told(style, "missing/subtle.json"), Catch::Contains("there is no such folder"));
  CHECK(folder.fileCount() == 0);
  CHECK(writtenTo(locators, folder / "places.json").exitCode == 0);
  CHECK(writtenTo(style, folder / "subtle.json").exitCode == 0);
}

TEST_CASE("A stream and a table of curvature are refused where they cannot be, and nothing is written",
          "[output]") {
  const TemporaryFolder folder;
  test::writeObjFrames(test::shorteningTube(3, 0.1, 0.2, 0.1), folder / "tube", "tube");
  const std::size_t before = folder.fileCount();
  const auto told = [&](const char* option, const char* name) {
    const test::VerbAnswer answer =
        writtenTo({"compress", (folder / "tube").string(), "--bones", "3", option, (folder / name).string()},
                  folder / "out.glb");
    CHECK(answer.exitCode == 1);
    return answer.told;
  };
  CHECK_THAT(told("--stream", "missing/stream"), Catch::Contains("missing: there is no such folder"));
  CHECK_THAT(told("--curvature", "missing/table.csv"), Catch::Contains("missing: there is no such folder"));
  CHECK_THAT(told("--curvature", "out.glb"), Catch::Contains("out.glb: is written twice"));
  CHECK(folder.fileCount() == before);
  folder.write("stream", "a file");
  CHECK_THAT(told("--stream", "stream"), Catch::Contains("the folder cannot be made"));
  CHECK(folder.fileCount() == before + 1);
  CHECK(writtenTo({"compress", (folder / "tube").string(), "--bones", "3", "--stream",
                   (folder / "made").string() + "/"},
                  folder / "out.glb")
            .exitCode == 0); // as a shell completes a folder's name
  CHECK(fs::exists(folder / "made/frames.bin"));
}

TEST_CASE("An input that is not there is told before it is said to be written over", "[output]") {
  const TemporaryFolder folder;
  const std::string typo = (folder / "typo.glb").string();
  const test::VerbAnswer answer =
      test::runVerb({"exaggerate", typo, "--limb", "left-arm", "--scale", "2", "-o", typo});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains("there is no such file"));
}

TEST_CASE("A file that stays the avatar that it is keeps its ending", "[output]") {
  const TemporaryFolder folder;
  fs::copy_file(test::posedCharacter, folder / "avatar.vrm");
  CHECK(writtenTo({"resave", (folder / "avatar.vrm").string()}, folder / "again.vrm").exitCode == 0);
}

TEST_CASE("A buffer's file that another file names, or nobody knows, is not written over", "[output]") {
  const TemporaryFolder folder;
  const Words punch{"exaggerate", "--limb", "left-arm", "--range", "21:27", "--scale", "3"};
  const auto punched = [&](const std::string& source, const char* name) {
    Words words = punch;
    words.insert(words.begin() + 1, source);
    const test::VerbAnswer answer = writtenTo(words, folder / name);
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    REQUIRE(runVerb({"info", (folder / name).string()}).exitCode == 0);
  };
  // The source's own buffer, under the name that the output's would have.
  REQUIRE(writtenTo({"resave", test::posedCharacter}, folder / "x.gltf").exitCode == 0);
  fs::rename(folder / "x.gltf", folder / "source.gltf");
  const Bytes buffer = readFile(folder / "x.bin").value();
  punched((folder / "source.gltf").string(), "x.gltf");
  CHECK((readFile(folder / "x.bin").value() == buffer));
  // A file of that name which no glTF speaks of.
  folder.write("keep.bin", "precious");
  punched(test::posedCharacter, "keep.gltf");
  CHECK(readText(folder / "keep.bin").value() == "precious");
  // The output's own buffer of the last time is replaced: nothing piles up.
  const std::size_t files = folder.fileCount();
  punched(test::posedCharacter, "keep.gltf");
  CHECK(folder.fileCount() == files);
  CHECK(readText(folder / "keep.bin").value() == "precious");
}

TEST_CASE("A .glb that needs an image beside it says so where it is written to another folder", "[output]") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "in");
  fs::create_directories(folder / "out");
  test::twoSheets("red.png").write(folder / "in/sheets.glb");
  test::writeBytes(folder / "in/red.png", {1, 2, 3});
  const auto told = [&](const char* output) {
    const test::VerbAnswer answer =
        writtenTo({"resave", (folder / "in/sheets.glb").string()}, folder / output);
    CHECK(answer.exitCode == 0);
    return answer.output + answer.told;
  };
  CHECK_THAT(told("out/copy.glb"), Catch::Contains("copy.glb needs red.png, written beside it"));
  CHECK(fs::exists(folder / "out/red.png"));
  CHECK_THAT(told("in/copy.glb"), !Catch::Contains("needs red.png"));
  test::GlbBuilder two = test::twoSheets("red.png");
  two.json["images"].push_back(gltf::Json{{"uri", "blue.png"}});
  two.write(folder / "in/sheets.glb");
  test::writeBytes(folder / "in/blue.png", {4, 5, 6});
  CHECK_THAT(told("out/two.glb"), Catch::Contains("two.glb needs blue.png and 1 more, written beside it"));
  CHECK(fs::exists(folder / "out/blue.png"));
}

TEST_CASE("A rigged and a bound mesh say which images were written beside them", "[output]") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "in");
  fs::create_directories(folder / "out");
  const test::TubePerson person = test::tubePerson({.armsDown = 0.5});
  const std::string mesh = (folder / "in/person.gltf").string();
  test::writeMeshFile(mesh, person.positions, person.triangles);
  gltf::Json json = gltf::Json::parse(readText(mesh).value());
  json["images"] = {{{"uri", "red.png"}}};
  folder.write("in/person.gltf", json.dump());
  test::writeBytes(folder / "in/red.png", {1, 2, 3});
  for (const char* const verb : {"rig", "bind"}) {
    const test::VerbAnswer answer = writtenTo({verb, mesh}, folder / "out/made.glb");
    INFO(verb << ": " << answer.told);
    REQUIRE(answer.exitCode == 0);
    CHECK_THAT(answer.told, Catch::Contains("warning: made.glb needs red.png, written beside it"));
    CHECK(fs::exists(folder / "out/red.png"));
    fs::remove(folder / "out/red.png");
    CHECK_THAT(writtenTo({verb, mesh}, folder / "in/made.glb").told, !Catch::Contains("needs red.png"));
  }
}
