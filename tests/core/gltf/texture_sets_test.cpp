// Sets of texture coordinates, as far as they follow each other and fit their vertices.
#include "core/gltf/import/texture_sets.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/source/source.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using test::armBuilder;
using test::GlbBuilder;

namespace {

/// Texture coordinates for the arm's six vertices, or for so many.
int addCoordinates(GlbBuilder& glb, const std::string& set, std::size_t vertices = 6) {
  std::vector<float> numbers;
  for (std::size_t i = 0; i < vertices; ++i) {
    numbers.insert(numbers.end(), {static_cast<float>(i), 0.5F});
  }
  const int accessor = glb.floats(numbers, "VEC2", 2);
  glb.json["meshes"][0]["primitives"][0]["attributes"][set] = accessor;
  return accessor;
}

} // namespace

TEST_CASE("Sets of texture coordinates are read as far as they are counted without a gap") {
  GlbBuilder glb = armBuilder();
  CHECK(gltf::TextureSets(test::loaded(glb)).of(0, 0).empty());
  addCoordinates(glb, "TEXCOORD_0");
  addCoordinates(glb, "TEXCOORD_1");
  addCoordinates(glb, "TEXCOORD_3");
  const auto sets = gltf::TextureSets(test::loaded(glb)).of(0, 0);
  REQUIRE(sets.size() == 2);
  for (const auto& set : sets) {
    REQUIRE(set.size() == 6);
    CHECK(set[0] == glm::vec2(0.0F, 0.5F));
    CHECK(set[5] == glm::vec2(5.0F, 0.5F));
  }
}

TEST_CASE("A set that has another number of coordinates than there are vertices ends the sets") {
  GlbBuilder glb = armBuilder();
  addCoordinates(glb, "TEXCOORD_0");
  addCoordinates(glb, "TEXCOORD_1", 4);
  addCoordinates(glb, "TEXCOORD_2");
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  CHECK((!file || gltf::TextureSets(*file).of(0, 0).size() == 1));
}
