#include "ui/render/scene/outline_pass.h"

#include <utility>

#include <epoxy/gl.h>

namespace stretch::ui {

namespace {

constexpr double innerPoints = 1.75;
constexpr double outerPoints = 3.0;

} // namespace

Result<OutlinePass> OutlinePass::create() {
  Result<ShaderProgram> program = ShaderProgram::build({"outline.vert", "outline.frag", {}, {}});
  if (!program) {
    return program.error();
  }
  return OutlinePass(std::move(program).value());
}

// The far side of a shell around the surface, of which the surface itself leaves only the rim in sight.
void OutlinePass::draw(const Scene& scene, const UploadedScene& uploaded, const View& view,
                       const Palette& palette, const FrameState& frame) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 4.0F); // A sheet without thickness lies on its own far side.
  glDisable(GL_BLEND);
  program_.use();
  program_.set("viewProjection", glm::mat4(view.projection * view.view));
  program_.set("viewportSize", glm::vec2(view.viewport.widthPixels, view.viewport.heightPixels));
  for (const auto& [color, points] :
       {std::pair(palette.selectionGround, outerPoints), std::pair(palette.selectionLine, innerPoints)}) {
    program_.set("color", color);
    program_.set("widthPixels", static_cast<float>(points * view.viewport.pixelsPerPoint));
    for (const DrawItem& item : uploaded.items) {
      setFrontFace(scene, item, frame);
      drawTriangles(uploaded, item);
    }
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glDepthMask(GL_TRUE);
}

} // namespace stretch::ui
