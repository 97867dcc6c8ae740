#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/keyboard_layout.h"

struct GLFWwindow;
struct ImGuiIO;

namespace stretch::ui {

/// A key going down, repeating or coming up.
struct KeyInput {
  app::KeyPress press;
  bool down = true;
  bool repeat = false;
};

/// A press or a release of one of the mouse's buttons.
struct ButtonEvent {
  std::size_t button = 0; ///< 0 left, 1 right, 2 middle.
  bool down = false;
  double seconds = 0.0; ///< By the window's clock.
};

/// Events that the window told since the last frame. Its callbacks and scripts fill it through the same
/// functions.
struct InputQueue {
  std::vector<KeyInput> keys;
  std::vector<std::filesystem::path> drops;
  bool closeAsked = false;
  bool focusGained = false;
  bool anything = true;      ///< Something happened that may change the picture.
  bool guiTakesKeys = false; ///< A text field or a dialog is open: keys go to the widgets as well.
  /// Keys pressed since the last drawn frame (GLFW's codes), and those of them that came up again: the
  /// widgets look at keys once a frame and would miss a quick tap.
  std::vector<int> pressedKeys;
  std::vector<int> lateReleases;
  std::deque<ButtonEvent> buttons;                   ///< That the widgets have not seen yet.
  std::array<bool, 3> heldButtons{};                 ///< Buttons as the widgets have seen them last,
  std::array<double, 3> pressedAt{-1.0, -1.0, -1.0}; ///< and when each was pressed, seconds.

  void clear();
};

/// Lets the window's callbacks fill the queue, which must outlive the window, and feed the widgets.
void installCallbacks(GLFWwindow* window, InputQueue& queue);

/// A key as GLFW reports it (its key, scancode, action and mods).
void receiveKey(InputQueue& queue, GLFWwindow* window, int key, int scancode, int action, int mods);
/// After a drawn frame: lets keys come up for the widgets that were pressed and released before it.
void releaseTappedKeys(InputQueue& queue, GLFWwindow* window);
/// Before a frame begins: the next event of each button, so that a press and its release, and two quick
/// clicks, are seen however slow the frames are. Whether two clicks are a double click is told by the times
/// of the events, which within a slow frame are known no nearer than the frame.
void playButtons(InputQueue& queue, ImGuiIO& io);
/// A typed character.
void receiveCharacter(InputQueue& queue, GLFWwindow* window, unsigned int codepoint);

/// Our key of one of GLFW's; none for keys that nothing is bound to. Modifier keys are none.
[[nodiscard]] app::Key fromGlfwKey(int glfwKey);

/// The keyboard layout that the operating system has chosen now.
[[nodiscard]] app::KeyboardLayout currentKeyboard();

} // namespace stretch::ui
