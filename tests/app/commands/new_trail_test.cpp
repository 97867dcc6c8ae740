#include <catch2/catch.hpp>

#include "app/commands/trail/exaggerate.h"
#include "core/math/rotation.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A new trail keeps the axes of the camera that it was made under") {
  Session session(test::boxer());
  session.view().selection.editTrails().limbs = {"left-arm", "right-arm"};
  session.view().rangeStart = 2.0;
  session.view().rangeEnd = 9.0;
  session.view().cameraAxes = glm::mat3_cast(axisAngle(Vec3(0.0, 1.0, 0.0), 1.2));
  for (const Result<ExaggerateTargets>& made : {newTrails(session, false), exaggerateTargets(session)}) {
    REQUIRE(made);
    REQUIRE(made->trailIds.size() == 2);
    for (const int id : made->trailIds) {
      const rig::TrailSettings& settings = findTrail(made->document, id)->settings;
      CHECK(settings.viewAxes == session.view().cameraAxes);
      CHECK(settings.startFrame == 2.0);
      CHECK(settings.endFrame == 9.0);
    }
  }
}
