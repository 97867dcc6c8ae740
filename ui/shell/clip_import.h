#pragma once

#include <filesystem>

#include "ui/shell/shell.h"

namespace stretch::ui {

// Clips of other files for the open character (app/edits/keys/import_clip.h), read beside the window.

/// Imports the clip of a file, or asks which where it holds several. A character is open.
void askForClip(Shell& shell, const std::filesystem::path& file);

/// Begins with it; one at a time.
void importClip(Shell& shell, const ClipAnswer& wanted);

/// Once a frame: takes up what was read, as one undo step, and shows the first of the clips.
void updateClipImport(Shell& shell);

} // namespace stretch::ui
