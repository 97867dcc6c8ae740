#include "tests/support/skinning/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

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

namespace {

struct BodyPart {
  const char* name;
  int parent;
  Vec3 pivot;
  Vec3 end;
  double swing; ///< Radians, about z.
  double phase;
};

const std::array<BodyPart, 6>& partsOfArmedBody() {
  static const std::array<BodyPart, 6> parts{{{"trunk", -1, {0, -9, 0}, {0, 3, 0}, 0.05, 0.0},
                                              {"head", 0, {0, 3, 0}, {0, 9, 0}, 0.5, 1.0},
                                              {"upper_left", 0, {1, 1, 0}, {5, 1, 0}, 0.7, 2.0},
                                              {"lower_left", 2, {5, 1, 0}, {9, 1, 0}, 0.9, 0.5},
                                              {"upper_right", 0, {-1, 1, 0}, {-5, 1, 0}, 0.7, 4.0},
                                              {"lower_right", 4, {-5, 1, 0}, {-9, 1, 0}, 0.9, 3.0}}};
  return parts;
}

/// How far outside of a part's span a place is, along the part: negative inside.
double beyond(const BodyPart& part, const Vec3& place) {
  const Vec3 along = part.end - part.pivot;
  const double length = glm::length(along);
  const double at = glm::dot(place - part.pivot, along) / length;
  const double across = glm::length(place - part.pivot - at * along / length);
  return std::max(std::max(-at, at - length), across - 1.5);
}

Influences influencesAt(const Vec3& place) {
  std::array<double, 6> weights{};
  double sum = 0.0;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    weights[b] = std::exp(-4.0 * std::max(0.0, beyond(partsOfArmedBody()[b], place) + 0.2));
    weights[b] = weights[b] < 0.05 ? 0.0 : weights[b] * weights[b];
    sum += weights[b];
  }
  Influences influences;
  std::size_t slot = 0;
  for (std::size_t b = 0; b < weights.size() && slot < 4; ++b) {
    if (weights[b] > 0.0) {
      influences.bones[slot] = static_cast<std::uint16_t>(b);
      influences.weights[slot++] = static_cast<float>(weights[b] / sum);
    }
  }
  return influences;
}

} // namespace

SkinnedSequence armedBody(int frames) {
  const auto filled = [](int x, int y, int z) {
    const bool across = z >= -2 && z < 2;
    const bool trunk = x >= -2 && x < 2 && y >= -18 && y < 18;
    const bool arms = x >= -18 && x < 18 && y >= 0 && y < 4;
    return across && (trunk || arms);
  };
  const Shape shape = cubes({-20, -20, -3}, {20, 20, 3}, 0.5, filled);
  SkinnedSequence skinned;
  skinned.name = "body";
  skinned.bindPositions = shape.positions;
  skinned.triangles = shape.triangles;
  for (const BodyPart& part : partsOfArmedBody()) {
    skinned.bones.push_back({part.pivot, part.end, Quat(1.0, 0.0, 0.0, 0.0), part.parent, part.name});
  }
  for (const glm::vec3& place : shape.positions) {
    skinned.influences.push_back(influencesAt(Vec3(place)));
  }
  for (int k = 0; k < frames; ++k) {
    std::vector<Mat4> world;
    for (const BodyPart& part : partsOfArmedBody()) {
      const double swell = std::min(1.0, k / 6.0);
      const double angle = swell * part.swing * std::sin(0.4 * k + part.phase);
      Mat4 turn = glm::mat4_cast(glm::angleAxis(angle, Vec3(0.0, 0.0, 1.0)));
      turn[3] = Vec4(part.pivot - Vec3(turn * Vec4(part.pivot, 0.0)), 1.0);
      world.push_back(part.parent < 0 ? turn : world[static_cast<std::size_t>(part.parent)] * turn);
      skinned.poses.push_back({Vec3(world.back() * Vec4(part.pivot, 1.0)),
                               glm::normalize(glm::quat_cast(Mat3(world.back()))), Vec3(1.0),
                               Quat(1.0, 0.0, 0.0, 0.0)});
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
