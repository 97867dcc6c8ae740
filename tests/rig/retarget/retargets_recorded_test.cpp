#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "rig/retarget/copy_tracks.h"
#include "rig/retarget/retarget.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct Built {
  const char* title;
  SyntheticBiped body;
};

void turnArms(SyntheticBiped& body, double down) {
  for (const std::string side : {".l", ".r"}) {
    const Vec3 shoulder = jointOf(body, "upperArm" + side).position;
    const double sign = side == ".l" ? -1.0 : 1.0;
    const Quat turn = axisAngle(Vec3(0.0, 0.0, 1.0), sign * down);
    for (SyntheticJoint& joint : body.joints) {
      const bool isArm =
          joint.key.ends_with(side) && joint.position.y > 1.0 && joint.key != "clavicle" + side;
      joint.position = isArm ? shoulder + turn * (joint.position - shoulder) : joint.position;
    }
  }
}

std::vector<Built> bodies() {
  SyntheticBiped lowered = namedBody();
  turnArms(lowered, 0.7);
  SyntheticBiped broad = namedBody();
  SyntheticBiped longLegs = namedBody();
  for (SyntheticJoint& joint : broad.joints) {
    joint.position.x *= joint.position.y > 1.0 ? 1.4 : 1.0;
  }
  for (SyntheticJoint& joint : longLegs.joints) {
    joint.position.y = joint.position.y < 0.95 ? 1.5 * joint.position.y : joint.position.y + 0.47;
  }
  SyntheticBiped backwards = namedBody();
  backwards.facesBackwards = true;
  SyntheticBiped large = namedBody();
  large.size = 3.0;
  large.posedAtRest = true;
  return {{"as usual", namedBody()},
          {"arms lowered", lowered},
          {"broad", broad},
          {"long legs", longLegs},
          {"facing back", backwards},
          {"large, posed at rest", large},
          {"no fingers, one spine joint", namedBody({.spineJoints = 1, .fingers = false})},
          {"no clavicles, no toes",
           namedBody({.spineJoints = 4, .neckJoints = 2, .clavicles = false, .toes = false})}};
}

/// Everything turns a little, the hips travel, hands come together before the chest at the end.
MovingBiped moved(const SyntheticBiped& body, std::uint32_t seed) {
  MovingBiped moving = still(body);
  Row row(seed);
  const double facing = body.facesBackwards ? -1.0 : 1.0;
  for (const auto& [key, node] : moving.node) {
    const Quat turn = axisAngle(glm::normalize(row.vector(1.0)), row.around(0.5));
    const Quat rest = moving.scene.nodes[at(node)].rest.rotation;
    moving.clip.tracks.emplace_back(rotationTrack(
        node, Interpolation::linear, {{0.0, rest}, {0.5, rest * turn}, {1.0, rest * turn * turn}}));
  }
  const NodeIndex hips = moving.node.at("hips");
  const Vec3 place = moving.scene.nodes[at(hips)].rest.translation;
  const Vec3 travel = body.size * Vec3(0.3, 0.1, 0.6 * facing);
  moving.clip.tracks.emplace_back(
      vectorTrack(hips, Channel::translation, Interpolation::linear, {{0.0, place}, {1.0, place + travel}}));
  setEndsFromKeys(moving.clip);
  return moving;
}

std::string vectorText(const Vec3& value) {
  return fmt::format(" {:.4f} {:.4f} {:.4f}", value.x, value.y, value.z);
}

std::string broughtText(const MovingBiped& from, const MovingBiped& to) {
  const std::optional<Skeleton> source = skeletonOf(from.scene, from.body);
  const std::optional<Skeleton> own = skeletonOf(to.scene, to.body);
  if (!source || !own) {
    return fmt::format("  no skeleton: {} {}\n", source.has_value(), own.has_value());
  }
  const Result<Retargeted> brought = retarget(*source, from.clip, *own);
  if (!brought) {
    return "  refused: " + brought.error().line() + "\n";
  }
  std::size_t keys = 0;
  for (const CopyOnWrite<Track>& track : brought->clip.tracks) {
    keys += track->times.size();
  }
  std::string text = fmt::format("  {} tracks , {} keys , same bones {} , left", brought->clip.tracks.size(),
                                 keys, haveSameBones(from.scene, from.clip, to.scene));
  for (const std::string& part : brought->left) {
    text += " " + part;
  }
  text += "\n";
  for (const double seconds : {0.0, 0.5, 1.0}) {
    const FrameState frame = frameOf(to.scene, samplePose(to.scene, brought->clip, seconds), seconds);
    text += fmt::format("  {} s : hips", seconds) + vectorText(Vec3(frame.worlds[at(to.body.hips)][3]));
    for (const Limb& limb : to.body.limbs) {
      text += " , " + limb.id + vectorText(endPosition(limb, frame.worlds));
      if (limb.endNode.exists()) {
        const Quat turn = rotationOf(frame.worlds[at(limb.endNode)]);
        text += " turned" + vectorText((turn.w < 0.0 ? -1.0 : 1.0) * Vec3(turn.x, turn.y, turn.z));
      }
    }
    text += "\n";
  }
  return text;
}

/// Fingers that names tell, the hands turned so far about the arms.
SyntheticBiped withNamedFingers(double radians) {
  SyntheticBiped body = namedBody();
  const std::map<std::string, std::string> fingers{
      {"finger0", "Index"}, {"finger1", "Middle"}, {"finger2", "Pinky"}};
  for (SyntheticJoint& joint : body.joints) {
    const auto finger = fingers.find(joint.key.substr(0, std::min<std::size_t>(7, joint.key.size())));
    if (finger == fingers.end()) {
      continue;
    }
    const bool isLeft = joint.key.ends_with(".l");
    const Vec3 wrist = jointOf(body, isLeft ? "hand.l" : "hand.r").position;
    joint.position =
        wrist + axisAngle(Vec3(1, 0, 0), isLeft ? radians : -0.5 * radians) * (joint.position - wrist);
    body.names[joint.key] = std::string("mixamorig:") + (isLeft ? "Left" : "Right") + "Hand" +
                            finger->second + (joint.key[7] == 'a' ? "1" : "2");
  }
  return body;
}

/// Steps: each foot stands while the other one swings, the hips go on and sink a little, hands meet before
/// the chest; the clip begins late and has a rate of its own.
MovingBiped steppingBiped(const SyntheticBiped& body, std::uint32_t seed) {
  MovingBiped moving = still(body);
  Row row(seed);
  moving.clip.framesPerSecond = row.oneOf(std::array{24.0, 30.0, 48.0});
  const double start = row.once(2) ? 0.0 : row.between(0.1, 0.6);
  const double facing = body.facesBackwards ? -1.0 : 1.0;
  const double wide = row.between(0.15, 0.5);
  const Vec3 sideways(facing, 0.0, 0.0);
  const auto addTurns = [&](const std::string& key, const std::vector<double>& angles) {
    if (!moving.node.contains(key)) {
      return;
    }
    const NodeIndex node = moving.node.at(key);
    const Quat rest = moving.scene.nodes[at(node)].rest.rotation;
    RotationKeys keys;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      keys.emplace_back(start + 0.25 * static_cast<double>(i), rest * axisAngle(sideways, angles[i]));
    }
    moving.clip.tracks.emplace_back(rotationTrack(node, Interpolation::linear, keys));
  };
  addTurns("thigh.l", {-wide, 0.0, wide, -wide, -wide});
  addTurns("thigh.r", {wide, -wide, -wide, 0.0, wide});
  addTurns("shin.l", {0.0, 0.05, 0.1, 1.5 * wide, 0.0});
  addTurns("shin.r", {0.1, 1.5 * wide, 0.0, 0.05, 0.1});
  addTurns("foot.l", {wide, 0.0, -0.4 * wide, 0.0, wide});
  addTurns("toe.r", {-0.3, 0.0, 0.0, 0.0, -0.3});
  addTurns("finger0a.l", {0.0, 0.6, 0.9, 0.2, 0.0});
  addTurns("spine1", {0.0, 0.2, 0.0, -0.1, 0.0});
  for (const std::string side : {".l", ".r"}) {
    const NodeIndex arm = moving.node.at("upperArm" + side);
    const Quat rest = moving.scene.nodes[at(arm)].rest.rotation;
    const double inwards = (side == ".l" ? -1.0 : 1.0) * row.between(1.0, 1.8);
    moving.clip.tracks.emplace_back(
        rotationTrack(arm, Interpolation::linear,
                      {{start, rest}, {start + 0.5, rest * axisAngle(Vec3(0, 1, 0), inwards)}}));
  }
  const NodeIndex hips = moving.node.at("hips");
  const Vec3 place = moving.scene.nodes[at(hips)].rest.translation;
  VectorKeys keys;
  for (int i = 0; i <= 8; ++i) {
    const Vec3 way(0.0, -0.05 * (i % 2), facing * 0.1 * i * wide);
    keys.emplace_back(start + 0.125 * i, place + body.size / body.armatureScale * way);
  }
  moving.clip.tracks.emplace_back(vectorTrack(hips, Channel::translation, Interpolation::linear, keys));
  setEndsFromKeys(moving.clip);
  return moving;
}

/// Every key of a clip, added up track by track.
std::string tracksText(const Clip& clip) {
  std::string text;
  int still = 0;
  double stillValues = 0.0;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    double values = 0.0;
    for (std::size_t i = 0; i < track->values.size(); ++i) {
      values += static_cast<double>(track->values[i]) * static_cast<double>(1 + i % 7);
    }
    if (track->times.size() == 1) {
      ++still;
      stillValues += values * (1.0 + 0.1 * track->node.value);
      continue;
    }
    text += fmt::format("  node {} channel {} , {} keys from {:.4f} to {:.4f} , values {:.3f}\n",
                        track->node.value, static_cast<int>(track->channel), track->times.size(),
                        track->times.front(), track->times.back(), values);
  }
  return text + fmt::format("  {} of one key , values {:.3f}\n", still, stillValues);
}

} // namespace

TEST_CASE(
    "What walks of bodies of one build become on others, with feet and hands put right or not, is as it "
    "was looked at") {
  std::string text;
  std::vector<Built> all = bodies();
  SyntheticBiped inCentimetres = namedBody({.tips = true});
  inCentimetres.armatureScale = 0.01;
  SyntheticBiped loose = namedBody({.toes = false});
  jointOf(loose, "foot.l").parent = "root";
  jointOf(loose, "foot.r").parent = "root";
  all.push_back({"under a scaled armature, with tips", inCentimetres});
  all.push_back({"feet under the root", loose});
  all.push_back({"no feet", namedBody({.feet = false})});
  all.push_back({"no hands", namedBody({.hands = false})});
  SyntheticBiped headless = namedBody();
  std::erase_if(headless.joints, [](const SyntheticJoint& joint) {
    return joint.key == "head" || joint.key.starts_with("neck");
  });
  all.push_back({"no head", headless});
  all.push_back({"palms down", withNamedFingers(0.0)});
  all.push_back({"palms ahead", withNamedFingers(1.2)});
  all.push_back({"palms back", withNamedFingers(-2.0)});
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::size_t to : {i, (i + 1) % all.size(), (i + 4) % all.size(), (i + 7) % all.size()}) {
      const MovingBiped from = steppingBiped(all[i].body, static_cast<std::uint32_t>(i + 31));
      const MovingBiped onto = still(all[to].body);
      text += fmt::format("{} on {}\n", all[i].title, all[to].title) + broughtText(from, onto);
      const std::optional<Skeleton> source = skeletonOf(from.scene, from.body);
      const std::optional<Skeleton> own = skeletonOf(onto.scene, onto.body);
      if (!source || !own) {
        continue;
      }
      const Correction correction = (i + to) % 2 == 0 ? Correction::none : Correction::feetAndHands;
      if (const auto brought = retarget(*source, from.clip, *own, {}, correction)) {
        text +=
            fmt::format("  at {} frames per second from {:.4f} to {:.4f}\n", brought->clip.framesPerSecond,
                        brought->clip.startSeconds, brought->clip.endSeconds) +
            tracksText(brought->clip);
      }
      const CopiedTracks copied = copyTracks(from.scene, from.clip, onto.scene);
      text += fmt::format("  copied onto {} joints , {} tracks\n", copied.joints, copied.clip.tracks.size());
    }
  }
  const std::string difference = differenceFromRecord("retargeted-walks", text, 2e-3);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("What clips of bodies of one build become on others is as it was looked at") {
  std::string text;
  const std::vector<Built> all = bodies();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::size_t to : {std::size_t{0}, (i + 1) % all.size(), (i + 3) % all.size()}) {
      text += fmt::format("{} on {}\n", all[i].title, all[to].title) +
              broughtText(moved(all[i].body, static_cast<std::uint32_t>(i + 1)), still(all[to].body));
    }
  }
  const std::string difference = differenceFromRecord("retargets", text, 5e-4);
  INFO(difference);
  CHECK(difference.empty());
}
