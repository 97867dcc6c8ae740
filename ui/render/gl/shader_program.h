#pragma once

#include <string_view>
#include <vector>

#include <glm/mat3x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/base/result.h"
#include "ui/render/gl/gl_objects.h"

namespace stretch::ui {

/// Files of assets/shaders that make one program. `common.glsl` goes in front of each.
struct ShaderFiles {
  std::string_view vertex;
  std::string_view fragment;         ///< Empty for a program that only captures vertices.
  std::string_view geometry;         ///< Empty for none.
  std::vector<const char*> captured; ///< Outputs of the vertex shader to capture, interleaved.
};

/// A linked program. `set` writes a uniform of the program in use (call `use` first); a name that the
/// compiler dropped is ignored.
class ShaderProgram {
public:
  ShaderProgram() = default;

  /// An error carries the driver's log: the driver does not understand what the program ships.
  [[nodiscard]] static Result<ShaderProgram> build(const ShaderFiles& files);

  void use() const;
  void set(const char* name, bool value) const;
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::mat3x2& value) const;
  void set(const char* name, const glm::mat4& value) const;

private:
  explicit ShaderProgram(GlObject<GlKind::program> program) : program_(std::move(program)) {}
  [[nodiscard]] int location(const char* name) const;

  GlObject<GlKind::program> program_;
};

} // namespace stretch::ui
