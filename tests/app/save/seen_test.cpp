#include <algorithm>

#include <catch2/catch.hpp>

#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document withTrail(const Document& document, bool connected) {
  return test::withNewTrail(document, {.connected = connected});
}

std::size_t keyedTracks(const Document& document) {
  const Result<gltf::Edits> edits = editsOf(document, {});
  REQUIRE(edits);
  CHECK_FALSE(edits->work.isNull());
  std::size_t count = edits->addedNodes.size();
  for (const gltf::ClipTracks& clip : edits->clips) {
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
  const auto mostKeys = [&](bool everyFrame) {
    const Result<gltf::Edits> edits = editsOf(followed, {.keyEveryFrame = everyFrame});
    REQUIRE(edits);
    REQUIRE(edits->clips.size() == 1);
    std::size_t most = 0;
    for (const Track& track : edits->clips.front().tracks) {
      most = std::max(most, track.times.size());
    }
    return most;
  };
  CHECK(mostKeys(true) > mostKeys(false));
}
