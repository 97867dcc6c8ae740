#include <catch2/catch.hpp>

#include "app/files/save.h"
#include "ui/shell/playback.h"
#include "ui/shell/shell.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The bundled punch at 24 frames per second, playing.
struct Playing {
  Playing() {
    Result<app::Document> document = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
    REQUIRE(document);
    shell.open.open(std::move(document).value());
    shell.ui.time.timeline.playing = true;
  }
  [[nodiscard]] double frame() const { return shell.open.character()->view().frame; }

  Shell shell;
};

} // namespace

TEST_CASE(
    "Playing in time passes over frames that a slow machine has no time for, every frame leaves none out") {
  Playing inTime;
  play(inTime.shell, 0.125);
  CHECK(inTime.frame() == Approx(3.0));
  Playing each;
  each.shell.ui.time.timeline.everyFrame = true;
  for (const double wanted : {1.0, 2.0, 3.0}) {
    play(each.shell, 0.125);
    CHECK(each.frame() == wanted);
  }
  // A fast machine does not play it faster than it is.
  play(each.shell, 0.5 / 24.0);
  CHECK(each.frame() == 3.0);
  play(each.shell, 0.5 / 24.0);
  CHECK(each.frame() == 4.0);
}

TEST_CASE("On twos every second frame is held for two") {
  Playing playing;
  playing.shell.ui.time.timeline.onTwos = true;
  for (const double wanted : {0.0, 2.0, 2.0, 4.0, 4.0, 6.0}) {
    play(playing.shell, 1.001 / 24.0);
    CHECK(playing.frame() == wanted);
  }
  // It goes on from where the playhead was put.
  playing.shell.open.character()->view().frame = 11.0;
  play(playing.shell, 1.001 / 24.0);
  CHECK(playing.frame() == 12.0);
}

TEST_CASE("After a pause of the program playing goes on from where it was, a quarter of a second at most") {
  Playing playing;
  play(playing.shell, 5.0);
  CHECK(playing.frame() == Approx(6.0));
  Playing half;
  half.shell.ui.time.timeline.speed = 0.5;
  play(half.shell, 0.125);
  CHECK(half.frame() == Approx(1.5));
}

TEST_CASE("Playing begins again after the last frame, or stops there where it does not loop") {
  Playing looping;
  looping.shell.open.character()->view().frame = 59.0;
  play(looping.shell, 3.0 / 24.0);
  CHECK(looping.frame() == Approx(2.0));
  CHECK(looping.shell.ui.time.timeline.playing);
  Playing once;
  once.shell.ui.time.timeline.loop = false;
  once.shell.open.character()->view().frame = 59.0;
  play(once.shell, 3.0 / 24.0);
  CHECK(once.frame() == 60.0);
  CHECK_FALSE(once.shell.ui.time.timeline.playing);
  play(once.shell, 3.0 / 24.0);
  CHECK(once.frame() == 60.0);
}

TEST_CASE("A playhead that is let go of between frames snaps to the nearest one while frames snap") {
  Playing playing;
  playing.shell.open.character()->view().frame = 7.6;
  playing.shell.ui.time.timeline.snapToFrames = false;
  snapPlayhead(playing.shell);
  CHECK(playing.frame() == 7.6);
  playing.shell.ui.time.timeline.snapToFrames = true;
  snapPlayhead(playing.shell);
  CHECK(playing.frame() == 8.0);
}
