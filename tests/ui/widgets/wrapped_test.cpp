#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/ui/panel_driver.h"
#include "ui/widgets/layout.h"

using namespace stretch;

namespace {

std::vector<std::string> linesOf(const std::string& text, float width) {
  std::vector<std::string> lines;
  for (const std::string_view line : ui::wrapped(ImGui::GetFont(), text, width)) {
    lines.emplace_back(line);
  }
  return lines;
}

} // namespace

TEST_CASE("Text is wrapped between words, and a number keeps its decimals and its percent sign together") {
  const test::PanelDriver driver(std::nullopt);
  const std::string text = "compressed to 24 bones, RMSE 0.273 % of the size";
  const float whole = ui::textSize(ImGui::GetFont(), text).x;
  for (float width = 0.3F * whole; width < 1.1F * whole; width += 1.0F) {
    std::string joined;
    for (const std::string& line : linesOf(text, width)) {
      joined += (joined.empty() ? "" : "|") + line;
    }
    INFO(joined);
    CHECK(joined.find("0.273 %") != std::string::npos);
    std::replace(joined.begin(), joined.end(), '|', ' ');
    CHECK(joined == text);
  }
}

TEST_CASE(
    "A word that is wider than the line is broken, and the last line that is asked for holds the rest") {
  const test::PanelDriver driver(std::nullopt);
  const std::string word = "a-very-long-name-without-a-blank.glb";
  CHECK(linesOf(word, 0.4F * ui::textSize(ImGui::GetFont(), word).x).size() > 2);
  const std::vector<std::string_view> two = ui::wrapped(ImGui::GetFont(), "one two three four", 40.0F, 2);
  REQUIRE(two.size() == 2);
  CHECK(std::string(two.back()).ends_with("three four"));
}
