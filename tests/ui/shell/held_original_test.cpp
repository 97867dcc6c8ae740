#include <catch2/catch.hpp>

#include "tests/support/ui/editor_stage.h"
#include "ui/shell/shell_commands.h"

using namespace stretch;
using namespace stretch::ui;

TEST_CASE("The original is shown while its key is held, whatever other keys do meanwhile, and not after") {
  test::EditorStage stage;
  stage.openBoxer();
  const auto isShownAfter = [&](const char* key, bool down) {
    KeyInput input;
    input.press.chord = *app::parseChord(key);
    input.down = down;
    dispatchKey(stage.shell, input);
    return stage.session().view().showOriginal;
  };
  CHECK(isShownAfter("O", true));
  CHECK(isShownAfter("H", true));
  CHECK(isShownAfter("H", false));
  CHECK_FALSE(isShownAfter("O", false));
  CHECK(isShownAfter("`", true)); // its other key
  CHECK(isShownAfter("O", false));
  CHECK_FALSE(isShownAfter("`", false));
}
