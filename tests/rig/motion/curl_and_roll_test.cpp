#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/adjust/foot_roll.h"
#include "rig/adjust/hand_curl.h"
#include "rig/reach/bind_places.h"
#include "tests/support/rig/adjusted_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Finger by finger: what its joints are called, from the palm outwards.
struct NamedFinger {
  std::string key;
  double z = 0.0;
  std::vector<std::string> names;
  bool hasTip = false; ///< The last joint moves no mesh.
};

void addFinger(SyntheticBiped& body, const std::string& side, const NamedFinger& finger) {
  const double sign = side == ".l" ? 1.0 : -1.0;
  std::string parent = "hand" + side;
  for (std::size_t i = 0; i < finger.names.size(); ++i) {
    const std::string key = "f" + finger.key + std::to_string(i) + side;
    const double x = 0.73 + 0.03 * static_cast<double>(i);
    const bool isTip = finger.hasTip && i + 1 == finger.names.size();
    body.joints.push_back({key, parent, Vec3(sign * x, 1.43, finger.z), true, !isTip});
    body.names[key] = finger.names[i] + (side == ".l" ? "_L" : "_R");
    parent = key;
  }
}

MovingBiped withFingers(const std::vector<NamedFinger>& fingers) {
  BodyOptions options;
  options.fingers = false;
  SyntheticBiped body = namedBody(options);
  for (const NamedFinger& finger : fingers) {
    addFinger(body, ".l", finger);
    addFinger(body, ".r", finger);
  }
  return still(body);
}

const std::vector<NamedFinger>& manyFingers() {
  static const std::vector<NamedFinger> fingers{
      {"thumb", 0.05, {"Thumb1", "Thumb2", "Thumb3"}},
      {"plain", 0.03, {"Index1", "Index2", "Index3"}},
      {"tipped", 0.01, {"Middle1", "Middle2", "Middle3", "Middle4"}, true},
      {"four", -0.01, {"Ring0", "Ring1", "Ring2", "Ring3"}},
      {"carpal", -0.03, {"PinkyMetacarpal", "Pinky1", "Pinky2"}},
      {"palm", -0.05, {"Palm4", "Extra1", "Extra2"}},
  };
  return fingers;
}

double turnDegrees(const MovingBiped& moving, const FrameState& a, const FrameState& b,
                   const std::string& key) {
  const NodeIndex node = moving.node.at(key);
  const NodeIndex parent = moving.scene.nodes[at(node)].parent;
  const auto local = [&](const FrameState& frame) {
    return glm::inverse(rotationOf(frame.worlds[at(parent)])) * rotationOf(frame.worlds[at(node)]);
  };
  const Quat turn = glm::inverse(local(a)) * local(b);
  return 2.0 * std::atan2(glm::length(Vec3(turn.x, turn.y, turn.z)), std::abs(turn.w)) * 180.0 / pi;
}

FootRoll rollOf(const MovingBiped& moving, const std::string& leg) {
  const BindPlaces places = bindPlaces(moving.scene);
  const Limb& limb = moving.limb(leg);
  return footRoll(moving.scene, limb, limbTopology(moving.scene, limb, moving.body.limbs, places), places);
}

// The bind pose is the rest pose of these bodies.
Vec3 pointOfFoot(const MovingBiped& moving, const std::string& foot, const Vec3& point) {
  return transformPoint(bindPlaces(moving.scene).worlds[at(moving.node.at(foot))], point);
}

void checkPoint(const Vec3& point, const Vec3& wanted) {
  CAPTURE(point.x, point.y, point.z, wanted.x, wanted.y, wanted.z);
  CHECK(glm::length(point - wanted) < 1e-6);
}

} // namespace

TEST_CASE("a fist turns each finger by 80, 95 and 60 degrees beyond the palm, and the thumb by half") {
  const std::string side = GENERATE(".l", ".r");
  const double curl = GENERATE(1.0, 0.5, -0.2);
  CAPTURE(side, curl);
  const MovingBiped moving = withFingers(manyFingers());
  const std::string hand = side == ".l" ? "left-hand.curl" : "right-hand.curl";
  const FrameState source = sourceAtFrame(moving, 0);
  const FrameState fist = atFrame(moving, adjusted(moving, {valued(hand, curl)}), 0);
  const std::map<std::string, std::vector<double>> wanted{
      {"thumb", {40, 47.5, 30}}, {"plain", {80, 95, 60}}, {"tipped", {80, 95, 60, 0}},
      {"four", {0, 80, 95, 60}}, {"carpal", {0, 80, 95}}, {"palm", {0, 80, 95}},
  };
  for (const auto& [finger, degrees] : wanted) {
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      CAPTURE(finger, i);
      const std::string joint = "f" + finger + std::to_string(i) + side;
      CHECK(turnDegrees(moving, source, fist, joint) == Approx(std::abs(curl) * degrees[i]).margin(1e-5));
      const std::string other = "f" + finger + std::to_string(i) + (side == ".l" ? ".r" : ".l");
      CHECK(turnDegrees(moving, source, fist, other) == Approx(0.0).margin(1e-6));
    }
  }
}

TEST_CASE("fingers close downwards in a T-pose and straighten upwards, and the thumb goes over the palm") {
  const MovingBiped moving = withFingers(manyFingers());
  const FrameState source = sourceAtFrame(moving, 0);
  const auto poseOfCurl = [&](double curl) {
    return atFrame(moving,
                   adjusted(moving, {valued("left-hand.curl", curl), valued("right-hand.curl", curl)}), 0);
  };
  const FrameState fist = poseOfCurl(0.5);
  const FrameState open = poseOfCurl(-0.2);
  for (const std::string side : {".l", ".r"}) {
    const auto place = [&](const FrameState& frame, const std::string& key) {
      return positionOf(frame.worlds[at(moving.node.at(key + side))]);
    };
    for (const char* key : {"fplain2", "ftipped3", "ffour3", "fcarpal2", "fpalm2"}) {
      CAPTURE(key, side);
      CHECK(place(fist, key).y < place(source, key).y - 0.015);
      CHECK(place(open, key).y > place(source, key).y + 0.005);
      CHECK(place(fist, key).z == Approx(place(source, key).z).margin(1e-6)); // in its own plane
    }
    CHECK(place(fist, "fthumb2").z < place(source, "fthumb2").z - 0.01);
    CHECK(place(open, "fthumb2").z > place(source, "fthumb2").z + 0.005);
  }
}

TEST_CASE("both fists of a character that is the same on both sides mirror each other") {
  const MovingBiped moving = withFingers(manyFingers());
  const FrameState fist =
      atFrame(moving, adjusted(moving, {valued("left-hand.curl", 0.8), valued("right-hand.curl", 0.8)}), 0);
  for (const auto& [key, node] : moving.node) {
    if (key.ends_with(".l")) {
      CAPTURE(key);
      const Vec3 left = positionOf(fist.worlds[at(node)]);
      const NodeIndex other = moving.node.at(key.substr(0, key.size() - 1) + "r");
      checkPoint(positionOf(fist.worlds[at(other)]), Vec3(-left.x, left.y, left.z));
    }
  }
}

TEST_CASE("a whole roll lifts the heel by 60 degrees and the toes by 40") {
  const auto [roll, degrees] =
      GENERATE(table<double, double>({{1.0, 60.0}, {0.5, 30.0}, {0.0, 0.0}, {-0.5, -20.0}, {-1.0, -40.0}}));
  CHECK(rollRadians(roll) * 180.0 / pi == Approx(degrees).margin(1e-12));
}

TEST_CASE("a foot rolls about its toe joint and about the back of its sole") {
  const auto [leg, side, x] =
      GENERATE(table<std::string, std::string, double>({{"left-leg", ".l", 0.1}, {"right-leg", ".r", -0.1}}));
  const double size = GENERATE(1.0, 3.0);
  const bool facesBackwards = GENERATE(false, true);
  CAPTURE(leg, size, facesBackwards);
  SyntheticBiped body = namedBody();
  body.size = size;
  body.facesBackwards = facesBackwards;
  const MovingBiped moving = still(body);
  const FootRoll roll = rollOf(moving, leg);
  const double sign = facesBackwards ? -1.0 : 1.0;
  const Vec3 front(sign, 1, sign);
  CHECK(roll.toes == moving.node.at("toe" + side));
  checkPoint(pointOfFoot(moving, "foot" + side, roll.ball), size * front * Vec3(x, 0.02, 0.1));
  checkPoint(pointOfFoot(moving, "foot" + side, roll.heel), size * front * Vec3(x, -0.02, -0.05));
  checkPoint(roll.axis, Vec3(sign, 0, 0));
}

TEST_CASE("a foot without a toe joint rolls about a place at 0.7 of the way to the tip of its mesh") {
  BodyOptions options;
  options.toes = false;
  const MovingBiped moving = still(namedBody(options));
  for (const auto& [leg, side, x] :
       {std::tuple("left-leg", ".l", 0.1), std::tuple("right-leg", ".r", -0.1)}) {
    const FootRoll roll = rollOf(moving, leg);
    const std::string foot = std::string("foot") + side;
    CHECK_FALSE(roll.toes.exists());
    checkPoint(pointOfFoot(moving, foot, roll.ball), Vec3(x, -0.02, -0.03 + 0.7 * 0.15));
    checkPoint(pointOfFoot(moving, foot, roll.heel), Vec3(x, -0.02, -0.05));
    checkPoint(roll.axis, Vec3(1, 0, 0));
  }
}

TEST_CASE("of several joints below a foot the one that reaches farthest over the ground is its toes") {
  const bool heelFirst = GENERATE(true, false);
  SyntheticBiped body = namedBody();
  const SyntheticJoint heel{"heel.l", "foot.l", Vec3(0.1, 0.02, -0.06)};
  const auto toe = std::ranges::find(body.joints, "toe.l", &SyntheticJoint::key);
  body.joints.insert(heelFirst ? toe : std::next(toe), heel);
  const MovingBiped moving = still(body);
  CHECK(rollOf(moving, "left-leg").toes == moving.node.at("toe.l"));
}

TEST_CASE("a foot rolls about its heel where the toes lift, and about its ball where the heel lifts") {
  const auto [leg, attribute, side] = GENERATE(table<std::string, std::string, std::string>(
      {{"left-leg", "left-foot.roll", ".l"}, {"right-leg", "right-foot.roll", ".r"}}));
  const double value = GENERATE(-1.0, -0.4, 0.4, 1.0);
  CAPTURE(leg, value);
  const MovingBiped moving = still(namedBody());
  const FootRoll roll = rollOf(moving, leg);
  const FrameState source = sourceAtFrame(moving, 0);
  const FrameState rolled = atFrame(moving, adjusted(moving, {valued(attribute, value, 0)}), 0);
  const Mat4& before = source.worlds[at(moving.node.at("foot" + side))];
  const Mat4& after = rolled.worlds[at(moving.node.at("foot" + side))];
  const Vec3 center = value > 0.0 ? roll.ball : roll.heel;
  checkPoint(transformPoint(after, center), transformPoint(before, center));
  CHECK(turnDegrees(moving, source, rolled, "toe" + side) ==
        Approx(value > 0.0 ? 60.0 * value : 0.0).margin(1e-5));
  const Quat turn = rotationOf(after) * glm::inverse(rotationOf(before));
  const double angle = 2.0 * std::atan2(turn.x, turn.w) * 180.0 / pi; // about +X: lifts the heel
  CHECK(angle == Approx(value * (value > 0.0 ? 60.0 : 40.0)).margin(1e-5));
}
