#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/modal.h"
#include "app/edits/keys/key_edits.h"

namespace stretch::app {

/// The modals behind G and S over graph and dope sheet: move or scale the picked keys. Pure state: keys and
/// mouse in, an edit of keys out.
struct KeysModal {
  enum class Kind { move, scale };
  enum class Lock { none, time, value };
  Kind kind = Kind::move;
  Lock lock = Lock::none;
  bool valuesShown = true;  ///< Else there is nothing but time: the dope sheet.
  bool wholeFrames = true;  ///< Keys come to stand on whole frames.
  double aboutFrame = 0.0;  ///< For a scale:
  double aboutValue = 0.0;  ///< the playhead, and the value that the mouse began at.
  double mouseFrames = 0.0; ///< How far the mouse has pulled, frames and shown units;
  double mouseValue = 0.0;
  double mouseFactor = 1.0; ///< of a scale, how many times as far from the playhead it is.
  double arrowFrames = 0.0;
  double arrowValue = 0.0;
  double valueStep = 1.0; ///< Step of Up and Down, shown units.
  TypedNumber typed; ///< Replaces mouse and arrows: frames (or the value where that is locked), a factor.
};

/// X keeps to time and Y to value (again: both), digits type an amount, arrows step, Enter keeps, Esc
/// restores.
[[nodiscard]] ModalOutcome pressKey(KeysModal& modal, const KeyPress& press);

[[nodiscard]] KeyMove moveOf(const KeysModal& modal);
[[nodiscard]] KeyScale scaleOf(const KeysModal& modal);

/// "3 keys by 2 frames and 0.1".
[[nodiscard]] std::string modalText(const KeysModal& modal, std::size_t keys);
[[nodiscard]] std::vector<ModalHint> modalHints(const KeysModal& modal);

} // namespace stretch::app
