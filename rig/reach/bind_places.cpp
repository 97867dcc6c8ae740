#include "rig/reach/bind_places.h"

#include "rig/body/evidence/body_view.h"

namespace stretch::rig {

BindPlaces bindPlaces(const Scene& scene) {
  return bindPlaces(scene, body::placeBindPose(scene));
}

BindPlaces bindPlaces(const Scene& scene, const body::BindPose& bindPose) {
  const std::vector<std::vector<Vec3>> clouds = body::vertexClouds(scene, bindPose, body::RigidMeshes::all);
  BindPlaces places{bindPose.worlds, std::vector<Bounds>(clouds.size())};
  for (std::size_t node = 0; node < clouds.size(); ++node) {
    for (const Vec3& point : clouds[node]) {
      places.meshes[node].add(point);
    }
  }
  return places;
}

} // namespace stretch::rig
