#include "app/commands/table/keyboard_layout.h"

#include <algorithm>
#include <cctype>

namespace stretch::app {

namespace {

bool isLetter(Key key) {
  return key >= Key{'A'} && key <= Key{'Z'};
}

bool isUpperRowDigit(Key key) {
  return key >= Key::digit0 && key <= Key::digit9;
}

/// The key that is named as this text; none for text that names no printable key, or a digit.
Key keyPrinted(const std::string& text) {
  if (text.size() != 1 || text == " ") {
    return Key::none;
  }
  const Key key = static_cast<Key>(std::toupper(static_cast<unsigned char>(text.front())));
  return isUpperRowDigit(key) || keyName(key).empty() ? Key::none : key;
}

/// Capitals of ASCII and of the letters of Latin-1 (U+00E0 to U+00FE, without the sign U+00F7).
std::string capitals(std::string text) {
  if (text.size() == 1) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
  }
  const bool isLatin = text.size() == 2 && text[0] == '\xC3';
  const auto second = static_cast<unsigned char>(isLatin ? text[1] : '\0');
  if (second >= 0xA0 && second <= 0xBE && second != 0xB7) {
    text[1] = static_cast<char>(second - 0x20);
  }
  return text;
}

bool printsLatinLetters(const PrintedKeys& printed) {
  return std::ranges::any_of(
      printed, [](const auto& entry) { return isLetter(entry.first) && isLetter(keyPrinted(entry.second)); });
}

/// The places that print each key; the first of two.
std::map<Key, Key> placesByPrint(const PrintedKeys& printed) {
  std::map<Key, Key> places;
  for (const auto& [place, text] : printed) {
    const Key key = isUpperRowDigit(place) ? Key::none : keyPrinted(text);
    if (key != Key::none) {
      places.emplace(key, place);
    }
  }
  return places;
}

/// Where a key stands that no place prints: its own place, else the place of the key that stands there, and
/// so on. Ends, as no two places have one key and none has this one.
Key freePlaceFor(Key key, const std::map<Key, Key>& keys) {
  Key place = key;
  for (auto taken = keys.find(place); taken != keys.end(); taken = keys.find(place)) {
    place = taken->second;
  }
  return place;
}

} // namespace

KeyboardLayout::KeyboardLayout(const PrintedKeys& printed) {
  if (!printsLatinLetters(printed)) {
    return;
  }
  const std::map<Key, Key> places = placesByPrint(printed);
  for (const auto& [key, place] : places) {
    keys_[place] = key;
  }
  for (int code = 1; code < static_cast<int>(Key::escape); ++code) {
    const Key key = static_cast<Key>(code);
    if (!keyName(key).empty() && !isUpperRowDigit(key) && !places.contains(key)) {
      keys_[freePlaceFor(key, keys_)] = key;
    }
  }
  for (const auto& [place, key] : keys_) {
    const auto text = printed.find(place);
    if (text != printed.end() && key != Key::space) {
      labels_[key] = capitals(text->second);
    }
  }
}

Key KeyboardLayout::keyAt(Key place) const {
  const auto found = keys_.find(place);
  return found == keys_.end() ? place : found->second;
}

std::string KeyboardLayout::chordText(const Chord& chord) const {
  const auto label = labels_.find(chord.key);
  if (label == labels_.end() || label->second == keyName(chord.key)) {
    return app::chordText(chord);
  }
  Chord modifiers = chord;
  modifiers.key = Key::none;
  return app::chordText(modifiers) + label->second;
}

} // namespace stretch::app
