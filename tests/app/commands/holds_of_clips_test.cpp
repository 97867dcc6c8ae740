// Commands on holds leave those of other clips alone, and grips do not lead in circles while they blend.
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/edits/pose/hold_edits.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The boxer with the same clip twice and a stick beside it.
Document ofTwoClips() {
  Document document = test::boxer();
  Scene scene = *document.scene;
  scene.meshes.push_back({"Stick", {Primitive{}}, {}});
  const NodeIndex stick = test::addNode(scene, "Stick", NodeIndex::none, {0.8, 1.5, 0.0});
  scene.nodes[at(stick)].mesh = 0;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clips.front());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  return document;
}

rig::Prop stickIn(int clip, const std::vector<rig::OffsetKey>& keys) {
  rig::Prop prop;
  prop.node = "Stick";
  prop.clip = clip;
  prop.boundFrame = 0.0;
  prop.hands = {{"left-arm", keys}};
  return prop;
}

rig::Grip gripOf(const std::string& follower, const std::string& leader, const Vec2& range, const Vec2& blend,
                 int clip = 0) {
  return {follower, leader, clip, {range, blend}, {}, 1.0};
}

Document withHolds(const rig::Holds& holds) {
  const Result<Document> placed = placeHolds(ofTwoClips(), holds);
  INFO((placed ? std::string() : placed.error().line()));
  REQUIRE(placed);
  return *placed;
}

Session workedIn(const Document& document, int clip, const char* limb) {
  Session session(document);
  session.view().clip = clip;
  session.view().frame = 8.0;
  session.view().selection.editTrails().limbs = {limb};
  return session;
}

} // namespace

TEST_CASE("A prop is let go in the clip that is worked in alone, from as firm as it was held") {
  rig::Holds holds;
  for (const int clip : {0, 1}) {
    holds.props.push_back(stickIn(clip, {{.frame = 0.0, .value = 0.6}}));
  }
  const Document document = withHolds(holds);
  for (const int clip : {0, 1}) {
    Session session = workedIn(document, clip, "left-arm");
    CHECK(test::run(session, command::holdLetGo).empty());
    for (const rig::Prop& prop : session.document().holds.props) {
      const std::vector<rig::OffsetKey>& keys = prop.hands[0].keys;
      REQUIRE(keys.size() == (prop.clip == clip ? 3U : 1U));
      if (prop.clip == clip) {
        CHECK(keys[1].frame == 8.0);
        CHECK(keys[1].value == 0.6);
        CHECK(keys[2].frame == 11.0);
        CHECK(keys[2].value == 0.0);
      }
    }
  }
}

TEST_CASE("Holds are taken away in the clip that is worked in alone, of whichever kind") {
  rig::Holds holds;
  for (const int clip : {0, 1}) {
    holds.props.push_back(stickIn(clip, {{.frame = 0.0, .value = 1.0}}));
    holds.grips.push_back(gripOf("right-arm", "left-arm", {0.0, 5.0}, {0.0, 0.0}, clip));
    rig::Pin pin;
    pin.limb = "left-arm";
    pin.clip = clip;
    pin.time = {{10.0, 15.0}, {0.0, 0.0}};
    pin.atFrame = 12.0;
    holds.pins.push_back(pin);
  }
  Session session = workedIn(withHolds(holds), 1, "left-arm");
  CHECK(test::run(session, command::holdRemove).empty());
  const rig::Holds& left = session.document().holds;
  REQUIRE(left.props.size() == 1);
  REQUIRE(left.grips.size() == 1);
  REQUIRE(left.pins.size() == 1);
  CHECK(left.props[0].clip + left.grips[0].clip + left.pins[0].clip == 0);
}

TEST_CASE("M lets go the grip of the clip that is worked in, and makes one where only another clip has it") {
  rig::Holds holds;
  holds.grips.push_back(gripOf("right-arm", "left-arm", {0.0, 20.0}, {0.0, 0.0}, 0));
  Session session = workedIn(withHolds(holds), 1, "left-arm");
  CHECK(test::run(session, command::holdMatch).empty());
  REQUIRE(session.document().holds.grips.size() == 2);
  CHECK(session.document().holds.grips[1].clip == 1);
  CHECK(test::run(session, command::holdMatch).empty());
  REQUIRE(session.document().holds.grips.size() == 1);
  CHECK(session.document().holds.grips[0].clip == 0);
}

TEST_CASE("Grips lead in a circle where their blends meet, in and out, and not where they are apart") {
  const auto isTaken = [](const Vec2& firstBlend, const Vec2& secondBlend) {
    rig::Holds holds;
    holds.grips = {gripOf("right-arm", "left-arm", {0.0, 6.0}, firstBlend),
                   gripOf("left-arm", "right-arm", {12.0, 18.0}, secondBlend)};
    const bool isForward = placeHolds(ofTwoClips(), holds).ok();
    std::swap(holds.grips[0], holds.grips[1]);
    CHECK(placeHolds(ofTwoClips(), holds).ok() == isForward);
    return isForward;
  };
  CHECK(isTaken({0.0, 0.0}, {0.0, 0.0}));
  CHECK(isTaken({0.0, 2.0}, {2.0, 0.0}));
  CHECK_FALSE(isTaken({0.0, 4.0}, {4.0, 0.0}));
  CHECK_FALSE(isTaken({0.0, 7.0}, {0.0, 0.0}));
  CHECK_FALSE(isTaken({0.0, 0.0}, {7.0, 0.0}));
}

TEST_CASE("Only what a hand holds at the playhead is let go: what it takes later stays") {
  rig::Holds holds;
  holds.props.push_back(stickIn(0, {{.frame = 0.0, .value = 1.0}}));
  rig::Prop later = stickIn(0, {{.frame = 0.0, .value = 0.0}, {.frame = 20.0, .value = 1.0}});
  later.node = "Stick of the other clip";
  rig::Prop ranged = stickIn(0, {{.frame = 0.0, .value = 1.0}});
  ranged.time = rig::HoldTime{{20.0, 30.0}, {3.0, 3.0}};
  ranged.node = "Later";
  holds.props.insert(holds.props.end(), {later, ranged});
  Document document = withHolds({});
  document.holds = holds;
  Session session = workedIn(document, 0, "left-arm");
  CHECK(test::run(session, command::holdLetGo).empty());
  const std::vector<rig::Prop>& props = session.document().holds.props;
  REQUIRE(props.size() == 3);
  CHECK(props[0].hands[0].keys.back().value == 0.0);
  CHECK(props[1] == later);
  CHECK(props[2] == ranged);
}

TEST_CASE("M lets go a grip that comes up to the shown range, and makes one beside a grip that does not") {
  struct Shown {
    Vec2 grip;
    Vec2 range;
    std::size_t grips;
  };
  for (const Shown& one : {Shown{{0.0, 5.0}, {5.0, 10.0}, 0}, Shown{{0.0, 5.0}, {6.0, 10.0}, 2},
                           Shown{{12.0, 18.0}, {4.0, 12.0}, 0}, Shown{{12.0, 18.0}, {4.0, 11.0}, 2}}) {
    CAPTURE(one.range.x, one.range.y);
    rig::Holds holds;
    holds.grips.push_back(gripOf("right-arm", "left-arm", one.grip, {0.0, 0.0}));
    Session session = workedIn(withHolds(holds), 0, "left-arm");
    session.view().rangeStart = one.range.x;
    session.view().rangeEnd = one.range.y;
    CHECK(test::run(session, command::holdMatch).empty());
    CHECK(session.document().holds.grips.size() == one.grips);
  }
}
