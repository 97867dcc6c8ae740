#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/dummy/leap.h"
#include "assets/dummy/props.h"
#include "tests/support/assets/played_clip.h"

using namespace stretch;
using namespace stretch::assets;

namespace {

constexpr double letGo = 44.0; ///< Frame at which the batter's right hand leaves the bat.
constexpr double handSpacing = 0.082;

/// How far the middle of a fist is from its place on the bat.
double offTheBat(const PlayedClip& swing, bool isLeft, double frame) {
  const Vec3 fist = swing.at(isLeft ? "LeftHand" : "RightHand", frame, gloveMiddle(isLeft));
  return glm::length(fist - swing.at("Bat", frame, {0.0, isLeft ? -handSpacing : handSpacing, 0.0}));
}

/// Largest distance of a node from where it is at the first of the frames.
double strays(const PlayedClip& clip, const std::string& node, double firstFrame, double lastFrame) {
  const Vec3 place = clip.at(node, firstFrame);
  double farthest = 0.0;
  for (double frame = firstFrame; frame <= lastFrame; frame += 0.5) {
    farthest = std::max(farthest, glm::length(clip.at(node, frame) - place));
  }
  return farthest;
}

/// To the left, degrees, as the line from the right to the left joint tells it.
double yawOf(const PlayedClip& clip, const std::string& joint, double frame) {
  const Vec3 left = clip.at("Left" + joint, frame) - clip.at("Right" + joint, frame);
  return std::atan2(-left.z, left.x) * 180.0 / pi;
}

struct Box {
  Vec3 low{1e9};
  Vec3 high{-1e9};
};

Box boxOf(const Prop& prop) {
  Box box;
  for (const SkinnedVertex& vertex : prop.part.mesh.vertices) {
    box.low = glm::min(box.low, prop.position + vertex.position);
    box.high = glm::max(box.high, prop.position + vertex.position);
  }
  return box;
}

} // namespace

TEST_CASE("Both fists hold the bat within a hundredth of its length, until the right one lets go") {
  const PlayedClip swing("dummy_swing.glb");
  for (double frame = 0.0; frame <= swing.lastFrame(); frame += 0.5) {
    CAPTURE(frame);
    REQUIRE(offTheBat(swing, true, frame) < 0.01 * batLength);
    if (frame <= letGo) {
      REQUIRE(offTheBat(swing, false, frame) < 0.01 * batLength);
    }
  }
  CHECK(offTheBat(swing, false, 60.0) > 0.3);
}

TEST_CASE("The batter's back foot stays, and the front foot stays after its stride") {
  const PlayedClip swing("dummy_swing.glb");
  CHECK(strays(swing, "RightToeBase", 0.0, swing.lastFrame()) < 0.01);
  CHECK(strays(swing, "LeftToeBase", 0.0, 17.0) < 0.005);
  CHECK(strays(swing, "LeftToeBase", 34.0, swing.lastFrame()) < 0.005);
}

TEST_CASE("The batter's weight goes over the back foot, then forwards, and it never falls over") {
  const PlayedClip swing("dummy_swing.glb");
  CHECK(std::abs(swing.centreOfMass(25.0).x - swing.at("RightToeBase", 25.0).x) < 0.06);
  CHECK(swing.centreOfMass(38.0).x - swing.centreOfMass(25.0).x > 0.3);
  for (const double frame : {0.0, 12.0, 54.0, 88.0}) {
    CAPTURE(frame);
    CHECK(swing.centreOfMass(frame).x > swing.at("RightToeBase", frame).x);
    CHECK(swing.centreOfMass(frame).x < swing.at("LeftToeBase", frame).x);
  }
}

TEST_CASE("In the swing the hips lead the shoulders, the shoulders the hands, and the barrel is fastest at "
          "the ball") {
  const PlayedClip swing("dummy_swing.glb");
  CHECK(yawOf(swing, "UpLeg", 36.0) > yawOf(swing, "Arm", 36.0) + 15.0);
  const auto speed = [&](double frame) {
    const Vec3 tip(0.0, batLength - batGripHeight, 0.0);
    return glm::length(swing.at("Bat", frame + 0.5, tip) - swing.at("Bat", frame - 0.5, tip));
  };
  double fastest = 1.0;
  for (double frame = 1.0; frame < swing.lastFrame(); frame += 0.5) {
    fastest = speed(frame) > speed(fastest) ? frame : fastest;
  }
  CHECK(fastest >= 36.0);
  CHECK(fastest <= 41.0);
}

TEST_CASE("Neither bat nor fist goes through the batter's head, trunk or legs") {
  const PlayedClip swing("dummy_swing.glb");
  for (double frame = 0.0; frame <= swing.lastFrame(); frame += 1.0) {
    CAPTURE(frame);
    const auto onBat = [&](double height) { return swing.at("Bat", frame, {0.0, height, 0.0}); };
    REQUIRE(swing.depthInBody(frame, onBat(-batGripHeight), onBat(0.35), 0.018) < 0.005);
    REQUIRE(swing.depthInBody(frame, onBat(0.35), onBat(batLength - batGripHeight), 0.037) < 0.005);
    for (const bool isLeft : {true, false}) {
      const Vec3 fist = swing.at(isLeft ? "LeftHand" : "RightHand", frame, gloveMiddle(isLeft));
      REQUIRE(swing.depthInBody(frame, fist, fist, gloveRadius) < 0.015);
    }
  }
}

TEST_CASE("In the leap feet and hands stay where they stand") {
  const PlayedClip leap("dummy_leap.glb");
  CHECK(strays(leap, "LeftToeBase", 0.0, 14.0) < 0.005);   // The push into the run.
  CHECK(strays(leap, "RightToeBase", 18.0, 22.0) < 0.005); // Steps.
  CHECK(strays(leap, "LeftToeBase", 25.0, 29.0) < 0.005);
  CHECK(strays(leap, "RightToeBase", 31.0, 35.0) < 0.005); // Take-off.
  CHECK(strays(leap, "LeftToeBase", 33.0, 35.0) < 0.005);
  CHECK(strays(leap, "LeftHand", 46.0, 50.0) < 0.005); // On the ledge.
  CHECK(strays(leap, "RightHand", 46.0, 50.0) < 0.005);
  CHECK(strays(leap, "LeftToeBase", 63.0, 78.0) < 0.005); // Landing, and the step out of it.
  CHECK(strays(leap, "RightToeBase", 63.0, 96.0) < 0.005);
  CHECK(strays(leap, "LeftToeBase", 87.0, 96.0) < 0.005);
}

TEST_CASE("The leaper goes into neither the floor nor a block, and its hands touch the ledge") {
  const PlayedClip leap("dummy_leap.glb");
  const std::vector<Prop> blocks = leapBlocks();
  for (double frame = 0.0; frame <= leap.lastFrame(); frame += 1.0) {
    CAPTURE(frame);
    REQUIRE(leap.lowest(frame).y > -0.01);
    for (const Prop& block : blocks) {
      const Box box = boxOf(block);
      REQUIRE(leap.depthInBox(frame, box.low, box.high) < 0.012);
    }
  }
  const double top = boxOf(blocks[1]).high.y;
  const double fist = leap.at("LeftHand", 48.0, gloveMiddle(true)).y;
  CHECK(fist - top < gloveRadius + 0.03);
}

TEST_CASE("In flight the leaper falls as bodies fall") {
  const PlayedClip leap("dummy_leap.glb");
  const auto fallsAt = [&](double first, double last) {
    const double seconds = 0.5 * (last - first) / leap.clip().framesPerSecond;
    const auto height = [&](double frame) { return leap.at("Hips", frame).y; };
    return (2.0 * height(0.5 * (first + last)) - height(first) - height(last)) / (seconds * seconds);
  };
  CHECK(fallsAt(36.0, 45.0) == Approx(9.8).margin(2.0));
  CHECK(fallsAt(52.0, 62.0) == Approx(9.8).margin(2.0));
}

TEST_CASE("The leaper comes to rest over its feet") {
  const PlayedClip leap("dummy_leap.glb");
  for (const double frame : {0.0, 71.0, 96.0}) {
    CAPTURE(frame);
    const double heel = std::min(leap.at("LeftFoot", frame).z, leap.at("RightFoot", frame).z);
    const double toe = std::max(leap.at("LeftToeBase", frame).z, leap.at("RightToeBase", frame).z) + 0.1;
    CHECK(leap.centreOfMass(frame).z > heel);
    CHECK(leap.centreOfMass(frame).z < toe);
  }
}

TEST_CASE("Nothing pops in the bundled clips: no joint turns by more than 60 degrees in half a frame") {
  for (const char* file : {"dummy.glb", "dummy_swing.glb", "dummy_leap.glb"}) {
    const PlayedClip played(file);
    std::vector<Mat4> before = played.worlds(0.0);
    for (double frame = 0.5; frame <= played.lastFrame(); frame += 0.5) {
      const std::vector<Mat4> now = played.worlds(frame);
      for (std::size_t node = 0; node < now.size(); ++node) {
        const Quat turn = glm::quat_cast(glm::transpose(Mat3(before[node])) * Mat3(now[node]));
        CAPTURE(file, frame, played.scene().nodes[node].name);
        REQUIRE(2.0 * std::acos(std::min(1.0, std::abs(turn.w))) < 60.0 * pi / 180.0);
      }
      before = now;
    }
  }
}
