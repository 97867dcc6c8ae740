// The edges between panes under the mouse.
#include <string>

#include <catch2/catch.hpp>

#include "tests/support/ui/editor_stage.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

struct Panes : test::EditorStage {
  Panes() { openBoxer(); }
  void take(const std::string& edge) {
    const Item* const found = shell.items.find("splitter/" + edge);
    INFO(edge);
    REQUIRE(found != nullptr);
    ImGui::GetIO().MousePos = found->centre();
    frames(40); // So that the next press is no double click.
    press(true);
  }
  void press(bool down) {
    ImGui::GetIO().MouseDown[0] = down;
    frame();
  }
  [[nodiscard]] bool isOpen(const std::string& pane) const {
    const PaneSizes& sizes = shell.panes;
    return pane == "left" ? sizes.leftOpen : pane == "right" ? sizes.rightOpen : sizes.bottomOpen;
  }
  [[nodiscard]] double size(const std::string& pane) const {
    const PaneSizes& sizes = shell.panes;
    return pane == "left" ? sizes.left : pane == "right" ? sizes.right : sizes.bottom;
  }
};

const std::vector<std::string> panes{"left", "right", "bottom"};

} // namespace

TEST_CASE("A double click on a pane's edge folds that pane away, and no other") {
  const std::string folded = GENERATE("left", "right", "bottom");
  Panes stage;
  stage.take(folded);
  stage.press(false);
  for (const std::string& pane : panes) {
    CHECK(stage.isOpen(pane)); // One click folds nothing.
  }
  stage.press(true);
  stage.press(false);
  for (const std::string& pane : panes) {
    CAPTURE(folded, pane);
    CHECK(stage.isOpen(pane) == (pane != folded));
  }
  stage.frames(2);
  CHECK(stage.shell.items.find("splitter/" + folded) == nullptr);
}

TEST_CASE("A pane's edge goes with the mouse: its pane grows towards the picture, and no other one changes") {
  const std::string dragged = GENERATE("left", "right", "bottom");
  Panes stage;
  const std::vector<double> before{stage.size("left"), stage.size("right"), stage.size("bottom")};
  const float inwards = GENERATE(30.0F, -20.0F);
  stage.take(dragged);
  ImVec2& mouse = ImGui::GetIO().MousePos;
  mouse.x += dragged == "left" ? inwards : dragged == "right" ? -inwards : 0.0F;
  mouse.y -= dragged == "bottom" ? inwards : 0.0F;
  stage.frame();
  stage.press(false);
  for (std::size_t i = 0; i < panes.size(); ++i) {
    CAPTURE(dragged, panes[i]);
    CHECK(stage.size(panes[i]) == Approx(before[i] + (panes[i] == dragged ? double(inwards) : 0.0)));
    CHECK(stage.isOpen(panes[i]));
  }
}
