#include "core/scene/mesh_sequence.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace stretch {

double boxDiagonal(std::span<const glm::vec3> positions) {
  if (positions.empty()) {
    return 0.0;
  }
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high(std::numeric_limits<float>::lowest());
  for (const glm::vec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return glm::length(Vec3(high) - Vec3(low));
}

SequenceExtent extentOf(const MeshSequence& sequence) {
  constexpr double leastShare = 0.01;
  std::vector<double> diagonals;
  diagonals.reserve(sequence.frameCount());
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    diagonals.push_back(boxDiagonal(sequence.frame(k)));
  }
  if (diagonals.empty()) {
    return {};
  }
  const double enough = leastShare * *std::ranges::max_element(diagonals);
  const auto first = std::ranges::find_if(diagonals, [&](double diagonal) { return diagonal >= enough; });
  return {*first, static_cast<std::size_t>(first - diagonals.begin())};
}

MeshSequence withoutFirstFrames(const MeshSequence& sequence, std::size_t firstFrame) {
  const std::size_t frames = sequence.frameCount();
  const auto first = static_cast<std::ptrdiff_t>(std::min(firstFrame, frames == 0 ? 0 : frames - 1));
  MeshSequence rest = sequence;
  rest.positions.erase(rest.positions.begin(),
                       rest.positions.begin() + first * static_cast<std::ptrdiff_t>(sequence.vertexCount));
  const auto names = std::min<std::ptrdiff_t>(first, static_cast<std::ptrdiff_t>(rest.frameNames.size()));
  rest.frameNames.erase(rest.frameNames.begin(), rest.frameNames.begin() + names);
  return rest;
}

} // namespace stretch
