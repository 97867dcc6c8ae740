#include <string>

#include <catch2/catch.hpp>
#include <imgui.h>

#include "core/math/types.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/slider.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// One field of a hundred pixels, frame by frame under a mouse that the test moves.
struct Field {
  Field() : gui(ImGui::CreateContext(&test::PanelDriver::fonts())) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800.0F, 400.0F};
    io.DeltaTime = 1.0F / 60.0F;
    io.MousePos = {700.0F, 300.0F};
    applyStyle(test::PanelDriver::sharedTheme());
    ImGui::SetClipboardText("");
    frames(2);
  }
  ~Field() { ImGui::DestroyContext(gui); }
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      ImGui::NewFrame();
      items.clear();
      ImGui::SetNextWindowPos({50.0F, 50.0F});
      ImGui::SetNextWindowSize({300.0F, 100.0F});
      ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration);
      const EditPhase phase = slider({test::PanelDriver::sharedTheme(), items}, spec, value);
      wasCut = wasCut || phase.cut;
      ended = ended || phase.ended;
      ImGui::End();
      ImGui::Render();
    }
  }
  void press(const std::string& item, int button) {
    const Item* const found = items.find(item);
    INFO(item);
    REQUIRE(found != nullptr);
    ImGui::GetIO().MousePos = found->centre();
    frames(2);
    ImGui::GetIO().MouseDown[button] = true;
    frames(1);
  }
  void release(int button) {
    ImGui::GetIO().MouseDown[button] = false;
    frames(3);
  }
  /// An entry of the menu that a right click opens.
  void choose(const std::string& entry) {
    press("field", ImGuiMouseButton_Right);
    release(ImGuiMouseButton_Right);
    press("field/" + entry, ImGuiMouseButton_Left);
    release(ImGuiMouseButton_Left);
  }
  [[nodiscard]] bool offers(const std::string& entry) {
    press("field", ImGuiMouseButton_Right);
    release(ImGuiMouseButton_Right);
    const Item* const found = items.find("field/" + entry);
    REQUIRE(found != nullptr);
    const bool isOn = found->enabled;
    ImGui::GetIO().MousePos = {700.0F, 300.0F};
    frames(1);
    ImGui::GetIO().MouseDown[0] = true;
    frames(1);
    release(ImGuiMouseButton_Left);
    return isOn;
  }
  void moveBy(float pixels) {
    ImGui::GetIO().MousePos.x += pixels;
    frames(1);
  }

  ImGuiContext* gui;
  ItemRegistry items;
  SliderSpec spec{.id = "field", .minimum = 0.0, .maximum = 2.0, .step = 0.01, .width = 100.0F};
  double value = 0.5;
  bool wasCut = false;
  bool ended = false;
};

} // namespace

TEST_CASE("A field's number is copied as it is shown, and pasted into another field as it is shown there") {
  const double factor = GENERATE(1.0, 100.0, 180.0 / pi);
  CAPTURE(factor);
  Field field;
  field.spec.displayFactor = factor;
  field.value = 0.375;
  field.choose("Copy");
  CHECK(std::stod(ImGui::GetClipboardText()) == Approx(0.375 * factor));
  CHECK(field.value == 0.375);
  field.value = 1.25;
  field.choose("Paste");
  CHECK(field.value == Approx(0.375));
  CHECK(field.ended);
  field.spec.displayFactor = 1.0;
  field.spec.hardMaximum = 1e6;
  field.choose("Paste");
  CHECK(field.value == Approx(0.375 * factor));
  CHECK_FALSE(field.wasCut);
}

TEST_CASE("A pasted number is cut at the hard limits, and nothing is pasted that is no number") {
  Field field;
  field.spec.hardMinimum = -3.0;
  field.spec.hardMaximum = 5.0;
  for (const auto& [text, wanted] : {std::pair("4.5", 4.5), {"-2,5", -2.5}, {"900", 5.0}, {"-900", -3.0}}) {
    CAPTURE(text);
    field.wasCut = false;
    ImGui::SetClipboardText(text);
    field.choose("Paste");
    CHECK(field.value == wanted);
    CHECK(field.wasCut == (wanted == 5.0 || wanted == -3.0));
  }
  ImGui::SetClipboardText("soon");
  CHECK_FALSE(field.offers("Paste"));
  CHECK(field.offers("Copy"));
}

TEST_CASE("Reset gives a field the value that it has by itself, and is off where it has none") {
  Field field;
  CHECK_FALSE(field.offers("Reset"));
  field.spec.defaultValue = 1.5;
  CHECK(field.offers("Reset"));
  field.choose("Reset");
  CHECK(field.value == 1.5);
  CHECK(field.ended);
}

TEST_CASE("A value that was dragged past an end of its range comes back as soon as the mouse turns") {
  Field field;
  const float towards = GENERATE(1.0F, -1.0F);
  const double end = towards > 0.0F ? 2.0 : 0.0;
  field.press("field", ImGuiMouseButton_Left);
  field.moveBy(20.0F * towards);
  CHECK(field.value == Approx(0.5 + 0.4 * towards).margin(0.011));
  field.moveBy(200.0F * towards);
  CHECK(field.value == end);
  field.moveBy(100.0F * towards);
  CHECK(field.value == end);
  field.moveBy(-10.0F * towards);
  CHECK(field.value == Approx(end - 0.2 * towards).margin(0.011));
  field.release(ImGuiMouseButton_Left);
  CHECK(field.ended);
}

TEST_CASE("With Shift a field goes a tenth of the way") {
  Field field;
  field.spec.step = 0.0;
  field.press("field", ImGuiMouseButton_Left);
  ImGui::GetIO().KeyShift = true;
  field.moveBy(20.0F);
  CHECK(field.value == Approx(0.5 + 0.04).margin(1e-4));
  ImGui::GetIO().KeyShift = false;
  field.moveBy(20.0F);
  CHECK(field.value == Approx(0.5 + 0.04 + 0.4).margin(1e-4));
}

TEST_CASE("A press that moves less than three pixels begins typing, one that moves farther was a drag") {
  const float moved = GENERATE(0.0F, 2.0F, 3.0F, 8.0F);
  CAPTURE(moved);
  Field field;
  field.press("field", ImGuiMouseButton_Left);
  field.moveBy(moved);
  field.release(ImGuiMouseButton_Left);
  CHECK(ImGui::GetIO().WantTextInput == (moved < 3.0F));
}

TEST_CASE("What is added to a field counts in what it shows, and goes on from what was there before") {
  Field field;
  field.spec.displayFactor = 100.0;
  field.press("field", ImGuiMouseButton_Left);
  field.release(ImGuiMouseButton_Left);
  for (const char* const typed : {"+=", "1", "0"}) { // 50 % and 10 more, digit by digit.
    ImGui::GetIO().AddInputCharactersUTF8(typed);
    field.frames(2);
  }
  CHECK(field.value == Approx(0.6));
}
