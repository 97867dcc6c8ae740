// What all panels share: messages, numbers as words, rows that are too short for their controls.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/scene/scene.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/context/row_parts.h"
#include "ui/panels/files/welcome_entries.h"

using namespace stretch;
using test::PanelDriver;
using ui::ToastKind;

namespace {

std::vector<std::string> textsOf(const ui::UiState& ui) {
  std::vector<std::string> texts;
  for (const ui::Toast& toast : ui.toasts) {
    texts.push_back(toast.text);
  }
  return texts;
}

/// A row of controls of thirty pixels each, which write down that they were drawn.
struct ShortRow {
  explicit ShortRow(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back({30.0F, [this, i] { drawn.push_back(i); }});
    }
  }
  ShortRow(const ShortRow&) = delete;
  ShortRow& operator=(const ShortRow&) = delete;

  /// The controls that are drawn in a row of a width.
  std::vector<std::size_t> drawnWithin(float width) {
    drawn.clear();
    ui::PanelContext context{driver.open,      driver.ui,    driver.theme, driver.commands,
                             driver.requested, driver.items, driver.status};
    ImGui::NewFrame();
    driver.items.clear();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({400.0F, 60.0F});
    ImGui::Begin("row", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    ui::rowOfParts(context, "row/more", width, parts);
    ImGui::End();
    ImGui::Render();
    return drawn;
  }
  [[nodiscard]] bool hasMore() const { return driver.find("row/more") != nullptr; }

  PanelDriver driver{std::nullopt};
  std::vector<ui::RowControl> parts;
  std::vector<std::size_t> drawn;
};

} // namespace

TEST_CASE("What is told already stays longer, and what went wrong stays longest") {
  ui::UiState ui;
  ui::tell(ui, ToastKind::info, "Saved");
  CHECK(ui.toasts.front().secondsLeft == 5.0F);
  ui.toasts.front().secondsLeft = 0.5F;
  ui::tell(ui, ToastKind::info, "Saved");
  REQUIRE(ui.toasts.size() == 1);
  CHECK(ui.toasts.front().secondsLeft == 5.0F);
  ui::tell(ui, ToastKind::warning, "Too long");
  ui::tell(ui, ToastKind::error, "Not saved");
  CHECK(ui.toasts[1].secondsLeft == 5.0F);
  CHECK(ui.toasts[2].secondsLeft == 8.0F);
}

TEST_CASE("Of more than three messages the oldest that only informs makes room, and no other one") {
  using Texts = std::vector<std::string>;
  ui::UiState ui;
  ui::tell(ui, ToastKind::warning, "Too long");
  ui::tell(ui, ToastKind::info, "Copied");
  ui::tell(ui, ToastKind::info, "Pasted");
  CHECK(textsOf(ui) == Texts{"Too long", "Copied", "Pasted"});
  ui::tell(ui, ToastKind::success, "Saved");
  CHECK(textsOf(ui) == Texts{"Too long", "Pasted", "Saved"});
  ui::tell(ui, ToastKind::error, "Not saved");
  CHECK(textsOf(ui) == Texts{"Too long", "Saved", "Not saved"});
  ui::tell(ui, ToastKind::info, "Undone"); // The one that has just been told stays.
  CHECK(textsOf(ui) == Texts{"Too long", "Saved", "Not saved", "Undone"});
  ui::hideNews(ui);
  CHECK(textsOf(ui) == Texts{"Too long", "Not saved"});
}

TEST_CASE("Numbers in words have no more decimals than they need, and whole ones keep their noughts") {
  CHECK(ui::shortNumber(24.0) == "24");
  CHECK(ui::shortNumber(12.5) == "12.5");
  CHECK(ui::shortNumber(1.0 / 3.0) == "0.33");
  CHECK(ui::shortNumber(100.0, 0) == "100");
  CHECK(ui::shortNumber(100.0) == "100");
  CHECK(ui::shortNumber(-0.001) == "0");
  CHECK(ui::shortNumber(-0.5, 1) == "-0.5");
}

TEST_CASE("A field shows decimals of a frame where it lies between frames, on either side of one") {
  CHECK(ui::frameDecimals(12.0) == 0);
  CHECK(ui::frameDecimals(12.004) == 0);
  CHECK(ui::frameDecimals(11.996) == 0);
  CHECK(ui::frameDecimals(12.006) == 2);
  CHECK(ui::frameDecimals(11.994) == 2);
}

TEST_CASE("Lengths at the tip are told with decimals that fit the size of the character, and as a share") {
  const std::string arrow = " \xE2\x86\x92 ";
  const std::string times = "  (\xC3\x97";
  CHECK(ui::lengthsText({10.0, 20.0}) == "10.0" + arrow + "20.0" + times + "2.00)");
  CHECK(ui::lengthsText({9.5, 19.0}) == "9.50" + arrow + "19.00" + times + "2.00)");
  CHECK(ui::lengthsText({0.1, 0.05}) == "0.10" + arrow + "0.05" + times + "0.50)");
  CHECK(ui::lengthsText({0.05, 0.1}) == "0.0500" + arrow + "0.1000" + times + "2.00)");
  CHECK(ui::lengthsText({0.0, 0.5}) == "0.0000" + arrow + "0.5000" + times + "1.00)");
}

TEST_CASE(
    "A joint is called by its name, by its number where it has none, and is a guess where there is none") {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].name = "Hips";
  CHECK(ui::nodeName(scene, NodeIndex(0)) == "Hips");
  CHECK(ui::nodeName(scene, NodeIndex(1)) == "#1");
  CHECK(ui::nodeName(scene, NodeIndex(2)) == "(estimated)");
  CHECK(ui::nodeName(scene, NodeIndex::none) == "(estimated)");
}

TEST_CASE(
    "A row shows all of its controls while they fit, else as many as fit beside the button for the rest") {
  using Places = std::vector<std::size_t>;
  ShortRow row(4); // The button takes 34 pixels.
  CHECK(row.drawnWithin(120.0F) == Places{0, 1, 2, 3});
  CHECK_FALSE(row.hasMore());
  CHECK(row.drawnWithin(119.0F) == Places{0, 1});
  CHECK(row.hasMore());
  CHECK(row.drawnWithin(94.0F) == Places{0, 1});
  CHECK(row.drawnWithin(93.0F) == Places{0});
  CHECK(row.drawnWithin(20.0F).empty());
  CHECK(row.hasMore());
}

TEST_CASE("The button of a short row opens what had no room, and nothing twice") {
  ShortRow row(4);
  row.drawnWithin(100.0F);
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = row.driver.find("row/more")->centre();
  row.drawnWithin(100.0F);
  io.MouseDown[0] = true;
  row.drawnWithin(100.0F);
  io.MouseDown[0] = false;
  row.drawnWithin(100.0F);
  CHECK(row.drawnWithin(100.0F) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(row.hasMore());
}

TEST_CASE(
    "The welcome offers the bundled clips, a file of one's own, and the five files that were opened last") {
  using Kind = ui::WelcomeEntry::Kind;
  ui::UiState ui;
  const std::size_t bundled = app::bundledClips().size();
  REQUIRE(ui::welcomeEntries(ui).size() == bundled + 1);
  for (const char* const name : {"a", "b", "c", "d", "e", "f", "g"}) {
    ui.recentFiles.emplace_back(name);
  }
  const std::vector<ui::WelcomeEntry> entries = ui::welcomeEntries(ui);
  REQUIRE(entries.size() == bundled + 6);
  CHECK(std::ranges::count(entries, Kind::bundled, &ui::WelcomeEntry::kind) ==
        static_cast<std::ptrdiff_t>(bundled));
  CHECK(entries[bundled].kind == Kind::dialog);
  CHECK(entries[bundled + 1].file == "a");
  CHECK(entries.back().kind == Kind::recent);
  CHECK(entries.back().file == "e");
}
