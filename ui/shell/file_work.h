#pragma once

#include "ui/shell/shell.h"
#include "ui/shell/window/input.h"

namespace stretch::ui {

// Joins the file work (app/file_work.h) with dialogs, messages and the view.

/// Opens a character or a mesh sequence (a path, or a base mesh and its cache) beside the running window;
/// asks first when work would be lost.
void openFile(Shell& shell, const std::vector<std::filesystem::path>& paths);

/// Opens a file that comes with the program.
Status openBundled(Shell& shell, const std::string& name);

/// Saves what is open: a character where it was saved before, the result of a sequence where a dialog says.
void saveFile(Shell& shell);
/// Saves under the next free number: "punch-002.glb".
void saveIncremental(Shell& shell);

/// Opens the dialog that asks for a file, with a proposed name.
void askForFile(Shell& shell, FilePurpose purpose);

/// Leaves the program; asks first when work would be lost.
void askToQuit(Shell& shell);

/// Once a frame: takes up a file that was read, answers of dialogs, drops, and keeps work aside. `nowSeconds`
/// of a clock that only runs forward.
void updateFileWork(Shell& shell, const InputQueue& input, double nowSeconds);

/// Writes how the file was looked at, and forgets the autosave: the program ends in peace.
void closeFile(Shell& shell);
/// Writes how the open character is looked at, and what it refers to, into the user's settings of its file.
void keepView(Shell& shell);

/// "punch.glb": the file of what is open, or where it was saved to; empty while nothing is.
[[nodiscard]] std::string openFileName(const Shell& shell);

/// "punch.glb" with a dot in front of it while there is unsaved work.
[[nodiscard]] std::string windowTitle(const Shell& shell);

/// Writes the viewed clip's trails as a recipe.
void saveRecipeFile(Shell& shell, const std::filesystem::path& path);
/// Replays a recipe on this character, as one undo step.
void loadRecipeFile(Shell& shell, const std::filesystem::path& path);
/// Puts the thing of a file into the selected hands.
void addPropFile(Shell& shell, const std::filesystem::path& path);

} // namespace stretch::ui
