#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/trail/applied.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document withTrail(const Document& document, const std::string& limb, bool connected) {
  return test::withNewTrail(
      document, {.limb = limb, .startFrame = 5.0, .endFrame = 10.0, .scale = 3.0, .connected = connected});
}

bool applied(Session& session, const char* id) {
  const std::vector<DocumentCommand> commands = documentCommands();
  const auto command =
      std::find_if(commands.begin(), commands.end(), [&](const auto& c) { return c.id == id; });
  REQUIRE(command != commands.end());
  return command->enabled(session) && command->run(session).ok();
}

} // namespace

TEST_CASE("An applied trail shows its new keys, until it is changed") {
  Session session(withTrail(test::boxer(), "left-arm", true));
  session.view().selection.editTrails().limbs = {"left-arm"};
  const std::vector<double> source = shownKeyFrames(session, {"left-arm"});
  CHECK(source == keyFrames(session.document(), 0, {"left-arm"}));
  session.view().selection.editTrails().trail = 1;
  REQUIRE(applied(session, command::trailApply));
  const std::vector<double> keyed = shownKeyFrames(session, {"left-arm"});
  CHECK(keyed.size() > source.size());
  CHECK(std::includes(keyed.begin(), keyed.end(), source.begin(), source.end()));
  rig::TrailSettings changed = session.document().trails.front().settings;
  changed.scale = 2.0;
  REQUIRE(session.edit(*setTrailSettings(session.document(), 1, changed), "Change the scale"));
  CHECK(shownKeyFrames(session, {"left-arm"}) == source);
}

TEST_CASE("What applying came to is told: the limb, its frames with the way back, and the keys there") {
  Session session(withTrail(test::boxer(), "left-arm", true));
  session.view().selection.editTrails().limbs = {"left-arm"};
  session.view().selection.editTrails().trail = 1;
  REQUIRE(applied(session, command::trailApply));
  const std::vector<double> keys = shownKeyFrames(session, {"left-arm"});
  const auto inside =
      std::count_if(keys.begin(), keys.end(), [](double frame) { return frame >= 4.99 && frame <= 20.01; });
  const auto between = std::count_if(keys.begin(), keys.end(), [](double frame) {
    return frame >= 4.99 && frame <= 20.01 && std::abs(frame - std::round(frame)) > 0.01;
  });
  REQUIRE(between > 0);
  CHECK(appliedText(session, {1}) == "left arm, frames 5 to 20: " + std::to_string(inside) + " keys, " +
                                         std::to_string(between) + " of them between frames");
}

TEST_CASE("Next key stops at each key, between the frames of the rate that the clip is worked on too") {
  Session session(workAtRate(test::boxer(), 0, 24.0));
  session.view().selection.editTrails().limbs = {"left-arm"};
  std::vector<double> stops;
  for (int i = 0; i < 4; ++i) {
    REQUIRE(applied(session, command::timeNextKey));
    stops.push_back(session.view().frame);
  }
  CHECK(stops == std::vector<double>{4.0, 8.0, 16.0, 16.0});
  session.edit(workAtRate(session.document(), 0, 25.0), "Change the frame rate");
  session.view().frame = 0.0;
  REQUIRE(applied(session, command::timeNextKey));
  CHECK(session.view().frame == Approx(25.0 / 6.0).margin(1e-3));
}

TEST_CASE("Apply all is one step for every connected trail of the clip, and leaves disconnected ones out") {
  const Document two = withTrail(withTrail(test::boxer(), "left-arm", true), "right-arm", true);
  Session session(withTrail(two, "spine", false));
  REQUIRE(applied(session, command::trailApplyAll));
  const std::vector<rig::Trail>& trails = session.document().trails;
  CHECK(trails[0].applied);
  CHECK(trails[1].applied);
  CHECK_FALSE(trails[2].applied);
  CHECK_FALSE(applied(session, command::trailApplyAll)); // Nothing waits any more.
  session.undo();
  CHECK_FALSE(session.document().trails[0].applied);
}

TEST_CASE("Apply all leaves the trails of other clips waiting") {
  Document document = withTrail(test::boxer(), "left-arm", true);
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>(2, document.clips->front()));
  rig::Trail other = document.trails.front();
  other.id = document.nextTrailId++;
  other.clip = 1;
  document.trails.push_back(other);
  Session session(document);
  CHECK(waitingTrails(session) == std::vector<int>{document.trails.front().id});
  REQUIRE(applied(session, command::trailApplyAll));
  CHECK(session.document().trails[0].applied);
  CHECK_FALSE(session.document().trails[1].applied);
  session.view().clip = 1;
  CHECK(waitingTrails(session) == std::vector<int>{other.id});
}

TEST_CASE(
    "What several trails came to is told from the first frame of any to the last, and of many how many") {
  Document document = test::withNewTrail(test::boxer(), {"left-arm", 5.0, 10.0});
  document = test::withNewTrail(document, {"right-arm", 2.0, 4.0});
  document.trails[0].settings.releaseFrames = 4.0;
  document.trails[1].settings.releaseFrames = 3.0;
  const int left = document.trails[0].id;
  const int right = document.trails[1].id;
  Session session(document); // The arm has keys at 0, 5, 10 and 20, the other one none.
  CHECK(appliedText(session, {left, right, 77}) == "left arm, right arm, frames 2 to 14: 2 keys");
  CHECK(appliedText(session, {right, left}) == "right arm, left arm, frames 2 to 14: 2 keys");
  CHECK(appliedText(session, {right}) == "right arm, frames 2 to 7: 0 keys");
  document = test::withNewTrail(document, {"spine", 3.0, 6.0});
  const int spine = document.trails[2].id;
  document = test::withNewTrail(document, {"left-arm", 15.0, 18.0});
  Session more(document);
  CHECK_THAT(appliedText(more, {left, right, spine}),
             Catch::StartsWith("left arm, right arm, spine, frames "));
  CHECK_THAT(appliedText(more, {left, right, spine, document.trails[3].id}),
             Catch::StartsWith("4 trails, frames 2 to "));
}
