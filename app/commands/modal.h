#pragma once

#include <string>

namespace stretch::app {

/// What a key did to a modal tool, which takes all keys until it ends.
enum class ModalOutcome {
  running,
  keep,   ///< Ends: the preview becomes one undo step.
  restore ///< Ends: everything is as before.
};

/// What a key does right now, for the status bar.
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

} // namespace stretch::app
