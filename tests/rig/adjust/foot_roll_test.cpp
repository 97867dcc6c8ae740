// Points that feet roll about, on feet that are made of points and boxes.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/adjust/foot_roll.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const Vec3 ankle(0.3, 0.1, 0.2);
const Vec3 upright(0, 1, 0);

/// A leg that ends at an ankle, and what is added to it.
struct Foot {
  Scene scene;
  BindPlaces places;
  Limb leg;
  LimbTopology topology;
  Quat turn = axisAngle(glm::normalize(Vec3(1, -2, 3)), 1.1); ///< Of the foot's joint.

  Foot() {
    static_cast<LimbPlace&>(leg) = biped::rightLeg;
    const NodeIndex knee = addJoint("knee", NodeIndex::none, ankle + Vec3(0, 0.4, 0));
    leg.joints = {knee};
    leg.restLength = 1.0;
    leg.endNode = addJoint("foot", knee, ankle, turn);
  }

  NodeIndex addJoint(const std::string& name, NodeIndex parent, const Vec3& place,
                     const Quat& turned = Quat(1, 0, 0, 0)) {
    const NodeIndex node = addNode(scene, name, parent, Vec3(0.0));
    Transform world;
    world.translation = place;
    world.rotation = turned;
    places.worlds.push_back(toMatrix(world));
    places.meshes.emplace_back();
    return node;
  }
  NodeIndex addToe(const Vec3& fromAnkle, const std::string& name = "toe") {
    return addJoint(name, leg.endNode, ankle + fromAnkle);
  }
  void addBox(NodeIndex node, const Vec3& low, const Vec3& high) {
    places.meshes[at(node)].add(ankle + low);
    places.meshes[at(node)].add(ankle + high);
  }

  [[nodiscard]] FootRoll roll() const { return footRoll(scene, leg, topology, places); }
  /// From the ankle, in the world.
  [[nodiscard]] Vec3 seen(const Vec3& point) const {
    return transformPoint(places.worlds[at(leg.endNode)], point) - ankle;
  }
  [[nodiscard]] Vec3 axis() const { return turn * roll().axis; }
};

void checkVector(const Vec3& vector, const Vec3& wanted) {
  CAPTURE(vector.x, vector.y, vector.z, wanted.x, wanted.y, wanted.z);
  CHECK(glm::length(vector - wanted) < 1e-9);
}

/// Level, at an angle from the z axis towards the x axis.
Vec3 heading(double degrees) {
  return {std::sin(degrees * pi / 180.0), 0.0, std::cos(degrees * pi / 180.0)};
}

} // namespace

TEST_CASE("a foot rolls about its toes wherever it points, and about the back of its sole") {
  const double degrees = GENERATE(0.0, 30.0, 100.0, 200.0, 290.0);
  CAPTURE(degrees);
  const Vec3 forward = heading(degrees);
  Foot foot;
  const NodeIndex toe = foot.addToe(0.15 * forward + Vec3(0, -0.07, 0));
  foot.addBox(foot.leg.endNode, Vec3(-0.04, -0.09, -0.06), Vec3(0.05, 0.0, 0.03));
  CHECK(foot.roll().toes == toe);
  checkVector(foot.axis(), glm::cross(upright, forward));
  checkVector(foot.seen(foot.roll().ball), 0.15 * forward + Vec3(0, -0.07, 0));
  // How far the box reaches backwards, corner by corner.
  double back = 0.0;
  for (const double cornerX : {-0.04, 0.05}) {
    for (const double cornerZ : {-0.06, 0.03}) {
      back = std::max(back, -glm::dot(forward, Vec3(cornerX, 0.0, cornerZ)));
    }
  }
  checkVector(foot.seen(foot.roll().heel), -back * forward + Vec3(0, -0.09, 0));
}

TEST_CASE("a sole that lies before the ankle has its heel below it") {
  Foot foot;
  foot.addToe(Vec3(0, -0.07, 0.15));
  foot.addBox(foot.leg.endNode, Vec3(-0.04, -0.09, 0.02), Vec3(0.05, 0.0, 0.2));
  checkVector(foot.seen(foot.roll().heel), Vec3(0, -0.09, 0));
}

TEST_CASE("the sole is of all that hangs on the foot and of what stands beside it") {
  Foot foot;
  const NodeIndex toe = foot.addToe(Vec3(0, -0.07, 0.15));
  const NodeIndex nail = foot.addJoint("nail", toe, ankle);
  const NodeIndex heel = foot.addJoint("heel", foot.leg.joints[0], ankle);
  const NodeIndex spur = foot.addJoint("spur", heel, ankle);
  foot.addBox(foot.leg.endNode, Vec3(-0.04, -0.05, -0.01), Vec3(0.04, 0.0, 0.02));
  foot.addBox(nail, Vec3(-0.04, -0.09, 0.1), Vec3(0.04, -0.08, 0.2));
  foot.addBox(spur, Vec3(-0.04, -0.04, -0.08), Vec3(0.04, -0.03, -0.05));
  checkVector(foot.seen(foot.roll().heel), Vec3(0, -0.09, -0.01));
  foot.topology.companions = {heel};
  checkVector(foot.seen(foot.roll().heel), Vec3(0, -0.09, -0.08));
}

TEST_CASE("without a mesh a foot rolls about its toes and about the place below the ankle at their height") {
  Foot foot;
  foot.addToe(Vec3(0.1, -0.07, 0.0));
  checkVector(foot.seen(foot.roll().ball), Vec3(0.1, -0.07, 0.0));
  checkVector(foot.seen(foot.roll().heel), Vec3(0, -0.07, 0));
  checkVector(foot.axis(), glm::cross(upright, Vec3(1, 0, 0)));
}

TEST_CASE("without toes the middle of the sole says where a foot points, its ball at 0.7 of the way") {
  Foot foot;
  foot.addBox(foot.leg.endNode, Vec3(-0.2, -0.09, -0.03), Vec3(0.06, 0.0, 0.03));
  CHECK_FALSE(foot.roll().toes.exists());
  checkVector(foot.axis(), glm::cross(upright, Vec3(-1, 0, 0)));
  checkVector(foot.seen(foot.roll().ball), Vec3(-0.7 * 0.2, -0.09, 0));
  checkVector(foot.seen(foot.roll().heel), Vec3(0.06, -0.09, 0));
}

TEST_CASE("toes are the joint that reaches farthest over the ground, not below it, and no prop's") {
  Foot foot;
  const NodeIndex toe = foot.addToe(Vec3(0, 0.0, 0.15));
  foot.addToe(Vec3(0, -0.9, 0.05), "below");
  CHECK(foot.roll().toes == toe);
  const NodeIndex tag = foot.addToe(Vec3(0, 0, 0.5), "tag");
  CHECK(foot.roll().toes == tag); // Where no skin says which nodes are joints.
  Skin skin;
  skin.joints = {foot.leg.endNode, toe};
  skin.inverseBind.assign(2, Mat4(1.0));
  foot.scene.skins = {skin};
  CHECK(foot.roll().toes == toe);
}

TEST_CASE("a foot that points nowhere rolls about nothing") {
  Foot foot;
  checkVector(foot.roll().axis, Vec3(0.0));
  const auto turnsAbout = [](double toesAway, double legLength) {
    Foot other;
    other.leg.restLength = legLength;
    other.addToe(Vec3(0, -0.07, toesAway));
    return glm::length(other.roll().axis);
  };
  CHECK(turnsAbout(0.0009, 1.0) == 0.0);
  CHECK(turnsAbout(0.0011, 1.0) == Approx(1.0));
  CHECK(turnsAbout(0.0011, 2.0) == 0.0);
  foot.addToe(Vec3(0, 0, 0.1));
  CHECK(glm::length(foot.roll().axis) == Approx(1.0));
  foot.leg.endNode = NodeIndex::none;
  CHECK(foot.roll().axis == Vec3(0.0));
  CHECK_FALSE(foot.roll().toes.exists());
}
