#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/files/save.h"
#include "tests/support/app/boxer.h"
#include "ui/shell/shell_commands.h"
#include "ui/shell/stroke_news.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The editor with the boxer, whose left arm punches while everything else stands still.
struct Boxing {
  Boxing() {
    shell.open.open(app::Opened{app::Document(test::boxer())});
    shell.commands = editorCommands();
    shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  }

  Shell shell;
};

} // namespace

TEST_CASE("E on a limb that stands still opens no tool: it says which limb makes a stroke, and its key") {
  Boxing boxing;
  Shell& shell = boxing.shell;
  shell.open.character()->view().selection.editTrails().limbs = {"right-arm"};
  runCommand(shell, command::trailExaggerate);
  CHECK_FALSE(isRunning(shell.tool));
  CHECK(shell.open.character()->document().trails.empty());
  CHECK_FALSE(shell.open.character()->history().canUndo());
  REQUIRE(shell.ui.toasts.size() == 1);
  CHECK(shell.ui.toasts.front().text ==
        "The right arm does not move in this clip. The left arm makes the strongest stroke: 1 selects it");
}

TEST_CASE("Enter after an E that was refused adds nothing to what was told, later it says why") {
  Boxing boxing;
  Shell& shell = boxing.shell;
  shell.open.character()->view().selection.editTrails().limbs = {"right-arm"};
  runCommand(shell, command::trailExaggerate);
  runCommand(shell, command::trailApply);
  REQUIRE(shell.ui.toasts.size() == 1);
  CHECK(shell.ui.toasts.front().text.starts_with("The right arm does not move"));
  shell.ui.toasts.clear();
  runCommand(shell, command::trailApply);
  REQUIRE(shell.ui.toasts.size() == 1);
  CHECK(shell.ui.toasts.front().text.starts_with("Apply new motion"));
}

TEST_CASE("E on another stroke than the limb's strongest says which frames are taken and where that is") {
  Shell shell;
  const Result<app::Document> dummy = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(dummy);
  shell.open.open(app::Opened{*dummy});
  shell.commands = editorCommands();
  shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  app::Session& session = *shell.open.character();
  session.view().selection.editTrails().limbs = {"left-arm"};
  const std::vector<rig::Moment> strokes = session.momentsOf("left-arm");
  REQUIRE(strokes.size() > 1);
  const rig::Moment strongest = *rig::strongestMoment(strokes);
  const rig::Moment other = strokes.front() == strongest ? strokes.back() : strokes.front();
  session.view().frame = std::floor(0.5 * (other.startFrame + other.endFrame));
  runCommand(shell, command::trailExaggerate);
  REQUIRE(shell.ui.toasts.size() == 1);
  const std::string where = fmt::format("{:.4g} to {:.4g}", strongest.startFrame, strongest.endFrame);
  CHECK(shell.ui.toasts.front().text.find(
            fmt::format("taken, frames {:.4g} to {:.4g}; the strongest, {}, is free", other.startFrame,
                        other.endFrame, where)) != std::string::npos);
  finishTool(session, shell.tool, false);
  session.view().frame = std::floor(0.5 * (strongest.startFrame + strongest.endFrame));
  runCommand(shell, command::trailExaggerate);
  CHECK(shell.ui.toasts.empty()); // Nor does what was told before stay in the way.
}

namespace {

/// The boxer whose left arm only sways.
app::Document swayingBoxer() {
  app::Document document = test::boxer();
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.front().edit([](Track& track) {
    for (std::size_t i = 0; i < track.values.size(); ++i) {
      track.values[i] = i % 4 == 3 ? 1.0F : 0.02F * track.values[i];
    }
  });
  document.clips = std::make_shared<const std::vector<Clip>>(clips);
  return document;
}

} // namespace

TEST_CASE("E on a limb that only sways is told that it makes no stroke, a range set by hand stretches it") {
  Boxing boxing;
  Shell& shell = boxing.shell;
  shell.open.open(app::Opened{swayingBoxer()});
  app::Session& session = *shell.open.character();
  session.view().selection.editTrails().limbs = {"left-arm"};
  runCommand(shell, command::trailExaggerate);
  CHECK_FALSE(isRunning(shell.tool));
  CHECK(session.document().trails.empty());
  REQUIRE(shell.ui.toasts.size() == 1);
  CHECK(shell.ui.toasts.front().text ==
        "The left arm makes no stroke in this clip: set a range, or choose another clip");
  app::setRangeByHand(session, {2.0, 10.0});
  runCommand(shell, command::trailExaggerate);
  CHECK(isRunning(shell.tool));
  CHECK(session.document().trails.front().settings.endFrame == 10.0);
}

TEST_CASE("E on a limb that the floor keeps as long as it is, says so") {
  Boxing boxing;
  Shell& shell = boxing.shell;
  shell.open.open(app::Opened{swayingBoxer()});
  app::Session& session = *shell.open.character();
  session.view().selection.editTrails().limbs = {"left-arm"};
  app::setRangeByHand(session, {0.0, 10.0});
  REQUIRE(startExaggerate(session, shell.tool));
  auto& tool = std::get<ExaggerateTool>(shell.tool);
  CHECK_FALSE(standsStill(session, tool));
  app::Document stopped = session.document();
  rig::Trail& trail = stopped.trails.front();
  const Vec3 tip = app::solvedTrail(session, trail.id)->tip.originalTip;
  trail.settings.stopAt = rig::StopPlane{tip, app::solvedTrail(session, trail.id)->tip.tip - tip};
  session.preview(stopped);
  CHECK(standsStill(session, tool));
  CHECK(stillNews(session, tool, [](const std::string&) {
          return "1";
        }).find("only into the floor in frames 0 to 10") != std::string::npos);
}

TEST_CASE("E on a limb whose stroke has a trail goes on editing that trail, wherever the playhead stands") {
  Shell shell;
  const Result<app::Document> dummy = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(dummy);
  shell.open.open(app::Opened{*dummy});
  shell.commands = editorCommands();
  shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  app::Session& session = *shell.open.character();
  session.view().selection.editTrails().limbs = {"left-arm"};
  app::setRangeByHand(session, {20.0, 26.0});
  runCommand(shell, command::trailExaggerate);
  auto& tool = std::get<ExaggerateTool>(shell.tool);
  tool.modal.settings.scale = 3.0;
  session.preview(*app::exaggeratedWith(tool.targets, tool.modal));
  finishTool(session, shell.tool, true);
  app::selectTrail(session, 0);
  app::selectLimb(session, "left-arm", false);
  session.view().frame = 0.0;
  session.view().rangeEnd = session.view().rangeStart - 1.0;
  session.view().selection.dropTrail();
  const std::size_t steps = session.history().position();
  runCommand(shell, command::trailExaggerate);
  REQUIRE(isRunning(shell.tool));
  REQUIRE(session.document().trails.size() == 1);
  CHECK(session.document().trails.front().settings.scale == 3.0);
  CHECK(session.document().trails.front().settings.startFrame == 20.0);
  REQUIRE(shell.ui.toasts.size() == 1);
  CHECK(shell.ui.toasts.front().text ==
        "The left arm has a trail at its strongest stroke: that goes on, frames 20 to 26");
  finishTool(session, shell.tool, true);
  CHECK(session.history().position() <= steps + 1);
}

TEST_CASE("E on several limbs of which one moves opens the tool") {
  Boxing boxing;
  Shell& shell = boxing.shell;
  shell.open.character()->view().selection.editTrails().limbs = {"right-arm", "left-arm"};
  runCommand(shell, command::trailExaggerate);
  CHECK(isRunning(shell.tool));
}
