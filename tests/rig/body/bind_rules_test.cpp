// What places a skin: which of its joints, in which units, and which of several skins.
#include <cstddef>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/anim/sampling.h"
#include "rig/body/evidence/bind_pose.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

Mat4 inverseAt(const Vec3& place) {
  return glm::translate(Mat4(1.0), -place);
}

/// A column of joints that rests bent, a length apart from each other, and is bound straight up, so many
/// lengths of that apart.
Scene column(double length, double apart, int count = 4) {
  Scene scene;
  Skin skin;
  for (int i = 0; i < count; ++i) {
    const NodeIndex parent = i == 0 ? NodeIndex::none : NodeIndex(i - 1);
    const NodeIndex node = test::addNode(scene, "joint", parent, Vec3(0.0, length, 0.0));
    scene.nodes[at(node)].rest.rotation = glm::angleAxis(i == 1 ? 0.7 : 0.0, Vec3(0.0, 0.0, 1.0));
    skin.joints.push_back(node);
    skin.inverseBind.push_back(inverseAt(Vec3(0.0, apart * (i + 1), 0.0)));
  }
  scene.skins = {skin};
  return scene;
}

double between(const std::vector<Mat4>& worlds, std::size_t a, std::size_t b) {
  return glm::distance(positionOf(worlds[a]), positionOf(worlds[b]));
}

} // namespace

TEST_CASE("A character of any size is bound as it is said, be it far smaller than a unit") {
  for (const double size : {100.0, 1.0, 1e-3, 2e-5, 1e-8}) {
    CAPTURE(size);
    const std::vector<Mat4> worlds = bindPoseWorlds(column(size, size));
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(glm::distance(positionOf(worlds[i]), Vec3(0.0, size * static_cast<double>(i + 1), 0.0)) <
            1e-9 * size);
    }
  }
}

TEST_CASE(
    "Binds in another unit are brought to the scene's, bones that are half or twice as long are posed") {
  for (const auto& [apart, wanted] :
       {std::pair(1.0, 1.0), {1.9, 1.9}, {0.55, 0.55}, {2.2, 1.0}, {0.45, 1.0}, {100.0, 1.0}, {0.001, 1.0}}) {
    CAPTURE(apart);
    const std::vector<Mat4> worlds = bindPoseWorlds(column(1.0, apart));
    CHECK(glm::distance(positionOf(worlds[0]), Vec3(0.0, 1.0, 0.0)) < 1e-9); // as it rests
    CHECK(between(worlds, 0, 1) == Approx(wanted));
    CHECK(between(worlds, 0, 3) == Approx(3.0 * wanted));
  }
  // The median of the bones counts: one that a pose has stretched tells no unit.
  Scene scene = column(1.0, 1.0);
  for (std::size_t i = 2; i < 4; ++i) {
    scene.skins[0].inverseBind[i] = inverseAt(Vec3(0.0, 50.0 + static_cast<double>(i), 0.0));
  }
  CHECK(between(bindPoseWorlds(scene), 1, 2) == Approx(50.0));
}

TEST_CASE(
    "A matrix that flattens, or holds what is no number, is no bind, and its joint stands as it rests") {
  for (const Mat4& broken :
       {glm::scale(Mat4(1.0), Vec3(1.0, 0.0, 1.0)), Mat4(0.0), inverseAt(Vec3(0.0, 1.0 / 0.0, 0.0))}) {
    Scene scene = column(1.0, 1.0);
    scene.nodes[3].rest.translation = Vec3(0.5, 0.25, 0.0);
    scene.skins[0].inverseBind[3] = broken;
    const std::vector<Mat4> worlds = bindPoseWorlds(scene);
    CHECK(glm::distance(positionOf(worlds[3]), Vec3(0.5, 3.25, 0.0)) < 1e-9);
    CHECK(glm::distance(positionOf(worlds[2]), Vec3(0.0, 3.0, 0.0)) < 1e-9);
  }
}

TEST_CASE(
    "Of joints that are as high the one with the most below it places the skin, whichever comes first") {
  for (const bool lonelyFirst : {true, false}) {
    Scene scene;
    const auto lonely = [&] { return test::addNode(scene, "lonely", NodeIndex::none, Vec3(5.0, 0.0, 0.0)); };
    NodeIndex alone = lonelyFirst ? lonely() : NodeIndex::none;
    const NodeIndex top = test::addNode(scene, "top", NodeIndex::none, Vec3(0.0, 1.0, 0.0));
    const NodeIndex below = test::addNode(scene, "below", top, Vec3(0.0, 1.0, 0.0));
    alone = lonelyFirst ? alone : lonely();
    // Bound elsewhere: 3 beside where the column rests, and the lonely one 7 beside.
    scene.skins = {
        {"skin",
         {alone, top, below},
         {inverseAt(Vec3(12.0, 0.0, 0.0)), inverseAt(Vec3(3.0, 1.0, 0.0)), inverseAt(Vec3(3.0, 2.0, 0.0))}}};
    const std::vector<Mat4> worlds = bindPoseWorlds(scene);
    CHECK(glm::distance(positionOf(worlds[at(top)]), Vec3(0.0, 1.0, 0.0)) < 1e-9);
    CHECK(glm::distance(positionOf(worlds[at(below)]), Vec3(0.0, 2.0, 0.0)) < 1e-9);
    CHECK(glm::distance(positionOf(worlds[at(alone)]), Vec3(9.0, 0.0, 0.0)) < 1e-9);
  }
}

TEST_CASE("A joint of several skins stands where the one of most joints has it, of equals the first") {
  const Scene whole = column(1.0, 1.0);
  const auto heightWith = [&](const std::vector<std::pair<int, double>>& skins) {
    Scene scene = whole;
    scene.skins.clear();
    for (const auto& [count, bend] : skins) {
      Skin skin;
      for (int i = 0; i < count; ++i) { // the last one to the side
        skin.joints.emplace_back(i);
        skin.inverseBind.push_back(inverseAt(Vec3(i == 2 ? bend : 0.0, i + 1.0, 0.0)));
      }
      scene.skins.push_back(skin);
    }
    const body::BindPose pose = body::placeBindPose(scene);
    CHECK(pose.placements.size() == skins.size());
    for (const Mat4& placement : pose.placements) { // all by the joint that they share
      CHECK(glm::distance(positionOf(placement), Vec3(0.0)) < 1e-9);
    }
    return positionOf(pose.worlds[2]).x;
  };
  CHECK(heightWith({{3, 0.3}, {4, 0.5}}) == Approx(0.5));
  CHECK(heightWith({{4, 0.5}, {3, 0.3}}) == Approx(0.5));
  CHECK(heightWith({{3, 0.3}, {3, 0.4}}) == Approx(0.3));
  CHECK(heightWith({{2, 0.0}, {3, 0.4}}) == Approx(0.4));
  CHECK(heightWith({{3, 0.2}, {2, 0.0}, {3, 0.4}}) == Approx(0.2));
}

TEST_CASE("A helper with the identity stands as it rests below a joint that is bound, at any depth") {
  Scene scene = column(1.0, 1.0);
  const NodeIndex between = test::addNode(scene, "group", NodeIndex(1), Vec3(0.0, 0.0, 2.0));
  const NodeIndex helper = test::addNode(scene, "helper", between, Vec3(0.25, 0.0, 0.0));
  scene.skins[0].joints.push_back(helper);
  scene.skins[0].inverseBind.emplace_back(1.0);
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  CHECK(glm::distance(positionOf(worlds[at(helper)]), Vec3(0.25, 2.0, 2.0)) < 1e-9);
  // A joint below such a helper that is bound counts as before.
  const NodeIndex tip = test::addNode(scene, "tip", helper, Vec3(9.0, 9.0, 9.0));
  scene.skins[0].joints.push_back(tip);
  scene.skins[0].inverseBind.push_back(inverseAt(Vec3(0.5, 2.5, 2.5)));
  CHECK(glm::distance(positionOf(bindPoseWorlds(scene)[at(tip)]), Vec3(0.5, 2.5, 2.5)) < 1e-9);
}

TEST_CASE(
    "A skin that binds all its joints alike stands as they rest, and its vertices with the joint of each") {
  Scene scene = column(1.0, 1.0);
  for (Mat4& bind : scene.skins[0].inverseBind) {
    bind = Mat4(1.0);
  }
  const std::vector<Mat4> rest = worldMatrices(scene, restPose(scene));
  const body::BindPose pose = body::placeBindPose(scene);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(glm::distance(positionOf(pose.worlds[i]), positionOf(rest[i])) < 1e-9);
  }
  CHECK(pose.areAtRest.at(0));
  CHECK_FALSE(body::placeBindPose(column(1.0, 1.0)).areAtRest.at(0));
}
