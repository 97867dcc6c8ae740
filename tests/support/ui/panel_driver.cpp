#include "tests/support/ui/panel_driver.h"

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/files/save.h"

namespace stretch::test {

namespace {

constexpr float width = 1280.0F;
constexpr float height = 3200.0F; // tall enough for every panel to be drawn whole

std::vector<ui::CommandInfo> allCommands(const app::OpenDocument& open) {
  static const std::vector<app::DocumentCommand> commands = app::documentCommands();
  std::vector<ui::CommandInfo> infos;
  for (const app::DocumentCommand& command : commands) {
    const bool enabled = app::isEnabled(command, open);
    infos.push_back({command.id, app::labelNow(command, open), app::helpNow(command, open),
                     command.keys.empty() ? "" : command.keys.front(), enabled, app::isChecked(command, open),
                     app::whyOff(command, open), command.label});
  }
  for (const char* id : {ui::command::fileOpen, ui::command::timePlay, ui::command::trailExaggerate,
                         ui::command::pickChain, ui::command::fileExportClean}) {
    infos.push_back({id, id, "Of the editor.", "", true, false});
  }
  return infos;
}

/// Fonts and theme, which all drivers share: they are made once.
struct Lettering {
  Lettering() {
    ImGuiContext* const gui = ImGui::CreateContext(&fonts);
    theme = ui::makeTheme(ui::ThemeKind::dark, 1.0F);
    unsigned char* pixels = nullptr;
    int atlasWidth = 0;
    int atlasHeight = 0;
    fonts.GetTexDataAsAlpha8(&pixels, &atlasWidth, &atlasHeight);
    ImGui::DestroyContext(gui);
  }

  ImFontAtlas fonts;
  ui::Theme theme;
};

Lettering& lettering() {
  static Lettering shared;
  return shared;
}

bool beginPane(const char* name, float x, float y, float w, float h) {
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({w, h});
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoBringToFrontOnFocus);
}

} // namespace

PanelDriver::PanelDriver(std::optional<app::Document> document)
    : theme(lettering().theme), gui_(ImGui::CreateContext(&lettering().fonts)) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {width, height};
  io.DeltaTime = 1.0F / 60.0F;
  io.MousePos = {1.0F, 1.0F};
  for (const int key : {ImGuiKey_Enter, ImGuiKey_KeyPadEnter, ImGuiKey_Escape, ImGuiKey_DownArrow,
                        ImGuiKey_UpArrow, ImGuiKey_Backspace, ImGuiKey_A}) {
    io.KeyMap[key] = key + 1;
  }
  ui::applyStyle(theme);
  if (document) {
    open.open(std::move(*document));
  }
  frames(2);
}

PanelDriver::~PanelDriver() {
  ImGui::DestroyContext(gui_);
}

ImFontAtlas& PanelDriver::fonts() {
  return lettering().fonts;
}

const ui::Theme& PanelDriver::sharedTheme() {
  return lettering().theme;
}

app::Document PanelDriver::bundledCharacter() {
  static const Result<app::Document> document = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(document.ok());
  return *document;
}

void PanelDriver::drawPanes(ui::PanelContext& context) const {
  if (ImGui::BeginMainMenuBar()) {
    ui::drawMenuBar(context);
    ImGui::EndMainMenuBar();
  }
  beginPane("left", 0.0F, 40.0F, 264.0F, 2200.0F);
  const ui::PanelSet panels = ui::panelSetOf(context);
  panels.left(context);
  ImGui::End();
  beginPane("right", 976.0F, 40.0F, 304.0F, rightPaneHeight);
  panels.right(context);
  ImGui::End();
  beginPane("bottom", 0.0F, 2240.0F, width, 400.0F);
  panels.bottom(context);
  ImGui::End();
  beginPane("status", 0.0F, 2640.0F, width, 40.0F);
  ui::drawStatusBar(context);
  ImGui::End();
  beginPane("bar", 264.0F, 40.0F, 712.0F, 60.0F);
  panels.viewportBar(context);
  ImGui::End();
  ui::drawDialogs(context);
}

void PanelDriver::frame() {
  ImGui::GetIO().KeyShift = shift;
  commands = allCommands(open);
  ImGui::NewFrame();
  ui::PanelContext context{open, ui, theme, commands, requested, items, status};
  ui::beginPanels(context);
  drawPanes(context);
  ImGui::Render();
}

void PanelDriver::frames(int count) {
  for (int i = 0; i < count; ++i) {
    frame();
  }
}

ImVec2 PanelDriver::centreOf(const std::string& id) {
  const ui::Item* item = find(id);
  INFO("widget " << id);
  REQUIRE(item != nullptr);
  return item->centre();
}

void PanelDriver::moveTo(const std::string& id) {
  ImGui::GetIO().MousePos = centreOf(id);
  frame();
}

void PanelDriver::pressMouse() {
  ImGui::GetIO().MouseDown[0] = true;
  frame();
}

void PanelDriver::moveBy(float dx, float dy) {
  ImVec2& mouse = ImGui::GetIO().MousePos;
  mouse = {mouse.x + dx, mouse.y + dy};
  frame();
}

void PanelDriver::releaseMouse() {
  ImGui::GetIO().MouseDown[0] = false;
  frames(2);
}

void PanelDriver::click(const std::string& id) {
  moveTo(id);
  pressMouse();
  releaseMouse();
  frames(40); // so that the next click is no double click
}

void PanelDriver::doubleClick(const std::string& id) {
  moveTo(id);
  pressMouse();
  releaseMouse();
  pressMouse();
  releaseMouse();
}

void PanelDriver::clickRight(const std::string& id) {
  moveTo(id);
  ImGui::GetIO().MouseDown[1] = true;
  frame();
  ImGui::GetIO().MouseDown[1] = false;
  frames(3);
}

void PanelDriver::drag(const std::string& id, float dx, float dy) {
  moveTo(id);
  pressMouse();
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i) {
    moveBy(dx / steps, dy / steps);
  }
  releaseMouse();
  frames(40);
}

void PanelDriver::pressKey(int imguiKey) {
  ImGui::GetIO().KeysDown[imguiKey + 1] = true;
  frame();
  ImGui::GetIO().KeysDown[imguiKey + 1] = false;
  frame();
}

void PanelDriver::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  frame();
}

} // namespace stretch::test
