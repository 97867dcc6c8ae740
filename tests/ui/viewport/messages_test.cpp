#include <catch2/catch.hpp>

#include <algorithm>
#include <optional>

#include <imgui_internal.h>

#include "app/commands/table/selection.h"
#include "rig/trail/trail.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/render/picking/picking.h"
#include "ui/viewport/shown/shown_controllers.h"
#include "ui/viewport/viewport_labels.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr float width = 460.0F;
constexpr float height = 340.0F;

/// How many messages there are, and how many of them lie over a place.
struct MessagesTold {
  int count = 0;
  int over = 0;
};

MessagesTold messagesOver(const ItemRegistry& items, const Rect& box) {
  MessagesTold told;
  for (const Item& item : items.items) {
    if (item.id.starts_with("toast/")) {
      ++told.count;
      told.over += box.overlaps({item.min, item.max}) ? 1 : 0;
    }
  }
  return told;
}

/// Places of the picture, beside one another, where the trails that show are covered by a message.
int coveredTrails(const ViewportState& viewport, const ItemRegistry& items) {
  int covered = 0;
  for (const ShownTrail& trail : viewport.shown.trails) {
    for (const Vec3& world : trail.drawn.exaggerated) {
      const std::optional<ImVec2> place = placeOf(viewport, world);
      covered += place && messagesOver(items, {*place, *place}).over > 0 ? 1 : 0;
    }
  }
  return covered;
}

Rect around(const ImVec2& place, float radius) {
  return {{place.x - radius, place.y - radius}, {place.x + radius, place.y + radius}};
}

void tellTwo(UiState& ui) {
  ui.toasts = {
      {ToastKind::success, "Applied: left arm, frames 21 to 29: 16 keys, 7 of them between frames", 60.0F},
      {ToastKind::warning, "The left arm gets no longer than 1.4 times at frame 25", 60.0F}};
}

/// The bundled character with a trail, in a view whose middle is a place of the world.
struct Seen : test::GuiStage {
  explicit Seen(test::GuiPainter& painter) : GuiStage(painter, ThemeKind::dark, width, height) {
    test::withTrail({open, ui, status, {}});
    viewport.framePending = true;
    showViewport();
  }

  /// Sees it from close, with a place of the world at a part of the picture's width and height.
  void lookAt(const Vec3& world, double across, double down) {
    viewport.camera.distance *= 0.9;
    showViewport();
    const double unit = unitsPerPixel(viewport.view, world);
    viewport.camera.target = world - viewRight(viewport.view) * unit * (across - 0.5) * double(width) +
                             viewUp(viewport.view) * unit * (down - 0.5) * double(height);
    ui.toasts.clear();
    showViewport();
    tellTwo(ui);
    showViewport();
  }
};

} // namespace

TEST_CASE("No message covers the selected trail's tip, wherever it stands in the picture") {
  test::GuiPainter painter;
  Seen stage(painter);
  const rig::Trail trail = *app::selectedTrail(*stage.open.character());
  const ShownTrail* const shown = findShown(stage.viewport.shown, trail.id);
  REQUIRE(shown != nullptr);
  const Vec3 tip = pointOnTrail(*shown, rig::tipFrameOf(trail.settings), shown->exaggerated);
  for (const double across : {0.2, 0.5, 0.8}) {
    for (const double down : {0.06, 0.15, 0.3, 0.5, 0.9}) {
      CAPTURE(across, down);
      stage.lookAt(tip, across, down);
      const std::optional<ImVec2> place = placeOf(stage.viewport, tip);
      REQUIRE(place);
      CHECK(place->x == Approx(across * double(width)).margin(20.0));
      const MessagesTold told = messagesOver(stage.items, around(*place, 8.0F));
      CHECK(told.count >= 1);
      CHECK(told.over == 0);
    }
  }
}

TEST_CASE("Messages spare a trail that nobody selected where the picture has room beside it") {
  test::GuiPainter painter;
  Seen stage(painter);
  const rig::Trail trail = *app::selectedTrail(*stage.open.character());
  const ShownTrail shown = *findShown(stage.viewport.shown, trail.id);
  const Vec3 tip = pointOnTrail(shown, rig::tipFrameOf(trail.settings), shown.exaggerated);
  stage.open.character()->view().selection.dropTrail();
  int nearAnEdge = 0;
  for (const double down : {0.06, 0.12, 0.88, 0.94}) {
    CAPTURE(down);
    stage.lookAt(tip, 0.5, down);
    const MessagesTold told = messagesOver(stage.items, {{0.0F, 0.0F}, {width, height}});
    CHECK(told.count >= 1);
    CHECK(coveredTrails(stage.viewport, stage.items) == 0);
    const float edge = down < 0.5 ? 0.0F : height;
    nearAnEdge += messagesOver(stage.items, {{0.0F, edge - 60.0F}, {width, edge + 60.0F}}).over > 0 ? 0 : 1;
  }
  CHECK(nearAnEdge == 4); // They stand at the other edge.
}

TEST_CASE("A click on a message takes it away and does nothing below it") {
  test::GuiPainter painter;
  Seen stage(painter);
  app::Session& session = *stage.open.character();
  app::selectLimb(session, "left-arm", false);
  tellTwo(stage.ui);
  stage.showViewport();
  const std::size_t before = stage.ui.toasts.size();
  REQUIRE(stage.items.find("toast/0") != nullptr);
  const ImVec2 place = stage.items.find("toast/0")->centre();
  const std::string told = stage.ui.toasts.front().text;
  stage.clickInViewport("toast/0");
  REQUIRE(stage.ui.toasts.size() == before - 1);
  CHECK(stage.ui.toasts.front().text != told);
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm"});

  // A running tool has every press.
  stage.tool = KeysTool{};
  stage.clickInViewport("toast/0");
  CHECK(stage.ui.toasts.size() == before - 1);
  stage.tool = std::monostate{};

  // The same place without a message is the picture's: a click beside everything drops the limb.
  stage.ui.toasts.clear();
  stage.showViewport();
  stage.items.add("below", place, place);
  stage.clickInViewport("below");
  CHECK(session.view().selection.limbs().empty());
}

TEST_CASE("No message covers the handles of a selected controller") {
  test::GuiPainter painter;
  Seen stage(painter);
  app::Session& session = *stage.open.character();
  app::selectControllers(session, {"left-hand"});
  stage.showViewport();
  const auto handles = controllerHandles(session, stage.viewport.controllers);
  REQUIRE(handles);
  for (const double down : {0.1, 0.5, 0.9}) {
    CAPTURE(down);
    stage.lookAt(handles->origin, 0.5, down);
    const std::optional<ImVec2> place = placeOf(stage.viewport, handles->origin);
    REQUIRE(place);
    const MessagesTold told = messagesOver(stage.items, around(*place, 60.0F));
    CHECK(told.count >= 1);
    CHECK(told.over == 0);
  }
}

TEST_CASE("What went wrong is told beside an open dialog where the window has room, news wait for its end") {
  test::GuiPainter painter;
  test::GuiStage stage(painter, ThemeKind::dark, 1280.0F, 720.0F);
  stage.open.open(test::PanelDriver::bundledCharacter());
  stage.ui.dialogs.settingsOpen = true;
  tellTwo(stage.ui);
  stage.showDialogs();
  const ImGuiWindow* const dialog = ImGui::GetTopMostPopupModal();
  REQUIRE(dialog != nullptr);
  const MessagesTold told = messagesOver(stage.items, {dialog->Rect().Min, dialog->Rect().Max});
  CHECK(told.count == 1);
  CHECK(told.over == 0);
}

TEST_CASE("No message covers what the picture's lines and colours mean, nor the label of the lens") {
  test::GuiPainter painter;
  Seen stage(painter);
  stage.ui.toasts.clear();
  stage.showViewport();
  tellTwo(stage.ui);
  stage.showViewport();
  const auto isSpared = [&](const char* id) {
    CAPTURE(id);
    const Item* const item = stage.items.find(id);
    REQUIRE(item != nullptr);
    CHECK(messagesOver(stage.items, {item->min, item->max}).over == 0);
  };
  isSpared("viewport/trail-legend");
  isSpared("viewport/lens");
  stage.ui.overlays.heatMap = true;
  stage.showViewport();
  isSpared("viewport/stretch-legend");
  stage.ui.overlays.weights = true;
  stage.showViewport();
  isSpared("viewport/weight-legend");
}

TEST_CASE("Messages leave each scale of colours, wherever they stood in the frame before") {
  test::GuiPainter painter;
  const bool isWeights = GENERATE(true, false);
  Seen stage(painter);
  test::withLimb({stage.open, stage.ui, stage.status, {}}); // Without a trail the scale is in the corner.
  stage.ui.overlays.weights = isWeights;
  stage.ui.overlays.heatMap = !isWeights;
  stage.ui.toasts.clear();
  stage.viewport.framePending = true;
  stage.showViewport();
  const char* const id = isWeights ? "viewport/weight-legend" : "viewport/stretch-legend";
  for (const std::size_t place : {0U, 1U}) { // High and low.
    for (const char* const text : {"Saved", "The left arm gets no longer than 1.4 times at frame 25"}) {
      CAPTURE(id, place, text);
      stage.ui.toasts = {{ToastKind::warning, text, 60.0F}};
      stage.viewport.messages.place = place;
      stage.showViewport();
      const Item* const legend = stage.items.find(id);
      REQUIRE(legend != nullptr);
      const MessagesTold told = messagesOver(stage.items, {legend->min, legend->max});
      CHECK(told.count == 1);
      CHECK(told.over == 0);
    }
  }
}
