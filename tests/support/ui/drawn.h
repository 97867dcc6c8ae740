#pragma once

#include <string>
#include <vector>

#include <imgui.h>

namespace stretch::test {

/// Words that stand in one line in one colour.
struct DrawnWords {
  ImVec2 at; ///< Window pixels, top left.
  float size = 0.0F;
  ImU32 colour = 0;
  std::string text;
};

/// The words that a list draws, in the order in which it draws them, read from its letters. Those that lie
/// outside of what may be drawn on are left out.
[[nodiscard]] std::vector<DrawnWords> wordsOf(const ImDrawList& list);

/// What the last frame of the current context draws, window by window: its words with place, size and colour,
/// and of what is no letter how many shapes there are of each colour, what their areas add up to, and in
/// which box and about which middle they stand.
[[nodiscard]] std::string drawnText();

/// The words of the tooltip that the last frame of the current context shows; empty without one.
[[nodiscard]] std::string tooltipWords();

/// Every word that the last frame shows, a line each, without places.
[[nodiscard]] std::vector<std::string> shownWords();

/// Fails unless a text is that of tests/recorded/NAME.txt (recorded.h), but for what roundings make of it.
void compareWithRecord(const std::string& name, const std::string& text);

} // namespace stretch::test
