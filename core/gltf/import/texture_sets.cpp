#include "core/gltf/import/texture_sets.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_source.h"

namespace stretch::gltf {

namespace {

/// The JSON of a primitive that the scene has.
const Json* primitiveJson(const Json& json, std::size_t mesh, std::size_t primitive) {
  const Json& primitives = element(json, "meshes", mesh)["primitives"];
  for (const Json& candidate : primitives) {
    if (holdsTriangles(candidate) && primitive-- == 0) {
      return &candidate;
    }
  }
  return nullptr;
}

std::vector<glm::vec2> pairsOf(const std::vector<float>& numbers) {
  std::vector<glm::vec2> pairs;
  pairs.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    const glm::vec2 pair(numbers[i], numbers[i + 1]);
    pairs.push_back(std::isfinite(pair.x + pair.y) ? pair : glm::vec2(0.0F));
  }
  return pairs;
}

} // namespace

TextureSets::TextureSets(const Loaded& loaded) : readable_(loaded.source) {
  Problems problems;
  if (std::optional<PlainSource> plain = plainSource(*loaded.source, problems);
      plain && !problems.hasErrors()) {
    readable_ = std::make_shared<const Source>(std::move(plain->source));
  }
}

std::vector<std::vector<glm::vec2>> TextureSets::of(std::size_t mesh, std::size_t primitive) const {
  std::vector<std::vector<glm::vec2>> sets;
  const Json* json = primitiveJson(readable_->json, mesh, primitive);
  if (json == nullptr) {
    return sets;
  }
  const Json& attributes = (*json)["attributes"];
  const std::optional<AccessorShape> vertices = shapeOf(*readable_, indexOr(attributes, "POSITION"));
  for (int accessor = 0; vertices && accessor >= 0;) {
    accessor = indexOr(attributes, fmt::format("TEXCOORD_{}", sets.size()));
    if (accessor >= 0) {
      const std::optional<AccessorShape> shape = shapeOf(*readable_, accessor);
      if (!shape || shape->type != "VEC2" || shape->count != vertices->count) {
        break;
      }
      sets.push_back(pairsOf(readFloats(*readable_, accessor)));
    }
  }
  return sets;
}

} // namespace stretch::gltf
