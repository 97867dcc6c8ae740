// What is chosen from lists and by keys: trails that are gone, the moment before.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/moments.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A trail of a list that is gone is not selected, and what was selected stays") {
  Session session(test::withNewTrail(test::boxer(), {}));
  const int trail = session.document().trails.front().id;
  selectTrailInList(session, trail, false);
  for (const bool add : {true, false}) {
    selectTrailInList(session, trail + 7, add);
    CHECK(session.view().selection.trail() == trail);
    CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm"});
  }
}

TEST_CASE("N goes to the moment after the playhead, Shift+N to the one before it, round and round") {
  Session session(test::openedFile(test::posedCharacter));
  const auto frameAfter = [&](const char* command) {
    CHECK(test::run(session, command).empty());
    return session.view().frame;
  };
  CHECK(frameAfter(command::momentNext) == 27.0);
  CHECK(frameAfter(command::momentNext) == 33.0);
  CHECK(frameAfter(command::momentPrevious) == 27.0);
  CHECK(frameAfter(command::momentPrevious) == 50.0);
}
