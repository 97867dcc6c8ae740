#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/math/types.h"
#include "skinning/sequence/mesh_file.h"

namespace stretch::skinning {
namespace {

/// One polygon, seen along its normal.
class PolygonCutter {
public:
  PolygonCutter(std::span<const std::uint32_t> corners, std::span<const glm::vec3> positions) {
    for (const std::uint32_t corner : corners) {
      places_.emplace_back(positions[corner]);
    }
    for (std::size_t i = 2; i < places_.size(); ++i) {
      normal_ += glm::cross(places_[i - 1] - places_[0], places_[i] - places_[0]);
    }
    const double doubleArea = glm::length(normal_);
    normal_ = doubleArea > 0.0 ? normal_ / doubleArea : normal_;
    flat_ = 1e-6 * doubleArea; // Corners of single precision on a line are hardly ever exactly on it.
  }

  /// Adds the triangles, of corners counted from `first` on.
  void cut(std::uint32_t first, std::vector<Triangle>& triangles) const {
    constexpr std::size_t mostCorners = 500; // Ears take time by the square of their number, and more.
    std::vector<std::uint32_t> ring(places_.size());
    std::iota(ring.begin(), ring.end(), 0U);
    if (isFan() || ring.size() > mostCorners) {
      for (std::size_t i = 2; i < ring.size(); ++i) {
        triangles.push_back({first, first + ring[i - 1], first + ring[i]});
      }
      return;
    }
    std::size_t passed = 0; // Corners without an ear since the last one was cut off.
    for (std::size_t i = 1; ring.size() > 2;) {
      i %= ring.size();
      const bool isGivenUp = passed >= ring.size(); // It crosses itself.
      if (!isGivenUp && !isEar(ring, i)) {
        ++passed;
        ++i;
        continue;
      }
      const auto [before, after] = beside(ring, i);
      triangles.push_back({first + before, first + ring[i], first + after});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      passed = isGivenUp ? passed : 0;
    }
  }

private:
  static std::pair<std::uint32_t, std::uint32_t> beside(const std::vector<std::uint32_t>& ring,
                                                        std::size_t i) {
    return {ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()]};
  }

  /// Twice the area of the triangle as it is seen, negative where it is wound against the polygon.
  [[nodiscard]] double turn(std::size_t a, std::size_t b, std::size_t c) const {
    return glm::dot(glm::cross(places_[b] - places_[a], places_[c] - places_[a]), normal_);
  }

  [[nodiscard]] bool isFan() const {
    for (std::size_t i = 2; i < places_.size(); ++i) {
      if (turn(0, i - 1, i) < -flat_) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool isEar(const std::vector<std::uint32_t>& ring, std::size_t i) const {
    const auto [before, after] = beside(ring, i);
    const std::uint32_t tip = ring[i];
    return turn(before, tip, after) > flat_ &&
           std::ranges::none_of(ring, [&, before = before, after = after](std::uint32_t other) {
             return turn(before, tip, other) > flat_ && turn(tip, after, other) > flat_ &&
                    turn(after, before, other) > flat_;
           });
  }

  std::vector<Vec3> places_;
  Vec3 normal_{0.0};
  double flat_ = 0.0; ///< Areas up to this are none.
};

} // namespace

void cutIntoTriangles(MeshFile& mesh) {
  const Polygons& polygons = mesh.polygons;
  mesh.cuts.reserve(polygons.corners.size() - 2 * polygons.ends.size());
  std::size_t begin = 0;
  for (const std::size_t end : polygons.ends) {
    const auto corners = std::span(polygons.corners).subspan(begin, end - begin);
    const auto first = static_cast<std::uint32_t>(begin);
    if (corners.size() == 3) {
      mesh.cuts.push_back({first, first + 1, first + 2});
    } else {
      PolygonCutter(corners, mesh.positions).cut(first, mesh.cuts);
    }
    begin = end;
  }
  mesh.triangles.reserve(mesh.cuts.size());
  for (const auto& [a, b, c] : mesh.cuts) {
    mesh.triangles.push_back({polygons.corners[a], polygons.corners[b], polygons.corners[c]});
  }
}

} // namespace stretch::skinning
