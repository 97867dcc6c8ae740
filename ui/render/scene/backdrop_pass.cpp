#include "ui/render/scene/backdrop_pass.h"

#include <utility>

#include <epoxy/gl.h>

#include "ui/render/gl/picture_texture.h"

namespace stretch::ui {

Vec4 backdropBox(const Backdrop& backdrop, const Image& image, const Viewport& viewport) {
  const double aspect = static_cast<double>(image.width) / static_cast<double>(image.height);
  const double width = backdrop.height * aspect * viewport.heightPixels / viewport.widthPixels;
  const double left = backdrop.across * (1.0 - width);
  const double bottom = 0.5 * (1.0 - backdrop.height);
  return {left, bottom, left + width, bottom + backdrop.height};
}

Result<BackdropPass> BackdropPass::create() {
  Result<ShaderProgram> program = ShaderProgram::build({"backdrop.vert", "backdrop.frag", {}, {}});
  if (!program) {
    return program.error();
  }
  BackdropPass pass;
  pass.program_ = std::move(program).value();
  pass.nothing_ = GlVertexArray::create();
  return pass;
}

void BackdropPass::draw(const Viewport& viewport, const Backdrop& backdrop) {
  const Result<std::shared_ptr<const Image>> given = backdrop.image();
  const std::shared_ptr<const Image> image = given ? *given : nullptr;
  if (image == nullptr || image->width <= 0 || image->height <= 0) {
    return;
  }
  glActiveTexture(GL_TEXTURE0);
  if (image != uploaded_) {
    texture_ = uploadPicture(*image);
    uploaded_ = image;
  }
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  program_.use();
  program_.set("box", glm::vec4(backdropBox(backdrop, *image, viewport)));
  program_.set("image", 0);
  program_.set("opacity", static_cast<float>(backdrop.opacity));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

} // namespace stretch::ui
