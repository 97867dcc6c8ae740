#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/open_document.h"

namespace stretch::app {

/// Request of a user, by whatever door: menu, palette, key or test. `Context` is what running needs: the
/// shell's own type for commands of the window.
template <typename Context>
struct Command {
  std::string id;                ///< "trail.apply": stable, used by key files and scripts.
  std::string label;             ///< Text in menus.
  std::string help;              ///< One sentence.
  std::vector<std::string> keys; ///< Default keys, "Ctrl+Shift+Z"; may be empty.
  std::function<bool(const Context&)> enabled;
  std::function<Status(Context&)> run;
  std::function<bool(const Context&)> checked;         ///< A switch: whether it is on.
  std::function<std::string(const Context&)> labelNow; ///< Label that is not always the same.
  std::function<std::string(const Context&)> needs;    ///< Says what to do first while it is off.
  std::string otherwise; ///< Id of the command that its keys run while it is off; may be empty.
  std::function<std::string(const Context&)> helpNow = {}; ///< Help that is not always the same.
};

/// When a command of a character is on, and what to do first while it is off.
struct Need {
  std::function<bool(const Session&)> holds = {};
  std::string text = {}; ///< "select a limb first".
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
  std::string needs = {};                                   ///< Says what to do first while it is off.
  std::string otherwise = {};                               ///< Copied to Command::otherwise.
  std::function<bool(const Session&)> checked = {};         ///< A switch: whether it is on.
  std::function<std::string(const Session&)> labelNow = {}; ///< Label that depends on what is open.
  std::function<std::string(const Session&)> helpNow = {};  ///< And the help.
  std::function<std::string(const Session&)> needsNow = {}; ///< And what to do first.
};

[[nodiscard]] bool isEnabled(const DocumentCommand& command, const OpenDocument& open);
/// Whether a switch of the character that is open is on; false for every other command.
[[nodiscard]] bool isChecked(const DocumentCommand& command, const OpenDocument& open);
[[nodiscard]] std::string labelNow(const DocumentCommand& command, const OpenDocument& open);
[[nodiscard]] std::string helpNow(const DocumentCommand& command, const OpenDocument& open);
/// Why it is off, as what to do first; empty while it is on.
[[nodiscard]] std::string whyOff(const DocumentCommand& command, const OpenDocument& open);
/// Runs a command; what is open must be of a kind that the command has a meaning for.
Status run(const DocumentCommand& command, OpenDocument& open);

} // namespace stretch::app
