#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace stretch::ui {

enum class GlKind { buffer, vertexArray, texture, sampler, framebuffer, renderbuffer, program, shader };

/// Makes a name of the graphics driver; a context must be current. Shaders are made by the program builder.
[[nodiscard]] unsigned createGl(GlKind kind);
void destroyGl(GlKind kind, unsigned name);

/// Owns one object of the graphics driver. It must be destroyed while the context that made it is current.
template <GlKind kind>
class GlObject {
public:
  GlObject() = default; ///< Empty: name 0.
  explicit GlObject(unsigned name) : name_(name) {}
  [[nodiscard]] static GlObject create() { return GlObject(createGl(kind)); }

  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (name_ != 0) {
      destroyGl(kind, name_);
    }
  }

  [[nodiscard]] unsigned name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

private:
  unsigned name_ = 0;
};

using GlBuffer = GlObject<GlKind::buffer>;
using GlVertexArray = GlObject<GlKind::vertexArray>;
using GlTexture = GlObject<GlKind::texture>;
using GlSampler = GlObject<GlKind::sampler>;
using GlFramebuffer = GlObject<GlKind::framebuffer>;
using GlRenderbuffer = GlObject<GlKind::renderbuffer>;

/// A buffer that is written once (`upload`) or every frame (`replace`, which lets the driver drop the old
/// content).
[[nodiscard]] GlBuffer uploadBuffer(std::span<const std::byte> bytes);
void replaceBuffer(const GlBuffer& buffer, std::span<const std::byte> bytes);

template <typename T>
[[nodiscard]] std::span<const std::byte> bytesOf(const T& range) {
  return std::as_bytes(std::span(range));
}

/// How one vertex attribute lies in a buffer.
struct VertexAttribute {
  unsigned location = 0;
  int width = 3; ///< Numbers per vertex.
  std::size_t strideBytes = 0;
  std::size_t offsetBytes = 0;
  bool unsignedShorts = false; ///< Whole numbers of 16 bits, read as integers; else floats.
  bool perInstance = false;
};

/// Adds an attribute, read from `buffer`, to a vertex array.
void addAttribute(const GlVertexArray& array, const GlBuffer& buffer, const VertexAttribute& attribute);

/// Puts back, when it goes, what drawing changes: framebuffer, viewport, program, vertex array, blending,
/// depth, culling. So pictures can be drawn in the middle of somebody else's frame.
class GlStateGuard {
public:
  GlStateGuard();
  ~GlStateGuard();
  GlStateGuard(const GlStateGuard&) = delete;
  GlStateGuard& operator=(const GlStateGuard&) = delete;

private:
  int drawFramebuffer_ = 0;
  int readFramebuffer_ = 0;
  int viewport_[4] = {};
  int program_ = 0;
  int vertexArray_ = 0;
  bool blend_ = false;
  bool depthTest_ = false;
  bool cullFace_ = false;
  bool scissor_ = false;
};

} // namespace stretch::ui
