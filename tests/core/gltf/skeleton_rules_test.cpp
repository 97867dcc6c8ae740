// What a file may say of the skeletons of its skins and of the numbers of its clips.
#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using test::armBuilder;
using test::GlbBuilder;

namespace {

bool complainsOfSkeleton(const GlbBuilder& glb) {
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  return std::ranges::any_of(file->warnings, [](const std::string& warning) {
    return warning.find("skeleton") != std::string::npos;
  });
}

} // namespace

TEST_CASE("The skeleton of a skin is a node above all of its joints, or one of them that is") {
  // Nodes 0, 1 and 2 hang on each other and are the joints; 3 hangs on 2.
  for (const auto& [skeleton, isAbove] : {std::pair(0, true), {1, false}, {2, false}, {3, false}}) {
    GlbBuilder glb = armBuilder();
    glb.json["skins"][0]["skeleton"] = skeleton;
    CAPTURE(skeleton);
    CHECK(complainsOfSkeleton(glb) == !isAbove);
  }
}

TEST_CASE("A clip whose values are no finite numbers is told, and the file is not opened for it") {
  GlbBuilder glb = armBuilder();
  const auto output = glb.json["animations"][0]["samplers"][0]["output"].get<std::size_t>();
  const auto view = glb.json["accessors"][output]["bufferView"].get<std::size_t>();
  const auto offset = glb.json["bufferViews"][view]["byteOffset"].get<std::size_t>();
  const float broken =
      GENERATE(std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN());
  std::memcpy(glb.binary.data() + offset, &broken, sizeof(broken));
  const auto file = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(file);
  CHECK_THAT(file.error().line(), Catch::Contains("holds values that are no finite numbers"));
}
