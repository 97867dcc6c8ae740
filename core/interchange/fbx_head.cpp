#include "core/interchange/fbx_head.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string_view>

#include <fmt/core.h>

#include "core/base/number.h"

namespace stretch::interchange {

namespace {

constexpr std::string_view magic = "Kaydara FBX Binary";
constexpr std::size_t byteOrderAt = 22;
constexpr std::size_t versionAt = 23;
constexpr std::uint32_t oldestVersion = 7100;
constexpr std::uint32_t notLinearFlags = 0x8 | 0x2; // KeyAttrFlags of the FBX SDK: constant 2, linear 4,
                                                    // cubic 8

std::uint32_t numberAt(std::string_view text, std::size_t place) {
  std::uint32_t number = 0;
  if (place + sizeof(number) <= text.size()) {
    std::memcpy(&number, text.data() + place, sizeof(number));
  }
  return number;
}

// Calls visit(place behind the word) wherever the word stands.
template <typename Visit>
void atEach(std::string_view text, std::string_view word, const Visit& visit) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    visit(at + word.size());
  }
}

// Objects of a class: in a binary file a record whose name, with its length before, is followed by a long id,
// in a text "Class: id, ...".
std::size_t objectsOf(std::string_view text, std::string_view name, bool isBinary) {
  std::size_t count = 0;
  atEach(text, name, [&](std::size_t end) {
    const std::size_t start = end - name.size();
    const bool isRecord = isBinary && start > 0 && end < text.size() && text[end] == 'L' &&
                          static_cast<unsigned char>(text[start - 1]) == name.size();
    const bool isEntry = !isBinary && text.substr(end).starts_with(": ") && end + 2 < text.size() &&
                         std::isdigit(static_cast<unsigned char>(text[end + 2])) != 0;
    count += isRecord || isEntry ? 1 : 0;
  });
  return count;
}

// A binary list of flags stands behind 'i', its count, its encoding (0: as it is) and its length.
bool bendsBinary(std::string_view text, std::size_t at) {
  constexpr std::size_t headBytes = 13;
  const std::size_t count = numberAt(text, at + 1);
  if (at + headBytes > text.size() || text[at] != 'i' || numberAt(text, at + 5) != 0) {
    return false;
  }
  const std::size_t most = std::min(count, (text.size() - at - headBytes) / sizeof(std::uint32_t));
  for (std::size_t i = 0; i < most; ++i) {
    if ((numberAt(text, at + headBytes + i * sizeof(std::uint32_t)) & notLinearFlags) != 0) {
      return true;
    }
  }
  return false;
}

// "KeyAttrFlags: *2 { a: 24840,24840 }"
bool bendsText(std::string_view text, std::size_t at) {
  const std::size_t open = text.find("a:", at);
  const std::size_t close = text.find('}', at);
  if (open == std::string_view::npos || close == std::string_view::npos || open > close) {
    return false;
  }
  std::uint32_t number = 0;
  bool isIn = false;
  bool bends = false;
  for (const char c : text.substr(open + 2, close - open - 2)) {
    const bool isDigit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    number = isDigit ? number * 10 + static_cast<std::uint32_t>(c - '0') : number;
    bends = bends || (!isDigit && isIn && (number & notLinearFlags) != 0);
    number = isDigit ? number : 0;
    isIn = isDigit;
  }
  return bends || (isIn && (number & notLinearFlags) != 0);
}

// "Post-Extrapolation: { Type: C: "R" ...": a letter, C where the last value is held.
bool repeats(std::string_view text, std::size_t at, bool isBinary) {
  constexpr std::size_t near = 80;
  const std::string_view part = text.substr(at, near);
  const std::size_t type = part.find(isBinary ? "TypeC" : "C: \"");
  const std::size_t letter = type + (isBinary ? 5 : 4);
  return type != std::string_view::npos && letter < part.size() && part[letter] != 'C';
}

} // namespace

Result<FbxHead> fbxHeadOf(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool isBinary = text.starts_with(magic);
  if (isBinary && text.size() > byteOrderAt && text[byteOrderAt] != 0) {
    return Error{"is an FBX in big endian order, which is not read", "",
                 "export it as .glb, or as FBX of 2014 or later"};
  }
  std::uint32_t version = isBinary ? numberAt(text, versionAt) : oldestVersion;
  if (const std::size_t said = text.find("FBXVersion: "); !isBinary && said != std::string_view::npos) {
    version = parseNumber<std::uint32_t>(text.substr(said + 12, 4)).value_or(oldestVersion);
  }
  if (version < oldestVersion) {
    return Error{fmt::format("is an FBX of version {}.{}; it is read from 7.1 (2011) on", version / 1000,
                             version / 100 % 10),
                 "", "open it in Blender or the FBX Converter, and save it as .glb or a newer FBX"};
  }
  FbxHead head;
  const std::size_t layers = objectsOf(text, "AnimationLayer", isBinary);
  head.layersOnTop = layers - std::min(layers, objectsOf(text, "AnimationStack", isBinary));
  atEach(text, "KeyAttrFlags", [&](std::size_t at) {
    head.hasTangents = head.hasTangents || (isBinary ? bendsBinary(text, at) : bendsText(text, at));
  });
  atEach(text, "-Extrapolation",
         [&](std::size_t at) { head.hasRepetition = head.hasRepetition || repeats(text, at, isBinary); });
  return head;
}

BvhFrames bvhFramesOf(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  BvhFrames frames;
  const std::size_t said = text.find("Frames:");
  const std::size_t rate = text.find("Frame Time:");
  if (said == std::string_view::npos || rate == std::string_view::npos) {
    return frames;
  }
  for (std::size_t at = said + 7; at < text.size() && text[at] != '\n'; ++at) {
    const bool isDigit = std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    frames.said = isDigit ? frames.said * 10 + static_cast<std::size_t>(text[at] - '0') : frames.said;
  }
  bool isFilled = false;
  for (std::size_t at = text.find('\n', rate); at < text.size(); ++at) {
    const bool ends = text[at] == '\n';
    frames.held += ends && isFilled ? 1 : 0;
    isFilled = !ends && (isFilled || std::isspace(static_cast<unsigned char>(text[at])) == 0);
  }
  frames.held += isFilled ? 1 : 0;
  return frames;
}

} // namespace stretch::interchange
