#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/things/place.h"
#include "core/math/types.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

template <typename T>
struct Wrong {
  std::function<void(T&)> make;
  std::string reason; ///< What the refusal begins with.
};

// Each fault by itself in a thing that is let in without it.
template <typename T>
void checkRefused(const std::vector<Wrong<T>>& faults, std::size_t which = 0) {
  const Document document = test::twoPunches();
  const Things all = test::oneOfEach(0, 0.5);
  const T sound = listOf<T>(all)[which];
  REQUIRE(test::refusal(placeOf<T>(document, {sound}, Entry::request)) == "accepted");
  for (const Wrong<T>& wrong : faults) {
    T thing = sound;
    wrong.make(thing);
    CHECK_THAT(test::refusal(placeOf<T>(document, {thing}, Entry::request)), Catch::StartsWith(wrong.reason));
  }
}

// Times that no hold may have; `timeOf` answers the time of one.
template <typename T, typename TimeOf>
std::vector<Wrong<T>> wrongTimes(const std::string& who, const TimeOf& timeOf) {
  const std::string noBlend = who + ": its blend is not a number of frames";
  return {
      {[=](T& hold) {
         timeOf(hold).rangeFrames = {12.0, 3.0};
       },
       who + ": its range ends before it starts"},
      {[=](T& hold) { timeOf(hold).rangeFrames.y = endless; }, who + ": a number of its range is not finite"},
      {[=](T& hold) { timeOf(hold).blendFrames.x = -endless; },
       who + ": a number of its range is not finite"},
      {[=](T& hold) { timeOf(hold).blendFrames.x = -1.0; }, noBlend},
      {[=](T& hold) { timeOf(hold).blendFrames.y = -1.0; }, noBlend},
      {[=](T& hold) { timeOf(hold).blendFrames.x = 2e6; }, noBlend},
      {[=](T& hold) { timeOf(hold).blendFrames.y = 2e6; }, noBlend},
      {[=](T& hold) {
         timeOf(hold).rangeFrames = {3.0, 20.5};
       },
       who + ": its range 3 to 20.5"},
      {[=](T& hold) {
         timeOf(hold).rangeFrames = {-5.0, -1.0};
       },
       who + ": its range -5 to -1"},
      {[=](T& hold) { hold.clip = 2; }, "clip 2: the file has no such clip"},
      {[=](T& hold) { hold.clip = -1; }, "clip -1: the file has no such clip"},
      {[=](T& hold) { hold.stretch = -0.1; }, who + ": its stretch is out of range"},
      {[=](T& hold) { hold.stretch = 1.1; }, who + ": its stretch is out of range"},
  };
}

void setPlace(rig::Pin& pin, const Vec3& position, const Quat& orientation = Quat(1.0, 0.0, 0.0, 0.0)) {
  pin.place = rig::HeldPlace{position, orientation};
}

} // namespace

TEST_CASE("A pin is refused by what is wrong with it") {
  using rig::Pin;
  checkRefused(wrongTimes<Pin>("right-arm", [](Pin& pin) -> rig::HoldTime& { return pin.time; }));
  const std::string noNumber = "right-arm: its place is not finite";
  checkRefused<Pin>({
      {[](Pin& pin) { pin.limb = "tail"; }, "tail: the character has no hand or foot of a limb 'tail'"},
      {[](Pin& pin) { pin.limb = "spine"; }, "spine: the character has no hand or foot of a limb 'spine'"},
      {[](Pin& pin) { pin.atFrame = 20.5; }, "right-arm: frame 20.5"},
      {[](Pin& pin) { pin.atFrame = -1.0; }, "right-arm: frame -1"},
      {[](Pin& pin) { pin.atFrame = endless; }, "right-arm: frame inf"},
      {[](Pin& pin) {
         setPlace(pin, {0.0, endless, 0.0});
       },
       noNumber},
      {[](Pin& pin) { setPlace(pin, Vec3(0.0), Quat(0.0, 0.0, 0.0, 0.0)); }, noNumber},
      {[](Pin& pin) { setPlace(pin, Vec3(0.0), Quat(0.0, 3.0, 0.0, 0.0)); }, noNumber},
      {[](Pin& pin) {
         setPlace(pin, {0.0, 1801.0, 0.0});
       },
       "right-arm: its place is out of proportion"},
  });
}

TEST_CASE("A grip is refused by what is wrong with it") {
  using rig::Grip;
  checkRefused(wrongTimes<Grip>("right-arm", [](Grip& grip) -> rig::HoldTime& { return grip.time; }));
  checkRefused<Grip>({
      {[](Grip& grip) { grip.follower = "tail"; }, "tail: the character has no hand or foot"},
      {[](Grip& grip) { grip.leader = "tail"; }, "tail: the character has no hand or foot"},
      {[](Grip& grip) { grip.leader = "right-arm"; }, "right-arm: it follows itself"},
      {[](Grip& grip) { grip.relationFrame = 21.0; }, "right-arm: frame 21"},
      {[](Grip& grip) { grip.relationFrame = -1.0; }, "right-arm: frame -1"},
  });
}

TEST_CASE("A prop is refused by what is wrong with it") {
  using rig::Prop;
  checkRefused(wrongTimes<Prop>("Stick", [](Prop& prop) -> rig::HoldTime& {
    return prop.time ? *prop.time : prop.time.emplace(rig::HoldTime{{3.0, 12.0}, {0.0, 0.0}});
  }));
  const std::string hand = "Stick.left-arm: ";
  const std::string offset = "Stick: the offset at its binding is out of proportion";
  checkRefused<Prop>({
      {[](Prop& prop) { prop.node = "Bat"; }, "Bat: the file has no such node"},
      {[](Prop& prop) { prop.node = "LeftForeArm"; }, "LeftForeArm: is part of the body"},
      {[](Prop& prop) { prop.node = "Hips"; }, "Hips: is part of the body"},
      {[](Prop& prop) { prop.hands.clear(); }, "Stick: no hand holds it"},
      {[](Prop& prop) { prop.hands[0].limb = "tail"; }, "tail: the character has no hand or foot"},
      {[](Prop& prop) { prop.hands.push_back(prop.hands[0]); }, hand + "the hand is named twice"},
      {[](Prop& prop) { prop.hands[0].keys.clear(); }, hand + "the hand is named twice, or has no keys"},
      {[](Prop& prop) { prop.hands[0].keys[0].value = 1.1; }, hand + "the value at frame 8 is out of range"},
      {[](Prop& prop) { prop.hands[0].keys[0].value = -0.1; }, hand + "the value at frame 8 is out of range"},
      {[](Prop& prop) { prop.hands[0].keys[0].frame = endless; }, hand + "the value at frame inf is out of"},
      {[](Prop& prop) { prop.hands[0].keys.push_back(prop.hands[0].keys[0]); },
       hand + "two keys stand at frame 8"},
      {[](Prop& prop) { prop.move.z = 1801.0; }, offset},
      {[](Prop& prop) { prop.turn.x = 629.0; }, offset},
      {[](Prop& prop) { prop.turn.x = endless; }, offset},
      {[](Prop& prop) { prop.boundFrame = 21.0; }, "Stick: frame 21"},
  });
}

TEST_CASE("Offsets of a controller are refused by what is wrong with them") {
  using rig::Adjustment;
  const std::string outside = "hips: the offset at frame 8 is out of proportion";
  const auto onPole = [](Adjustment& adjustment) {
    adjustment.controller = "left-elbow";
    adjustment.keys[0].move = Vec3(0.0, 0.1, 0.0);
  };
  checkRefused<Adjustment>({
      {[](Adjustment& hips) { hips.clip = 2; }, "clip 2: the file has no such clip"},
      {[](Adjustment& hips) { hips.rangeFrames = Vec2(9.0, 9.0); }, "hips: the range has no length"},
      {[](Adjustment& hips) { hips.rangeFrames = Vec2(21.0, 30.0); }, "hips: the range"},
      {[](Adjustment& hips) { hips.rangeFrames = Vec2(-9.0, -1.0); }, "hips: the range"},
      {[](Adjustment& hips) { hips.keys[0].frame = 17.0; }, "hips: the key at frame 17 lies outside"},
      {[](Adjustment& hips) { hips.keys[0].frame = 1.0; }, "hips: the key at frame 1 lies outside"},
      {[](Adjustment& hips) { hips.keys.push_back(hips.keys[0]); }, "hips: two keys stand at frame 8"},
      {[](Adjustment& hips) { hips.keys.clear(); }, "hips: has no keys"},
      {[](Adjustment& hips) { hips.keys[0].moveSlope.x = endless; }, "hips: a number of a key is not finite"},
      {[](Adjustment& hips) { hips.keys[0].turnSlope.x = endless; }, "hips: a number of a key is not finite"},
      {[](Adjustment& hips) { hips.keys[0].move.x = 1801.0; }, outside},
      {[](Adjustment& hips) { hips.keys[0].moveSlope.x = 1801.0; }, outside},
      {[](Adjustment& hips) { hips.keys[0].turn.x = 629.0; }, outside},
      {[](Adjustment& hips) { hips.keys[0].turnSlope.x = 629.0; }, outside},
      {[=](Adjustment& elbow) {
         onPole(elbow);
         elbow.keys[0].turn.x = 0.1;
       },
       "left-elbow: moves and does not turn"},
      {[=](Adjustment& elbow) {
         onPole(elbow);
         elbow.keys[0].turnSlope.x = 0.1;
       },
       "left-elbow: moves and does not turn"},
  });
}

TEST_CASE("Values of an attribute are refused where they are out of proportion") {
  using rig::Adjustment;
  const std::string outside = "right-arm.stretch: the value at frame 8 is out of proportion";
  constexpr std::size_t attribute = 1; // in oneOfEach
  checkRefused<Adjustment>({{[](Adjustment& arm) { arm.keys[0].value = 1001.0; }, outside},
                            {[](Adjustment& arm) { arm.keys[0].value = -1001.0; }, outside},
                            {[](Adjustment& arm) { arm.keys[0].valueSlope = 1001.0; }, outside},
                            {[](Adjustment& arm) { arm.keys[0].valueSlope = endless; },
                             "right-arm.stretch: a number of a key is not finite"}},
                           attribute);
}

TEST_CASE("A trail is refused by what is wrong with it") {
  using rig::Trail;
  const std::string noNumber = "left-arm: a setting of the trail is not a number";
  checkRefused<Trail>({
      {[](Trail& trail) { trail.limb = "tail"; }, "tail: the character has no such limb"},
      {[](Trail& trail) { trail.clip = 2; }, "clip 2: the file has no such clip"},
      {[](Trail& trail) { trail.clip = -1; }, "clip -1: the file has no such clip"},
      {[](Trail& trail) { trail.settings.startFrame = -endless; }, noNumber},
      {[](Trail& trail) { trail.settings.endFrame = endless; }, noNumber},
      {[](Trail& trail) {
         trail.settings.spheres = {{endless, Vec3(0.0), {}}};
       },
       noNumber},
      {[](Trail& trail) {
         trail.settings.spheres = {{2.0, Vec3(0.0, 0.0, endless), {}}};
       },
       noNumber},
      {[](Trail& trail) {
         trail.settings.spheres = {{2.0, Vec3(0.0), Vec3(endless, 0.0, 0.0)}};
       },
       noNumber},
      {[](Trail& trail) {
         trail.settings.stopAt = rig::StopPlane{{0.0, endless, 0.0}, {0.0, 1.0, 0.0}};
       },
       noNumber},
      {[](Trail& trail) {
         trail.settings.stopAt = rig::StopPlane{{0.0, 1.0, 0.0}, {endless, 0.0, 0.0}};
       },
       noNumber},
      {[](Trail& trail) { trail.settings.endFrame = 0.0; }, "left-arm: the range 0 to 0 has no length"},
      {[](Trail& trail) {
         trail.settings.startFrame = 20.0;
         trail.settings.endFrame = 25.0;
       },
       "left-arm: the range 20 to 25 lies outside the clip, which has the frames 0 to 20"},
      {[](Trail& trail) {
         trail.settings.startFrame = -5.0;
         trail.settings.endFrame = 0.0;
       },
       "left-arm: the range -5 to 0 lies outside the clip"},
      {[](Trail& trail) { trail.settings.sight.asSeen = true; },
       "left-arm: the scale counts as seen, by no camera"},
      {[](Trail& trail) { trail.settings.sight.turnDegrees = 10.0; },
       "left-arm: the path is turned to the view, of no camera"},
      {[](Trail& trail) { trail.settings.sight.camera = "Shot"; }, "left-arm: there is no camera 'Shot'"},
  });
}
