#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/commands/table/ranges.h"
#include "app/commands/trail/exaggerate.h"
#include "app/file_work.h"
#include "ui/panels/state/file_dialog_state.h"

namespace stretch::ui {

enum class NavigationStyle { maya, blender };

struct FileChoice {
  FilePurpose purpose = FilePurpose::openModel;
  std::filesystem::path path;
};

/// Choice of what is to become of it.
struct DropAnswer {
  std::filesystem::path file;
  FilePurpose purpose = FilePurpose::openModel; ///< Or openProp, or openClip.
};

/// Which clips of another file are to be imported.
struct ClipAnswer {
  std::filesystem::path file;
  int clip = -1; ///< Clip of `file`; -1: all of them.
};

struct KeyChange {
  std::string commandId;
  std::string keyText; ///< Spelt as in Command::keys; empty: no key.
};

/// Answers that the user gave in a dialog, for the shell to take (and reset) in the same frame.
struct UiAnswers {
  std::optional<FileChoice> file;
  std::optional<app::FileAnswer> question; ///< To EditorStatus::question.
  std::optional<NavigationStyle> navigation;
  std::optional<KeyChange> keyChange;
  std::optional<app::OverlapChoice> overlap; ///< To DialogStates::rangeClash.
  std::optional<DropAnswer> drop;            ///< To DialogStates::dropped.
  std::optional<ClipAnswer> clip;            ///< To DialogStates::clipPick.
  bool resetKeys = false;
  bool themeChanged = false;    ///< `theme` or `scale` below was changed.
  bool quitWithoutFilm = false; ///< To DialogStates::lostFilm.
  bool keepSettings = false;    ///< The user's settings are to be written at once.
};

} // namespace stretch::ui
