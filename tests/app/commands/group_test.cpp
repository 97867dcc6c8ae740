#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/place_trails.h"
#include "app/files/saved_work.h"
#include "app/recipe/replay.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Both arms exaggerated at once.
Session withBothArms() {
  Session session(test::boxer());
  session.view().selection.editTrails().limbs = {"left-arm", "right-arm"};
  Result<ExaggerateTargets> made = exaggerateTargets(session);
  REQUIRE(made);
  session.edit(made->document, "Exaggerate");
  selectTrail(session, made->trailIds.front());
  return session;
}

} // namespace

TEST_CASE("Limbs exaggerated at once are one group over one range, in one undo step") {
  Session session = withBothArms();
  const std::vector<rig::Trail>& trails = session.document().trails;
  REQUIRE(trails.size() == 2);
  CHECK(trails[0].settings.startFrame == trails[1].settings.startFrame);
  CHECK(trails[0].settings.endFrame == trails[1].settings.endFrame);
  CHECK(groupMembers(session.document(), trails[0].id) == std::vector<int>{trails[0].id, trails[1].id});
  REQUIRE(session.undo());
  CHECK(session.document().trails.empty());
}

TEST_CASE("One limb alone makes no group") {
  Session session(test::boxer());
  session.view().selection.editTrails().limbs = {"left-arm"};
  const Result<ExaggerateTargets> made = exaggerateTargets(session);
  REQUIRE(made);
  CHECK(groupMembers(made->document, made->trailIds.front()).empty());
}

TEST_CASE("Limbs that are added to the selection beside a limb with a trail act with it") {
  Session session(test::boxer());
  selectLimb(session, "left-arm", false);
  Result<ExaggerateTargets> made = exaggerateTargets(session);
  REQUIRE(made);
  session.edit(made->document, "Exaggerate");
  selectTrail(session, made->trailIds.front());
  selectLimb(session, "right-arm", true);
  made = exaggerateTargets(session);
  REQUIRE(made);
  REQUIRE(made->document.trails.size() == 2);
  const rig::Trail& first = made->document.trails[0];
  const rig::Trail& second = made->document.trails[1];
  CHECK(made->trailIds == std::vector<int>{first.id, second.id});
  CHECK(second.limb == "right-arm");
  CHECK(second.settings.endFrame == first.settings.endFrame);
  CHECK(groupMembers(made->document, first.id).size() == 2);
}

TEST_CASE("A group is chosen as a whole, a member of it alone") {
  Session session = withBothArms();
  const int second = session.document().trails[1].id;
  selectTrailInList(session, second, false);
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"right-arm"});
  CHECK(targetTrails(session) == std::vector<int>{second});
  selectGroup(session, second);
  CHECK(targetTrails(session).size() == 2);
}

TEST_CASE("A group is taken apart, and put together from trails of different limbs") {
  Session session = withBothArms();
  const std::vector<int> ids = targetTrails(session);
  const Document apart = takeApart(session.document(), ids);
  CHECK(groupMembers(apart, ids.front()).empty());
  const Result<Document> together = groupTrails(apart, ids);
  REQUIRE(together);
  CHECK(groupMembers(*together, ids.front()) == ids);
  CHECK_THAT(test::refusal(groupTrails(apart, std::vector<int>{ids.front()})),
             Catch::StartsWith("a group needs two trails or more"));
  CHECK_THAT(test::refusal(groupTrails(apart, std::vector<int>{ids.front(), ids.front()})),
             Catch::Contains("a group holds one trail of each limb"));
}

TEST_CASE("Groups and tangents are kept with the work and in recipes") {
  Document document = withBothArms().document();
  document.trails[0].settings.spheres = {{5.0, Vec3(0.1, 0.0, 0.0), Vec3(0.0, 0.03, 0.0)}};
  Document restored = test::boxer();
  REQUIRE(restoreWork(workOf(document), restored));
  CHECK(restored.trails == document.trails);

  Document other = test::boxer();
  const Result<Recipe> recipe = recipeFromJson(recipeToJson(document, 0), other);
  REQUIRE(recipe);
  const Result<PlacedTrails> placed = withRecipe(other, *recipe);
  REQUIRE(placed);
  CHECK(groupMembers(placed->document, placed->trailIds.front()) == placed->trailIds);
  const rig::SphereOffset& sphere = placed->document.trails[0].settings.spheres.front();
  REQUIRE(sphere.tangent);
  CHECK(sphere.tangent->y == Approx(0.03));
}

TEST_CASE(
    "Of limbs that are exaggerated at once the one that moves most leads, and of limbs that rest the first "
    "that was selected") {
  const auto leaderOf = [](const std::vector<std::string>& limbs) {
    std::vector<std::string> leaders;
    Session session(test::boxer()); // whose left arm punches
    session.view().selection.editTrails().limbs = limbs;
    for (const Result<ExaggerateTargets>& made :
         {exaggerateTargets(session), exaggerateTargets(session, OverlapChoice::beside),
          newTrails(session, false)}) {
      REQUIRE(made);
      CHECK(made->trailIds.size() == limbs.size());
      leaders.push_back(findTrail(made->document, made->trailIds.front())->limb);
    }
    CHECK(leaders == std::vector<std::string>(3, leaders.front()));
    return leaders.front();
  };
  CHECK(leaderOf({"right-arm", "left-arm"}) == "left-arm");
  CHECK(leaderOf({"left-arm", "right-arm"}) == "left-arm");
  CHECK(leaderOf({"spine", "left-arm", "right-arm"}) == "left-arm");
  CHECK(leaderOf({"right-arm", "spine"}) == "right-arm");
  CHECK(leaderOf({"spine", "right-arm"}) == "spine");
}

TEST_CASE("Trails of both sides that are mirrored together change places") {
  Session session = withBothArms();
  Document document = takeApart(session.document(), targetTrails(session));
  document.trails[0].settings.scale = 2.0;
  document.trails[1].settings.scale = 4.0;
  session.edit(document, "Scale");
  REQUIRE(targetTrails(session).size() == 2);
  CHECK(test::run(session, command::mirrorTrail).empty());
  CHECK(session.document().trails[0].settings.scale == 4.0);
  CHECK(session.document().trails[1].settings.scale == 2.0);
}

TEST_CASE("A group is of one clip, whatever numbers a file has, and one that is made anew has no name yet") {
  Document document = withBothArms().document();
  const std::vector<int> arms{document.trails[0].id, document.trails[1].id};
  rig::Trail other = document.trails[0];
  other.id = document.nextTrailId++;
  other.clip = 1;
  document.trails.push_back(other);
  CHECK(groupMembers(document, arms.front()) == arms);
  CHECK(groupMembers(document, other.id).empty());
  CHECK_THAT(test::refusal(groupTrails(document, std::vector<int>{arms[1], other.id})),
             Catch::Contains("all of one clip"));
  document.trails[0].groupName = document.trails[1].groupName = "Clap";
  const Result<Document> again = groupTrails(document, arms);
  REQUIRE(again);
  CHECK(groupMembers(*again, arms.front()) == arms);
  CHECK(again->trails[0].group > document.trails[0].group);
  CHECK(again->trails[0].groupName.empty());
  CHECK(again->trails[1].groupName.empty());
}
