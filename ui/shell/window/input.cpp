#include "ui/shell/window/input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cfloat>
#include <iterator>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

namespace stretch::ui {

namespace {

using app::Key;

constexpr std::array<std::pair<Key, int>, 18> functionalKeys{{{Key::escape, GLFW_KEY_ESCAPE},
                                                              {Key::enter, GLFW_KEY_ENTER},
                                                              {Key::tab, GLFW_KEY_TAB},
                                                              {Key::backspace, GLFW_KEY_BACKSPACE},
                                                              {Key::insert, GLFW_KEY_INSERT},
                                                              {Key::del, GLFW_KEY_DELETE},
                                                              {Key::right, GLFW_KEY_RIGHT},
                                                              {Key::left, GLFW_KEY_LEFT},
                                                              {Key::down, GLFW_KEY_DOWN},
                                                              {Key::up, GLFW_KEY_UP},
                                                              {Key::pageUp, GLFW_KEY_PAGE_UP},
                                                              {Key::pageDown, GLFW_KEY_PAGE_DOWN},
                                                              {Key::home, GLFW_KEY_HOME},
                                                              {Key::end, GLFW_KEY_END},
                                                              {Key::numpadDecimal, GLFW_KEY_KP_DECIMAL},
                                                              {Key::numpadEnter, GLFW_KEY_KP_ENTER},
                                                              {Key::numpadSubtract, GLFW_KEY_KP_SUBTRACT},
                                                              {Key::space, GLFW_KEY_SPACE}}};

Key shifted(Key first, int steps) {
  return static_cast<Key>(static_cast<int>(first) + steps);
}

/// The character that the layout prints for a printable key, in lower case; 0 when there is none of one byte.
char layoutLetter(int glfwKey, int scancode) {
  const char* name = glfwGetKeyName(glfwKey, scancode);
  if (name == nullptr || name[0] == '\0' || name[1] != '\0') {
    return 0;
  }
  return static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
}

bool isModifier(int glfwKey) {
  return glfwKey >= GLFW_KEY_LEFT_SHIFT && glfwKey <= GLFW_KEY_RIGHT_SUPER;
}

InputQueue& queueOf(GLFWwindow* window) {
  return *static_cast<InputQueue*>(glfwGetWindowUserPointer(window));
}

void onKey(GLFWwindow* window, int key, int scancode, int action, int mods) {
  receiveKey(queueOf(window), window, key, scancode, action, mods);
}

void onCharacter(GLFWwindow* window, unsigned int codepoint) {
  receiveCharacter(queueOf(window), window, codepoint);
}

void onMouseButton(GLFWwindow* window, int button, int action, int mods) {
  InputQueue& queue = queueOf(window);
  queue.anything = true;
  if (button >= 0 && button < static_cast<int>(queue.heldButtons.size())) {
    queue.buttons.push_back({static_cast<std::size_t>(button), action == GLFW_PRESS, glfwGetTime()});
  }
  ImGui_ImplGlfw_MouseButtonCallback(window, button, action, mods);
}

void onScroll(GLFWwindow* window, double x, double y) {
  queueOf(window).anything = true;
  ImGui_ImplGlfw_ScrollCallback(window, x, y);
}

void onCursorMoved(GLFWwindow* window, double, double) {
  queueOf(window).anything = true;
}

void onCursorEntered(GLFWwindow* window, int entered) {
  queueOf(window).anything = true;
  ImGui_ImplGlfw_CursorEnterCallback(window, entered);
}

void onFocus(GLFWwindow* window, int focused) {
  InputQueue& queue = queueOf(window);
  queue.anything = true;
  queue.focusGained = queue.focusGained || focused == GLFW_TRUE;
  ImGui_ImplGlfw_WindowFocusCallback(window, focused);
}

void onDrop(GLFWwindow* window, int count, const char** paths) {
  InputQueue& queue = queueOf(window);
  queue.anything = true;
  for (int i = 0; i < count; ++i) {
    queue.drops.emplace_back(paths[i]);
  }
}

void onClose(GLFWwindow* window) {
  queueOf(window).closeAsked = true;
  queueOf(window).anything = true;
  glfwSetWindowShouldClose(window, GLFW_FALSE);
}

} // namespace

void InputQueue::clear() {
  keys.clear();
  drops.clear();
  closeAsked = false;
  focusGained = false;
  anything = false;
}

void installCallbacks(GLFWwindow* window, InputQueue& queue) {
  glfwSetWindowUserPointer(window, &queue);
  glfwSetKeyCallback(window, onKey);
  glfwSetCharCallback(window, onCharacter);
  glfwSetMouseButtonCallback(window, onMouseButton);
  glfwSetScrollCallback(window, onScroll);
  glfwSetCursorPosCallback(window, onCursorMoved);
  glfwSetCursorEnterCallback(window, onCursorEntered);
  glfwSetWindowFocusCallback(window, onFocus);
  glfwSetDropCallback(window, onDrop);
  glfwSetWindowCloseCallback(window, onClose);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { queueOf(w).anything = true; });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { queueOf(w).anything = true; });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { queueOf(w).anything = true; });
}

void receiveKey(InputQueue& queue, GLFWwindow* window, int key, int scancode, int action, int mods) {
  queue.anything = true;
  const auto& pressed = queue.pressedKeys;
  // A key that went down since the last frame is seen down in the next one, and what it is pressed with, too.
  const bool wasTapped = std::find(pressed.begin(), pressed.end(), key) != pressed.end();
  // The widgets would take Tab and others for themselves while no text field is open.
  if (action == GLFW_RELEASE && (wasTapped || (isModifier(key) && !pressed.empty()))) {
    queue.lateReleases.push_back(key);
  } else if (queue.guiTakesKeys || isModifier(key) || action == GLFW_RELEASE) {
    ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, mods);
    queue.pressedKeys.push_back(key);
  }
  KeyInput input;
  input.press.chord.key = fromGlfwKey(key);
  if (input.press.chord.key == Key::none) {
    return;
  }
  input.press.chord.ctrl = (mods & GLFW_MOD_CONTROL) != 0;
  input.press.chord.shift = (mods & GLFW_MOD_SHIFT) != 0;
  input.press.chord.alt = (mods & GLFW_MOD_ALT) != 0;
  input.press.letter = layoutLetter(key, scancode);
  input.down = action != GLFW_RELEASE;
  input.repeat = action == GLFW_REPEAT;
  queue.keys.push_back(input);
}

void releaseTappedKeys(InputQueue& queue, GLFWwindow* window) {
  for (const int key : queue.lateReleases) {
    ImGui_ImplGlfw_KeyCallback(window, key, 0, GLFW_RELEASE, 0);
  }
  queue.anything = queue.anything || !queue.lateReleases.empty();
  queue.lateReleases.clear();
  queue.pressedKeys.clear();
}

void playButtons(InputQueue& queue, ImGuiIO& io) {
  constexpr double usualSeconds = 0.3;
  constexpr float slowSeconds = 0.1F;
  std::array<bool, 3> isPlayed{};
  while (!queue.buttons.empty() && !isPlayed.at(queue.buttons.front().button)) {
    const ButtonEvent event = queue.buttons.front();
    queue.buttons.pop_front();
    isPlayed.at(event.button) = true;
    queue.heldButtons.at(event.button) = event.down;
    if (event.down) {
      const double frame = io.DeltaTime > slowSeconds ? double(io.DeltaTime) : 0.0;
      const double last = std::exchange(queue.pressedAt.at(event.button), event.seconds);
      io.MouseDoubleClickTime = event.seconds - last < usualSeconds + frame ? FLT_MAX : 0.0F;
    }
  }
  std::ranges::copy(queue.heldButtons, std::begin(io.MouseDown));
  queue.anything = queue.anything || !queue.buttons.empty();
}

void receiveCharacter(InputQueue& queue, GLFWwindow* window, unsigned int codepoint) {
  queue.anything = true;
  if (queue.guiTakesKeys) {
    ImGui_ImplGlfw_CharCallback(window, codepoint);
  }
}

Key fromGlfwKey(int glfwKey) {
  if (glfwKey >= GLFW_KEY_F1 && glfwKey <= GLFW_KEY_F12) {
    return shifted(Key::f1, glfwKey - GLFW_KEY_F1);
  }
  if (glfwKey >= GLFW_KEY_KP_0 && glfwKey <= GLFW_KEY_KP_9) {
    return shifted(Key::numpad0, glfwKey - GLFW_KEY_KP_0);
  }
  for (const auto& [ours, theirs] : functionalKeys) {
    if (theirs == glfwKey) {
      return ours;
    }
  }
  // GLFW's printable keys are the characters of a US keyboard, as ours are.
  const bool printable = glfwKey > 0 && glfwKey < 128 && !app::keyName(static_cast<Key>(glfwKey)).empty();
  return printable ? static_cast<Key>(glfwKey) : Key::none;
}

app::KeyboardLayout currentKeyboard() {
  app::PrintedKeys printed;
  for (int code = 1; code < 128; ++code) {
    const Key place = fromGlfwKey(code);
    const char* const text = place == Key::none ? nullptr : glfwGetKeyName(code, 0);
    if (text != nullptr && text[0] != '\0') {
      printed[place] = text;
    }
  }
  return app::KeyboardLayout(printed);
}

} // namespace stretch::ui
