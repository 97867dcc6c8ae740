// The pose at a trail's tip, which stands in the picture as a ghost while the trail is changed.
#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The bundled character with a trail over frames 18 to 30, which is selected; each frame of the window takes
/// 0.4 seconds, and four of them are drawn at a time.
struct ChangedTrail : test::GuiStage {
  explicit ChangedTrail(test::GuiPainter& painter, bool connected = true)
      : GuiStage(painter, ThemeKind::dark, 160.0F, 120.0F) {
    open.open(test::withNewTrail(test::PanelDriver::bundledCharacter(),
                                 {.startFrame = 18.0, .endFrame = 30.0, .connected = connected}));
    app::selectTrail(session(), session().document().trails.front().id);
    session().view().frame = 5.0;
    ImGui::GetIO().DeltaTime = 0.4F;
    showViewport();
  }
  [[nodiscard]] app::Session& session() { return *open.character(); }
  [[nodiscard]] app::Document scaled(double scale) {
    app::Document document = session().document();
    document.trails.front().settings.scale = scale;
    return document;
  }
  void scaleTo(double scale) {
    session().edit(scaled(scale), "Change the scale");
    showViewport();
  }
};

} // namespace

TEST_CASE("The pose at the tip is shown while a trail is changed, and for two and a half seconds after") {
  test::GuiPainter painter;
  ChangedTrail stage(painter);
  CHECK_FALSE(stage.viewport.tipFrame); // Nothing was changed yet.
  stage.scaleTo(1.6);
  CHECK(stage.viewport.tipFrame == 30.0);
  stage.showViewport();
  CHECK_FALSE(stage.viewport.tipFrame);
  stage.session().begin("Drag");
  stage.session().preview(stage.scaled(1.8));
  for (int i = 0; i < 3; ++i) {
    stage.showViewport();
  }
  CHECK(stage.viewport.tipFrame == 30.0); // However long it is held.
  stage.session().commit();
  for (int i = 0; i < 2; ++i) {
    stage.showViewport();
  }
  CHECK_FALSE(stage.viewport.tipFrame);
}

TEST_CASE("No pose at the tip is shown where the playhead is there, nor when the trail is let go of") {
  test::GuiPainter painter;
  ChangedTrail stage(painter);
  stage.session().view().frame = 29.6;
  stage.scaleTo(1.6);
  CHECK_FALSE(stage.viewport.tipFrame);
  stage.session().view().frame = 29.0;
  stage.scaleTo(1.7);
  CHECK(stage.viewport.tipFrame == 30.0);
  stage.session().view().selection.dropTrail();
  stage.showViewport();
  CHECK_FALSE(stage.viewport.tipFrame);
}

TEST_CASE("No pose at the tip is shown of a limb that does not follow its trail") {
  test::GuiPainter painter;
  ChangedTrail stage(painter, false);
  stage.scaleTo(1.6);
  CHECK_FALSE(stage.viewport.tipFrame);
}
