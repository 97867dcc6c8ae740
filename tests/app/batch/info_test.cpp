#include <catch2/catch.hpp>

#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

/// The bundled character with three trails: two of one group that has a name, one of them disconnected.
Document withWork() {
  const Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  Document document = test::withNewTrail(*opened, {.startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
  document = test::withNewTrail(
      document,
      {.limb = "right-arm", .startFrame = 37.0, .endFrame = 43.0, .scale = 2.5, .connected = false});
  document = test::withNewTrail(document, {.limb = "spine", .startFrame = 21.0, .endFrame = 27.0});
  const std::vector<int> both{1, 2};
  Result<Document> grouped = groupTrails(document, both);
  REQUIRE(grouped);
  for (rig::Trail& trail : grouped->trails) {
    trail.groupName = trail.group > 0 ? "both fists" : "";
    trail.applied = trail.limb == "spine";
  }
  return setLooping(*grouped, 0, true);
}

} // namespace

TEST_CASE("What a file carries of the work is told: trails with range, scale, state and group, and loops") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "work.glb";
  REQUIRE(saveDocument(withWork(), file, {}));
  const test::VerbAnswer answer = test::runVerb({"info", file.string(), "--json"});
  REQUIRE(answer.exitCode == 0);
  const Json info = Json::parse(answer.output);
  REQUIRE(info["trails"].size() == 3);
  const std::string clip = info["clips"][0]["name"];
  CHECK(info["trails"][0] == Json{{"limb", "left-arm"},
                                  {"clip", clip},
                                  {"range", {21.0, 27.0}},
                                  {"scale", 3.0},
                                  {"state", "connected"},
                                  {"group", 1},
                                  {"group_name", "both fists"}});
  CHECK(info["trails"][1]["state"] == "disconnected");
  CHECK(info["trails"][2]["state"] == "applied");
  CHECK_FALSE(info["trails"][2].contains("group"));
  CHECK(info["loops"] == Json::array({clip}));
}

TEST_CASE("A file without work has no trails to tell of") {
  const test::VerbAnswer answer = test::runVerb({"info", STRETCH_SOURCE_DIR "/assets/dummy.glb", "--json"});
  REQUIRE(answer.exitCode == 0);
  CHECK(Json::parse(answer.output)["trails"] == Json::array());
}

TEST_CASE("Adjustments that a file carries are told with keys and range") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "posed.glb";
  const Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const ControllerOffset lowered{"hips", {0.0, -0.1, 0.0}, {}};
  const Result<Document> posed = setOffsets(*opened, 0, 12.0, {&lowered, 1}, {}, {Vec2(4.0, 20.0)});
  REQUIRE(posed);
  REQUIRE(saveDocument(*posed, file, {}));
  const test::VerbAnswer json = test::runVerb({"info", file.string(), "--json"});
  REQUIRE(json.exitCode == 0);
  const Json adjustments = Json::parse(json.output)["adjustments"];
  REQUIRE(adjustments.size() == 1);
  CHECK(adjustments[0]["controller"] == "hips");
  REQUIRE(adjustments[0]["keys"].size() == 1);
  CHECK(adjustments[0]["keys"][0]["frame"] == 12.0);
  CHECK(adjustments[0]["range"] == Json::array({4.0, 20.0}));
}
