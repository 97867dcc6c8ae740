#pragma once

#include "app/commands/table/command.h"

namespace stretch::app {

// Conditions that several tables of commands need before their commands are on.

[[nodiscard]] Need clipNeeded();          ///< A clip is viewed.
[[nodiscard]] Need limbNeeded();          ///< A limb is selected, in a clip.
[[nodiscard]] Need targetNeeded();        ///< There is a trail that commands act on.
[[nodiscard]] Need selectedTrailNeeded(); ///< A trail is selected.

} // namespace stretch::app
