#include "ui/render/scene/draw_items.h"

#include <epoxy/gl.h>
#include <glm/matrix.hpp>

namespace stretch::ui {

namespace {

// What the item's surface is moved by as a whole.
Mat4 movedBy(const Scene& scene, const DrawItem& item, const FrameState& frame) {
  if (item.skin < 0) {
    return meshMatrix(frame, item.node);
  }
  const Skin& skin = scene.skins[static_cast<std::size_t>(item.skin)];
  return skin.joints.empty() ? Mat4(1.0) : meshMatrix(frame, skin.joints[0]) * skin.inverseBind[0];
}

} // namespace

void drawTriangles(const UploadedScene& uploaded, const DrawItem& item) {
  glBindVertexArray(item.surface.name());
  glVertexAttrib4f(4, 1.0F, 1.0F, 1.0F, 1.0F);
  glDrawElements(GL_TRIANGLES, uploaded.parts[item.part].indexCount, GL_UNSIGNED_INT, nullptr);
}

void setFrontFace(const Scene& scene, const DrawItem& item, const FrameState& frame) {
  glFrontFace(glm::determinant(Mat3(movedBy(scene, item, frame))) < 0.0 ? GL_CW : GL_CCW);
}

} // namespace stretch::ui
