#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/open_document.h"
#include "ui/panels/context/panels.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/gl/render_target.h"
#include "ui/viewport/viewport_pane.h"

namespace stretch::test {

/// What all pictures of the interface share: a context without a window, the fonts, and what the viewport
/// keeps on the graphics card.
class GuiPainter {
public:
  GuiPainter();
  ~GuiPainter();
  GuiPainter(const GuiPainter&) = delete;
  GuiPainter& operator=(const GuiPainter&) = delete;

  [[nodiscard]] ui::ViewportGpu& viewportGpu() { return *gpu_; }
  [[nodiscard]] ui::Theme theme(ui::ThemeKind kind) const;
  [[nodiscard]] ImFontAtlas& fonts() { return fonts_; }
  /// What the last frame of the current context shows in a rectangle of its window.
  [[nodiscard]] Image picture(const ui::Rect& box, const ui::Theme& theme);

private:
  ui::OffscreenContext context_;
  ImFontAtlas fonts_;
  ui::Theme theme_;
  ui::RenderTarget target_;
  std::unique_ptr<ui::ViewportGpu> gpu_;
};

/// A window of its own for one picture, without a screen: panels or the viewport, drawn as the editor draws
/// them.
class GuiStage {
public:
  GuiStage(GuiPainter& painter, ui::ThemeKind kind, float width, float height);
  ~GuiStage();
  GuiStage(const GuiStage&) = delete;
  GuiStage& operator=(const GuiStage&) = delete;

  using Draw = std::function<void(ui::ViewportContext&)>;

  /// Frames are drawn until everything has settled. The last one stays for `picture`.
  void show(const Draw& draw);
  /// A panel in a pane of the stage's width; answers its height.
  float showPanel(void (*panel)(ui::PanelContext&), float height = 0.0F);
  /// A click on a widget of the panel that is shown; answers its height then.
  float clickInPanel(const std::string& item, void (*panel)(ui::PanelContext&), float height = 0.0F);
  void showDialogs();
  void showViewport();
  void clickInViewport(const std::string& item);
  [[nodiscard]] Image picture(float height);
  [[nodiscard]] Image picture() { return picture(height_); }

  /// The mouse, held still where a widget is.
  void pointAt(const std::string& item);
  void click(const std::string& item, const Draw& draw);

  app::OpenDocument open;
  ui::UiState ui;
  ui::EditorStatus status;
  ui::Theme theme;
  ui::ItemRegistry items;
  ui::ViewportState viewport;
  ui::Tool tool;

private:
  void frame(const Draw& draw);
  [[nodiscard]] Draw viewportPane() const;
  /// Draws a panel in a pane of the stage's width, and tells in `used` how high it is.
  [[nodiscard]] Draw paneOf(void (*panel)(ui::PanelContext&), float height, float& used) const;

  GuiPainter& painter_;
  ImGuiContext* gui_;
  float width_;
  float height_;
  std::vector<ui::CommandInfo> commands_;
  std::vector<std::string> requested_;
};

} // namespace stretch::test
