#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/commands/table/key.h"
#include "core/math/types.h"

namespace stretch::app {

/// Outcome of a key for a modal tool, which takes all keys until it ends.
enum class ModalOutcome {
  running,
  keep,   ///< Ends: the preview becomes one undo step.
  restore ///< Ends: everything is as before.
};

/// Meaning of a key right now, for the status bar.
struct ModalHint {
  std::string key;
  std::string does;
};

/// A number as it is typed: digits, one decimal separator (period or comma), a leading minus.
struct TypedNumber {
  std::string text; ///< With a period, whatever was typed.

  [[nodiscard]] bool empty() const { return text.empty(); }
  /// 0 for what is not yet a number ("", "-", ".").
  [[nodiscard]] double value() const;
};

/// How a key ends a modal tool: Enter keeps, Esc restores; nothing for every other key.
[[nodiscard]] std::optional<ModalOutcome> endBy(const Chord& chord);

/// Takes a digit, a separator, minus (turns the sign) or Backspace into a number that is typed. False for a
/// key that types none of it.
bool typeNumber(TypedNumber& number, const Chord& chord);

inline constexpr std::array<char, 3> axisNames{'X', 'Y', 'Z'};

/// 0 for x, 1 for y, 2 for z; nothing for another letter.
[[nodiscard]] std::optional<int> axisOf(char letter);

/// Direction and length of an arrow's or page key's nudge: right, up, towards the viewer, times the step
/// (Shift ten times, Ctrl a tenth); zero for other keys. `viewAxes`: world columns: right, up, towards the
/// viewer.
[[nodiscard]] Vec3 nudgeOf(const Chord& chord, const Mat3& viewAxes, double stepUnits);

} // namespace stretch::app
