#pragma once

#include "ui/shell/input.h"
#include "ui/shell/shell.h"

namespace stretch::ui {

/// Opens a character or a mesh sequence (a path, or a base mesh and its cache) beside the running window;
/// asks first when work would be lost.
void openFile(Shell& shell, const std::vector<std::filesystem::path>& paths);

/// Saves where it was saved before, else asks for a name: the source is never overwritten by the first save.
void saveFile(Shell& shell);
void saveFileAs(Shell& shell, const std::filesystem::path& path, bool clean);
/// Saves under the next free number: "punch-002.glb".
void saveIncremental(Shell& shell);

/// Opens the dialog that asks for a file, with a proposed name.
void askForFile(Shell& shell, FilePurpose purpose);

/// Leaves the program; asks first when work would be lost.
void askToQuit(Shell& shell);

/// Once per frame: takes up a file that was loaded, answers of dialogs, drops, and saves aside. `nowSeconds`
/// of a clock that only runs forward.
void updateFileWork(Shell& shell, const InputQueue& input, double nowSeconds);

/// Offers the work that a crash left behind: on this file, or on any when it is empty.
void offerAutosave(Shell& shell, const std::filesystem::path& file);

/// Writes how the file was looked at, and forgets the autosave: the program ends in peace.
void closeFile(Shell& shell);

/// "punch.glb" with a dot in front of it while there is unsaved work.
[[nodiscard]] std::string windowTitle(const Shell& shell);

[[nodiscard]] bool hasUnsavedWork(const Shell& shell);

/// "punch-002.glb" after "punch.glb" and "punch-001.glb": the first free number.
[[nodiscard]] std::filesystem::path nextIncrement(const std::filesystem::path& path);

} // namespace stretch::ui
