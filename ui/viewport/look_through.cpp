#include "ui/viewport/look_through.h"

#include <algorithm>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/seen.h"
#include "core/math/transform.h"
#include "ui/viewport/viewport_state.h"

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

void lookFreely(ViewportState& viewport) {
  if (viewport.through) {
    viewport.camera = orbitingFrom(*viewport.through);
  }
  viewport.through.reset();
  viewport.throughName.clear();
}

std::string lensText(const ViewportState& viewport) {
  const bool isThrough = viewport.through.has_value();
  const bool isPerspective = isThrough ? viewport.through->lens.kind == CameraKind::perspective
                                       : viewport.camera.projection == ProjectionKind::perspective;
  const double angle =
      isThrough ? viewport.through->lens.fieldOfViewRadians : viewport.camera.fieldOfViewRadians;
  return (isThrough ? viewport.throughName + ", " : std::string()) +
         (isPerspective ? fmt::format("perspective, {:.0f} mm", focalLength(angle)) : "orthographic");
}

} // namespace stretch::ui
