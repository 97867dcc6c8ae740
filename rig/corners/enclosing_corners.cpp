#include "rig/corners/enclosing_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/bounds.h"
#include "core/math/rotation.h"

namespace stretch::rig {

namespace {

constexpr std::size_t sides = 4;
using Normals = std::array<Vec3, sides>;
using Heights = std::array<double, sides>;

constexpr double margin = 1e-6; // of a height: what rounding takes

// Normals of a regular tetrahedron, turned.
Normals normalsTurned(const Quat& turn) {
  const double unit = 1.0 / std::sqrt(3.0);
  return {turn * Vec3(unit, unit, unit), turn * Vec3(unit, -unit, -unit), turn * Vec3(-unit, unit, -unit),
          turn * Vec3(-unit, -unit, unit)};
}

// How far the points reach along each normal.
Heights heightsOf(const std::vector<Vec3>& points, const Normals& normals) {
  Heights heights{};
  for (std::size_t side = 0; side < sides; ++side) {
    double& height = heights[side] = std::numeric_limits<double>::lowest();
    for (const Vec3& point : points) {
      height = std::max(height, glm::dot(normals[side], point));
    }
    height += margin;
  }
  return heights;
}

double sizeOf(const Heights& heights) {
  return heights[0] + heights[1] + heights[2] + heights[3];
}

// Turns of the tetrahedron to try: twists about each axis, which bring edges or faces to the ends.
std::vector<Quat> turnsToTry() {
  constexpr int steps = 4;
  std::vector<Quat> turns;
  for (int x = 0; x < steps; ++x) {
    for (int y = 0; y < steps; ++y) {
      for (int z = 0; z < steps; ++z) {
        constexpr double step = pi / 2.0 / steps;
        turns.push_back(axisAngle(Vec3(1, 0, 0), x * step) * axisAngle(Vec3(0, 1, 0), y * step) *
                        axisAngle(Vec3(0, 0, 1), z * step));
      }
    }
  }
  return turns;
}

// The point in three of the four sides, which is the corner across from the fourth.
Vec3 cornerAcross(std::size_t apart, const Normals& normals, const Heights& heights) {
  Mat3 rows(0.0);
  Vec3 wanted(0.0);
  int row = 0;
  for (std::size_t side = 0; side < sides; ++side) {
    if (side != apart) {
      for (int column = 0; column < 3; ++column) {
        rows[column][row] = normals[side][column];
      }
      wanted[row++] = heights[side];
    }
  }
  return glm::inverse(rows) * wanted;
}

} // namespace

std::vector<Vec3> enclosingTetrahedron(const std::vector<Vec3>& points, const Quat& axes) {
  constexpr double thinnest = 1e-3; // of the longest side
  std::vector<Vec3> seen;
  Bounds box;
  for (const Vec3& point : points) {
    seen.push_back(glm::inverse(axes) * point);
    box.add(seen.back());
  }
  const Vec3 centre = 0.5 * (box.low + box.high);
  const double farthest = glm::length(centre);
  const double longest = std::max(box.largestExtent(), farthest > 0.0 ? thinnest * farthest : 1.0);
  const Vec3 half = 0.5 * glm::max(box.high - box.low, Vec3(thinnest * longest));
  for (Vec3& point : seen) {
    point = (point - centre) / half;
  }
  Normals normals = normalsTurned(Quat(1.0, 0.0, 0.0, 0.0));
  Heights heights = heightsOf(seen, normals);
  for (const Quat& turn : turnsToTry()) {
    const Normals tried = normalsTurned(turn);
    const Heights reached = heightsOf(seen, tried);
    if (sizeOf(reached) < sizeOf(heights)) {
      normals = tried;
      heights = reached;
    }
  }
  std::vector<Vec3> corners;
  for (std::size_t side = 0; side < sides; ++side) {
    corners.push_back(axes * (centre + half * cornerAcross(side, normals, heights)));
  }
  return corners;
}

std::vector<Vec3> enclosingEnds(const std::vector<Vec3>& points, const Vec3& direction) {
  double low = 0.0;
  double high = 0.0;
  for (const Vec3& point : points) {
    low = std::min(low, glm::dot(point, direction));
    high = std::max(high, glm::dot(point, direction));
  }
  std::vector<Vec3> ends;
  for (const double end : {low, high}) {
    if (std::abs(end) > margin * (high - low)) {
      ends.push_back(end * direction);
    }
  }
  return ends;
}

std::vector<double> affineCoordinates(const std::vector<Vec3>& corners, const Vec3& point) {
  std::vector<double> shares;
  if (corners.size() < sides) {
    for (const Vec3& end : corners) {
      shares.push_back(std::clamp(glm::dot(point, end) / glm::dot(end, end), 0.0, 1.0));
    }
    return shares;
  }
  const Vec3& base = corners[3];
  const Vec3 three =
      glm::inverse(Mat3(corners[0] - base, corners[1] - base, corners[2] - base)) * (point - base);
  shares = {three.x, three.y, three.z, 1.0 - three.x - three.y - three.z};
  double sum = 0.0;
  for (double& share : shares) {
    share = std::max(share, 0.0);
    sum += share;
  }
  for (double& share : shares) {
    share /= sum;
  }
  return shares;
}

} // namespace stretch::rig
