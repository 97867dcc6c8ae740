#pragma once

#include "ui/render/gl/shader_program.h"
#include "ui/render/scene/draw_items.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

/// Draws a line around the parts of the surface that are selected: a light one inside of a dark one, or the
/// other way round, so that it is seen on a surface and a ground of any colour.
class OutlinePass {
public:
  [[nodiscard]] static Result<OutlinePass> create();

  /// After the surfaces, into the framebuffer that is bound and has their depth.
  void draw(const Scene& scene, const UploadedScene& uploaded, const View& view, const Palette& palette,
            const FrameState& frame) const;

private:
  explicit OutlinePass(ShaderProgram program) : program_(std::move(program)) {}

  ShaderProgram program_;
};

} // namespace stretch::ui
