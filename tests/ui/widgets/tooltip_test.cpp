#include <optional>

#include <catch2/catch.hpp>
#include <imgui_internal.h>

#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/control.h"

using namespace stretch;
using namespace stretch::ui;
using test::PanelDriver;

namespace {

const ImVec2 window{1280.0F, 800.0F};
const ImVec2 size{200.0F, 60.0F};

Rect placed(const Rect& widget, const Rect& panel) {
  const ImVec2 corner = tooltipCorner(widget, panel, size, window, 6.0F);
  return {corner, {corner.x + size.x, corner.y + size.y}};
}

bool inWindow(const Rect& box, const ImVec2& screen) {
  return box.min.x >= 0.0F && box.min.y >= 0.0F && box.max.x <= screen.x && box.max.y <= screen.y;
}

/// The driver's panes.
enum class Pane { left, right, bottom, bar };
Pane paneOf(const Item& item) {
  if (item.min.y >= 2240.0F) {
    return Pane::bottom;
  }
  return item.max.x <= 264.0F ? Pane::left : item.min.x >= 976.0F ? Pane::right : Pane::bar;
}

/// The tooltip that the last frame showed.
std::optional<Rect> shownTooltip() {
  for (const ImGuiWindow* shown : ImGui::GetCurrentContext()->Windows) {
    if (shown->WasActive && !shown->Hidden && (shown->Flags & ImGuiWindowFlags_Tooltip) != 0) {
      return Rect{shown->Rect().Min, shown->Rect().Max};
    }
  }
  return std::nullopt;
}

} // namespace

TEST_CASE("A tooltip stands beside an upright panel, level with its widget") {
  const Rect left{{0.0F, 30.0F}, {264.0F, 600.0F}};
  const Rect right{{976.0F, 30.0F}, {1280.0F, 600.0F}};
  const Rect fromLeft = placed({{8.0F, 100.0F}, {250.0F, 126.0F}}, left);
  CHECK(fromLeft.min.x >= left.max.x);
  CHECK(fromLeft.min.y == 100.0F);
  const Rect fromRight = placed({{984.0F, 100.0F}, {1270.0F, 126.0F}}, right);
  CHECK(fromRight.max.x <= right.min.x);
}

TEST_CASE("A tooltip stands above a widget of a flat panel, and below only under the window's top") {
  const Rect bottom{{0.0F, 600.0F}, {1280.0F, 780.0F}};
  const Rect row{{8.0F, 700.0F}, {40.0F, 726.0F}};
  CHECK(placed(row, bottom).max.y <= row.min.y);
  const Rect bar{{264.0F, 26.0F}, {976.0F, 60.0F}};
  const Rect button{{300.0F, 30.0F}, {330.0F, 56.0F}};
  CHECK(placed(button, bar).min.y >= button.max.y);
}

TEST_CASE("A tooltip never leaves the window") {
  const Rect left{{0.0F, 30.0F}, {264.0F, 800.0F}};
  CHECK(inWindow(placed({{8.0F, 780.0F}, {250.0F, 799.0F}}, left), window));
  const Rect bottom{{0.0F, 600.0F}, {1280.0F, 780.0F}};
  CHECK(inWindow(placed({{1250.0F, 700.0F}, {1276.0F, 726.0F}}, bottom), window));
}

TEST_CASE("Tooltips of the panels keep off their widget and off what stands below it") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.click("limb/left-arm");
  const std::vector<Item> items = driver.items.items;
  int seen = 0;
  for (const Item& item : items) {
    if (!item.explained || item.max.x <= item.min.x) {
      continue;
    }
    driver.moveTo(item.id);
    driver.frames(34);
    const std::optional<Rect> tip = shownTooltip();
    if (!tip) {
      continue; // another widget lies over it
    }
    ++seen;
    INFO(item.id);
    CHECK_FALSE(tip->overlaps({item.min, item.max}));
    CHECK(inWindow(*tip, ImGui::GetIO().DisplaySize));
    for (const Item& other : items) {
      const bool below = other.min.y >= item.max.y && paneOf(other) == paneOf(item);
      if (below && paneOf(item) != Pane::bar) {
        INFO(other.id);
        CHECK_FALSE(tip->overlaps({other.min, other.max}));
      }
    }
  }
  CHECK(seen > 30);
}
