#include "skinning/bind/bind_weights.h"

#include <algorithm>
#include <limits>

#include <tbb/parallel_for.h>

#include "skinning/bind/stiff_shells.h"
#include "skinning/bind/voxel_body.h"
#include "skinning/bind/weight_blend.h"
#include "skinning/weights/geodesic_weights.h"

namespace stretch::skinning {

namespace {

double distanceTo(const BoneLine& line, const Vec3& point) {
  const Vec3 along = line.end - line.start;
  const double squared = glm::dot(along, along);
  const double part =
      squared > 0.0 ? std::clamp(glm::dot(point - line.start, along) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(point, line.start + part * along);
}

// Cells that no bone reaches inside, those of shells of their own, go to the bone that is nearest in space.
void giveTheRest(const VoxelBody& body, const std::vector<BoneLine>& lines, const std::vector<double>& radii,
                 double sections, std::vector<std::uint16_t>& owners) {
  tbb::parallel_for(std::size_t{0}, owners.size(), [&](std::size_t cell) {
    if (owners[cell] != nobody) {
      return;
    }
    const Vec3 middle = body.middleOf(cell);
    double nearest = std::numeric_limits<double>::max();
    for (const BoneLine& line : lines) {
      const double distance = distanceTo(line, middle) - sections * radii[line.joint];
      if (distance < nearest) {
        nearest = distance;
        owners[cell] = line.joint;
      }
    }
  });
}

// What a point follows: between the middles of cells, those around it mixed.
std::vector<double> weightsAt(const VoxelBody& body, const std::vector<CellWeights>& cells, const Vec3& point,
                              std::size_t joints) {
  std::vector<double> weights(joints, 0.0);
  const auto take = [&](const CellWeights& cell, double factor) {
    for (std::size_t i = 0; i < CellWeights::capacity; ++i) {
      weights[cell.joints[i]] += factor * static_cast<double>(cell.weights[i]);
    }
  };
  const Vec3 local = (point - body.grid.origin) / body.grid.size - 0.5;
  const Vec3 base = glm::floor(local);
  bool isMet = false;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> place{};
    double factor = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const int side = (corner >> axis) & 1;
      const double part = local[axis] - base[axis];
      place[static_cast<std::size_t>(axis)] = static_cast<int>(base[axis]) + side;
      factor *= side == 1 ? part : 1.0 - part;
    }
    const std::int32_t cell = body.cellAt[body.grid.indexOf(place)];
    if (cell != VoxelBody::outside && factor > 0.0) {
      take(cells[static_cast<std::size_t>(cell)], factor);
      isMet = true;
    }
  }
  if (!isMet) {
    // A vertex of no triangle: nothing was filled where it is.
    constexpr int cubesAround = 3;
    const std::int32_t cell = body.cellNear(point, cubesAround);
    weights[0] = cell == VoxelBody::outside ? 1.0 : 0.0;
    if (cell != VoxelBody::outside) {
      take(cells[static_cast<std::size_t>(cell)], 1.0);
    }
  }
  return weights;
}

Status checkJoints(const std::vector<BindJoint>& joints) {
  if (joints.empty()) {
    return Error{"there are no joints to bind to", "", "give a skeleton"};
  }
  if (joints.size() >= nobody) {
    return Error{"more joints than a skin can name", "", "bind to fewer"};
  }
  return Success{};
}

} // namespace

Result<std::vector<Influences>> bindWeights(std::span<const glm::vec3> positions,
                                            const std::vector<Triangle>& triangles,
                                            const std::vector<BindJoint>& joints,
                                            const BindSettings& settings) {
  if (Status usable = checkJoints(joints); !usable) {
    return usable.error();
  }
  const Result<VoxelBody> body = voxelBody(positions, triangles, settings.cubesAlong);
  if (!body) {
    return body.error();
  }
  const std::vector<BoneLine> lines = boneLines(*body, joints);
  const std::vector<BoneCell> bones = boneCells(*body, lines);
  const std::vector<double> radii = boneRadii(*body, bones, joints.size());
  std::vector<std::uint16_t> owners = boneRegions(*body, bones, radii, settings.sections);
  giveTheRest(*body, lines, radii, settings.sections, owners);
  const std::vector<CellWeights> cells = blendedRegions(*body, owners, radii, settings.blend);
  std::vector<std::vector<double>> weights(positions.size());
  tbb::parallel_for(std::size_t{0}, positions.size(), [&](std::size_t v) {
    weights[v] = weightsAt(*body, cells, Vec3(positions[v]), joints.size());
  });
  stiffenShells(positions, triangles, lines, weights);
  std::vector<Influences> influences(positions.size());
  std::transform(weights.begin(), weights.end(), influences.begin(), strongestFour);
  return influences;
}

} // namespace stretch::skinning
