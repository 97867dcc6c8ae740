#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/table/key.h"
#include "core/base/result.h"

namespace stretch::app {

/// Facts that keys need to know of a command.
struct KeyedCommand {
  std::string id;
  std::vector<std::string> defaultKeys; ///< Copied from Command::keys.
};

/// Which key runs which command: the defaults of the commands, with what the user changed on top.
class Keymap {
public:
  /// Keys that do not parse are left out.
  explicit Keymap(std::vector<KeyedCommand> commands);

  /// Id of the command that a key runs; empty for none.
  [[nodiscard]] std::string commandOf(const Chord& chord) const;
  [[nodiscard]] std::vector<Chord> chordsOf(std::string_view commandId) const;

  /// Gives a command this key alone (or none). A key that another command has is taken from it; answers that
  /// command's id, so that the clash can be told.
  Result<std::string> rebind(const std::string& commandId, const std::optional<Chord>& chord);
  void resetToDefaults();
  [[nodiscard]] bool isChanged() const { return !changed_.empty(); }

  /// {"version": 1, "keys": {"trail.apply": ["Enter"], ...}}: only what differs from the defaults, unless
  /// `all`.
  [[nodiscard]] std::string toJson(bool all = false) const;
  /// Reads what toJson wrote. Entries of unknown commands and keys are left out and told by an error, and
  /// toJson writes them again as they were, until their command gets another key; the others are taken. What
  /// is no file of keys changes nothing.
  Status readJson(const std::string& text);

private:
  [[nodiscard]] const KeyedCommand* find(std::string_view commandId) const;

  std::vector<KeyedCommand> commands_;
  std::map<std::string, std::vector<Chord>> changed_;
  std::map<std::string, std::string> unknown_; ///< Entries of the file that were left out, as JSON.
};

/// The keys of a table of commands.
template <typename AnyCommand>
[[nodiscard]] std::vector<KeyedCommand> keyedCommands(const std::vector<AnyCommand>& commands) {
  std::vector<KeyedCommand> keyed;
  keyed.reserve(commands.size());

  for (const AnyCommand& command : commands) {
    keyed.push_back({command.id, command.keys});
  }
  return keyed;
}

} // namespace stretch::app
