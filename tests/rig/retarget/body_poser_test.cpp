// Poses of a small skeleton, and the tracks that are written of them, against the world places they have.
#include "rig/retarget/body_poser.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

constexpr std::size_t legs = 2;

/// Hips below a node of other units that is turned, a spine of two, and two legs, of which the right one's
/// foot hangs on that node. One joint of each leg follows nothing.
struct Stander {
  Scene scene;
  Skeleton skeleton;
  NodeIndex space, hips, spine, chest;
  std::array<NodeIndex, legs> thighs, shins, feet;

  /// `unit`: world units of one unit of the file.
  explicit Stander(double unit) {
    const auto add = [&](const char* name, NodeIndex parent, const Vec3& world) {
      return test::addNode(scene, name, parent, world / unit);
    };
    space = test::addNode(scene, "Space", NodeIndex::none, {0.3, 0.0, -0.2});
    scene.nodes[at(space)].rest.rotation = axisAngle(Vec3(0.0, 1.0, 0.0), 0.7);
    scene.nodes[at(space)].rest.scale = Vec3(unit);
    hips = add("Hips", space, {0.0, 1.0, 0.0});
    spine = add("Spine", hips, {0.0, 0.2, 0.0});
    chest = add("Chest", spine, {0.0, 0.3, 0.0});
    for (const std::size_t side : {leftSide, rightSide}) {
      const double x = side == leftSide ? 0.1 : -0.1;
      thighs[side] = add("Thigh", hips, {x, 0.0, 0.0});
      shins[side] = add("Shin", thighs[side], {0.0, -0.5, 0.0});
      feet[side] =
          side == leftSide ? add("Foot", shins[side], {0.0, -0.5, 0.0}) : add("Foot", space, {x, 0.0, 0.0});
      SkeletonLeg& leg = skeleton.legs[side];
      leg.limb.joints = {thighs[side], shins[side]};
      leg.limb.endNode = feet[side];
    }
    skeleton.scene = &scene;
    skeleton.height = 1.8;
    skeleton.hips = skeleton.carrier = hips;
    scene.skins.push_back({"skin", {hips, spine, chest, thighs[0], shins[0], feet[0]}, {}});
    scene.skins.back().inverseBind.resize(6, Mat4(1.0));
    bindAsAtRest();
  }

  void bindAsAtRest() { skeleton.bind = worldMatrices(scene, restPose(scene)); }

  [[nodiscard]] std::vector<JointPair> pairsOf(const std::vector<NodeIndex>& joints) const {
    std::vector<JointPair> pairs;
    for (const NodeIndex joint : joints) {
      pairs.emplace_back();
      pairs.back().joint = joint;
    }
    return pairs;
  }
};

Vec3 posedPlace(const BodyPose& pose, NodeIndex node) {
  return positionOf(pose.worlds[at(node)]);
}

double unequal(const Quat& a, const Quat& b) {
  return angleBetween(a, b);
}

/// The clip of some tracks.
Clip clipWith(std::vector<Track> tracks) {
  Clip clip;
  for (Track& track : tracks) {
    clip.tracks.emplace_back(std::move(track));
  }
  return clip;
}

const Track* trackFor(const std::vector<Track>& tracks, NodeIndex node, Channel channel) {
  const auto found = std::ranges::find_if(
      tracks, [&](const Track& track) { return track.node == node && track.channel == channel; });
  return found == tracks.end() ? nullptr : &*found;
}

std::vector<float> timesOf(std::size_t frames) {
  std::vector<float> times;
  for (std::size_t i = 0; i < frames; ++i) {
    times.push_back(static_cast<float>(i) / 30.0F);
  }
  return times;
}

} // namespace

TEST_CASE("Without turns, a shift or places of feet a body stands as in its bind pose") {
  const Stander body(GENERATE(1.0, 0.01, 7.0));
  const BodyPoser poser(body.skeleton, {});
  const BodyPose pose = poser.pose({}, Vec3(0.0), {});
  for (std::size_t node = 0; node < body.scene.nodes.size(); ++node) {
    CHECK(glm::length(posedPlace(pose, NodeIndex(node)) - positionOf(body.skeleton.bind[node])) < 1e-12);
    CHECK(poser.pairOf(NodeIndex(node)) == -1);
  }
}

TEST_CASE("Paired joints have the turns that are asked for in the world, whatever those above them do") {
  const Stander body(GENERATE(1.0, 0.01));
  const std::vector<JointPair> pairs = body.pairsOf({body.chest, body.hips, body.shins[0]});
  const BodyPoser poser(body.skeleton, pairs);
  CHECK(poser.pairOf(body.chest) == 0);
  CHECK(poser.pairOf(body.hips) == 1);
  CHECK(poser.pairOf(body.shins[0]) == 2);
  CHECK(poser.pairOf(body.spine) == -1);
  const std::vector<Quat> turns{axisAngle(Vec3(1, 0, 0), 0.4), axisAngle(Vec3(0, 1, 0), -1.1),
                                axisAngle(Vec3(0, 0, 1), 0.8)};
  const BodyPose pose = poser.pose(turns, Vec3(0.0), {});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CHECK(unequal(rotationOf(pose.worlds[at(pairs[i].joint)]), turns[i]) < 1e-7);
  }
  // The joints between and below keep how they stand to the one above.
  for (const NodeIndex node : {body.spine, body.thighs[0], body.thighs[1], body.feet[0]}) {
    const NodeIndex above = body.scene.nodes[at(node)].parent;
    const Mat4 before = glm::inverse(body.skeleton.bind[at(above)]) * body.skeleton.bind[at(node)];
    const Mat4 now = glm::inverse(pose.worlds[at(above)]) * pose.worlds[at(node)];
    CHECK(glm::length(positionOf(before) - positionOf(now)) < 1e-9);
    CHECK(unequal(rotationOf(before), rotationOf(now)) < 1e-7);
  }
  CHECK(glm::length(posedPlace(pose, body.hips) - positionOf(body.skeleton.bind[at(body.hips)])) < 1e-12);
}

TEST_CASE("A body below a mirror is posed as the same one without") {
  const Stander plain(1.0);
  Stander mirrored(1.0);
  // The axes of all below the mirror are mirrored too: the joints stand where they stood.
  for (Node& node : mirrored.scene.nodes) {
    const bool isMirror = !node.parent.exists();
    node.rest.scale.x = isMirror ? -1.0 : 1.0;
    node.rest.translation.x *= isMirror ? 1.0 : -1.0;
  }
  mirrored.bindAsAtRest();
  const auto posed = [](const Stander& body) {
    const std::vector<JointPair> pairs = body.pairsOf({body.hips, body.spine, body.shins[0]});
    std::vector<Quat> turns;
    turns.reserve(pairs.size());
    for (const JointPair& pair : pairs) {
      turns.push_back(axisAngle(Vec3(1, 2, 3), 0.4 * static_cast<double>(turns.size() + 1)) *
                      rotationOf(body.skeleton.bind[at(pair.joint)]));
    }
    const BodyPoser poser(body.skeleton, pairs);
    return poser.pose(turns, Vec3(0.1, 0.2, 0.3), {});
  };
  const BodyPose wanted = posed(plain);
  const BodyPose pose = posed(mirrored);
  for (std::size_t node = 0; node < plain.scene.nodes.size(); ++node) {
    CHECK(glm::length(posedPlace(pose, NodeIndex(node)) - posedPlace(wanted, NodeIndex(node))) < 1e-9);
  }
}

TEST_CASE("The carrier is shifted in the world, with all that hangs on it and nothing else") {
  const Stander body(GENERATE(1.0, 0.01, 7.0));
  const BodyPoser poser(body.skeleton, body.pairsOf({body.hips}));
  const Vec3 shift(0.3, -0.2, 0.5);
  const Quat stays = rotationOf(body.skeleton.bind[at(body.hips)]);
  const BodyPose pose = poser.pose({stays}, shift, {});
  for (std::size_t node = 0; node < body.scene.nodes.size(); ++node) {
    const bool isCarried = node != at(body.space) && node != at(body.feet[1]);
    const Vec3 wanted = positionOf(body.skeleton.bind[node]) + (isCarried ? shift : Vec3(0.0));
    CHECK(glm::length(posedPlace(pose, NodeIndex(node)) - wanted) < 1e-9);
  }
}

TEST_CASE("A foot that hangs beside its leg comes to its place, one on its leg goes where that takes it") {
  const Stander body(GENERATE(1.0, 0.01, 7.0));
  const BodyPoser poser(body.skeleton, {});
  const Vec3 left(0.7, 0.1, 0.2), right(-0.6, 0.3, 0.4);
  const BodyPose pose = poser.pose({}, Vec3(0.0), {left, right});
  CHECK(glm::length(posedPlace(pose, body.feet[1]) - right) < 1e-9);
  CHECK(glm::length(posedPlace(pose, body.feet[0]) - positionOf(body.skeleton.bind[at(body.feet[0])])) <
        1e-9);
  const BodyPose loose = poser.pose({}, Vec3(0.0), {left, std::nullopt});
  CHECK(glm::length(posedPlace(loose, body.feet[1]) - positionOf(body.skeleton.bind[at(body.feet[1])])) <
        1e-9);
}

TEST_CASE("Tracks of poses take joints to their places, within the tolerance and in any units") {
  const double unit = GENERATE(1.0, 0.01, 7.0);
  const Stander body(unit);
  const BodyPoser poser(body.skeleton, body.pairsOf({body.hips, body.thighs[1]}));
  std::vector<BodyPose> poses;
  const std::vector<float> times = timesOf(40);
  const Quat stays = rotationOf(body.skeleton.bind[at(body.hips)]);
  const Quat hangs = rotationOf(body.skeleton.bind[at(body.thighs[1])]);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double phase = 0.2 * static_cast<double>(i);
    const Vec3 way(0.0, 0.05 * std::sin(phase), 0.02 * static_cast<double>(i));
    const Vec3 foot(-0.1, 0.1 + 0.1 * std::sin(2.0 * phase), 0.03 * static_cast<double>(i));
    poses.push_back(poser.pose({stays, axisAngle(Vec3(1, 0, 0), 0.6 * std::sin(phase)) * hangs}, way,
                               {std::nullopt, foot}));
  }
  const double tolerance = GENERATE(0.001, 0.01);
  const std::vector<Track> tracks = poser.tracks(times, poses, tolerance);
  const Clip clip = clipWith(tracks);
  double farthest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::vector<Mat4> worlds =
        worldMatrices(body.scene, samplePose(body.scene, clip, static_cast<double>(times[i])));
    for (const NodeIndex node : {body.hips, body.chest, body.feet[1], body.feet[0]}) {
      farthest = std::max(farthest, glm::length(positionOf(worlds[at(node)]) - posedPlace(poses[i], node)));
    }
    // The shin hangs on two of them.
    CHECK(glm::length(positionOf(worlds[at(body.shins[1])]) - posedPlace(poses[i], body.shins[1])) <
          2.0 * tolerance);
  }
  CHECK(farthest < 1.01 * tolerance);
  CHECK(farthest > 0.3 * tolerance); // And no more keys than that needs.
  CAPTURE(unit);
  for (const auto& [node, channel] : {std::pair(body.hips, Channel::translation),
                                      {body.feet[1], Channel::translation},
                                      {body.thighs[1], Channel::rotation}}) {
    const Track* const track = trackFor(tracks, node, channel);
    REQUIRE(track != nullptr);
    CHECK(track->times.size() > 4);
    CHECK(track->times.size() < times.size());
  }
  CHECK(trackFor(tracks, body.hips, Channel::rotation)->times.size() <= 2); // It keeps its turn.
  for (const NodeIndex node : {body.space, body.spine, body.chest, body.feet[0], body.shins[0]}) {
    CHECK(trackFor(tracks, node, Channel::rotation) == nullptr);
    CHECK(trackFor(tracks, node, Channel::translation) == nullptr);
  }
}

TEST_CASE("A joint that the clip leaves alone is keyed with its bind pose where that is not how it rests") {
  Stander body(GENERATE(1.0, 0.01));
  const Vec3 chestBound = positionOf(body.skeleton.bind[at(body.chest)]);
  Node& spine = body.scene.nodes[at(body.spine)];
  Node& shin = body.scene.nodes[at(body.shins[0])];
  Node& thigh = body.scene.nodes[at(body.thighs[1])]; // No joint of the skin.
  Node& hips = body.scene.nodes[at(body.hips)];
  spine.rest.rotation = axisAngle(Vec3(0, 0, 1), 0.3);
  thigh.rest.rotation = axisAngle(Vec3(0, 0, 1), 0.3);
  shin.rest.translation *= 1.1;
  hips.rest.translation *= 1.2;
  const BodyPoser poser(body.skeleton, body.pairsOf({body.shins[0]}));
  const Quat hangs = rotationOf(body.skeleton.bind[at(body.shins[0])]);
  const std::vector<float> times = timesOf(3);
  const BodyPose pose = poser.pose({hangs}, Vec3(0.0), {});
  const std::vector<Track> tracks = poser.tracks(times, {pose, pose, pose}, 0.001);
  CHECK(trackFor(tracks, body.spine, Channel::rotation) != nullptr);
  CHECK(trackFor(tracks, body.spine, Channel::translation) == nullptr);
  CHECK(trackFor(tracks, body.shins[0], Channel::translation) != nullptr);
  CHECK(trackFor(tracks, body.thighs[1], Channel::rotation) == nullptr);
  const auto count = [&](NodeIndex node, Channel channel) {
    return std::ranges::count_if(
        tracks, [&](const Track& track) { return track.node == node && track.channel == channel; });
  };
  CHECK(count(body.hips, Channel::translation) == 1); // The carrier's, which are its places.
  CHECK(count(body.shins[0], Channel::rotation) == 1);
  const std::vector<Mat4> worlds = worldMatrices(body.scene, samplePose(body.scene, clipWith(tracks), 0.0));
  CHECK(glm::length(positionOf(worlds[at(body.chest)]) - chestBound) < 1e-6);
  CHECK(glm::length(positionOf(worlds[at(body.feet[0])]) - positionOf(body.skeleton.bind[at(body.feet[0])])) <
        1e-6);
}
