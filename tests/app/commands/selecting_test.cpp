// Ways to select: what each takes and lets go of, which trails are then meant, and the range that follows.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;
using Names = std::vector<std::string>;
using Ids = std::vector<int>;

namespace {

/// Left arm twice, right arm and spine once: in the order of their numbers.
Session withTrails() {
  Document document = test::boxer();
  document = test::withNewTrail(document, {"left-arm", 1.0, 5.0});
  document = test::withNewTrail(document, {"left-arm", 10.0, 15.0});
  document = test::withNewTrail(document, {"right-arm", 8.0, 12.0});
  return Session(test::withNewTrail(document, {"spine", 1.0, 5.0}));
}

int trailAt(const Session& session, std::size_t place) {
  return session.document().trails.at(place).id;
}

std::optional<Vec2> rangeOf(const Session& session) {
  const ViewState& view = session.view();
  return view.rangeEnd >= view.rangeStart ? std::optional(Vec2(view.rangeStart, view.rangeEnd))
                                          : std::nullopt;
}

} // namespace

TEST_CASE("The range is that of the selected trail, and the one set by hand when no trail is selected") {
  struct Way {
    const char* says;
    std::function<void(Session&)> select;
    std::optional<Vec2> range; ///< Nothing: that set by hand.
  };
  const Way ways[] = {
      {"the trail", [](Session& s) { selectTrail(s, trailAt(s, 1)); }, Vec2(10.0, 15.0)},
      {"the trail in the list", [](Session& s) { selectTrailInList(s, trailAt(s, 2), false); },
       Vec2(8.0, 12.0)},
      {"its limb", [](Session& s) { selectLimb(s, "right-arm", false); }, Vec2(8.0, 12.0)},
      {"its group", [](Session& s) { selectGroup(s, trailAt(s, 3)); }, Vec2(1.0, 5.0)},
      {"a limb whose trails are elsewhere", [](Session& s) { selectLimb(s, "spine", false); }, std::nullopt},
      {"no trail", [](Session& s) { selectTrail(s, 0); }, std::nullopt},
      {"a controller", [](Session& s) { selectController(s, "left-hand", false); }, std::nullopt},
      {"controllers",
       [](Session& s) {
         selectControllers(s, {"left-hand", "hips"});
       },
       std::nullopt},
      {"a locator", [](Session& s) { selectLocator(s, "leftHand", false); }, std::nullopt},
      {"locators",
       [](Session& s) {
         selectLocators(s, {"leftHand", "hips"});
       },
       std::nullopt}};
  const Vec2 byHand(3.0, 7.0);
  for (const Way& way : ways) {
    CAPTURE(way.says);
    Session session = withTrails();
    session.view().frame = 11.0;
    session.view().rangeStart = byHand.x;
    session.view().rangeEnd = byHand.y;
    selectTrail(session, trailAt(session, 0));
    REQUIRE(rangeOf(session) == Vec2(1.0, 5.0));
    way.select(session);
    CHECK(rangeOf(session) == way.range.value_or(byHand));
    selectTrail(session, 0);
    CHECK(rangeOf(session) == byHand);
  }
}

TEST_CASE("A limb means its trail at the playhead, else its only one") {
  Session session = withTrails();
  const Ids left{trailAt(session, 0), trailAt(session, 1)};
  const Ids right{trailAt(session, 2)};
  for (const double frame : {0.0, 3.0, 7.0, 9.0, 14.0, 18.0}) {
    CAPTURE(frame);
    session.view().selection = {};
    session.view().frame = frame;
    session.view().selection.editTrails().limbs = {"left-arm"};
    CHECK(targetTrails(session) == (frame == 3.0 ? Ids{left[0]} : frame == 14.0 ? Ids{left[1]} : Ids{}));
    session.view().selection.editTrails().limbs = {"right-arm"};
    CHECK(targetTrails(session) == right);
    session.view().selection.editTrails().limbs = {"left-arm", "right-arm"};
    CHECK(targetTrails(session).size() == (frame == 3.0 || frame == 14.0 ? 2 : 1));
    CHECK(targetTrails(session).back() == right[0]);
    CHECK(targetsOfRange(session).empty()); // no trail is selected whose range would be theirs
    selectLimb(session, "left-arm", false);
    CHECK(session.view().selection.trail() == (frame == 3.0 ? left[0] : frame == 14.0 ? left[1] : 0));
  }
}

TEST_CASE("Beside the selected trail another limb means the trail that shares time with it") {
  Session session = withTrails();
  selectTrail(session, trailAt(session, 0));
  session.view().selection.editTrails().limbs = {"left-arm", "right-arm", "spine"};
  CHECK(targetTrails(session) == Ids{trailAt(session, 0), trailAt(session, 3)});
  CHECK(targetsOfRange(session) == Ids{trailAt(session, 0), trailAt(session, 3)});
  selectTrail(session, trailAt(session, 1));
  session.view().selection.editTrails().limbs = {"left-arm", "right-arm", "spine"};
  CHECK(targetTrails(session) == Ids{trailAt(session, 1), trailAt(session, 2)});
  CHECK(targetsOfRange(session) == Ids{trailAt(session, 1)});
}

TEST_CASE("A trail of a list is added with its limb, and taken away again, but for the one that leads") {
  Session session = withTrails();
  selectTrailInList(session, trailAt(session, 0), true);
  CHECK(session.view().selection.limbs() == Names{"left-arm"});
  selectTrailInList(session, trailAt(session, 2), true);
  selectTrailInList(session, trailAt(session, 3), true);
  CHECK(session.view().selection.limbs() == Names{"left-arm", "right-arm", "spine"});
  CHECK(session.view().selection.trail() == trailAt(session, 0));
  selectTrailInList(session, trailAt(session, 2), true);
  selectTrailInList(session, trailAt(session, 0), true);
  CHECK(session.view().selection.limbs() == Names{"left-arm", "spine"});
  selectTrailInList(session, trailAt(session, 3), false);
  CHECK(session.view().selection.limbs() == Names{"spine"});
  CHECK(session.view().selection.trail() == trailAt(session, 3));
}

TEST_CASE("Controllers and locators are added and taken away one by one, and nothing else is selected then") {
  Session session = withTrails();
  struct Kind {
    void (*select)(Session&, const std::string&, bool);
    const Names& (Selection::*selected)() const;
  };
  for (const Kind& kind :
       {Kind{selectController, &Selection::controllers}, Kind{selectLocator, &Selection::locators}}) {
    selectTrail(session, trailAt(session, 0));
    const auto now = [&] { return (session.view().selection.*kind.selected)(); };
    kind.select(session, "left-hand", false);
    CHECK(now() == Names{"left-hand"});
    CHECK(session.view().selection.trail() == 0);
    CHECK(session.view().selection.limbs().empty());
    kind.select(session, "hips", true);
    kind.select(session, "head", true);
    CHECK(now() == Names{"left-hand", "hips", "head"});
    kind.select(session, "hips", true);
    CHECK(now() == Names{"left-hand", "head"});
    kind.select(session, "head", false);
    CHECK(now() == Names{"head"});
    kind.select(session, "head", true);
    CHECK(now().empty());
  }
}

TEST_CASE("Tab goes to the trail of the limb that is nearest to the playhead, in the clip that is viewed") {
  for (const char* const key : {command::sphereNext, command::spherePrevious}) {
    CAPTURE(key);
    for (const auto& [frame, place] :
         {std::pair(0.0, 0), std::pair(7.0, 0), std::pair(8.0, 1), std::pair(12.0, 1), std::pair(20.0, 1)}) {
      CAPTURE(frame);
      Session session = withTrails();
      session.view().frame = frame;
      session.view().selection.editTrails().limbs = {"spine", "left-arm"};
      CHECK(test::run(session, key).empty());
      CHECK(session.view().selection.trail() == trailAt(session, static_cast<std::size_t>(place)));
    }
  }
  Document document = withTrails().document();
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clips.front());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  document.trails[0].clip = 1;
  Session session(document);
  session.view().frame = 2.0;
  session.view().selection.editTrails().limbs = {"left-arm"};
  CHECK(test::run(session, command::sphereNext).empty());
  CHECK(session.view().selection.trail() == trailAt(session, 1));
}

TEST_CASE(
    "Trails that are added in a list are meant with the one that leads, two of one limb and others too") {
  Session session = withTrails();
  const Ids ids{trailAt(session, 0), trailAt(session, 1), trailAt(session, 2), trailAt(session, 3)};
  selectTrailInList(session, ids[0], false);
  selectTrailInList(session, ids[1], true);
  CHECK(session.view().selection.limbs() == Names{"left-arm"});
  CHECK(targetTrails(session) == Ids{ids[0], ids[1]});
  selectTrailInList(session, ids[2], true); // shares no time with the first
  CHECK(session.view().selection.limbs() == Names{"left-arm", "right-arm"});
  CHECK(targetTrails(session) == Ids{ids[0], ids[1], ids[2]});
  selectTrail(session, ids[1]); // leads now
  CHECK(targetTrails(session) == Ids{ids[1], ids[0], ids[2]});
  selectTrailInList(session, ids[0], true);
  CHECK(session.view().selection.limbs() == Names{"left-arm", "right-arm"});
  CHECK(targetTrails(session) == Ids{ids[1], ids[2]});
  selectTrailInList(session, ids[2], true);
  CHECK(session.view().selection.limbs() == Names{"left-arm"});
  CHECK(targetTrails(session) == Ids{ids[1]});
}

TEST_CASE("Added trails go with their limb, with the leading trail and with themselves") {
  const auto added = [] {
    Session session = withTrails();
    selectTrailInList(session, trailAt(session, 0), false);
    selectTrailInList(session, trailAt(session, 1), true);
    selectTrailInList(session, trailAt(session, 2), true);
    return session;
  };
  Session session = added();
  selectLimb(session, "right-arm", true);
  selectLimb(session, "right-arm", true);
  CHECK(session.view().selection.trailsBeside() == Ids{trailAt(session, 1)});
  session = added();
  selectLimb(session, "left-arm", false);
  CHECK(session.view().selection.trailsBeside().empty());
  session = added();
  selectTrail(session, trailAt(session, 3));
  CHECK(targetTrails(session) == Ids{trailAt(session, 3)});
  session = added();
  const int gone = trailAt(session, 2);
  Document without = session.document();
  std::erase_if(without.trails, [&](const rig::Trail& trail) { return trail.id == gone; });
  session.edit(without, "Delete");
  CHECK(session.view().selection.trailsBeside() == Ids{trailAt(session, 1)});
}

TEST_CASE("Nothing is selected by the key for it where locators are") {
  Session session = withTrails();
  session.view().showLocators = true;
  selectLocator(session, "leftHand", false);
  CHECK(test::run(session, command::selectNone).empty());
  CHECK(session.view().selection.locators().empty());
  CHECK(test::run(session, command::selectNone) == "nothing is selected");
}

TEST_CASE("A group that is chosen is meant alone, also where another trail of its leading limb was added") {
  Document document = withTrails().document();
  document.trails[0].group = document.trails[3].group = 7; // left arm and spine, frames 1 to 5
  Session session(document);
  selectTrailInList(session, trailAt(session, 0), false);
  selectTrailInList(session, trailAt(session, 1), true);
  REQUIRE(targetTrails(session) == Ids{trailAt(session, 0), trailAt(session, 1)});
  selectGroup(session, trailAt(session, 0));
  CHECK(session.view().selection.limbs() == Names{"left-arm", "spine"});
  CHECK(targetTrails(session) == Ids{trailAt(session, 0), trailAt(session, 3)});
}
