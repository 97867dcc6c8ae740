#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <imgui.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/ui/change.h"
#include "tests/support/ui/work.h"
#include "ui/shell/shell.h"
#include "ui/shell/window/input.h"

namespace stretch::test {

/// The editor without a window and without a picture: its panels, dialogs, commands, keys and files, frame by
/// frame. Whatever it keeps for the user lies in a folder of its own, which goes with it.
class EditorStage {
public:
  EditorStage();
  ~EditorStage();
  EditorStage(const EditorStage&) = delete;
  EditorStage& operator=(const EditorStage&) = delete;

  /// What is open, for bringing a state about.
  [[nodiscard]] Work work() { return {shell.open, shell.ui, status_, folder / "HOME/dummy.glb"}; }
  [[nodiscard]] app::Session& session() { return *shell.open.character(); }

  void frame();
  void frames(int count);
  /// Frames until nothing is worked on beside the window; fails the test when that does not end.
  void settle();
  /// A key, pressed and released, as its chord is spelt: "Ctrl+Z".
  void press(const std::string& chord);
  void type(const std::string& text);
  void pressWidgetKey(int imguiKey);
  void click(const std::string& widget);
  /// As the palette does.
  void run(const std::string& command);
  /// The bundled boxer as a file of the folder, opened as the user would; again where it is open.
  void openBoxer();
  /// Files that are dropped on the window.
  void drop(const std::vector<std::filesystem::path>& files);
  void askToClose();

  /// All that a step can change (change.h); with the words of dialogs, without those of panels.
  [[nodiscard]] Lines lines();

  TemporaryFolder folder;
  ui::Shell shell;

private:
  void update(const ui::InputQueue& input);

  std::filesystem::path startedIn_ = std::filesystem::current_path();
  ui::EditorStatus status_;
  ImGuiContext* gui_;
  double now_ = 0.0;
};

} // namespace stretch::test
