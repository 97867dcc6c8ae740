// From clip to clip: the next and the one before, and what is looked at then.
#include "app/commands/keys/clips.h"

#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The boxer's punch three times, with a trail of its left arm in the first.
Document threePunches() {
  Document document = test::withNewTrail(test::boxer(), {});
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>(3, document.clips->front()));
  return document;
}

} // namespace

TEST_CASE("The clips of a file are gone through round and round, either way") {
  Session session(threePunches());
  const auto clipAfter = [&](const char* command) {
    CHECK(test::run(session, command).empty());
    return session.view().clip;
  };
  CHECK(clipAfter(command::clipNext) == 1);
  CHECK(clipAfter(command::clipNext) == 2);
  CHECK(clipAfter(command::clipNext) == 0);
  CHECK(clipAfter(command::clipPrevious) == 2);
  CHECK(clipAfter(command::clipPrevious) == 1);
  CHECK(clipAfter(command::clipPrevious) == 0);
  Session one(test::boxer());
  CHECK(test::run(one, command::clipNext) == "the file has one clip");
}

TEST_CASE("Another clip is shown from its start with nothing selected in time, the same one as it stands") {
  Session session(threePunches());
  selectTrail(session, session.document().trails.front().id);
  session.view().frame = 7.0;
  showClip(session, 0);
  CHECK(session.view().frame == 7.0);
  CHECK(session.view().selection.trail() != 0);
  CHECK(isRangeSet(session.view()));
  showClip(session, 2);
  CHECK(session.view().clip == 2);
  CHECK(session.view().frame == 0.0);
  CHECK(session.view().selection.trail() == 0);
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm"});
  CHECK_FALSE(isRangeSet(session.view()));
}
