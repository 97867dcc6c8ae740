// Which of the commands that answer a word comes first.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/fuzzy.h"

using namespace stretch;

namespace {

/// The palette over a character whose left arm is selected.
struct OpenPalette : test::PanelDriver {
  OpenPalette() : PanelDriver(PanelDriver::bundledCharacter()) {
    app::selectLimb(*open.character(), "left-arm", false);
    palette().open = true;
    frames(3);
  }
  [[nodiscard]] ui::PaletteState& palette() { return ui.dialogs.palette; }
  void search(const std::string& text) {
    type(text);
    frames(2);
  }
  /// The label of the first command of the list.
  [[nodiscard]] std::string firstLabel() const {
    const ui::Item* first = nullptr;
    const ui::CommandInfo* command = nullptr;
    for (const ui::Item& item : items.items) {
      const auto found = std::ranges::find_if(
          commands, [&](const ui::CommandInfo& info) { return item.id == "palette/" + info.id; });
      if (found != commands.end() && (first == nullptr || item.min.y < first->min.y)) {
        first = &item;
        command = &*found;
      }
    }
    REQUIRE(command != nullptr);
    return command->label;
  }
};

} // namespace

TEST_CASE("A command that is called by what was typed comes before those whose help speaks of it") {
  OpenPalette driver;
  driver.search("trail");
  CHECK(ui::holdsWords("trail", driver.firstLabel()));
}

TEST_CASE("With every letter the first command that is found is the one that Enter runs") {
  OpenPalette driver;
  driver.search("select");
  driver.pressKey(ImGuiKey_DownArrow);
  driver.pressKey(ImGuiKey_DownArrow);
  REQUIRE(driver.palette().highlighted == 2);
  driver.search(" right");
  CHECK(driver.palette().highlighted == 0);
}
