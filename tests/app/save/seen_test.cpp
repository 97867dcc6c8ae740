#include <algorithm>
#include <limits>

#include <catch2/catch.hpp>

#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "app/session.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document withTrail(const Document& document, bool connected) {
  return test::withNewTrail(document, {.connected = connected});
}

std::size_t keyedTracks(const Document& document) {
  const gltf::Edits edits = editsOf(document, {}).edits;
  CHECK_FALSE(edits.work.isNull());
  std::size_t count = edits.addedNodes.size();
  for (const gltf::ClipTracks& clip : edits.clips) {
    count += clip.tracks.size();
  }
  return count;
}

} // namespace

TEST_CASE("A trail that the character does not follow is kept in the work, and keyed nowhere") {
  CHECK(keyedTracks(withTrail(test::boxer(), false)) == 0);
  const Document followed = withTrail(test::boxer(), true);
  CHECK(keyedTracks(*applyTrail(followed, followed.trails.front().id)) > 0);
}

TEST_CASE("Weight that is off is kept in the work, and keyed nowhere") {
  for (const bool on : {false, true}) {
    const Result<Document> weighted = setWeight(test::boxer(), {"left-arm", 0, on, {}});
    REQUIRE(weighted);
    CHECK((keyedTracks(*weighted) > 0) == on);
  }
}

TEST_CASE("Saving keys every frame where that is asked for, else as few as it needs") {
  NewTrail slight;
  slight.limb = "left-arm";
  slight.settings.startFrame = 12.0;
  slight.settings.endFrame = 18.0;
  slight.settings.spheres = {{15.0, Vec3(0.0, 3e-4, 0.0)}};
  slight.connected = true;
  const Result<CreatedTrail> created = createTrail(test::boxer(), slight);
  REQUIRE(created);
  const Document followed = *applyTrail(created->document, created->trailId);
  const auto mostKeys = [&](rig::KeyPlaces places) {
    const gltf::Edits edits = editsOf(followed, {.form = {.keys = places}}).edits;
    REQUIRE(edits.clips.size() == 1);
    std::size_t most = 0;
    for (const Track& track : edits.clips.front().tracks) {
      most = std::max(most, track.times.size());
    }
    return most;
  };
  CHECK(mostKeys(rig::KeyPlaces::everyFrame) > mostKeys(rig::KeyPlaces::needed));
}

TEST_CASE(
    "Saving on whole frames alone tells how far the motion is off between them, saving as needed keeps it") {
  const Document punch = test::withNewTrail(test::boxer(), {"left-arm", 0.0, 10.0, 2.5});
  CHECK(editsOf(punch, {}).missOfHeight == 0.0);
  CHECK(editsOf(punch, {.form = {.keys = rig::KeyPlaces::everyFrame}}).missOfHeight == 0.0);
  const SavedEdits whole = editsOf(punch, {.form = {.keys = rig::KeyPlaces::wholeFrames}});
  CHECK(whole.missOfHeight > 0.3e-4);
  CHECK(whole.missOfHeight < 1e-2);
  Session session(test::withNewTrail(test::openedFile(test::posedCharacter), {"left-arm", 21.0, 27.0, 3.0}));
  const test::TemporaryFolder folder;
  const SavedForm form{.keys = rig::KeyPlaces::wholeFrames};
  const Result<double> saved = session.save(folder / "punch.glb", false, form);
  REQUIRE(saved);
  CHECK(*saved > 0.0);
  CHECK(*saved == editsOf(session.document(), {.form = form}).missOfHeight);
  CHECK(*session.save(folder / "punch.glb", false) == 0.0);
}

TEST_CASE("Weights that are no numbers are saved as those that are seen in their place, once for each node "
          "that shows them") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  test::GlbBuilder file = test::armBuilder();
  gltf::Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["WEIGHTS_0"] = file.floats(
      {1, 0, 0, 0, nan, nan, nan, nan, .5F, .5F, 0, 0, .125F, .5F, .25F, .03125F, .5F, .5F, 0, 0, 1, 0, 0, 0},
      "VEC4", 4);
  attributes["JOINTS_1"] = file.accessor(std::vector<std::uint8_t>(24, 2), 5121, "VEC4", 4);
  std::vector<float> further(24, 0.0F);
  further[12] = 0.09375F;
  attributes["WEIGHTS_1"] = file.floats(further, "VEC4", 4);
  const test::TemporaryFolder folder;
  file.write(folder.path() / "arm.glb");
  const Result<Document> opened = openDocument(folder.path() / "arm.glb");
  REQUIRE(opened);
  REQUIRE(saveDocument(*opened, folder.path() / "saved.glb", {.clean = true}));
  const Result<Document> saved = openDocument(folder.path() / "saved.glb");
  INFO((saved ? std::string() : saved.error().line()));
  REQUIRE(saved);
  CHECK(std::ranges::none_of(saved->warnings,
                             [](const std::string& line) { return line.find("weights") != line.npos; }));
  const auto& seen = opened->scene->meshes[0].primitives[0].influences;
  const auto& written = saved->scene->meshes[0].primitives[0].influences;
  REQUIRE(written.size() == seen.size());
  for (const std::size_t vertex : {0, 1, 2, 4, 5}) {
    CHECK(written[vertex].weights == seen[vertex].weights);
    CHECK(written[vertex].weights[0] > 0.0F);
  }
  // Of five influences the four strongest, which sum to 1 again.
  const auto& kept = written[3].weights;
  CHECK(kept[0] == Approx(0.5F / 0.96875F));
  CHECK(kept[3] == Approx(0.09375F / 0.96875F));
  CHECK(kept[4] == 0.0F);
}

TEST_CASE("Saving takes the motion that was worked out for a report, and writes the same") {
  Document document = test::boxer();
  for (const rig::Limb& limb : document.body.limbs) {
    document = *setWeight(document, {limb.id, 0, true, {}});
  }
  EvaluationCache cache;
  REQUIRE_FALSE(cache.weightReports(document, 0).empty());
  const std::shared_ptr<const rig::MotionState> reported = cache.motion(document, 0);
  const SavedEdits saved = editsOf(document, {}, cache);
  CHECK(cache.motion(document, 0) == reported);
  const gltf::Edits alone = editsOf(document, {}).edits;
  REQUIRE(saved.edits.clips.size() == 1);
  CHECK(saved.edits.clips[0].tracks == alone.clips[0].tracks);
}
