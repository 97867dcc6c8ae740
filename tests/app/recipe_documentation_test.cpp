#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include "app/document.h"
#include "app/files/save.h"
#include "app/recipe/recipe.h"
#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "core/gltf/json/json.h"

using namespace stretch;
using namespace stretch::app;

namespace {

const std::string documentation = STRETCH_SOURCE_DIR "/docs/recipes.md";

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The cells of the table row whose first cell is `key`; empty when there is none.
std::vector<std::string> rowOf(const std::string& text, const std::string& key) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| `" + key + "` |", 0) == 0) {
      std::vector<std::string> cells;
      std::istringstream rest(line.substr(1));
      for (std::string cell; std::getline(rest, cell, '|');) {
        cells.push_back(cell.substr(1, cell.size() - 2));
      }
      return cells;
    }
  }
  return {};
}

std::vector<std::string> wantedValues(const SettingFacts& setting) {
  switch (setting.kind) {
  case SettingKind::number:
  case SettingKind::whole:
  case SettingKind::optionalNumber:
  case SettingKind::vector:
    return {fmt::format("{:g} to {:g}", setting.minimum, setting.maximum)};
  case SettingKind::flag:
    return {"`true`", "`false`"};
  case SettingKind::axes:
    return {"`x`", "`y`", "`z`"};
  case SettingKind::ease:
    return {"[fraction, value]"};
  case SettingKind::text:
    return {"a name"};
  case SettingKind::choice:
    break;
  }
  std::vector<std::string> values;
  for (const SettingChoice& choice : setting.choices) {
    values.push_back("`" + choice.name + "`");
  }
  return values;
}

/// Without code marks, quotes and spaces.
std::string plain(const std::string& cell) {
  std::string text;
  for (const char letter : cell) {
    if (letter != '`' && letter != '"' && letter != ' ') {
      text += letter;
    }
  }
  return text;
}

std::string defaultText(const SettingFacts& setting) {
  std::string text = plain(setting.standard);
  for (std::size_t zeros = text.find(".0"); zeros != std::string::npos; zeros = text.find(".0")) {
    text.erase(zeros, 2); // "1.0" is documented as "1"
  }
  return text;
}

/// Whether the row says of the setting what the program does.
void checkRow(const std::string& text, const SettingFacts& setting) {
  INFO(setting.name);
  const std::vector<std::string> cells = rowOf(text, setting.name);
  REQUIRE(cells.size() == 5);
  CHECK(plain(cells[1]) == setting.option);
  for (const std::string& value : wantedValues(setting)) {
    CHECK_THAT(cells[2], Catch::Contains(value));
  }
  CHECK(plain(cells[3]) == defaultText(setting));
}

Document openedDummy() {
  Result<Document> document = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(document.ok());
  return std::move(document).value();
}

} // namespace

TEST_CASE("the documentation of recipes has a row for every setting, as the program takes it") {
  const std::string text = textOf(documentation);
  for (const SettingFacts& setting : trailSchema()) {
    checkRow(text, setting);
  }
  for (const SettingFacts& setting : weightSchema()) {
    checkRow(text, setting);
  }
  for (const char* const key : {"moduli", "elastic"}) {
    CHECK_FALSE(rowOf(text, key).empty());
  }
}

TEST_CASE("the documentation of recipes names every key that a saved recipe holds") {
  const std::string text = textOf(documentation);
  Document document = openedDummy();
  rig::Trail trail;
  trail.limb = document.body.limbs.front().id;
  trail.settings.space = rig::TrailSpace::view;
  trail.settings.stopAt = rig::StopPlane{};
  document.trails = {trail};
  const gltf::Json recipe = recipeToJson(document, 0);
  for (const gltf::Json* object : {&recipe, &recipe["trails"][0]}) {
    for (const auto& [key, value] : object->items()) {
      INFO(key);
      CHECK_FALSE(rowOf(text, key).empty());
    }
  }
}

namespace {

/// The bundled clip that a recipe is for, by the last word of its name.
Document openedFor(const std::string& recipe) {
  const std::string clip = recipe.ends_with("swing") ? "_swing" : recipe.ends_with("leap") ? "_leap" : "";
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy" + clip + ".glb");
  REQUIRE(opened);
  return std::move(opened).value();
}

} // namespace

TEST_CASE("the documented recipe and the bundled ones play on the bundled characters") {
  const std::string text = textOf(documentation);
  const std::size_t begin = text.find("```json\n") + 8;
  Document document = openedDummy();
  const Result<Recipe> documented =
      recipeFromJson(gltf::Json::parse(text.substr(begin, text.find("```", begin) - begin)), document);
  INFO((documented.ok() ? std::string() : documented.error().line()));
  REQUIRE(documented.ok());
  CHECK(documented->trails.size() == 2);
  for (const auto& entry : std::filesystem::directory_iterator(STRETCH_SOURCE_DIR "/docs/recipes")) {
    Document played = openedFor(entry.path().stem().string());
    const Result<Recipe> bundled = loadRecipe(entry.path(), played);
    INFO(entry.path() << (bundled.ok() ? std::string() : bundled.error().line()));
    CHECK(bundled.ok());
  }
}
