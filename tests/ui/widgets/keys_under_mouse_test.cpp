// What the mouse picks and moves in the rows of keys.
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <catch2/catch.hpp>
#include <imgui.h>

#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/timeline.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// Four rows with keys at frames 10, 30 and 50, frame by frame under a mouse that the test moves.
struct KeysUnderMouse {
  KeysUnderMouse() : gui(ImGui::CreateContext(&test::PanelDriver::fonts())) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {900.0F, 400.0F};
    io.DeltaTime = 1.0F / 60.0F;
    io.MousePos = {1.0F, 1.0F};
    applyStyle(test::PanelDriver::sharedTheme());
    model.clip = model.view = {0.0, 60.0};
    model.range = {0.0, 60.0};
    model.keysEditable = true;
    for (const char* const label : {"All keys", "Left arm", "Right arm", "Spine"}) {
      model.keyRows.push_back({label, {10.0, 30.0, 50.0}});
    }
    show();
    show();
  }
  ~KeysUnderMouse() { ImGui::DestroyContext(gui); }
  KeysUnderMouse(const KeysUnderMouse&) = delete;
  KeysUnderMouse& operator=(const KeysUnderMouse&) = delete;

  const TimelineOutcome& show() {
    ImGui::NewFrame();
    items.clear();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("sheet", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    outcome = timeline({test::PanelDriver::sharedTheme(), items}, "sheet", model, gesture, 100.0F, 300.0F);
    ImGui::End();
    ImGui::Render();
    return outcome;
  }
  [[nodiscard]] ImVec2 key(int row, int place) const {
    return items.find("sheet/row-" + std::to_string(row) + "/" + std::to_string(place))->centre();
  }
  /// A place in a row, of a frame.
  [[nodiscard]] ImVec2 at(int row, float frame) const {
    const float pixelsOfFrame = (key(0, 2).x - key(0, 0).x) / 40.0F;
    return {key(0, 0).x + (frame - 10.0F) * pixelsOfFrame, key(row, 0).y};
  }
  const TimelineOutcome& moveTo(const ImVec2& place) {
    ImGui::GetIO().MousePos = {std::floor(place.x), std::floor(place.y)};
    return show();
  }
  const TimelineOutcome& press(const ImVec2& place) {
    moveTo(place);
    ImGui::GetIO().MouseDown[0] = true;
    return show();
  }
  const TimelineOutcome& release() {
    ImGui::GetIO().MouseDown[0] = false;
    return show();
  }
  TimelineOutcome drag(const ImVec2& from, const ImVec2& to) {
    press(from);
    moveTo(to);
    return release();
  }

  ImGuiContext* gui;
  ItemRegistry items;
  TimelineModel model;
  TimelineGesture gesture;
  TimelineOutcome outcome;
};

constexpr double pixelMargin = 0.1; ///< Frames of a pixel.

} // namespace

TEST_CASE("A box around keys of the dope sheet holds its rows and frames from whichever corner it is drawn") {
  const bool fromRight = GENERATE(false, true);
  const bool fromBottom = GENERATE(false, true);
  CAPTURE(fromRight, fromBottom);
  KeysUnderMouse sheet;
  const ImVec2 from = sheet.at(fromBottom ? 2 : 1, fromRight ? 40.0F : 20.0F);
  const ImVec2 to = sheet.at(fromBottom ? 1 : 2, fromRight ? 20.0F : 40.0F);
  const TimelineOutcome drawn = sheet.drag(from, to);
  CHECK(drawn.gestureEnded);
  CHECK_FALSE(drawn.clickedBesideKeys);
  REQUIRE(drawn.keysPicked);
  CHECK(drawn.keysPicked->firstRow == 1);
  CHECK(drawn.keysPicked->lastRow == 2);
  CHECK(drawn.keysPicked->frames.start == Approx(20.0).margin(pixelMargin));
  CHECK(drawn.keysPicked->frames.end == Approx(40.0).margin(pixelMargin));
  CHECK_FALSE(drawn.keysPicked->add);
}

TEST_CASE("A box that goes on above the first row, or below the last, ends at it") {
  KeysUnderMouse sheet;
  const float row = sheet.key(1, 0).y - sheet.key(0, 0).y;
  const ImVec2 above{sheet.at(0, 40.0F).x, sheet.key(0, 0).y - row};
  const TimelineOutcome upwards = sheet.drag(sheet.at(2, 20.0F), above);
  REQUIRE(upwards.keysPicked);
  CHECK(upwards.keysPicked->firstRow == 0);
  CHECK(upwards.keysPicked->lastRow == 2);
  const ImVec2 below{sheet.at(0, 40.0F).x, sheet.key(3, 0).y + 2.0F * row};
  const TimelineOutcome downwards = sheet.drag(sheet.at(1, 20.0F), below);
  REQUIRE(downwards.keysPicked);
  CHECK(downwards.keysPicked->firstRow == 1);
  CHECK(downwards.keysPicked->lastRow == 3);
}

TEST_CASE(
    "A press beside keys that hardly moves picks nothing: it lets go of the picks, with Shift of none") {
  KeysUnderMouse sheet;
  const ImVec2 beside = sheet.at(1, 20.0F);
  const TimelineOutcome clicked = sheet.drag(beside, {beside.x + 2.0F, beside.y + 2.0F});
  CHECK(clicked.clickedBesideKeys);
  CHECK_FALSE(clicked.keysPicked);
  ImGui::GetIO().KeyShift = true;
  const TimelineOutcome adding = sheet.drag(beside, beside);
  CHECK_FALSE(adding.clickedBesideKeys);
  CHECK_FALSE(adding.keysPicked);
  const TimelineOutcome box = sheet.drag(beside, {beside.x + 4.0F, beside.y});
  REQUIRE(box.keysPicked);
  CHECK(box.keysPicked->add);
  ImGui::GetIO().KeyShift = false;
  const TimelineOutcome upright = sheet.drag(beside, {beside.x, beside.y + 4.0F});
  CHECK_FALSE(upright.clickedBesideKeys);
  CHECK(upright.keysPicked);
}

TEST_CASE("A press on a key picks it in its row, and leaves the picks where it is one of them") {
  KeysUnderMouse sheet;
  const TimelineOutcome pressed = sheet.press(sheet.key(2, 1));
  REQUIRE(pressed.keysPicked);
  CHECK(pressed.keysPicked->firstRow == 2);
  CHECK(pressed.keysPicked->lastRow == 2);
  CHECK(pressed.keysPicked->frames.start == 30.0);
  CHECK(pressed.keysPicked->frames.end == 30.0);
  CHECK_FALSE(pressed.keysPicked->add);
  sheet.release();
  ImGui::GetIO().KeyShift = true;
  const TimelineOutcome added = sheet.press(sheet.key(2, 1));
  REQUIRE(added.keysPicked);
  CHECK(added.keysPicked->add);
  sheet.release();
  ImGui::GetIO().KeyShift = false;
  sheet.model.keyRows[2].picked = {10.0, 30.0};
  CHECK_FALSE(sheet.press(sheet.key(2, 1)).keysPicked);
  const ImVec2 goal = sheet.at(2, 37.0F);
  CHECK(sheet.moveTo(goal).keyFrames == 7.0);
  CHECK_FALSE(sheet.release().clickedBesideKeys);
  CHECK(sheet.press(sheet.key(2, 2)).keysPicked); // Another one of the row.
}

TEST_CASE("The column of labels is as wide as the longest, within limits, of which a hold's are narrower") {
  const KeysUnderMouse sheet;
  const Theme& theme = test::PanelDriver::sharedTheme();
  TimelineModel model;
  CHECK(timelineLabelWidth(theme, model) == theme.px(112.0F));
  const std::string veryLong(80, 'm');
  model.bars = {{.id = -1, .label = veryLong}};
  CHECK(timelineLabelWidth(theme, model) == theme.px(150.0F));
  model.bars = {{.id = 1, .label = veryLong}};
  CHECK(timelineLabelWidth(theme, model) == theme.px(240.0F));
  model.bars.clear();
  model.keyRows = {{"short", {}}, {veryLong, {}}};
  CHECK(timelineLabelWidth(theme, model) == theme.px(240.0F));
  std::string middling;
  while (textSize(theme.fonts.label, middling).x < 120.0F) {
    middling += 'm';
  }
  model.keyRows = {{middling, {}}, {"short", {}}};
  const float text = textSize(theme.fonts.label, middling).x;
  CHECK(timelineLabelWidth(theme, model) == std::ceil(text) + theme.px(20.0F));
}
