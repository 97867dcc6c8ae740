#include "rig/motion/trail_camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/reach/limb_reach.h"

namespace stretch::rig {

bool isStandardView(const std::string& name) {
  return std::ranges::find(standardViews, name) != standardViews.end();
}

CameraPlace standardView(const std::string& name, const Vec3& facing) {
  const Vec3 up(0.0, 1.0, 0.0);
  if (name == "top") {
    CameraPlace top = cameraFrom(up);
    top.up = facing;
    top.right = glm::cross(facing, up);
    return top;
  }
  const Vec3 left = glm::cross(up, facing);
  constexpr double yaw = 0.6; // of the three-quarter view, radians
  constexpr double pitch = 0.2;
  return cameraFrom(name == "side"    ? left
                    : name == "front" ? facing
                                      : std::cos(pitch) * (std::cos(yaw) * facing + std::sin(yaw) * left) +
                                            std::sin(pitch) * up);
}

Vec3 facingInClip(const Scene& scene, const Clip& clip, NodeIndex hips, const std::vector<Limb>& limbs,
                  const BindPlaces& places) {
  Vec3 facing = facingInBind(limbs, places);
  if (hips.exists()) {
    FrameState first;
    NodeSampler(scene, clip, {hips}).sample(0.0, first);
    facing =
        rotationOf(first.worlds[at(hips)]) * glm::conjugate(rotationOf(places.worlds[at(hips)])) * facing;
  }
  return std::abs(facing.x) > std::abs(facing.z) ? Vec3(std::copysign(1.0, facing.x), 0.0, 0.0)
                                                 : Vec3(0.0, 0.0, std::copysign(1.0, facing.z));
}

std::optional<CameraPlace> placeOfCamera(const SceneCamera& camera, FrameSource& frames, double timeSeconds) {
  return cameraPlace(camera.kind, frames.at(timeSeconds).worlds[at(camera.node)]);
}

} // namespace stretch::rig
