// A pose that is mirrored while the character goes another way than it faces in its bind pose.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/pose/pose_edits.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/named.h"
#include "core/math/rotation.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("Body and hips are mirrored by the way that the clip has turned them, all else by the bind pose") {
  // The boxer faces +X from the first frame on, and its left is at -Z.
  const Document start = test::boxer();
  Track hips = test::turnsOf(start, "left-arm");
  hips.node = start.body.hips;
  for (const double frame : {0.0, 20.0}) {
    test::addKey(hips, frame, axisAngle(Vec3(0.0, 1.0, 0.0), 0.5 * pi));
  }
  const Document document = test::withTracks(start, {hips});
  REQUIRE(glm::length(sagittalNormal(document, 0, 5.0) - Vec3(0.0, 0.0, -1.0)) < 1e-6);
  const Vec3 move(0.1, 0.2, 0.3);
  const Vec3 turn(0.4, 0.5, 0.6);
  for (const char* const id : {"body", "hips", "spine-top", "left-hand", "right-elbow"}) {
    CAPTURE(id);
    const std::string name(id);
    const Result<OffsetPose> mirrored = mirroredPose(document, 0, 5.0, {{{name, move, turn}}, {}});
    REQUIRE(mirrored);
    const bool goesAlong = name == "body" || name == "hips";
    const Vec3 across = goesAlong ? Vec3(1.0, 1.0, -1.0) : Vec3(-1.0, 1.0, 1.0);
    CHECK(glm::length(mirrored->offsets.front().move - move * across) < 1e-6);
    CHECK(glm::length(mirrored->offsets.front().turn + turn * across) < 1e-6);
  }
}

TEST_CASE("In world units a controller is neither moved nor turned where it cannot be") {
  const Document document = test::boxer();
  const rig::ControllerList list = controllersOf(document);
  std::size_t still = 0;
  for (const rig::Controller& controller : list.controllers) {
    CAPTURE(controller.id);
    const OffsetPose pose{{{controller.id, Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.5, 0.6)}}, {}};
    const OffsetPose made = inWorldUnits(document, pose);
    REQUIRE(made.offsets.size() == 1);
    const Vec3 move = controller.moves ? controller.length * Vec3(0.1, 0.2, 0.3) : Vec3(0.0);
    CHECK(glm::length(made.offsets[0].move - move) < 1e-12);
    CHECK(made.offsets[0].turn == (controller.turns ? Vec3(0.4, 0.5, 0.6) : Vec3(0.0)));
    still += controller.moves && controller.turns ? 0 : 1;
    CHECK(glm::length(inLengths(document, made).offsets[0].move - move / controller.length) < 1e-12);
  }
  CHECK(still > 1);
  const OffsetPose values{{{"tail-tip", Vec3(1.0), {}}}, {{"left-arm.stretch", 0.3}, {"tail.stretch", 0.5}}};
  CHECK(inWorldUnits(document, values).offsets.empty()); // it has no tail
  CHECK(inWorldUnits(document, values).values == std::vector<AttributeValue>{{"left-arm.stretch", 0.3}});
  CHECK(inLengths(document, values).values == values.values);
}
