#include "tests/support/ui/controllers_under_mouse.h"

#include <catch2/catch.hpp>

#include "tests/support/app/boxer.h"

namespace stretch::test {

ControllersUnderMouse::ControllersUnderMouse() : MouseStage(boxer()) {
  ui.overlays.controllers = true;
  session().view().frame = 20.0;
  frame();
}

Vec3 ControllersUnderMouse::placeOf(const std::string& id) const {
  const ui::ShownController* const shown = ui::findShown(viewport.controllers, id);
  REQUIRE(shown != nullptr);
  return shown->placed.placeWorld;
}

const std::vector<std::string>& ControllersUnderMouse::selected() const {
  return open.character()->view().selection.controllers();
}

} // namespace stretch::test
