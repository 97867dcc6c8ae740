// A mesh sequence in the shell: from where it is looked at, how it is played, and the moduli of its segments.
#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "skinning/elastic/moduli.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/shell/playback.h"
#include "ui/shell/sequence_work.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// A tube of twelve frames, 50 of them a second, that lies along x, or along z.
app::SequenceDocument lyingTube(bool alongZ) {
  MeshSequence tube = test::shorteningTube(12, 1.0, 0.06, 0.1);
  tube.framesPerSecond = 50.0;
  for (glm::vec3& place : tube.positions) {
    place = alongZ ? glm::vec3(place.z, place.y, -place.x) : place;
  }
  app::SequenceDocument document;
  document.paths = {"tube"};
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(tube));
  document.mesh = std::make_shared<const MeshSequence>(std::move(tube));
  return document;
}

} // namespace

TEST_CASE("A body that lies along z is looked at from its side, in the window and in pictures") {
  const bool alongZ = GENERATE(false, true);
  const double facing = alongZ ? 0.5 * pi : 0.0;
  Shell shell;
  shell.open.open(lyingTube(alongZ));
  showSequence(shell);
  CHECK(shell.viewport.look.facingYawRadians == facing);
  CHECK(shell.viewport.camera == lookFrom(Camera{}, ViewDirection::threeQuarter, facing));
  CHECK(shell.viewport.framePending);
  PictureOptions options;
  options.view = ViewDirection::front;
  const auto pictures =
      picturesOfSequence(contentOf(shell.open.sequence()->document()), {}, {}, {0.0, 11.0}, options);
  REQUIRE(pictures);
  CHECK(pictures->camera.yawRadians == facing);
}

TEST_CASE("A mesh sequence is played at its own rate, around, or up to its last frame") {
  Shell shell;
  shell.open.open(lyingTube(false));
  const double& frame = shell.open.sequence()->view().frame;
  TimelineState& time = shell.ui.time.timeline;
  time.playing = true;
  play(shell, 0.1);
  CHECK(frame == Approx(5.0));
  play(shell, 0.2); // to 15, of 11
  CHECK(frame == Approx(4.0));
  CHECK(time.playing);
  time.loop = false;
  play(shell, 0.2);
  CHECK(frame == 11.0);
  CHECK_FALSE(time.playing);
  shell.open.sequence()->view().frame = 6.6;
  snapPlayhead(shell);
  CHECK(frame == 7.0);
}

TEST_CASE("Moduli that are read replace what their file names, and are written as they are set") {
  const test::TemporaryFolder folder;
  Shell shell;
  shell.open.open(lyingTube(false));
  const auto moduli = [&] {
    const skinning::BodyStretchSettings& body = shell.open.sequence()->document().settings.body;
    return skinning::SegmentModuli{body.youngModulus, body.moduli.ranges};
  };
  const auto load = [&](const char* name) {
    answerSequenceFile(shell, {FilePurpose::openModuli, folder / name});
  };
  folder.write("all.json", R"({"young": 5, "segments": [{"from": 1, "to": 2, "young": 7}]})");
  load("all.json");
  CHECK(moduli() == skinning::SegmentModuli{5.0, {{1, 2, 7.0}}});
  folder.write("some.json", R"({"segments": [{"from": 0, "to": 0, "young": 3}]})");
  load("some.json");
  const skinning::SegmentModuli both{5.0, {{0, 0, 3.0}}}; // That of all other segments stays.
  CHECK(moduli() == both);
  CHECK(shell.open.sequence()->history().undoLabel() == "Load moduli");
  answerSequenceFile(shell, {FilePurpose::saveModuli, folder / "saved.json"});
  CHECK(shell.ui.toasts.back().text == "Saved saved.json");
  CHECK(skinning::parseModuli(readText(folder / "saved.json").value()).value() == both);
  load("none.json");
  CHECK(shell.ui.toasts.back().text == "none.json cannot be read");
  folder.write("bad.json", "3");
  load("bad.json");
  CHECK_THAT(shell.ui.toasts.back().text,
             Catch::StartsWith("bad.json: moduli: the moduli are no JSON object"));
  CHECK(moduli() == both);
}
