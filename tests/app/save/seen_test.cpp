#include <catch2/catch.hpp>

#include "app/edits/trail_edits.h"
#include "app/edits/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "core/gltf/json.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document withTrail(const Document& document, bool connected) {
  NewTrail wanted;
  wanted.limb = "left-arm";
  wanted.settings.endFrame = 10.0;
  wanted.settings.scale = 2.0;
  wanted.exaggerated = true;
  wanted.connected = connected;
  const Result<CreatedTrail> created = createTrail(document, wanted);
  REQUIRE(created);
  return created->document;
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
