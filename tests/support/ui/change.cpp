#include "tests/support/ui/change.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "app/files/saved_work.h"
#include "core/gltf/json/json.h"
#include "ui/shell/user_settings.h"

namespace stretch::test {

namespace {

void addJson(Lines& lines, const std::string& name, const gltf::Json& json) {
  if (!json.is_structured()) {
    return;
  }
  const gltf::Json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    const bool isLeftOut = path.starts_with("/camera") || (name == "work " && path.starts_with("/limbs"));
    if (!isLeftOut) {
      const std::string told =
          value.is_number_float() ? fmt::format("{:.4g}", value.get<double>()) : value.dump();
      ++lines[name + path + " " + told];
    }
  }
}

std::string lastPart(const std::filesystem::path& path) {
  return path.filename().string();
}

} // namespace

void addSession(Lines& lines, const app::Session& session) {
  const app::ViewState& view = session.view();
  addJson(lines, "work ", app::workOf(session.document()));
  addJson(lines, "look ", gltf::Json::parse(ui::viewText(view, {}, {})));
  for (const double sphere : view.selection.spheres()) {
    ++lines[fmt::format("sphere at {:.4g} is selected", sphere)];
  }
  for (const std::string& name : view.selection.locators()) {
    ++lines["locator " + name + " is selected"];
  }
  ++lines[fmt::format("undo : {}", session.history().undoLabel())];
  ++lines[fmt::format("redo : {}", session.history().redoLabel())];
  ++lines[fmt::format("trail {} , controllers {} , range {:.4g} {:.4g}", view.selection.trail(),
                      fmt::join(view.selection.controllers(), " "), view.rangeStart, view.rangeEnd)];
  ++lines[fmt::format("original {} , keyed at once {} , whole clip {} , mirror {} , locators {}",
                      view.showOriginal, view.autoKey, view.wholeClip, view.mirrorLocators,
                      view.showLocators)];
  ++lines[fmt::format("{} offsets without a key , {} keys picked , copied {} {} {}",
                      view.unkeyed.offsets.size() + view.unkeyed.values.size(), view.pickedKeys.size(),
                      view.copiedTrail.has_value(), view.copiedPose.has_value(),
                      view.copiedKeys.has_value())];
  if (session.isDragging()) {
    ++lines["a drag goes on"];
  }
}

void addView(Lines& lines, const ui::UiState& ui) {
  gltf::Json settings = gltf::Json::parse(ui::settingsText(ui, {}, {}));
  addJson(lines, "setting ", settings);
  const ui::UiAnswers& answers = ui.answers;
  if (answers.file) {
    ++lines[fmt::format("answer : file {} for {}", lastPart(answers.file->path),
                        static_cast<int>(answers.file->purpose))];
  }
  if (answers.question) {
    ++lines[fmt::format("answer : to the question {}", static_cast<int>(*answers.question))];
  }
  if (answers.navigation) {
    ++lines[fmt::format("answer : navigation {}", static_cast<int>(*answers.navigation))];
  }
  if (answers.keyChange) {
    ++lines["answer : key " + answers.keyChange->keyText + " for " + answers.keyChange->commandId];
  }
  if (answers.overlap) {
    ++lines[fmt::format("answer : to the clash {}", static_cast<int>(*answers.overlap))];
  }
  if (answers.drop) {
    ++lines[fmt::format("answer : dropped {} for {}", lastPart(answers.drop->file),
                        static_cast<int>(answers.drop->purpose))];
  }
  if (answers.clip) {
    ++lines[fmt::format("answer : clip {} of {}", answers.clip->clip, lastPart(answers.clip->file))];
  }
  ++lines[fmt::format("answer : keys as they were {} , theme {} , keep settings {}", answers.resetKeys,
                      answers.themeChanged, answers.keepSettings)];
  for (const ui::Toast& toast : ui.toasts) {
    ++lines["news : " + toast.text];
  }
  const ui::TimelineState& time = ui.time.timeline;
  ++lines[fmt::format("time from {:.4g} to {:.4g} , playing {} , speed {:.4g}", time.viewStart, time.viewEnd,
                      time.playing, time.speed)];
  ++lines[fmt::format("graph from {:.4g} to {:.4g} , tab {}", ui.time.graph.valueMin, ui.time.graph.valueMax,
                      static_cast<int>(ui.time.tab))];
}

void addWidgets(Lines& lines, const ui::ItemRegistry& items) {
  for (const ui::Item& item : items.items) {
    ++lines["widget " + item.id + (item.enabled ? "" : " , off")];
  }
}

std::string changeText(const Lines& before, const Lines& after, int most) {
  std::vector<std::string> told;
  const auto countIn = [](const Lines& lines, const std::string& line) {
    const auto found = lines.find(line);
    return found == lines.end() ? 0 : found->second;
  };
  for (const auto& [line, count] : after) {
    if (count > countIn(before, line)) {
      told.push_back("+ " + line);
    }
  }
  for (const auto& [line, count] : before) {
    if (count > countIn(after, line)) {
      told.push_back("- " + line);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(told.size(), static_cast<std::size_t>(most)); ++i) {
    text += "      " + told[i] + "\n";
  }
  const std::size_t more = told.size() - std::min(told.size(), static_cast<std::size_t>(most));
  return text + (more > 0 ? fmt::format("      and {} more\n", more) : "");
}

} // namespace stretch::test
