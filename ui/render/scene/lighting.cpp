#include "ui/render/scene/lighting.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "core/math/transform.h"

namespace stretch::ui {

namespace {

std::array<Vec3, 8> cornersOf(const Box& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1U) != 0 ? box.maximum.x : box.minimum.x,
                  (i & 2U) != 0 ? box.maximum.y : box.minimum.y,
                  (i & 4U) != 0 ? box.maximum.z : box.minimum.z};
  }
  return corners;
}

} // namespace

StudioLights studioLights(const View& view) {
  const Vec3 right = viewRight(view);
  const Vec3 up = viewUp(view);
  StudioLights lights;
  lights.key = glm::normalize(Vec3(-0.55, 1.15, 0.75));
  lights.fill = glm::normalize(0.8 * right + 0.15 * up - 0.6 * view.forward);
  lights.rim = glm::normalize(0.45 * right + 0.7 * up + 0.55 * view.forward);
  return lights;
}

FloorArea shadowedFloor(const Box& box, double floorHeight, const Vec3& towardsLight) {
  constexpr double margin = 0.14;
  Box covered;
  for (const Vec3& corner : cornersOf(box)) {
    const double above = std::max(corner.y - floorHeight, 0.0);
    covered.add({corner.x, 0.0, corner.z});
    covered.add(corner - towardsLight * (above / towardsLight.y));
  }
  const Vec3 size = covered.size();
  const double side = std::max({size.x, size.z, 1e-9}) * (0.5 + margin);
  return {{covered.centre().x, covered.centre().z}, {side, side}};
}

Mat4 lightProjection(const Box& box, const Vec3& towardsLight) {
  const Mat4 view = glm::lookAt(box.centre() + towardsLight, box.centre(), Vec3(0.0, 1.0, 0.0));
  Box seen;
  for (const Vec3& corner : cornersOf(box)) {
    seen.add(transformPoint(view, corner));
  }
  const Vec3 margin = 0.02 * seen.size() + Vec3(1e-9);
  return glm::ortho(seen.minimum.x - margin.x, seen.maximum.x + margin.x, seen.minimum.y - margin.y,
                    seen.maximum.y + margin.y, -seen.maximum.z - margin.z, -seen.minimum.z + margin.z) *
         view;
}

double floorCellSize(double characterHeight) {
  const double wanted = 0.3 * std::max(characterHeight, 1e-9);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double share = wanted / power;
  return power * (share < 2.0 ? 1.0 : share < 5.0 ? 2.0 : 5.0);
}

} // namespace stretch::ui
