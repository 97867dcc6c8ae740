#include "ui/render/view/view_cube.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::ui {

namespace {

Vec3 turnedAboutUp(const Vec3& vector, double yawRadians) {
  const double sine = std::sin(yawRadians);
  const double cosine = std::cos(yawRadians);
  return {cosine * vector.x + sine * vector.z, vector.y, cosine * vector.z - sine * vector.x};
}

} // namespace

bool CubePart::isFace() const {
  return std::ranges::count(side, 0) == 2;
}

ViewCube::ViewCube(const View& view, double facingYawRadians)
    : right_(turnedAboutUp(viewRight(view), -facingYawRadians)),
      up_(turnedAboutUp(viewUp(view), -facingYawRadians)),
      back_(turnedAboutUp(-view.forward, -facingYawRadians)) {}

Vec2 ViewCube::seenAt(const Vec3& point) const {
  return {glm::dot(right_, point), glm::dot(up_, point)};
}

double ViewCube::towardsViewer(int axis, int side) const {
  return side * back_[axis];
}

std::optional<CubePart> ViewCube::partAt(const Vec2& place) const {
  constexpr double edgeOn = 1e-6; // A face that is seen from its edge has no width.
  const Vec3 inViewPlane = place.x * right_ + place.y * up_;
  for (int axis = 0; axis < 3; ++axis) {
    const int side = back_[axis] < 0.0 ? -1 : 1;
    if (towardsViewer(axis, side) < edgeOn) {
      continue;
    }
    const Vec3 point = inViewPlane + back_ * ((side - inViewPlane[axis]) / back_[axis]);
    CubePart part;
    bool onFace = true;
    for (int other = 0; other < 3; ++other) {
      onFace = onFace && (other == axis || std::abs(point[other]) <= 1.0);
      part.side[static_cast<std::size_t>(other)] =
          other == axis || std::abs(point[other]) > cubeMiddle ? (point[other] < 0.0 ? -1 : 1) : 0;
    }
    if (onFace) {
      return part;
    }
  }
  return std::nullopt;
}

Camera lookingAt(Camera camera, const CubePart& part, double facingYawRadians) {
  const auto [x, y, z] = part.side;
  camera.yawRadians = std::remainder(facingYawRadians + std::atan2(x, z), 2.0 * pi);
  camera.pitchRadians = std::atan2(y, std::hypot(x, z));
  camera.projection = part.isFace() ? ProjectionKind::orthographic : ProjectionKind::perspective;
  return camera;
}

} // namespace stretch::ui
