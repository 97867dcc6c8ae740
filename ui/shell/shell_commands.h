#pragma once

#include <string_view>
#include <vector>

#include "ui/shell/shell.h"
#include "ui/shell/window/input.h"

namespace stretch::ui {

/// Every command of the editor: those of the document and those of the shell, as menus, palette and keys know
/// them.
[[nodiscard]] std::vector<app::Command<Shell>> editorCommands();

// The shell's own tables.
[[nodiscard]] std::vector<app::Command<Shell>> fileCommands();
[[nodiscard]] std::vector<app::Command<Shell>> viewCommands();
[[nodiscard]] std::vector<app::Command<Shell>> toolCommands();
[[nodiscard]] std::vector<app::Command<Shell>> helpCommands();
/// Cameras of the file, the best view, and the views that are kept under numbers.
[[nodiscard]] std::vector<app::Command<Shell>> cameraCommands();

/// Whether a switch is on; false for commands that are not switches.
[[nodiscard]] bool isChecked(const Shell& shell, std::string_view commandId);

/// Keeps what a tool or a drag in a panel has made so far: one undo step, before anything else happens.
void finishWhatIsDragged(Shell& shell);

/// Runs a command by its id; what went wrong is told in a toast. While the clip plays it is run at the whole
/// frame that is nearest, if snapping is on and it does more than look.
void runCommand(Shell& shell, std::string_view commandId);

/// Tells what of the document before stood where new things are now, and made room for them.
void tellGaveWay(Shell& shell, const app::Document& before);

/// Makes `shell.commandInfos` for the panels.
void describeCommands(Shell& shell);

/// A key for whoever owns the keys right now: dialogs and text fields, a running tool, else the commands.
void dispatchKey(Shell& shell, const KeyInput& input);

/// Whether a dialog or text field takes the keys.
[[nodiscard]] bool widgetsOwnKeys(const Shell& shell);

/// While E is on: the playhead to the tip of its trail, if the settings want it there.
void goToTip(Shell& shell);

/// Begins E, where the settings say at the trail's tip. A character is open.
Status startExaggerating(Shell& shell, app::OverlapChoice choice);

/// Takes up what the keys overview was answered: a key for a command, or all keys as they were. They are
/// written into the user's settings at once, and whose key it was is told.
void takeKeyAnswers(Shell& shell);

} // namespace stretch::ui
