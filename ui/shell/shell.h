#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/commands/table/command.h"
#include "app/commands/table/keyboard_layout.h"
#include "app/commands/table/keymap.h"
#include "app/edits/keys/import_clip.h"
#include "app/file_work.h"
#include "app/open_document.h"
#include "app/sequence/job.h"
#include "ui/panels/context/panel_context.h"
#include "ui/panels/frame/pane_layout.h"
#include "ui/shell/bind_work.h"
#include "ui/shell/film_work.h"
#include "ui/shell/fit_work.h"
#include "ui/shell/pose_library.h"
#include "ui/shell/reference_work.h"
#include "ui/shell/style_work.h"
#include "ui/shell/user_settings.h"
#include "ui/viewport/tools.h"
#include "ui/viewport/viewport_state.h"

namespace stretch::ui {

/// Clips of another file on their way to the open character, beside the window.
struct ClipImport {
  std::filesystem::path file;
  std::shared_ptr<const Scene> scene;           ///< Scene of the character that they are for.
  std::unique_ptr<app::Job<app::NewClips>> job; ///< Null: none.
};

/// Work that goes on beside the window, each of which runs or does not.
struct WorkBeside {
  BindWork binding;
  FitWork fitting;
  ClipImport clipImport;
  StyleWork styling;
  PoseLibraryWork library;
  ReferenceWork reference;
  FilmWork film;
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
  app::FileWork files;
  WorkBeside beside;
  std::vector<app::Command<Shell>> commands;
  app::Keymap keymap{{}};
  app::KeyboardLayout keyboard; ///< The operating system's, as of this frame.
  std::vector<CommandInfo> commandInfos;
  std::vector<std::string> requested; ///< Command ids, run after the panels.
  app::Key heldKey = app::Key::none;
  std::string pressedKey;     ///< In this frame, while widgets own the keys.
  double playRemainder = 0.0; ///< Played time that made no whole step yet, seconds.
  std::string refused;        ///< Why the last command that was asked for was not done, as it was told.
  bool themeDirty = true;
  bool nameAsked = false; ///< The file dialog was opened for the question where to save to.
  bool quit = false;
};

/// Returns what is going on, for the panels.
[[nodiscard]] EditorStatus statusOf(const Shell& shell);
/// A character or a sequence is open.
[[nodiscard]] bool hasPicture(const Shell& shell);
/// A character is open, and one of its clips is shown.
[[nodiscard]] bool showsClip(const Shell& shell);
/// Work goes on beside the window.
[[nodiscard]] bool isBusy(const Shell& shell);

/// Tells the user something for a few seconds.
void tell(Shell& shell, ToastKind kind, const std::string& text);
/// Tells why a command is not done.
void refuse(Shell& shell, const std::string& why);
/// An error as a toast; nothing for success.
void tellProblem(Shell& shell, const Status& status);

} // namespace stretch::ui
