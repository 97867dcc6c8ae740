// Limbs below joints that are scaled unevenly reach their places in bodies of any size, and adjustments
// without keys do nothing.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// Without its way along the ground, which is as long whatever the size.
MovingBiped punchingOfSize(double size) {
  SyntheticBiped body = namedBody();
  body.size = size;
  MovingBiped moving = still(body);
  addPunch(moving, Interpolation::linear);
  std::erase_if(moving.clip.tracks,
                [](const CopyOnWrite<Track>& track) { return track->channel == Channel::translation; });
  return moving;
}

} // namespace

TEST_CASE("A pinned hand below an unevenly scaled chest stays at its place to a millionth of its arm") {
  for (const double size : {1.0, 100.0, 0.01}) {
    for (const char* const limb : {"left-arm", "right-arm"}) {
      CAPTURE(size, limb);
      MovingBiped moving = punchingOfSize(size);
      moving.scene.nodes[at(moving.node.at("spine2"))].rest.scale = Vec3(1.0, 1.06, 0.97);
      Pin pin = pinAt(limb, heldOver(4.0, 20.0), 8.0);
      HeldPlace place = endPlaceOf(moving, limb, sourceAtFrame(moving, 8.0));
      place.position += size * Vec3(0.0, -0.02, -0.015);
      pin.place = place;
      const MotionState motion = held(moving, {{pin}, {}, {}});
      for (double frame = 4.0; frame <= 20.0; frame += 2.0) {
        const HeldPlace now = endPlaceOf(moving, limb, atFrame(moving, motion, frame));
        CHECK(glm::distance(now.position, place.position) < 1e-6 * moving.limb(limb).restLength);
      }
    }
  }
}

TEST_CASE("Adjustments without keys, of controllers, joints and values, leave a motion as it is") {
  const MovingBiped moving = punchingBiped();
  const MotionState without = adjusted(moving, {});
  const std::string finger = moving.scene.nodes[at(moving.node.at("clavicle.l"))].name;
  for (const std::string& id : {std::string("left-hand"), std::string("left-elbow"), std::string("hips"),
                                std::string("left-arm.stretch"), finger}) {
    CAPTURE(id);
    const MotionState with = adjusted(moving, {Adjustment{id, 0, std::nullopt, {}}});
    CHECK(with.adjustments.joints.size() == without.adjustments.joints.size());
    for (double frame = 0.0; frame <= 24.0; frame += 3.0) {
      CHECK(largestMatrixMiss(atFrame(moving, with, frame), atFrame(moving, without, frame)) == 0.0);
    }
  }
}
