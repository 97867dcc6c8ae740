// The card of the tour in pictures of any size.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;

namespace {

/// The second of five steps over a picture, alone in the window.
struct TourOver {
  TourOver(float width, float height) : driver(std::nullopt) {
    driver.status.tour = ui::TourCard{1, 5, "Pick a limb", "Click the arm that strikes.", "1"};
    ui::PanelContext context{driver.open,      driver.ui,    driver.theme, driver.commands,
                             driver.requested, driver.items, driver.status};
    for (int i = 0; i < 3; ++i) {
      ImGui::NewFrame();
      driver.items.clear();
      ui::drawTour(context, {{0.0F, 0.0F}, {width, height}});
      ImGui::Render();
    }
  }
  [[nodiscard]] bool has(const char* widget) const { return driver.find(widget) != nullptr; }
  [[nodiscard]] static bool shows(const std::string& line) {
    const std::vector<std::string> words = test::shownWords();
    return std::ranges::find(words, line) != words.end();
  }

  test::PanelDriver driver;
};

} // namespace

TEST_CASE("The card of the tour counts its steps from one, and tells what to do and by which key") {
  const TourOver tour(800.0F, 600.0F);
  REQUIRE(tour.has("tour"));
  CHECK_FALSE(tour.has("tour/step"));
  CHECK(TourOver::shows("2 of 5"));
  CHECK(TourOver::shows("Pick a limb"));
  CHECK(TourOver::shows("Click the arm that strikes."));
  CHECK(TourOver::shows("1"));
}

TEST_CASE("In a low picture the tour is one row, and in a narrow one it leaves the picture alone") {
  {
    const TourOver low(800.0F, 299.0F);
    CHECK(low.has("tour/step"));
    CHECK(TourOver::shows("2 of 5"));
    CHECK_FALSE(TourOver::shows("Click the arm that strikes."));
  }
  {
    const TourOver highEnough(800.0F, 300.0F);
    CHECK(highEnough.has("tour"));
    CHECK_FALSE(highEnough.has("tour/step"));
  }
  {
    const TourOver wideEnough(164.0F, 600.0F); // Twelve pixels beside the card at either side.
    CHECK(wideEnough.has("tour"));
  }
  {
    const TourOver narrow(163.0F, 600.0F);
    CHECK_FALSE(narrow.has("tour"));
  }
}
