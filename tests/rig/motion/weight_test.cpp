#include "rig/limb.h"
#include "rig/reach/limb_weight.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/soft_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

Vec3 endOf(const MovingBiped& moving, const std::string& limb, const FrameState& frame) {
  return endPosition(moving.limb(limb), frame);
}

double bonesOf(const Limb& limb, const FrameState& frame) {
  const std::vector<Vec3> points = limbPoints(limb, frame);
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += glm::length(points[i] - points[i - 1]);
  }
  return sum;
}

SoftBones none(double /*frame*/) {
  return {};
}

SoftBones longer(double /*frame*/) {
  return {1.2, 0.9, 1.0, Vec3(0.3, 1.0, 0.2), 0.0};
}

SoftBones touching(double /*frame*/) {
  SoftBones bones;
  bones.kept = 1.0;
  return bones;
}

// A leg that stands and gives way more and more.
SoftBones squashed(double frame) {
  const double along = 1.0 - 0.006 * frame;
  return {along, 1.0 / std::sqrt(along), 1.0 / std::sqrt(along), Vec3(0.0, 0.0, 1.0), 1.0, 1.0};
}

} // namespace

TEST_CASE("weight that does not give way leaves every number of the clip alone") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion =
      softMotion(moving, {}, {softLimb(moving, "left-arm", none), softLimb(moving, "left-leg", none)});
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState soft = atFrame(moving, motion, frame);
    CHECK(soft.worlds == source.worlds);
    CHECK(soft.stretch.empty());
  }
}

TEST_CASE("each bone is stretched by its factors and carries the hand along") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = softMotion(moving, {}, {softLimb(moving, "left-arm", longer)});
  const Limb& arm = moving.limb("left-arm");
  for (const double frame : {0.0, 5.0, 12.0, 24.0}) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState soft = atFrame(moving, motion, frame);
    const std::vector<Vec3> before = limbPoints(arm, source);
    const std::vector<Vec3> after = limbPoints(arm, soft);
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      CHECK(glm::length(after[i + 1] - after[i] - 1.2 * (before[i + 1] - before[i])) < 1e-9);
      const Mat3& stretch = soft.stretch[at(arm.joints[i])];
      CHECK(glm::determinant(stretch) == Approx(1.2 * 0.9));
      CHECK(stretch[0][1] == Approx(stretch[1][0]).margin(1e-12));
    }
    const Mat4& hand = soft.worlds[at(arm.endNode)];
    CHECK(glm::length(Vec3(hand[0] - source.worlds[at(arm.endNode)][0])) < 1e-9);
    CHECK(glm::length(endOf(moving, "right-arm", soft) - endOf(moving, "right-arm", source)) == 0.0);
  }
}

TEST_CASE("a foot without a mesh that is below all of the body's stays as low as it is") {
  const MovingBiped moving = punchingBiped();
  MotionState motion = softMotion(moving, {}, {softLimb(moving, "left-leg", longer)});
  // Of a body of which the hips alone have a mesh.
  motion.outline.body = {moving.node.at("hips")};
  motion.outline.riding = motion.outline.body;
  motion.weights.front().ends.clear();
  for (const double frame : {0.0, 6.0, 12.0}) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState soft = atFrame(moving, motion, frame);
    CHECK(bonesOf(moving.limb("left-leg"), soft) > 1.1 * bonesOf(moving.limb("left-leg"), source));
    CHECK(endOf(moving, "left-leg", soft).y == Approx(endOf(moving, "left-leg", source).y).margin(1e-6));
  }
}

TEST_CASE("on top of a trail both stretches multiply and stay free of shear") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Trail> trails{connectedTrail("left-arm", 0, 12, 2.0)};
  const Limb& arm = moving.limb("left-arm");
  LimbWeight weight{"left-arm", {}, 0.0, 1.0, 0.0, 0.0};
  const MotionState alone = softMotion(moving, trails, {});
  for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
    weight.samples.push_back(softSample(arm, atFrame(moving, alone, frame), longer(frame)));
  }
  const MotionState both = softMotion(moving, trails, {weight});
  for (const double frame : {3.0, 12.0, 14.0}) {
    const FrameState with = atFrame(moving, both, frame);
    CHECK(lengthOf(arm, with) == Approx(1.2 * lengthOf(arm, atFrame(moving, alone, frame))));
    for (const NodeIndex joint : arm.joints) {
      const Mat3& stretch = with.stretch[at(joint)];
      for (int i = 0; i < 3; ++i) {
        CHECK(stretch[i][(i + 1) % 3] == Approx(stretch[(i + 1) % 3][i]).margin(1e-12));
      }
    }
  }
}

TEST_CASE("a leg that stands and gives way lowers the hips and keeps its foot") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = softMotion(
      moving, {}, {softLimb(moving, "right-leg", squashed), softLimb(moving, "left-leg", touching)});
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState soft = atFrame(moving, motion, frame);
    const double height = moving.body.height;
    CHECK(glm::length(endOf(moving, "right-leg", soft) - endOf(moving, "right-leg", source)) < 1e-6 * height);
    CHECK(glm::length(endOf(moving, "left-leg", soft) - endOf(moving, "left-leg", source)) < 1e-6 * height);
    const double drop = source.worlds[at(moving.body.hips)][3].y - soft.worlds[at(moving.body.hips)][3].y;
    const double wanted = 0.006 * frame * lengthOf(moving.limb("right-leg"), source);
    CHECK(drop == Approx(wanted).epsilon(0.05).margin(1e-9));
  }
}

TEST_CASE("a leg without weight keeps its foot when the other one lowers the hips") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = softMotion(moving, {}, {softLimb(moving, "right-leg", squashed)});
  const FrameState soft = atFrame(moving, motion, 20.0);
  const FrameState source = sourceAtFrame(moving, 20.0);
  CHECK(soft.worlds[at(moving.body.hips)][3].y < source.worlds[at(moving.body.hips)][3].y);
  CHECK(glm::length(endOf(moving, "left-leg", soft) - endOf(moving, "left-leg", source)) <
        1e-6 * moving.body.height);
}

TEST_CASE("a leg in the air keeps its bend and goes down with the hips") {
  const MovingBiped moving = punchingBiped();
  const Limb& left = moving.limb("left-leg");
  const MotionState motion =
      softMotion(moving, {}, {softLimb(moving, "right-leg", squashed), softLimb(moving, "left-leg", none)});
  const std::vector<Vec3> before = limbPoints(left, sourceAtFrame(moving, 12.0)); // kicks
  const std::vector<Vec3> after = limbPoints(left, atFrame(moving, motion, 12.0));
  const Vec3 hipsMove = after.front() - before.front();
  CHECK(hipsMove.y < -0.02 * moving.body.height);
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(glm::length(after[i] - before[i] - hipsMove) < 1e-9);
  }
}

TEST_CASE("a hand that gets through the floor is held up to it") {
  MovingBiped moving = still(namedBody());
  const Limb arm = moving.limb("left-arm");
  // Down along the body; three times as long it would end below the feet.
  const Quat down = axisAngle(Vec3(0.0, 0.0, 1.0), -0.45 * pi);
  moving.clip.tracks.emplace_back(
      rotationTrack(arm.joints.front(), Interpolation::linear, {{0.0, down}, {1.0, down}}));
  moving.clip.endSeconds = 1.0;
  const MotionState motion = softMotion(moving, {}, {softLimb(moving, "left-arm", [](double) {
                                          return SoftBones{3.0, 0.6, 0.6};
                                        })});
  const FrameState source = sourceAtFrame(moving, 6.0);
  const FrameState soft = atFrame(moving, motion, 6.0);
  const std::optional<double> floor = lowestOf(motion.outline, motion.outline.body, source);
  REQUIRE(floor);
  CHECK(*lowestOf(motion.outline, motion.weights.front().ends, soft) == Approx(*floor).margin(1e-9));
  CHECK(lengthOf(arm, soft) > 1.5 * lengthOf(arm, source));
}

TEST_CASE("legs that get longer in the air lift the hips: no foot gets lower than the body was") {
  const MovingBiped moving = still(namedBody());
  const MotionState motion =
      softMotion(moving, {}, {softLimb(moving, "left-leg", longer), softLimb(moving, "right-leg", longer)});
  const FrameState source = sourceAtFrame(moving, 0.0);
  const FrameState soft = atFrame(moving, motion, 0.0);
  const Limb& leg = moving.limb("left-leg");
  CHECK(lengthOf(leg, soft) == Approx(1.2 * lengthOf(leg, source)).epsilon(1e-6));
  CHECK(*lowestOf(motion.outline, motion.outline.body, soft) ==
        Approx(*lowestOf(motion.outline, motion.outline.body, source)).margin(1e-9));
}

TEST_CASE("a leg in the air is stretched without moving the hips") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = softMotion(moving, {}, {softLimb(moving, "left-leg", longer)});
  const FrameState source = sourceAtFrame(moving, 12.0);
  const FrameState soft = atFrame(moving, motion, 12.0);
  CHECK(soft.worlds[at(moving.body.hips)] == source.worlds[at(moving.body.hips)]);
  CHECK(lengthOf(moving.limb("left-leg"), soft) ==
        Approx(1.2 * lengthOf(moving.limb("left-leg"), source)).epsilon(1e-6));
}

TEST_CASE("outside its range weight does nothing, inside it fades in and out without a jump") {
  const MovingBiped moving = punchingBiped();
  LimbWeight weight = softLimb(moving, "left-arm", longer);
  weight.startSeconds = 0.25;
  weight.endSeconds = 0.75;
  weight.fadeInSeconds = 0.125;
  weight.fadeOutSeconds = 0.125;
  const MotionState motion = softMotion(moving, {}, {weight});
  const Limb& arm = moving.limb("left-arm");
  double before = 1.0;
  for (double frame = 0.0; frame <= 24.0; frame += 0.125) {
    const double ratio =
        lengthOf(arm, atFrame(moving, motion, frame)) / lengthOf(arm, sourceAtFrame(moving, frame));
    if (frame <= 6.0 || frame >= 18.0) {
      CHECK(ratio == Approx(1.0).epsilon(1e-12));
    }
    if (frame >= 9.0 && frame <= 15.0) {
      CHECK(ratio == Approx(1.2).epsilon(1e-9));
    }
    CHECK(std::abs(ratio - before) < 0.02);
    before = ratio;
  }
}

TEST_CASE("weight of a limb that is missing or has other bones is left out") {
  const MovingBiped moving = punchingBiped();
  LimbWeight wrong = softLimb(moving, "left-arm", longer);
  wrong.samples.front().strains.pop_back();
  LimbWeight missing = softLimb(moving, "left-arm", longer);
  missing.limb = "tail";
  CHECK(softMotion(moving, {}, {wrong, missing}).weights.empty());
}

TEST_CASE("a bent leg takes what its foot in place asks of it by its knee") {
  MovingBiped moving = still(namedBody());
  const Limb leg = moving.limb("left-leg");
  const Quat thigh = axisAngle(Vec3(1.0, 0.0, 0.0), -0.6);
  const Quat shin = axisAngle(Vec3(1.0, 0.0, 0.0), 1.1);
  moving.clip.tracks.emplace_back(
      rotationTrack(leg.joints[0], Interpolation::linear, {{0.0, thigh}, {1.0, thigh}}));
  moving.clip.tracks.emplace_back(
      rotationTrack(leg.joints[1], Interpolation::linear, {{0.0, shin}, {1.0, shin}}));
  moving.clip.endSeconds = 1.0;
  const MotionState motion = softMotion(
      moving, {}, {softLimb(moving, "right-leg", squashed), softLimb(moving, "left-leg", touching)});
  for (double frame = 0.0; frame <= 24.0; frame += 3.0) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState soft = atFrame(moving, motion, frame);
    CHECK(glm::length(endOf(moving, "left-leg", soft) - endOf(moving, "left-leg", source)) <
          1e-6 * moving.body.height);
    CHECK(bonesOf(leg, soft) == Approx(bonesOf(leg, source)).epsilon(1e-6));
  }
}

TEST_CASE("a foot that hangs under the root goes with its leg when the hips sink") {
  SyntheticBiped body = namedBody();
  for (const char* const side : {"l", "r"}) {
    jointOf(body, std::string("foot.") + side).parent = "root";
  }
  MovingBiped moving = still(body);
  moving.clip.endSeconds = 1.0;
  const MotionState motion = softMotion(
      moving, {}, {softLimb(moving, "right-leg", squashed), softLimb(moving, "left-leg", squashed)});
  for (double frame = 0.0; frame <= 24.0; frame += 3.0) {
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState soft = atFrame(moving, motion, frame);
    for (const char* const leg : {"left-leg", "right-leg"}) {
      CHECK(glm::length(endOf(moving, leg, soft) - endOf(moving, leg, source)) < 1e-6 * moving.body.height);
      CHECK(lengthOf(moving.limb(leg), soft) / lengthOf(moving.limb(leg), source) ==
            Approx(1.0 - 0.006 * frame).epsilon(1e-3));
    }
  }
}

TEST_CASE("what rides on the hips hangs on them and on no limb with weight") {
  const MovingBiped moving = punchingBiped();
  for (const std::string limb : {"left-arm", "left-leg", "neck"}) {
    CAPTURE(limb);
    const MotionState motion = softMotion(moving, {}, {softLimb(moving, limb, longer)});
    std::vector<NodeIndex> riding;
    for (const NodeIndex node : motion.outline.body) {
      bool hangsOnHips = false;
      bool hangsOnLimb = false;
      for (NodeIndex above = node; above.exists(); above = moving.scene.nodes[at(above)].parent) {
        hangsOnHips = hangsOnHips || above == moving.body.hips;
        for (const SolvedWeight& solved : motion.weights) {
          const std::vector<NodeIndex> own = touchedNodes(solved.limb, solved.topology);
          hangsOnLimb = hangsOnLimb || std::ranges::find(own, above) != own.end();
        }
      }
      if (hangsOnHips && !hangsOnLimb) {
        riding.push_back(node);
      }
    }
    REQUIRE(riding.size() > 3);
    CHECK(riding.size() < motion.outline.body.size());
    CHECK(motion.outline.riding == riding);
  }
}

TEST_CASE("what hangs on the hips gets no lower than the floor, however far the legs give way") {
  MovingBiped moving = still(namedBody());
  const NodeIndex hips = moving.body.hips;
  const double hipsHeight = sourceAtFrame(moving, 0.0).worlds[at(hips)][3].y;
  const NodeIndex tail = addNode(moving.scene, "tail", hips, Vec3(0.0));
  const auto low = static_cast<float>(0.05 - hipsHeight); // of the hips; 0.05 in the world
  Primitive primitive;
  primitive.positions = {{0.0F, 0.0F, -0.3F}, {0.05F, low, -0.3F}, {-0.05F, low, -0.3F}};
  moving.scene.nodes[at(tail)].mesh = static_cast<int>(moving.scene.meshes.size());
  moving.scene.meshes.push_back({"tail", {primitive}, {}});
  moving.clip.endSeconds = 1.0;
  const MotionState motion = softMotion(
      moving, {}, {softLimb(moving, "left-leg", squashed), softLimb(moving, "right-leg", squashed)});
  const FrameState source = sourceAtFrame(moving, 24.0);
  const std::optional<double> floor = lowestOf(motion.outline, motion.outline.body, source);
  REQUIRE(floor);
  const double room = 0.05 - *floor;
  REQUIRE(room < 0.1 * lengthOf(moving.limb("left-leg"), source)); // the legs would give way by more
  const FrameState soft = atFrame(moving, motion, 24.0);
  CHECK(hipsHeight - soft.worlds[at(hips)][3].y == Approx(room).margin(1e-6));
}
