#pragma once

#include <filesystem>

#include "app/session.h"
#include "core/gltf/json/json.h"
#include "ui/panels/frame/pane_layout.h"
#include "ui/panels/state/ui_state.h"
#include "ui/viewport/camera/look_through.h"

namespace stretch::ui {

/// Memory of the window between starts.
struct WindowMemory {
  int width = 1440; ///< Window units.
  int height = 860;
  bool maximised = false;
};

/// Theme, navigation, overlays, panes and recent files as JSON, and back. Reading takes what it understands
/// and leaves the rest as it is: a damaged file never keeps the program from starting.
[[nodiscard]] std::string settingsText(const UiState& ui, const PaneSizes& panes, const WindowMemory& window);
void readSettings(const std::string& text, UiState& ui, PaneSizes& panes, WindowMemory& window);

/// How one file was looked at last: camera, clip, playhead, selection; the views that are kept, and what its
/// clips refer to (app::referencesToJson).
[[nodiscard]] std::string viewText(const app::ViewState& view, const ViewBookmark& now,
                                   const ViewBookmarks& kept, const gltf::Json& references = {});
void readView(const std::string& text, const app::Document& document, app::ViewState& view, ViewBookmark& now,
              ViewBookmarks& kept);

[[nodiscard]] gltf::Json referencesOfView(const std::string& text);

[[nodiscard]] std::filesystem::path settingsPath();
[[nodiscard]] std::filesystem::path keysPath();
[[nodiscard]] std::filesystem::path viewPath(const std::filesystem::path& file);

/// Puts a file first in the list of recent ones.
void rememberRecent(UiState& ui, const std::filesystem::path& file);

} // namespace stretch::ui
