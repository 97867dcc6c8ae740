#include "tests/support/ui/drawn.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <imgui_internal.h>

#include "tests/support/recorded.h"

namespace stretch::test {

namespace {

/// A letter of a font.
struct KnownLetter {
  int font = 0; ///< Of the current context.
  float size = 0.0F;
  ImFontGlyph glyph;
};

/// A letter as it was drawn.
struct Letter {
  const KnownLetter* known = nullptr;
  float pen = 0.0F; ///< Where the line goes on that it belongs to: x,
  float top = 0.0F; ///< and the line's upper edge.
  ImU32 colour = 0;
};

/// Triangles that share corners.
struct Shape {
  ImU32 colour = 0; ///< Of the corner that is least transparent.
  double area = 0.0;
  ImVec2 middle;
  ImVec2 min{1e9F, 1e9F};
  ImVec2 max{-1e9F, -1e9F};
};

using Corners = std::pair<float, float>;

using LetterBook = std::map<Corners, KnownLetter>;

/// The letters of all fonts of the current context, by the upper left corner of their pictures. They are
/// listed once for each making of the fonts.
const LetterBook& lettersByPicture() {
  static LetterBook letters;
  static const void* madeFrom = nullptr;
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  if (madeFrom == fonts[0]->Glyphs.Data && !letters.empty()) {
    return letters;
  }
  madeFrom = fonts[0]->Glyphs.Data;
  letters.clear();
  for (int i = 0; i < fonts.Size; ++i) {
    for (const ImFontGlyph& glyph : fonts[i]->Glyphs) {
      if (glyph.Visible != 0) {
        letters[{glyph.U0, glyph.V0}] = {i, fonts[i]->FontSize, glyph};
      }
    }
  }
  return letters;
}

bool isOutside(const ImVec2& min, const ImVec2& max, const ImVec4& clip) {
  return max.x < clip.x || min.x > clip.z || max.y < clip.y || min.y > clip.w;
}

/// What the triangles of a list make, told apart by the corners that they share.
class Reader {
public:
  Reader(const ImDrawList& list, const LetterBook& book) : list_(list), book_(book) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
      read(command);
    }
  }

  std::vector<Letter> letters;
  std::vector<Shape> shapes;

private:
  const ImDrawVert& corner(const ImDrawCmd& command, unsigned at) const {
    return list_.VtxBuffer[static_cast<int>(command.VtxOffset + list_.IdxBuffer[static_cast<int>(at)])];
  }

  void read(const ImDrawCmd& command) {
    const unsigned end = command.IdxOffset + command.ElemCount;
    for (unsigned from = command.IdxOffset; from < end;) {
      unsigned to = from;
      unsigned highest = 0;
      do {
        for (unsigned i = 0; i < 3; ++i) {
          highest = std::max<unsigned>(highest, list_.IdxBuffer[static_cast<int>(to + i)]);
        }
        to += 3;
      } while (to < end && lowestOf(to) <= highest);
      take(command, from, to);
      from = to;
    }
  }

  unsigned lowestOf(unsigned at) const {
    const int first = static_cast<int>(at);
    return std::min({list_.IdxBuffer[first], list_.IdxBuffer[first + 1], list_.IdxBuffer[first + 2]});
  }

  void take(const ImDrawCmd& command, unsigned from, unsigned to) {
    const ImDrawVert& first = corner(command, from);
    const auto letter = to - from == 6 ? book_.find({first.uv.x, first.uv.y}) : book_.end();
    if (letter != book_.end()) {
      const ImFontGlyph& glyph = letter->second.glyph;
      const ImVec2 far = corner(command, from + 2).pos;
      if (!isOutside(first.pos, far, command.ClipRect)) {
        letters.push_back({&letter->second, first.pos.x - glyph.X0, first.pos.y - glyph.Y0, first.col});
      }
      return;
    }
    takeShape(command, from, to);
  }

  void takeShape(const ImDrawCmd& command, unsigned from, unsigned to) {
    Shape shape;
    ImVec2 sum;
    for (unsigned i = from; i < to; ++i) {
      const ImDrawVert& at = corner(command, i);
      shape.min = {std::min(shape.min.x, at.pos.x), std::min(shape.min.y, at.pos.y)};
      shape.max = {std::max(shape.max.x, at.pos.x), std::max(shape.max.y, at.pos.y)};
      sum = {sum.x + at.pos.x, sum.y + at.pos.y};
      const bool isDenser = (at.col >> IM_COL32_A_SHIFT) > (shape.colour >> IM_COL32_A_SHIFT);
      shape.colour = isDenser ? at.col : shape.colour;
    }
    for (unsigned i = from; i < to; i += 3) {
      const ImVec2 a = corner(command, i).pos;
      const ImVec2 b = corner(command, i + 1).pos;
      const ImVec2 c = corner(command, i + 2).pos;
      shape.area +=
          0.5 * std::abs(static_cast<double>((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)));
    }
    const auto count = static_cast<float>(to - from);
    shape.middle = {sum.x / count, sum.y / count};
    if (!isOutside(shape.min, shape.max, command.ClipRect) && shape.colour != 0) {
      shapes.push_back(shape);
    }
  }

  const ImDrawList& list_;
  const LetterBook& book_;
};

/// A pictogram is named by its number.
std::string utf8(ImWchar letter) {
  if (letter >= 0xE000 && letter < 0xF900) {
    return fmt::format("<{:x}>", static_cast<unsigned>(letter));
  }
  char bytes[5] = {};
  ImTextCharToUtf8(bytes, letter);
  return bytes;
}

std::string colourText(ImU32 colour) {
  return fmt::format("#{:02x}{:02x}{:02x}{:02x}", (colour >> IM_COL32_R_SHIFT) & 255U,
                     (colour >> IM_COL32_G_SHIFT) & 255U, (colour >> IM_COL32_B_SHIFT) & 255U,
                     (colour >> IM_COL32_A_SHIFT) & 255U);
}

std::vector<DrawnWords> wordsOf(const std::vector<Letter>& letters) {
  std::vector<DrawnWords> words;
  const Letter* before = nullptr;
  for (const Letter& letter : letters) {
    bool goesOn = false;
    if (before != nullptr) {
      const float gap = letter.pen - before->pen - before->known->glyph.AdvanceX;
      goesOn = letter.known->font == before->known->font && letter.colour == before->colour &&
               std::abs(letter.top - before->top) < 0.5F && gap > -1.5F && gap < 0.8F * letter.known->size;
      if (goesOn && gap > 1.5F) {
        words.back().text += " ";
      }
    }
    if (!goesOn) {
      words.push_back({{letter.pen, letter.top}, letter.known->size, letter.colour, ""});
    }
    words.back().text += utf8(static_cast<ImWchar>(letter.known->glyph.Codepoint));
    before = &letter;
  }
  return words;
}

std::string shapesText(const std::vector<Shape>& shapes) {
  struct Sum {
    int count = 0;
    double area = 0.0;
    double x = 0.0;
    double y = 0.0;
    ImVec2 min{1e9F, 1e9F};
    ImVec2 max{-1e9F, -1e9F};
  };
  std::map<std::string, Sum> sums;
  for (const Shape& shape : shapes) {
    Sum& sum = sums[colourText(shape.colour)];
    ++sum.count;
    sum.area += shape.area;
    sum.x += static_cast<double>(shape.middle.x);
    sum.y += static_cast<double>(shape.middle.y);
    sum.min = {std::min(sum.min.x, shape.min.x), std::min(sum.min.y, shape.min.y)};
    sum.max = {std::max(sum.max.x, shape.max.x), std::max(sum.max.y, shape.max.y)};
  }
  std::string text;
  for (const auto& [colour, sum] : sums) {
    text += fmt::format(
        "    {} of {} , area {:.1f} , from {:.1f} {:.1f} to {:.1f} {:.1f} , about {:.2f} {:.2f}\n", sum.count,
        colour, sum.area, sum.min.x, sum.min.y, sum.max.x, sum.max.y, sum.x / sum.count, sum.y / sum.count);
  }
  return text;
}

std::vector<const ImDrawList*> drawnLists() {
  const ImDrawData& drawn = *ImGui::GetDrawData();
  return {drawn.CmdLists, drawn.CmdLists + drawn.CmdListsCount};
}

} // namespace

std::vector<DrawnWords> wordsOf(const ImDrawList& list) {
  return wordsOf(Reader(list, lettersByPicture()).letters);
}

std::string drawnText() {
  const LetterBook& book = lettersByPicture();
  std::string text;
  for (const ImDrawList* list : drawnLists()) {
    const Reader read(*list, book);
    if (read.letters.empty() && read.shapes.empty()) {
      continue;
    }
    const std::string owner = list->_OwnerName != nullptr ? list->_OwnerName : "in front";
    text += "  " + owner.substr(0, owner.find_first_of("/_")) + "\n";
    for (const DrawnWords& words : wordsOf(read.letters)) {
      text += fmt::format("    {:.0f} {:.0f} {} {:.0f} : {}\n", words.at.x, words.at.y,
                          colourText(words.colour), words.size, words.text);
    }
    text += shapesText(read.shapes);
  }
  return text;
}

std::string tooltipWords() {
  std::string text;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    const bool isShown =
        window->WasActive && !window->Hidden && (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
    if (isShown) {
      for (const DrawnWords& words : wordsOf(*window->DrawList)) {
        text += (text.empty() ? "" : " | ") + words.text;
      }
    }
  }
  return text;
}

std::vector<std::string> shownWords() {
  const LetterBook& book = lettersByPicture();
  std::vector<std::string> shown;
  for (const ImDrawList* list : drawnLists()) {
    for (const DrawnWords& words : wordsOf(Reader(*list, book).letters)) {
      shown.push_back(words.text);
    }
  }
  return shown;
}

void compareWithRecord(const std::string& name, const std::string& text) {
  constexpr double tolerance = 2e-3;
  compareWithRecord(name, text, tolerance);
}

} // namespace stretch::test
