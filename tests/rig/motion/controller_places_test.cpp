#include "rig/motion/controller_places.h"

#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/adjust/apply_adjustments.h"
#include "rig/adjust/solve_adjustments.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/moving_creatures.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

class Placed {
public:
  Placed(const MovingBiped& moving, const std::vector<Adjustment>& adjustments, double frame,
         const std::vector<Trail>& trails = {})
      : moving_(moving), motion_(adjusted(moving, adjustments, trails)),
        shown_(atFrame(moving, motion_, frame)) {
    SolvedAdjustments solved = motion_.adjustments;
    if (solved.body == nullptr) {
      solved.body = std::make_shared<const AdjustedBody>(
          adjustedBody({moving.scene, moving.clip, moving.body.hips, moving.body.limbs}));
    }
    placed_ = placeControllers({moving.scene, moving.clip, solved, shown_});
  }

  [[nodiscard]] const PlacedController& operator[](const std::string& id) const {
    const auto found = std::ranges::find(placed_, id, &PlacedController::id);
    REQUIRE(found != placed_.end());
    return *found;
  }
  [[nodiscard]] Vec3 joint(const std::string& key) const {
    return positionOf(shown_.worlds[at(moving_.node.at(key))]);
  }
  [[nodiscard]] const std::vector<PlacedController>& all() const { return placed_; }

private:
  const MovingBiped& moving_;
  MotionState motion_;
  FrameState shown_;
  std::vector<PlacedController> placed_;
};

} // namespace

TEST_CASE("a hand's controller stands where the wrist is, a foot's at the ankle, the body's on the floor") {
  const MovingBiped moving = punchingBiped();
  const Vec3 low(0.0, -0.1 * moving.body.height, 0.0);
  for (const std::vector<Adjustment>& adjustments :
       {std::vector<Adjustment>{}, {rig::Adjustment(test::moved("hips", low))}}) {
    for (const double frame : {0.0, 7.5, 12.0}) {
      const Placed placed(moving, adjustments, frame);
      CHECK(placed["left-hand"].placeWorld == placed.joint("hand.l"));
      CHECK(placed["right-foot"].placeWorld == placed.joint("foot.r"));
      CHECK(placed["hips"].placeWorld == placed.joint("hips"));
      CHECK(placed["spine-low"].placeWorld == placed.joint("spine0"));
      CHECK(placed["body"].placeWorld.y == Approx(0.0).margin(1e-12));
    }
  }
}

TEST_CASE("what a controller leads is told to be where it was asked for, and nothing else to be there") {
  const MovingBiped moving = punchingBiped();
  const double step = 0.02 * moving.body.height;
  for (const auto& [id, way] : {std::pair<std::string, Vec3>{"hips", Vec3(0.0, -1.0, 0.0)},
                                {"spine-low", Vec3(0.5, -1.0, 0.5)},
                                {"spine-top", Vec3(0.5, -1.0, 0.5)},
                                {"head", Vec3(0.5, -1.0, 0.5)},
                                {"left-hand", Vec3(0.0, 0.0, -1.0)},
                                {"right-hand", Vec3(0.0, -1.0, -0.5)},
                                {"left-foot", Vec3(0.5, 1.0, 0.0)},
                                {"right-foot", Vec3(0.0, 1.0, 0.5)}}) {
    const MotionState motion = adjusted(moving, {test::moved(id, step * way)}, {});
    FrameState state = sampledFrame(moving.scene, moving.clip, 12.0 / moving.clip.framesPerSecond);
    const FrameState before = state;
    const std::vector<AskedPlace> asked = applyAdjustments(moving.scene, motion.adjustments, state);
    const auto own = std::ranges::find(asked, id, &AskedPlace::controller);
    INFO(id);
    REQUIRE(own != asked.end());
    const Vec3 reached = controllerPlace(motion.adjustments, id, state);
    CHECK(glm::length(reached - own->place) < 0.1 * step);
    CHECK(glm::length(controllerPlace(motion.adjustments, id, before) - own->place) > 0.5 * step);
  }
}

TEST_CASE("a controller stands where a trail takes what it is on") {
  const MovingBiped moving = punchingBiped();
  const Placed placed(moving, {}, 12.0, {connectedTrail("left-arm", 6.0, 12.0, 3.0)});
  CHECK(placed["left-hand"].placeWorld == placed.joint("hand.l"));
}

TEST_CASE("a pole stands half the limb's length before its joint, the way the limb bends") {
  const MovingBiped moving = punchingBiped();
  const Placed placed(moving, {test::moved("hips", Vec3(0.0, -0.15 * moving.body.height, 0.0))}, 6.0);
  for (const char* side : {".l", ".r"}) {
    const PlacedController& knee = placed[side[1] == 'l' ? "left-knee" : "right-knee"];
    const Vec3 hip = placed.joint(std::string("thigh") + side);
    const Vec3 joint = placed.joint(std::string("shin") + side);
    const Vec3 ankle = placed.joint(std::string("foot") + side);
    const double length = glm::length(joint - hip) + glm::length(ankle - joint);
    const Vec3 line = glm::normalize(ankle - hip);
    const Vec3 bend = (joint - hip) - line * glm::dot(joint - hip, line);
    CHECK(glm::length(knee.placeWorld - (joint + 0.5 * length * glm::normalize(bend))) < 1e-6 * length);
    REQUIRE(knee.jointWorld);
    CHECK(*knee.jointWorld == joint);
  }
}

TEST_CASE("a pole that is moved by its slack alone leaves the bend as it is") {
  const MovingBiped moving = punchingBiped();
  const Adjustment lowered = test::moved("hips", Vec3(0.05, -0.15, 0.08) * moving.body.height);
  const Placed before(moving, {lowered}, 6.0);
  const PlacedController& knee = before["left-knee"];
  const Placed after(moving, {lowered, test::moved("left-knee", knee.slack + Vec3(1e-9))}, 6.0);
  CHECK(glm::length(after.joint("shin.l") - before.joint("shin.l")) < 1e-3 * moving.body.height);
}

TEST_CASE("an offset along a controller's carrier axes takes it there in the world") {
  const MovingBiped moving = punchingBiped();
  const std::vector<Adjustment> bent{turned("hips", {0, 50, 10}), turned("spine-top", {20, 0, 30}),
                                     turned("body", {0, 70, 0})};
  const Vec3 wanted = 0.03 * moving.body.height * Vec3(1.0, 0.5, -0.3);
  const Placed before(moving, bent, 12.0);
  for (const char* id : {"body", "hips", "spine-mid", "spine-top", "head", "left-hand", "right-foot"}) {
    std::vector<Adjustment> adjustments = bent;
    const Vec3 move = glm::transpose(before[id].carrierAxesWorld) * wanted;
    const auto own = std::ranges::find(adjustments, id, &Adjustment::controller);
    if (own == adjustments.end()) {
      adjustments.push_back(test::moved(id, move));
    } else {
      own->keys.front().move = move;
    }
    const Placed after(moving, adjustments, 12.0);
    INFO(id);
    CHECK(glm::length(after[id].placeWorld - before[id].placeWorld - wanted) < 1e-3 * moving.body.height);
  }
}

TEST_CASE("a horse's hips carry its tail and its hind legs, its chest its head and its front legs") {
  const MovingBiped horse = pawingHorse();
  const Placed placed(horse, {}, 6.0);
  for (const char* id : {"spine-top", "tail-tip", "hind-left-foot"}) {
    CHECK(placed[id].carrier == Carrier::hips);
  }
  for (const char* id : {"head", "front-left-foot"}) {
    CHECK(placed[id].carrier == Carrier::chest);
  }
  CHECK(placed["body"].carrier == Carrier::scene);
}

TEST_CASE("every joint that no controller of the body moves has one of its own, turned along its carrier") {
  const MovingBiped moving = punchingBiped();
  const Placed placed(moving, {turned("spine-top", {0, 40, 0})}, 12.0);
  const PlacedController& clavicle = placed[moving.scene.nodes[at(moving.node.at("clavicle.l"))].name];
  CHECK(clavicle.kind == ControllerKind::joint);
  CHECK_FALSE(clavicle.moves);
  CHECK(clavicle.placeWorld == placed.joint("clavicle.l"));
  const bool limbsOwn = std::ranges::any_of(placed.all(), [&](const PlacedController& one) {
    return one.kind == ControllerKind::joint && one.node == moving.node.at("foreArm.l");
  });
  CHECK_FALSE(limbsOwn);
}
