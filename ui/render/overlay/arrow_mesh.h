#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "ui/render/overlay/overlay.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

struct SolidVertex {
  glm::vec3 position{}; ///< Relative to the eye, world axes.
  glm::vec3 normal{};
  glm::vec4 color{};
};

/// Triangles (three vertices each, counter-clockwise from outside) of arrows: a thin cylinder and a cone,
/// sized in points at the arrow's foot; the farthest arrow first, its hidden parts before its visible ones.
/// Arrows without length are left out.
[[nodiscard]] std::vector<SolidVertex> arrowMeshes(const View& view, std::span<const Arrow> arrows);

} // namespace stretch::ui
