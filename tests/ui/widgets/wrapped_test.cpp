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

TEST_CASE(
    "A name that is cut in its middle keeps both of its ends, as much of them as fits, in whole letters") {
  const test::PanelDriver driver(std::nullopt);
  ImFont* const font = ImGui::GetFont();
  const std::string dots = "\xE2\x80\xA6";
  std::string name;
  for (int i = 0; i < 12; ++i) {
    name += "\xC3\xA4\xC3\xB6"; // Two letters of two bytes each.
  }
  const float whole = ui::textSize(font, name).x;
  CHECK(ui::cutInMiddle(font, name, whole + 0.5F) == name);
  std::size_t longest = 0;
  for (float width = 0.2F * whole; width < whole - 1.0F; width += 3.0F) {
    const std::string cut = ui::cutInMiddle(font, name, width);
    CAPTURE(width, cut);
    const std::size_t at = cut.find(dots);
    REQUIRE(at != std::string::npos);
    const std::string head = cut.substr(0, at);
    const std::string tail = cut.substr(at + dots.size());
    CHECK(ui::textSize(font, cut).x <= width);
    CHECK((name.starts_with(head) && name.ends_with(tail)));
    CHECK((head.size() % 2 == 0 && tail.size() % 2 == 0));
    CHECK((head.size() <= tail.size() + 3 && tail.size() <= head.size() + 3));
    CHECK(head.size() + tail.size() >= longest); // More room shows no less.
    longest = head.size() + tail.size();
  }
  CHECK(longest >= name.size() - 12);
}
