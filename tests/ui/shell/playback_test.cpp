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
