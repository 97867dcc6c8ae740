#include "ui/render/gl/render_target.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace stretch::ui {

namespace {

int limitOf(GLenum limit) {
  GLint value = 0;
  glGetIntegerv(limit, &value);
  return value;
}

void setClamped(GLenum filter) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

GlRenderbuffer makeRenderbuffer(GLenum format, int width, int height, int samples) {
  GlRenderbuffer buffer = GlRenderbuffer::create();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width, height);
  return buffer;
}

GlTexture makeColorTexture(int width, int height) {
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  setClamped(GL_LINEAR);
  return texture;
}

bool isComplete() {
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace

Status RenderTarget::resize(int widthPixels, int heightPixels, int samples) {
  const int largest = std::min(limitOf(GL_MAX_TEXTURE_SIZE), limitOf(GL_MAX_RENDERBUFFER_SIZE));
  const int width = std::clamp(widthPixels, 1, largest);
  const int height = std::clamp(heightPixels, 1, largest);
  const int given = std::clamp(samples, 1, std::max(1, limitOf(GL_MAX_SAMPLES)));
  if (width == width_ && height == height_ && given == samples_) {
    return Success{};
  }
  const GlStateGuard guard;
  texture_ = makeColorTexture(width, height);
  color_ = makeRenderbuffer(GL_RGBA8, width, height, given);
  depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, width, height, given);
  resolved_ = GlFramebuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  const bool resolvedComplete = isComplete();
  drawn_ = GlFramebuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (!resolvedComplete || !isComplete()) {
    *this = RenderTarget();
    return Error{"the graphics driver cannot make a picture of this size", "viewport",
                 "choose a smaller size"};
  }
  width_ = width;
  height_ = height;
  samples_ = given;
  return Success{};
}

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  glViewport(0, 0, width_, height_);
}

void RenderTarget::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image RenderTarget::readPixels() const {
  const GlStateGuard guard;
  Image image;
  image.width = width_;
  image.height = height_;
  const std::size_t rowBytes = 4 * static_cast<std::size_t>(width_);
  image.rgba.resize(rowBytes * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  for (std::size_t row = 0; row < static_cast<std::size_t>(height_) / 2; ++row) {
    const auto top = image.rgba.begin() + static_cast<std::ptrdiff_t>(row * rowBytes);
    const auto bottom = image.rgba.end() - static_cast<std::ptrdiff_t>((row + 1) * rowBytes);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(rowBytes), bottom);
  }
  return image;
}

TextureTarget makeMaskTarget(int side) {
  TextureTarget target{GlTexture::create(), GlFramebuffer::create(), side};
  glBindTexture(GL_TEXTURE_2D, target.texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG8, side, side, 0, GL_RG, GL_UNSIGNED_BYTE, nullptr);
  setClamped(GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.name(), 0);
  return target;
}

TextureTarget makeDepthTarget(int side) {
  TextureTarget target{GlTexture::create(), GlFramebuffer::create(), side};
  glBindTexture(GL_TEXTURE_2D, target.texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
               nullptr);
  setClamped(GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.texture.name(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  return target;
}

} // namespace stretch::ui
