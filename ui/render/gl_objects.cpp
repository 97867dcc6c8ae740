#include "ui/render/gl_objects.h"

#include <cstdint>

#include <epoxy/gl.h>

namespace stretch::ui {

unsigned createGl(GlKind kind) {
  GLuint name = 0;
  switch (kind) {
  case GlKind::buffer:
    glGenBuffers(1, &name);
    break;
  case GlKind::vertexArray:
    glGenVertexArrays(1, &name);
    break;
  case GlKind::texture:
    glGenTextures(1, &name);
    break;
  case GlKind::sampler:
    glGenSamplers(1, &name);
    break;
  case GlKind::framebuffer:
    glGenFramebuffers(1, &name);
    break;
  case GlKind::renderbuffer:
    glGenRenderbuffers(1, &name);
    break;
  case GlKind::program:
    name = glCreateProgram();
    break;
  case GlKind::shader:
    break;
  }
  return name;
}

void destroyGl(GlKind kind, unsigned name) {
  switch (kind) {
  case GlKind::buffer:
    glDeleteBuffers(1, &name);
    break;
  case GlKind::vertexArray:
    glDeleteVertexArrays(1, &name);
    break;
  case GlKind::texture:
    glDeleteTextures(1, &name);
    break;
  case GlKind::sampler:
    glDeleteSamplers(1, &name);
    break;
  case GlKind::framebuffer:
    glDeleteFramebuffers(1, &name);
    break;
  case GlKind::renderbuffer:
    glDeleteRenderbuffers(1, &name);
    break;
  case GlKind::program:
    glDeleteProgram(name);
    break;
  case GlKind::shader:
    glDeleteShader(name);
    break;
  }
}

GlBuffer uploadBuffer(std::span<const std::byte> bytes) {
  GlBuffer buffer = GlBuffer::create();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return buffer;
}

void replaceBuffer(const GlBuffer& buffer, std::span<const std::byte> bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

void addAttribute(const GlVertexArray& array, const GlBuffer& buffer, const VertexAttribute& attribute) {
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  // The offset travels as a pointer: an inheritance of the days before buffers.
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  const void* offset = reinterpret_cast<const void*>(static_cast<std::uintptr_t>(attribute.offsetBytes));
  const auto stride = static_cast<GLsizei>(attribute.strideBytes);
  if (attribute.unsignedShorts) {
    glVertexAttribIPointer(attribute.location, attribute.width, GL_UNSIGNED_SHORT, stride, offset);
  } else {
    glVertexAttribPointer(attribute.location, attribute.width, GL_FLOAT, GL_FALSE, stride, offset);
  }
  glVertexAttribDivisor(attribute.location, attribute.perInstance ? 1 : 0);
  glEnableVertexAttribArray(attribute.location);
}

namespace {

void setEnabled(GLenum capability, bool enabled) {
  if (enabled) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

} // namespace

GlStateGuard::GlStateGuard()
    : blend_(glIsEnabled(GL_BLEND) == GL_TRUE), depthTest_(glIsEnabled(GL_DEPTH_TEST) == GL_TRUE),
      cullFace_(glIsEnabled(GL_CULL_FACE) == GL_TRUE), scissor_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE) {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawFramebuffer_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readFramebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
  glDisable(GL_SCISSOR_TEST);
}

GlStateGuard::~GlStateGuard() {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glUseProgram(static_cast<GLuint>(program_));
  glBindVertexArray(static_cast<GLuint>(vertexArray_));
  setEnabled(GL_BLEND, blend_);
  setEnabled(GL_DEPTH_TEST, depthTest_);
  setEnabled(GL_CULL_FACE, cullFace_);
  setEnabled(GL_SCISSOR_TEST, scissor_);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glFrontFace(GL_CCW);
  glDepthFunc(GL_LESS);
  glBlendEquation(GL_FUNC_ADD);
  glActiveTexture(GL_TEXTURE0);
}

} // namespace stretch::ui
