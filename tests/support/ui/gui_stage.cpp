#include "tests/support/ui/gui_stage.h"

#include <cmath>

#include <backends/imgui_impl_opengl3.h>
#include <catch2/catch.hpp>
#include <epoxy/gl.h>

#include "app/commands/table/document_commands.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/shell_commands.h"

namespace stretch::test {

namespace {

constexpr int settlingFrames = 4;

ui::OffscreenContext offscreen() {
  Result<ui::OffscreenContext> context = ui::OffscreenContext::create();
  REQUIRE(context);
  return std::move(context).value();
}

/// Commands as the editor lists them; those of the document are on where they can run, the others always.
std::vector<ui::CommandInfo> commandsFor(const app::OpenDocument& open) {
  std::vector<ui::CommandInfo> infos;
  for (const app::Command<ui::Shell>& command : ui::editorCommands()) {
    infos.push_back({command.id, command.label, command.help,
                     command.keys.empty() ? "" : command.keys.front(), true, false});
  }
  for (ui::CommandInfo& info : infos) { // G moves controllers where there is no sphere to grab
    if (info.id == ui::command::controllerMove) {
      info.keyText = "G";
    }
  }
  for (const auto& command : app::documentCommands()) {
    for (ui::CommandInfo& info : infos) {
      info.enabled = info.id == command.id ? app::isEnabled(command, open) : info.enabled;
    }
  }
  return infos;
}

} // namespace

GuiPainter::GuiPainter() : context_(offscreen()) {
  ImGuiContext* gui = ImGui::CreateContext(&fonts_);
  theme_ = ui::makeTheme(ui::ThemeKind::dark, 1.0F);
  ImGui::DestroyContext(gui);
  Result<std::unique_ptr<ui::ViewportGpu>> gpu = ui::createViewportGpu();
  REQUIRE(gpu);
  gpu_ = std::move(gpu).value();
  gpu_->governor = ui::QualityGovernor(ui::highestQualityLevel - 1); // the same on every machine
}

GuiPainter::~GuiPainter() = default;

ui::Theme GuiPainter::theme(ui::ThemeKind kind) const {
  ui::Theme theme = theme_;
  theme.kind = kind;
  theme.colours = ui::coloursOf(kind);
  return theme;
}

Image GuiPainter::picture(const ui::Rect& box, const ui::Theme& theme) {
  REQUIRE(target_.resize(static_cast<int>(box.width()), static_cast<int>(box.height()), 1));
  target_.bind();
  const ImVec4 background = ImGui::ColorConvertU32ToFloat4(theme.colours.background);
  glClearColor(background.x, background.y, background.z, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  ImDrawData* drawn = ImGui::GetDrawData();
  drawn->DisplayPos = box.min;
  drawn->DisplaySize = {box.width(), box.height()};
  ImGui_ImplOpenGL3_RenderDrawData(drawn);
  target_.resolve();
  Image image = target_.readPixels();
  ui::makeOpaque(image);
  return image;
}

GuiStage::GuiStage(GuiPainter& painter, ui::ThemeKind kind, float width, float height)
    : theme(painter.theme(kind)), painter_(painter), gui_(ImGui::CreateContext(&painter.fonts())),
      width_(width), height_(height) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;
  io.DisplaySize = {width, height};
  io.DeltaTime = 1.0F / 60.0F;
  io.MousePos = {-1.0F, -1.0F};
  REQUIRE(ImGui_ImplOpenGL3_Init("#version 330 core"));
  ui::applyStyle(theme);
}

GuiStage::~GuiStage() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(gui_);
}

void GuiStage::frame(const Draw& draw) {
  commands_ = commandsFor(open);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  const ui::PanelContext panels{open, ui, theme, commands_, requested_, items, status};
  ui::ViewportContext context{panels, viewport, tool};
  ui::beginPanels(context);
  draw(context);
  ImGui::Render();
}

void GuiStage::show(const Draw& draw) {
  for (int i = 0; i < settlingFrames; ++i) {
    frame(draw);
  }
}

GuiStage::Draw GuiStage::paneOf(void (*panel)(ui::PanelContext&), float height, float& used) const {
  return [this, panel, height, &used](ui::PanelContext& context) {
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({width_, height > 0.0F ? height : height_});
    ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    panel(context);
    used = height > 0.0F ? height : std::min(height_, std::ceil(ImGui::GetCursorPosY() + theme.unit()));
    ImGui::End();
  };
}

float GuiStage::showPanel(void (*panel)(ui::PanelContext&), float height) {
  float used = height;
  show(paneOf(panel, height, used));
  return used;
}

float GuiStage::clickInPanel(const std::string& item, void (*panel)(ui::PanelContext&), float height) {
  float used = height;
  click(item, paneOf(panel, height, used));
  return used;
}

void GuiStage::showDialogs() {
  show([&](ui::PanelContext& context) {
    ui::drawDialogs(context);
    std::size_t place = 0;
    ui::drawMessages(context, {{{0.0F, 0.0F}, {width_, height_}}, {}, {}, {}}, place,
                     *ImGui::GetForegroundDrawList());
  });
}

GuiStage::Draw GuiStage::viewportPane() const {
  return [this](ui::ViewportContext& context) {
    ui::drawViewportPane(context, painter_.viewportGpu(), {{0.0F, 0.0F}, {width_, height_}}, 1.0);
  };
}

void GuiStage::showViewport() {
  show(viewportPane());
}

void GuiStage::clickInViewport(const std::string& item) {
  click(item, viewportPane());
}

Image GuiStage::picture(float height) {
  return painter_.picture({{0.0F, 0.0F}, {width_, height}}, theme);
}

void GuiStage::pointAt(const std::string& item) {
  const ui::Item* found = items.find(item);
  INFO("widget " << item);
  REQUIRE(found != nullptr);
  ImGui::GetIO().MousePos = found->centre();
}

void GuiStage::click(const std::string& item, const Draw& draw) {
  pointAt(item);
  for (const bool down : {false, true, false}) {
    ImGui::GetIO().MouseDown[0] = down;
    frame(draw);
  }
  show(draw);
}

} // namespace stretch::test
