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

} // namespace

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
