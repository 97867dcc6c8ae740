#include "app/commands/pose/held_controllers.h"

#include <sstream>
#include <tuple>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/table/modal.h"
#include "core/math/rotation.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double degree = pi / 180.0;

rig::PlacedController placed(const std::string& id, rig::ControllerKind kind,
                             rig::Carrier carrier = rig::Carrier::scene) {
  rig::PlacedController controller;
  controller.carrier = carrier;
  controller.id = id;
  controller.kind = kind;
  return controller;
}

// A hand whose carrier is turned by a quarter about Y: its X is the world's -Z.
rig::PlacedController turnedHand() {
  rig::PlacedController hand = placed("left-hand", rig::ControllerKind::hand);
  hand.carrierAxesWorld = glm::mat3_cast(axisAngle({0, 1, 0}, 90.0 * degree));
  return hand;
}

PullModal sphereModal() {
  PullModal modal;
  modal.hasCarriers = false;
  modal.arrowUnits = 0.01;
  return modal;
}

void type(PullModal& modal, const std::string& keys) {
  std::istringstream words(keys);
  for (std::string word; words >> word;) {
    REQUIRE(pressKey(modal, {*parseChord(word), 0}) == ModalOutcome::running);
  }
}

ControllerOffset changed(const PullModal& modal, const rig::PlacedController& one,
                         const ControllerOffset& offset = {"left-hand"}) {
  const std::vector<HeldController> held{{one, offset}};
  return changedOffsets(modal, held).front();
}

bool near(const Vec3& a, const Vec3& b) {
  return glm::length(a - b) < 1e-9;
}

} // namespace

TEST_CASE("a controller is moved along the locked axis of the world by what is typed") {
  PullModal modal;
  type(modal, "Z - . 1");
  const ControllerOffset offset = changed(modal, turnedHand(), {"left-hand", {0.5, 0.0, 0.0}});
  CHECK(near(offset.move, Vec3(0.5 + 0.1, 0.0, 0.0)));
  CHECK(modalText(modal, "left hand") == "left hand moved along Z by -0.100");
}

TEST_CASE("an axis that is locked twice is the carrier's, three times none") {
  PullModal modal;
  type(modal, "X X 2");
  CHECK(near(changed(modal, turnedHand()).move, Vec3(2.0, 0.0, 0.0)));
  type(modal, "X");
  CHECK_FALSE(modal.lock.axis);
}

TEST_CASE("without a lock the mouse moves in the view plane, with Shift and an axis without that axis") {
  PullModal modal;
  modal.mouseWorld = {1.0, 2.0, 3.0};
  const rig::PlacedController hand = placed("left-hand", rig::ControllerKind::hand);
  CHECK(near(changed(modal, hand).move, Vec3(1.0, 2.0, 3.0)));
  type(modal, "Shift+Y");
  CHECK(near(changed(modal, hand).move, Vec3(1.0, 0.0, 3.0)));
}

TEST_CASE(
    "a controller is turned about the locked axis by the degrees that are typed, more than a turn too") {
  PullModal modal;
  modal.motion = PullMotion::turn;
  type(modal, "X 4 5");
  const rig::PlacedController head = placed("head", rig::ControllerKind::head);
  CHECK(near(changed(modal, head).turn, Vec3(45.0 * degree, 0.0, 0.0)));
  type(modal, "0");
  CHECK(near(changed(modal, head).turn, Vec3(450.0 * degree, 0.0, 0.0)));
  CHECK(modalText(modal, "head") == "head turned about X by 450.0°");
}

TEST_CASE("a turn in the world goes on top of the one that is there") {
  PullModal modal;
  modal.motion = PullMotion::turn;
  type(modal, "Y 3 0");
  const rig::PlacedController hand = turnedHand();
  const Vec3 before(0.0, 0.0, 60.0 * degree);
  const Vec3 after = changed(modal, hand, {"left-hand", Vec3(0.0), before}).turn;
  const auto inWorld = [&](const Vec3& vector) {
    const Vec3 world = hand.carrierAxesWorld * vector;
    return axisAngle(glm::normalize(world), glm::length(world));
  };
  const Quat expected = axisAngle({0, 1, 0}, 30.0 * degree) * inWorld(before);
  CHECK(std::abs(glm::dot(expected, inWorld(after))) == Approx(1.0));
  const Vec3 twice = changed(modal, hand, {"left-hand", Vec3(0.0), {0.0, 700.0 * degree, 0.0}}).turn;
  CHECK(near(twice, Vec3(0.0, 730.0 * degree, 0.0)));
}

TEST_CASE("several controllers move together: what another one carries is not moved twice") {
  const std::vector<rig::PlacedController> selected{
      placed("hips", rig::ControllerKind::hips),
      placed("left-hand", rig::ControllerKind::hand, rig::Carrier::chest),
      placed("left-foot", rig::ControllerKind::foot, rig::Carrier::hips)};
  const std::vector<ControllerOffset> offsets{{"hips"}, {"left-hand"}, {"left-foot"}};
  const std::vector<HeldController> held = heldControllers(PullMotion::move, selected, offsets);
  REQUIRE(held.size() == 2);
  CHECK(held[0].placed.id == "hips");
  CHECK(held[1].placed.id == "left-foot");
  CHECK(heldControllers(PullMotion::turn, selected, offsets).size() == 3);
}

TEST_CASE("the chest carries the head and the wings, not the tail, and no foot") {
  const rig::PlacedController chest = placed("spine-top", rig::ControllerKind::spineTop, rig::Carrier::hips);
  const auto movesWithChest = [&](const std::string& id, rig::ControllerKind kind, rig::Carrier carrier) {
    const std::vector<rig::PlacedController> selected{chest, placed(id, kind, carrier)};
    const std::vector<ControllerOffset> offsets{{chest.id}, {id}};
    return heldControllers(PullMotion::move, selected, offsets).size() == 1;
  };
  CHECK(movesWithChest("head", rig::ControllerKind::head, rig::Carrier::chest));
  CHECK(movesWithChest("left-wing-tip", rig::ControllerKind::tip, rig::Carrier::chest));
  CHECK_FALSE(movesWithChest("tail-tip", rig::ControllerKind::tip, rig::Carrier::hips));
  CHECK_FALSE(movesWithChest("front-left-foot", rig::ControllerKind::foot, rig::Carrier::chest));
}

TEST_CASE("what only turns cannot be moved, what only moves not be turned") {
  rig::PlacedController joint = placed("toe", rig::ControllerKind::joint);
  joint.moves = false;
  rig::PlacedController pole = placed("left-knee", rig::ControllerKind::pole);
  pole.turns = false;
  const std::vector<rig::PlacedController> selected{joint, pole};
  const std::vector<ControllerOffset> offsets{{"toe"}, {"left-knee"}};
  CHECK(heldControllers(PullMotion::move, selected, offsets).front().placed.id == "left-knee");
  CHECK(heldControllers(PullMotion::turn, selected, offsets).front().placed.id == "toe");
}

TEST_CASE("a pole's first move starts where it is seen") {
  rig::PlacedController pole = placed("left-knee", rig::ControllerKind::pole);
  pole.slack = {0.0, 0.0, 0.2};
  PullModal modal;
  CHECK(near(changed(modal, pole).move, Vec3(0.0)));
  type(modal, "X 1");
  CHECK(near(changed(modal, pole).move, Vec3(1.0, 0.0, 0.2)));
}

TEST_CASE("Enter keeps and Escape restores") {
  PullModal modal;
  CHECK(pressKey(modal, {*parseChord("Enter"), 0}) == ModalOutcome::keep);
  CHECK(pressKey(modal, {*parseChord("Esc"), 0}) == ModalOutcome::restore);
}

TEST_CASE("spheres are pulled along X by what is typed, and let go of the axis by pressing it again") {
  PullModal modal = sphereModal();
  modal.mouseWorld = Vec3(5.0);
  type(modal, "X 0 . 2");
  CHECK(worldChange(modal).x == Approx(0.2));
  CHECK(worldChange(modal).y == 0.0);
  CHECK(modalText(modal, "sphere") == "sphere moved along X by 0.200");
  CHECK(modalHints(modal)[3].does == "lock an axis");
  type(modal, "X");
  CHECK_FALSE(modal.lock.axis);
  CHECK_FALSE(modal.lock.ofCarrier);
}

TEST_CASE("spheres follow the mouse, locked to an axis or to a plane") {
  PullModal modal = sphereModal();
  modal.mouseWorld = Vec3(1.0, 2.0, 3.0);
  CHECK(worldChange(modal) == Vec3(1.0, 2.0, 3.0));
  type(modal, "Y");
  CHECK(worldChange(modal) == Vec3(0.0, 2.0, 0.0));
  type(modal, "Shift+Y");
  CHECK(worldChange(modal) == Vec3(1.0, 0.0, 3.0));
  type(modal, "Shift+Y");
  CHECK(worldChange(modal) == Vec3(1.0, 2.0, 3.0));
}

TEST_CASE("spheres are pulled by arrows and with a minus") {
  PullModal modal = sphereModal();
  type(modal, "Right Shift+Up Ctrl+Left");
  CHECK(worldChange(modal).x == Approx(0.009));
  CHECK(worldChange(modal).y == Approx(0.1));
  type(modal, "Z 3 -");
  CHECK(worldChange(modal).z == Approx(-3.0));
}

TEST_CASE(
    "Arrows nudge along the view's axes and pages towards it and away, ten times as far with Shift and a "
    "tenth with Ctrl") {
  const Mat3 axes(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0)); // right, up, to the viewer
  const std::vector<std::pair<const char*, Vec3>> ways{
      {"Right", {0.0, 0.0, -1.0}}, {"Left", {0.0, 0.0, 1.0}},     {"Up", {0.0, 1.0, 0.0}},
      {"Down", {0.0, -1.0, 0.0}},  {"PageDown", {1.0, 0.0, 0.0}}, {"PageUp", {-1.0, 0.0, 0.0}}};
  for (const auto& [key, way] : ways) {
    CAPTURE(key);
    for (const auto& [before, factor] :
         {std::pair("", 1.0), std::pair("Shift+", 10.0), std::pair("Ctrl+", 0.1)}) {
      const auto chord = parseChord(std::string(before) + key);
      REQUIRE(chord);
      CHECK(glm::length(nudgeOf(*chord, axes, 0.02) - 0.02 * factor * way) < 1e-12);
    }
  }
  CHECK(nudgeOf(*parseChord("Home"), axes, 0.02) == Vec3(0.0));
}

TEST_CASE("A number is typed digit by digit, turned round by a minus and taken back") {
  TypedNumber number;
  const auto type = [&](const std::vector<const char*>& keys) {
    bool taken = true;
    for (const char* const key : keys) {
      taken = typeNumber(number, *parseChord(key)) && taken;
    }
    return taken;
  };
  CHECK(type({"1", "2", ".", "5"}));
  CHECK(number.text == "12.5");
  CHECK(type({"."}));
  CHECK(number.text == "12.5");
  CHECK(type({"-"}));
  CHECK(number.text == "-12.5");
  CHECK(number.value() == Approx(-12.5));
  CHECK(type({"Numpad -"}));
  CHECK(number.text == "12.5");
  CHECK(type({"Numpad -"}));
  CHECK(number.text == "-12.5");
  CHECK(type({"-", "Backspace", "Backspace"}));
  CHECK(number.text == "12");
  CHECK(type({"Backspace", "Backspace", "Backspace"}));
  CHECK(number.text.empty());
  CHECK(type({"1", "2", "3", "4", "5", "6", "7", "8", "9"}));
  type({"0"});
  CHECK(number.text == "123456789");
  CHECK_FALSE(type({"Home"}));
  CHECK(number.text == "123456789");
}

TEST_CASE("What is typed keeps to the plane of the lock, as the mouse does") {
  PullModal modal = sphereModal();
  modal.viewAxes = Mat3(Vec3(0.6, 0.0, 0.8), Vec3(0.0, 1.0, 0.0), Vec3(-0.8, 0.0, 0.6));
  type(modal, "2");
  CHECK(near(worldChange(modal, Mat3(1.0)), {1.2, 0.0, 1.6}));
  type(modal, "Shift+X");
  CHECK(near(worldChange(modal, Mat3(1.0)), {0.0, 0.0, 2.0}));
  modal.viewAxes = Mat3(1.0); // X points to the right: up is left
  CHECK(near(worldChange(modal, Mat3(1.0)), {0.0, 2.0, 0.0}));
  type(modal, "X");
  CHECK(near(worldChange(modal, Mat3(1.0)), {2.0, 0.0, 0.0}));
}

TEST_CASE("Turns about one axis add up past half turns and whole ones, either way, and cancel out") {
  for (const auto& [before, change, after] : {std::tuple(0.0, -200.0, -200.0),
                                              {350.0, 20.0, 370.0},
                                              {-350.0, -20.0, -370.0},
                                              {170.0, 20.0, 190.0},
                                              {190.0, -20.0, 170.0},
                                              {180.0, 180.0, 360.0},
                                              {60.0, -60.0, 0.0},
                                              {370.0, -20.0, 350.0}}) {
    CAPTURE(before, change);
    const Vec3 turn = turnedFurther({0.0, 0.0, before * degree}, {0.0, 0.0, change * degree});
    CHECK(near(turn, Vec3(0.0, 0.0, after * degree)));
  }
}
