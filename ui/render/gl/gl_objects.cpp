#include "ui/render/gl/gl_objects.h"

#include <cstdint>

#include <epoxy/gl.h>

namespace stretch::ui {

namespace {

/// How the driver makes and destroys objects of a kind, several at a time. Programs and shaders have calls of
/// their own.
struct NameCalls {
  void (*make)(GLsizei count, GLuint* names) = nullptr;
  void (*destroy)(GLsizei count, const GLuint* names) = nullptr;
};

NameCalls callsOf(GlKind kind) {
  switch (kind) {
  case GlKind::buffer:
    return {glGenBuffers, glDeleteBuffers};
  case GlKind::vertexArray:
    return {glGenVertexArrays, glDeleteVertexArrays};
  case GlKind::texture:
    return {glGenTextures, glDeleteTextures};
  case GlKind::sampler:
    return {glGenSamplers, glDeleteSamplers};
  case GlKind::framebuffer:
    return {glGenFramebuffers, glDeleteFramebuffers};
  case GlKind::renderbuffer:
    return {glGenRenderbuffers, glDeleteRenderbuffers};
  case GlKind::program:
  case GlKind::shader:
    break;
  }
  return {};
}

} // namespace

unsigned createGl(GlKind kind) {
  GLuint name = 0;
  if (const NameCalls calls = callsOf(kind); calls.make != nullptr) {
    calls.make(1, &name);
  } else if (kind == GlKind::program) {
    name = glCreateProgram();
  }
  return name;
}

void destroyGl(GlKind kind, unsigned name) {
  if (const NameCalls calls = callsOf(kind); calls.destroy != nullptr) {
    calls.destroy(1, &name);
  } else if (kind == GlKind::program) {
    glDeleteProgram(name);
  } else {
    glDeleteShader(name);
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
