#include "app/recipe/offset_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/core.h>

#include "app/edits/pose/adjustment_edits.h"
#include "app/recipe/recipe.h"
#include "core/anim/frames.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/utf8.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct TableRow {
  std::size_t number = 0; // as a spreadsheet counts; the head is row 1
  Json key;               // as in a recipe, with "controller" or "attribute" and "range" beside
};

Error inRow(std::size_t number, const Error& error) {
  return {error.what, fmt::format("row {}", number) + (error.where.empty() ? "" : ": " + error.where),
          error.remedy};
}

std::string withoutBlanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// A cell may stand in double quotes, two of which are one inside.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  bool isQuoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool isPair = isQuoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (line[i] == '"' && !isPair) {
      isQuoted = !isQuoted;
    } else if (line[i] == ',' && !isQuoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
      i += isPair ? 1 : 0;
    }
  }
  std::ranges::transform(cells, cells.begin(), withoutBlanks);
  return cells;
}

constexpr std::array textColumns{"controller", "attribute", "interpolation"};
constexpr std::array numberColumns{"frame",  "frame_of_clip", "move_x", "move_y", "move_z", "turn_x",
                                   "turn_y", "turn_z",        "value",  "first",  "last"};

template <typename Names>
bool isAmong(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

Status checkHead(const std::vector<std::string>& head) {
  for (const std::string& column : head) {
    if (!isAmong(textColumns, column) && !isAmong(numberColumns, column)) {
      return Error{"'" + column + "' is not a column of a table of offset keys", "row 1",
                   "docs/recipes.md, A table of offset keys, lists them"};
    }
    if (std::ranges::count(head, column) > 1) {
      return Error{"the column '" + column + "' stands there twice", "row 1", "leave one of them out"};
    }
  }
  const bool isNamed = isAmong(head, "controller") || isAmong(head, "attribute");
  const bool isTimed = isAmong(head, "frame") || isAmong(head, "frame_of_clip");
  return isNamed && isTimed
             ? Status(Success{})
             : Error{"the table has no head", "row 1",
                     "name the columns in its first row, such as controller,frame,move_x,move_y,move_z"};
}

// "move_y" is the second number of "move", "last" of "range".
void setNumber(const std::string& column, double number, Json& key) {
  const auto setPart = [&](const std::string& name, std::size_t count, std::size_t part) {
    if (!key.contains(name)) {
      key[name] = std::vector<double>(count, 0.0);
    }
    key[name][part] = number;
  };
  if (column == "first" || column == "last") {
    setPart("range", 2, column == "last" ? 1 : 0);
  } else if (column.starts_with("move_") || column.starts_with("turn_")) {
    setPart(column.substr(0, 4), 3, static_cast<std::size_t>(column.back() - 'x'));
  } else {
    key[column] = number;
  }
}

Result<Json> keyOfCells(const std::vector<std::string>& head, const std::vector<std::string>& cells) {
  if (cells.size() > head.size()) {
    return Error{fmt::format("has {} cells under {} columns", cells.size(), head.size()), "",
                 "give one cell for each column"};
  }
  Json key = Json::object();
  bool hasFirst = false;
  bool hasLast = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty()) {
      continue;
    }
    hasFirst = hasFirst || head[i] == "first";
    hasLast = hasLast || head[i] == "last";
    if (isAmong(textColumns, head[i])) {
      key[head[i]] = cells[i];
      continue;
    }
    const std::optional<double> number = parseNumber(cells[i]);
    if (!number) {
      return Error{"'" + cells[i] + "' is not a number", head[i], "give a finite number"};
    }
    setNumber(head[i], *number, key);
  }
  return hasFirst == hasLast ? Result<Json>(std::move(key))
                             : Result<Json>(Error{"has only one end of a range", "",
                                                  "give both 'first' and 'last', or neither"});
}

Result<std::vector<TableRow>> rowsOfCsv(const std::string& text) {
  std::istringstream lines(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text);
  std::vector<std::string> head;
  std::vector<TableRow> rows;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (withoutBlanks(line).empty()) {
      continue;
    }
    if (head.empty()) {
      head = cellsOf(line);
      if (const Status known = checkHead(head); !known) {
        return known.error();
      }
      continue;
    }
    Result<Json> key = keyOfCells(head, cellsOf(line));
    if (!key) {
      return inRow(number, key.error());
    }
    rows.push_back({number, std::move(*key)});
  }
  return rows;
}

Result<std::vector<TableRow>> rowsOfJson(const std::string& text) {
  const std::string example = R"(give [{"controller": "hips", "frame": 12, "move": [0, -0.1, 0]}, ...])";
  const Result<Json> list = gltf::parseHandwrittenJson(text, example);
  if (list ? !list->is_array() : list.error().where.empty()) {
    return Error{"is not a list in JSON", "", example};
  }
  if (!list) {
    return list.error();
  }
  std::vector<TableRow> rows;
  for (const Json& key : *list) {
    if (!key.is_object()) {
      return Error{key.dump() + " is not a key", fmt::format("row {}", rows.size() + 1),
                   R"(give {"controller": "hips", "frame": 12, "move": [0, -0.1, 0]})"};
    }
    rows.push_back({rows.size() + 1, key});
  }
  return rows;
}

// A column 'controller' may name attributes, too.
void nameAttribute(const rig::ControllerList& list, Json& key) {
  const auto named = key.find("controller");
  if (named != key.end() && named->is_string() && list.attribute(named->get<std::string>()) != nullptr) {
    key["attribute"] = *named;
    key.erase("controller");
  }
}

// The adjustment that a row would be alone, as the one door of adjustments takes it.
Result<rig::Adjustment> adjustmentOfRow(const TableRow& row, Document& document, int clip,
                                        const std::string& units) {
  Json key = row.key;
  Json adjustment = Json::object();
  for (const char* name : {"controller", "attribute", "range", "range_of_clip"}) {
    if (key.contains(name)) {
      adjustment[name] = key[name];
      key.erase(name);
    }
  }
  adjustment["keys"] = Json::array({std::move(key)});
  const Json recipe{{"version", 1}, {"units", units}, {"adjustments", Json::array({std::move(adjustment)})}};
  Result<Recipe> read = recipeFromJson(recipe, document, clip);
  if (!read) {
    // Where in the recipe that nobody wrote.
    const std::string& where = read.error().where;
    const std::size_t dot = where.rfind('.');
    return Error{read.error().what, dot == std::string::npos ? "" : where.substr(dot + 1),
                 read.error().remedy};
  }
  const Result<Document> placed = placeAdjustments(document, read->adjustments);
  return placed ? Result<rig::Adjustment>(std::move(read->adjustments.front()))
                : Result<rig::Adjustment>(placed.error());
}

Status joinRow(rig::Adjustment own, std::vector<rig::Adjustment>& adjustments) {
  const auto same = std::ranges::find_if(adjustments, [&](const rig::Adjustment& other) {
    return other.controller == own.controller && other.rangeFrames == own.rangeFrames;
  });
  if (same == adjustments.end()) {
    adjustments.push_back(std::move(own));
    return Success{};
  }
  const rig::OffsetKey& key = own.keys.front();
  const bool isThere = std::ranges::any_of(
      same->keys, [&](const rig::OffsetKey& other) { return sameFrame(other.frame, key.frame); });
  if (isThere) {
    return Error{fmt::format("there is a key of {} at frame {:g} already", own.controller, key.frame), "",
                 "leave one of them out"};
  }
  same->keys.push_back(key);
  return Success{};
}

Result<std::vector<rig::Adjustment>> adjustmentsOfRows(const std::vector<TableRow>& rows, Document& document,
                                                       int clip, const std::string& units) {
  const rig::ControllerList list = controllersOf(document);
  std::vector<rig::Adjustment> adjustments;
  for (TableRow row : rows) {
    nameAttribute(list, row.key);
    Result<rig::Adjustment> own = adjustmentOfRow(row, document, clip, units);
    const Status joined = own ? joinRow(std::move(*own), adjustments) : Status(own.error());
    if (!joined) {
      return inRow(row.number, joined.error());
    }
  }
  for (rig::Adjustment& adjustment : adjustments) {
    std::ranges::sort(adjustment.keys, {}, &rig::OffsetKey::frame);
  }
  return adjustments.empty()
             ? Result<std::vector<rig::Adjustment>>(Error{"holds no keys", "", "give a row for each key"})
             : Result<std::vector<rig::Adjustment>>(std::move(adjustments));
}

} // namespace

Result<std::vector<rig::Adjustment>> loadOffsetTable(const std::filesystem::path& path, Document& document,
                                                     int clip, const std::string& units) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  if (gltf::asUtf8(*text) != *text) {
    return Error{"is no UTF-8 text", path.string(), "save the table as UTF-8"};
  }
  const bool isJson = path.extension() == ".json";
  const Result<std::vector<TableRow>> rows = isJson ? rowsOfJson(*text) : rowsOfCsv(*text);
  Result<std::vector<rig::Adjustment>> adjustments = rows
                                                         ? adjustmentsOfRows(*rows, document, clip, units)
                                                         : Result<std::vector<rig::Adjustment>>(rows.error());
  if (!adjustments) {
    const std::string& where = adjustments.error().where;
    return Error{adjustments.error().what, path.string() + (where.empty() ? "" : ": " + where),
                 adjustments.error().remedy};
  }
  return adjustments;
}

} // namespace stretch::app
