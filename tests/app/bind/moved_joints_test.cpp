// Keys of joints that are moved in the bind pose, by quarter turns and whole steps.
#include "app/bind/moved_joints.h"

#include <memory>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

const Quat quarterAboutX = axisAngle(Vec3(1.0, 0.0, 0.0), 0.5 * pi);
const Quat quarterAboutZ = axisAngle(Vec3(0.0, 0.0, 1.0), 0.5 * pi);

/// A joint two above its parent, which is turned by a quarter about z while the joint is put three to the
/// right (world), turned by a quarter about x: three above its parent then.
JointMove movedByQuarters(NodeIndex node) {
  JointMove move{node, glm::translate(Mat4(1.0), Vec3(0.0, 2.0, 0.0)),
                 toMatrix({Vec3(-3.0, 0.0, 0.0), quarterAboutX, Vec3(1.0)})};
  move.parentTo = glm::mat4_cast(quarterAboutZ);
  return move;
}

Track keyedTrack(NodeIndex node, Channel channel, Interpolation interpolation,
                 const std::vector<float>& values) {
  Track track;
  track.node = node;
  track.channel = channel;
  track.interpolation = interpolation;
  track.width = channel == Channel::rotation ? 4 : 3;
  const std::size_t perKey = (interpolation == Interpolation::cubicSpline ? 3U : 1U) * at(track.width);
  for (std::size_t key = 0; key * perKey < values.size(); ++key) {
    track.times.push_back(static_cast<float>(key));
  }
  track.values = values;
  return track;
}

/// The values of a joint's track after the joint was moved.
std::vector<float> movedValues(Channel channel, Interpolation interpolation,
                               const std::vector<float>& values) {
  const NodeIndex joint(3);
  Clip clip;
  clip.tracks.emplace_back(keyedTrack(joint, channel, interpolation, values));
  const auto clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  const SharedClips moved = withMovedJoints(clips, {movedByQuarters(joint)});
  REQUIRE(moved->size() == 1);
  REQUIRE(moved->front().tracks.size() == 1);
  CHECK(moved->front().tracks.front()->times == clip.tracks.front()->times);
  return moved->front().tracks.front()->values;
}

Vec3 placeIn(const std::vector<float>& values, std::size_t place) {
  return {values.at(3 * place), values.at(3 * place + 1), values.at(3 * place + 2)};
}

bool isNearPlace(const Vec3& a, const Vec3& b) {
  return glm::distance(a, b) < 1e-6;
}

} // namespace

TEST_CASE("Where a moved joint is keyed it goes from its new place the way that it went from the old one") {
  const std::vector<float> values =
      movedValues(Channel::translation, Interpolation::linear, {0.0F, 2.0F, 0.0F, 1.0F, 2.0F, 5.0F});
  REQUIRE(values.size() == 6);
  CHECK(isNearPlace(placeIn(values, 0), Vec3(0.0, 3.0, 0.0)));
  CHECK(isNearPlace(placeIn(values, 1), Vec3(0.0, 2.0, 5.0))); // one to the right, seen by what was turned
}

TEST_CASE("Tangents of a moved joint's places are turned and no more, values between them are moved") {
  const std::vector<float> values = movedValues(Channel::translation, Interpolation::cubicSpline,
                                                {1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F, 0.0F, 4.0F, 0.5F});
  REQUIRE(values.size() == 9);
  CHECK(isNearPlace(placeIn(values, 0), Vec3(0.0, -1.0, 0.0)));
  CHECK(isNearPlace(placeIn(values, 1), Vec3(0.0, 3.0, 0.0)));
  CHECK(isNearPlace(placeIn(values, 2), Vec3(4.0, 0.0, 0.5)));
}

TEST_CASE("A moved joint's turns are made between the turn of what carries it and its own") {
  const std::vector<float> values =
      movedValues(Channel::rotation, Interpolation::linear, {0.0F, 0.0F, 0.0F, 1.0F});
  REQUIRE(values.size() == 4);
  const Quat turn(values[3], values[0], values[1], values[2]);
  CHECK(isNearPlace(turn * Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)));
  CHECK(isNearPlace(turn * Vec3(1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0)));
}

TEST_CASE("Sizes of moved joints, other joints and clips without keys of them are as they were") {
  const std::vector<float> sizes{1.0F, 2.0F, 3.0F};
  CHECK(movedValues(Channel::scale, Interpolation::linear, sizes) == sizes);
  const std::vector<float> places{1.0F, 2.0F, 3.0F};
  Clip clip;
  clip.tracks.emplace_back(keyedTrack(NodeIndex(4), Channel::translation, Interpolation::linear, places));
  const auto clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  CHECK(*withMovedJoints(clips, {movedByQuarters(NodeIndex(3))}) == *clips);
  CHECK(withMovedJoints(clips, {}) == clips);
  CHECK(withMovedJoints(nullptr, {movedByQuarters(NodeIndex(3))}) == nullptr);
}

TEST_CASE(
    "A joint without a locator goes along with the one that it hangs from, as far off and turned with it") {
  Scene scene;
  const NodeIndex hips = test::addNode(scene, "hips", NodeIndex::none, Vec3(0.0, 1.0, 0.0));
  const NodeIndex spine = test::addNode(scene, "spine", hips, Vec3(0.0, 0.2, 0.0));
  const NodeIndex pouch = test::addNode(scene, "pouch", spine, Vec3(0.1, 0.0, 0.0));
  Skin skin;
  for (const NodeIndex joint : {hips, spine, pouch}) {
    skin.joints.push_back(joint);
    skin.inverseBind.push_back(glm::inverse(worldMatrices(scene, restPose(scene))[at(joint)]));
  }
  scene.skins.push_back(skin);
  rig::Locators locators;
  locators.list = {{"hips", Vec3(0.0, 1.0, 0.0)}, {"spine", Vec3(0.0, 1.5, 0.0), quarterAboutZ}};
  const std::vector<JointMove> moves = movesTo(scene, locators);
  REQUIRE(moves.size() == 2); // the hips stay
  CHECK(moves[0].node == spine);
  CHECK(isNearPlace(positionOf(moves[0].to), Vec3(0.0, 1.5, 0.0)));
  CHECK(moves[1].node == pouch);
  CHECK(isNearPlace(positionOf(moves[1].from), Vec3(0.1, 1.2, 0.0)));
  CHECK(isNearPlace(positionOf(moves[1].to), Vec3(0.0, 1.6, 0.0)));
  CHECK(isNearPlace(Mat3(moves[1].to) * Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)));
  CHECK(moves[1].parentTo == moves[0].to);
  locators.list[1] = {"spine", Vec3(0.0, 1.2, 0.0)};
  CHECK(movesTo(scene, locators).empty());
}

TEST_CASE("A joint to bind stands and leads where it is moved to, the others as before") {
  SkeletonToBind skeleton;
  for (const std::size_t node : {3U, 4U}) {
    skeleton.nodes.emplace_back(node);
    skeleton.worlds.push_back(glm::translate(Mat4(1.0), Vec3(0.0, 2.0, 0.0)));
    skeleton.joints.push_back({Vec3(0.0, 2.0, 0.0), -1});
    skeleton.joints.back().forward = Vec3(0.0, 1.0, 0.0);
  }
  const SkeletonToBind after = moved(skeleton, {movedByQuarters(NodeIndex(3))});
  CHECK(isNearPlace(after.joints[0].place, Vec3(-3.0, 0.0, 0.0)));
  CHECK(isNearPlace(after.joints[0].forward, Vec3(0.0, 0.0, 1.0)));
  CHECK(after.worlds[0] == movedByQuarters(NodeIndex(3)).to);
  CHECK(after.joints[1].place == Vec3(0.0, 2.0, 0.0));
  CHECK(after.joints[1].forward == Vec3(0.0, 1.0, 0.0));
  CHECK(after.worlds[1] == skeleton.worlds[1]);
}
