#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/file_work.h"
#include "ui/widgets/control.h"

namespace stretch::ui {

using ToastKind = app::Tone;

struct Toast {
  ToastKind kind = ToastKind::info;
  std::string text;
  float secondsLeft = 4.0F;
};

/// A message where it was drawn.
struct DrawnToast {
  Rect box;
  std::string text;
};

struct KeyHint {
  std::string key;  ///< "Enter"
  std::string does; ///< "keep"
};

/// One step of the tour, as its card shows it.
struct TourCard {
  int step = 0; ///< From 0.
  int steps = 0;
  std::string title;
  std::string text;
  std::string key; ///< Key to press.
};

/// State of the editor in this frame, as the panels show it: made anew for each one.
struct EditorStatus {
  std::string fileName;          ///< Name of what is open; empty: nothing is.
  bool unsaved = false;          ///< It holds work that no file has.
  app::FileQuestion question;    ///< Answered by UiAnswers::question.
  std::string modalText;         ///< "left arm x3.00, axes X Z": empty outside a modal.
  std::vector<KeyHint> keyHints; ///< Meaning of the keys in a modal.
  std::string busyText;          ///< "Opening punch.glb": work in progress; empty: none.
  float busyFraction = -1.0F;    ///< 0..1; < 0 unknown.
  std::string pressedKey;       ///< Pressed in this frame, as Command::keys spells it: for the keys overview.
  std::optional<TourCard> tour; ///< While it runs.
};

} // namespace stretch::ui
