#include "core/scene/camera.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/transform.h"

namespace stretch {

std::optional<CameraPlace> cameraPlace(CameraKind kind, const Mat4& world) {
  const Vec3 back(world[2]);
  const Vec3 side = glm::cross(Vec3(world[1]), back);
  const double backLength = glm::length(back);
  const double sideLength = glm::length(side);
  const Vec3 position = positionOf(world);
  const bool isUsable = backLength > 0.0 && sideLength > 0.0 && std::isfinite(backLength + sideLength) &&
                        std::isfinite(position.x + position.y + position.z);
  if (!isUsable) {
    return std::nullopt;
  }
  const Vec3 right = side / sideLength;
  return CameraPlace{kind, position, right, glm::cross(back / backLength, right), -back / backLength};
}

CameraPlace cameraFrom(const Vec3& towardsEye) {
  const Vec3 back = glm::normalize(towardsEye);
  const bool isSteep = std::abs(back.y) > 0.9999; // no way up is left in the picture
  const Vec3 right =
      glm::normalize(glm::cross(isSteep ? Vec3(0.0, 0.0, -back.y) : Vec3(0.0, 1.0, 0.0), back));
  return {CameraKind::orthographic, Vec3(0.0), right, glm::cross(back, right), -back};
}

std::optional<Vec2> inPicture(const CameraPlace& camera, const Vec3& point) {
  const Vec3 offset = point - camera.position;
  const Vec2 place(glm::dot(camera.right, offset), glm::dot(camera.up, offset));
  if (camera.kind == CameraKind::orthographic) {
    return place;
  }
  const double depth = glm::dot(camera.forward, offset);
  return depth > nearestSeen ? std::optional<Vec2>(place / depth) : std::nullopt;
}

double focalLength(double fieldOfViewRadians) {
  constexpr double halfPicture = 12.0;
  return halfPicture / std::tan(0.5 * fieldOfViewRadians);
}

Vec3 towardsEye(const CameraPlace& camera, const Vec3& point) {
  const Vec3 way = camera.position - point;
  const double length = glm::length(way);
  return camera.kind == CameraKind::perspective && length > 0.0 ? way / length : -camera.forward;
}

} // namespace stretch
