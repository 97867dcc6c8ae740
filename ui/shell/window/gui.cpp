#include "ui/shell/window/gui.h"

#include <utility>

#include <epoxy/gl.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace stretch::ui {

Result<Gui> Gui::create(Window& window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // What is remembered lies in the user's settings.
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigInputTextCursorBlink = false;
  ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
  installCallbacks(window.handle(), window.input());
  Gui gui;
  gui.alive_ = true;
  if (!ImGui_ImplOpenGL3_Init("#version 330 core") || !ImGui_ImplOpenGL3_CreateDeviceObjects()) {
    return Error{"OpenGL 3.3 is not there", "display", "update the graphics driver"};
  }
  return gui;
}

Gui::Gui(Gui&& other) noexcept : alive_(std::exchange(other.alive_, false)) {}

Gui::~Gui() {
  if (alive_) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
}

Theme Gui::setTheme(ThemeKind kind, float scale) {
  const Theme theme = makeTheme(kind, scale);
  applyStyle(theme);
  // The texture alone: the backend of Dear ImGui 1.86 does not forget the sizes of its vertex buffers when it
  // destroys them, and draws nothing from then on.
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  return theme;
}

void Gui::beginFrame(InputQueue& input, const DrivenMouse* mouse) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  playButtons(input, ImGui::GetIO());
  if (mouse != nullptr) {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 1.0F / 60.0F;
    io.MousePos = ImVec2(mouse->x, mouse->y);
    for (int button = 0; button < 3; ++button) {
      io.MouseDown[button] = mouse->buttons[button];
    }
    io.MouseWheel = mouse->wheel;
  }
  ImGui::NewFrame();
}

void Gui::endFrame() {
  ImGui::Render();
}

void Gui::paint(const Theme& theme, const WindowSize& size) {
  const ImVec4 background = ImGui::ColorConvertU32ToFloat4(theme.colours.background);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.framebufferWidth, size.framebufferHeight);
  glClearColor(background.x, background.y, background.z, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

} // namespace stretch::ui
