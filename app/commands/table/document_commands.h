#pragma once

#include <string>
#include <vector>

#include "app/commands/table/command.h"
#include "rig/body/locators/locators.h"

namespace stretch::app {

/// Every command of what is open, in the order in which menus show them. They act on what is selected in the
/// session's view: `enabled` tells whether there is something to act on, `run` says in one line why it could
/// not.
[[nodiscard]] std::vector<DocumentCommand> documentCommands();

// The tables that it is made of, one per subject.
[[nodiscard]] std::vector<DocumentCommand> historyCommands();
[[nodiscard]] std::vector<DocumentCommand> limbCommands();
[[nodiscard]] std::vector<DocumentCommand> selectionSetCommands();
[[nodiscard]] std::vector<DocumentCommand> locatorCommands();
[[nodiscard]] std::vector<DocumentCommand> timeCommands();
[[nodiscard]] std::vector<DocumentCommand> clipCommands();
[[nodiscard]] std::vector<DocumentCommand> trailCommands();
[[nodiscard]] std::vector<DocumentCommand> groupCommands();
[[nodiscard]] std::vector<DocumentCommand> sphereCommands();
[[nodiscard]] std::vector<DocumentCommand> controllerCommands();
[[nodiscard]] std::vector<DocumentCommand> poseCommands();
[[nodiscard]] std::vector<DocumentCommand> holdCommands();
[[nodiscard]] std::vector<DocumentCommand> keyCommands();
[[nodiscard]] std::vector<DocumentCommand> weightCommands();
[[nodiscard]] std::vector<DocumentCommand> sequenceCommands();

/// Whether the character has neither limbs nor a skeleton: locators are fitted to its meshes.
[[nodiscard]] bool isMeshAlone(const Session& session);

/// Id of the plan whose locators a command fits: empty for the one that the shape shows.
[[nodiscard]] std::string planToFit(const Session& session, const std::string& command);

/// Puts locators that were fitted into the document, shown, as one step of this name.
void takeLocators(Session& session, rig::Locators locators, const std::string& label);

} // namespace stretch::app
