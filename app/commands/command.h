#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session.h"

namespace stretch::app {

/// What a user asks for, by whatever door: menu, palette, key, batch or test. `Context` is what running
/// needs: Session for commands of the document, the shell's own type for those of the view.
template <typename Context>
struct Command {
  std::string id;                ///< "trail.apply": stable, used by key files and scripts.
  std::string label;             ///< As menus show it.
  std::string help;              ///< One sentence.
  std::vector<std::string> keys; ///< Default keys, "Ctrl+Shift+Z"; may be empty.
  std::function<bool(const Context&)> enabled;
  std::function<Status(Context&)> run;
};

} // namespace stretch::app
