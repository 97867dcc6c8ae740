#include "tests/support/ui/mouse_stage.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "ui/render/picking/picking.h"
#include "ui/viewport/viewport_mouse.h"

namespace stretch::test {

namespace {

constexpr float pictureWidth = 800.0F;
constexpr float pictureHeight = 600.0F;

} // namespace

MouseStage::MouseStage(app::Document document) : gui_(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {pictureWidth, pictureHeight};
  io.DeltaTime = 1.0F / 60.0F;
  theme_ = ui::makeTheme(ui::ThemeKind::dark, 1.0F);
  unsigned char* pixels = nullptr;
  int atlasWidth = 0;
  int atlasHeight = 0;
  io.Fonts->GetTexDataAsAlpha8(&pixels, &atlasWidth, &atlasHeight);
  open.open(std::move(document));
  viewport.camera.target = Vec3(0.0, 1.0, 0.0);
  viewport.camera.projection = ui::ProjectionKind::orthographic;
  viewport.box = {{0.0F, 0.0F}, {pictureWidth, pictureHeight}};
  pointAt(Vec2(5.0, 5.0));
}

MouseStage::~MouseStage() {
  ImGui::DestroyContext(gui_);
}

Vec2 MouseStage::pixelsOf(const Vec3& world) const {
  const auto place = ui::projectToPixels(viewport.view, world);
  REQUIRE(place);
  return place->pixels;
}

void MouseStage::frame() {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyShift = shift;
  io.KeyCtrl = control;
  io.KeyAlt = alt;
  ImGui::NewFrame();
  ui::ViewportContext context{{open, ui, theme_, commands_, requested_, items_, status}, viewport, tool};
  viewport.view = ui::makeView(viewport.camera, {pictureWidth, pictureHeight, 1.0});
  updateShownTrails(session(), viewport.shown);
  updateTangents(session(), ui.overlays, viewport.view, viewport.tangents);
  viewport.controllers = shownControllers(session(), ui.overlays);
  const bool held = std::ranges::any_of(io.MouseDown, [](bool down) { return down; });
  handleViewportMouse(context, over, held);
  ImGui::EndFrame();
  io.MouseWheel = 0.0F;
}

void MouseStage::pointAt(const Vec2& pixels) {
  ImGui::GetIO().MousePos = {static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
  frame();
}

void MouseStage::press(int button) {
  ImGui::GetIO().MouseDown[button] = true;
  frame();
}

void MouseStage::release(int button) {
  ImGui::GetIO().MouseDown[button] = false;
  frame();
}

void MouseStage::click(int button) {
  for (int waited = 0; waited < 60; ++waited) {
    frame();
  }
  press(button);
  release(button);
}

void MouseStage::clickAt(const Vec3& world, int button) {
  pointAt(world);
  click(button);
}

void MouseStage::doubleClick() {
  click();
  press();
  release();
}

void MouseStage::drag(const Vec2& fromPixels, const Vec2& toPixels, int button) {
  pointAt(fromPixels);
  press(button);
  pointAt(glm::mix(fromPixels, toPixels, 0.5));
  pointAt(toPixels);
  release(button);
}

void MouseStage::turnWheel(float steps) {
  ImGui::GetIO().MouseWheel = steps;
  frame();
}

} // namespace stretch::test
