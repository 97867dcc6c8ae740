#include "ui/render/view/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace stretch::ui {

namespace {

struct Axes {
  Vec3 right;
  Vec3 up;
  Vec3 back; // target to eye
};

Axes axesOf(const Camera& camera) {
  const double sy = std::sin(camera.yawRadians);
  const double cy = std::cos(camera.yawRadians);
  const double sp = std::sin(camera.pitchRadians);
  const double cp = std::cos(camera.pitchRadians);
  return {{cy, 0.0, -sy}, {-sp * sy, cp, -sp * cy}, {sy * cp, sp, cy * cp}};
}

double widthOf(const Viewport& viewport) {
  return std::max(1.0, viewport.widthPixels);
}
double heightOf(const Viewport& viewport) {
  return std::max(1.0, viewport.heightPixels);
}

Mat4 viewMatrix(const Camera& camera) {
  const Axes axes = axesOf(camera);
  const Vec3 eye = camera.target + camera.distance * axes.back;
  Mat4 view(1.0);
  for (glm::length_t i = 0; i < 3; ++i) {
    view[i] = Vec4(axes.right[i], axes.up[i], axes.back[i], 0.0);
  }
  view[3] = Vec4(-glm::dot(axes.right, eye), -glm::dot(axes.up, eye), -glm::dot(axes.back, eye), 1.0);
  return view;
}

// Clipping planes hang on the distance alone, so that characters of any unit get the same depth precision.
Mat4 projectionMatrix(const Camera& camera, double aspect) {
  constexpr double nearShare = 0.02;
  constexpr double farShare = 100.0;
  if (camera.projection == ProjectionKind::perspective) {
    return glm::perspective(camera.fieldOfViewRadians, aspect, nearShare * camera.distance,
                            farShare * camera.distance);
  }
  const double halfHeight = camera.distance * std::tan(0.5 * camera.fieldOfViewRadians);
  const double halfWidth = halfHeight * aspect;
  return glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, -farShare * camera.distance,
                    farShare * camera.distance);
}

Vec2 toNdc(const Viewport& viewport, const Vec2& pixels) {
  return {2.0 * pixels.x / widthOf(viewport) - 1.0, 1.0 - 2.0 * pixels.y / heightOf(viewport)};
}

Vec3 unproject(const Mat4& inverse, const Vec3& ndc) {
  const Vec4 point = inverse * Vec4(ndc, 1.0);
  return Vec3(point) / point.w;
}

} // namespace

void Box::add(const Vec3& point) {
  minimum = glm::min(minimum, point);
  maximum = glm::max(maximum, point);
}

void Box::add(const Box& other) {
  minimum = glm::min(minimum, other.minimum);
  maximum = glm::max(maximum, other.maximum);
}

View makeView(const Camera& camera, const Viewport& viewport) {
  const Axes axes = axesOf(camera);
  View view;
  view.view = viewMatrix(camera);
  view.projection = projectionMatrix(camera, widthOf(viewport) / heightOf(viewport));
  view.eye = camera.target + camera.distance * axes.back;
  view.forward = -axes.back;
  view.viewport = viewport;
  return view;
}

Camera lookFrom(Camera camera, ViewDirection direction, double facingYawRadians) {
  constexpr double quarter = 0.5 * pi;
  camera.projection = ProjectionKind::orthographic;
  camera.pitchRadians = 0.0;
  camera.yawRadians = facingYawRadians;
  switch (direction) {
  case ViewDirection::front:
    break;
  case ViewDirection::back:
    camera.yawRadians += pi;
    break;
  case ViewDirection::side:
    camera.yawRadians += quarter;
    break;
  case ViewDirection::otherSide:
    camera.yawRadians -= quarter;
    break;
  case ViewDirection::top:
    camera.pitchRadians = quarter;
    break;
  case ViewDirection::threeQuarter:
    camera.yawRadians += 0.6;
    camera.pitchRadians = 0.2;
    camera.projection = ProjectionKind::perspective;
    break;
  }
  return camera;
}

Camera lookingFrom(Camera camera, const Vec3& towardsEye) {
  camera.projection = ProjectionKind::perspective;
  camera.yawRadians = std::atan2(towardsEye.x, towardsEye.z);
  camera.pitchRadians = std::asin(std::clamp(towardsEye.y, -1.0, 1.0));
  return camera;
}

Camera orbited(Camera camera, const Viewport& viewport, const Vec2& dragPixels) {
  const double radiansPerPixel = pi / heightOf(viewport);
  camera.yawRadians = std::remainder(camera.yawRadians - dragPixels.x * radiansPerPixel, 2.0 * pi);
  camera.pitchRadians = std::clamp(camera.pitchRadians + dragPixels.y * radiansPerPixel, -0.5 * pi, 0.5 * pi);
  return camera;
}

Camera panned(Camera camera, const Viewport& viewport, const Vec2& dragPixels) {
  const Axes axes = axesOf(camera);
  const double units = unitsPerPixel(makeView(camera, viewport), camera.target);
  camera.target += units * (dragPixels.y * axes.up - dragPixels.x * axes.right);
  return camera;
}

Camera zoomed(Camera camera, const Viewport& viewport, double factor, const Vec2& mousePixels) {
  const double before = camera.distance;
  const Vec3 under = pointInViewPlane(makeView(camera, viewport), camera.target, mousePixels);
  camera.distance = std::clamp(before * factor, 1e-6, 1e9);
  camera.target = under + (camera.target - under) * (camera.distance / before);
  return camera;
}

Camera fitted(Camera camera, const Viewport& viewport, const Box& box, double margin) {
  if (box.empty()) {
    return camera;
  }
  const Axes axes = axesOf(camera);
  const double tangentY = std::tan(0.5 * camera.fieldOfViewRadians) * std::max(0.1, 1.0 - 2.0 * margin);
  const double tangentX = tangentY * widthOf(viewport) / heightOf(viewport);
  camera.target = box.centre();
  double distance = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1U) != 0 ? 0.5 : -0.5, (corner & 2U) != 0 ? 0.5 : -0.5,
                    (corner & 4U) != 0 ? 0.5 : -0.5);
    const Vec3 offset = sign * box.size();
    const double towardsEye =
        camera.projection == ProjectionKind::perspective ? glm::dot(offset, axes.back) : 0.0;
    const double needed = std::max(std::abs(glm::dot(offset, axes.up)) / tangentY,
                                   std::abs(glm::dot(offset, axes.right)) / tangentX);
    distance = std::max(distance, towardsEye + needed);
  }
  camera.distance = distance > 0.0 ? distance : 1.0;
  return camera;
}

std::optional<ScreenPoint> projectToPixels(const View& view, const Vec3& pointWorld) {
  const Vec4 inEye = view.view * Vec4(pointWorld, 1.0);
  const Vec4 clip = view.projection * inEye;
  if (clip.w <= 1e-12) {
    return std::nullopt;
  }
  const Vec2 ndc = Vec2(clip) / clip.w;
  return ScreenPoint{
      {0.5 * (ndc.x + 1.0) * widthOf(view.viewport), 0.5 * (1.0 - ndc.y) * heightOf(view.viewport)},
      -inEye.z};
}

Ray rayThroughPixel(const View& view, const Vec2& pixels) {
  const Mat4 inverse = glm::inverse(view.projection * view.view);
  const Vec2 ndc = toNdc(view.viewport, pixels);
  const Vec3 origin = unproject(inverse, Vec3(ndc, -1.0));
  return {origin, glm::normalize(unproject(inverse, Vec3(ndc, 0.0)) - origin)};
}

double unitsPerPixel(const View& view, const Vec3& pointWorld) {
  const Vec4 clip = view.projection * (view.view * Vec4(pointWorld, 1.0));
  return 2.0 * std::abs(clip.w) / (view.projection[1][1] * heightOf(view.viewport));
}

Vec3 pointInViewPlane(const View& view, const Vec3& pointWorld, const Vec2& pixels) {
  const Ray ray = rayThroughPixel(view, pixels);
  const double along = glm::dot(ray.direction, view.forward);
  return ray.origin + ray.direction * (glm::dot(pointWorld - ray.origin, view.forward) / along);
}

double positionAlongAxis(const View& view, const Vec3& origin, const Vec3& axis, const Vec2& pixels) {
  const Ray ray = rayThroughPixel(view, pixels);
  const double cosine = glm::dot(axis, ray.direction);
  const double sineSquared = 1.0 - cosine * cosine;
  constexpr double smallest = 1e-4;
  if (sineSquared < smallest) {
    return 0.0;
  }
  const Vec3 between = origin - ray.origin;
  return (cosine * glm::dot(between, ray.direction) - glm::dot(between, axis)) / sineSquared;
}

Vec3 viewRight(const View& view) {
  return {view.view[0][0], view.view[1][0], view.view[2][0]};
}
Vec3 viewUp(const View& view) {
  return {view.view[0][1], view.view[1][1], view.view[2][1]};
}

} // namespace stretch::ui
