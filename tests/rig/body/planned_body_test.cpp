// What a body of a plan says of limbs that it has not, and which end of them leads.
#include "rig/body/reading/planned_body.h"

#include <string>

#include <catch2/catch.hpp>

#include "rig/plan/body_plan.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

Limb limbHaving(const std::string& id, const LimbPlace& place, const std::vector<NodeIndex>& joints) {
  Limb limb;
  static_cast<LimbPlace&>(limb) = place;
  limb.id = id;
  limb.joints = joints;
  return limb;
}

Mat4 standingAt(double z) {
  Mat4 world(1.0);
  world[3] = Vec4(0.0, 0.0, z, 1.0);
  return world;
}

} // namespace

TEST_CASE("A limb that a body's plan has not is refused with those that the body has, but for a biped") {
  Body body;
  body.plan = "quadruped";
  CHECK(whyNoLimb(body, "left-arm") == "the character is a quadruped and has no left-arm");
  body.limbs = {limbHaving("spine", biped::spine, {NodeIndex(0)}),
                limbHaving("tail", {LimbKind::tail}, {NodeIndex(1)})};
  CHECK(whyNoLimb(body, "left-arm") ==
        "the character is a quadruped and has no left-arm; it has spine, tail");
  CHECK(whyNoLimb(body, "front-left-leg").empty()); // The plan has it, this body alone does not.
  body.plan = "biped";
  CHECK(whyNoLimb(body, "front-left-leg").empty());
  body.plan = "centaur"; // Of no plan that there is: as a body of none.
  CHECK(planOf(body).id == "other");
  CHECK(whyNoLimb(body, "left-arm") ==
        "the character is a body of no known plan and has no left-arm; it has spine, tail");
}

TEST_CASE(
    "A serpent's trunk is led by the end that is nearer to its head, any other limb by its last joint") {
  const std::vector<Mat4> worlds{standingAt(1.0), standingAt(0.0), standingAt(-1.0), standingAt(1.2),
                                 standingAt(-1.2)};
  const auto isLedByFirst = [&](const std::string& plan, NodeIndex head) {
    Body body;
    body.plan = plan;
    body.head = head;
    body.limbs = {limbHaving("spine", biped::spine, {NodeIndex(0), NodeIndex(1)})};
    body.limbs.front().endNode = NodeIndex(2);
    body.limbs.front().ledByFirst = true; // What an earlier reading left there counts for nothing.
    setLeadingEnds(worlds, body);
    return body.limbs.front().ledByFirst;
  };
  CHECK(isLedByFirst("serpent", NodeIndex(3)));
  CHECK_FALSE(isLedByFirst("serpent", NodeIndex(4)));
  CHECK_FALSE(isLedByFirst("serpent", NodeIndex::none));
  CHECK_FALSE(isLedByFirst("quadruped", NodeIndex(3)));
}
