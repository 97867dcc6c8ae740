#include "app/commands/table/key.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace stretch::app {

namespace {

constexpr std::array<std::pair<Key, std::string_view>, 21> namedKeys{{
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
    {Key::numpadDecimal, "Numpad ."},
    {Key::numpadSubtract, "Numpad -"},
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

/// Keys that are told apart by a number.
struct NumberedKeys {
  Key first;
  Key last;
  int firstNumber;
  std::string_view name;
};
constexpr std::array<NumberedKeys, 2> numberedKeys{
    {{Key::f1, Key::f12, 1, "F"}, {Key::numpad0, Key::numpad9, 0, "Numpad "}}};

/// "F5", "Numpad 0"; empty for a key without a number.
std::string numberedName(Key key) {
  for (const NumberedKeys& keys : numberedKeys) {
    if (key >= keys.first && key <= keys.last) {
      const int number = keys.firstNumber + static_cast<int>(key) - static_cast<int>(keys.first);
      return std::string(keys.name) + std::to_string(number);
    }
  }
  return {};
}

std::optional<Key> parseKey(std::string_view text) {
  if (text.size() == 1) {
    const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return isPrintableKey(upper) ? std::optional(static_cast<Key>(upper)) : std::nullopt;
  }
  const std::string wanted = folded(text);
  const auto* const found =
      std::ranges::find_if(namedKeys, [&](const auto& entry) { return folded(entry.second) == wanted; });
  if (found != namedKeys.end()) {
    return found->first;
  }
  for (int code = static_cast<int>(Key::f1); code <= static_cast<int>(Key::numpad9); ++code) {
    if (folded(numberedName(static_cast<Key>(code))) == wanted) {
      return static_cast<Key>(code);
    }
  }
  return std::nullopt;
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
  return printable ? std::string(1, static_cast<char>(code)) : numberedName(key);
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

} // namespace stretch::app
