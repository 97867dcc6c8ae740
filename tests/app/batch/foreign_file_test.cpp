#include <string>

#include <catch2/catch.hpp>

#include "app/files/file_facts.h"
#include "app/files/save.h"
#include "app/session.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/foreign_text.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::TemporaryFolder;

namespace {

const std::string marching = STRETCH_SOURCE_DIR "/tests/ui/files/marching.bvh";

bool isOneLine(const std::string& told) {
  return !told.empty() && told.find('\n') == told.size() - 1;
}

} // namespace

TEST_CASE("A BVH is brought to a character by one command, and what was guessed of it is told") {
  const TemporaryFolder folder;
  const std::string output = (folder / "marching.glb").string();
  const test::VerbAnswer answer =
      test::runVerb({"import-clip", test::posedCharacter, "-o", output, "--from", marching, "--json"});
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  const Json report = Json::parse(answer.output);
  CHECK(report["clips"][0]["way"] == "retargeted");
  CHECK(report["clips"][0]["frames"] == 25);
  CHECK(report["clips"][0]["fps"] == 30.0);
  CHECK(report["warnings"].dump().find("names no unit") != std::string::npos);
  const Result<Document> made = openDocument(output);
  REQUIRE(made);
  CHECK(made->clips->back().name == "marching"); // A BVH names no clip: it is the file's.
}

TEST_CASE("Every verb reads a file of another program, and none writes it") {
  const TemporaryFolder folder;
  const std::string fbx = folder.write("bones.fbx", test::twoBonesFbx()).string();
  const test::VerbAnswer info = test::runVerb({"info", fbx, "--json"});
  REQUIRE(info.exitCode == 0);
  CHECK(Json::parse(info.output)["clips"][0]["name"] == "bend");
  const std::string glb = (folder / "bones.glb").string();
  CHECK(test::exitCodeOf({"resave", fbx, "-o", glb}) == 0);
  CHECK(openDocument(glb).value().clips->front().framesPerSecond == 24.0);
  const test::VerbAnswer over = test::runVerb({"resave", fbx, "-o", fbx, "--in-place"});
  CHECK(over.exitCode == 2);
  CHECK(over.told.find("has to end in .glb or .gltf") != std::string::npos);
  CHECK(test::runVerb({"check", fbx}).exitCode == 0);
}

TEST_CASE("A file of another program opens as a new document: the first save asks for a name") {
  const TemporaryFolder folder;
  const std::string fbx = folder.write("bones.fbx", test::twoBonesFbx()).string();
  Result<Document> document = openDocument(fbx);
  REQUIRE(document);
  const Session session(*document);
  CHECK(session.savePath().empty());
  CHECK(session.proposedSavePath().extension() == ".glb");
}

TEST_CASE("A file that is no character is named in one line by every verb that asks for one") {
  const TemporaryFolder folder;
  const std::string zip = folder.write("walk.fbx", "PK\x03\x04 and so on").string();
  const test::VerbAnswer info = test::runVerb({"info", zip});
  CHECK(info.exitCode == 1);
  CHECK(isOneLine(info.told));
  CHECK(info.told.find("is a ZIP archive") != std::string::npos);
  const std::string mesh = folder.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
  const test::VerbAnswer import =
      test::runVerb({"import-clip", test::posedCharacter, "-o", (folder / "a.glb").string(), "--from", mesh});
  CHECK(import.exitCode == 1);
  CHECK(isOneLine(import.told));
  CHECK(import.told.find("is an OBJ mesh") != std::string::npos);
}

TEST_CASE("Before it is read, a file of another program is known by its kind") {
  CHECK(factsOf(marching).kind == "BVH motion capture");
  CHECK_FALSE(factsOf(marching).isScene);
  CHECK(factsOf(marching).problem.empty());
}
