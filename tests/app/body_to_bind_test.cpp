#include "app/bind/body_to_bind.h"

#include <algorithm>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "rig/body/reading/detection.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;

TEST_CASE("Joints to bind are all that limbs need, wherever they hang, and no handle beside them") {
  test::SyntheticBiped body = test::makeNamedBody("Mixamo");
  // Legs beside the hips on a joint of their own, feet and handles on the root.
  const auto hips = std::ranges::find(body.joints, std::string("hips"), &test::SyntheticJoint::key);
  body.joints.insert(hips, {"carrier", "root", Vec3(0.0, 0.95, 0.0)});
  body.names["carrier"] = "Body";
  test::jointOf(body, "hips").parent = "carrier";
  for (const std::string side : {".l", ".r"}) {
    test::jointOf(body, "thigh" + side).parent = "carrier";
    test::jointOf(body, "foot" + side).parent = "root";
    body.joints.push_back({"handle" + side, "spine0", test::jointOf(body, "foreArm" + side).position});
    body.names["handle" + side] = "hand_IK" + side;
  }
  const test::BuiltBiped built = test::build(body);
  app::Document document;
  document.scene = std::make_shared<const Scene>(built.scene);
  document.body = rig::detectBody(built.scene);
  const app::SkeletonToBind skeleton = app::ownSkeleton(document);
  const std::vector<NodeIndex>& bound = skeleton.nodes;
  const auto isBound = [&](const std::string& key) {
    return std::ranges::find(bound, built.node.at(key)) != bound.end();
  };
  for (const char* key :
       {"hips", "spine0", "head", "thigh", "shin", "foot", "toe", "upperArm", "foreArm", "hand"}) {
    for (const std::string side : {".l", ".r"}) {
      const std::string name = built.node.contains(key) ? key : key + side;
      INFO(name);
      CHECK(isBound(name));
    }
  }
  // A foot that hangs on the root goes on as its shin comes, or its shin would take all that it has.
  const auto slot = [&](const std::string& key) {
    return static_cast<int>(std::ranges::find(bound, built.node.at(key)) - bound.begin());
  };
  for (const std::string side : {".l", ".r"}) {
    CHECK(skeleton.joints[at(slot("foot" + side))].parent == slot("shin" + side));
    CHECK(skeleton.joints[at(slot("shin" + side))].parent == slot("thigh" + side));
  }
  CHECK_FALSE(isBound("handle.l"));
  CHECK_FALSE(isBound("handle.r"));
}
