#include "skinning/locate/upright.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "core/math/finite.h"
#include "skinning/bind/voxel_body.h"

namespace stretch::skinning {

namespace {

constexpr int coarse = 64; // cubes along the body: legs and arms are several thick

// Middles of the cubes of a body, and which places lie in it.
struct Lump {
  VoxelBody body;
  std::vector<Vec3> cells;
  std::vector<bool> isNear; ///< For each cube whether it or one beside it is a cell.
  Vec3 centroid{0.0};

  /// 1 in a cell, less beside one: bodies are modelled by hand.
  [[nodiscard]] double holds(const Vec3& point) const {
    const std::size_t cube = body.grid.indexOf(body.grid.placeOf(point));
    return (body.cellAt[cube] != VoxelBody::outside ? 0.5 : 0.0) + (isNear[cube] ? 0.5 : 0.0);
  }
};

struct Mirror {
  Vec3 normal{1.0, 0.0, 0.0};
  double offset = 0.0;
  double share = 0.0; ///< Of the cells that have their mirror image.
};

struct Stance {
  Vec3 up{0.0, 1.0, 0.0};
  Mirror mirror;
  double legs = 0.0;
  double score = -1.0;
};

// Of every few cells, `most` at most.
double mirroredShare(const Lump& lump, const Vec3& normal, double offset, std::size_t most) {
  const std::size_t stride = 1 + lump.cells.size() / most;
  double held = 0.0;
  double asked = 0.0;
  for (std::size_t cell = 0; cell < lump.cells.size(); cell += stride) {
    const Vec3& place = lump.cells[cell];
    held += lump.holds(place - 2.0 * (glm::dot(place, normal) - offset) * normal);
    asked += 1.0;
  }
  return held / asked;
}

// How much of the lowest part of a body is two legs with nothing between them.
double leggedShare(const Lump& lump, const Vec3& up, const Mirror& mirror) {
  constexpr int slices = 40;
  constexpr int lowest = 1;
  constexpr int highest = 6; // chibi figures have short legs
  std::array<std::array<std::size_t, 3>, slices> counts{};
  double low = std::numeric_limits<double>::max();
  double high = -low;
  for (const Vec3& cell : lump.cells) {
    low = std::min(low, glm::dot(cell, up));
    high = std::max(high, glm::dot(cell, up));
  }
  for (const Vec3& cell : lump.cells) {
    const double height = (glm::dot(cell, up) - low) / std::max(high - low, lump.body.grid.size);
    const double across = glm::dot(cell, mirror.normal) - mirror.offset;
    const auto slice = static_cast<std::size_t>(std::clamp(height * slices, 0.0, slices - 1.0));
    const bool isMiddle = std::abs(across) < 0.6 * lump.body.grid.size;
    ++counts[slice][isMiddle ? 0 : across > 0.0 ? 1 : 2];
  }
  double legged = 0.0;
  for (std::size_t slice = lowest; slice < highest; ++slice) {
    const auto& [middle, left, right] = counts[slice];
    legged += left > 0 && right > 0 && middle == 0 ? 1.0 : 0.0;
  }
  return legged / (highest - lowest);
}

// A better plane near one, to a degree and a quarter of a cube.
Mirror refined(const Lump& lump, const Vec3& up, const Mirror& rough) {
  const Vec3 second = glm::cross(up, rough.normal);
  Mirror best = rough;
  best.share = mirroredShare(lump, rough.normal, rough.offset, 20000);
  for (int degrees = -3; degrees <= 3; ++degrees) {
    const double angle = degrees * pi / 180.0;
    const Vec3 normal = std::cos(angle) * rough.normal + std::sin(angle) * second;
    const double middle = rough.offset + glm::dot(lump.centroid, normal - rough.normal);
    for (int quarters = -6; quarters <= 6; ++quarters) {
      const double offset = middle + 0.25 * quarters * lump.body.grid.size;
      const double share = mirroredShare(lump, normal, offset, 20000);
      if (share > best.share + 1e-9) {
        best = {normal, offset, share};
      }
    }
  }
  return best;
}

Stance stanceOf(const Lump& lump, const Vec3& up, const Vec3& across) {
  Stance best;
  const Vec3 second = glm::cross(up, across);
  for (int step = 0; step < 36; ++step) {
    const double angle = step * pi / 36.0;
    Stance stance;
    stance.up = up;
    const Vec3 normal = std::cos(angle) * across + std::sin(angle) * second;
    for (const double shift : {0.0, 1.5, -1.5, 3.0, -3.0}) {
      const double offset = glm::dot(lump.centroid, normal) + shift * lump.body.grid.size;
      const double share = mirroredShare(lump, normal, offset, 2000);
      if (share > stance.mirror.share + 1e-9) {
        stance.mirror = {normal, offset, share};
      }
    }
    stance.legs = leggedShare(lump, up, stance.mirror);
    stance.score = stance.mirror.share * (0.5 + stance.legs);
    if (stance.score > best.score + 1e-9) {
      best = stance;
    }
  }
  return best;
}

Result<Lump> lumpOf(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                    const Vec3& middle, double extent) {
  std::vector<glm::vec3> scaled(positions.size());
  std::ranges::transform(positions, scaled.begin(),
                         [&](const Vec3& position) { return glm::vec3((position - middle) / extent); });
  Result<VoxelBody> body = voxelBody(scaled, triangles, coarse);
  if (!body) {
    return body.error();
  }
  Lump lump{std::move(*body), {}, {}, {}};
  lump.isNear.assign(lump.body.cellAt.size(), false);
  for (std::size_t cell = 0; cell < lump.body.cellCount(); ++cell) {
    lump.cells.push_back(lump.body.middleOf(cell));
    lump.centroid += lump.cells.back();
    const std::array<int, 3> place = lump.body.grid.placeOfIndex(lump.body.cubeOf[cell]);
    for (int around = 0; around < 27; ++around) {
      lump.isNear[lump.body.grid.indexOf(
          {place[0] + around % 3 - 1, place[1] + around / 3 % 3 - 1, place[2] + around / 9 - 1})] = true;
    }
  }
  lump.centroid /= static_cast<double>(lump.cells.size());
  return lump;
}

Stance standing(const Lump& lump, UpAxis upAxis) {
  const Vec3 x(1.0, 0.0, 0.0);
  const Vec3 y(0.0, 1.0, 0.0);
  const Vec3 z(0.0, 0.0, 1.0);
  Stance best = stanceOf(lump, y, x);
  constexpr double asGood = 1.15; // another way up has to be better by so much than the scene's own
  best.score *= asGood;
  for (const auto& [up, across] :
       {std::pair{z, x}, std::pair{-z, x}, std::pair{-y, x}, std::pair{x, z}, std::pair{-x, z}}) {
    const Stance other = upAxis == UpAxis::ofScene ? Stance{} : stanceOf(lump, up, across);
    if (other.score > best.score) {
      best = other;
    }
  }
  best.mirror = refined(lump, best.up, best.mirror);
  return best;
}

// Towards +Z of the scene, or along +X where that is across.
Vec3 chosenSide(const Vec3& normal, const Vec3& up) {
  const Vec3 forward = glm::cross(normal, up);
  const double towards = std::abs(forward.z) > 1e-3   ? forward.z
                         : std::abs(forward.y) > 1e-3 ? forward.y
                                                      : forward.x;
  return towards < 0.0 ? -normal : normal;
}

} // namespace

Result<Upright> findUpright(std::span<const Vec3> positions, const std::vector<Triangle>& triangles,
                            UpAxis up) {
  Bounds box;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      if (!isFinite(positions[corner])) {
        return Error{"the mesh has places that are no numbers", "", ""};
      }
      box.add(positions[corner]);
    }
  }
  const double extent = box.empty() ? 0.0 : box.largestExtent();
  const Vec3 middle = box.empty() ? Vec3(0.0) : 0.5 * (box.low + box.high);
  const Result<Lump> lump = lumpOf(positions, triangles, middle, extent > 0.0 ? extent : 1.0);
  if (!lump) {
    return lump.error();
  }
  const Stance stance = standing(*lump, up);
  const Vec3 across = chosenSide(stance.mirror.normal, stance.up);
  Upright upright;
  upright.axes = {across, stance.up, glm::cross(across, stance.up)};
  upright.symmetry = stance.mirror.share;
  upright.legs = stance.legs;
  Bounds own;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      own.add(glm::transpose(upright.axes) * (positions[corner] - middle));
    }
  }
  upright.height = std::max(own.high.y - own.low.y, 1e-9 * extent);
  const double side = (across == stance.mirror.normal ? 1.0 : -1.0) * stance.mirror.offset * extent;
  upright.origin = middle + upright.axes * Vec3(side, own.low.y, 0.5 * (own.low.z + own.high.z));
  return upright;
}

} // namespace stretch::skinning
