#include <catch2/catch.hpp>

#include "rig/limb_nodes.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;

TEST_CASE("Hand and fingers belong to the arm, the head to the neck, hips and shoulders to the trunk, props "
          "to nobody") {
  Scene scene;
  const NodeIndex hips = test::addNode(scene, "Hips", NodeIndex::none, {0.0, 1.0, 0.0});
  const NodeIndex spine = test::addNode(scene, "Spine", hips, {0.0, 0.2, 0.0});
  const NodeIndex chest = test::addNode(scene, "Chest", spine, {0.0, 0.2, 0.0});
  const NodeIndex shoulder = test::addNode(scene, "Shoulder", chest, {0.1, 0.1, 0.0});
  const NodeIndex arm = test::addNode(scene, "Arm", shoulder, {0.1, 0.0, 0.0});
  const NodeIndex hand = test::addNode(scene, "Hand", arm, {0.5, 0.0, 0.0});
  const NodeIndex finger = test::addNode(scene, "Finger", hand, {0.1, 0.0, 0.0});
  const NodeIndex neck = test::addNode(scene, "Neck", chest, {0.0, 0.2, 0.0});
  const NodeIndex head = test::addNode(scene, "Head", neck, {0.0, 0.1, 0.0});
  const NodeIndex prop = test::addNode(scene, "Ball", NodeIndex::none, {2.0, 0.0, 0.0});
  std::vector<Limb> limbs(3);
  limbs[0].kind = LimbKind::arm;
  limbs[0].joints = {arm};
  limbs[0].endNode = hand;
  limbs[1].kind = LimbKind::spine;
  limbs[1].joints = {spine};
  limbs[1].endNode = chest;
  limbs[2].kind = LimbKind::neck;
  limbs[2].joints = {neck};
  limbs[2].endNode = head;
  const std::vector<int> owner = limbOfNodes(scene, limbs, hips);
  for (const NodeIndex node : {arm, hand, finger}) {
    CHECK(owner[at(node)] == 0);
  }
  for (const NodeIndex node : {hips, spine, chest, shoulder}) {
    CHECK(owner[at(node)] == 1);
  }
  CHECK(owner[at(head)] == 2);
  CHECK(owner[at(prop)] == -1);
  CHECK(isAtEnd(scene, limbs[0], finger));
  CHECK_FALSE(isAtEnd(scene, limbs[0], arm));
}
