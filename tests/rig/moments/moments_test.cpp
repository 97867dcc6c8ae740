#include "rig/moments/moments.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/moments/body_motion.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/moving_creatures.h"

using namespace stretch;
using namespace stretch::rig;
using test::MovingBiped;

namespace {

struct Turn {
  double frame = 0.0;
  double degrees = 0.0;
};

constexpr double rate = 24.0;

void turn(MovingBiped& biped, const std::string& joint, const Vec3& axis, const std::vector<Turn>& poses) {
  const NodeIndex node = biped.node.at(joint);
  test::RotationKeys keys;
  for (const Turn& pose : poses) {
    keys.emplace_back(pose.frame / rate,
                      axisAngle(axis, pose.degrees * pi / 180.0) * biped.scene.nodes[at(node)].rest.rotation);
  }
  biped.clip.tracks.emplace_back(test::rotationTrack(node, Interpolation::linear, keys));
  setEndsFromKeys(biped.clip);
}

void move(MovingBiped& biped, const std::string& joint, const std::vector<std::pair<double, Vec3>>& moves) {
  const NodeIndex node = biped.node.at(joint);
  test::VectorKeys keys;
  for (const auto& [frame, by] : moves) {
    keys.emplace_back(frame / rate, biped.scene.nodes[at(node)].rest.translation + by);
  }
  biped.clip.tracks.emplace_back(test::vectorTrack(node, Channel::translation, Interpolation::linear, keys));
  setEndsFromKeys(biped.clip);
}

constexpr Vec3 up{0, 1, 0};
constexpr Vec3 rightwards{-1, 0, 0}; ///< Of a body that faces +Z.

MovingBiped stillBiped() {
  return test::still(test::namedBody());
}

std::vector<Moment> momentsOf(const MovingBiped& biped) {
  return rig::momentsOf(biped.scene, biped.clip, biped.body);
}

/// The strongest of a limb.
std::optional<Moment> momentOf(const std::vector<Moment>& moments, const std::string& limb) {
  const auto found = std::ranges::find(moments, limb, &Moment::limb);
  return found == moments.end() ? std::nullopt : std::optional(*found);
}

double strengthOf(const std::vector<Moment>& moments, const std::string& limb) {
  const std::optional<Moment> found = momentOf(moments, limb);
  return found ? found->strength : 0.0;
}

/// The left arm goes forwards from its side over frames 10 to 14 and comes back until 30.
MovingBiped striker() {
  MovingBiped biped = stillBiped();
  turn(biped, "upperArm.l", up, {{0, 30}, {10, 30}, {14, -80}, {18, -80}, {30, 30}, {40, 30}});
  return biped;
}

} // namespace

TEST_CASE("A strike is a stroke from its wind-up to where the limb is out, and its way back is weaker") {
  const std::vector<Moment> moments = momentsOf(striker());
  REQUIRE(moments.size() == 2);
  CHECK(moments[0].limb == "left-arm");
  CHECK(moments[0].kind == MomentKind::stroke);
  CHECK(moments[0].startFrame == Approx(10.0).margin(1.0));
  CHECK(moments[0].tipFrame == Approx(14.0).margin(1.0));
  CHECK(moments[0].endFrame == moments[0].tipFrame);
  CHECK(moments[1].startFrame == Approx(18.0).margin(1.0));
  CHECK(moments[1].tipFrame == Approx(30.0).margin(1.0));
  CHECK(moments[1].strength < 0.3 * moments[0].strength);
}

TEST_CASE(
    "A stroke reaches as far as a quarter of its fastest speed, through a bend but not through a turn back") {
  MovingBiped eased = stillBiped(); // 2, 8, 20 and 2 degrees a frame.
  turn(eased, "upperArm.l", up, {{0, 40}, {8, 24}, {12, -8}, {16, -88}, {24, -104}});
  const Moment slow = momentsOf(eased).front();
  CHECK(slow.startFrame == Approx(8.0).margin(1.0));
  CHECK(slow.tipFrame == Approx(16.0).margin(1.0));
  MovingBiped bent = stillBiped(); // Forwards, and at once as fast upwards.
  const NodeIndex node = bent.node.at("upperArm.l");
  const Quat rest = bent.scene.nodes[at(node)].rest.rotation;
  const auto posed = [&](double yaw, double lift) {
    return axisAngle({0, 0, 1}, lift * pi / 180.0) * axisAngle(up, yaw * pi / 180.0) * rest;
  };
  bent.clip.tracks.emplace_back(test::rotationTrack(node, Interpolation::linear,
                                                    {{0.0, posed(20, 0)},
                                                     {10 / rate, posed(20, 0)},
                                                     {12 / rate, posed(0, 0)},
                                                     {18 / rate, posed(0, 60)},
                                                     {1.0, posed(0, 60)}}));
  setEndsFromKeys(bent.clip);
  REQUIRE(momentsOf(bent).size() == 1);
  CHECK(momentsOf(bent).front().startFrame == Approx(10.0).margin(1.0));
  CHECK(momentsOf(bent).front().tipFrame == Approx(18.0).margin(1.0));
}

TEST_CASE("The straight way back to where the clip began counts half, but in a cycle") {
  const Vec3 forward{0, 0, 1};
  MovingBiped lifted = stillBiped();
  turn(lifted, "upperArm.l", forward, {{0, 0}, {10, 0}, {14, 70}, {18, 70}, {22, 0}, {32, 0}});
  const std::vector<Moment> moments = momentsOf(lifted);
  REQUIRE(moments.size() == 2);
  CHECK(moments[0].tipFrame == Approx(14.0).margin(1.0));
  CHECK(moments[1].strength == Approx(0.5 * moments[0].strength).epsilon(0.1));
  MovingBiped beating = stillBiped();
  turn(beating, "upperArm.l", forward, {{0, 0}, {4, 40}, {8, 0}, {12, 40}, {16, 0}, {20, 40}, {24, 0}});
  const std::vector<Moment> beats = momentsOf(beating);
  REQUIRE(beats.size() > 3);
  CHECK(beats.front().kind == MomentKind::cycle);
  CHECK(beats.back().strength > 0.7 * beats.front().strength);
}

TEST_CASE("Strength is counted in reaches per second: faster is stronger, size and facing do not matter") {
  const double strength = momentsOf(striker()).front().strength;
  CHECK(strength > 5.0);
  MovingBiped slower = stillBiped();
  turn(slower, "upperArm.l", up, {{0, 30}, {10, 30}, {18, -80}, {22, -80}});
  CHECK(momentsOf(slower).front().strength == Approx(0.5 * strength).epsilon(0.15));
  for (const double size : {0.01, 100.0}) {
    test::SyntheticBiped body = test::namedBody();
    body.size = size;
    body.turn = axisAngle(up, 0.5 * pi);
    MovingBiped other = test::still(body);
    turn(other, "upperArm.l", up, {{0, 30}, {10, 30}, {14, -80}, {18, -80}, {30, 30}, {40, 30}});
    CHECK(momentsOf(other).front().strength == Approx(strength).epsilon(0.01));
  }
}

TEST_CASE("A moment is the same at any frame rate") {
  MovingBiped biped = striker();
  const Moment at24 = momentsOf(biped).front();
  for (const double factor : {2.0, 5.0}) {
    biped.clip.framesPerSecond = factor * rate;
    const Moment fast = momentsOf(biped).front();
    CHECK(fast.startFrame == Approx(factor * at24.startFrame).margin(1.5 * factor));
    CHECK(fast.tipFrame == Approx(factor * at24.tipFrame).margin(1.5 * factor));
    CHECK(fast.strength == Approx(at24.strength).epsilon(0.15));
  }
}

TEST_CASE("A stroke that its clip breaks off between two frames ends where the clip does") {
  MovingBiped cut = stillBiped();
  turn(cut, "upperArm.l", up, {{0, 30}, {10, 30}, {13.5, -66}});
  const std::vector<Moment> moments = momentsOf(cut);
  REQUIRE_FALSE(moments.empty());
  CHECK(moments.front().limb == "left-arm");
  CHECK(moments.front().tipFrame == Approx(13.5));
}

TEST_CASE("What trembles between the frames of a dense capture does not part a stroke") {
  MovingBiped dense = stillBiped();
  std::vector<Turn> turns;
  for (int i = 0; i <= 200; ++i) { // At 120 frames per second.
    const double swing = 30.0 - 110.0 * std::clamp((i - 50.0) / 20.0, 0.0, 1.0);
    turns.push_back({i / 5.0, swing + (i % 2 == 0 ? 1.5 : -1.5)});
  }
  turn(dense, "upperArm.l", up, turns);
  dense.clip.framesPerSecond = 120.0;
  const std::vector<Moment> moments = momentsOf(dense);
  REQUIRE(moments.size() == 1);
  CHECK(moments.front().startFrame == Approx(50.0).margin(5.0));
  CHECK(moments.front().tipFrame == Approx(70.0).margin(5.0));
}

TEST_CASE("A pose that stands alone in front of a motion or behind it makes no moment") {
  const std::vector<Moment> plain = momentsOf(striker());
  for (const double lone : {0.0, 40.0}) {
    MovingBiped captured = stillBiped();
    const double beside = lone == 0.0 ? 1.0 : 39.0;
    const auto poses = [&](double usual, double raised, std::vector<Turn> between) {
      between.push_back({lone, raised});
      between.push_back({beside, usual});
      between.push_back({40.0 - lone, usual});
      std::ranges::sort(between, {}, &Turn::frame);
      return between;
    };
    turn(captured, "upperArm.l", up, poses(30.0, -60.0, {{10, 30}, {14, -80}, {18, -80}, {30, 30}}));
    turn(captured, "upperArm.r", up, poses(-30.0, 60.0, {}));
    CAPTURE(lone);
    CHECK(momentsOf(captured) == plain);
  }
}

TEST_CASE("In place of a pose that stands alone the one beside it is held: limbs, hips and facing") {
  for (const double lone : {0.0, 40.0}) {
    CAPTURE(lone);
    const double beside = lone == 0.0 ? 1.0 : 39.0;
    MovingBiped captured = stillBiped();
    move(captured, "hips",
         {{0, Vec3(0.0)}, {1, Vec3(0.1, 0.2, 0)}, {39, Vec3(0, 0.4, 0.1)}, {40, Vec3(0.0)}});
    for (const auto& [arm, degrees] : {std::pair("upperArm.l", 60.0), std::pair("upperArm.r", -60.0)}) {
      const double raised = -degrees;
      turn(captured, arm, up,
           lone == 0.0 ? std::vector<Turn>{{0, raised}, {1, degrees}, {40, degrees}}
                       : std::vector<Turn>{{0, degrees}, {39, degrees}, {40, raised}});
    }
    turn(captured, "spine0", up, {{0, 0}, {1, 20}, {39, 20}, {40, 0}});
    const BodyMotion motion = motionOfBody(captured.scene, captured.clip, captured.body, captured.body.limbs);
    const auto first = static_cast<std::size_t>(2.0 * std::min(lone, beside));
    const auto held = static_cast<std::size_t>(2.0 * beside);
    const std::size_t last = first + 2;
    for (std::size_t sample = first; sample <= last; ++sample) {
      CAPTURE(sample);
      CHECK(motion.hips[sample] == motion.hips[held]);
      CHECK(motion.forward[sample] == motion.forward[held]);
      for (const LimbMotion& limb : motion.limbs) {
        CHECK(limb.places[sample] == limb.places[held]);
        CHECK(limb.ends[sample] == limb.ends[held]);
      }
    }
    const std::size_t inside = lone == 0.0 ? last + 1 : first - 1;
    CHECK(motion.hips[inside] != motion.hips[held]);
  }
}

TEST_CASE("A strike of one arm in the first frame of a clip is one, and so is that of both which goes on") {
  MovingBiped sudden = stillBiped();
  turn(sudden, "upperArm.l", up, {{0, 30}, {1, -60}, {24, -60}});
  CHECK(strengthOf(momentsOf(sudden), "left-arm") > 1.0);
  MovingBiped both = stillBiped();
  turn(both, "upperArm.l", up, {{0, 60}, {1, 20}, {3, -60}, {24, -60}});
  turn(both, "upperArm.r", up, {{0, -60}, {1, -20}, {3, 60}, {24, 60}});
  CHECK(strengthOf(momentsOf(both), "left-arm") > 1.0);
  CHECK(strengthOf(momentsOf(both), "right-arm") > 1.0);
}

TEST_CASE("The arm that strikes forwards is stronger than the one that is drawn back as fast") {
  MovingBiped biped = stillBiped();
  turn(biped, "upperArm.l", up, {{0, 10}, {10, 10}, {15, -80}, {30, -80}});
  turn(biped, "upperArm.r", up, {{0, 80}, {10, 80}, {15, -10}, {30, -10}}); // From the front to the side.
  const std::vector<Moment> moments = momentsOf(biped);
  REQUIRE(moments.size() == 2);
  CHECK(moments[0].limb == "left-arm");
  CHECK(moments[1].strength < 0.7 * moments[0].strength);
}

TEST_CASE("A hand that stays in the world while the body turns away under it does little") {
  MovingBiped hips = stillBiped();
  move(hips, "hips", {{0, Vec3(0.0)}, {10, Vec3(0.0)}, {14, Vec3(0, 0, -0.3)}, {30, Vec3(0, 0, -0.3)}});
  MovingBiped both = hips;
  turn(both, "thigh.l", rightwards, {{0, 0}, {10, 0}, {14, 21}, {30, 21}}); // The foot stays behind.
  MovingBiped kick = stillBiped();
  turn(kick, "thigh.l", rightwards, {{0, 0}, {10, 0}, {14, 21}, {30, 21}});
  REQUIRE(strengthOf(momentsOf(kick), "left-leg") > 1.0);
  CHECK(strengthOf(momentsOf(both), "left-leg") < 0.6 * strengthOf(momentsOf(kick), "left-leg"));
}

TEST_CASE("What stands still, trembles or creeps has no moment") {
  CHECK(momentsOf(stillBiped()).empty());
  MovingBiped trembling = stillBiped();
  std::vector<Turn> poses;
  for (int frame = 0; frame <= 48; ++frame) {
    poses.push_back({static_cast<double>(frame), frame % 2 == 0 ? 2.0 : -2.0});
  }
  turn(trembling, "upperArm.l", up, poses);
  CHECK(momentsOf(trembling).empty());
  MovingBiped creeping = stillBiped();
  turn(creeping, "upperArm.l", up, {{0, 30}, {240, -30}});
  CHECK(momentsOf(creeping).empty());
}

TEST_CASE("An idle has no moment: it sways from foot to foot, breathes, looks about") {
  const auto swaying = [](double times) { // A second or so to each side.
    MovingBiped idle = stillBiped();
    std::vector<Turn> sway;
    std::vector<Turn> nod;
    for (int frame = 0; frame <= 48; ++frame) {
      const double angle = 2.0 * pi * times * frame / 48.0;
      sway.push_back({static_cast<double>(frame), 16.0 * std::sin(angle)});
      nod.push_back({static_cast<double>(frame), 25.0 * std::sin(angle)});
    }
    turn(idle, "upperArm.l", up, sway);
    turn(idle, "upperArm.r", up, sway);
    turn(idle, "spine0", rightwards, {{0, 0}, {12, 2}, {24, 0}, {36, 2}, {48, 0}});
    turn(idle, "neck0", up, nod);
    return idle;
  };
  CHECK(momentsOf(swaying(2.0)).empty());
  CHECK_FALSE(momentsOf(swaying(8.0)).empty()); // A drummer.
  MovingBiped footless = swaying(2.0);          // A ghost: nothing of it stands.
  std::erase_if(footless.body.limbs, [](const Limb& limb) { return !isArm(limb); });
  CHECK_FALSE(momentsOf(footless).empty());
  MovingBiped walking = swaying(2.0);
  const std::vector<Turn> steps{{0, -20}, {12, 20}, {24, -20}, {36, 20}, {48, -20}};
  turn(walking, "thigh.l", rightwards, steps);
  CHECK(momentOf(momentsOf(walking), "left-arm"));
}

TEST_CASE("A clip that is called an idle, comes back and never strikes only fidgets") {
  const auto called = [](const char* name, double degrees, double last) {
    MovingBiped fidget = stillBiped();
    turn(fidget, "upperArm.l", up, {{0, 30}, {20, 30}, {50, 30 - degrees}, {60, 30 - degrees}, {90, last}});
    fidget.clip.name = name;
    return momentsOf(fidget);
  };
  const auto greets = [&](const char* name) { return !called(name, 110.0, 30.0).empty(); };
  CHECK(greets("Wave"));
  CHECK(greets("Idle_HitReact_Left"));
  CHECK(greets("idleness"));
  CHECK(greets("Sidle"));
  CHECK(greets("SIDLE"));
  CHECK(greets(""));
  CHECK(greets("2"));
  CHECK_FALSE(greets("Idle"));
  CHECK_FALSE(greets("Armature|Fighting Idle"));
  CHECK_FALSE(greets("idle_2"));
  CHECK_FALSE(greets("FightToIdle"));
  CHECK_FALSE(greets("FIGHT-IDLE"));
  MovingBiped beating = stillBiped();
  turn(beating, "upperArm.l", up, {{0, 0}, {6, 30}, {12, 0}, {18, 30}, {24, 0}});
  const std::vector<Moment> beats = momentsOf(beating);
  REQUIRE_FALSE(beats.empty());
  REQUIRE(beats.front().strength < 5.0);
  beating.clip.name = "Fly_Idle";
  CHECK(momentsOf(beating) == beats);
  CHECK_FALSE(called("drop_idle", 110.0, -40.0).empty()); // On its way to rest.
  MovingBiped strike = striker();
  strike.clip.name = "Fighting Idle";
  REQUIRE(strengthOf(momentsOf(striker()), "left-arm") > 5.0);
  CHECK(momentsOf(strike) == momentsOf(striker()));
}

TEST_CASE("Steps are cycles, and so is what swings along with them, the arm that strikes meanwhile is none") {
  const std::vector<Turn> forth{{0, -30}, {12, 30}, {24, -30}};
  const std::vector<Turn> back{{0, 30}, {12, -30}, {24, 30}};
  MovingBiped walk = stillBiped();
  turn(walk, "thigh.l", rightwards, forth);
  turn(walk, "thigh.r", rightwards, back);
  turn(walk, "upperArm.l", up, {{0, 0}, {5, -30}, {24, 0}});
  const std::vector<Moment> steps = momentsOf(walk);
  REQUIRE(steps.size() >= 4);
  CHECK(momentOf(steps, "left-arm"));
  CHECK(std::ranges::all_of(steps, [](const Moment& step) { return step.kind == MomentKind::cycle; }));
  MovingBiped striking = stillBiped();
  turn(striking, "thigh.l", rightwards, forth);
  turn(striking, "thigh.r", rightwards, back);
  turn(striking, "upperArm.l", up, {{0, 30}, {10, 30}, {13, -80}, {24, 30}});
  const std::vector<Moment> moments = momentsOf(striking);
  CHECK(moments.front().limb == "left-arm");
  CHECK(moments.front().kind == MomentKind::stroke);
  CHECK(momentOf(moments, "left-leg")->kind == MomentKind::cycle);
}

TEST_CASE("Steps to the side are mirrored steps, and a limping leg goes with the other one") {
  const Vec3 forward{0, 0, 1};
  MovingBiped side = stillBiped();
  turn(side, "thigh.l", forward, {{0, 0}, {12, 25}, {24, 0}});
  turn(side, "thigh.r", forward, {{0, -25}, {12, 0}, {24, -25}});
  REQUIRE(momentOf(momentsOf(side), "left-leg"));
  CHECK(momentOf(momentsOf(side), "left-leg")->kind == MomentKind::cycle);
  MovingBiped limping = stillBiped();
  turn(limping, "thigh.l", rightwards, {{0, -18}, {12, 18}, {24, -18}});
  turn(limping, "thigh.r", rightwards, {{0, 38}, {12, -38}, {24, 38}});
  for (const char* const leg : {"left-leg", "right-leg"}) {
    REQUIRE(momentOf(momentsOf(limping), leg));
    CHECK(momentOf(momentsOf(limping), leg)->kind == MomentKind::cycle);
  }
}

TEST_CASE("A limb goes round when it does the same a third of the clip later, not when it strikes once") {
  MovingBiped waving = stillBiped();
  turn(waving, "upperArm.l", up, {{0, 0}, {4, 40}, {8, 0}, {12, 40}, {16, 0}, {20, 40}, {24, 0}});
  CHECK(momentsOf(waving).front().kind == MomentKind::cycle);
  MovingBiped once = stillBiped();
  turn(once, "upperArm.l", up, {{0, 0}, {4, 40}, {8, 0}, {24, 0}});
  CHECK(momentsOf(once).front().kind == MomentKind::stroke);
  MovingBiped open = stillBiped(); // Three times, and then somewhere else.
  turn(open, "upperArm.l", up, {{0, 0}, {4, 40}, {8, 0}, {12, 40}, {16, 0}, {20, 40}, {24, 90}});
  CHECK(momentsOf(open).front().kind == MomentKind::stroke);
}

TEST_CASE("Cycles come after strokes of the same clip, whatever their strength") {
  MovingBiped biped = stillBiped();
  turn(biped, "upperArm.r", up, {{0, 0}, {4, 70}, {8, 0}, {12, 70}, {16, 0}, {20, 70}, {24, 0}});
  turn(biped, "upperArm.l", up, {{0, 0}, {8, -40}, {24, 0}});
  const std::vector<Moment> moments = momentsOf(biped);
  REQUIRE(moments.size() > 2);
  CHECK(moments.front().limb == "left-arm");
  CHECK(moments.front().strength < moments.back().strength + 10.0);
  CHECK(moments.back().kind == MomentKind::cycle);
  const auto firstCycle = std::ranges::find(moments, MomentKind::cycle, &Moment::kind);
  CHECK(std::is_sorted(firstCycle, moments.end(),
                       [](const Moment& a, const Moment& b) { return a.strength > b.strength; }));
  CHECK(firstCycle->strength > moments.front().strength);
}

TEST_CASE("A landing is the fall of the hips that feet stop, a squat is none, nor a fall without an end") {
  const double falls = -0.6;
  const auto fallen = [&](double lowest) {
    MovingBiped biped = stillBiped();
    std::vector<std::pair<double, Vec3>> moves;
    for (int frame = 0; frame <= 12; ++frame) {
      moves.emplace_back(frame, Vec3(0, 0.6 + falls * frame * frame / 144.0, 0));
    }
    moves.emplace_back(16.0, Vec3(0, lowest, 0));
    moves.emplace_back(30.0, Vec3(0, lowest, 0));
    move(biped, "hips", moves);
    return biped;
  };
  MovingBiped landing = fallen(-0.25);
  // The feet stay at frame 12, where the legs bend: thighs forwards, shins back.
  for (const char* const side : {"l", "r"}) {
    turn(landing, std::string("thigh.") + side, rightwards, {{0, 0}, {12, 0}, {16, 42}, {30, 42}});
    turn(landing, std::string("shin.") + side, rightwards, {{0, 0}, {12, 0}, {16, -84}, {30, -84}});
  }
  const std::optional<Moment> touch = momentOf(momentsOf(landing), wholeBody);
  REQUIRE(touch);
  CHECK(touch->kind == MomentKind::landing);
  CHECK(touch->startFrame == Approx(12.0).margin(1.0));
  CHECK(touch->tipFrame == Approx(16.0).margin(1.0));
  MovingBiped oneLegged = fallen(-0.25); // The other leg stays drawn up.
  turn(oneLegged, "thigh.l", rightwards, {{0, 0}, {12, 0}, {16, 42}, {30, 42}});
  turn(oneLegged, "shin.l", rightwards, {{0, 0}, {12, 0}, {16, -84}, {30, -84}});
  CHECK(momentOf(momentsOf(oneLegged), wholeBody));
  CHECK_FALSE(momentOf(momentsOf(fallen(-1.5)), wholeBody)); // Through the floor: nothing stops it.
  MovingBiped squat = stillBiped();
  move(squat, "hips", {{0, Vec3(0.0)}, {6, Vec3(0, -0.25, 0)}, {20, Vec3(0, -0.25, 0)}});
  for (const char* const side : {"l", "r"}) {
    turn(squat, std::string("thigh.") + side, rightwards, {{0, 0}, {6, 42}, {20, 42}});
    turn(squat, std::string("shin.") + side, rightwards, {{0, 0}, {6, -84}, {20, -84}});
  }
  CHECK_FALSE(momentOf(momentsOf(squat), wholeBody));
}

TEST_CASE("The moments of one limb share at most their ends, and lie within the clip") {
  MovingBiped biped = stillBiped();
  turn(biped, "upperArm.l", up, {{0, 0}, {5, 50}, {7, 45}, {9, 60}, {13, -60}, {16, 10}, {21, -70}, {23, 0}});
  std::vector<Moment> moments = momentsOf(biped);
  REQUIRE(moments.size() > 2);
  std::ranges::sort(moments, {}, &Moment::startFrame);
  CHECK(moments.front().startFrame >= 0.0);
  CHECK(moments.back().endFrame <= 23.0);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    CHECK(moments[i].startFrame < moments[i].tipFrame);
    CHECK((i == 0 || moments[i].startFrame >= moments[i - 1].endFrame));
  }
}

TEST_CASE("The trunk carries the limbs that act and a tail follows them: both weigh less") {
  const MovingBiped horse = test::pawingHorse();
  const std::vector<Moment> moments = momentsOf(horse);
  CHECK(moments.front().limb.ends_with("leg"));
  CHECK(strengthOf(moments, "tail") < 0.5 * moments.front().strength);
  MovingBiped body = stillBiped();
  turn(body, "spine0", up, {{0, 40}, {10, 40}, {14, -40}, {30, -40}}); // The arms with it.
  turn(body, "upperArm.l", up, {{0, 20}, {10, 20}, {14, -20}, {30, -20}});
  CHECK(momentsOf(body).front().limb == "left-arm");
  MovingBiped bow = stillBiped();
  turn(bow, "spine0", rightwards, {{0, 0}, {10, 0}, {14, -70}, {30, -70}});
  MovingBiped asChain = bow;
  std::ranges::find(asChain.body.limbs, "spine", &Limb::id)->kind = LimbKind::chain;
  CHECK(strengthOf(momentsOf(bow), "spine") ==
        Approx(0.6 * strengthOf(momentsOf(asChain), "spine")).epsilon(1e-6));
}

TEST_CASE("A beast's neck counts in its own lengths, a person's does not, a tail the less the longer it is") {
  MovingBiped horse = test::pawingHorse();
  turn(horse, "neck0", rightwards, {{0, 0}, {4, 60}, {24, 60}});
  MovingBiped person = horse;
  REQUIRE(horse.body.plan == "quadruped");
  person.body.plan = "biped";
  std::vector<double> reaches;
  for (const LimbMotion& limb : motionOfBody(horse.scene, horse.clip, horse.body, horse.body.limbs).limbs) {
    reaches.push_back(limb.reach);
  }
  const auto placeOf = [&](const char* limb) {
    return static_cast<std::size_t>(std::ranges::find(horse.body.limbs, limb, &Limb::id) -
                                    horse.body.limbs.begin());
  };
  const double reach = motionOfBody(horse.scene, horse.clip, horse.body, horse.body.limbs).reach;
  REQUIRE(reaches[placeOf("neck")] < 0.8 * reach);
  CHECK(strengthOf(momentsOf(horse), "neck") * reaches[placeOf("neck")] / reach ==
        Approx(strengthOf(momentsOf(person), "neck") / 0.6));
  MovingBiped longTailed = test::pawingHorse();
  longTailed.scene.nodes[at(longTailed.node.at("tail1"))].rest.translation *= 9.0;
  const BodyMotion motion =
      motionOfBody(longTailed.scene, longTailed.clip, longTailed.body, longTailed.body.limbs);
  const LimbMotion& tail = motion.limbs[placeOf("tail")];
  REQUIRE(tail.reach > 1.5 * motion.reach);
  CHECK(tail.weight == Approx(0.35 / std::sqrt(tail.reach / motion.reach)));
}

TEST_CASE("A chain that the user picked has its moments beside the body's limbs") {
  const MovingBiped biped = striker();
  Result<Limb> chain = chainLimb(biped.scene, biped.scene.nodes[at(biped.node.at("upperArm.l"))].name,
                                 biped.scene.nodes[at(biped.node.at("foreArm.l"))].name);
  REQUIRE(chain);
  const std::vector<Moment> moments = rig::momentsOf(biped.scene, biped.clip, biped.body, {*chain});
  REQUIRE(momentOf(moments, chain->id));
  CHECK(momentOf(moments, chain->id)->tipFrame == momentOf(moments, "left-arm")->tipFrame);
}

TEST_CASE("A body without limbs, a clip without keys and limbs without joints have no moments") {
  MovingBiped biped = striker();
  CHECK(rig::momentsOf(biped.scene, Clip{}, biped.body).empty());
  Body none = biped.body;
  none.limbs.clear();
  CHECK(rig::momentsOf(biped.scene, biped.clip, none).empty());
  none.limbs.push_back(Limb{});
  CHECK(rig::momentsOf(biped.scene, biped.clip, none).empty());
}

TEST_CASE("What goes round does so at any size, and what does not close does not") {
  for (const double size : {0.01, 1.0, 100.0}) {
    CAPTURE(size);
    test::SyntheticBiped body = test::namedBody();
    body.size = size;
    MovingBiped open = test::still(body);
    turn(open, "upperArm.l", up, {{0, 0}, {4, 40}, {8, 0}, {12, 40}, {16, 0}, {20, 40}, {24, 90}});
    REQUIRE_FALSE(momentsOf(open).empty());
    CHECK(momentsOf(open).front().kind == MomentKind::stroke);
    MovingBiped closed = test::still(body);
    turn(closed, "upperArm.l", up, {{0, 0}, {4, 40}, {8, 0}, {12, 40}, {16, 0}, {20, 40}, {24, 0}});
    CHECK(momentsOf(closed).front().kind == MomentKind::cycle);
  }
}

TEST_CASE("The moment at a frame is the one that it lies in, the strongest near it, else the nearest") {
  const auto made = [](const char* limb, double start, double end, double strength) {
    return Moment{limb, MomentKind::stroke, start, end, end, strength};
  };
  const std::vector<Moment> moments{made("strong", 10, 14, 9.0), made("weak", 12, 20, 2.0),
                                    made("late", 30, 34, 5.0)};
  const auto nameAt = [&](double frame, double near = 0.0) { return momentAt(moments, frame, near)->limb; };
  CHECK(nameAt(10.0) == "strong");
  CHECK(nameAt(13.0) == "strong"); // both hold the frame
  CHECK(nameAt(14.0) == "strong");
  CHECK(nameAt(14.5) == "weak"); // only one of them does
  CHECK(nameAt(20.0) == "weak");
  CHECK(nameAt(24.0) == "weak"); // 4 frames after it, 6 before the other
  CHECK(nameAt(26.0) == "late");
  CHECK(nameAt(0.0) == "strong");
  CHECK(nameAt(99.0) == "late");
  CHECK(nameAt(24.0, 10.0) == "strong"); // all are within 10 frames
  CHECK(nameAt(24.0, 6.0) == "late");    // 10 frames after the strongest
  CHECK(nameAt(24.0, 5.0) == "weak");
  CHECK(nameAt(14.5, 10.0) == "weak"); // it lies in this one
  CHECK(momentAt({}, 3.0) == nullptr);
  CHECK(strongestMoment(moments)->limb == "strong");
  CHECK(strongestMoment({}) == nullptr);
  CHECK(std::string(momentKindName(MomentKind::stroke)) == "stroke");
  CHECK(std::string(momentKindName(MomentKind::cycle)) == "cycle");
  CHECK(std::string(momentKindName(MomentKind::landing)) == "landing");
}
