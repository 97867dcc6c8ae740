#include "ui/viewport/camera/look_through.h"

#include <algorithm>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/seen.h"
#include "core/math/transform.h"

namespace stretch::ui {

std::optional<ThroughCamera> throughCamera(const app::Document& document, const SceneCamera& camera,
                                           const FrameState& frame) {
  const std::optional<CameraPlace> place = app::cameraIn(camera, frame);
  if (!place) {
    return std::nullopt;
  }
  const NodeIndex hips = document.body.hips;
  const Vec3 body = hips.exists() ? positionOf(frame.worlds[at(hips)]) : Vec3(0.0);
  return ThroughCamera{camera, *place,
                       std::max(0.5 * document.body.height, glm::distance(body, place->position))};
}

void lookFreely(ViewportLook& look, Camera& camera) {
  if (look.through) {
    camera = orbitingFrom(*look.through);
  }
  look.through.reset();
  look.name.clear();
}

std::string lensText(const ViewportLook& look, const Camera& camera) {
  const bool isPerspective = look.through ? look.through->lens.kind == CameraKind::perspective
                                          : camera.projection == ProjectionKind::perspective;
  const double angle = look.through ? look.through->lens.fieldOfViewRadians : camera.fieldOfViewRadians;
  return (look.through ? look.name + ", " : std::string()) +
         (isPerspective ? fmt::format("perspective, {:.0f} mm", focalLength(angle)) : "orthographic");
}

} // namespace stretch::ui
