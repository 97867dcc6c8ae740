// Points of a plot under the mouse.
#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>
#include <imgui.h>

#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/scatter_plot.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// A plot of x and y from 0 to 10, frame by frame under a mouse that the test moves.
struct PlotUnderMouse {
  PlotUnderMouse() : gui(ImGui::CreateContext(&test::PanelDriver::fonts())) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {500.0F, 400.0F};
    io.DeltaTime = 1.0F / 60.0F;
    io.MousePos = {1.0F, 1.0F};
    applyStyle(test::PanelDriver::sharedTheme());
    model.points = {{Vec2(0.0, 0.0)}, {Vec2(10.0, 10.0)}};
    show();
    show();
  }
  ~PlotUnderMouse() { ImGui::DestroyContext(gui); }
  PlotUnderMouse(const PlotUnderMouse&) = delete;
  PlotUnderMouse& operator=(const PlotUnderMouse&) = delete;

  std::optional<std::size_t> show() {
    ImGui::NewFrame();
    items.clear();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("plot", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    const std::optional<std::size_t> clicked =
        scatterPlot({test::PanelDriver::sharedTheme(), items}, "plot", model, 300.0F);
    ImGui::End();
    ImGui::Render();
    return clicked;
  }
  std::optional<std::size_t> click(float x, float y) {
    ImGui::GetIO().MousePos = {x, y};
    show();
    ImGui::GetIO().MouseDown[0] = true;
    CHECK_FALSE(show()); // It is the release that goes there.
    ImGui::GetIO().MouseDown[0] = false;
    return show();
  }

  ImGuiContext* gui;
  ItemRegistry items;
  ScatterPlotModel model;
};

} // namespace

TEST_CASE("A click on a plot takes the nearest point within eight pixels, in whichever order they stand") {
  const bool isReversed = GENERATE(false, true);
  PlotUnderMouse plot;
  const Item box = *plot.items.find("plot");
  // Beside the values, below the label, and above the values and the label of the other axis.
  const Axis x{plottedSpan(plot.model, 0).start, plottedSpan(plot.model, 0).end, box.min.x + 40.0F,
               box.max.x - 6.0F};
  const Axis y{plottedSpan(plot.model, 1).start, plottedSpan(plot.model, 1).end, box.max.y - 36.0F,
               box.min.y + 18.0F};
  const double apart = 12.0 * x.valuesPerPixel();
  const float atX = std::floor(x.toPixel(5.0));
  const float atY = std::floor(y.toPixel(5.0));
  const Vec2 middle(x.toValue(atX + 0.5F), y.toValue(atY + 0.5F));
  plot.model.points.push_back({middle});
  plot.model.points.push_back({Vec2(middle.x + apart, middle.y)});
  if (isReversed) {
    std::ranges::reverse(plot.model.points);
  }
  const std::size_t left = isReversed ? 1 : 2;
  const std::size_t right = isReversed ? 0 : 3;
  CHECK(plot.click(atX + 5.0F, atY) == left);
  CHECK(plot.click(atX + 7.0F, atY) == right);
  CHECK(plot.click(atX + 12.0F, atY + 6.0F) == right);
  CHECK_FALSE(plot.click(atX - 9.0F, atY));
  CHECK_FALSE(plot.click(atX, atY + 10.0F));
}
