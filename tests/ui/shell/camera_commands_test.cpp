#include <catch2/catch.hpp>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/files/save.h"
#include "tests/support/app/camera_file.h"
#include "tests/support/app/new_trail.h"
#include "ui/shell/shell_commands.h"

using namespace stretch;
using namespace stretch::ui;
namespace command = app::command;

namespace {

/// The editor with a boxer that has the cameras Side, Front and Flat, and a punch on its left arm.
struct Filmed {
  Filmed() {
    const Result<app::Document> document = app::openDocument(test::boxerWithCameras(folder));
    REQUIRE(document);
    shell.open.open(
        app::Opened{test::withNewTrail(*document, {.startFrame = 21.0, .endFrame = 27.0, .scale = 3.0})});
    shell.commands = editorCommands();
    shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  }

  /// What one frame of the viewport does first.
  void show() {
    app::Session& session = *shell.open.character();
    const SceneCamera* const camera = cameraNamed(*session.document().scene, shell.viewport.look.name);
    shell.viewport.look.through =
        camera != nullptr ? throughCamera(session.document(), *camera, session.shownAt(session.view().frame))
                          : std::nullopt;
  }

  test::TemporaryFolder folder;
  Shell shell;
};

} // namespace

TEST_CASE("The file's cameras are looked through one after the other, and then the view moves freely again") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  for (const char* const name : {"Side", "Front", "Flat", ""}) {
    runCommand(shell, command::viewCamera);
    filmed.show();
    CHECK(shell.viewport.look.name == name);
    CHECK(shell.viewport.look.through.has_value() == (*name != '\0'));
  }
  CHECK(lensText(shell.viewport.look, shell.viewport.camera) == "orthographic"); // where Flat stood
  shell.viewport.look.name = "Side";
  filmed.show();
  CHECK(lensText(shell.viewport.look, shell.viewport.camera) == "Side, perspective, 39 mm");
  runCommand(shell, command::viewTop);
  CHECK(shell.viewport.look.name.empty());
}

TEST_CASE("The camera that is looked through is told by its name and its place among the file's") {
  Filmed filmed;
  const auto toldNext = [&] {
    runCommand(filmed.shell, command::viewCamera);
    filmed.show();
    return filmed.shell.ui.toasts.back().text;
  };
  CHECK(toldNext() == "Through the camera 'Side', 1 of 3");
  CHECK(toldNext() == "Through the camera 'Front', 2 of 3");
  CHECK(toldNext() == "Through the camera 'Flat', 3 of 3");
  CHECK(toldNext() == "The view moves freely again");
}

TEST_CASE("A view is kept with the camera that is looked through, and its key goes back to it") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  shell.viewport.camera.yawRadians = 0.3;
  runCommand(shell, command::keepView[3]);
  CHECK(shell.ui.toasts.back().text.find("Numpad 4") != std::string::npos);
  runCommand(shell, command::viewCamera);
  runCommand(shell, command::keepView[0]);
  shell.viewport.camera.yawRadians = 2.0;
  runCommand(shell, command::keptView[3]);
  CHECK(shell.viewport.camera.yawRadians == 0.3);
  CHECK(shell.viewport.look.name.empty());
  runCommand(shell, command::keptView[0]); // no longer the front view
  CHECK(shell.viewport.look.name == "Side");
}

TEST_CASE("A key of the numpad shows its standard view before a view is kept under it, others say how to "
          "keep one") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  for (const auto& [number, id] : {std::pair(1, command::viewFront), std::pair(3, command::viewSide),
                                   std::pair(5, command::viewPerspective), std::pair(7, command::viewTop)}) {
    runCommand(shell, command::keptView[static_cast<std::size_t>(number - 1)]);
    const Camera byKey = shell.viewport.camera;
    shell.viewport.camera = Camera{.target = byKey.target, .distance = byKey.distance};
    runCommand(shell, id);
    CHECK(shell.viewport.camera == byKey);
  }
  runCommand(shell, command::keptView[1]);
  CHECK(shell.ui.toasts.back().text == "No view is kept as 2: Ctrl+2 keeps this one");
}

TEST_CASE("The best view looks at the punch from a side, and is told in words") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  runCommand(shell, command::viewBest); // no trail is selected
  CHECK_FALSE(shell.viewport.frameSelectionPending);
  shell.open.character()->view().selection.editTrails().trail = 1;
  runCommand(shell, command::viewBest);
  CHECK(shell.viewport.frameSelectionPending);
  CHECK(std::abs(std::sin(shell.viewport.camera.yawRadians)) > 0.7);
  CHECK(shell.ui.toasts.back().text.starts_with("Seen best from "));
}

TEST_CASE("The best view and the numpad's standard views are shown while a file's camera is looked through") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  shell.open.character()->view().selection.editTrails().trail = 1;
  const std::string left = GENERATE(std::string(command::viewBest), std::string(command::keptView[6]));
  CAPTURE(left);
  runCommand(shell, command::viewCamera);
  filmed.show();
  REQUIRE(shell.viewport.look.name == "Side");
  runCommand(shell, left);
  filmed.show();
  CHECK(shell.viewport.look.name.empty());
  CHECK_FALSE(shell.viewport.look.through);
}

TEST_CASE(
    "A playblast holds the whole clip, or the range that was set by hand, and says so where it is saved") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  app::Session& session = *shell.open.character();
  const auto asked = [&] {
    runCommand(shell, command::fileFilm);
    return shell.ui.dialogs.file.remark;
  };
  const std::string whole =
      fmt::format("Draws frames 0 to {:g}", app::lastFrame(session.document(), session.view().clip));
  CHECK(asked() == whole);
  app::selectTrail(session, session.document().trails.front().id);
  REQUIRE(session.view().rangeEnd == 27.0); // the trail's, which nobody set
  CHECK(asked() == whole);
  shell.ui.overlays.sideBySide = true;
  CHECK(asked() == whole + ", beside the original");
  shell.ui.overlays.sideBySide = false;
  app::setRangeByHand(session, {4.0, 30.0});
  CHECK(asked() == "Draws frames 4 to 30");
  app::selectLimb(session, "right-arm", false);
  app::selectTrail(session, session.document().trails.front().id);
  REQUIRE(session.view().rangeEnd == 27.0);
  CHECK(asked() == "Draws frames 4 to 30");
}

TEST_CASE(
    "A view is kept, and one that is not kept is told, also where the key of the other command was taken") {
  Filmed filmed;
  Shell& shell = filmed.shell;
  REQUIRE(shell.keymap.rebind(command::keptView[1], std::nullopt));
  runCommand(shell, command::keepView[1]);
  CHECK(shell.ui.toasts.back().text == "View 2 is kept");
  REQUIRE(shell.keymap.rebind(command::keepView[3], std::nullopt));
  runCommand(shell, command::keptView[3]);
  CHECK(shell.ui.toasts.back().text == "No view is kept as 4");
}
