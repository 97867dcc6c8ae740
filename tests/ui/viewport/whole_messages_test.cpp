#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/context/panel_support.h"
#include "ui/widgets/layout.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr const char* problem =
    "holds a skinned mesh, which its joints move and not a hand; give a file with a thing that a hand can "
    "hold, as a sword, or import its clips instead";

} // namespace

TEST_CASE("A message names a file by its name, without the folders that it lies in") {
  UiState ui;
  tell(ui, ToastKind::error, "/somewhere/a folder/Knight 2.glb: " + std::string(problem));
  CHECK(ui.toasts.front().text == "Knight 2.glb: " + std::string(problem));
  for (const char* const plain : {"and/or is no path: it stays", "Saved knight.glb", "/"}) {
    ui.toasts.clear();
    tell(ui, ToastKind::info, plain);
    CHECK(ui.toasts.front().text == plain);
  }
}

TEST_CASE("A message of what went wrong is shown whole with its remedy, wherever the character stands") {
  test::GuiPainter painter;
  const float width = GENERATE(460.0F, 712.0F);
  const double across = GENERATE(0.3, 0.5, 0.72);
  test::GuiStage stage(painter, ThemeKind::dark, width, 480.0F);
  stage.open.open(test::PanelDriver::bundledCharacter());
  stage.viewport.framePending = true;
  stage.showViewport();
  const Vec3 right = viewRight(stage.viewport.view);
  stage.viewport.camera.target += right * (0.5 - across) * 2.0;
  stage.ui.toasts = {{ToastKind::error, "Knight 2.glb: " + std::string(problem), 60.0F}};
  stage.showViewport();
  const Item* const box = stage.items.find("toast/0");
  REQUIRE(box != nullptr);
  // Narrower than the box by its edges, the text takes more lines rather than fewer.
  const ImFont* const font = width < 500.0F ? stage.theme.fonts.label : stage.theme.fonts.body;
  const float room = box->max.x - box->min.x - stage.theme.px(width < 500.0F ? 20.0F : 28.0F);
  const float lines = std::floor((box->max.y - box->min.y) / font->FontSize);
  CHECK(static_cast<float>(wrapped(font, stage.ui.toasts.front().text, room).size()) <= lines);
  CHECK(box->min.x >= 0.0F);
  CHECK(box->max.x <= width);
  CHECK(box->max.x - box->min.x > stage.theme.px(160.0F));
}
