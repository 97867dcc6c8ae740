#include "skinning/compress/flattening.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"

namespace stretch::skinning {
namespace {

constexpr int segments = 25;

struct Extents {
  double along = 0.0;
  double across = 0.0;
};

/// Size of the cross-section in the middle of the body: vertices within 2 % of its length.
Extents middleExtents(const MeshSequence& sequence, const BodyMotion& body, const Vec3& gravity) {
  const std::size_t last = sequence.frameCount() - 1;
  const auto& joints = body.joints[last];
  const Vec3 axis = glm::normalize(joints[segments / 2 + 1] - joints[segments / 2]);
  const Vec3 up = -glm::normalize(gravity - glm::dot(gravity, axis) * axis);
  const Vec3 side = glm::cross(axis, up);
  const double first = body.skeleton.stations.front();
  const double length = body.skeleton.stations.back() - first;
  Vec2 low(std::numeric_limits<double>::max());
  Vec2 high(std::numeric_limits<double>::lowest());
  for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
    if (std::abs((body.skeleton.along[v] - first) / length - 0.5) < 0.02) {
      const Vec3 p(sequence.frame(last)[v]);
      const Vec2 at(glm::dot(p, up), glm::dot(p, side));
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
  }
  return {high.x - low.x, high.y - low.y};
}

double closestCompression(double height, double width) {
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 5000; ++i) {
    const double q = largestCompression * i / 5000.0;
    const double off = std::pow(1.0 - q - height, 2.0) + std::pow(1.0 / (1.0 - q) - width, 2.0);
    if (off < least) {
      least = off;
      best = q;
    }
  }
  return best;
}

} // namespace

Result<Flattening> gravityFlattening(const MeshSequence& with, const MeshSequence& without,
                                     const BodyStretchSettings& settings) {
  if (with.vertexCount != without.vertexCount || with.triangles.size() != without.triangles.size()) {
    return Error{"the two runs are of different meshes", with.name + " and " + without.name,
                 "compare runs of one body"};
  }
  if (!(glm::length(settings.gravity) > 0.0)) {
    return Error{"without gravity there is nothing to compare", "gravity", "give its direction and size"};
  }
  const auto loaded = analyseBody(with, segments);
  const auto free = analyseBody(without, segments);
  if (!loaded || !free) {
    return loaded ? free.error() : loaded.error();
  }
  const Extents a = middleExtents(with, *loaded, settings.gravity);
  const Extents b = middleExtents(without, *free, settings.gravity);
  Flattening result;
  result.height = a.along / b.along;
  result.width = a.across / b.across;
  result.length = polylineLength(loaded->joints.back()) / polylineLength(free->joints.back());
  result.compression = closestCompression(result.height, result.width);
  result.predictedHeight = 1.0 - result.compression;
  result.predictedWidth = 1.0 / (1.0 - result.compression);
  BodyStretchSettings unit = settings;
  unit.youngModulus = 1e9; // Any stiff one: the compression is inversely proportional to it.
  const auto stiff = stretchOfBody(*loaded, unit);
  if (!stiff) {
    return stiff.error();
  }
  const double loading = stiff->compressions[segments / 2] * 1e9;
  result.youngModulus = result.compression > 0.0 ? loading / result.compression : 0.0;
  return result;
}

} // namespace stretch::skinning
