// Where E acts after an earlier E, on a limb that has a trail elsewhere, and on several limbs.
#include <catch2/catch.hpp>

#include "app/commands/exaggerate.h"
#include "app/commands/ranges.h"
#include "app/commands/selection.h"
#include "app/edits/trail_edits.h"
#include "app/files/save.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Session dummy() {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  return Session(std::move(opened).value());
}

const rig::TrailSettings& leading(const ExaggerateTargets& targets) {
  return findTrail(targets.document, targets.trailIds.front())->settings;
}

/// E, as the tool does it: a preview with the trail selected.
ExaggerateTargets begun(Session& session) {
  Result<ExaggerateTargets> targets = exaggerateTargets(session);
  REQUIRE(targets);
  session.begin("Exaggerate");
  session.preview(targets->document);
  selectTrail(session, targets->trailIds.front());
  return std::move(targets).value();
}

} // namespace

TEST_CASE("After E was left by Esc the next E follows the playhead") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  const rig::TrailSettings first = leading(begun(session));
  CHECK(isRangeSet(session.view()));
  session.cancel();
  CHECK_FALSE(isRangeSet(session.view()));
  session.view().frame = 31.0;
  const rig::TrailSettings second = leading(begun(session));
  CHECK(second.startFrame >= first.endFrame);
}

TEST_CASE("A range set by hand is there again after E was left by Esc") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  setRangeByHand(session, {22.0, 30.0});
  begun(session);
  session.cancel();
  CHECK(session.view().rangeStart == 22.0);
  CHECK(session.view().rangeEnd == 30.0);
}

TEST_CASE("A limb with a trail elsewhere gets another one at the stroke under the playhead") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  const ExaggerateTargets punch = begun(session);
  session.commit();
  session.view().frame = 31.0;
  selectLimb(session, "left-arm", false);
  CHECK(session.view().selectedTrail == 0);
  const ExaggerateTargets back = begun(session);
  CHECK(back.trailIds.front() != punch.trailIds.front());
  CHECK(leading(back).startFrame >= leading(punch).endFrame);
  CHECK(session.document().trails.size() == 2);
}

TEST_CASE("Limbs that are exaggerated at once take the strongest stroke of any of them") {
  for (const bool punchFirst : {true, false}) {
    Session session = dummy();
    selectLimb(session, punchFirst ? "left-arm" : "left-leg", false);
    selectLimb(session, punchFirst ? "left-leg" : "left-arm", true);
    const ExaggerateTargets both = begun(session);
    REQUIRE(both.trailIds.size() == 2);
    CHECK(leading(both).startFrame == 21.0);
    CHECK(leading(both).endFrame == 27.0);
  }
}
