#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/keymap.h"
#include "app/open_document.h"
#include "ui/panels/panel_context.h"
#include "ui/shell/pane_layout.h"
#include "ui/shell/user_files.h"
#include "ui/shell/user_settings.h"
#include "ui/viewport/tools.h"
#include "ui/viewport/viewport_state.h"

namespace stretch::ui {

/// What is to be done once the user said what shall become of unsaved work.
enum class AfterUnsaved { nothing, quit, open };

/// Opening, saving and autosaving of the one file that is edited.
struct FileWork {
  std::filesystem::path path;               ///< As opened; empty: none is.
  std::future<Result<app::Opened>> loading; ///< Runs beside the window.
  std::vector<std::filesystem::path> loadingPaths;
  std::shared_ptr<std::atomic<float>> loadingShare; ///< Done, 0..1; < 0 unknown.
  std::optional<std::filesystem::path> restoreFrom; ///< Autosave to take up once `loading` is done.
  AfterUnsaved afterUnsaved = AfterUnsaved::nothing;
  std::vector<std::filesystem::path> pendingOpen;
  std::filesystem::path offeredAutosave; ///< What ui.restoreOffer is about.
  std::filesystem::path offeredSource;   ///< The file that it belongs to.
  std::filesystem::path stampedPath;     ///< File whose stamp is kept.
  std::optional<FileStamp> stamp;        ///< As we last read or wrote it.
  std::filesystem::path changedSavePath; ///< Save that waits for "yes, overwrite": changed by another
                                         ///< program.
  bool changeTold = false;               ///< The user knows that the file changed.
  double lastEditSeconds = 0.0;
  double lastAutosaveSeconds = -1.0;
  app::Document autosaved; ///< What the last autosave holds.
  bool hasAutosave = false;
};

/// The editor's state: plain parts that functions join. The session of what is open is the only door to the
/// document.
struct Shell {
  app::OpenDocument open;
  UiState ui;
  Theme theme;
  ItemRegistry items;
  PaneSizes panes;
  WindowMemory window;
  ViewportState viewport;
  Tool tool;
  FileWork files;
  std::vector<app::Command<Shell>> commands;
  app::Keymap keymap{{}};
  std::vector<CommandInfo> commandInfos;
  std::vector<std::string> requested; ///< Command ids, run after the panels.
  app::Key heldKey = app::Key::none;
  double playRemainder = 0.0; ///< Played time that made no whole step yet, seconds.
  bool themeDirty = true;
  bool quit = false;
};

/// Tells the user something for a few seconds.
void tell(Shell& shell, ToastKind kind, const std::string& text);
/// An error as a toast; nothing for success.
void tellProblem(Shell& shell, const Status& status);

} // namespace stretch::ui
