#include "ui/shell/user_settings.h"

#include <algorithm>
#include <cmath>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/files/user_files.h"
#include "app/schema/schema_json.h"
#include "app/schema/schema_rows.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"
#include "ui/panels/context/view_schema.h"

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;
using gltf::Json;

constexpr std::size_t recentFilesKept = 12;

void take(const Json& json, const char* name, bool& value) {
  if (json.contains(name) && json[name].is_boolean()) {
    value = json[name].get<bool>();
  }
}

template <typename Number>
void take(const Json& json, const char* name, Number& value, double smallest, double largest) {
  if (json.contains(name) && json[name].is_number()) {
    const double read = json[name].get<double>();
    if (std::isfinite(read)) {
      value = static_cast<Number>(std::clamp(read, smallest, largest));
    }
  }
}

Json child(const Json& json, const char* name) {
  return json.is_object() && json.contains(name) && json[name].is_object() ? json[name] : Json::object();
}

app::Setting<PaneSizes> paneSize(const char* name, float PaneSizes::*member, double least = smallestPane) {
  return app::setting<PaneSizes>(
      {.name = name, .minimum = least, .maximum = 900.0, .unit = "px", .help = "Size of a pane."}, member);
}

const app::Schema<PaneSizes>& paneSchema() {
  static const app::Schema<PaneSizes> schema{
      paneSize("left", &PaneSizes::left),
      paneSize("right", &PaneSizes::right),
      paneSize("bottom", &PaneSizes::bottom),
      paneSize("graph", &PaneSizes::graph, 0.0),
      app::setting<PaneSizes>({.name = "left_open", .help = "Whether it is open."}, &PaneSizes::leftOpen),
      app::setting<PaneSizes>({.name = "right_open", .help = "Whether it is open."}, &PaneSizes::rightOpen),
      app::setting<PaneSizes>({.name = "bottom_open", .help = "Whether it is open."},
                              &PaneSizes::bottomOpen)};
  return schema;
}

const app::Schema<WindowMemory>& placeSchema() {
  using W = WindowMemory;
  constexpr double largest = 16384.0;
  static const app::Schema<W> schema{
      app::setting<W>({.name = "width", .minimum = 320.0, .maximum = largest, .help = "Width."}, &W::width),
      app::setting<W>({.name = "height", .minimum = 240.0, .maximum = largest, .help = "Height."},
                      &W::height),
      app::setting<W>({.name = "maximised", .help = "Whether it fills the screen."}, &W::maximised)};
  return schema;
}

template <typename Settings>
Json objectOf(const app::Schema<Settings>& schema, const Settings& settings) {
  Json object = Json::object();
  app::writeSettings(schema, settings, object);
  return object;
}

Json vectorJson(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

void readVector(const Json& json, const char* name, Vec3& vector) {
  if (!json.contains(name) || !json[name].is_array() || json[name].size() != 3) {
    return;
  }
  Vec3 read(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    read[i] = json[name][i].is_number() ? json[name][i].get<double>() : 0.0;
  }
  vector = std::isfinite(read.x + read.y + read.z) ? read : vector;
}

void readRecent(const Json& json, UiState& ui) {
  if (!json.contains("recent") || !json["recent"].is_array()) {
    return;
  }
  ui.recentFiles.clear();
  for (const Json& entry : json["recent"]) {
    if (entry.is_string() && ui.recentFiles.size() < recentFilesKept) {
      ui.recentFiles.emplace_back(entry.get<std::string>());
    }
  }
}

Json cameraJson(const ViewBookmark& view) {
  Json json{{"target", vectorJson(view.camera.target)},
            {"distance", view.camera.distance},
            {"yaw", view.camera.yawRadians},
            {"pitch", view.camera.pitchRadians},
            {"angle", view.camera.fieldOfViewRadians},
            {"orthographic", view.camera.projection == ProjectionKind::orthographic}};
  if (!view.through.empty()) {
    json["through"] = view.through;
  }
  return json;
}

void readCamera(const Json& json, ViewBookmark& view) {
  Camera& camera = view.camera;
  readVector(json, "target", camera.target);
  take(json, "distance", camera.distance, 1e-6, 1e9);
  take(json, "yaw", camera.yawRadians, -1e3, 1e3);
  take(json, "pitch", camera.pitchRadians, -0.5 * pi, 0.5 * pi);
  take(json, "angle", camera.fieldOfViewRadians, 0.01, 3.0);
  bool orthographic = camera.projection == ProjectionKind::orthographic;
  take(json, "orthographic", orthographic);
  camera.projection = orthographic ? ProjectionKind::orthographic : ProjectionKind::perspective;
  if (json.contains("through") && json["through"].is_string()) {
    view.through = json["through"].get<std::string>();
  }
}

} // namespace

std::string settingsText(const UiState& ui, const PaneSizes& panes, const WindowMemory& window) {
  Json recent = Json::array();
  for (const fs::path& file : ui.recentFiles) {
    recent.push_back(file.string());
  }
  Json json{{"version", 1}};
  app::writeSettings(windowSchema(), ui, json);
  json["overlays"] = objectOf(overlaySchema(), ui.overlays);
  json["panes"] = objectOf(paneSchema(), panes);
  json["window"] = objectOf(placeSchema(), window);
  json["closed_sections"] = ui.closedSections;
  json["recent"] = std::move(recent);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void readSettings(const std::string& text, UiState& ui, PaneSizes& panes, WindowMemory& window) {
  const Json json = gltf::parseAnyJson(text);
  if (!json.is_object()) {
    return;
  }
  app::takeSettings(json, windowSchema(), ui);
  app::takeSettings(child(json, "overlays"), overlaySchema(), ui.overlays);
  app::takeSettings(child(json, "panes"), paneSchema(), panes);
  app::takeSettings(child(json, "window"), placeSchema(), window);
  if (json.contains("closed_sections") && json["closed_sections"].is_array()) {
    ui.closedSections.clear();
    for (const Json& entry : json["closed_sections"]) {
      if (entry.is_string()) {
        ui.closedSections.push_back(entry.get<std::string>());
      }
    }
  }
  readRecent(json, ui);
}

std::string viewText(const app::ViewState& view, const ViewBookmark& now, const ViewBookmarks& kept,
                     const Json& references) {
  Json views = Json::object();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) {
      views[std::to_string(i + 1)] = cameraJson(*kept[i]);
    }
  }
  Json json{{"version", 1},
            {"clip", view.clip},
            {"frame", view.frame},
            {"range", {view.rangeStart, view.rangeEnd}},
            {"limbs", view.selection.limbs()},
            {"trail", view.selection.trail()},
            {"camera", cameraJson(now)},
            {"kept_views", views}};
  if (!references.empty()) {
    json["references"] = references;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void readView(const std::string& text, const app::Document& document, app::ViewState& view, ViewBookmark& now,
              ViewBookmarks& kept) {
  const Json json = gltf::parseAnyJson(text);
  if (!json.is_object()) {
    return;
  }
  const auto clips = static_cast<double>(document.clips->size());
  take(json, "clip", view.clip, 0.0, std::max(0.0, clips - 1.0));
  take(json, "frame", view.frame, 0.0, app::lastFrame(document, view.clip));
  int trail = 0;
  take(json, "trail", trail, 0.0, 1e9);
  if (json.contains("range") && json["range"].is_array() && json["range"].size() == 2) {
    const Json range{{"start", json["range"][0]}, {"end", json["range"][1]}};
    take(range, "start", view.rangeStart, 0.0, app::lastFrame(document, view.clip));
    take(range, "end", view.rangeEnd, -1.0, app::lastFrame(document, view.clip));
  }
  view.selection.editTrails().trail = app::findTrail(document, trail) == nullptr ? 0 : trail;
  if (json.contains("limbs") && json["limbs"].is_array()) {
    for (const Json& limb : json["limbs"]) {
      if (limb.is_string() && app::findLimb(document, limb.get<std::string>()) != nullptr) {
        view.selection.editTrails().limbs.push_back(limb.get<std::string>());
      }
    }
  }
  readCamera(child(json, "camera"), now);
  const Json views = child(json, "kept_views");
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Json one = child(views, std::to_string(i + 1).c_str());
    if (!one.empty()) {
      readCamera(one, kept[i].emplace());
    }
  }
}

Json referencesOfView(const std::string& text) {
  const Json json = gltf::parseAnyJson(text);
  return json.is_object() ? json.value("references", Json()) : Json();
}

fs::path settingsPath() {
  return app::configFolder() / "settings.json";
}
fs::path keysPath() {
  return app::configFolder() / "keys.json";
}
fs::path viewPath(const fs::path& file) {
  return app::configFolder() / "views" / (app::nameFor(file) + ".json");
}

void rememberRecent(UiState& ui, const fs::path& file) {
  std::error_code ignored;
  const fs::path full = fs::absolute(file, ignored).lexically_normal();
  std::erase(ui.recentFiles, full);
  ui.recentFiles.insert(ui.recentFiles.begin(), full);
  if (ui.recentFiles.size() > recentFilesKept) {
    ui.recentFiles.resize(recentFilesKept);
  }
}

} // namespace stretch::ui
