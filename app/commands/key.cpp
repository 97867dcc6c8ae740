#include "app/commands/key.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace stretch::app {

namespace {

constexpr std::array<std::pair<Key, std::string_view>, 42> namedKeys{{
    {Key::space, "Space"},
    {Key::escape, "Esc"},
    {Key::enter, "Enter"},
    {Key::tab, "Tab"},
    {Key::backspace, "Backspace"},
    {Key::insert, "Insert"},
    {Key::del, "Delete"},
    {Key::right, "Right"},
    {Key::left, "Left"},
    {Key::down, "Down"},
    {Key::up, "Up"},
    {Key::pageUp, "Page Up"},
    {Key::pageDown, "Page Down"},
    {Key::home, "Home"},
    {Key::end, "End"},
    {Key::f1, "F1"},
    {Key::f2, "F2"},
    {Key::f3, "F3"},
    {Key::f4, "F4"},
    {Key::f5, "F5"},
    {Key::f6, "F6"},
    {Key::f7, "F7"},
    {Key::f8, "F8"},
    {Key::f9, "F9"},
    {Key::f10, "F10"},
    {Key::f11, "F11"},
    {Key::f12, "F12"},
    {Key::numpad0, "Numpad 0"},
    {Key::numpad1, "Numpad 1"},
    {Key::numpad2, "Numpad 2"},
    {Key::numpad3, "Numpad 3"},
    {Key::numpad4, "Numpad 4"},
    {Key::numpad5, "Numpad 5"},
    {Key::numpad6, "Numpad 6"},
    {Key::numpad7, "Numpad 7"},
    {Key::numpad8, "Numpad 8"},
    {Key::numpad9, "Numpad 9"},
    {Key::numpadDecimal, "Numpad ."},
    {Key::numpadEnter, "Numpad Enter"},
    // Other names by which people know some of them.
    {Key::escape, "Escape"},
    {Key::del, "Del"},
    {Key::enter, "Return"},
}};

/// Lower case without spaces: "Page Up" and "pageup" are the same name.
std::string folded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ') {
      result.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
  }
  return result;
}

bool isPrintableKey(char c) {
  const std::string_view punctuation = "',-./;=[\\]`";
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || punctuation.find(c) != std::string_view::npos;
}

std::optional<Key> parseKey(std::string_view text) {
  if (text.size() == 1) {
    const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return isPrintableKey(upper) ? std::optional(static_cast<Key>(upper)) : std::nullopt;
  }
  const std::string wanted = folded(text);
  const auto* const found = std::find_if(namedKeys.begin(), namedKeys.end(),
                                         [&](const auto& entry) { return folded(entry.second) == wanted; });
  return found == namedKeys.end() ? std::nullopt : std::optional(found->first);
}

bool takeModifier(std::string_view word, Chord& chord) {
  const std::string name = folded(word);
  if (name == "ctrl" || name == "control") {
    chord.ctrl = true;
  } else if (name == "shift") {
    chord.shift = true;
  } else if (name == "alt") {
    chord.alt = true;
  } else {
    return false;
  }
  return true;
}

} // namespace

std::optional<Chord> parseChord(std::string_view text) {
  Chord chord;
  std::size_t plus = text.find('+');
  while (plus != std::string_view::npos) {
    if (!takeModifier(text.substr(0, plus), chord)) {
      return std::nullopt;
    }
    text.remove_prefix(plus + 1);
    plus = text.find('+');
  }
  if (text == "?") {
    chord.shift = true;
    text = "/";
  }
  const std::optional<Key> key = parseKey(text);
  if (!key) {
    return std::nullopt;
  }
  chord.key = *key;
  return chord;
}

std::string keyName(Key key) {
  const auto* const found =
      std::find_if(namedKeys.begin(), namedKeys.end(), [&](const auto& entry) { return entry.first == key; });
  if (found != namedKeys.end()) {
    return std::string(found->second);
  }
  const int code = static_cast<int>(key);
  const bool printable = code > 0 && code < 128 && isPrintableKey(static_cast<char>(code));
  return printable ? std::string(1, static_cast<char>(code)) : std::string();
}

std::string chordText(const Chord& chord) {
  if (chord == Chord{Key::slash, false, true, false}) {
    return "?";
  }
  std::string text;
  text += chord.ctrl ? "Ctrl+" : "";
  text += chord.shift ? "Shift+" : "";
  text += chord.alt ? "Alt+" : "";
  return text + keyName(chord.key);
}

std::optional<int> digitOf(Key key) {
  const int code = static_cast<int>(key);
  if (key >= Key::digit0 && key <= Key::digit9) {
    return code - static_cast<int>(Key::digit0);
  }
  if (key >= Key::numpad0 && key <= Key::numpad9) {
    return code - static_cast<int>(Key::numpad0);
  }
  return std::nullopt;
}

bool isDecimalSeparator(Key key) {
  return key == Key::period || key == Key::comma || key == Key::numpadDecimal;
}

char typedLetter(const KeyPress& press) {
  if (press.letter != 0) {
    return press.letter;
  }
  const int code = static_cast<int>(press.chord.key);
  return code >= 'A' && code <= 'Z' ? static_cast<char>(code - 'A' + 'a') : '\0';
}

std::vector<Key> allKeys() {
  std::vector<Key> keys;
  for (int code = 1; code < 128; ++code) {
    if (isPrintableKey(static_cast<char>(code))) {
      keys.push_back(static_cast<Key>(code));
    }
  }
  keys.push_back(Key::space);
  for (int code = static_cast<int>(Key::escape); code <= static_cast<int>(Key::numpadEnter); ++code) {
    keys.push_back(static_cast<Key>(code));
  }
  return keys;
}

} // namespace stretch::app
