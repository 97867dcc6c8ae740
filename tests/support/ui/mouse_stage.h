#pragma once

#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/open_document.h"
#include "ui/viewport/viewport_context.h"

namespace stretch::test {

/// The mouse over the viewport without a window and without a graphics card: the test says where it is and
/// which buttons and keys are down, and each change is one frame. The character is seen from the front,
/// orthographically, in a picture of 800 by 600 pixels.
class MouseStage {
public:
  explicit MouseStage(app::Document document);
  ~MouseStage();
  MouseStage(const MouseStage&) = delete;
  MouseStage& operator=(const MouseStage&) = delete;

  [[nodiscard]] app::Session& session() { return *open.character(); }
  [[nodiscard]] Vec2 pixelsOf(const Vec3& world) const;

  void frame();
  /// The mouse, without a press.
  void pointAt(const Vec2& pixels);
  void pointAt(const Vec3& world) { pointAt(pixelsOf(world)); }
  void press(int button = ImGuiMouseButton_Left);
  void release(int button = ImGuiMouseButton_Left);
  /// Press and release where the mouse is. Long after the one before, so that two of them are no double
  /// click.
  void click(int button = ImGuiMouseButton_Left);
  void clickAt(const Vec3& world, int button = ImGuiMouseButton_Left);
  void doubleClick();
  /// A press at one place, moves, and the release at another.
  void drag(const Vec2& fromPixels, const Vec2& toPixels, int button = ImGuiMouseButton_Left);
  void turnWheel(float steps);

  app::OpenDocument open;
  ui::UiState ui;
  ui::EditorStatus status;
  ui::ViewportState viewport;
  ui::Tool tool;
  bool over = true; ///< Whether the mouse is over the viewport.
  bool shift = false;
  bool control = false;
  bool alt = false;

private:
  ui::Theme theme_;
  ui::ItemRegistry items_;
  std::vector<ui::CommandInfo> commands_;
  std::vector<std::string> requested_;
  ImGuiContext* gui_;
};

} // namespace stretch::test
