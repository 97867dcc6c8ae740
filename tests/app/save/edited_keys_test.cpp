#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/retime.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/files/save.h"
#include "app/files/saved_work.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

namespace fs = std::filesystem;

constexpr const char* editedDummyPath = STRETCH_SOURCE_DIR "/assets/dummy.glb";

template <typename Value>
Value valueOrFail(const Result<Value>& result) {
  INFO((result ? std::string() : result.error().line()));
  REQUIRE(result);
  return *result;
}

Document openedForKeys(const fs::path& path) {
  return valueOrFail(openDocument(path));
}

// A track of the left arm with some keys.
KeyRow armRow(const Document& document) {
  const rig::Limb* const arm = findLimb(document, "left-arm");
  REQUIRE(arm != nullptr);
  KeyRow row{arm->joints[1], Channel::rotation, {}};
  REQUIRE(keyFramesOf(document, 0, row).size() > 4);
  return row;
}

Document withMovedKey(const Document& document) {
  const EditedKeys moved = valueOrFail(moveKeys(document, 0, {{armRow(document), {{2, 1U}}}}, {0.25, 20.0}));
  return moved.document;
}

Json channelsOf(const Document& document) {
  return (*document.source->json)["animations"][0]["channels"];
}

} // namespace

TEST_CASE("One moved key changes one channel of the saved file, and all others are the source's", "[keys]") {
  const test::TemporaryFolder folder;
  const Document source = openedForKeys(editedDummyPath);
  const Document edited = withMovedKey(source);
  REQUIRE(saveDocument(edited, folder.path() / "clean.glb", {.clean = true}));
  const Document saved = openedForKeys(folder.path() / "clean.glb");
  const Json before = channelsOf(source);
  const Json after = channelsOf(saved);
  REQUIRE(after.size() == before.size());
  int changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    changed += after[i] == before[i] ? 0 : 1;
  }
  CHECK(changed == 1);
  const Clip& clip = clipOf(saved, 0);
  const KeyRow row = armRow(source);
  for (std::size_t i = 0; i < clip.tracks.size(); ++i) {
    const bool isEdited = clip.tracks[i]->node == row.node && clip.tracks[i]->channel == row.channel;
    CHECK((*clip.tracks[i] == *clipOf(source, 0).tracks[i]) != isEdited);
    CHECK((clip.tracks[i]->interpolation == clipOf(source, 0).tracks[i]->interpolation));
    CHECK(clip.tracks[i]->values == clipOf(edited, 0).tracks[i]->values);
    CHECK(clip.tracks[i]->times == clipOf(edited, 0).tracks[i]->times);
  }
  CHECK(clip.framesPerSecond == clipOf(source, 0).framesPerSecond);
}

TEST_CASE("Edited keys come back with the file, and restored they leave the source's bytes", "[keys]") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "edited.glb";
  const Document edited = withMovedKey(openedForKeys(editedDummyPath));
  REQUIRE(saveDocument(edited, path, {}));
  const Document again = openedForKeys(path);
  CHECK(again.warnings == edited.warnings);
  CHECK(*again.clips == *edited.clips);
  CHECK(editedTracks(again, 0) == editedTracks(edited, 0));
  const Document restored = restoreAllTracks(again);
  CHECK_FALSE(hasEditedKeys(restored));
  REQUIRE(saveDocument(restored, folder.path() / "restored.glb", {}));
  CHECK(*readFile(folder.path() / "restored.glb") == *readFile(editedDummyPath));
}

TEST_CASE("Every kind of edit of the clip's keys comes back", "[keys]") {
  const Document start = openedForKeys(editedDummyPath);
  const KeyRow row = armRow(start);
  const std::vector<KeyRow> rows{row};
  const Document curved =
      valueOrFail(setKeyKind(start, 0, {{row, {{3}}}}, rig::KeyInterpolation::flat)).document;
  const Document inserted = valueOrFail(insertKeys(start, 0, rows, 3.37)).document;
  const Document slower = valueOrFail(retimed(start, 0, {4.0, 9.0, 8.5}));
  const KeyRow rootScale{NodeIndex(0), Channel::scale, {}};
  const Document added = valueOrFail(insertKeys(start, 0, std::vector<KeyRow>{rootScale}, 3.0)).document;
  for (const Document& edited : {curved, inserted, slower, added}) {
    Document restored = openedForKeys(editedDummyPath);
    REQUIRE(restoreWork(workOf(edited), restored));
    CHECK(*restored.clips == *edited.clips);
    CHECK(sameDocument(withoutWork(edited), start));
    CHECK(*withoutWork(edited).clips == *start.clips);
  }
}

TEST_CASE("Auto keys come back with the file and follow their neighbours as before", "[keys]") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "auto.glb";
  const Document start = openedForKeys(editedDummyPath);
  const KeyRow row = armRow(start);
  const Document curved =
      valueOrFail(setKeyKind(start, 0, {{row, {{2}, {3, 1U}}}}, rig::KeyInterpolation::automatic)).document;
  REQUIRE(curved.followingKeys.size() == 1);
  REQUIRE(saveDocument(curved, path, {}));
  const Document again = openedForKeys(path);
  CHECK(again.followingKeys == curved.followingKeys);
  const auto moved = [&](const Document& document) {
    return *valueOrFail(moveKeys(document, 0, {{row, {{4, 1U}}}}, {0.0, 25.0})).document.clips;
  };
  CHECK(moved(again) == moved(curved));
  Json broken = workOf(curved);
  broken["auto_keys"][0]["path"] = "weights";
  Document restored = openedForKeys(editedDummyPath);
  CHECK_THAT(test::refusal(restoreWork(broken, restored)), Catch::Contains("auto_keys"));
  Json elsewhere = workOf(curved);
  elsewhere["auto_keys"][0]["keys"] = {{123.0, 7}};
  restored = openedForKeys(editedDummyPath);
  REQUIRE(restoreWork(elsewhere, restored));
  CHECK(restored.followingKeys.empty());
}

TEST_CASE("What stands past the end of a shortened clip comes back with the file", "[keys]") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "short.glb";
  Document start = openedForKeys(editedDummyPath);
  rig::Adjustment adjustment;
  adjustment.controller = "left-hand";
  adjustment.rangeFrames = Vec2(50.0, 58.0);
  adjustment.keys = {{.frame = 54.0, .move = Vec3(0.1, 0.0, 0.0)}};
  start = valueOrFail(placeAdjustments(start, {&adjustment, 1}));
  rig::Holds pin;
  pin.pins.push_back(
      {.limb = "right-leg", .time = {{52.0, 57.0}, {2.0, 2.0}}, .atFrame = 53.0, .place = std::nullopt});
  start = valueOrFail(placeHolds(start, pin));
  Document cut = start;
  for (const KeyRow& row : keyedRows(start, 0)) {
    const KeySelection late = row.isOffset() ? KeySelection{} : keysBetween(cut, 0, {&row, 1}, 45.0, 1000.0);
    cut = late.empty() ? cut : valueOrFail(removeKeys(cut, 0, late)).document;
  }
  REQUIRE(saveDocument(cut, path, {}));
  const Document again = openedForKeys(path);
  CHECK(again.warnings == start.warnings);
  CHECK(again.adjustments == start.adjustments);
  CHECK(again.holds == start.holds);
}

TEST_CASE("Kept keys that make no sense are refused", "[keys]") {
  const Document start = test::boxer();
  const KeyRow row{NodeIndex(3), Channel::rotation, {}};
  const Document edited = valueOrFail(moveKeys(start, 0, {{row, {{1}}}}, {1.0, 0.0})).document;
  const Json work = workOf(edited);
  const auto isRefused = [&](const char* key, const Json& value) {
    Json broken = work;
    broken["clip_keys"][0][key] = value;
    Document restored = test::boxer();
    const bool refused = !restoreWork(broken, restored);
    CHECK(sameDocument(restored, restored));
    return refused;
  };
  CHECK(isRefused("clip", 7));
  CHECK(isRefused("clip", -1));
  CHECK(isRefused("node", 700));
  CHECK(isRefused("path", "weights"));
  CHECK(isRefused("interpolation", "SMOOTH"));
  CHECK(isRefused("times", {0.0, 0.5, 0.4, 0.6}));
  CHECK(isRefused("times", {-1.0, 0.1, 0.4, 0.6}));
  CHECK(isRefused("times", {0.0, 0.1, 0.4, 1e300}));
  CHECK(isRefused("values", {1.0, 0.0}));
  CHECK(isRefused("changed", {{9, {0.0, 0.0, 0.0, 1.0}}}));
  CHECK(isRefused("changed", {{1, {0.0, 0.0, 1.0}}}));
  Json twice = work;
  twice["clip_keys"].push_back(twice["clip_keys"][0]);
  Document restored = test::boxer();
  CHECK_THAT(test::refusal(restoreWork(twice, restored)), Catch::Contains("clip_keys"));
}
