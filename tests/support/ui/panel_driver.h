#pragma once

#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/open_document.h"
#include "ui/panels/context/panels.h"

namespace stretch::test {

/// All panels without a window: frames are drawn into ImGui's lists, and mouse and keys are set by the test.
/// Widgets are found by their id, as whoever drives the program finds them.
class PanelDriver {
public:
  explicit PanelDriver(std::optional<app::Document> document);
  ~PanelDriver();
  PanelDriver(const PanelDriver&) = delete;
  PanelDriver& operator=(const PanelDriver&) = delete;

  /// The bundled character with its clip.
  [[nodiscard]] static app::Document bundledCharacter();

  /// The fonts that all drivers share, and the theme that is made with them.
  [[nodiscard]] static ImFontAtlas& fonts();
  [[nodiscard]] static const ui::Theme& sharedTheme();

  void frame();
  void frames(int count);

  /// Null when the last frame did not draw it.
  [[nodiscard]] const ui::Item* find(const std::string& id) const { return items.find(id); }
  /// Scrolls it into view where it is not; fails the test when no panel draws it.
  [[nodiscard]] ImVec2 centreOf(const std::string& id);

  void moveTo(const std::string& id);
  void click(const std::string& id);
  void doubleClick(const std::string& id);
  void clickRight(const std::string& id);
  /// Press, moves of the mouse in steps, release.
  void drag(const std::string& id, float dx, float dy);
  void pressMouse();
  void moveBy(float dx, float dy);
  void releaseMouse();
  void pressKey(int imguiKey);
  void type(const std::string& text);

  app::OpenDocument open; ///< A mesh sequence can be opened instead.
  ui::UiState ui;
  ui::EditorStatus status;
  ui::Theme theme;
  ui::ItemRegistry items;
  std::vector<ui::CommandInfo> commands;
  std::vector<std::string> requested;
  bool shift = false;
  float rightPaneHeight = 2200.0F; ///< Pixels; what has no room in it is scrolled to.

private:
  void drawPanes(ui::PanelContext& context) const;

  ImGuiContext* gui_;
};

} // namespace stretch::test
