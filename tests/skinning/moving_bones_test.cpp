#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "skinning/fit/alternate.h"
#include "skinning/metrics.h"
#include "skinning/skinned_sequence.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr std::size_t frames = 12;
constexpr std::size_t ofPart = 64;

/// Cubes of 64 places side by side, each moved by itself.
MeshSequence cubesThatMove(std::size_t cubes, const std::function<Vec3(std::size_t, double, Vec3)>& moved) {
  MeshSequence sequence;
  sequence.name = "cubes";
  sequence.vertexCount = cubes * ofPart;
  for (std::size_t k = 0; k < frames; ++k) {
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      const std::size_t place = v % ofPart;
      const std::size_t part = v / ofPart;
      const auto cube = static_cast<double>(part);
      const std::size_t row = place / 4 % 4;
      const std::size_t layer = place / 16;
      const Vec3 rest(6.0 * cube + static_cast<double>(place % 4), static_cast<double>(row),
                      static_cast<double>(layer));
      sequence.positions.emplace_back(moved(v / ofPart, static_cast<double>(k) / frames, rest));
    }
  }
  return sequence;
}

/// A start with each vertex on the bone that is named.
SkinnedSequence onBones(const MeshSequence& sequence, std::size_t bones,
                        const std::function<std::size_t(std::size_t)>& boneOf) {
  SkinnedSequence skinned = withoutBones(sequence);
  skinned.bones.resize(bones);
  for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
    Influences on;
    on.bones[0] = static_cast<std::uint16_t>(boneOf(v));
    on.weights[0] = 1.0F;
    skinned.influences.push_back(on);
  }
  return skinned;
}

double percentAfterFit(const MeshSequence& sequence, SkinnedSequence start, bool bonesMove) {
  FitSettings settings;
  settings.bonesMove = bonesMove;
  fitFreeBones(sequence, start, settings);
  return distancesOf(sequence, skinAllFrames(start)).rmsePercent;
}

} // namespace

TEST_CASE("a bone that another can stand in for goes to a part that lacks one") {
  // Two bones on a cube that rests, one for two cubes that turn each about its own axis.
  const MeshSequence cubes = cubesThatMove(3, [](std::size_t cube, double time, Vec3 place) {
    const Vec3 middle(6.0 * static_cast<double>(cube) + 1.5, 1.5, 1.5);
    const Vec3 axis = glm::normalize(Vec3(cube == 1, 0.5, cube == 2));
    return cube == 0 ? place : middle + glm::angleAxis(3.0 * time, axis) * (place - middle);
  });
  const SkinnedSequence start = onBones(cubes, 3, [](std::size_t v) {
    const std::size_t cube = v / ofPart;
    return cube == 0 ? v % 2 : 2;
  });
  CHECK(percentAfterFit(cubes, start, true) < 0.1);
  CHECK(percentAfterFit(cubes, start, false) > 0.3);
}

TEST_CASE("bones without a direction turn their axes to where the body stretches") {
  const Vec3 along = glm::normalize(Vec3(1.0, 1.0, 0.3));
  const MeshSequence cube = cubesThatMove(1, [&](std::size_t, double time, Vec3 place) {
    return place + 0.8 * time * glm::dot(along, place) * along;
  });
  const SkinnedSequence start = onBones(cube, 1, [](std::size_t) { return 0; });
  CHECK(percentAfterFit(cube, start, true) < 0.05);
  CHECK(percentAfterFit(cube, start, false) > 1.0);
}
