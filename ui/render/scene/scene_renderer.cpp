#include "ui/render/scene/scene_renderer.h"

#include <algorithm>
#include <optional>

#include <epoxy/gl.h>

#include "ui/render/scene/floor_pass.h"
#include "ui/render/scene/lighting.h"
#include "ui/render/scene/outline_pass.h"
#include "ui/render/scene/posing.h"
#include "ui/render/scene/shadow_pass.h"
#include "ui/render/scene/surface_pass.h"
#include "ui/render/scene/value_colors.h"

namespace stretch::ui {

struct SceneRenderer::Parts {
  PosingPass posing;
  ShadowPass shadows;
  FloorPass floor;
  BackdropPass backdrop;
  SurfacePass surface;
  OutlinePass outline;
  const Scene* scene = nullptr;
  UploadedScene uploaded;
  std::optional<BoundsSampler> bounds;
};

namespace {

JointAttributes attributesOf(const FrameState& frame, const SceneStyle& style) {
  return {style.stretchRatio.empty() ? stretchRatios(frame) : style.stretchRatio, style.highlight};
}

/// An image, which the floor would hide.
bool hasImageBehind(const SceneStyle& style) {
  return style.backdrop && style.backdrop->opacity > 0.0;
}

bool picksOut(const SceneStyle& style) {
  return std::ranges::any_of(style.highlight, [](float share) { return share > 0.0F; });
}

SurfaceLook lookOf(const SceneStyle& style, const ShadowMaps& shadows) {
  return {style.palette,
          style.shading,
          style.wireframe,
          style.measures.floorHeight,
          style.measures.characterHeight,
          &shadows};
}

} // namespace

namespace {

template <typename Parts>
void poseParts(Parts& parts, const FrameState& frame, const SceneStyle& style) {
  const bool plain = style.normals == skinning::NormalMatrix::plain;
  const FrameState turning =
      plain ? skinning::turningFrame(*parts.scene, frame, !style.newStretchTurns) : FrameState{};
  parts.posing.pose(*parts.scene, parts.uploaded, frame, attributesOf(frame, style),
                    plain ? &turning : nullptr);
}

// Ghosts lie behind the character wherever they stand, so that it stays clear, and leave no depth behind.
template <typename Parts>
void drawGhosts(Parts& parts, const View& view, std::span<const Ghost> ghosts) {
  for (const Ghost& ghost : ghosts) {
    parts.posing.pose(*parts.scene, parts.uploaded, ghost.frame, {});
    parts.surface.drawGhost(parts.uploaded, view, ghost.tint);
  }
  if (!ghosts.empty()) {
    glClear(GL_DEPTH_BUFFER_BIT);
  }
}

} // namespace

SceneRenderer::SceneRenderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

Result<SceneRenderer> SceneRenderer::create() {
  Result<PosingPass> posing = PosingPass::create();
  if (!posing) {
    return posing.error();
  }
  Result<ShadowPass> shadows = ShadowPass::create();
  if (!shadows) {
    return shadows.error();
  }
  Result<FloorPass> floor = FloorPass::create();
  if (!floor) {
    return floor.error();
  }
  Result<BackdropPass> backdrop = BackdropPass::create();
  if (!backdrop) {
    return backdrop.error();
  }
  Result<SurfacePass> surface = SurfacePass::create();
  if (!surface) {
    return surface.error();
  }
  Result<OutlinePass> outline = OutlinePass::create();
  if (!outline) {
    return outline.error();
  }
  return SceneRenderer(std::make_unique<Parts>(Parts{std::move(posing).value(),
                                                     std::move(shadows).value(),
                                                     std::move(floor).value(),
                                                     std::move(backdrop).value(),
                                                     std::move(surface).value(),
                                                     std::move(outline).value(),
                                                     nullptr,
                                                     {},
                                                     {}}));
}

void SceneRenderer::setScene(const Scene& scene) {
  parts_->scene = &scene;
  parts_->uploaded = uploadScene(scene);
  parts_->bounds.emplace(scene);
}

void SceneRenderer::reshape(const SceneShape& shape) {
  const GlStateGuard guard;
  ui::reshape(parts_->uploaded, *parts_->scene, shape);
  parts_->bounds->reshape(shape);
}

void SceneRenderer::draw(const View& view, const FrameState& frame, std::span<const Ghost> ghosts,
                         const SceneStyle& style, unsigned targetFramebuffer) {
  const GlStateGuard guard;
  Parts& parts = *parts_;
  const StudioLights lights = studioLights(view);
  const bool drawsMesh = parts.scene != nullptr && style.mesh;
  ShadowMaps shadows;
  if (drawsMesh) {
    poseParts(parts, frame, style);
    const ShadowScene shadowScene{parts.bounds->boxOf(*parts.scene, frame), style.measures.floorHeight,
                                  style.measures.characterHeight, lights.key};
    shadows = parts.shadows.draw(parts.uploaded, shadowScene, style.quality);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, targetFramebuffer);
  glViewport(0, 0, static_cast<GLsizei>(view.viewport.widthPixels),
             static_cast<GLsizei>(view.viewport.heightPixels));
  parts.floor.drawBackground(style.palette);
  if (style.backdrop) {
    parts.backdrop.draw(view.viewport, *style.backdrop);
  }
  if (style.floor) {
    const Vec2 centre = drawsMesh ? shadows.area.centre : Vec2(0.0);
    parts.floor.drawFloor(
        view, style.palette,
        {style.measures.floorHeight, style.measures.characterHeight, centre, !hasImageBehind(style)},
        shadows);
  }
  if (drawsMesh) {
    drawGhosts(parts, view, ghosts);
    if (!ghosts.empty()) {
      poseParts(parts, frame, style);
    }
    const SurfaceLook look = lookOf(style, shadows);
    parts.surface.drawOpaque(*parts.scene, parts.uploaded, view, lights, look, frame);
    parts.surface.drawBlended(*parts.scene, parts.uploaded, view, lights, look, frame);
    if (style.shading != SurfaceShading::jointWeights && picksOut(style)) {
      parts.outline.draw(*parts.scene, parts.uploaded, view, style.palette, frame);
    }
  }
}

std::vector<glm::vec3> SceneRenderer::posedPositions(const FrameState& frame, std::size_t primitive) {
  const GlStateGuard guard;
  parts_->posing.pose(*parts_->scene, parts_->uploaded, frame, {});
  return readPosedPositions(parts_->uploaded, primitive);
}

std::vector<glm::vec3> SceneRenderer::posedNormals(const FrameState& frame, std::size_t primitive,
                                                   const SceneStyle& style) {
  const GlStateGuard guard;
  poseParts(*parts_, frame, style);
  return readPosedNormals(parts_->uploaded, primitive);
}

} // namespace stretch::ui
