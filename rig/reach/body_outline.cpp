#include "rig/reach/body_outline.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/index.h"
#include "rig/body/evidence/body_view.h"

namespace stretch::rig {

namespace {

// Evenly over all directions: a spiral of golden angles from pole to pole.
std::vector<Vec3> evenDirections() {
  constexpr int count = 48;
  const double goldenAngle = pi * (3.0 - std::sqrt(5.0));
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const double radius = std::sqrt(1.0 - y * y);
    directions.emplace_back(radius * std::cos(goldenAngle * i), y, radius * std::sin(goldenAngle * i));
  }
  return directions;
}

std::vector<Vec3> outermost(const std::vector<Vec3>& cloud, const std::vector<Vec3>& directions) {
  if (cloud.size() <= directions.size()) {
    return cloud;
  }
  std::vector<std::size_t> places;
  for (const Vec3& direction : directions) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < cloud.size(); ++i) {
      best = glm::dot(cloud[i] - cloud[best], direction) > 0.0 ? i : best;
    }
    places.push_back(best);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<Vec3> points;
  std::transform(places.begin(), places.end(), std::back_inserter(points),
                 [&](std::size_t i) { return cloud[i]; });
  return points;
}

} // namespace

BodyOutline outlineOf(const Scene& scene) {
  const std::vector<Vec3> directions = evenDirections();
  const body::BindPose bindPose = body::placeBindPose(scene);
  BodyOutline outline;
  outline.points = body::vertexClouds(scene, bindPose, body::RigidMeshes::all);
  for (std::size_t node = 0; node < outline.points.size(); ++node) {
    const Mat4& world = bindPose.worlds[node];
    std::vector<Vec3>& points = outline.points[node];
    points = glm::determinant(Mat3(world)) != 0.0 ? outermost(points, directions) : std::vector<Vec3>{};
    const Mat4 toNode = points.empty() ? Mat4(1.0) : glm::inverse(world);
    for (Vec3& point : points) {
      point = transformPoint(toNode, point);
    }
  }
  return outline;
}

std::vector<NodeIndex> outlined(const BodyOutline& outline, const std::vector<NodeIndex>& nodes) {
  std::vector<NodeIndex> some;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(some),
               [&](NodeIndex node) { return !outline.points[at(node)].empty(); });
  return some;
}

std::optional<double> lowestOf(const BodyOutline& outline, const std::vector<NodeIndex>& nodes,
                               const FrameState& frame) {
  std::optional<double> lowest;
  for (const NodeIndex node : nodes) {
    const Mat4 world = meshMatrix(frame, node);
    for (const Vec3& point : outline.points[at(node)]) {
      const double height = transformPoint(world, point).y;
      lowest = std::min(lowest.value_or(height), height);
    }
  }
  return lowest;
}

} // namespace stretch::rig
