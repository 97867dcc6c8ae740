// Axes about which fingers close, on hands that are made of points.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/rotation.h"
#include "rig/adjust/hand_curl.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// A wrist at a place of the world, and fingers that are added to it.
struct Hand {
  Scene scene;
  BindPlaces places;
  Limb arm;

  explicit Hand(const Vec3& wrist = Vec3(0.0)) {
    static_cast<LimbPlace&>(arm) = biped::leftArm;
    const NodeIndex elbow = addJoint("elbow", NodeIndex::none, wrist - Vec3(1.0, 0.0, 0.0), true);
    arm.joints = {elbow};
    arm.endNode = addJoint("wrist", elbow, wrist, true);
  }

  NodeIndex addJoint(const std::string& name, NodeIndex parent, const Vec3& place, bool hasMesh,
                     const Quat& turn = Quat(1, 0, 0, 0)) {
    const NodeIndex node = addNode(scene, name, parent, Vec3(0.0));
    Transform world;
    world.translation = place;
    world.rotation = turn;
    places.worlds.push_back(toMatrix(world));
    places.meshes.emplace_back();
    if (hasMesh) {
      places.meshes.back().add(place - Vec3(0.01));
      places.meshes.back().add(place + Vec3(0.01));
    }
    return node;
  }

  /// Joints at these places, each with a mesh unless the last is a tip.
  std::vector<NodeIndex> addFinger(const std::string& name, const std::vector<Vec3>& points,
                                   bool hasTip = true) {
    std::vector<NodeIndex> joints;
    NodeIndex parent = arm.endNode;
    for (std::size_t i = 0; i < points.size(); ++i) {
      parent = addJoint(name + std::to_string(i), parent, points[i], !hasTip || i + 1 < points.size());
      joints.push_back(parent);
    }
    return joints;
  }

  [[nodiscard]] std::vector<FingerJoint> curl() const { return handCurl(scene, arm, places); }

  [[nodiscard]] Vec3 axisOf(NodeIndex node) const {
    for (const FingerJoint& joint : curl()) {
      if (joint.node == node) {
        return joint.axis;
      }
    }
    return Vec3(0.0);
  }
  [[nodiscard]] double degreesOf(NodeIndex node) const {
    for (const FingerJoint& joint : curl()) {
      if (joint.node == node) {
        return joint.fistRadians * 180.0 / pi;
      }
    }
    return 0.0;
  }
};

/// Points from a knuckle on in steps of a tenth, each turned from the one before by an angle about an axis.
std::vector<Vec3> bentFinger(const Vec3& knuckle, const Vec3& direction, const Vec3& axis, double radians,
                             std::size_t bones = 3) {
  std::vector<Vec3> points{knuckle};
  Vec3 bone = 0.1 * direction;
  for (std::size_t i = 0; i < bones; ++i) {
    points.push_back(points.back() + bone);
    bone = axisAngle(axis, radians) * bone;
  }
  return points;
}

const Vec3 xAxis(1, 0, 0);
const Vec3 yAxis(0, 1, 0);
const Vec3 zAxis(0, 0, 1);

std::vector<Vec3> straightFinger(const Vec3& knuckle, const Vec3& direction = xAxis) {
  return bentFinger(knuckle, direction, zAxis, 0.0);
}

void checkAxis(const Vec3& vector, const Vec3& wanted) {
  CAPTURE(vector.x, vector.y, vector.z, wanted.x, wanted.y, wanted.z);
  CHECK(glm::length(vector - wanted) < 1e-9);
}

} // namespace

TEST_CASE("straight fingers close downwards about the line across them, in their joints' own space") {
  Hand hand(Vec3(0.4, 1.4, 0.2));
  const Quat turn = axisAngle(glm::normalize(Vec3(1, 2, -1)), 0.8);
  const NodeIndex first = hand.addJoint("index0", hand.arm.endNode, Vec3(0.5, 1.4, 0.2), true, turn);
  const NodeIndex second = hand.addJoint("index1", first, Vec3(0.6, 1.4, 0.2), true);
  checkAxis(hand.axisOf(first), glm::inverse(turn) * -zAxis);
  checkAxis(hand.axisOf(second), -zAxis);
  CHECK(hand.degreesOf(first) == Approx(80.0));
  CHECK(hand.degreesOf(second) == Approx(95.0));
}

TEST_CASE("fingers of a hand that is mirrored close downwards as well") {
  Hand hand;
  const Quat turn = axisAngle(glm::normalize(Vec3(1, 2, -1)), 0.8);
  const NodeIndex first = hand.addJoint("index0", hand.arm.endNode, Vec3(0.1, 0.0, 0.0), true, turn);
  const NodeIndex second = hand.addJoint("index1", first, Vec3(0.2, 0.0, 0.0), true);
  Transform mirror;
  mirror.scale = Vec3(-1.0, 1.0, 1.0);
  for (Mat4& world : hand.places.worlds) {
    world = toMatrix(mirror) * world;
  }
  const Mat4& knuckle = hand.places.worlds[at(first)];
  const Vec3 next = positionOf(hand.places.worlds[at(second)]);
  const Vec3 bent = axisAngle(hand.axisOf(first), 0.5 * pi) * transformPoint(glm::inverse(knuckle), next);
  CHECK(glm::length(transformPoint(knuckle, bent) - Vec3(-0.1, -0.1, 0.0)) < 1e-9);
}

TEST_CASE("fingers that are bent in the bind pose close the way they are bent, upwards too") {
  const double up = GENERATE(1.0, -1.0);
  Hand hand;
  const std::vector<NodeIndex> index =
      hand.addFinger("index", bentFinger(Vec3(0.2, 0, 0.03), xAxis, up * zAxis, 0.3));
  const std::vector<NodeIndex> ring =
      hand.addFinger("ring", bentFinger(Vec3(0.2, 0, -0.03), xAxis, up * zAxis, 0.3));
  for (const NodeIndex joint : {index[0], index[1], index[2], ring[0], ring[2]}) {
    checkAxis(hand.axisOf(joint), up * zAxis);
  }
  CHECK(hand.curl().size() == 6); // Tips do not bend.
}

TEST_CASE("fingers that are hardly bent close downwards whichever way they are bent") {
  // Two bends of a finger: clear for a hand are 0.1 for each of its fingers, for a finger 0.15.
  const auto closesUp = [](double radians) {
    Hand hand;
    hand.addFinger("index", bentFinger(Vec3(0.2, 0, 0.03), xAxis, zAxis, radians));
    const std::vector<NodeIndex> ring =
        hand.addFinger("ring", bentFinger(Vec3(0.2, 0, -0.03), xAxis, zAxis, radians));
    return hand.axisOf(ring[0]).z > 0.0;
  };
  CHECK_FALSE(closesUp(std::asin(0.049)));
  CHECK(closesUp(std::asin(0.051)));
}

TEST_CASE("a clearly bent finger closes in its own plane, a hardly bent one across its bones") {
  const Vec3 tilted = glm::normalize(Vec3(0.0, 0.5, 1.0)); // Of the first finger's bends.
  const auto axisAt = [&](double radians) {
    Hand hand;
    const std::vector<NodeIndex> index =
        hand.addFinger("index", bentFinger(Vec3(0.2, 0, 0.03), xAxis, tilted, radians));
    for (const double side : {-0.03, 0.0}) { // These say where the palm is.
      hand.addFinger("other", bentFinger(Vec3(0.2, 0, side), xAxis, zAxis, 1.0));
    }
    return hand.axisOf(index[0]);
  };
  checkAxis(axisAt(std::asin(0.076)), tilted);                       // Two bends: 0.152.
  CHECK(std::abs(glm::dot(axisAt(std::asin(0.074)), xAxis)) < 1e-9); // Across its first bone,
  CHECK(glm::dot(axisAt(std::asin(0.074)), tilted) < 0.999);         // and not about its own axis.
}

TEST_CASE("a finger that is bent the other way closes with the others") {
  Hand hand;
  for (const double side : {-0.03, 0.0, 0.03}) {
    hand.addFinger("other", bentFinger(Vec3(0.2, 0, side), xAxis, zAxis, 0.5));
  }
  const std::vector<NodeIndex> odd =
      hand.addFinger("odd", bentFinger(Vec3(0.2, 0, 0.06), xAxis, -zAxis, 0.3));
  CHECK(hand.axisOf(odd[0]).z > 0.9);
  CHECK(hand.axisOf(odd[2]).z > 0.9);
}

TEST_CASE("fingers that hang down close towards the thumb, and without one not at all") {
  const double side = GENERATE(1.0, -1.0);
  Hand hand;
  const std::vector<NodeIndex> index = hand.addFinger("index", straightFinger(Vec3(0.03, -0.2, 0), -yAxis));
  const std::vector<NodeIndex> ring = hand.addFinger("ring", straightFinger(Vec3(-0.03, -0.2, 0), -yAxis));
  CHECK(hand.curl().empty());
  hand.addFinger("Left_THUMB",
                 straightFinger(Vec3(0.0, -0.05, 0.03 * side), glm::normalize(Vec3(0, -1, side))));
  checkAxis(hand.axisOf(index[0]), -side * xAxis); // Downwards goes towards z about -x.
  checkAxis(hand.axisOf(ring[2]), -side * xAxis);
}

TEST_CASE("a thumb closes by half over the middle of the palm") {
  Hand hand;
  const Vec3 knuckle(0.05, -0.01, 0.06);
  const Vec3 bone = 0.1 * glm::normalize(Vec3(1, 0, 1));
  const std::vector<NodeIndex> thumb =
      hand.addFinger("thumb", {knuckle, knuckle + bone, knuckle + 2.0 * bone, knuckle + 3.0 * bone});
  const std::vector<NodeIndex> index = hand.addFinger("index", straightFinger(Vec3(0.2, 0, 0.03)));
  hand.addFinger("ring", straightFinger(Vec3(0.2, 0, -0.03)));
  const Vec3 middle = (knuckle + Vec3(0.2, 0, 0.03) + Vec3(0.2, 0, -0.03)) / 3.0;
  const Vec3 towards = middle - knuckle + 0.3 * 0.1 * -yAxis;
  for (const NodeIndex joint : {thumb[0], thumb[1], thumb[2]}) {
    checkAxis(hand.axisOf(joint), glm::normalize(glm::cross(bone, towards)));
  }
  CHECK(hand.degreesOf(thumb[0]) == Approx(40.0));
  CHECK(hand.degreesOf(thumb[1]) == Approx(47.5));
  CHECK(hand.degreesOf(thumb[2]) == Approx(30.0));
  CHECK(hand.degreesOf(index[2]) == Approx(60.0));
}

TEST_CASE("a thumb says nothing of the side to which fingers close that are not along it") {
  Hand hand; // Its own strong bend is none of the fingers'.
  hand.addFinger("thumb", bentFinger(Vec3(0.05, 0, 0.06), glm::normalize(Vec3(1, 0, 1)), zAxis, 1.2));
  const std::vector<NodeIndex> index = hand.addFinger("index", straightFinger(Vec3(0.2, 0, 0.0)));
  checkAxis(hand.axisOf(index[0]), -zAxis);
}

TEST_CASE("joints of the palm do not bend: named ones, and those before the last three") {
  const auto degrees = [](const std::string& first, std::size_t bones) {
    Hand hand;
    std::vector<Vec3> points = bentFinger(Vec3(0.2, 0, 0), xAxis, zAxis, 0.0, bones);
    std::vector<NodeIndex> joints;
    NodeIndex parent = hand.arm.endNode;
    for (std::size_t i = 0; i < bones; ++i) {
      parent = hand.addJoint(i == 0 ? first : "joint", parent, points[i], true);
      joints.push_back(parent);
    }
    std::vector<int> all(joints.size());
    std::ranges::transform(joints, all.begin(), [&](NodeIndex joint) {
      return static_cast<int>(std::lround(hand.degreesOf(joint)));
    });
    return all;
  };
  using Degrees = std::vector<int>;
  CHECK(degrees("index", 3) == Degrees{80, 95, 60});
  CHECK(degrees("index", 2) == Degrees{80, 95});
  CHECK(degrees("index", 4) == Degrees{0, 80, 95, 60});
  CHECK(degrees("index", 5) == Degrees{0, 0, 80, 95, 60});
  CHECK(degrees("hand_PALM.01", 3) == Degrees{0, 80, 95});
  CHECK(degrees("LeftMetacarpal", 2) == Degrees{0, 80});
  CHECK(degrees("palm", 4) == Degrees{0, 80, 95, 60});
  CHECK(degrees("palm", 5) == Degrees{0, 0, 80, 95, 60});
}

TEST_CASE("a finger of one joint reaches to the middle of its mesh, and without a mesh it does not bend") {
  Hand hand;
  const std::vector<NodeIndex> stump = hand.addFinger(GENERATE("stump", "palm"), {Vec3(0.2, 0, 0)}, false);
  const bool hasMesh = GENERATE(true, false);
  hand.places.meshes[at(stump[0])] = {};
  if (hasMesh) {
    hand.places.meshes[at(stump[0])].add(Vec3(0.2, 0.0, 0.0));
    hand.places.meshes[at(stump[0])].add(Vec3(0.3, 0.0, 0.1)); // Its middle lies in the direction (1, 0, 1).
  }
  checkAxis(hand.axisOf(stump[0]), hasMesh ? glm::normalize(glm::cross(Vec3(1, 0, 1), -yAxis)) : Vec3(0.0));
  CHECK(hand.curl().size() == (hasMesh ? 1U : 0U));
}

TEST_CASE("the last bone of a finger is its tip's, or as long as the one before") {
  const bool hasTip = GENERATE(true, false);
  Hand hand;
  const Vec3 knuckle(0.2, 0, 0);
  const Vec3 last(0.4, 0, 0.005); // Too little of a bend to say where the palm is.
  const std::vector<NodeIndex> index = hand.addFinger("index", {knuckle, Vec3(0.3, 0, 0), last}, hasTip);
  CHECK(hand.curl().size() == (hasTip ? 2U : 3U));
  const Vec3 along = glm::normalize(Vec3(0.1, 0, 0.005));
  checkAxis(hand.axisOf(index[1]), glm::cross(along, -yAxis));
  checkAxis(hand.axisOf(index[2]), hasTip ? Vec3(0.0) : glm::cross(along, -yAxis));
}
