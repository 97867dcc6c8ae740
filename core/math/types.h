#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace stretch {

// Motion is solved in double precision; single precision is for vertices, files and the graphics card.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3; ///< Column-major, as GLM and glTF: m[column][row].
using Mat4 = glm::dmat4;
using Quat = glm::dquat; ///< Constructor order (w, x, y, z); glTF stores (x, y, z, w).

inline constexpr double pi = 3.14159265358979323846;

} // namespace stretch
