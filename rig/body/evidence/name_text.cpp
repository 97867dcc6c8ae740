#include "rig/body/evidence/name_text.h"

#include <cstdint>

namespace stretch::rig::body {

namespace {

enum class Script { separator, lower, upper, ideograph };

// One code point from the front of `text`; 0 for a byte that starts no valid sequence.
char32_t takeCodePoint(std::string_view& text) {
  const auto lead = static_cast<std::uint8_t>(text.front());
  text.remove_prefix(1);
  if (lead < 0x80) {
    return lead;
  }
  const std::size_t followers = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
  if (followers == 0 || followers > text.size()) {
    return 0;
  }
  char32_t point = lead & (0x3FU >> followers);
  for (std::size_t i = 0; i < followers; ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    if ((byte & 0xC0U) != 0x80U) {
      return 0;
    }
    point = (point << 6U) | (byte & 0x3FU);
  }
  text.remove_prefix(followers);
  return point;
}

void appendUtf8(std::string& out, char32_t point) {
  if (point < 0x80) {
    out += static_cast<char>(point);
  } else if (point < 0x800) {
    out += static_cast<char>(0xC0U | (point >> 6U));
    out += static_cast<char>(0x80U | (point & 0x3FU));
  } else {
    out += static_cast<char>(0xE0U | (point >> 12U));
    out += static_cast<char>(0x80U | ((point >> 6U) & 0x3FU));
    out += static_cast<char>(0x80U | (point & 0x3FU));
  }
}

// Base letter of the accented Latin letters from U+00C0 to U+017F, '.' where there is none.
constexpr std::string_view latinBase =
    "aaaaaaaceeeeiiiidnooooo.ouuuuytsaaaaaaaceeeeiiiidnooooo.ouuuuyty" // U+00C0
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll" // U+0100
    "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

char32_t fullWidthToAscii(char32_t point) {
  return point >= 0xFF01 && point <= 0xFF5E ? point - 0xFEE0 : point;
}

bool isIdeograph(char32_t point) {
  return (point >= 0x3040 && point <= 0x30FF) || (point >= 0x3400 && point <= 0x9FFF) ||
         (point >= 0xAC00 && point <= 0xD7A3);
}

Script scriptOf(char32_t point) {
  if (point >= 'a' && point <= 'z') {
    return Script::lower;
  }
  if (point >= 'A' && point <= 'Z') {
    return Script::upper;
  }
  if (point >= 0xC0 && point <= 0x17F) {
    return point <= 0xDE ? Script::upper : Script::lower;
  }
  if (point >= 0x400 && point <= 0x42F) {
    return Script::upper;
  }
  if (point >= 0x430 && point <= 0x45F) {
    return Script::lower;
  }
  return isIdeograph(point) ? Script::ideograph : Script::separator;
}

void appendFolded(std::string& out, char32_t point) {
  if (point >= 'A' && point <= 'Z') {
    out += static_cast<char>(point + 32);
  } else if (point == 0xDF) {
    out += "ss";
  } else if (point >= 0xC0 && point < 0xC0 + latinBase.size()) {
    out += latinBase[point - 0xC0];
  } else if (point >= 0x410 && point <= 0x42F) {
    appendUtf8(out, point + 0x20);
  } else if (point == 0x401 || point == 0x451) {
    appendUtf8(out, 0x435);
  } else {
    appendUtf8(out, point);
  }
}

// What follows the last namespace separator, unless nothing does.
std::string_view withoutNamespace(std::string_view name) {
  const std::size_t cut = name.find_last_of(":|");
  return cut == std::string_view::npos || cut + 1 >= name.size() ? name : name.substr(cut + 1);
}

std::vector<char32_t> codePoints(std::string_view text) {
  std::vector<char32_t> points;
  while (!text.empty()) {
    points.push_back(fullWidthToAscii(takeCodePoint(text)));
  }
  return points;
}

// Whether a new part starts at `i`: aB, and the last capital of ABc.
bool startsPart(const std::vector<char32_t>& points, std::size_t i) {
  const Script before = scriptOf(points[i - 1]);
  const Script here = scriptOf(points[i]);
  const Script after = i + 1 < points.size() ? scriptOf(points[i + 1]) : Script::separator;
  return here == Script::upper &&
         (before == Script::lower || (before == Script::upper && after == Script::lower));
}

bool startsChunk(const std::vector<char32_t>& points, std::size_t i) {
  return i == 0 || scriptOf(points[i - 1]) == Script::separator ||
         (scriptOf(points[i - 1]) == Script::ideograph) != (scriptOf(points[i]) == Script::ideograph);
}

} // namespace

std::vector<NameChunk> nameChunks(std::string_view name) {
  const std::vector<char32_t> points = codePoints(withoutNamespace(name));
  std::vector<NameChunk> chunks;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (scriptOf(points[i]) == Script::separator) {
      continue;
    }
    if (startsChunk(points, i)) {
      chunks.push_back({{""}, ""});
    } else if (startsPart(points, i)) {
      chunks.back().parts.emplace_back();
    }
    appendFolded(chunks.back().parts.back(), points[i]);
  }
  for (NameChunk& chunk : chunks) {
    for (const std::string& part : chunk.parts) {
      chunk.whole += part;
    }
  }
  return chunks;
}

std::vector<std::size_t> partStarts(std::string_view name) {
  std::vector<std::size_t> starts;
  const std::vector<char32_t> points = codePoints(name);
  std::string_view left = name;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isLetter = scriptOf(points[i]) != Script::separator;
    if (i > 0 && isLetter && (startsChunk(points, i) || startsPart(points, i))) {
      starts.push_back(name.size() - left.size());
    }
    takeCodePoint(left);
  }
  return starts;
}

std::optional<RowLetters> rowLetters(std::string_view part) {
  const auto isSide = [](char letter) { return letter == 'l' || letter == 'r'; };
  if (part.size() != 2 || part == "lf") {
    return std::nullopt;
  }
  if (isSide(part[1]) && std::string_view("fbhrm").find(part[0]) != std::string_view::npos) {
    return RowLetters{part[0], part[1]};
  }
  if (isSide(part[0]) && std::string_view("fbhm").find(part[1]) != std::string_view::npos) {
    return RowLetters{part[1], part[0]};
  }
  return std::nullopt;
}

} // namespace stretch::rig::body
