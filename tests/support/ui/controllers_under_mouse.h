#pragma once

#include <string>
#include <vector>

#include "tests/support/ui/mouse_stage.h"

namespace stretch::test {

/// The boxer with its controllers shown; the playhead is on its punch.
struct ControllersUnderMouse : MouseStage {
  ControllersUnderMouse();
  /// Place of a controller that is shown, world space.
  [[nodiscard]] Vec3 placeOf(const std::string& id) const;
  [[nodiscard]] const std::vector<std::string>& selected() const;
};

} // namespace stretch::test
