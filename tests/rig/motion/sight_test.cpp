#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/motion/best_view.h"
#include "rig/motion/trail_camera.h"
#include "rig/reach/bind_places.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Of the limb at the tip, in the camera's picture: with the trail over the source's.
double seenAtTip(const MovingBiped& moving, const MotionState& motion, const CameraPlace& camera) {
  const SolvedTrail& trail = motion.trails.front();
  const double frame = trail.tipSeconds * moving.clip.framesPerSecond;
  const auto length = [&](const FrameState& at) {
    return seenLength(camera, stayingPosition(trail.limb, at), leadingPosition(trail.limb, at)).value();
  };
  return length(atFrame(moving, motion, frame)) / length(sourceAtFrame(moving, frame));
}

// From three metres away, half from the front.
CameraPlace besideTheBody(const MovingBiped& moving) {
  CameraPlace camera = cameraFrom(glm::normalize(Vec3(1.0, 0.3, 1.0)));
  camera.kind = CameraKind::perspective;
  camera.position = -3.0 * moving.body.height * camera.forward;
  return camera;
}

// A camera of the file on a node of its own, which the clip carries round the body.
MovingBiped withCamera(MovingBiped moving) {
  Node node;
  node.name = "Shot";
  node.rest.translation = Vec3(0.0, 1.0, 6.0);
  moving.scene.nodes.push_back(node);
  const NodeIndex shot(moving.scene.nodes.size() - 1);
  moving.scene.roots.push_back(shot);
  moving.scene.cameras.push_back({"Shot", shot, CameraKind::perspective, 0.6, 1.0, {}});
  const Quat aside = axisAngle(Vec3(0.0, 1.0, 0.0), 0.5 * pi);
  moving.clip.tracks.emplace_back(
      rotationTrack(shot, Interpolation::linear, {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {0.5, aside}}));
  moving.clip.tracks.emplace_back(vectorTrack(shot, Channel::translation, Interpolation::linear,
                                              {{0.0, Vec3(0.0, 1.0, 6.0)}, {0.5, Vec3(6.0, 1.0, 0.0)}}));
  return moving;
}

} // namespace

TEST_CASE("as seen: at the tip the limb looks as many times as long as the scale says, in every space") {
  const MovingBiped moving = punchingBiped();
  const CameraPlace camera = besideTheBody(moving);
  for (const std::string limb : {"left-arm", "left-leg"}) {
    for (const bool keepDepth : {true, false}) {
      for (const double scale : {1.5, 2.0}) {
        for (const TrailSpace space :
             {TrailSpace::world, TrailSpace::root, TrailSpace::base, TrailSpace::view}) {
          for (const Pivot pivot : {Pivot::start, Pivot::end}) {
            CAPTURE(limb, keepDepth, scale, static_cast<int>(space), static_cast<int>(pivot));
            Trail trail = connectedTrail(limb, 6, 12, scale);
            trail.settings.space = space;
            trail.settings.viewAxes = Mat3(Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(1, 0, 0));
            trail.settings.pivot = pivot;
            trail.settings.sight = {true, keepDepth, "", 0.0, camera};
            const MotionState motion = solved(moving, {trail});
            if (motion.trails.front().tip.reached()) {
              CHECK(seenAtTip(moving, motion, camera) == Approx(scale).epsilon(1e-4));
            } else {
              CHECK_FALSE(motion.trails.front().warnings.empty());
            }
          }
        }
      }
    }
  }
}

TEST_CASE("as seen: the reference rest counts in the rest length") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.sight = {true, true, "", 0.0, cameraFrom(Vec3(1.0, 0.0, 0.0))};
  trail.settings.reference = Reference::rest;
  const MotionState motion = solved(moving, {trail});
  const double inPose = lengthOf(moving.limb("left-arm"), sourceAtFrame(moving, 12.0));
  REQUIRE(motion.trails.front().tip.reached());
  CHECK(seenAtTip(moving, motion, *motion.trails.front().camera) ==
        Approx(2.0 * moving.limb("left-arm").restLength / inPose).epsilon(1e-4));
}

TEST_CASE("the file's camera judges a trail from where it stands at the tip, carried by the clip") {
  const MovingBiped moving = withCamera(punchingBiped());
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.sight.camera = "Shot";
  trail.settings.sight.asSeen = true;
  const MotionState motion = solved(moving, {trail});
  const SolvedTrail& punch = motion.trails.front();
  REQUIRE(punch.camera);
  CHECK(glm::length(punch.camera->position - Vec3(6.0, 1.0, 0.0)) < 1e-9);
  CHECK(glm::length(punch.camera->forward - Vec3(-1.0, 0.0, 0.0)) < 1e-9);
  REQUIRE(punch.tip.reached());
  CHECK(seenAtTip(moving, motion, *punch.camera) == Approx(2.0).epsilon(1e-4));
  trail.settings.pivot = Pivot::end; // the tip is the first frame: the camera is half way there
  const Vec3 halfWay = solved(moving, {trail}).trails.front().camera->position;
  CHECK(glm::length(halfWay - Vec3(3.0, 1.0, 3.0)) < 1e-9);
}

TEST_CASE("a camera that is not there is told, and the scale counts in the limb's own length") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.sight.camera = "Lost";
  trail.settings.sight.asSeen = true;
  const MotionState motion = solved(moving, {trail});
  REQUIRE(motion.trails.front().warnings.size() == 1);
  CHECK_THAT(motion.trails.front().warnings.front(), Catch::Contains("'Lost'"));
  const Limb& arm = moving.limb("left-arm");
  CHECK(lengthOf(arm, atFrame(moving, motion, 12.0)) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12.0))).epsilon(1e-4));
}

TEST_CASE("a view that a trail keeps judges it where no camera is named, and not in place of a lost one") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.sight.asSeen = true;
  trail.settings.sight.view = cameraFrom(Vec3(1.0, 0.0, 0.0));
  CHECK((solved(moving, {trail}).trails.front().camera == trail.settings.sight.view));
  trail.settings.sight.camera = "Lost";
  const MotionState motion = solved(moving, {trail});
  CHECK_FALSE(motion.trails.front().camera.has_value());
  REQUIRE(motion.trails.front().warnings.size() == 1);
  CHECK_THAT(motion.trails.front().warnings.front(), Catch::Contains("'Lost'"));
}

TEST_CASE("turned to the view, the limb is as long as the scale says and more of it is seen") {
  const MovingBiped moving = punchingBiped();
  const CameraPlace front = cameraFrom(Vec3(0.3, 0.0, 1.0));
  Trail trail = connectedTrail("left-arm", 6, 12, 2.0);
  trail.settings.sight.view = front;
  const double straight = seenAtTip(moving, solved(moving, {trail}), front);
  trail.settings.sight.turnDegrees = 25.0;
  const MotionState turned = solved(moving, {trail});
  CHECK(seenAtTip(moving, turned, front) > 1.1 * straight);
  const Limb& arm = moving.limb("left-arm");
  CHECK(lengthOf(arm, atFrame(moving, turned, 12.0)) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12.0))).epsilon(1e-4));
  CHECK(largestNodeMiss(atFrame(moving, turned, 6.0), sourceAtFrame(moving, 6.0)) < 1e-9);
}

TEST_CASE("standard views stand where the character faces in the clip") {
  MovingBiped moving = punchingBiped();
  const BindPlaces places = bindPlaces(moving.scene);
  const auto facing = [&] {
    return facingInClip(moving.scene, moving.clip, moving.body.hips, moving.body.limbs, places);
  };
  CHECK(facing() == Vec3(0.0, 0.0, 1.0));
  CHECK(glm::length(standardView("front", facing()).forward - Vec3(0.0, 0.0, -1.0)) < 1e-12);
  CHECK(glm::length(standardView("side", facing()).forward - Vec3(-1.0, 0.0, 0.0)) < 1e-12); // from its left
  CHECK(glm::length(standardView("top", facing()).forward - Vec3(0.0, -1.0, 0.0)) < 1e-12);
  const Vec3 quarter = standardView("three-quarter", facing()).forward;
  CHECK((quarter.x < -0.4 && quarter.y < -0.1 && quarter.z < -0.7));
  for (const std::string_view name : standardViews) {
    const CameraPlace view = standardView(std::string(name), Vec3(1.0, 0.0, 0.0));
    CHECK(isStandardView(std::string(name)));
    CHECK(glm::length(glm::cross(view.right, view.up) + view.forward) < 1e-12);
  }
  CHECK_FALSE(isStandardView("Shot"));
  moving.clip.tracks.emplace_back(
      rotationTrack(moving.body.hips, Interpolation::linear,
                    {{0.0, axisAngle(Vec3(0.0, 1.0, 0.0), -0.4 * pi)}, {1.0, Quat(1.0, 0.0, 0.0, 0.0)}}));
  CHECK(facing() == Vec3(-1.0, 0.0, 0.0));
}

TEST_CASE("what is seen as well from every height is looked at from five degrees above") {
  SightedAction swing;
  swing.path = {Vec3(-1.0, 1.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(1.0, 1.0, 0.0)};
  swing.base = Vec3(-0.5, 1.0, 0.0);
  swing.tip = Vec3(1.0, 1.0, 0.0);
  const Vec3 eye = bestView(swing);
  CHECK(eye.y == Approx(std::sin(5.0 * pi / 180.0)));
  CHECK(eye.x == Approx(0.0).margin(1e-9));
}

TEST_CASE("the best view shows path and limb across, the face, and no trunk in the way") {
  SightedAction punch;
  for (int i = 0; i <= 8; ++i) {
    punch.path.emplace_back(0.3, 1.4, 0.2 + 0.1 * i);
  }
  punch.base = Vec3(0.25, 1.4, 0.0);
  punch.tip = punch.path.back();
  punch.trunkLow = Vec3(0.0, 0.9, 0.0);
  punch.trunkHigh = Vec3(0.0, 1.6, 0.0);
  punch.trunkRadius = 0.2;
  punch.facing = Vec3(0.0, 0.0, 1.0);
  const Vec3 eye = bestView(punch);
  CHECK(std::abs(eye.x) > 0.9);         // from the side
  CHECK(eye.z > 0.15);                  // and a little from the front: the face is seen
  CHECK((eye.y > -0.1 && eye.y < 0.3)); // level
  punch.facing = Vec3(0.0, 0.0, -1.0);  // looks back over the shoulder
  CHECK(bestView(punch).z < -0.15);
  punch.facing.reset();
  punch.path = {Vec3(0.25, 1.2, 0.1), Vec3(0.25, 1.2, 0.0), Vec3(0.25, 1.2, -0.1)}; // beside the trunk
  punch.tip = Vec3(0.25, 1.4, 0.4);
  CHECK(bestView(punch).x > 0.8);
  punch.trunkRadius = 0.0;
  punch.path.clear(); // nothing to go by: any answer, a unit
  CHECK(glm::length(bestView(punch)) == Approx(1.0));
}
