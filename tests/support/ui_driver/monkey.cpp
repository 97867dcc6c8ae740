#include "tests/support/ui_driver/monkey.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "tests/support/ui_driver/document_watch.h"

namespace stretch::test {

using namespace ui;

namespace {

constexpr int stepsBetweenChecks = 40;

/// What an animator presses all day.
const std::vector<std::string>& usualKeys() {
  static const std::vector<std::string> keys{"1",      "2",      "3",          "4",       "5",
                                             "6",      "E",      "E",          "3",       "0",
                                             "X",      "Y",      "Z",          "Enter",   "Enter",
                                             "Enter",  "Escape", "Ctrl+Z",     "Ctrl+Z",  "Ctrl+Shift+Z",
                                             "Tab",    "Tab",    "G",          "Up",      "Down",
                                             "Left",   "Right",  "Shift+1",    "Shift+2", "[",
                                             "]",      "Ctrl+.", "Delete",     ".",       ",",
                                             "Ctrl+C", "Ctrl+V", "Ctrl+M",     "C",       "T",
                                             "Home",   "End",    "L",          "I",       "O",
                                             "V",      "R",      "Ctrl+Enter", "Space",   "B"};
  return keys;
}

const std::vector<std::string>& anyKeys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> all{"Enter",   "Escape",    "Tab",      "Backspace", "Insert",   "Delete",
                                 "Left",    "Right",     "Up",       "Down",      "Home",     "End",
                                 "Page Up", "Page Down", "Space",    "F1",        "F2",       "F3",
                                 "F5",      "Numpad 1",  "Numpad 3", "Numpad 5",  "Numpad 7", "Numpad 0"};
    for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789,.-=;'`[]/")) {
      all.emplace_back(1, c);
    }
    return all;
  }();
  return keys;
}

const std::vector<std::string>& texts() {
  static const std::vector<std::string> all{"3",      "0.5", "2*3",  "-1", "1+",   "abc", "(",
                                            "1e9",    "nan", "50 %", "27", "2,25", "x",   "arm",
                                            "-0.001", "0",   "99",   "..", "*",    "a b"};
  return all;
}

} // namespace

Monkey::Monkey(unsigned seed, int steps)
    : random_(seed), stepsLeft_(steps), untilCheck_(stepsBetweenChecks),
      home_(std::filesystem::weakly_canonical(std::filesystem::current_path())) {}

std::size_t Monkey::below(std::size_t count) {
  return random_() % count;
}

bool Monkey::chance(int percent) {
  return static_cast<int>(below(100)) < percent;
}

const std::string& Monkey::anyOf(const std::vector<std::string>& words) {
  return words[below(words.size())];
}

std::string Monkey::place() {
  return fmt::format("{:.3f} {:.3f}", 0.001 * static_cast<double>(below(1001)),
                     0.001 * static_cast<double>(below(1001)));
}

std::string Monkey::modifiers() {
  std::string text;
  for (const char* name : {" shift", " ctrl", " alt"}) {
    text += chance(10) ? name : "";
  }
  return text;
}

std::string Monkey::anyItem(const Shell& shell) {
  std::vector<std::string> ids;
  for (const Item& item : shell.items.items) {
    if (item.enabled && !item.id.empty() && item.id.find_first_of(" #\t") == std::string::npos) {
      ids.push_back(item.id);
    }
  }
  if (ids.empty()) {
    return {};
  }
  // What lies on top was drawn last.
  const bool covered = !openThing(shell).empty() && chance(70);
  const std::size_t first = covered ? ids.size() - std::min<std::size_t>(ids.size(), 12) : 0;
  return ids[first + below(ids.size() - first)];
}

std::string Monkey::key(const Shell& shell) {
  if (!heldKey_.empty() && chance(30)) {
    return "release " + std::exchange(heldKey_, std::string());
  }
  std::string key = anyOf(usualKeys());
  if (chance(15)) {
    const std::vector<app::Chord> chords =
        shell.keymap.chordsOf(shell.commands[below(shell.commands.size())].id);
    key = chords.empty() ? key : app::chordText(chords.front());
  } else if (chance(15)) {
    key = anyOf({"", "", "Ctrl+", "Shift+", "Alt+", "Ctrl+Shift+"}) + anyOf(anyKeys());
  }
  if (heldKey_.empty() && chance(3)) {
    heldKey_ = key;
    return "hold " + key;
  }
  return anyOf({"key ", "key ", "tap "}) + key;
}

std::string Monkey::pressOrLift(const Shell& shell) {
  if (pressed_) {
    pressed_ = !chance(40);
    return pressed_ ? "move " + (chance(60) ? "viewport" : anyItem(shell)) + " " + place() : "lift";
  }
  pressed_ = true;
  return "press left" + modifiers();
}

std::string Monkey::mouse(const Shell& shell) {
  const std::string id = chance(35) ? anyOf({"viewport", "viewport", "timeline"}) : anyItem(shell);
  const std::string onId = shell.items.find(id) != nullptr ? id : anyItem(shell);
  if (onId.empty()) {
    return "wait 1";
  }
  switch (below(10)) {
  case 0:
    return "doubleclick " + onId + " " + place() + modifiers();
  case 1:
    return "rightclick " + onId + " " + place() + modifiers();
  case 2:
  case 3:
    return "drag " + onId + " " + place() + " " + onId + " " + place() +
           anyOf({" left", " left", " left", " right", " middle"}) + modifiers();
  case 4:
    return "move " + onId + " " + place();
  default:
    return "click " + onId + (chance(50) ? " " + place() : "") + modifiers();
  }
}

std::string Monkey::something(const Shell& shell) {
  if (pressed_ && chance(50)) {
    return pressOrLift(shell);
  }
  const std::size_t dice = below(100);
  if (dice < 45) {
    return key(shell);
  }
  if (dice < 85) {
    return pressed_ ? pressOrLift(shell) : mouse(shell);
  }
  if (dice < 89) {
    return anyOf({"wheel 1", "wheel -1", "wheel 3"});
  }
  if (dice < 95) {
    return "type " + anyOf(texts());
  }
  if (dice < 97) {
    return pressOrLift(shell);
  }
  return dice == 97 && chance(30) ? "drop " + shell.files.path().string() : "wait 5";
}

bool Monkey::isAstray(const Shell& shell) const {
  const FileDialogState& dialog = shell.ui.dialogs.file;
  const std::filesystem::path folder = std::filesystem::weakly_canonical(dialog.folder);
  return dialog.open &&
         std::mismatch(home_.begin(), home_.end(), folder.begin(), folder.end()).first != home_.end();
}

void Monkey::planSave(const Shell& shell) {
  constexpr int mostKeys = 4;
  if (shell.ui.dialogs.file.open && saving_ < mostKeys) {
    ++saving_;
    planned_ = {"key Enter"};
  } else {
    saving_ = 0;
    planned_ = {"expect plays-as-drawn yes", "until unsaved no"};
  }
}

void Monkey::planChecks(const Shell& shell) {
  untilCheck_ = stepsBetweenChecks;
  pressed_ = false;
  planned_ = {"redo-all", "wait 2", "undo-all", "calm"};
  if (const app::Session* const character = shell.open.character()) {
    planned_.push_back(fmt::format("wait 1 # {} trails, last step: {}", character->document().trails.size(),
                                   character->history().undoLabel()));
  }
  if (!heldKey_.empty()) {
    planned_.push_back("release " + std::exchange(heldKey_, std::string()));
  }
  if (shell.open.character() != nullptr && !shell.files.isOpening()) {
    planned_.insert(planned_.begin(), "key Ctrl+S");
    saving_ = 1;
  }
}

void Monkey::tell(const std::string& line) {
  if (!told_.is_open()) {
    told_.open("monkey.script");
  }
  told_ << line << std::endl; // Flushed: the next step may be the last one.
}

std::optional<std::string> Monkey::next(Shell& shell) {
  if (planned_.empty() && saving_ > 0) {
    planSave(shell);
  } else if (planned_.empty() && untilCheck_ <= 0) {
    planChecks(shell);
  }
  std::string line;
  if (!planned_.empty()) {
    line = planned_.back();
    planned_.pop_back();
  } else if (isAstray(shell)) {
    line = "key Escape";
  } else if (stepsLeft_ == 0) {
    return std::nullopt;
  } else {
    line = something(shell);
    --stepsLeft_;
    untilCheck_ = stepsLeft_ == 0 ? 0 : untilCheck_ - 1;
  }
  tell(line);
  return line;
}

} // namespace stretch::test
