#pragma once

#include <filesystem>
#include <vector>

namespace stretch::ui {

struct EditorOptions {
  float scale = 0.0F; ///< Everything this many times as large, in place of the screen's and the user's scale;
                      ///< 0: theirs.
  int width = 0;      ///< Of the window; 0: as it was left.
  int height = 0;
  std::filesystem::path script; ///< Runs the editor by itself: see ui/shell/script.h. Empty: a user does.
};

/// Opens the editor, on a file or mesh sequence unless there is none, and returns when the user leaves: 0, or
/// 1 with one line on standard error when there is no display, no OpenGL 3.3, or a script failed. The
/// environment's STRETCH_UI_SCRIPT, STRETCH_UI_SCALE and STRETCH_UI_SIZE ("1280x720") stand in for options
/// that are not given.
int runEditor(const std::vector<std::filesystem::path>& files, const EditorOptions& options = {});

} // namespace stretch::ui
