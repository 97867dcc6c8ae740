#include "ui/render/scene/floor_pass.h"

#include <epoxy/gl.h>

namespace stretch::ui {

Result<FloorPass> FloorPass::create() {
  Result<ShaderProgram> background = ShaderProgram::build({"fullscreen.vert", "background.frag", {}, {}});
  if (!background) {
    return background.error();
  }
  Result<ShaderProgram> floor = ShaderProgram::build({"floor.vert", "floor.frag", {}, {}});
  if (!floor) {
    return floor.error();
  }
  FloorPass pass;
  pass.background_ = std::move(background).value();
  pass.floor_ = std::move(floor).value();
  pass.nothing_ = GlVertexArray::create();
  return pass;
}

void FloorPass::drawBackground(const Palette& palette) const {
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  background_.use();
  background_.set("topColor", palette.backgroundTop);
  background_.set("bottomColor", palette.backgroundBottom);
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FloorPass::drawFloor(const View& view, const Palette& palette, const FloorPlace& place,
                          const ShadowMaps& shadows) const {
  constexpr double radiusInHeights = 4.0;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, shadows.floorTexture);
  floor_.use();
  floor_.set("viewProjection", glm::mat4(view.projection * view.view));
  floor_.set("centre", glm::vec2(place.centre));
  floor_.set("radius", static_cast<float>(radiusInHeights * place.characterHeight));
  floor_.set("floorHeight", static_cast<float>(place.height));
  floor_.set("cellSize", static_cast<float>(floorCellSize(place.characterHeight)));
  floor_.set("cover", place.covers ? 0.9F : 0.0F);
  floor_.set("floorColor", palette.floor);
  floor_.set("lineColor", palette.floorLine);
  floor_.set("lineWidth", static_cast<float>(view.viewport.pixelsPerPoint));
  floor_.set("shadowColor", palette.shadow);
  floor_.set("fromBelow", view.eye.y < place.height);
  floor_.set("hasShadow", shadows.floorTexture != 0);
  floor_.set("shadow", 0);
  floor_.set("shadowArea", glm::vec4(shadows.area.centre.x, shadows.area.centre.y, shadows.area.halfSize.x,
                                     shadows.area.halfSize.y));
  floor_.set("shadowStrength", glm::vec2(0.85F, 0.50F));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

} // namespace stretch::ui
