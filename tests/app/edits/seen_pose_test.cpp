// Poses that go from one character to another one, from one side to the other and into a library.
#include "app/edits/pose/seen_pose.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/edits/pose/pose_edits.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/named.h"
#include "app/session.h"
#include "core/math/rotation.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::app;
using stretch::test::MovingBiped;
using stretch::test::SyntheticBiped;

namespace {

const Quat quarterTurn = axisAngle(Vec3(0.0, 1.0, 0.0), 0.5 * pi);

/// How a body differs from the usual one.
struct Build {
  double size = 1.0;
  Quat turn{1.0, 0.0, 0.0, 0.0};
  double forearm = 1.0; ///< Length of the left one.
  double ankle = 0.0;   ///< How much higher the ankles stand above the soles.
};

SyntheticBiped bodyOf(const Build& build) {
  SyntheticBiped body = test::namedBody({.toes = false, .fingers = false});
  const Vec3 elbow = jointOf(body, "foreArm.l").position;
  jointOf(body, "hand.l").position = elbow + build.forearm * (jointOf(body, "hand.l").position - elbow);
  for (test::SyntheticJoint& joint : body.joints) {
    joint.position.y += build.ankle;
  }
  body.size = build.size;
  body.turn = build.turn;
  return body;
}

/// The punch of moving_biped.h as such a body does it: as it is seen from the body itself.
Document punching(const Build& build) {
  MovingBiped usual = test::still(bodyOf({}));
  addPunch(usual, Interpolation::linear);
  MovingBiped moving = test::still(bodyOf(build));
  moving.clip = usual.clip;
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    Track turned = *track;
    const auto width = static_cast<std::size_t>(turned.width);
    for (std::size_t i = 0; i < turned.values.size(); i += width) {
      float* const value = &turned.values[i];
      Vec3 vector = build.turn * Vec3(value[0], value[1], value[2]);
      if (turned.channel == Channel::translation) {
        vector *= build.size;
      }
      for (int axis = 0; axis < 3; ++axis) {
        value[axis] = static_cast<float>(vector[axis]);
      }
    }
    track = CopyOnWrite<Track>(std::move(turned));
  }
  const test::TemporaryFolder folder;
  const std::string file = folder / "body.glb";
  test::characterFile(moving.scene, {moving.clip}).write(file);
  return test::openedFile(file);
}

/// A character at a frame of its clip, without changes.
struct Shown {
  explicit Shown(Document opened, double at)
      : session(std::move(opened)), frame(at), placed(session.controllersAt(at)),
        state(evaluateOriginal(session.document(), 0, at / clipOf(session.document(), 0).framesPerSecond)) {}

  [[nodiscard]] SeenMoment moment() const { return {session.document(), 0, frame, placed, state}; }
  [[nodiscard]] Vec3 below() const {
    const auto hips = std::ranges::find(placed, rig::ControllerKind::hips, &rig::PlacedController::kind);
    REQUIRE(hips != placed.end());
    return {hips->placeWorld.x, 0.0, hips->placeWorld.z};
  }
  [[nodiscard]] const rig::PlacedController& of(const std::string& id) const {
    const auto found = std::ranges::find(placed, id, &rig::PlacedController::id);
    REQUIRE(found != placed.end());
    return *found;
  }
  [[nodiscard]] Vec3 baseOf(const std::string& limb) const {
    return positionOf(state.worlds[at(findLimb(session.document(), limb)->joints.front())]);
  }

  Session session;
  double frame;
  std::vector<rig::PlacedController> placed;
  FrameState state;
};

const SeenController& goalOf(const std::vector<SeenController>& goals, const std::string& id) {
  const auto found = std::ranges::find(goals, id, &SeenController::id);
  REQUIRE(found != goals.end());
  return *found;
}

double apart(const Quat& a, const Quat& b) {
  const Quat between = a * glm::inverse(b);
  return 2.0 * glm::length(Vec3(between.x, between.y, between.z));
}

constexpr double punchFrame = 12.0;
constexpr double nearby = 1e-5; // single precision of files
const std::vector<std::string> all;

} // namespace

TEST_CASE("On a character twice as large that faces another way a pose is what that one does itself") {
  const Shown small(punching({}), punchFrame);
  for (const Build& build : {Build{2.0}, Build{1.0, quarterTurn}, Build{0.5, quarterTurn}}) {
    const Shown other(punching(build), punchFrame);
    const SeenPose pose = seenPose(small.moment(), all);
    const std::vector<SeenController> goals = goalsOn(other.moment(), pose, other.below());
    CHECK(goals.size() + 1 == other.placed.size()); // all but the body's
    for (const SeenController& goal : goals) {
      CAPTURE(goal.id, build.size);
      const rig::PlacedController& own = other.of(goal.id);
      CHECK(glm::length(goal.placeWorld - own.placeWorld) < nearby);
      CHECK(apart(goal.turnWorld, own.orientationWorld) < 1e-4);
    }
    // Wherever it is to stand: what hangs on no limb goes along.
    const Vec3 aside(3.0, 0.0, -1.0);
    const std::vector<SeenController> there = goalsOn(other.moment(), pose, other.below() + aside);
    for (const char* const id : {"hips", "left-foot", "right-knee", "left-hand", "head", "left-elbow"}) {
      const bool hangs = goalOf(goals, id).fromBase.has_value();
      CHECK(glm::length(goalOf(there, id).placeWorld - goalOf(goals, id).placeWorld -
                        (hangs ? Vec3(0.0) : aside)) < 1e-9);
      CHECK(hangs == (std::string(id) != "hips" && std::string(id) != "left-foot"));
    }
  }
}

TEST_CASE("Hands and poles of a pose are so many lengths of their arm from its base, turned with the body") {
  const Shown small(punching({}), punchFrame);
  const Shown longer(punching({1.0, quarterTurn, 1.8}), 0.0); // its arms hang otherwise there
  const std::vector<SeenController> goals =
      goalsOn(longer.moment(), seenPose(small.moment(), all), longer.below());
  const rig::ControllerList list = controllersOf(small.session.document());
  const rig::ControllerList others = controllersOf(longer.session.document());
  REQUIRE(others.controller("left-hand")->length > 1.3 * list.controller("left-hand")->length);
  for (const char* const id : {"left-hand", "left-elbow", "right-hand", "right-elbow", "left-knee", "head"}) {
    CAPTURE(id);
    const std::string limb = list.controller(id)->limb;
    const double share = others.controller(id)->length / list.controller(id)->length;
    const Vec3 wanted =
        longer.baseOf(limb) + quarterTurn * (small.of(id).placeWorld - small.baseOf(limb)) * share;
    CHECK(glm::length(goalOf(goals, id).placeWorld - wanted) < nearby);
  }
}

TEST_CASE("Feet and hips of a pose are as far above where they rest, by the length of the legs") {
  const Shown small(punching({}), punchFrame);
  const Shown high(punching({1.0, {1.0, 0.0, 0.0, 0.0}, 1.0, 0.07}), punchFrame);
  const SeenPose pose = seenPose(small.moment(), all);
  const std::vector<SeenController> goals = goalsOn(high.moment(), pose, high.below());
  const Shown smallRest(punching({}), 0.0);
  for (const char* const id : {"left-foot", "right-foot", "hips"}) {
    CAPTURE(id);
    const SeenController& seen = goalOf(pose.controllers, id);
    REQUIRE(seen.restHeight);
    CHECK_FALSE(seen.fromBase);
    const double rest = *goalOf(seenPose(high.moment(), all).controllers, id).restHeight;
    const double scale = controllersOf(high.session.document()).controller("hips")->length /
                         controllersOf(small.session.document()).controller("hips")->length;
    CHECK(goalOf(goals, id).placeWorld.y ==
          Approx(rest + scale * (seen.placeWorld.y - *seen.restHeight)).margin(nearby));
  }
  // Above the soles, wherever these are.
  CHECK(*goalOf(pose.controllers, "left-foot").restHeight ==
        Approx(*goalOf(pose.controllers, "right-foot").restHeight).margin(1e-6));
  for (const char* const id : {"left-hand", "head", "left-knee"}) {
    CHECK_FALSE(goalOf(pose.controllers, id).restHeight);
  }
}

TEST_CASE("A pose from a library comes to each character as it does from the one that it was seen on") {
  const Shown seen(punching({1.5, quarterTurn}), punchFrame);
  const SeenPose pose = seenPose(seen.moment(), all);
  const SeenPose kept = standardised(pose);
  CHECK(kept.of == nullptr);
  CHECK(kept.legLength == 1.0);
  CHECK(kept.standingWorld == Vec3(0.0));
  CHECK(glm::length(kept.leftWorld - Vec3(1.0, 0.0, 0.0)) < 1e-9);
  for (const Build& build : {Build{}, Build{0.7, glm::inverse(quarterTurn), 1.5, 0.05}}) {
    const Shown other(punching(build), 6.0);
    const std::vector<SeenController> straight = goalsOn(other.moment(), pose, other.below());
    const std::vector<SeenController> fromLibrary = goalsOn(other.moment(), kept, other.below());
    REQUIRE(straight.size() == fromLibrary.size());
    for (std::size_t i = 0; i < straight.size(); ++i) {
      CAPTURE(straight[i].id);
      CHECK(fromLibrary[i].id == straight[i].id);
      CHECK(glm::length(fromLibrary[i].placeWorld - straight[i].placeWorld) < 1e-9);
      CHECK(apart(fromLibrary[i].turnWorld, straight[i].turnWorld) < 1e-7);
    }
    // Mirrored in the library or before it came there.
    const std::vector<SeenController> before =
        goalsOn(other.moment(), standardised(mirroredPose(seen.session.document(), pose)), other.below());
    const std::vector<SeenController> after =
        goalsOn(other.moment(), mirroredPose(seen.session.document(), kept), other.below());
    for (std::size_t i = 0; i < before.size(); ++i) {
      CAPTURE(before[i].id);
      CHECK(glm::length(after[i].placeWorld - before[i].placeWorld) < 1e-9);
      CHECK(apart(after[i].turnWorld, before[i].turnWorld) < 1e-7);
    }
  }
}

TEST_CASE("A pose on the character that it was seen on stays where it was, wherever that is to stand") {
  const Shown seen(punching({}), punchFrame);
  const SeenPose pose = seenPose(seen.moment(), std::vector<std::string>{"left-hand", "body", "left-foot"});
  REQUIRE(pose.controllers.size() == 3);
  for (const SeenController& goal : goalsOn(seen.moment(), pose, Vec3(7.0, 0.0, 7.0))) {
    CHECK(goal.placeWorld == seen.of(goal.id).placeWorld);
    CHECK(goal.turnWorld == seen.of(goal.id).orientationWorld);
  }
  SeenPose more = pose;
  more.controllers.front().id = "tail-tip";
  CHECK(goalsOn(seen.moment(), more, Vec3(0.0)).size() == 2); // it has none
}

TEST_CASE("A mirrored pose stands on the same place with its sides swapped, its values as well") {
  const Shown seen(punching({}), punchFrame);
  const Document& document = seen.session.document();
  SeenPose pose = seenPose(seen.moment(), all);
  pose.values = {{"left-hand.curl", 0.7}, {"right-arm.stretch", 0.2}, {"head.none", 1.0}};
  const SeenPose mirrored = mirroredPose(document, pose);
  REQUIRE(mirrored.controllers.size() == pose.controllers.size());
  const Vec3 normal = pose.leftOnItsWay;
  for (const SeenController& one : pose.controllers) {
    CAPTURE(one.id);
    const SeenController& other = goalOf(mirrored.controllers, otherSideOf(document, one.id));
    const Vec3 from = one.placeWorld - pose.standingWorld;
    const Vec3 to = other.placeWorld - pose.standingWorld;
    CHECK(glm::dot(to, normal) == Approx(-glm::dot(from, normal)).margin(1e-9));
    CHECK(glm::length(glm::cross(to + from, normal)) ==
          Approx(2.0 * glm::length(glm::cross(from, normal))).margin(1e-9));
    REQUIRE(one.fromBase.has_value() == other.fromBase.has_value());
    if (one.fromBase) {
      CHECK(glm::length(*other.fromBase - reflected(*one.fromBase, normal)) < 1e-9);
    }
    CHECK(other.restHeight == one.restHeight);
  }
  if (controllersOf(document).attribute("left-hand.curl") == nullptr) {
    pose.values.front().id = "left-arm.volume";
  }
  const SeenPose again = mirroredPose(document, pose);
  REQUIRE(again.values.size() == 2);
  CHECK(again.values.front() == AttributeValue{otherSideOf(document, pose.values.front().id), 0.7});
  CHECK(again.values.back() == AttributeValue{"left-arm.stretch", 0.2});
  // Back on its side it is what it was.
  const SeenPose back = mirroredPose(document, mirrored);
  for (const SeenController& one : pose.controllers) {
    CAPTURE(one.id);
    CHECK(glm::length(goalOf(back.controllers, one.id).placeWorld - one.placeWorld) < 1e-9);
    CHECK(apart(goalOf(back.controllers, one.id).turnWorld, one.turnWorld) < 1e-6);
  }
}
