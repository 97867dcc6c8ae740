#include "skinning/bind/bone_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/math/median.h"

namespace stretch::skinning {

namespace {

// How far a line runs inside the body, from a point on.
double lengthInside(const VoxelBody& body, const Vec3& start, const Vec3& direction, double most) {
  double length = 0.0;
  while (length < most && body.cellAt[body.grid.indexOf(body.grid.placeOf(start + direction * length))] !=
                              VoxelBody::outside) {
    length += 0.5 * body.grid.size;
  }
  return length;
}

// Where the bone of a last joint ends.
Vec3 endOf(const VoxelBody& body, const Vec3& place, const Vec3& along) {
  const double length = glm::length(along);
  if (length <= 0.0) {
    return place;
  }
  constexpr double mostOfBody = 0.25;
  constexpr double share = 0.8; // what is beyond is the end's own roundness
  const int cubes = *std::max_element(body.grid.counts.begin(), body.grid.counts.end());
  return place + along / length *
                     (share * lengthInside(body, place, along / length, mostOfBody * cubes * body.grid.size));
}

// Where a sibling stands that a last joint lies on the way to, and that goes on from there: the last one is a
// twist joint of the bone that ends at it.
std::optional<Vec3> siblingAhead(const std::vector<BindJoint>& joints, const std::vector<bool>& isLast,
                                 std::size_t joint, const Vec3& along) {
  constexpr double leastCosine = 0.95;
  for (std::size_t other = 0; other < joints.size(); ++other) {
    const Vec3 way = joints[other].place - joints[joint].place;
    if (!isLast[other] && joints[other].parent == joints[joint].parent &&
        glm::dot(way, along) > leastCosine * glm::length(way) * glm::length(along)) {
      return joints[other].place;
    }
  }
  return {};
}

// Whether a child stands where the bone of its parent leads.
bool isAhead(const BindJoint& parent, const Vec3& child) {
  constexpr double leastCosine = 0.9;
  const Vec3 way = child - parent.place;
  return glm::dot(way, parent.forward) > leastCosine * glm::length(way);
}

// Joints whose bones lead to a child: their other children stand beside the bone.
std::vector<bool> leadingToChildren(const std::vector<BindJoint>& joints) {
  std::vector<bool> isLeading(joints.size(), false);
  for (const BindJoint& joint : joints) {
    if (joint.parent >= 0) {
      const auto parent = static_cast<std::size_t>(joint.parent);
      isLeading[parent] = isLeading[parent] || isAhead(joints[parent], joint.place);
    }
  }
  return isLeading;
}

bool isBeside(const std::vector<BindJoint>& joints, const std::vector<bool>& isLeading, std::size_t child) {
  const int parent = joints[child].parent;
  return parent >= 0 && isLeading[static_cast<std::size_t>(parent)] &&
         !isAhead(joints[static_cast<std::size_t>(parent)], joints[child].place);
}

BoneLine lineTo(const std::vector<BindJoint>& joints, std::size_t child) {
  const auto parent = static_cast<std::size_t>(joints[child].parent);
  return {static_cast<std::uint16_t>(parent), joints[parent].place, joints[child].place,
          static_cast<int>(child)};
}

// A short thick bone that begins deep in the body, deeper than it is thick: what lies about its joint is its
// parent's.
bool isSunkStub(const VoxelBody& body, const Vec3& place, double radius, double length) {
  constexpr double deeper = 1.1;
  constexpr double shortOfRadius = 2.5;
  constexpr int cubesAround = 3;
  const std::int32_t cell = body.cellNear(place, cubesAround);
  return cell != VoxelBody::outside &&
         length<shortOfRadius * radius&& static_cast<double>(body.depths[static_cast<std::size_t>(cell)])>
                 deeper * radius;
}

struct Shares {
  double from = 0.0;
  double to = 1.0;
};

// The part of a line within the box of the cubes; empty where `to` is below `from`.
Shares withinBox(const VoxelGrid& grid, const BoneLine& line) {
  Shares part;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<glm::length_t>(axis);
    const double way = line.end[i] - line.start[i];
    const double low = grid.origin[i] - line.start[i];
    const double high = low + grid.size * grid.counts[axis];
    if (way == 0.0) {
      part.to = low <= 0.0 && high >= 0.0 ? part.to : -1.0;
    } else {
      part.from = std::max(part.from, std::min(low / way, high / way));
      part.to = std::min(part.to, std::max(low / way, high / way));
    }
  }
  return part;
}

} // namespace

std::vector<BoneLine> boneLines(const VoxelBody& body, const std::vector<BindJoint>& joints) {
  std::vector<BoneLine> lines =
      boneLines(joints, [&](const Vec3& place, const Vec3& along) { return endOf(body, place, along); });
  const std::vector<double> radii = boneRadii(body, lines, boneCells(body, lines), joints.size());
  std::vector<double> lengths(joints.size(), 0.0);
  for (const BoneLine& line : lines) {
    lengths[line.joint] = std::max(lengths[line.joint], glm::distance(line.start, line.end));
  }
  const std::vector<bool> isLeading = leadingToChildren(joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (isBeside(joints, isLeading, i) && isSunkStub(body, joints[i].place, radii[i], lengths[i])) {
      lines.push_back(lineTo(joints, i));
    }
  }
  return lines;
}

std::vector<BoneLine> boneLines(const std::vector<BindJoint>& joints,
                                const std::function<Vec3(const Vec3& place, const Vec3& along)>& endOfLast) {
  std::vector<BoneLine> lines;
  std::vector<bool> isLast(joints.size(), true);
  const std::vector<bool> isLeading = leadingToChildren(joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].parent >= 0) {
      isLast[static_cast<std::size_t>(joints[i].parent)] = false;
      if (!isBeside(joints, isLeading, i)) {
        lines.push_back(lineTo(joints, i));
      }
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (isLast[i]) {
      const BindJoint& joint = joints[i];
      const Vec3 before =
          joint.parent < 0 ? joint.place : joints[static_cast<std::size_t>(joint.parent)].place;
      // As long as the bone before it: ways that know no body go by that.
      const double length = glm::distance(joint.place, before);
      const Vec3 along =
          joint.forward != Vec3(0.0) && length > 0.0 ? length * joint.forward : joint.place - before;
      const std::optional<Vec3> ahead = siblingAhead(joints, isLast, i, along);
      lines.push_back(
          {static_cast<std::uint16_t>(i), joint.place, ahead ? *ahead : endOfLast(joint.place, along)});
    }
  }
  return lines;
}

std::vector<BoneCell> boneCells(const VoxelBody& body, const std::vector<BoneLine>& lines) {
  constexpr int cubesAround = 3;           // a joint may lie just outside of a thin part
  constexpr double mostHalfCubes = 2000.0; // of a bone that is looked at all along: several times a body
  std::vector<BoneCell> cells;
  for (std::size_t index = 0; index < lines.size(); ++index) {
    const BoneLine& line = lines[index];
    const double halfCubes = 2.0 * glm::distance(line.start, line.end) / body.grid.size;
    const Shares part = halfCubes > mostHalfCubes ? withinBox(body.grid, line) : Shares();
    if (part.to < part.from) {
      continue;
    }
    const int steps = std::max(1, static_cast<int>(std::ceil((part.to - part.from) * halfCubes)));
    for (int i = 0; i <= steps; ++i) {
      const double along = part.from + (part.to - part.from) * i / steps;
      const Vec3 point = glm::mix(line.start, line.end, along);
      const std::int32_t cell = body.cellNear(point, cubesAround);
      if (cell != VoxelBody::outside) {
        const auto met = static_cast<std::size_t>(cell);
        cells.push_back({met, static_cast<std::uint32_t>(index), static_cast<float>(along),
                         glm::distance(point, body.middleOf(met))});
      }
    }
  }
  return cells;
}

std::vector<double> boneRadii(const VoxelBody& body, const std::vector<BoneLine>& lines,
                              const std::vector<BoneCell>& cells, std::size_t jointCount) {
  std::vector<std::vector<double>> depths(jointCount);
  for (const BoneCell& cell : cells) {
    depths[lines[cell.line].joint].push_back(static_cast<double>(body.depths[cell.cell]));
  }
  std::vector<double> radii(jointCount, body.grid.size);
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    radii[joint] = medianOf(std::move(depths[joint]), radii[joint]);
  }
  return radii;
}

} // namespace stretch::skinning
