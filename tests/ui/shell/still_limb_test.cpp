#include <catch2/catch.hpp>

#include "app/commands/command_ids.h"
#include "tests/support/app/boxer.h"
#include "ui/shell/shell_commands.h"

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
  shell.open.character()->view().selectedLimbs = {"right-arm"};
  runCommand(shell, command::trailExaggerate);
  CHECK_FALSE(isRunning(shell.tool));
  CHECK(shell.open.character()->document().trails.empty());
  CHECK_FALSE(shell.open.character()->history().canUndo());
  REQUIRE(shell.ui.toasts.size() == 1);
  CHECK(shell.ui.toasts.front().text ==
        "The right arm does not move in this clip. The left arm makes its strongest stroke: 1 selects it");
}

TEST_CASE("E on several limbs of which one moves opens the tool") {
  Boxing boxing;
  Shell& shell = boxing.shell;
  shell.open.character()->view().selectedLimbs = {"right-arm", "left-arm"};
  runCommand(shell, command::trailExaggerate);
  CHECK(isRunning(shell.tool));
}
