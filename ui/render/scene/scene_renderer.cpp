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
#include "ui/render/scene/thinned_meshes.h"
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
  std::size_t heavyTriangles = 0;       // of a heavy scene that is drawn in software, else 0
  std::optional<UploadedScene> thinned; // such a scene with few of them, once it was drawn so
  std::optional<BoundsSampler> bounds;

  UploadedScene& drawn(const Quality& quality) {
    if (!quality.thinned || heavyTriangles == 0) {
      return uploaded;
    }
    if (!thinned) {
      thinned = uploadMeshes(*scene, thinnedMeshes(scene->meshes, movingTriangles), uploaded.textures);
    }
    return *thinned;
  }
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
void poseParts(Parts& parts, UploadedScene& drawn, const FrameState& frame, const SceneStyle& style) {
  const bool plain = style.normals == skinning::NormalMatrix::plain;
  const FrameState turning =
      plain ? skinning::turningFrame(*parts.scene, frame, !style.newStretchTurns) : FrameState{};
  parts.posing.pose(*parts.scene, drawn, frame, attributesOf(frame, style), plain ? &turning : nullptr);
}

// Ghosts lie behind the character wherever they stand, so that it stays clear, and leave no depth behind.
template <typename Parts>
void drawGhosts(Parts& parts, UploadedScene& drawn, const View& view, std::span<const Ghost> ghosts) {
  for (const Ghost& ghost : ghosts) {
    parts.posing.pose(*parts.scene, drawn, ghost.frame, {});
    parts.surface.drawGhost(drawn, view, ghost.tint);
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
                                                     0,
                                                     {},
                                                     {}}));
}

void SceneRenderer::setScene(const Scene& scene) {
  parts_->scene = &scene;
  parts_->uploaded = uploadScene(scene);
  parts_->thinned.reset();
  // Half as many again would hardly be drawn faster.
  const std::size_t triangles = triangleCount(scene.meshes);
  parts_->heavyTriangles = drawsInSoftware() && triangles > 3 * movingTriangles / 2 ? triangles : 0;
  parts_->bounds.emplace(scene);
}

double SceneRenderer::secondsUnthinned() const {
  constexpr double secondsOfTriangle = 4e-7; // of Mesa's llvmpipe on two cores
  return secondsOfTriangle * static_cast<double>(parts_->heavyTriangles);
}

void SceneRenderer::reshape(const SceneShape& shape) {
  const GlStateGuard guard;
  parts_->thinned.reset();
  parts_->heavyTriangles = 0;
  ui::reshape(parts_->uploaded, *parts_->scene, shape);
  parts_->bounds->reshape(shape);
}

void SceneRenderer::draw(const View& view, const FrameState& frame, std::span<const Ghost> ghosts,
                         const SceneStyle& style, unsigned targetFramebuffer) {
  const GlStateGuard guard;
  Parts& parts = *parts_;
  UploadedScene& drawn = parts.drawn(style.quality);
  const StudioLights lights = studioLights(view);
  const bool drawsMesh = parts.scene != nullptr && style.mesh;
  ShadowMaps shadows;
  if (drawsMesh) {
    poseParts(parts, drawn, frame, style);
    const ShadowScene shadowScene{parts.bounds->boxOf(*parts.scene, frame), style.measures.floorHeight,
                                  style.measures.characterHeight, lights.key};
    shadows = parts.shadows.draw(drawn, shadowScene, style.quality);
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
    drawGhosts(parts, drawn, view, ghosts);
    if (!ghosts.empty()) {
      poseParts(parts, drawn, frame, style);
    }
    const SurfaceLook look = lookOf(style, shadows);
    parts.surface.drawOpaque(*parts.scene, drawn, view, lights, look, frame);
    parts.surface.drawBlended(*parts.scene, drawn, view, lights, look, frame);
    if (style.shading != SurfaceShading::jointWeights && picksOut(style)) {
      parts.outline.draw(*parts.scene, drawn, view, style.palette, frame);
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
  poseParts(*parts_, parts_->uploaded, frame, style);
  return readPosedNormals(parts_->uploaded, primitive);
}

} // namespace stretch::ui
