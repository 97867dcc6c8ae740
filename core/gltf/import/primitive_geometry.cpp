#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/gltf/import/primitive_parts.h"

namespace stretch::gltf {

namespace {

bool isNormal(const glm::vec3& normal) {
  const float length = glm::length(normal);
  return std::isfinite(length) && length > 1e-6F;
}

float lengthError(const glm::vec3& normal) {
  const float error = std::abs(glm::length(normal) - 1.0F);
  return std::isfinite(error) ? error : std::numeric_limits<float>::max();
}

// Sum of the faces' cross products, whose lengths are twice their areas.
std::vector<glm::vec3> areaWeightedNormals(const Primitive& primitive) {
  std::vector<glm::vec3> normals(primitive.positions.size(), glm::vec3(0.0F));
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const glm::vec3& a = primitive.positions[primitive.indices[i]];
    const glm::vec3& b = primitive.positions[primitive.indices[i + 1]];
    const glm::vec3& c = primitive.positions[primitive.indices[i + 2]];
    const glm::vec3 face = glm::cross(b - a, c - a);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      normals[primitive.indices[i + corner]] += face;
    }
  }
  return normals;
}

} // namespace

void PrimitiveParts::completeNormals(Primitive& made) {
  const bool isComplete = !made.normals.empty() && std::ranges::all_of(made.normals, isNormal);
  const std::vector<glm::vec3> computed = isComplete ? std::vector<glm::vec3>() : areaWeightedNormals(made);
  const bool hasOwn = !made.normals.empty();
  made.hasNormals = hasOwn;
  float worst = 0.0F;
  for (const glm::vec3& normal : made.normals) {
    worst = std::max(worst, lengthError(normal));
  }
  constexpr float rounding = 2e-2F; // of normals stored in bytes
  constexpr float little = 0.1F;
  if (worst >= little) {
    problems_.warning(where_ + ".attributes.NORMAL",
                      "holds normals that are not of unit length; they are repaired");
  } else if (worst >= rounding) {
    problems_.warning(where_ + ".attributes.NORMAL", "holds normals a little off unit length");
  }
  made.normals.resize(made.positions.size());
  for (std::size_t i = 0; i < made.normals.size(); ++i) {
    const glm::vec3 normal = hasOwn && isNormal(made.normals[i]) ? made.normals[i] : computed[i];
    const float length = glm::length(normal);
    made.normals[i] = std::isfinite(length) && length > 0.0F ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F);
  }
}

namespace {

// For each vertex those that share a triangle or the place with it.
std::vector<std::vector<std::uint32_t>> neighboursOf(const Primitive& made) {
  std::vector<std::vector<std::uint32_t>> neighbours(made.positions.size());
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  for (std::size_t i = 0; i + 2 < made.indices.size(); i += 3) {
    join(made.indices[i], made.indices[i + 1]);
    join(made.indices[i + 1], made.indices[i + 2]);
    join(made.indices[i + 2], made.indices[i]);
  }
  std::map<std::array<float, 3>, std::uint32_t> first;
  for (std::uint32_t vertex = 0; vertex < made.positions.size(); ++vertex) {
    const glm::vec3& place = made.positions[vertex];
    const auto [known, isNew] = first.try_emplace({place.x, place.y, place.z}, vertex);
    if (!isNew) {
      join(known->second, vertex);
    }
  }
  return neighbours;
}

} // namespace

void PrimitiveParts::spreadInfluences(Primitive& made) {
  if (failed_ || unweighted_.empty()) {
    return;
  }
  problems_.warning(where_ + ".attributes.WEIGHTS_0",
                    fmt::format("{} {} no numbers for weights; such vertices follow their neighbours",
                                unweighted_.size(),
                                unweighted_.size() == 1 ? "vertex has" : "vertices have"));
  made.areInfluencesMended = true;
  std::vector<bool> isOpen(made.positions.size(), false);
  for (const std::uint32_t vertex : unweighted_) {
    isOpen[vertex] = true;
  }
  const std::vector<std::vector<std::uint32_t>> neighbours = neighboursOf(made);
  std::vector<std::uint32_t> known;
  for (std::uint32_t vertex = 0; vertex < made.positions.size(); ++vertex) {
    if (!isOpen[vertex]) {
      known.push_back(vertex);
    }
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    for (const std::uint32_t next : neighbours[known[i]]) {
      if (isOpen[next]) {
        isOpen[next] = false;
        made.influences[next] = made.influences[known[i]];
        known.push_back(next);
      }
    }
  }
}

bool normalizeWeights(std::vector<VertexInfluences>& influences) {
  constexpr float rounding = 4e-3F; // what the rounding of four weights to bytes leaves
  bool wasOff = false;
  for (VertexInfluences& vertex : influences) {
    const float sum = std::accumulate(vertex.weights.begin(), vertex.weights.end(), 0.0F);
    wasOff = wasOff || std::abs(sum - 1.0F) > rounding;
    if (sum <= 0.0F || !std::isfinite(sum)) {
      vertex.weights.fill(0.0F);
      vertex.weights[0] = 1.0F;
      continue;
    }
    for (float& weight : vertex.weights) {
      weight /= sum;
    }
  }
  return wasOff;
}

std::vector<std::uint32_t> unrolledTriangles(const std::vector<std::uint32_t>& corners, int mode) {
  constexpr int strip = 5;
  constexpr int fan = 6;
  if (mode != strip && mode != fan) {
    return {corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(corners.size() % 3)};
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    if (mode == fan) {
      triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
    } else {
      // Every second triangle of a strip is wound the other way round.
      const bool isOdd = i % 2 == 1;
      triangles.insert(triangles.end(),
                       {corners[i - 2], corners[isOdd ? i : i - 1], corners[isOdd ? i - 1 : i]});
    }
  }
  return triangles;
}

} // namespace stretch::gltf
