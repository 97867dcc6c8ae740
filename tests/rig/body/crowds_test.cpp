// Files with more skeletons than a character has.
#include <vector>

#include <catch2/catch.hpp>

#include "rig/body/evidence/skeletons.h"
#include "tests/support/nodes.h"

using namespace stretch;

namespace {

/// Appends a row of joints of the first skin; answers the first of them.
NodeIndex addRowOfJoints(Scene& scene, int count) {
  NodeIndex above;
  NodeIndex first;
  for (int i = 0; i < count; ++i) {
    above = test::addNode(scene, "joint", above, {0.0, 1.0, 0.0});
    first = i == 0 ? above : first;
    scene.skins.at(0).joints.push_back(above);
  }
  return first;
}

} // namespace

TEST_CASE("Of a crowd the eight skeletons of most joints are looked at, wherever they stand in the file") {
  Scene scene;
  scene.skins.emplace_back();
  std::vector<NodeIndex> tops;
  for (const int joints : {5, 6, 4, 7, 5, 8, 9, 6, 6, 12, 10}) {
    tops.push_back(addRowOfJoints(scene, joints));
  }
  // That of four is too small for a body, the two of five have to give way.
  CHECK(rig::body::skeletonsApart(scene) ==
        std::vector{tops[1], tops[3], tops[5], tops[6], tops[7], tops[8], tops[9], tops[10]});
}
