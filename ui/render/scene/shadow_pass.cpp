#include "ui/render/scene/shadow_pass.h"

#include <epoxy/gl.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

void drawAll(const UploadedScene& uploaded) {
  for (const DrawItem& item : uploaded.items) {
    glBindVertexArray(item.surface.name());
    glDrawElements(GL_TRIANGLES, uploaded.parts[item.part].indexCount, GL_UNSIGNED_INT, nullptr);
  }
}

} // namespace

Result<ShadowPass> ShadowPass::create() {
  Result<ShaderProgram> flatten = ShaderProgram::build({"floor_shadow.vert", "floor_shadow.frag", {}, {}});
  if (!flatten) {
    return flatten.error();
  }
  Result<ShaderProgram> blur = ShaderProgram::build({"fullscreen.vert", "blur.frag", {}, {}});
  if (!blur) {
    return blur.error();
  }
  Result<ShaderProgram> depth = ShaderProgram::build({"position.vert", "depth_only.frag", {}, {}});
  if (!depth) {
    return depth.error();
  }
  ShadowPass pass;
  pass.flatten_ = std::move(flatten).value();
  pass.blurProgram_ = std::move(blur).value();
  pass.depth_ = std::move(depth).value();
  pass.nothing_ = GlVertexArray::create();
  return pass;
}

ShadowMaps ShadowPass::draw(const UploadedScene& uploaded, const ShadowScene& scene, const Quality& quality) {
  ShadowMaps maps;
  if (scene.box.empty()) {
    return maps;
  }
  maps.area = shadowedFloor(scene.box, scene.floorHeight, scene.towardsKey);
  glDisable(GL_CULL_FACE);
  if (quality.floorShadowPixels > 0) {
    if (floor_.side != quality.floorShadowPixels) {
      floor_ = makeMaskTarget(quality.floorShadowPixels);
      floorSpare_ = makeMaskTarget(quality.floorShadowPixels);
    }
    drawFloorShadow(uploaded, scene, maps.area, quality.floorShadowBlurs);
    maps.floorTexture = floor_.texture.name();
  }
  if (quality.selfShadowPixels > 0) {
    if (depthTarget_.side != quality.selfShadowPixels) {
      depthTarget_ = makeDepthTarget(quality.selfShadowPixels);
    }
    const Mat4 projection = lightProjection(scene.box, scene.towardsKey);
    drawDepth(uploaded, projection);
    maps.depthTexture = depthTarget_.texture.name();
    maps.worldToDepth = glm::translate(Mat4(1.0), Vec3(0.5)) * glm::scale(Mat4(1.0), Vec3(0.5)) * projection;
    maps.depthTexelSize = glm::length(scene.box.size()) / quality.selfShadowPixels;
  }
  return maps;
}

void ShadowPass::drawFloorShadow(const UploadedScene& uploaded, const ShadowScene& scene,
                                 const FloorArea& area, int blurs) {
  glBindFramebuffer(GL_FRAMEBUFFER, floor_.framebuffer.name());
  glViewport(0, 0, floor_.side, floor_.side);
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  flatten_.use();
  flatten_.set("floorHeight", static_cast<float>(scene.floorHeight));
  flatten_.set("characterHeight", static_cast<float>(scene.characterHeight));
  flatten_.set("area", glm::vec4(area.centre.x, area.centre.y, area.halfSize.x, area.halfSize.y));
  flatten_.set("contact", true);
  flatten_.set("lightDirection", glm::vec3(0.0F, 1.0F, 0.0F));
  drawAll(uploaded);
  flatten_.set("contact", false);
  flatten_.set("lightDirection", glm::vec3(scene.towardsKey));
  drawAll(uploaded);
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
  blur(blurs);
}

void ShadowPass::blur(int times) {
  blurProgram_.use();
  blurProgram_.set("source", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(nothing_.name());
  // The same softness on the floor at every resolution: the step is a share of the texture.
  constexpr float narrowest = 1.0F / 420.0F;
  for (int i = 0; i < times; ++i) {
    const float step = narrowest * static_cast<float>(i + 1);
    glBindFramebuffer(GL_FRAMEBUFFER, floorSpare_.framebuffer.name());
    glBindTexture(GL_TEXTURE_2D, floor_.texture.name());
    blurProgram_.set("stepSize", glm::vec2(step, 0.0F));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, floor_.framebuffer.name());
    glBindTexture(GL_TEXTURE_2D, floorSpare_.texture.name());
    blurProgram_.set("stepSize", glm::vec2(0.0F, step));
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void ShadowPass::drawDepth(const UploadedScene& uploaded, const Mat4& projection) {
  glBindFramebuffer(GL_FRAMEBUFFER, depthTarget_.framebuffer.name());
  glViewport(0, 0, depthTarget_.side, depthTarget_.side);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  depth_.use();
  depth_.set("viewProjection", glm::mat4(projection));
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5F, 2.0F);
  drawAll(uploaded);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

} // namespace stretch::ui
