#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stretch::app {

/// A key by what a US keyboard prints on it: a place as the window reports it, or what `KeyboardLayout` makes
/// of that place. Printable keys have the value of their character (letters in capitals): Key{'Z'} is one
/// without a name of its own here.
enum class Key : int {
  none = 0,
  space = ' ',
  comma = ',',
  minus = '-',
  period = '.',
  slash = '/',
  digit0 = '0',
  digit9 = '9',
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  pageUp,
  pageDown,
  home,
  end,
  f1,
  f12 = f1 + 11,
  numpad0,
  numpad9 = numpad0 + 9,
  numpadDecimal,
  numpadSubtract,
  numpadEnter,
};

/// A key with its modifiers, as a command is bound to it.
struct Chord {
  Key key = Key::none;
  bool ctrl = false;
  bool shift = false;
  bool alt = false;

  friend bool operator==(const Chord&, const Chord&) = default;
};

/// One press (or repeat) of a key, as the window reports it.
struct KeyPress {
  Chord chord;
  /// Letter that the user's layout prints for the key without modifiers, in lower case; 0 when it prints
  /// nothing or is not known. Keys that are typed for what they say (x, y, z) are read by this.
  char letter = 0;
};

/// "Ctrl+Shift+Z", "[", "Numpad 1", "?" (which is Shift+/). Modifiers in any order; case does not matter.
[[nodiscard]] std::optional<Chord> parseChord(std::string_view text);

/// Returns the text that `parseChord` reads, modifiers in the order Ctrl, Shift, Alt.
[[nodiscard]] std::string chordText(const Chord& chord);

/// Name of a key without modifiers: "Page Up". Empty for Key::none.
[[nodiscard]] std::string keyName(Key key);

/// The digit that a key of the upper row or of the numeric pad types.
[[nodiscard]] std::optional<int> digitOf(Key key);

/// Whether the key types a decimal separator: period, comma, or the numeric pad's.
[[nodiscard]] bool isDecimalSeparator(Key key);

/// Returns the letter that the key is typed for: the layout's letter, else the position's.
[[nodiscard]] char typedLetter(const KeyPress& press);

} // namespace stretch::app
