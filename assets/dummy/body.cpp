#include "assets/dummy/body.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "assets/dummy/body_shape.h"
#include "assets/dummy/paint.h"
#include "assets/dummy/remesh.h"
#include "assets/dummy/weights.h"

namespace stretch::assets {

namespace {

/// Small triangles where the shape is small.
double wantedEdgeLength(const Vec3& point) {
  const Vec3 p(std::abs(point.x), point.y, point.z);
  struct Detail {
    Vec3 center;
    double radius;
    double edgeLength;
  };
  constexpr std::array<Detail, 11> details{{{{0.0, 1.565, 0.13}, 0.06, 0.0110},
                                            {{0.14, 1.575, -0.01}, 0.05, 0.0115},
                                            {{0.0, 1.78, 0.11}, 0.03, 0.0110},
                                            {{0.0, 1.60, 0.0}, 0.20, 0.0185},
                                            {{0.66, 0.94, 0.05}, 0.17, 0.0160},
                                            {{0.56, 1.03, 0.02}, 0.08, 0.0170},
                                            {{0.13, 0.03, 0.04}, 0.20, 0.0185},
                                            {{0.0, 1.008, 0.0}, 0.17, 0.0225},
                                            {{0.386, 1.186, -0.03}, 0.10, 0.0170},
                                            {{0.29, 1.27, -0.02}, 0.12, 0.0195},
                                            {{0.112, 0.492, 0.016}, 0.12, 0.0200}}};
  double length = 0.027;
  for (const Detail& detail : details) {
    const double outside = std::max(0.0, glm::length(p - detail.center) - detail.radius);
    length = std::min(length, detail.edgeLength + 0.25 * outside);
  }
  return length;
}

SurfaceMesh bodySurface() {
  const SurfaceMesh raw = polygonize(bodyDistance, {-0.80, -0.03, -0.20}, {0.80, 1.84, 0.26}, 0.010);
  const SurfaceMesh even = remesh(raw, {wantedEdgeLength, projectToBody, bodyNormal, 8});
  return cutAlongRegions(even);
}

Region regionOf(const SurfaceMesh& surface, const std::array<int, 3>& triangle) {
  const auto position = [&](int v) { return surface.positions[static_cast<std::size_t>(v)]; };
  return regionAt((position(triangle[0]) + position(triangle[1]) + position(triangle[2])) / 3.0);
}

} // namespace

SkinnedMesh makeBody(const std::vector<Joint>& skeleton) {
  const SurfaceMesh surface = bodySurface();
  const std::vector<Influences> influences = smoothWeights(surface, skeleton);
  SkinnedMesh body;
  std::map<std::pair<int, Region>, int> vertexOf;
  for (const auto& triangle : surface.triangles) {
    const Region region = regionOf(surface, triangle);
    std::array<int, 3> painted{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [entry, isNew] =
          vertexOf.try_emplace({triangle[corner], region}, static_cast<int>(body.vertices.size()));
      if (isNew) {
        const Vec3& position = surface.positions[static_cast<std::size_t>(triangle[corner])];
        const Vec3 normal = regionNormal(region, position);
        body.vertices.push_back({position, normal, paintedColor(region, position, normal),
                                 influences[static_cast<std::size_t>(triangle[corner])]});
      }
      painted[corner] = entry->second;
    }
    body.triangles.push_back(painted);
  }
  return body;
}

} // namespace stretch::assets
