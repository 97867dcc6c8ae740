#include "app/retarget/touch_body.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/base/index.h"
#include "core/math/bounds.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

// From the wrist to nine tenths of the vertices.
double sizeOf(const std::vector<Vec3>& places, const std::vector<std::size_t>& vertices, const Vec3& wrist) {
  std::vector<double> distances;
  distances.reserve(vertices.size());
  for (const std::size_t vertex : vertices) {
    distances.push_back(glm::length(places[vertex] - wrist));
  }
  if (distances.empty()) {
    return 0.0;
  }
  const auto place = distances.begin() + static_cast<std::ptrdiff_t>(9 * (distances.size() - 1) / 10);
  std::ranges::nth_element(distances, place);
  return *place;
}

// Triangles by the columns along z that they reach into: finds out sooner than the winding number what has no
// surface on both sides, and so is outside.
class Columns {
public:
  Columns(const skinning::PlacedSurface& surface, const Bounds& box) : surface_(surface), box_(box) {
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      Bounds triangle;
      for (const std::uint32_t vertex : surface.triangles[i]) {
        triangle.add(surface.places[vertex]);
      }
      for (int x = cellOf(triangle.low, 0); x <= cellOf(triangle.high, 0); ++x) {
        for (int y = cellOf(triangle.low, 1); y <= cellOf(triangle.high, 1); ++y) {
          cells_[at(x * count + y)].push_back(surface.triangles[i]);
          ++entries_;
        }
      }
      if (entries_ > mostEntries) {
        cells_ = {};
        return;
      }
    }
  }

  /// True of all places where the triangles are too large for columns to tell.
  [[nodiscard]] bool isBetween(const Vec3& place) const {
    if (entries_ > mostEntries) {
      return true;
    }
    const skinning::PlacedSurface here{surface_.places,
                                       cells_[at(cellOf(place, 0) * count + cellOf(place, 1))]};
    return !skinning::crossedBy(here, place, Vec3(0.0, 0.0, 1.0)).empty() &&
           !skinning::crossedBy(here, place, Vec3(0.0, 0.0, -1.0)).empty();
  }

private:
  static constexpr int count = 24;
  static constexpr std::size_t mostEntries = 4'000'000;

  [[nodiscard]] int cellOf(const Vec3& place, int axis) const {
    const double size = box_.high[axis] - box_.low[axis];
    return size > 0.0
               ? static_cast<int>(std::clamp(count * (place[axis] - box_.low[axis]) / size, 0.0, count - 1.0))
               : 0;
  }

  const skinning::PlacedSurface& surface_;
  Bounds box_;
  std::size_t entries_ = 0;
  std::array<std::vector<Triangle>, static_cast<std::size_t>(count* count)> cells_;
};

} // namespace

std::vector<NearVertex> nearVertices(const skinning::PlacedSurface& surface,
                                     const std::vector<std::size_t>& vertices, double limit) {
  std::vector<NearVertex> found;
  for (const std::size_t vertex : vertices) {
    const Vec3& place = surface.places[vertex];
    if (const std::optional<skinning::SurfacePoint> point = skinning::nearestOn(surface, place, limit)) {
      found.push_back({vertex, *point, glm::length(skinning::placeOf(surface, *point) - place)});
    }
  }
  return found;
}

TouchBody::TouchBody(const rig::Skeleton& body)
    : skeleton(body), parts(bodyPartsOf(body)), chart(body, parts) {
  constexpr std::size_t mostOfHand = 100;
  constexpr std::size_t mostOfForearm = 60;
  const std::vector<Vec3> places = placesOf(body.bind);
  for (const std::size_t side : {rig::leftSide, rig::rightSide}) {
    hands[side] = thinned(parts.arms[side].hand, mostOfHand);
    arms[side] = hands[side];
    const std::vector<std::size_t> forearm = thinned(parts.arms[side].forearm, mostOfForearm);
    arms[side].insert(arms[side].end(), forearm.begin(), forearm.end());
    for (const NearVertex& inside : inTrunk(places, side)) {
      std::erase(arms[side], inside.vertex);
    }
    constexpr double least = 1e-3; // of the height
    handSizes[side] = least * body.height;
    if (body.arms[side]) {
      handSizes[side] = std::max(handSizes[side], sizeOf(places, hands[side], wrist(body.bind, side)));
    }
  }
}

bool TouchBody::hasSurface() const {
  return !parts.trunk.empty() && !(arms[rig::leftSide].empty() && arms[rig::rightSide].empty());
}

std::vector<Vec3> TouchBody::placesOf(const std::vector<Mat4>& worlds) const {
  return skinning::skinnedPositions(*skeleton.scene, {0.0, restPose(*skeleton.scene), worlds, {}});
}

std::vector<NearVertex> TouchBody::nearTrunk(const std::vector<Vec3>& places, std::size_t side,
                                             double limit) const {
  return nearVertices({places, parts.trunk}, hands[side], limit);
}

std::vector<NearVertex> TouchBody::inTrunk(const std::vector<Vec3>& places, std::size_t side) const {
  constexpr double isInside = 0.5; // of the winding number
  Bounds box;
  for (const Triangle& triangle : parts.trunk) {
    for (const std::uint32_t vertex : triangle) {
      box.add(places[vertex]);
    }
  }
  std::vector<std::size_t> near;
  std::ranges::copy_if(arms[side], std::back_inserter(near), [&](std::size_t vertex) {
    const Vec3& place = places[vertex];
    return glm::all(glm::greaterThanEqual(place, box.low)) && glm::all(glm::lessThanEqual(place, box.high));
  });
  if (near.empty()) {
    return {};
  }
  const skinning::PlacedSurface surface{places, parts.trunk};
  const Columns columns(surface, box);
  std::vector<std::size_t> inside;
  for (const std::size_t vertex : near) {
    const Vec3& place = places[vertex];
    if (columns.isBetween(place) && skinning::windingNumber(surface, place) > isInside) {
      inside.push_back(vertex);
    }
  }
  return nearVertices(surface, inside, std::numeric_limits<double>::infinity());
}

double TouchBody::depthOf(const std::vector<Vec3>& places, std::size_t side) const {
  double deepest = 0.0;
  for (const NearVertex& inside : inTrunk(places, side)) {
    deepest = std::max(deepest, inside.distance / skeleton.height);
  }
  return deepest;
}

Vec3 TouchBody::wrist(const std::vector<Mat4>& worlds, std::size_t side) const {
  return rig::endPosition(skeleton.arms[side]->limb, worlds);
}

} // namespace stretch::app
