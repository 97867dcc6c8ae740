#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/limb.h"
#include "rig/motion/order.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/soft_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const std::string spineChain = "the spine, picked as a chain";

// The joints of the spine as a chain that the user picked, instead of the spine or beside it.
MovingBiped withSpineChain() {
  MovingBiped moving = punchingBiped();
  Limb chain = moving.limb("spine");
  chain.kind = LimbKind::chain;
  chain.id = spineChain;
  moving.body.limbs.push_back(chain);
  return moving;
}

Trail trailOf(int id, const std::string& limb, double scale) {
  Trail trail = connectedTrail(limb, 0, 12, scale);
  trail.id = id;
  return trail;
}

Vec3 handOf(const MovingBiped& moving, const MotionState& motion, double frame) {
  return endPosition(moving.limb("left-arm"), atFrame(moving, motion, frame));
}

std::vector<std::string> orderOf(const MotionState& motion) {
  std::vector<std::string> ids;
  std::transform(motion.trails.begin(), motion.trails.end(), std::back_inserter(ids),
                 [](const SolvedTrail& trail) { return trail.limb.id; });
  return ids;
}

} // namespace

TEST_CASE("a hand that stays in the world stays there, whatever the limb that carries the arm is called") {
  const MovingBiped moving = withSpineChain();
  Trail arm = trailOf(1, "left-arm", 1.2);
  const MotionState armOnly = solved(moving, {arm});
  arm.settings.stayInWorld = true;
  for (const std::string& inner : {std::string("spine"), spineChain}) {
    CAPTURE(inner);
    const MotionState motion = solved(moving, {arm, trailOf(2, inner, 1.6)});
    CHECK(orderOf(motion) == std::vector<std::string>{inner, "left-arm"});
    for (double frame = 0.0; frame <= 24.0; frame += 1.0) {
      CAPTURE(frame);
      CHECK(glm::length(handOf(moving, motion, frame) - handOf(moving, armOnly, frame)) < 1e-4);
    }
  }
}

TEST_CASE("an arm on a stretched chain holds its own length at its tip, and its path is drawn there") {
  const MovingBiped moving = withSpineChain();
  const Limb& arm = moving.limb("left-arm");
  const MotionState motion = solved(moving, {trailOf(1, "left-arm", 2.0), trailOf(2, spineChain, 1.6)});
  CHECK(lengthOf(arm, atFrame(moving, motion, 12)) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  const DrawnTrail drawn = pathsAt(moving.scene, moving.clip, motion, 1, {12.0});
  CHECK(glm::length(drawn.exaggerated.front() - handOf(moving, motion, 12)) < 1e-4);
}

TEST_CASE("paths that are asked for together are drawn where each is drawn alone, in any order") {
  const MovingBiped moving = withSpineChain();
  const MotionState motion = solved(moving, {trailOf(1, "left-arm", 2.0), trailOf(2, spineChain, 1.6)});
  const std::vector<double> frames = {6.0, 12.0};
  const std::vector<DrawnTrail> drawn =
      pathsAt(moving.scene, moving.clip, motion, {PathRequest{1, frames}, PathRequest{0, frames}});
  CHECK(drawn[0] == pathsAt(moving.scene, moving.clip, motion, 1, frames));
  CHECK(drawn[1] == pathsAt(moving.scene, moving.clip, motion, 0, frames));
}

TEST_CASE("a chain from the root acts before the spine and the legs that it carries") {
  MovingBiped moving = punchingBiped();
  Limb chain = moving.limb("spine");
  chain.kind = LimbKind::chain;
  chain.id = "lower";
  chain.joints = {moving.node.at("root"), moving.node.at("hips")};
  chain.endNode = moving.limb("spine").joints.back();
  moving.body.limbs.push_back(chain);
  const MotionState motion = solved(moving, {trailOf(1, "left-leg", 1.2), trailOf(2, "left-arm", 1.2),
                                             trailOf(3, "lower", 1.2), trailOf(4, "spine", 1.2)});
  CHECK(orderOf(motion) == std::vector<std::string>{"lower", "spine", "left-arm", "left-leg"});
}

TEST_CASE("a limb acts right after the last of those that carry it") {
  MovingBiped moving = withSpineChain();
  Limb chain = moving.limb("spine");
  chain.kind = LimbKind::chain;
  chain.id = "lower";
  chain.joints = {moving.node.at("root"), moving.node.at("hips")};
  chain.endNode = moving.limb("spine").joints.back();
  std::erase_if(moving.body.limbs, [](const Limb& limb) { return limb.id == "spine"; });
  moving.body.limbs.push_back(chain);
  const MotionState motion = solved(moving, {trailOf(1, "left-arm", 1.2), trailOf(2, "left-leg", 1.2),
                                             trailOf(3, spineChain, 1.2), trailOf(4, "lower", 1.2)});
  CHECK(orderOf(motion) == std::vector<std::string>{"lower", "left-leg", spineChain, "left-arm"});
}

TEST_CASE("trails of one limb act in the order of their starts, and a circle of limbs keeps all of them") {
  Scene scene;
  scene.nodes.resize(4);
  const auto hang = [&](std::size_t child, NodeIndex parent) {
    scene.nodes[child].parent = parent;
    scene.nodes[at(parent)].children.emplace_back(child);
  };
  hang(1, NodeIndex(0));
  hang(3, NodeIndex(2));
  Limb one{{}, "one", {NodeIndex(1)}, NodeIndex(2), Vec3(0.0), 1.0, 1.0, {}}; // its end is above
                                                                              // the other's base
  Limb other{biped::leftArm, "other", {NodeIndex(3)}, NodeIndex(0), Vec3(0.0), 1.0, 1.0, {}};
  CHECK(carries(scene, one, other));
  CHECK(carries(scene, other, one));
  CHECK_FALSE(carries(scene, one, one));
  CHECK(actingOrder(scene, {{&one, 2.0}, {&other, 3.0}, {&one, 1.0}}) == std::vector<std::size_t>{1, 2, 0});
}

TEST_CASE("limbs give way from the root outwards, chains included") {
  const MovingBiped moving = withSpineChain();
  const auto firm = [](double) { return SoftBones{}; };
  const MotionState motion =
      softMotion(moving, {}, {softLimb(moving, "left-arm", firm), softLimb(moving, spineChain, firm)});
  REQUIRE(motion.weights.size() == 2);
  CHECK(motion.weights.front().limb.id == spineChain);
}

TEST_CASE("of limbs that carry none of each other the trunk acts first, then arms, legs and all others") {
  Scene scene;
  std::vector<Limb> limbs;
  for (const LimbPlace& place : {LimbPlace{LimbKind::tail}, biped::leftLeg, biped::rightArm, biped::leftArm,
                                 biped::neck, biped::spine}) {
    Limb limb;
    static_cast<LimbPlace&>(limb) = place;
    limb.joints = {addNode(scene, "base", NodeIndex::none, Vec3(0.0))};
    limbs.push_back(limb);
  }
  const std::vector<double> starts{0.0, 1.0, 3.0, 2.0, 4.0, 5.0};
  std::vector<ActingLimb> acting;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    acting.push_back({&limbs[i], starts[i]});
  }
  CHECK(actingOrder(scene, acting) == std::vector<std::size_t>{5, 4, 3, 2, 1, 0});
}
