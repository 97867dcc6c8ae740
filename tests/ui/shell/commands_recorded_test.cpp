#include <memory>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/shell/shell_commands.h"

using namespace stretch;
using test::EditorStage;
using test::Work;

// What each command of the editor does where it is on, and what is told where it is off, in the states that
// work brings the editor to.

namespace {

struct EditorState {
  const char* name;
  void (*prepare)(const Work&);
};

const EditorState editorStates[] = {
    {"nothing is open", test::withNothing},
    {"a trail", test::withTrail},
    {"controllers", test::withControllers},
    {"picked keys",
     [](const Work& work) {
       test::withArmsGraph(work);
       test::pickAll(work);
     }},
    {"a compressed sequence", test::withCompression},
};

/// Those that open files of the program, which lie elsewhere on each machine, or look into its folders.
bool isLeftOut(const std::string& id) {
  return id == app::command::tour || id.starts_with("help.bundled");
}

std::unique_ptr<EditorStage> stageIn(const EditorState& state) {
  auto stage = std::make_unique<EditorStage>();
  state.prepare(stage->work());
  stage->frames(2);
  stage->settle();
  return stage;
}

std::string commandsText(const EditorState& state) {
  std::string text = std::string(state.name) + "\n";
  std::unique_ptr<EditorStage> stage = stageIn(state);
  for (const app::Command<ui::Shell>& command : ui::editorCommands()) {
    if (isLeftOut(command.id)) {
      continue;
    }
    const ui::CommandInfo info =
        *std::ranges::find(stage->shell.commandInfos, command.id, &ui::CommandInfo::id);
    const test::Lines before = stage->lines();
    stage->run(command.id);
    stage->settle();
    constexpr int most = 12;
    const std::string done = test::changeText(before, stage->lines(), most);
    text += fmt::format("    {} : {} , {}{}{}\n", command.id, info.label, info.keyText,
                        info.enabled ? "" : " , off", info.checked ? " , on now" : "");
    text += done;
    stage->shell.ui.toasts.clear();
    if (!done.empty() && info.enabled) {
      stage = nullptr;
      stage = stageIn(state);
    }
  }
  return text;
}

} // namespace

TEST_CASE("What each command of the editor does in each state of the work is as it was looked at") {
  std::string text;
  for (const EditorState& state : editorStates) {
    text += commandsText(state);
  }
  test::compareWithRecord("editor-commands", text);
}
