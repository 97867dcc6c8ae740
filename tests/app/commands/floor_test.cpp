#include <catch2/catch.hpp>

#include "app/commands/exaggerate.h"
#include "app/files/save.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A new trail of a leg stops at the floor that the feet stand on, one of an arm nowhere") {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const Session session(std::move(opened).value());
  const auto stopOf = [&](const char* limb) {
    return newTrailSettings(session, *findLimb(session.document(), limb), {0.0, 10.0}).stopAt;
  };
  REQUIRE(stopOf("left-leg"));
  CHECK(stopOf("left-leg")->normal == Vec3(0.0, -1.0, 0.0));
  CHECK(stopOf("left-leg")->point.y > 0.0); // The ankle, a little above the ground.
  CHECK(stopOf("left-leg")->point.y < 0.1 * session.document().biped.height);
  CHECK(stopOf("right-leg") == stopOf("left-leg"));
  CHECK_FALSE(stopOf("left-arm"));
}
