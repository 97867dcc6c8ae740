#include "ui/render/gl/shader_program.h"

#include <algorithm>
#include <array>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "ui/render/gl/shader_sources.h"

namespace stretch::ui {

namespace {

using GlShader = GlObject<GlKind::shader>;

Error driverError(std::string_view where, std::string log) {
  std::replace(log.begin(), log.end(), '\n', ' ');
  return {"the graphics driver refuses a shader: " + log, std::string(where),
          "update the driver or draw in software (LIBGL_ALWAYS_SOFTWARE=1)"};
}

std::string logOf(GLuint name, decltype(glGetShaderInfoLog) read) {
  std::array<char, 2048> text{};
  GLsizei length = 0;
  read(name, static_cast<GLsizei>(text.size()), &length, text.data());
  return {text.data(), static_cast<std::size_t>(length)};
}

Result<GlShader> compile(std::string_view file, GLenum stage) {
  const std::string text =
      "#version 330 core\n" + std::string(shaderSource("common.glsl")) + std::string(shaderSource(file));
  GlShader shader(glCreateShader(stage));
  const char* source = text.c_str();
  glShaderSource(shader.name(), 1, &source, nullptr);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    return driverError(file, logOf(shader.name(), glGetShaderInfoLog));
  }
  return shader;
}

Status attach(const GlObject<GlKind::program>& program, std::string_view file, GLenum stage) {
  if (file.empty()) {
    return Success{};
  }
  const Result<GlShader> shader = compile(file, stage);
  if (!shader) {
    return shader.error();
  }
  glAttachShader(program.name(), shader->name()); // the program keeps it alive
  return Success{};
}

} // namespace

Result<ShaderProgram> ShaderProgram::build(const ShaderFiles& files) {
  auto program = GlObject<GlKind::program>::create();
  for (const auto& [file, stage] : {std::pair<std::string_view, GLenum>(files.vertex, GL_VERTEX_SHADER),
                                    {files.geometry, GL_GEOMETRY_SHADER},
                                    {files.fragment, GL_FRAGMENT_SHADER}}) {
    if (const Status attached = attach(program, file, stage); !attached) {
      return attached.error();
    }
  }
  if (!files.captured.empty()) {
    glTransformFeedbackVaryings(program.name(), static_cast<GLsizei>(files.captured.size()),
                                files.captured.data(), GL_INTERLEAVED_ATTRIBS);
  }
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    return driverError(files.vertex, logOf(program.name(), glGetProgramInfoLog));
  }
  return ShaderProgram(std::move(program));
}

void ShaderProgram::use() const {
  glUseProgram(program_.name());
}

int ShaderProgram::location(const char* name) const {
  return glGetUniformLocation(program_.name(), name);
}

void ShaderProgram::set(const char* name, bool value) const {
  glUniform1i(location(name), value ? 1 : 0);
}
void ShaderProgram::set(const char* name, int value) const {
  glUniform1i(location(name), value);
}
void ShaderProgram::set(const char* name, float value) const {
  glUniform1f(location(name), value);
}
void ShaderProgram::set(const char* name, const glm::vec2& value) const {
  glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec3& value) const {
  glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec4& value) const {
  glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat3x2& value) const {
  glUniformMatrix3x2fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat4& value) const {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

} // namespace stretch::ui
