#include "app/bind/body_to_bind.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"
#include "rig/body/reading/detection.h"
#include "tests/support/nodes.h"
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

TEST_CASE("No joint is hung on what it carries, though a limb is said to go on there") {
  const test::BuiltBiped built = test::build(test::makeNamedBody("Mixamo"));
  app::Document document;
  document.scene = std::make_shared<const Scene>(built.scene);
  document.body = rig::detectBody(built.scene);
  const auto parentsOf = [](const app::SkeletonToBind& skeleton) {
    std::vector<int> parents;
    for (const skinning::BindJoint& joint : skeleton.joints) {
      parents.push_back(joint.parent);
    }
    return parents;
  };
  const std::vector<int> whole = parentsOf(app::ownSkeleton(document));
  for (const char* const carrier : {"hips", "thigh.l", "spine0"}) {
    CAPTURE(carrier);
    app::Document odd = document;
    const auto leg = std::ranges::find(odd.body.limbs, std::string("left-leg"), &rig::Limb::id);
    REQUIRE(leg != odd.body.limbs.end());
    leg->endNode = built.node.at(carrier);
    const std::vector<int> parents = parentsOf(app::ownSkeleton(odd));
    REQUIRE(parents.size() == whole.size());
    const bool isBeside = std::string(carrier) == "spine0"; // which hangs on the shin then
    CHECK((parents == whole) == !isBeside);
  }
}

TEST_CASE(
    "A joint beside the hips that vertices follow is bound, below the joint that its control stands on") {
  test::SyntheticBiped body = test::makeNamedBody("Mixamo");
  const Vec3 hips = test::jointOf(body, "hips").position;
  for (const auto& [key, parent, place, movesMesh] :
       {std::tuple<std::string, std::string, Vec3, bool>{"copy", "root", hips, false},
        {"pad", "copy", hips + Vec3(0.1, 0.0, 0.0), true},
        {"idle", "copy", hips - Vec3(0.1, 0.0, 0.0), false}}) {
    test::SyntheticJoint joint;
    joint.key = key;
    joint.parent = parent;
    joint.position = place;
    joint.movesMesh = movesMesh;
    body.joints.push_back(joint);
    body.names[key] = key;
  }
  const test::BuiltBiped built = test::build(body);
  app::Document document;
  document.scene = std::make_shared<const Scene>(built.scene);
  document.body = rig::detectBody(built.scene);
  REQUIRE(document.body.hips == built.node.at("hips"));
  const app::SkeletonToBind skeleton = app::ownSkeleton(document);
  const auto slot = [&](const std::string& key) {
    return static_cast<std::size_t>(std::ranges::find(skeleton.nodes, built.node.at(key)) -
                                    skeleton.nodes.begin());
  };
  REQUIRE(slot("pad") < skeleton.nodes.size());
  CHECK(skeleton.joints[slot("pad")].parent == static_cast<int>(slot("hips")));
  CHECK(slot("copy") == skeleton.nodes.size());
  CHECK(slot("idle") == skeleton.nodes.size());
}

TEST_CASE("Bones that run along one axis of theirs say where the last of them leads") {
  Scene scene;
  const Quat bent = glm::angleAxis(0.3, Vec3(0.0, 0.0, 1.0));
  NodeIndex last = test::addNode(scene, "bone0", NodeIndex::none, Vec3(0.0));
  for (int i = 1; i <= 5; ++i) {
    last = test::addNode(scene, "bone" + std::to_string(i), last, Vec3(0.0, 2.0, 0.0));
    scene.nodes[at(last)].rest.rotation = bent;
  }
  Skin skin;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    skin.joints.emplace_back(node);
  }
  const std::vector<Mat4> rest = worldMatrices(scene, restPose(scene));
  for (const Mat4& world : rest) {
    skin.inverseBind.push_back(glm::inverse(world));
  }
  scene.skins.push_back(skin);
  app::Document document;
  document.scene = std::make_shared<const Scene>(scene);
  const std::vector<skinning::BindJoint> joints = app::ownSkeleton(document).joints;
  REQUIRE(joints.size() == 6);
  CHECK(glm::length(joints[5].forward - Vec3(-std::sin(1.5), std::cos(1.5), 0.0)) < 1e-6);
  // Bones that run every way say nothing.
  for (int i = 1; i <= 5; i += 2) {
    scene.nodes[at(i)].rest.translation = Vec3(0.0, 0.0, 2.0);
  }
  scene.skins.front().inverseBind.clear();
  for (const Mat4& world : worldMatrices(scene, restPose(scene))) {
    scene.skins.front().inverseBind.push_back(glm::inverse(world));
  }
  document.scene = std::make_shared<const Scene>(scene);
  CHECK(app::ownSkeleton(document).joints[5].forward == Vec3(0.0));
}

TEST_CASE("Bones of one side that run the other way along their axis lead to their ends as well") {
  // A trunk of four bones and an arm of two on each side; those of the right one run backwards.
  Scene scene;
  NodeIndex top = test::addNode(scene, "trunk0", NodeIndex::none, Vec3(0.0));
  for (int i = 1; i <= 4; ++i) {
    top = test::addNode(scene, "trunk" + std::to_string(i), top, Vec3(0.0, 2.0, 0.0));
  }
  std::vector<NodeIndex> hands;
  for (const double side : {1.0, -1.0}) {
    NodeIndex last = test::addNode(scene, "shoulder", top, Vec3(0.5 * side, 0.0, 0.0));
    scene.nodes[at(last)].rest.rotation = glm::angleAxis(-0.5 * pi, Vec3(0.0, 0.0, 1.0)); // y is to the left
    for (const char* const name : {"elbow", "hand"}) {
      last = test::addNode(scene, name, last, Vec3(0.0, 2.0 * side, 0.0));
    }
    hands.push_back(last);
  }
  Skin skin;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    skin.joints.emplace_back(node);
  }
  for (const Mat4& world : worldMatrices(scene, restPose(scene))) {
    skin.inverseBind.push_back(glm::inverse(world));
  }
  scene.skins.push_back(skin);
  app::Document document;
  document.scene = std::make_shared<const Scene>(scene);
  const app::SkeletonToBind skeleton = app::ownSkeleton(document);
  REQUIRE(skeleton.joints.size() == scene.nodes.size());
  const auto leadsTo = [&](NodeIndex node, const Vec3& way) {
    const auto slot = std::ranges::find(skeleton.nodes, node) - skeleton.nodes.begin();
    return glm::length(skeleton.joints[at(static_cast<int>(slot))].forward - way) < 1e-6;
  };
  for (const auto& [hand, side] : {std::pair(hands[0], 1.0), {hands[1], -1.0}}) {
    CHECK(leadsTo(hand, Vec3(side, 0.0, 0.0)));
    CHECK(leadsTo(scene.nodes[at(hand)].parent, Vec3(side, 0.0, 0.0)));
  }
  CHECK(leadsTo(top, Vec3(0.0, 1.0, 0.0)));
}
