#include "ui/render/view/camera_view.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

double aspectOf(const Viewport& viewport) {
  return std::max(1.0, viewport.widthPixels) / std::max(1.0, viewport.heightPixels);
}

} // namespace

View viewThrough(const ThroughCamera& camera, const Viewport& viewport) {
  constexpr double nearShare = 0.02;
  constexpr double farShare = 100.0;
  const CameraPlace& place = camera.place;
  const double aspect = aspectOf(viewport);
  // A viewport that is narrower than the camera's picture shows more above and below it.
  const double widened = std::max(1.0, camera.lens.aspect.value_or(0.0) / aspect);
  View view;
  for (glm::length_t i = 0; i < 3; ++i) {
    view.view[i] = Vec4(place.right[i], place.up[i], -place.forward[i], 0.0);
  }
  view.view[3] = Vec4(-glm::dot(place.right, place.position), -glm::dot(place.up, place.position),
                      glm::dot(place.forward, place.position), 1.0);
  if (camera.lens.kind == CameraKind::perspective) {
    const double tangent = widened * std::tan(0.5 * camera.lens.fieldOfViewRadians);
    view.projection =
        glm::perspective(2.0 * std::atan(tangent), aspect, nearShare * camera.reach, farShare * camera.reach);
  } else {
    const double halfHeight = widened * camera.lens.halfHeight;
    view.projection = glm::ortho(-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight,
                                 -farShare * camera.reach, farShare * camera.reach);
  }
  view.eye = place.position;
  view.forward = place.forward;
  view.viewport = viewport;
  return view;
}

Camera orbitingFrom(const ThroughCamera& camera) {
  const Vec3 back = -camera.place.forward;
  Camera orbiting = lookingFrom({}, back);
  orbiting.distance = camera.reach;
  orbiting.target = camera.place.position - camera.reach * back;
  if (camera.lens.kind == CameraKind::perspective) {
    orbiting.fieldOfViewRadians = camera.lens.fieldOfViewRadians;
  } else {
    orbiting.projection = ProjectionKind::orthographic;
    orbiting.distance = camera.lens.halfHeight / std::tan(0.5 * orbiting.fieldOfViewRadians);
  }
  return orbiting;
}

CameraPlace placeOf(const View& view) {
  const bool isPerspective = view.projection[2][3] != 0.0;
  return {isPerspective ? CameraKind::perspective : CameraKind::orthographic, view.eye, viewRight(view),
          viewUp(view), view.forward};
}

PixelBox frameIn(const Viewport& viewport, std::optional<double> aspect, double share) {
  const double own = aspectOf(viewport);
  const double wanted = aspect.value_or(own);
  const Vec2 whole(std::max(1.0, viewport.widthPixels), std::max(1.0, viewport.heightPixels));
  const Vec2 size(whole.x * std::min(1.0, wanted / own), whole.y * std::min(1.0, own / wanted));
  return {0.5 * (whole - share * size), 0.5 * (whole + share * size)};
}

} // namespace stretch::ui
