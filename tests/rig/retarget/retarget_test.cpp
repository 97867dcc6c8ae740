#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/retarget/copy_tracks.h"
#include "rig/retarget/retarget.h"
#include "rig/retarget/thin_keys.h"
#include "tests/support/rig/boxed_biped.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using test::MovingBiped;

namespace {

MovingBiped bodyOf(const test::BodyOptions& options = {}) {
  return test::still(test::namedBody(options));
}

// The arms hang down by 45 degrees in the bind pose.
MovingBiped loweredArms() {
  test::SyntheticBiped body = test::namedBody();
  for (const std::string side : {".l", ".r"}) {
    const Vec3 shoulder = test::jointOf(body, "upperArm" + side).position;
    for (test::SyntheticJoint& joint : body.joints) {
      const double out = std::abs(joint.position.x) - std::abs(shoulder.x);
      const bool isArm = out > 1e-9 && joint.position.y > 1.0 && joint.key.ends_with(side);
      if (isArm) {
        const double share = std::sqrt(0.5);
        const double sign = joint.position.x < 0.0 ? -1.0 : 1.0;
        joint.position = {shoulder.x + sign * share * out,
                          shoulder.y - share * out + joint.position.y - shoulder.y, joint.position.z};
      }
    }
  }
  return test::still(body);
}

// Shoulders farther out than the body's.
MovingBiped broadShoulders() {
  constexpr double farther = 0.12;
  test::SyntheticBiped body = test::namedBody();
  for (test::SyntheticJoint& joint : body.joints) {
    const bool isArm = std::abs(joint.position.x) > 0.1 && joint.position.y > 1.0;
    joint.position.x += isArm ? std::copysign(farther, joint.position.x) : 0.0;
  }
  return test::still(body);
}

// From a T-pose both hands come together in front of the chest within a second.
MovingBiped choppingBiped(const test::BodyOptions& options) {
  MovingBiped moving = bodyOf(options);
  for (const std::string side : {".l", ".r"}) {
    const double sign = side == ".l" ? 1.0 : -1.0;
    const Quat forwards = axisAngle(Vec3(0.0, 1.0, 0.0), -sign * 1.75);
    moving.clip.tracks.emplace_back(test::rotationTrack(moving.node.at("upperArm" + side),
                                                        Interpolation::linear,
                                                        {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, forwards}}));
  }
  setEndsFromKeys(moving.clip);
  return moving;
}

// Knees bend within a second, the feet stay where they are and as they are.
MovingBiped squattingBiped() {
  constexpr double bent = 0.6;
  MovingBiped moving = bodyOf();
  for (const std::string side : {".l", ".r"}) {
    for (const auto& [key, angle] :
         {std::pair("thigh", -bent), std::pair("shin", 2.0 * bent), std::pair("foot", -bent)}) {
      moving.clip.tracks.emplace_back(test::rotationTrack(
          moving.node.at(key + side), Interpolation::linear,
          {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, axisAngle(Vec3(1.0, 0.0, 0.0), angle)}}));
    }
  }
  const auto ankle = [&](double seconds) {
    return endPosition(moving.limb("left-leg"),
                       worldMatrices(moving.scene, samplePose(moving.scene, moving.clip, seconds)));
  };
  const NodeIndex hips = moving.node.at("hips");
  test::VectorKeys keys;
  for (int i = 0; i <= 24; ++i) {
    const double seconds = static_cast<double>(i) / 24.0;
    keys.emplace_back(seconds, moving.scene.nodes[at(hips)].rest.translation + ankle(0.0) - ankle(seconds));
  }
  moving.clip.tracks.emplace_back(test::vectorTrack(hips, Channel::translation, Interpolation::linear, keys));
  setEndsFromKeys(moving.clip);
  return moving;
}

Clip brought(const MovingBiped& from, const MovingBiped& to) {
  const std::optional<Skeleton> source = skeletonOf(from.scene, from.body);
  const std::optional<Skeleton> own = skeletonOf(to.scene, to.body);
  REQUIRE(source);
  REQUIRE(own);
  Result<Retargeted> result = retarget(*source, from.clip, *own);
  REQUIRE(result);
  return result->clip;
}

std::vector<Mat4> worldsAt(const MovingBiped& moving, const Clip& clip, double seconds) {
  return worldMatrices(moving.scene, samplePose(moving.scene, clip, seconds));
}

Vec3 boneOf(const MovingBiped& moving, const Clip& clip, const std::string& limb, std::size_t bone,
            double seconds) {
  const std::vector<Vec3> points = limbPoints(moving.limb(limb), worldsAt(moving, clip, seconds));
  return points[bone + 1] - points[bone];
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  return angleBetween(a, b) * 180.0 / pi;
}

} // namespace

TEST_CASE("A clip that is brought to the same skeleton moves it as before") {
  const MovingBiped moving = test::punchingBiped();
  const Clip clip = brought(moving, moving);
  for (double seconds = 0.0; seconds <= 1.0; seconds += 1.0 / 24.0) {
    const std::vector<Mat4> before = worldsAt(moving, moving.clip, seconds);
    const std::vector<Mat4> after = worldsAt(moving, clip, seconds);
    for (const Limb& limb : moving.body.limbs) {
      CHECK(glm::length(endPosition(limb, after) - endPosition(limb, before)) < 0.01 * moving.body.height);
    }
  }
}

TEST_CASE("Arms that hang down in the bind pose point where the source's arms point") {
  const MovingBiped moving = test::punchingBiped();
  const MovingBiped other = loweredArms();
  REQUIRE(degreesBetween(boneOf(moving, {}, "left-arm", 0, 0.0), boneOf(other, {}, "left-arm", 0, 0.0)) >
          40.0);
  const Clip clip = brought(moving, other);
  for (const std::string limb : {"left-arm", "right-arm"}) {
    for (double seconds = 0.0; seconds <= 1.0; seconds += 0.125) {
      for (const std::size_t bone : {0U, 1U}) {
        CHECK(degreesBetween(boneOf(moving, moving.clip, limb, bone, seconds),
                             boneOf(other, clip, limb, bone, seconds)) < 0.5);
      }
    }
  }
}

TEST_CASE("Bones keep their lengths, and the body travels by the ratio of the legs") {
  const MovingBiped moving = test::punchingBiped();
  test::SyntheticBiped large = test::namedBody();
  large.armatureScale = 2.0;
  for (test::SyntheticJoint& joint : large.joints) {
    joint.position *= 2.0;
  }
  const MovingBiped other = test::still(large);
  const Clip clip = brought(moving, other);
  const double ratio = other.limb("left-leg").restLength / moving.limb("left-leg").restLength;
  const auto hips = [](const MovingBiped& body, const Clip& of, double seconds) {
    return positionOf(worldsAt(body, of, seconds)[at(body.body.hips)]);
  };
  for (double seconds = 0.25; seconds <= 1.0; seconds += 0.25) {
    const Vec3 travel = hips(moving, moving.clip, seconds) - hips(moving, moving.clip, 0.0);
    const Vec3 own = hips(other, clip, seconds) - hips(other, clip, 0.0);
    CHECK(glm::length(own - ratio * travel) < 0.01 * other.body.height);
    CHECK(glm::length(boneOf(other, clip, "left-arm", 0, seconds)) ==
          Approx(glm::length(boneOf(other, {}, "left-arm", 0, 0.0))).epsilon(1e-4));
  }
}

TEST_CASE("A spine of other joints turns as much in all, and a character that faces back moves backwards") {
  const MovingBiped moving = test::punchingBiped();
  test::SyntheticBiped turned = test::namedBody({.spineJoints = 5});
  turned.facesBackwards = true;
  const MovingBiped other = test::still(turned);
  const Clip clip = brought(moving, other);
  const Vec3 punch = boneOf(moving, moving.clip, "left-arm", 0, 0.5);
  const Vec3 own = boneOf(other, clip, "left-arm", 0, 0.5);
  CHECK(degreesBetween(own, Vec3(-punch.x, punch.y, -punch.z)) < 0.5);
}

TEST_CASE("The clip begins and ends with the source's keys, and its joints are keyed linearly") {
  MovingBiped moving = test::punchingBiped();
  const Clip clip = brought(moving, bodyOf());
  float first = 1e9F;
  float last = -1e9F;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    CHECK(track->interpolation == Interpolation::linear);
    first = std::min(first, track->times.front());
    last = std::max(last, track->times.back());
  }
  CHECK(first == Approx(0.0));
  CHECK(last == Approx(1.0));
}

TEST_CASE("A clip of one key becomes a pose") {
  MovingBiped moving = test::punchingBiped();
  for (CopyOnWrite<Track>& track : moving.clip.tracks) {
    track.edit([](Track& edited) {
      edited.times.resize(1);
      edited.values.resize(static_cast<std::size_t>(edited.width));
    });
  }
  moving.clip.endSeconds = moving.clip.startSeconds;
  for (const CopyOnWrite<Track>& track : brought(moving, bodyOf()).tracks) {
    CHECK(track->times.size() == 1);
  }
}

TEST_CASE("Hands that work together in the source are as many shoulder widths apart on other arms, and "
          "others are left alone") {
  const MovingBiped source = choppingBiped({});
  const MovingBiped target = broadShoulders();
  const Clip clip = brought(source, target);
  const auto apart = [](const MovingBiped& moving, const Clip& played, double seconds) {
    const std::vector<Mat4> worlds = worldsAt(moving, played, seconds);
    const std::vector<Mat4> bind = worldsAt(moving, Clip{}, 0.0);
    const Vec3 shoulders = positionOf(bind[at(moving.limb("right-arm").joints.front())]) -
                           positionOf(bind[at(moving.limb("left-arm").joints.front())]);
    return (endPosition(moving.limb("right-arm"), worlds) - endPosition(moving.limb("left-arm"), worlds)) /
           glm::length(shoulders);
  };
  REQUIRE(glm::length(apart(source, source.clip, 1.0)) < 0.75);
  REQUIRE(glm::length(apart(source, source.clip, 0.0)) > 2.0);
  CHECK(glm::length(apart(target, clip, 1.0) - apart(source, source.clip, 1.0)) < 0.01);
  const Clip alone = brought(test::still(test::namedBody()), target);
  CHECK(glm::length(apart(target, clip, 0.0) - apart(target, alone, 0.0)) < 0.01);
  for (const char* limb : {"left-arm", "right-arm"}) {
    for (const std::size_t bone : {0U, 1U}) {
      CHECK(glm::length(boneOf(target, clip, limb, bone, 1.0)) ==
            Approx(glm::length(boneOf(target, alone, limb, bone, 0.0))).epsilon(1e-3));
    }
  }
}

TEST_CASE("A foot that the source lacks is level while its shin leans, and follows the shin in the air") {
  MovingBiped source = bodyOf({.feet = false, .toes = false});
  const MovingBiped target = bodyOf();
  const auto levelOff = [&](const Clip& clip) {
    const std::vector<Mat4> worlds = worldsAt(target, clip, 1.0);
    const std::vector<Mat4> bind = worldsAt(target, Clip{}, 0.0);
    const NodeIndex foot = target.limb("left-leg").endNode;
    const Vec3 up(0.0, 1.0, 0.0);
    return degreesBetween(rotationOf(worlds[at(foot)]) * glm::inverse(rotationOf(bind[at(foot)])) * up, up);
  };
  const auto turned = [&](double thigh, double shin) {
    MovingBiped moving = source;
    for (const auto& [key, angle] : {std::pair("thigh.l", thigh), std::pair("shin.l", shin)}) {
      moving.clip.tracks.emplace_back(test::rotationTrack(
          moving.node.at(key), Interpolation::linear,
          {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, axisAngle(Vec3(1.0, 0.0, 0.0), angle)}}));
    }
    setEndsFromKeys(moving.clip);
    return brought(moving, target);
  };
  CHECK(levelOff(turned(-0.35, 0.7)) < 12.0);
  CHECK(levelOff(turned(-1.4, 0.2)) > 45.0);
}

TEST_CASE("Feet stand where the source's stand, and slide where they are only mapped") {
  const MovingBiped source = squattingBiped();
  test::SyntheticBiped lowKnees = test::namedBody();
  for (const std::string side : {".l", ".r"}) {
    test::jointOf(lowKnees, "shin" + side).position.y = 0.35;
  }
  const MovingBiped target = test::still(lowKnees);
  const std::optional<Skeleton> from = skeletonOf(source.scene, source.body);
  const std::optional<Skeleton> own = skeletonOf(target.scene, target.body);
  REQUIRE((from && own));
  const auto wander = [&](Correction correction) {
    const Result<Retargeted> result = retarget(*from, source.clip, *own, {}, correction);
    REQUIRE(result);
    double farthest = 0.0;
    for (double seconds = 0.0; seconds <= 1.0; seconds += 1.0 / 48.0) {
      const Vec3 way = own->legs[leftSide].ball(worldsAt(target, result->clip, seconds)) -
                       own->legs[leftSide].ball(worldsAt(target, result->clip, 0.0));
      farthest = std::max(farthest, std::hypot(way.x, way.z));
    }
    return farthest / own->height;
  };
  CHECK(wander(Correction::feetAndHands) < 0.002);
  CHECK(wander(Correction::none) > 0.02);
}

TEST_CASE("What the character has no joints for is told") {
  const MovingBiped moving = test::punchingBiped();
  const MovingBiped other = bodyOf({.toes = false, .fingers = false});
  const std::optional<Skeleton> source = skeletonOf(moving.scene, moving.body);
  const std::optional<Skeleton> own = skeletonOf(other.scene, other.body);
  REQUIRE((source && own));
  const Result<Retargeted> result = retarget(*source, moving.clip, *own);
  REQUIRE(result);
  CHECK(std::ranges::find(result->left, "toes") != result->left.end());
}

TEST_CASE("Few keys tell what many told, within the tolerance") {
  std::vector<float> times;
  std::vector<Quat> turns;
  for (int i = 0; i <= 100; ++i) {
    times.push_back(static_cast<float>(i) / 24.0F);
    turns.push_back(axisAngle(Vec3(0, 1, 0), i < 50 ? 0.01 * i : 0.5));
  }
  const Track track = thinTurns(NodeIndex(3), times, turns, 1e-3);
  CHECK(track.times.size() <= 4);
  for (std::size_t i = 0; i < times.size(); ++i) {
    double q[4];
    sampleTrack(track, times[i], q);
    const Quat sampled(q[3], q[0], q[1], q[2]);
    CHECK(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(sampled, turns[i])))) < 2e-3);
  }
  CHECK(thinTurns(NodeIndex(3), times, std::vector<Quat>(times.size(), turns[7]), 1e-3).times.size() == 1);
}

TEST_CASE("Tracks go to the joints of the same names, key for key, and missing joints are named") {
  const MovingBiped moving = test::punchingBiped();
  MovingBiped other = bodyOf();
  const NodeIndex lost = moving.node.at("foreArm.l");
  const std::string name = moving.scene.nodes[at(lost)].name;
  other.scene.nodes[at(other.node.at("foreArm.l"))].name = "elsewhere";
  const CopiedTracks copied = copyTracks(moving.scene, moving.clip, other.scene);
  CHECK(copied.missing == std::vector<std::string>{name});
  const NodeIndex arm = moving.node.at("upperArm.l");
  const int from = findTrack(moving.clip, arm, Channel::rotation);
  const int to = findTrack(copied.clip, other.node.at("upperArm.l"), Channel::rotation);
  REQUIRE((from >= 0 && to >= 0));
  CHECK(copied.clip.tracks[at(to)]->values == moving.clip.tracks[at(from)]->values);
  CHECK(copied.clip.tracks[at(to)]->times == moving.clip.tracks[at(from)]->times);
}

TEST_CASE("A copied track follows the name of its joint, wherever that stands in the file") {
  const MovingBiped moving = test::punchingBiped();
  MovingBiped other = bodyOf();
  const NodeIndex left = moving.node.at("upperArm.l");
  const NodeIndex right = moving.node.at("upperArm.r");
  std::swap(other.scene.nodes[at(left)].name, other.scene.nodes[at(right)].name);
  const CopiedTracks copied = copyTracks(moving.scene, moving.clip, other.scene);
  const int from = findTrack(moving.clip, left, Channel::rotation);
  const int to = findTrack(copied.clip, right, Channel::rotation);
  REQUIRE((from >= 0 && to >= 0));
  CHECK(copied.clip.tracks[at(to)]->values == moving.clip.tracks[at(from)]->values);
}

TEST_CASE("Bones of the same names and other lengths are not the same bones") {
  const MovingBiped moving = test::punchingBiped();
  CHECK(haveSameBones(moving.scene, moving.clip, bodyOf().scene));
  test::SyntheticBiped large = test::namedBody();
  for (test::SyntheticJoint& joint : large.joints) {
    joint.position *= 1.5;
  }
  CHECK_FALSE(haveSameBones(moving.scene, moving.clip, test::still(large).scene));
}

TEST_CASE(
    "Bones are the same within a twentieth of the longer one's length, and where none can be compared") {
  const MovingBiped moving = test::punchingBiped();
  const auto isSame = [&](double size) {
    test::SyntheticBiped sized = test::namedBody();
    for (test::SyntheticJoint& joint : sized.joints) {
      joint.position *= size;
    }
    return haveSameBones(moving.scene, moving.clip, test::still(sized).scene);
  };
  CHECK(isSame(1.052));
  CHECK_FALSE(isSame(1.054));
  CHECK(isSame(0.951));
  CHECK_FALSE(isSame(0.949));
  CHECK(haveSameBones(moving.scene, Clip{}, moving.scene));
}

TEST_CASE("What the clip does not move stands as in the bind pose, where the file has it otherwise at rest") {
  test::SyntheticBiped body = test::namedBody({.tips = true});
  test::addTwist(body, "twist", "upperArm.l", "foreArm.l", 0.5, false);
  body.posedAtRest = true;
  const MovingBiped to = test::still(body);
  MovingBiped from = bodyOf();
  const NodeIndex arm = from.node.at("upperArm.r");
  from.clip.tracks.emplace_back(test::rotationTrack(
      arm, Interpolation::linear, {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, axisAngle(Vec3(0, 1, 0), 0.6)}}));
  setEndsFromKeys(from.clip);
  const Clip clip = brought(from, to);
  const std::vector<Mat4> bind = bindPoseWorlds(to.scene);
  const std::vector<Mat4> worlds = worldsAt(to, clip, 1.0);
  for (const char* const key :
       {"twist", "headTip", "toeTip.l", "toeTip.r", "foreArm.l", "hand.l", "shin.r"}) {
    CAPTURE(key);
    const auto node = at(to.node.at(key));
    const auto parent = at(to.scene.nodes[node].parent);
    const Mat4 inBind = glm::inverse(bind[parent]) * bind[node];
    const Mat4 now = glm::inverse(worlds[parent]) * worlds[node];
    for (int column = 0; column < 4; ++column) {
      CHECK(glm::length(inBind[column] - now[column]) < 2e-3);
    }
  }
}

TEST_CASE("A clip that ends between two frames is brought to its end, and its last frame too") {
  const double start = GENERATE(0.0, 0.26);
  MovingBiped from = bodyOf();
  const NodeIndex arm = from.node.at("upperArm.l");
  const double end = start + 10.377 / 24.0; // beside the frames of faster rates, too
  const double lastFrame = start + 10.0 / 24.0;
  from.clip.tracks.emplace_back(test::rotationTrack(arm, Interpolation::linear,
                                                    {{start, Quat(1.0, 0.0, 0.0, 0.0)},
                                                     {lastFrame, axisAngle(Vec3(0, 1, 0), -1.2)},
                                                     {end, axisAngle(Vec3(0, 1, 0), -0.9)}}));
  setEndsFromKeys(from.clip);
  const MovingBiped to = bodyOf({.spineJoints = 4});
  const Clip clip = brought(from, to);
  const int index = findTrack(clip, to.node.at("upperArm.l"), Channel::rotation);
  REQUIRE(index >= 0);
  const Track& track = *clip.tracks[at(index)];
  CHECK(static_cast<double>(track.times.front()) == Approx(start).margin(1e-6));
  CHECK(static_cast<double>(track.times.back()) == Approx(end).margin(1e-6));
  for (const double time : {lastFrame, end}) {
    CAPTURE(start, time);
    CHECK(degreesBetween(boneOf(from, from.clip, "left-arm", 0, time),
                         boneOf(to, clip, "left-arm", 0, time)) < 0.1);
  }
}

TEST_CASE("A clip of few frames in each second is followed between its frames, too") {
  MovingBiped from = bodyOf();
  from.clip.framesPerSecond = 8.0;
  const double between = 1.0 / 24.0;
  const Quat level(1.0, 0.0, 0.0, 0.0);
  from.clip.tracks.emplace_back(test::rotationTrack(
      from.node.at("upperArm.l"), Interpolation::linear,
      {{0.0, level}, {between, axisAngle(Vec3(0, 1, 0), -1.2)}, {2.0 * between, level}, {1.0, level}}));
  setEndsFromKeys(from.clip);
  const MovingBiped to = bodyOf();
  const Clip clip = brought(from, to);
  REQUIRE(degreesBetween(boneOf(from, from.clip, "left-arm", 0, between), Vec3(1, 0, 0)) > 60.0);
  for (const double time : {0.0, between, 2.0 * between, 0.125}) {
    CAPTURE(time);
    CHECK(degreesBetween(boneOf(from, from.clip, "left-arm", 0, time),
                         boneOf(to, clip, "left-arm", 0, time)) < 0.5);
  }
}

TEST_CASE("A character that lies in its bind pose stands up where the source stands") {
  const MovingBiped from = bodyOf();
  MovingBiped lying = test::bareBiped(test::namedBody());
  lying.scene.skins.clear();
  lying.scene.nodes.front().rest.rotation = axisAngle(Vec3(1, 0, 0), -0.5 * pi);
  const auto trunkOf = [](const MovingBiped& body, const Clip& clip) {
    const std::vector<Mat4> worlds = worldsAt(body, clip, 0.0);
    return positionOf(worlds[at(body.body.head)]) - positionOf(worlds[at(body.body.hips)]);
  };
  REQUIRE(degreesBetween(trunkOf(lying, {}), Vec3(0, 1, 0)) > 80.0);
  // What lies is turned by its line from the feet to the head, which leans a little here.
  CHECK(degreesBetween(trunkOf(lying, brought(from, lying)), trunkOf(from, {})) < 3.0);
}

TEST_CASE("Copied morph weights go to a mesh with as many targets, and to no other") {
  const auto sceneWith = [](int targets, bool hasMesh) {
    Scene scene;
    Node node;
    node.name = "Face";
    if (hasMesh) {
      Primitive primitive;
      primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      primitive.morphTargets.resize(static_cast<std::size_t>(targets));
      scene.meshes.push_back({"face", {primitive, primitive}, {}});
      node.mesh = 0;
    }
    scene.nodes.push_back(node);
    scene.roots = {NodeIndex(0)};
    return scene;
  };
  Clip clip;
  Track weights;
  weights.node = NodeIndex(0);
  weights.channel = Channel::weights;
  weights.width = 2;
  weights.times = {0.0F, 1.0F};
  weights.values = {0.0F, 1.0F, 1.0F, 0.0F};
  clip.tracks.emplace_back(weights);
  setEndsFromKeys(clip);
  const Scene from = sceneWith(2, true);
  const CopiedTracks same = copyTracks(from, clip, sceneWith(2, true));
  REQUIRE(same.clip.tracks.size() == 1);
  CHECK(same.joints == 1);
  CHECK(same.clip.tracks.front()->values == weights.values);
  CHECK(same.missing.empty());
  for (const Scene& to : {sceneWith(1, true), sceneWith(3, true), sceneWith(2, false)}) {
    const CopiedTracks none = copyTracks(from, clip, to);
    CHECK(none.clip.tracks.empty());
    CHECK(none.joints == 0);
    CHECK(none.missing == std::vector<std::string>{"Face"});
  }
}
