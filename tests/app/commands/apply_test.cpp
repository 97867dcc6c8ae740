#include <algorithm>
#include <cmath>

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
