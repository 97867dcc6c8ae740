#include "tests/support/skinning/bodies.h"

#include <algorithm>
#include <cmath>

#include "tests/support/skinning/shapes.h"

namespace stretch::test {

using skinning::Influences;
using skinning::SkinnedSequence;

SkinnedSequence wavingTube(int bones, int frames) {
  const double length = 10.0;
  const Shape shape = tube(length, 0.5, 60, 12);
  SkinnedSequence skinned;
  skinned.name = "tube";
  skinned.bindPositions = shape.positions;
  skinned.triangles = shape.triangles;
  skinned.chained = true;
  const double bone = length / bones;
  for (int b = 0; b < bones; ++b) {
    skinned.bones.push_back(
        {Vec3(b * bone, 0.0, 0.0), Vec3((b + 1) * bone, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0)});
  }
  for (const glm::vec3& p : shape.positions) {
    const double at = std::clamp(static_cast<double>(p.x) / bone - 0.5, 0.0, bones - 1.0);
    const int lower = std::min(static_cast<int>(at), bones - 2);
    const double blend = std::clamp((at - lower - 0.5) * 3.0 + 0.5, 0.0, 1.0);
    Influences influences;
    influences.bones = {static_cast<std::uint16_t>(lower), static_cast<std::uint16_t>(lower + 1), 0, 0};
    influences.weights = {static_cast<float>(1.0 - blend), static_cast<float>(blend), 0.0F, 0.0F};
    skinned.influences.push_back(influences);
  }
  for (int k = 0; k < frames; ++k) {
    Vec3 position(0.02 * k, 0.0, 0.0);
    for (int b = 0; b < bones; ++b) {
      const double swell = std::min(1.0, k / 8.0);
      const double angle = 0.5 * swell * std::sin(0.9 * b - 0.35 * k);
      const Quat rotation = glm::angleAxis(angle, Vec3(0.0, 1.0, 0.0));
      skinned.poses.push_back({position, rotation, Vec3(1.0), Quat(1.0, 0.0, 0.0, 0.0)});
      position += rotation * Vec3(bone, 0.0, 0.0);
    }
  }
  return skinned;
}

MeshSequence shorteningTube(int frames, double largestCurvature, double shortening, double flattening) {
  const double length = 10.0;
  MeshSequence sequence = still(tube(length, 0.5, 60, 16));
  sequence.name = "arc";
  const auto rest = sequence.positions;
  sequence.frameNames.clear();
  sequence.positions.clear();
  for (int k = 0; k < frames; ++k) {
    const double curvature = largestCurvature * k / std::max(frames - 1, 1);
    const double scale = k == 0 ? 1.0 : 1.0 - shortening * curvature;
    const double flat = k == 0 ? 1.0 : 1.0 - flattening;
    for (const glm::vec3& p : rest) {
      const double across = static_cast<double>(p.z) / flat / std::sqrt(scale);
      const double up = static_cast<double>(p.y) * flat / std::sqrt(scale);
      const double along = static_cast<double>(p.x) * scale;
      const double radius = curvature > 0.0 ? length * scale / curvature : 0.0;
      const double angle = curvature > 0.0 ? along / radius : 0.0;
      const Vec3 posed = curvature > 0.0 ? Vec3((radius + across) * std::sin(angle), up,
                                                (radius + across) * std::cos(angle) - radius)
                                         : Vec3(along, up, across);
      sequence.positions.emplace_back(posed);
    }
    sequence.frameNames.push_back("frame " + std::to_string(k));
  }
  return sequence;
}

} // namespace stretch::test
