#include "core/gltf/source/json_text.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/gltf/json/json_builder.h"

namespace stretch::gltf {

namespace {

constexpr int deepestNesting = 256;
constexpr std::string_view exportAgain = "export the file again";

// Brackets outside strings; what else is wrong the parser finds.
int nestingOf(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (inString) {
      i += letter == '\\' ? 1 : 0;
      inString = letter != '"';
    } else if (letter == '"') {
      inString = true;
    } else if (letter == '{' || letter == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (letter == '}' || letter == ']') {
      --depth;
    }
  }
  return deepest;
}

// As editors of text count: lines and columns from 1. `byte` counts from 1, too.
std::string placeInText(std::string_view text, std::size_t byte) {
  const std::string_view before =
      text.substr(0, std::min(text.size(), byte - std::min<std::size_t>(byte, 1)));
  const std::size_t lineStart = before.rfind('\n');
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t column = before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1) + 1;
  return fmt::format(" (at line {}, column {})", line, column);
}

} // namespace

Result<Json> parseJson(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) {
    return Error{"starts with a byte order mark, which glTF forbids", "JSON", "save it as UTF-8 without one"};
  }
  if (nestingOf(text) > deepestNesting) {
    return Error{fmt::format("is nested deeper than {} levels", deepestNesting), "JSON",
                 std::string(exportAgain)};
  }
  Json json;
  if (const auto failure = buildJson(text, json)) {
    return Error{failure->isOutOfRange ? "holds a number out of range"
                                       : fmt::format("is no valid JSON (at byte {})", failure->byte),
                 "JSON", std::string(exportAgain)};
  }
  if (!json.is_object()) {
    return Error{"is not a JSON object, so not glTF", "JSON", std::string(exportAgain)};
  }
  return json;
}

Json parseAnyJson(std::string_view text) {
  Json json;
  return nestingOf(text) > deepestNesting || buildJson(text, json) ? Json(Json::value_t::discarded) : json;
}

Result<Json> parseHandwrittenJson(std::string_view text, const std::string& remedy) {
  if (nestingOf(text) > deepestNesting) {
    return Error{fmt::format("is nested deeper than {} levels", deepestNesting), "", remedy};
  }
  Json json;
  if (const auto failure = buildJson(text, json)) {
    const std::string what = failure->isOutOfRange ? "holds a number out of range" : "is not JSON";
    return Error{what + placeInText(text, failure->byte), "", remedy};
  }
  if (const std::optional<std::string> twice = repeatedKey(text)) {
    return Error{"stands twice in one object", *twice, "leave one of the two out"};
  }
  return json;
}

} // namespace stretch::gltf
