// A body taken apart into rows of joints: which of them mirror each other, and where they begin.
#include "rig/body/reading/extremities.h"

#include <catch2/catch.hpp>

#include "tests/support/nodes.h"
#include "tests/support/rig/joint_views.h"

using namespace stretch;
using namespace stretch::rig::body;

namespace {

/// Joints that are made one by one, each below one made before, as a scene and as what is looked at of it.
struct BodyOfRows {
  Scene scene;
  BodyView view;

  int add(int parent, const Vec3& place) {
    const NodeIndex above = parent < 0 ? NodeIndex::none : view.nodes[static_cast<std::size_t>(parent)];
    return test::addJoint(view, test::addNode(scene, "", above, place), parent, place);
  }

  [[nodiscard]] Extremities apart() const {
    BindPose bindPose;
    for (const Vec3& place : view.position) {
      bindPose.worlds.push_back(toMatrix({place, Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)}));
    }
    return takeApart(scene, bindPose, view, {}, Vec3(0.0, 1.0, 0.0));
  }
};

} // namespace

TEST_CASE(
    "An anchor in the middle on one side and a little beside it on the other is a joint of neither leg") {
  const double farSide = GENERATE(1.0, -1.0);
  CAPTURE(farSide);
  BodyOfRows body;
  const int hips = body.add(-1, Vec3(0.0, 1.0, 0.0));
  for (const double side : {1.0, -1.0}) {
    int joint = body.add(hips, Vec3(side * (side == farSide ? 0.006 : 0.001), 1.0, 0.0));
    for (const double height : {1.0, 0.5, 0.0}) {
      joint = body.add(joint, Vec3(side * 0.2, height, 0.0));
    }
  }
  const Extremities apart = body.apart();
  REQUIRE(apart.pairs.size() == 1);
  CHECK(apart.pairs.front().negative.path.size() == 3);
  CHECK(apart.pairs.front().positive.path.size() == 3);
  CHECK(apart.pairs.front().mirrorError < 1e-9);
}
