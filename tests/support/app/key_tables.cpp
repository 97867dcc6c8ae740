#include "tests/support/app/key_tables.h"

#include <map>

namespace stretch::test {

std::vector<app::Key> allKeys() {
  std::vector<app::Key> keys;
  for (int code = 1; code <= static_cast<int>(app::Key::numpadEnter); ++code) {
    if (!app::keyName(static_cast<app::Key>(code)).empty()) {
      keys.push_back(static_cast<app::Key>(code));
    }
  }
  return keys;
}

std::vector<std::string> keyProblems(const std::vector<app::KeyedCommand>& commands) {
  std::vector<std::string> problems;
  std::map<std::string, std::string> owners;
  for (const app::KeyedCommand& command : commands) {
    for (const std::string& text : command.defaultKeys) {
      const auto chord = app::parseChord(text);
      if (!chord) {
        problems.push_back(command.id + ": there is no key \"" + text + "\"");
        continue;
      }
      const auto [owner, isNew] = owners.emplace(app::chordText(*chord), command.id);
      if (!isNew) {
        problems.push_back(owner->first + " is bound to " + owner->second + " and to " + command.id);
      }
    }
  }
  return problems;
}

} // namespace stretch::test
