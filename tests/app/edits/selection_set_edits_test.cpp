#include <catch2/catch.hpp>

#include <algorithm>

#include "app/commands/body/selection_sets.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/selection_set_edits.h"
#include "app/files/saved_work.h"
#include "app/schema/selection_set_json.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_command.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::run;

namespace {

Document bundled() {
  return test::openedFile(test::posedCharacter);
}

std::vector<std::string> namesOf(const Document& document) {
  std::vector<std::string> names;
  std::ranges::transform(document.selectionSets, std::back_inserter(names), &SelectionSet::name);
  return names;
}

using Names = std::vector<std::string>;

/// Sets of limbs and of controllers.
Document withSets() {
  Document document = bundled();
  document.selectionSets = {{"Arms", {"left-arm", "right-arm"}, {}},
                            {"Hands", {}, {"left-hand", "right-hand"}}};
  return document;
}

/// What the next set selects, three times: arms, hands, and arms again.
void checkArmsHandsArms(Session& session) {
  for (const auto& [limbs, controllers] : {std::pair{Names{"left-arm", "right-arm"}, Names{}},
                                           {Names{}, Names{"left-hand", "right-hand"}},
                                           {Names{"left-arm", "right-arm"}, Names{}}}) {
    REQUIRE(run(session, command::selectionNext).empty());
    CHECK(session.view().selection.limbs() == limbs);
    CHECK(session.view().selection.controllers() == controllers);
  }
}

std::string refusalOf(const Json& sets) {
  return test::refusal(selectionSetsFromJson(sets));
}

} // namespace

TEST_CASE("A selection is kept as a set by its members' names, and one of more than two by their number") {
  Session session(bundled());
  CHECK_FALSE(run(session, command::selectionKeep).empty());
  selectLimb(session, "left-arm", false);
  REQUIRE(run(session, command::selectionKeep).empty());
  CHECK_FALSE(run(session, command::selectionKeep).empty());
  selectControllers(session, {"left-hand", "right-hand"});
  REQUIRE(run(session, command::selectionKeep).empty());
  selectControllers(session, {"left-hand", "right-hand", "head"});
  REQUIRE(run(session, command::selectionKeep).empty());
  selectControllers(session, {"left-foot", "right-foot", "head"});
  REQUIRE(run(session, command::selectionKeep).empty());
  for (const char* const limb : {"right-arm", "left-leg", "spine"}) {
    selectLimb(session, limb, limb != std::string("right-arm"));
  }
  REQUIRE(run(session, command::selectionKeep).empty());
  CHECK(namesOf(session.document()) ==
        Names{"left arm", "left hand, right hand", "3 controllers", "3 controllers 2", "3 limbs"});
  CHECK(session.document().selectionSets[0].limbs == Names{"left-arm"});
  CHECK(session.document().selectionSets[0].controllers.empty());
  CHECK(session.document().selectionSets[1].controllers == Names{"left-hand", "right-hand"});
  CHECK(session.document().selectionSets[1].limbs.empty());
  session.undo();
  CHECK(namesOf(session.document()).size() == 4);
}

TEST_CASE("A set of nothing is refused, and so is one that holds what another one does") {
  const Document document = withSets();
  Selection selection;
  CHECK_THAT(test::refusal(keepSelectionSet(document, selection, "Nothing")),
             Catch::StartsWith("no limb and no controller is selected"));
  selection.setControllers({"right-hand", "left-hand"});
  CHECK_THAT(test::refusal(keepSelectionSet(document, selection, "Fists")),
             Catch::StartsWith("the set 'Hands' holds just this"));
  selection.setControllers({"head"});
  CHECK(namesOf(*keepSelectionSet(document, selection, "Hands")) == Names{"Arms", "Hands", "Hands 2"});
}

TEST_CASE("The set of a selection is the one that holds just that, in any order") {
  const Document document = withSets();
  Selection selection;
  CHECK(setOfSelection(document, selection) == nullptr);
  selection.setControllers({"right-hand", "left-hand"});
  REQUIRE(setOfSelection(document, selection) != nullptr);
  CHECK(setOfSelection(document, selection)->name == "Hands");
  selection.setControllers({"left-hand"});
  CHECK(setOfSelection(document, selection) == nullptr);
  selection.setControllers({"left-hand", "right-hand", "head"});
  CHECK(setOfSelection(document, selection) == nullptr);
  selection.editTrails().limbs = {"right-arm", "left-arm"};
  REQUIRE(setOfSelection(document, selection) != nullptr);
  CHECK(setOfSelection(document, selection)->name == "Arms");
}

TEST_CASE("A set is selected in the place of what was selected, or beside it") {
  Session session(withSets());
  const SelectionSet arms = session.document().selectionSets[0];
  const SelectionSet hands = session.document().selectionSets[1];
  selectLimb(session, "left-leg", false);
  SECTION("limbs alone") {
    selectSet(session, arms, false);
    CHECK(session.view().selection.limbs() == Names{"left-arm", "right-arm"});
  }
  SECTION("limbs beside limbs, of which one is selected already") {
    selectLimb(session, "right-arm", true);
    selectSet(session, arms, true);
    CHECK(session.view().selection.limbs() == Names{"left-leg", "right-arm", "left-arm"});
  }
  SECTION("controllers alone") {
    selectControllers(session, {"head"});
    selectSet(session, hands, false);
    CHECK(session.view().selection.controllers() == Names{"left-hand", "right-hand"});
  }
  SECTION("controllers beside others, each once") {
    selectControllers(session, {"head", "right-hand"});
    selectSet(session, hands, true);
    CHECK(session.view().selection.controllers() == Names{"head", "right-hand", "left-hand"});
  }
  SECTION("what the character has of it") {
    selectSet(session, {"Wings", {}, {"left-wing", "head"}}, false);
    CHECK(session.view().selection.controllers() == Names{"head"});
    selectSet(session, {"Wings", {"left-wing", "spine"}, {}}, false);
    CHECK(session.view().selection.limbs() == Names{"spine"});
  }
}

TEST_CASE("The next set is the first, then each in turn, and the first again") {
  Session session(withSets());
  checkArmsHandsArms(session);
  Session without(bundled());
  CHECK_FALSE(run(without, command::selectionNext).empty());
}

TEST_CASE(
    "Of a set the character has what is left of it, and a set of which nothing is left is passed over") {
  Document document = withSets();
  document.selectionSets.insert(document.selectionSets.begin(), {"Wings", {}, {"left-wing", "right-wing"}});
  document.selectionSets[2].controllers.emplace_back("tail");
  CHECK(presentIn(document, document.selectionSets[0]).controllers.empty());
  CHECK(presentIn(document, document.selectionSets[2]).controllers == Names{"left-hand", "right-hand"});
  Session session(document);
  selectSet(session, session.document().selectionSets[0], false);
  CHECK(session.view().selection.controllers().empty());
  CHECK(session.view().selection.limbs().empty());
  checkArmsHandsArms(session);
  selectSet(session, session.document().selectionSets[2], false);
  REQUIRE(run(session, command::selectionForget).empty());
  CHECK(namesOf(session.document()) == Names{"Wings", "Arms"});
  document.selectionSets.resize(1);
  Session none(document);
  CHECK_FALSE(run(none, command::selectionNext).empty());
}

TEST_CASE("A set is forgotten while it is selected, and what it held stays selected") {
  Session session(withSets());
  CHECK_FALSE(run(session, command::selectionForget).empty());
  selectControllers(session, {"left-hand", "right-hand"});
  REQUIRE(run(session, command::selectionForget).empty());
  CHECK(namesOf(session.document()) == Names{"Arms"});
  CHECK(session.view().selection.controllers() == Names{"left-hand", "right-hand"});
}

TEST_CASE("A set is renamed to a name that no other one has") {
  const Document document = withSets();
  CHECK(namesOf(*renameSelectionSet(document, "Arms", "Punch")) == Names{"Punch", "Hands"});
  CHECK(namesOf(*renameSelectionSet(document, "Arms", "Arms")) == Names{"Arms", "Hands"});
  CHECK_THAT(test::refusal(renameSelectionSet(document, "Arms", "Hands")),
             Catch::StartsWith("another set is called 'Hands'"));
  CHECK_THAT(test::refusal(renameSelectionSet(document, "Arms", "")),
             Catch::StartsWith("a set needs a name"));
  CHECK_THAT(test::refusal(renameSelectionSet(document, "Legs", "Feet")),
             Catch::StartsWith("there is no selection set 'Legs'"));
}

TEST_CASE("Selection sets are work: saved, taken up again, counted as a change, and gone without the work") {
  const Document document = withSets();
  CHECK(workOf(bundled()).is_null());
  CHECK_FALSE(sameDocument(document, bundled()));
  CHECK(bytesBeyond(document, bundled()) > bytesBeyond(bundled(), bundled()));
  Document again = bundled();
  REQUIRE(restoreWork(workOf(document), again));
  CHECK(again.selectionSets == document.selectionSets);
  CHECK(withoutWork(document).selectionSets.empty());
}

TEST_CASE("Sets that no selection could be are refused, with what is wrong") {
  const Json good{{"name", "Hands"}, {"controllers", {"left-hand"}}};
  REQUIRE(selectionSetsFromJson(Json::array({good})));
  CHECK_THAT(refusalOf(Json::object()), Catch::StartsWith("selection_sets: is not a list"));
  CHECK_THAT(refusalOf(Json::array({{{"controllers", {"head"}}}})), Catch::StartsWith("name: is missing"));
  const auto isNone = Catch::StartsWith("selection_sets: is not a selection set of its own");
  CHECK_THAT(refusalOf(Json::array({good, good})), isNone);
  CHECK_THAT(refusalOf(Json::array({{{"name", ""}, {"limbs", {"spine"}}}})), isNone);
  CHECK_THAT(refusalOf(Json::array({{{"name", "None"}}})), isNone);
  CHECK_THAT(refusalOf(Json::array({{{"name", "Both"}, {"limbs", {"spine"}}, {"controllers", {"head"}}}})),
             isNone);
  CHECK_THAT(refusalOf(Json::array({{{"name", "Wrong"}, {"limbs", "spine"}}})),
             Catch::StartsWith("limbs: is not a list"));
  CHECK_THAT(refusalOf(Json::array({{{"name", "Wrong"}, {"controllers", {1}}}})),
             Catch::StartsWith("controllers: is not a list"));
  CHECK_THAT(refusalOf(Json::array({{{"name", "Wrong"}, {"joints", {"head"}}}})),
             Catch::StartsWith("joints: is not a part"));
}

TEST_CASE("The name of a set is trimmed and shortened, and spaces alone are none") {
  const Document document = withSets();
  CHECK_THAT(test::refusal(renameSelectionSet(document, "Arms", " \t ")),
             Catch::StartsWith("a set needs a name"));
  CHECK_THAT(test::refusal(renameSelectionSet(document, "Arms", " Hands ")),
             Catch::StartsWith("another set is called 'Hands'"));
  CHECK(namesOf(*renameSelectionSet(document, "Arms", " Both arms ")) == Names{"Both arms", "Hands"});
  CHECK(namesOf(*renameSelectionSet(document, "Arms", std::string(500, 'a'))).front().size() == 80);
}
