// The working range and the playhead by commands: both ends, with a range there and without.
#include <optional>
#include <string>
#include <tuple>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;
using test::run;

namespace {

/// What a session knows as its working range after a command at a frame.
std::optional<Vec2> rangeAfter(const char* command, double frame, const std::optional<Vec2>& before) {
  Session session(test::boxer()); // frames 0 to 20
  if (before) {
    session.view().rangeStart = before->x;
    session.view().rangeEnd = before->y;
  }
  session.view().frame = frame;
  const std::string told = run(session, command);
  if (!told.empty()) {
    CHECK_THAT(told, Catch::Contains("the range would have no length"));
    CHECK(session.rangeByHand() == before);
    return std::nullopt;
  }
  return session.rangeByHand();
}

double frameAfter(const char* command, double frame) {
  Session session(test::boxer());
  session.view().frame = frame;
  CHECK(run(session, command).empty());
  return session.view().frame;
}

} // namespace

TEST_CASE("A range starts at the playhead and ends where it did, or with the clip where that is before it") {
  CHECK(rangeAfter(command::rangeStart, 4.0, Vec2(2.0, 9.0)) == Vec2(4.0, 9.0));
  CHECK(rangeAfter(command::rangeStart, 1.0, Vec2(2.0, 9.0)) == Vec2(1.0, 9.0));
  CHECK(rangeAfter(command::rangeStart, 9.0, Vec2(2.0, 9.0)) == Vec2(9.0, 20.0));
  CHECK(rangeAfter(command::rangeStart, 12.0, Vec2(2.0, 9.0)) == Vec2(12.0, 20.0));
  CHECK(rangeAfter(command::rangeStart, 4.0, std::nullopt) == Vec2(4.0, 20.0));
  CHECK(rangeAfter(command::rangeStart, 0.0, std::nullopt) == Vec2(0.0, 20.0));
  CHECK_FALSE(rangeAfter(command::rangeStart, 20.0, std::nullopt));
  CHECK_FALSE(rangeAfter(command::rangeStart, 20.0, Vec2(2.0, 9.0)));
}

TEST_CASE("A range ends at the playhead and starts where it did, or with the clip where that is after it") {
  CHECK(rangeAfter(command::rangeEnd, 7.0, Vec2(2.0, 9.0)) == Vec2(2.0, 7.0));
  CHECK(rangeAfter(command::rangeEnd, 12.0, Vec2(2.0, 9.0)) == Vec2(2.0, 12.0));
  CHECK(rangeAfter(command::rangeEnd, 2.0, Vec2(2.0, 9.0)) == Vec2(0.0, 2.0));
  CHECK(rangeAfter(command::rangeEnd, 1.0, Vec2(2.0, 9.0)) == Vec2(0.0, 1.0));
  CHECK(rangeAfter(command::rangeEnd, 7.0, std::nullopt) == Vec2(0.0, 7.0));
  CHECK(rangeAfter(command::rangeEnd, 20.0, std::nullopt) == Vec2(0.0, 20.0));
  CHECK_FALSE(rangeAfter(command::rangeEnd, 0.0, std::nullopt));
  CHECK_FALSE(rangeAfter(command::rangeEnd, 0.0, Vec2(2.0, 9.0)));
}

TEST_CASE("Steps go to whole frames, also from between two, and stay in the clip") {
  CHECK(frameAfter(command::timeBack, 7.0) == 6.0);
  CHECK(frameAfter(command::timeBack, 7.25) == 7.0);
  CHECK(frameAfter(command::timeBack, 6.75) == 6.0);
  CHECK(frameAfter(command::timeBack, 0.0) == 0.0);
  CHECK(frameAfter(command::timeBack, 20.0) == 19.0);
  CHECK(frameAfter(command::timeForward, 7.0) == 8.0);
  CHECK(frameAfter(command::timeForward, 7.25) == 8.0);
  CHECK(frameAfter(command::timeForward, 6.75) == 7.0);
  CHECK(frameAfter(command::timeForward, 20.0) == 20.0);
  CHECK(frameAfter(command::timeForward, 0.0) == 1.0);
}

TEST_CASE("Far steps are ten frames and end with the clip, and both ends are one command away") {
  CHECK(frameAfter(command::timeFarBack, 14.0) == 4.0);
  CHECK(frameAfter(command::timeFarBack, 9.0) == 0.0);
  CHECK(frameAfter(command::timeFarForward, 4.0) == 14.0);
  CHECK(frameAfter(command::timeFarForward, 11.0) == 20.0);
  CHECK(frameAfter(command::timeStart, 11.0) == 0.0);
  CHECK(frameAfter(command::timeEnd, 11.0) == 20.0);
}

TEST_CASE(
    "The next key and the one before are never the one at the playhead, and nothing lies beyond the last") {
  for (const auto& [frame, before, next] : {std::tuple(0.0, 0.0, 5.0),
                                            {5.0, 0.0, 10.0},
                                            {7.0, 5.0, 10.0},
                                            {20.0, 10.0, 20.0},
                                            {10.5, 10.0, 20.0}}) {
    CAPTURE(frame);
    CHECK(frameAfter(command::timePreviousKey, frame) == Approx(before).margin(1e-5));
    CHECK(frameAfter(command::timeNextKey, frame) == Approx(next).margin(1e-5));
  }
}

TEST_CASE("While a controller is selected a range without a length is refused as well") {
  Session session(test::boxer());
  selectController(session, "left-hand", false);
  session.view().frame = 20.0;
  CHECK_THAT(run(session, command::rangeStart), Catch::Contains("the range would have no length"));
  CHECK_FALSE(session.rangeByHand());
  session.view().frame = 12.0;
  CHECK(run(session, command::rangeStart).empty());
  CHECK(session.rangeByHand() == Vec2(12.0, 20.0));
}
