#include "ui/shell/user_settings.h"

#include <algorithm>
#include <cmath>

#include "app/commands/frames.h"
#include "app/commands/selection.h"
#include "app/files/user_files.h"
#include "core/gltf/json.h"

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

template <typename Choice>
void takeChoice(const Json& json, const char* name, Choice& value, int count) {
  int index = static_cast<int>(value);
  take(json, name, index, 0.0, static_cast<double>(count - 1));
  value = static_cast<Choice>(index);
}

Json child(const Json& json, const char* name) {
  return json.is_object() && json.contains(name) && json[name].is_object() ? json[name] : Json::object();
}

Json overlaysJson(const ViewportOverlays& overlays) {
  return {{"skeleton", overlays.skeleton},
          {"wire", overlays.wire},
          {"grid", overlays.grid},
          {"trail_ticks", overlays.trailTicks},
          {"trail_frame_numbers", overlays.trailFrameNumbers},
          {"only_when_selected", overlays.trailsOnlyWhenSelected},
          {"ghosts_before", overlays.ghostsBefore},
          {"ghosts_after", overlays.ghostsAfter},
          {"ghost_step", overlays.ghostStepFrames},
          {"trail_thickness", overlays.trailThickness},
          {"sphere_size", overlays.sphereSize}};
}

void readOverlays(const Json& json, ViewportOverlays& overlays) {
  take(json, "skeleton", overlays.skeleton);
  take(json, "wire", overlays.wire);
  take(json, "grid", overlays.grid);
  take(json, "trail_ticks", overlays.trailTicks);
  take(json, "trail_frame_numbers", overlays.trailFrameNumbers);
  take(json, "only_when_selected", overlays.trailsOnlyWhenSelected);
  take(json, "ghosts_before", overlays.ghostsBefore, 0, 20);
  take(json, "ghosts_after", overlays.ghostsAfter, 0, 20);
  take(json, "ghost_step", overlays.ghostStepFrames, 1, 100);
  take(json, "trail_thickness", overlays.trailThickness, 1, 12);
  take(json, "sphere_size", overlays.sphereSize, 3, 20);
}

Json panesJson(const PaneSizes& panes) {
  return {{"left", panes.left},          {"right", panes.right},          {"bottom", panes.bottom},
          {"left_open", panes.leftOpen}, {"right_open", panes.rightOpen}, {"bottom_open", panes.bottomOpen}};
}

void readPanes(const Json& json, PaneSizes& panes) {
  take(json, "left", panes.left, smallestPane, 900);
  take(json, "right", panes.right, smallestPane, 900);
  take(json, "bottom", panes.bottom, smallestPane, 900);
  take(json, "left_open", panes.leftOpen);
  take(json, "right_open", panes.rightOpen);
  take(json, "bottom_open", panes.bottomOpen);
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

} // namespace

std::string settingsText(const UiState& ui, const PaneSizes& panes, const WindowMemory& window) {
  Json recent = Json::array();
  for (const fs::path& file : ui.recentFiles) {
    recent.push_back(file.string());
  }
  return Json{{"version", 1},
              {"theme", static_cast<int>(ui.theme)},
              {"scale", ui.scale},
              {"navigation", static_cast<int>(ui.navigation)},
              {"loop", ui.timeline.loop},
              {"snap", ui.timeline.snapToFrames},
              {"overlays", overlaysJson(ui.overlays)},
              {"panes", panesJson(panes)},
              {"window",
               {{"width", window.width}, {"height", window.height}, {"maximised", window.maximised}}},
              {"closed_sections", ui.closedSections},
              {"recent", std::move(recent)}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

void readSettings(const std::string& text, UiState& ui, PaneSizes& panes, WindowMemory& window) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    return;
  }
  takeChoice(json, "theme", ui.theme, 3);
  takeChoice(json, "navigation", ui.navigation, 2);
  take(json, "scale", ui.scale, 0.5, 4.0);
  take(json, "loop", ui.timeline.loop);
  take(json, "snap", ui.timeline.snapToFrames);
  readOverlays(child(json, "overlays"), ui.overlays);
  readPanes(child(json, "panes"), panes);
  const Json windowJson = child(json, "window");
  take(windowJson, "width", window.width, 320, 16384);
  take(windowJson, "height", window.height, 240, 16384);
  take(windowJson, "maximised", window.maximised);
  if (json.contains("closed_sections") && json["closed_sections"].is_array()) {
    for (const Json& entry : json["closed_sections"]) {
      if (entry.is_string()) {
        ui.closedSections.push_back(entry.get<std::string>());
      }
    }
  }
  readRecent(json, ui);
}

std::string viewText(const app::ViewState& view, const Camera& camera) {
  return Json{{"version", 1},
              {"clip", view.clip},
              {"frame", view.frame},
              {"range", {view.rangeStart, view.rangeEnd}},
              {"limbs", view.selectedLimbs},
              {"trail", view.selectedTrail},
              {"camera",
               {{"target", vectorJson(camera.target)},
                {"distance", camera.distance},
                {"yaw", camera.yawRadians},
                {"pitch", camera.pitchRadians},
                {"orthographic", camera.projection == ProjectionKind::orthographic}}}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

void readView(const std::string& text, const app::Document& document, app::ViewState& view, Camera& camera) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    return;
  }
  const auto clips = static_cast<double>(document.clips->size());
  take(json, "clip", view.clip, 0.0, std::max(0.0, clips - 1.0));
  take(json, "frame", view.frame, 0.0, app::lastFrame(document, view.clip));
  take(json, "trail", view.selectedTrail, 0.0, 1e9);
  if (app::findTrail(document, view.selectedTrail) == nullptr) {
    view.selectedTrail = 0;
  }
  if (json.contains("limbs") && json["limbs"].is_array()) {
    for (const Json& limb : json["limbs"]) {
      if (limb.is_string() && app::findLimb(document, limb.get<std::string>()) != nullptr) {
        view.selectedLimbs.push_back(limb.get<std::string>());
      }
    }
  }
  const Json cameraJson = child(json, "camera");
  readVector(cameraJson, "target", camera.target);
  take(cameraJson, "distance", camera.distance, 1e-6, 1e9);
  take(cameraJson, "yaw", camera.yawRadians, -1e3, 1e3);
  take(cameraJson, "pitch", camera.pitchRadians, -0.5 * pi, 0.5 * pi);
  bool orthographic = camera.projection == ProjectionKind::orthographic;
  take(cameraJson, "orthographic", orthographic);
  camera.projection = orthographic ? ProjectionKind::orthographic : ProjectionKind::perspective;
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
