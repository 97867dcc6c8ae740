#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/commands/table/command.h"
#include "app/commands/table/key.h"

namespace stretch::app {

/// Ids of the commands that nudge controllers begin with it.
inline constexpr const char* controllerNudges = "controller.nudge-";

/// Subject that arrows and page keys move.
struct NudgeSubject {
  std::string idPrefix; ///< "sphere.nudge-": the direction and the reach follow.
  std::string words;    ///< "the selected spheres".
  bool ownsKeys = true; ///< Else the keys come to it through another command.
  Need need;
  std::string otherwisePrefix; ///< Prefix of the commands that the keys run while it is off; empty: what
                               ///< steps time.
  std::function<Status(Session&, const Chord&)> nudge;
};

/// A command for each direction as the view shows it, ten times as far with Shift and a tenth with Ctrl. The
/// plain arrows step frames and keys while there is nothing to nudge.
[[nodiscard]] std::vector<DocumentCommand> nudgeCommands(const NudgeSubject& subject);

} // namespace stretch::app
