// What the mouse does with the keys of a graph: boxes, drags, handles and zooms.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <imgui.h>

#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/curve_view.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// A graph of frames 0 to 100 and values 0 to 10, frame by frame under a mouse that the test moves. Its first
/// curve has keys at frames 20, 50 and 80, of the values 2, 5 and 8.
struct CurvesUnderMouse {
  CurvesUnderMouse() : gui(ImGui::CreateContext(&test::PanelDriver::fonts())) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {900.0F, 500.0F};
    io.DeltaTime = 1.0F / 60.0F;
    io.MousePos = {1.0F, 1.0F};
    applyStyle(test::PanelDriver::sharedTheme());
    for (const double frame : {20.0, 50.0, 80.0}) {
      addKey(curves.front(), {frame, 0.1 * frame}, false);
    }
    model.frames = {0.0, 100.0};
    model.values = {0.0, 10.0};
    model.range = {0.0, 100.0};
    model.editable = true;
    show();
    show();
    const ImVec2 first = items.find("graph-key/even/0")->centre();
    const ImVec2 last = items.find("graph-key/even/2")->centre();
    pixelsOfFrame = (last.x - first.x) / 60.0F;
    pixelsOfValue = (first.y - last.y) / 6.0F;
    origin = {first.x - 20.0F * pixelsOfFrame, first.y + 2.0F * pixelsOfValue};
  }
  ~CurvesUnderMouse() { ImGui::DestroyContext(gui); }
  CurvesUnderMouse(const CurvesUnderMouse&) = delete;
  CurvesUnderMouse& operator=(const CurvesUnderMouse&) = delete;

  static void addKey(Curve& curve, const Vec2& at, bool isPicked) {
    curve.keys.push_back({at, Vec2(0.0), static_cast<int>(curve.keys.size()), isPicked});
    curve.points.push_back(at);
    curve.picked += isPicked ? 1 : 0;
  }
  [[nodiscard]] ImVec2 at(float frame, float value) const {
    return {origin.x + frame * pixelsOfFrame, origin.y - value * pixelsOfValue};
  }
  const CurveViewOutcome& show() {
    ImGui::NewFrame();
    items.clear();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("graph", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    model.curves = curves;
    outcome = curveView({test::PanelDriver::sharedTheme(), items}, "graph", model, gesture, 400.0F);
    ImGui::End();
    ImGui::Render();
    return outcome;
  }
  /// A mouse stands on whole pixels.
  const CurveViewOutcome& moveTo(const ImVec2& place) {
    ImGui::GetIO().MousePos = {std::floor(place.x), std::floor(place.y)};
    return show();
  }
  /// Frame and value where the mouse stands.
  [[nodiscard]] Vec2 underMouse() const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {double((mouse.x - origin.x) / pixelsOfFrame), double((origin.y - mouse.y) / pixelsOfValue)};
  }
  const CurveViewOutcome& press(const ImVec2& place) {
    moveTo(place);
    ImGui::GetIO().MouseDown[0] = true;
    return show();
  }
  const CurveViewOutcome& release() {
    ImGui::GetIO().MouseDown[0] = false;
    return show();
  }
  const CurveViewOutcome& turnWheel(float steps, bool control) {
    moveTo(at(30.0F, 5.0F));
    ImGui::GetIO().KeyCtrl = control;
    ImGui::GetIO().MouseWheel = steps;
    return show();
  }

  ImGuiContext* gui;
  ItemRegistry items;
  std::vector<Curve> curves{Curve{.label = "even", .colour = IM_COL32(200, 90, 10, 255)}};
  CurveViewModel model;
  CurveGesture gesture;
  CurveViewOutcome outcome;
  float pixelsOfFrame = 0.0F;
  float pixelsOfValue = 0.0F;
  ImVec2 origin;
};

// What a pixel is of frames and of values.
constexpr double frameMargin = 0.13;
constexpr double valueMargin = 0.03;

} // namespace

TEST_CASE("A box around keys holds the same frames and values from whichever corner it is drawn") {
  const bool fromRight = GENERATE(false, true);
  const bool fromTop = GENERATE(false, true);
  CAPTURE(fromRight, fromTop);
  CurvesUnderMouse graph;
  graph.press(graph.at(fromRight ? 60.0F : 25.0F, fromTop ? 7.0F : 3.0F));
  graph.moveTo(graph.at(fromRight ? 25.0F : 60.0F, fromTop ? 3.0F : 7.0F));
  const CurveViewOutcome& drawn = graph.release();
  REQUIRE(drawn.boxDrawn);
  CHECK(drawn.gestureEnded);
  CHECK_FALSE(drawn.clickedBeside);
  CHECK(drawn.boxFrames.start == Approx(25.0).margin(frameMargin));
  CHECK(drawn.boxFrames.end == Approx(60.0).margin(frameMargin));
  CHECK(drawn.boxValues.start == Approx(3.0).margin(valueMargin));
  CHECK(drawn.boxValues.end == Approx(7.0).margin(valueMargin));
}

TEST_CASE("With Shift a key of the graph is dragged in time alone or in value alone, as the mouse goes") {
  CurvesUnderMouse graph;
  CHECK(graph.press(graph.at(50.0F, 5.0F)).pickedKey);
  ImGui::GetIO().KeyShift = true;
  const ImVec2 key = graph.at(50.0F, 5.0F);
  const CurveViewOutcome& inTime = graph.moveTo({key.x + 5.0F * graph.pixelsOfFrame, key.y - 10.0F});
  REQUIRE(inTime.keysDragged);
  CHECK(inTime.drag.x == 5.0);
  CHECK(inTime.drag.y == 0.0);
  const CurveViewOutcome& inValue = graph.moveTo({key.x + 10.0F, key.y - 2.0F * graph.pixelsOfValue});
  CHECK(inValue.drag.x == 0.0);
  CHECK(inValue.drag.y == Approx(2.0).margin(2.0 * valueMargin));
  ImGui::GetIO().KeyShift = false;
  const CurveViewOutcome& both =
      graph.moveTo({key.x - 3.0F * graph.pixelsOfFrame, key.y + graph.pixelsOfValue});
  CHECK(both.drag.x == -3.0);
  CHECK(both.drag.y == Approx(-1.0).margin(2.0 * valueMargin));
}

TEST_CASE("A dragged key goes by whole frames while frames snap, and freely while they do not") {
  CurvesUnderMouse graph;
  graph.press(graph.at(50.0F, 5.0F));
  const ImVec2 place = graph.at(53.7F, 5.0F);
  CHECK(graph.moveTo(place).drag.x == 4.0);
  graph.model.snap = false;
  CHECK(graph.moveTo(place).drag.x == Approx(3.7).margin(frameMargin));
}

TEST_CASE("A handle turns its tangent and never stands upright, on whichever side of the key the mouse is") {
  const bool isAfter = GENERATE(false, true);
  CAPTURE(isAfter);
  CurvesUnderMouse graph;
  graph.curves.front().keys[1].picked = true;
  graph.curves.front().picked = 1;
  graph.show();
  const float side = isAfter ? 1.0F : -1.0F;
  const Item* const handle = graph.items.find(isAfter ? "graph-key/even/1/out" : "graph-key/even/1/in");
  REQUIRE(handle != nullptr);
  graph.press(handle->centre());
  const ImVec2 key = graph.at(50.0F, 5.0F);
  const CurveViewOutcome& turned =
      graph.moveTo({key.x + side * 5.0F * graph.pixelsOfFrame, key.y - 2.0F * graph.pixelsOfValue});
  REQUIRE(turned.tangent);
  CHECK(turned.tangent->key == 1);
  CHECK(turned.tangentAfter == isAfter);
  CHECK_FALSE(turned.tangentAlone);
  const Vec2 away = graph.underMouse() - Vec2(50.0, 5.0);
  CHECK(turned.slope == Approx(away.y / away.x).epsilon(1e-3));
  ImGui::GetIO().KeyAlt = true;
  // Beyond the key: two pixels on its own side are the least.
  const CurveViewOutcome& steepest =
      graph.moveTo({key.x - side * 5.0F * graph.pixelsOfFrame, key.y - 2.0F * graph.pixelsOfValue});
  CHECK(steepest.tangentAlone);
  const double least = 2.0 / double(graph.pixelsOfFrame);
  CHECK(steepest.slope == Approx((graph.underMouse().y - 5.0) / (least * double(side))).epsilon(1e-3));
}

TEST_CASE("Up to twenty-four picked keys can be bent by their handles, and with one more there are none") {
  const int count = GENERATE(24, 25);
  CAPTURE(count);
  CurvesUnderMouse graph;
  Curve& curve = graph.curves.front();
  curve = Curve{.label = "even", .colour = IM_COL32(200, 90, 10, 255)};
  for (int i = 0; i < count; ++i) {
    CurvesUnderMouse::addKey(curve, {10.0 + 3.5 * i, 5.0}, true);
  }
  graph.show();
  graph.press(graph.items.find("graph-key/even/0/in")->centre());
  CHECK((graph.gesture.part == CurveGesture::Part::tangent) == (count == 24));
  CHECK((graph.gesture.part == CurveGesture::Part::box) == (count == 25));
}

TEST_CASE("Of keys beside one another the nearer is taken, a picked one from a pixel farther, a hidden one "
          "never") {
  CurvesUnderMouse graph;
  const ImVec2 key = graph.at(50.0F, 5.0F);
  const float between = std::floor(key.x) + 5.0F; // Half a pixel nearer to the second one.
  const float apart = 2.0F * (between - key.x) - 0.5F;
  graph.curves.push_back(Curve{.label = "odd", .colour = IM_COL32(10, 90, 200, 255)});
  CurvesUnderMouse::addKey(graph.curves.back(), {50.0 + double(apart / graph.pixelsOfFrame), 5.0}, false);
  const auto takenAt = [&](float x) {
    const CurveViewOutcome pressed = graph.press({x, key.y});
    graph.release();
    REQUIRE(pressed.pickedKey);
    return pressed.pickedKey->curve;
  };
  CHECK(takenAt(between - 1.0F) == 0);
  CHECK(takenAt(between) == 1);
  graph.curves.front().hidden = true;
  CHECK(takenAt(between - 1.0F) == 1);
  graph.curves.front().hidden = false;
  graph.curves.front().keys[1].picked = true;
  graph.curves.front().picked = 1;
  graph.show();
  // The one that is picked is held by the press, and not picked anew.
  CHECK_FALSE(graph.press({between, key.y}).pickedKey);
  CHECK(graph.gesture.part == CurveGesture::Part::keys);
}

TEST_CASE("A click with Ctrl beside the keys asks for one there, and is neither a box nor a click beside") {
  CurvesUnderMouse graph;
  ImGui::GetIO().KeyCtrl = true;
  const CurveViewOutcome pressed = graph.press(graph.at(33.0F, 8.0F));
  REQUIRE(pressed.insertAt);
  CHECK(*pressed.insertAt == Approx(33.0).margin(frameMargin));
  const CurveViewOutcome& released = graph.release();
  CHECK_FALSE(released.boxDrawn);
  CHECK_FALSE(released.clickedBeside);
  ImGui::GetIO().KeyCtrl = false;
  CHECK_FALSE(graph.press(graph.at(33.0F, 8.0F)).insertAt);
  CHECK(graph.release().clickedBeside);
}

TEST_CASE("The wheel shows four frames of a graph at least, and a millionth of its values") {
  CurvesUnderMouse graph;
  const auto width = [](const Span& span) { return span.end - span.start; };
  CHECK(width(graph.turnWheel(100.0F, false).frames) == Approx(4.0));
  CHECK(width(graph.turnWheel(-100.0F, false).frames) == Approx(1e6));
  CHECK(width(graph.turnWheel(200.0F, true).values) == Approx(1e-6).epsilon(1e-3));
  CHECK(width(graph.turnWheel(-100.0F, true).values) == Approx(1e7));
}
