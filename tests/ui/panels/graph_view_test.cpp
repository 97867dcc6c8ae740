// What of the graph follows the mouse and the picks.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/selection.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/widgets/curve_view.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The graph of the left arm in the panels.
struct ArmsGraph : test::PanelDriver {
  ArmsGraph() : PanelDriver(std::nullopt) {
    test::withArmsGraph({open, ui, status});
    frames(4);
    ImGui::GetIO().MousePos = centreOf("graph");
    frames(2);
  }
  /// What is seen: the first and the last frame, the least and the largest value.
  struct View {
    double start, end, low, high;
  };
  [[nodiscard]] View view() const {
    return {ui.time.timeline.viewStart, ui.time.timeline.viewEnd, ui.time.graph.valueMin,
            ui.time.graph.valueMax};
  }
  void turn(float steps, bool control) {
    ImGui::GetIO().KeyCtrl = control;
    ImGui::GetIO().MouseWheel = steps;
    frame();
    ImGui::GetIO().MouseWheel = 0.0F;
    ImGui::GetIO().KeyCtrl = false;
    frame();
  }
};

} // namespace

TEST_CASE("The wheel with Ctrl zooms the values of the graph about the mouse, at both of their ends") {
  ArmsGraph graph;
  const ArmsGraph::View before = graph.view();
  const float steps = GENERATE(1.0F, 3.0F, -2.0F);
  const double factor = std::pow(0.85, double(steps));
  graph.turn(steps, true);
  const ArmsGraph::View after = graph.view();
  CHECK(after.high - after.low == Approx(factor * (before.high - before.low)));
  CHECK(((after.low > before.low) == (steps > 0.0F) && (after.high < before.high) == (steps > 0.0F)));
  CHECK(after.start == before.start);
  CHECK(after.end == before.end);
}

TEST_CASE("The wheel alone zooms the frames of the graph, at both of their ends, and leaves its values") {
  ArmsGraph graph;
  graph.turn(2.0F, false);
  const ArmsGraph::View before = graph.view();
  graph.turn(2.0F, false);
  const ArmsGraph::View after = graph.view();
  CHECK(after.end - after.start == Approx(0.85 * 0.85 * (before.end - before.start)));
  CHECK(after.start > before.start);
  CHECK(after.end < before.end);
  CHECK(after.low == before.low);
  CHECK(after.high == before.high);
}

TEST_CASE("The middle button moves the graph as it is, in frames and values") {
  ArmsGraph graph;
  graph.turn(2.0F, false);
  const ArmsGraph::View before = graph.view();
  ImGui::GetIO().MouseDown[2] = true;
  graph.frame();
  graph.moveBy(-30.0F, 20.0F);
  graph.moveBy(-30.0F, 20.0F);
  ImGui::GetIO().MouseDown[2] = false;
  graph.frames(2);
  const ArmsGraph::View after = graph.view();
  CHECK(after.start > before.start);
  CHECK(after.low > before.low);
  CHECK(after.end - after.start == Approx(before.end - before.start));
  CHECK(after.high - after.low == Approx(before.high - before.low));
}

namespace {

constexpr ImU32 ownColour = IM_COL32(10, 200, 90, 255);

/// How many corners of a colour a graph of curves draws.
int cornersOf(ImU32 colour, const std::vector<Curve>& curves) {
  ImGuiContext* const gui = ImGui::CreateContext(&test::PanelDriver::fonts());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {900.0F, 500.0F};
  ImGui::NewFrame();
  ItemRegistry items;
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("graph", nullptr, ImGuiWindowFlags_NoDecoration);
  CurveViewModel model;
  model.curves = curves;
  model.frames = {0.0, 10000.0};
  model.values = {-1.0, 1.0};
  model.playhead = -1000.0;
  CurveGesture gesture;
  static_cast<void>(curveView({test::PanelDriver::sharedTheme(), items}, "graph", model, gesture, 400.0F));
  const ImVector<ImDrawVert>& corners = ImGui::GetWindowDrawList()->VtxBuffer;
  const auto count = std::ranges::count(corners, colour, &ImDrawVert::col);
  ImGui::End();
  ImGui::EndFrame();
  ImGui::DestroyContext(gui);
  return static_cast<int>(count);
}

/// A level curve of its own colour with many keys, of which the first so many are picked.
Curve levelCurve(int keys, int picked) {
  Curve curve{.label = "level", .colour = ownColour, .points = {{0.0, 0.5}, {10000.0, 0.5}}};
  for (int i = 0; i < keys; ++i) {
    curve.keys.push_back({Vec2(i, 0.5), Vec2(0.0), i, i < picked});
  }
  curve.picked = static_cast<std::size_t>(picked);
  return curve;
}

} // namespace

TEST_CASE("Of more picked keys than can be told apart their curves are marked, those of one pick as well") {
  const int picked = GENERATE(0, 1, 2, 50);
  CAPTURE(picked);
  const int own = cornersOf(ownColour, {levelCurve(100, picked), levelCurve(9000, 9000)});
  const int none = cornersOf(ownColour, {levelCurve(9000, 9000)});
  CHECK(none == 0); // Its line stands in the colour of picks.
  CHECK((own > 0) == (picked == 0));
}

TEST_CASE("Where picked keys can be told apart their curve keeps its colour") {
  const int picked = GENERATE(1, 100);
  CHECK(cornersOf(ownColour, {levelCurve(100, picked)}) > 0);
}

TEST_CASE("A box around the whole graph picks the keys of the curves that show, and no hidden ones") {
  ArmsGraph graph;
  graph.ui.time.graph.hidden = {true, true, false};
  graph.frames(2);
  const Item box = *graph.find("graph");
  ImGui::GetIO().MousePos = {box.min.x + 64.0F, box.min.y + 6.0F}; // In the plot, above all curves.
  graph.frame();
  graph.pressMouse();
  ImGui::GetIO().MousePos = {box.max.x - 4.0F, box.max.y - 24.0F};
  graph.frame();
  graph.releaseMouse();
  const app::KeySelection& picked = app::pickedKeys(*graph.open.character());
  REQUIRE(picked.size() == 1);
  CHECK(picked.front().keys.size() > 3);
  CHECK(std::ranges::all_of(picked.front().keys,
                            [](const app::PickedKey& key) { return key.components == 0b100U; }));
}
