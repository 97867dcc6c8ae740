#pragma once

#include <map>
#include <string>

#include "app/commands/table/key.h"

namespace stretch::app {

/// What the places of a keyboard print without modifiers, as UTF-8; places that print nothing are left out.
using PrintedKeys = std::map<Key, std::string>;

/// Which key each printable place stands for under the user's layout. Letters and punctuation go by what is
/// printed, digits by place; what no place prints stands at its own place, or where the key that has taken it
/// came from. Every key stands at exactly one place. A
/// layout that prints none of the letters a to z at the places of letters goes by place altogether.
class KeyboardLayout {
public:
  /// The US layout.
  KeyboardLayout() = default;
  explicit KeyboardLayout(const PrintedKeys& printed);

  /// Key that a place stands for; keys that print nothing are themselves.
  [[nodiscard]] Key keyAt(Key place) const;
  /// The chord as the keyboard is labelled: the digit for a digit, else what the layout prints in capitals.
  [[nodiscard]] std::string chordText(const Chord& chord) const;

  friend bool operator==(const KeyboardLayout&, const KeyboardLayout&) = default;

private:
  std::map<Key, Key> keys_;           ///< By place.
  std::map<Key, std::string> labels_; ///< By key; keys of places that print something.
};

} // namespace stretch::app
