#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/table/ranges.h"
#include "app/files/file_facts.h"
#include "ui/panels/state/file_dialog_state.h"

namespace stretch::ui {

/// The list of what was done.
struct HistoryState {
  bool open = false;
  int highlighted = -1; ///< Row that the keys are on.
  bool wasOpen = false; ///< In the frame before.
};

struct PaletteState {
  bool open = false;
  std::string typed;
  int highlighted = 0;
  bool clipsOnly = false; ///< It lists the clips of the character, and no commands.
  bool wasOpen = false;   ///< In the frame before.
};

struct KeysOverviewState {
  bool open = false;
  std::string filter;
  std::string waitingFor; ///< Command id whose new key is awaited; empty: none.
  std::string clash;      ///< Told after a refused or shared key.
};

/// A file that was dropped on the open character, and that need not be opened in its place.
struct DroppedFile {
  std::filesystem::path path; ///< Empty: none is asked about.
  bool canBeHeld = false;     ///< By a hand: it is a thing.
  bool hasClips = false;
};

/// Choosing one of the clips of another file.
struct ClipPick {
  std::filesystem::path file; ///< Empty: nothing is asked.
  std::vector<app::FileFacts::ClipFacts> clips;
  std::string filter;
  int highlighted = 0;  ///< Index among those that the filter leaves.
  bool wasOpen = false; ///< In the frame before.
};

/// The dialog of the clip's reference.
struct ReferenceDialogState {
  bool open = false;
  std::size_t imageCount = 0; ///< In the series that was found.
};

/// Button of a question that Enter stands for, moved by Tab and the arrows.
struct QuestionFocus {
  std::string question; ///< Id of its dialog; empty: none is asked.
  int button = -1;      ///< Index; -1: Enter stands for none.
};

/// Dialogs that can lie over the window, and what each is about.
struct DialogStates {
  FileDialogState file;
  PaletteState palette;
  KeysOverviewState keys;
  HistoryState history;
  std::optional<app::RangeClash> rangeClash; ///< Asked about; none: nothing is.
  DroppedFile dropped;
  ClipPick clipPick;
  ReferenceDialogState reference;
  QuestionFocus question;
  std::string lostFilm; ///< Name of the video that quitting would give up; empty: nothing is asked.
  bool settingsOpen = false;
  bool aboutOpen = false;
  bool navigationChoiceOpen = false; ///< The first start.
};

} // namespace stretch::ui
