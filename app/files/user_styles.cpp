#include "app/files/user_styles.h"

#include <algorithm>

#include "app/files/user_files.h"
#include "app/schema/style_schema.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;

Error inStyleFile(const Error& error, const fs::path& path) {
  return {error.what, error.where.empty() ? path.string() : path.string() + ": " + error.where, error.remedy};
}

} // namespace

Result<rig::Style> loadStyle(const fs::path& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  const Result<gltf::Json> json = gltf::parseHandwrittenJson(*text, "give a style, as the editor exports it");
  Result<rig::Style> style = json ? styleFromJson(*json) : Result<rig::Style>(json.error());
  return style ? style : Result<rig::Style>(inStyleFile(style.error(), path));
}

Status saveStyle(const rig::Style& style, const fs::path& path) {
  if (Status usable = checkStyle(style); !usable) {
    return usable;
  }
  return writeText(path, styleToJson(style).dump(2) + "\n");
}

fs::path stylesFolder() {
  return configFolder() / "styles";
}

std::vector<rig::Style> userStyles(const fs::path& folder) {
  std::vector<rig::Style> styles;
  for (const fs::path& file : jsonFilesIn(folder)) {
    if (Result<rig::Style> style = loadStyle(file)) {
      styles.push_back(std::move(*style));
    }
  }
  std::ranges::sort(styles, {}, &rig::Style::name);
  return styles;
}

std::vector<rig::Style> allStyles(const fs::path& folder) {
  std::vector<rig::Style> styles = rig::builtInStyles();
  std::ranges::move(userStyles(folder), std::back_inserter(styles));
  return styles;
}

Result<rig::Style> findStyle(const std::string& text, const fs::path& folder) {
  if (fs::path(text).extension() == ".json") {
    return loadStyle(text);
  }
  const std::vector<rig::Style> styles = allStyles(folder);
  if (const rig::Style* const style = rig::styleNamed(styles, text)) {
    return *style;
  }
  std::string names;
  for (const rig::Style& style : styles) {
    names += (names.empty() ? "" : ", ") + style.name;
  }
  return Error{"'" + text + "' names no style, or several", "--style",
               "give a file of a style (.json), or one of: " + names};
}

} // namespace stretch::app
