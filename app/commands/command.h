#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/open_document.h"

namespace stretch::app {

/// What a user asks for, by whatever door: menu, palette, key or test. `Context` is what running needs: the
/// shell's own type for commands of the window.
template <typename Context>
struct Command {
  std::string id;                ///< "trail.apply": stable, used by key files and scripts.
  std::string label;             ///< As menus show it.
  std::string help;              ///< One sentence.
  std::vector<std::string> keys; ///< Default keys, "Ctrl+Shift+Z"; may be empty.
  std::function<bool(const Context&)> enabled;
  std::function<Status(Context&)> run;
  std::string needs = {};     ///< What there has to be for it, told while it is off; may be empty.
  std::string otherwise = {}; ///< Id of the command that its keys run while it is off; may be empty.
};

/// A command of what is open. It says what it means for each kind of document; for one that it has no
/// functions for it has no meaning, and is off.
struct DocumentCommand {
  std::string id;
  std::string label;
  std::string help;
  std::vector<std::string> keys;
  std::function<bool(const Session&)> enabled = {};
  std::function<Status(Session&)> run = {};
  std::function<bool(const SequenceSession&)> enabledOnSequence = {};
  std::function<Status(SequenceSession&)> runOnSequence = {};
  std::string needs = {};     ///< As Command::needs.
  std::string otherwise = {}; ///< As Command::otherwise.
};

[[nodiscard]] bool isEnabled(const DocumentCommand& command, const OpenDocument& open);
/// What is open must be of a kind that the command has a meaning for.
Status run(const DocumentCommand& command, OpenDocument& open);

} // namespace stretch::app
