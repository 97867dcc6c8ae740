// What a file may say of the skeletons of its skins and of the numbers of its clips.
#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

TEST_CASE("A bind matrix that is no number is told, and the file is not opened for it, tolerated or not") {
  GlbBuilder glb = armBuilder();
  const auto accessor = glb.json["skins"][0]["inverseBindMatrices"].get<std::size_t>();
  const auto view = glb.json["accessors"][accessor]["bufferView"].get<std::size_t>();
  const auto offset = glb.json["bufferViews"][view]["byteOffset"].get<std::size_t>();
  const float broken = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(glb.binary.data() + offset + 16 * sizeof(float) + 12 * sizeof(float), &broken, sizeof(broken));
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE_FALSE(file);
  CHECK(file.error().where == "skins[0].inverseBindMatrices");
  CHECK(file.error().what == "holds matrices that are not affine or not finite");
}

TEST_CASE("Keys before the beginning of time break the rules, and are kept where that is tolerated") {
  GlbBuilder glb = armBuilder();
  glb.json["animations"][0]["samplers"][0]["input"] = glb.floats({-0.5F, 0.0F, 0.5F}, "SCALAR", 1);
  const auto refused = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(refused);
  CHECK(refused.error().where == "animations[0].samplers[0].input");
  CHECK(refused.error().what == "has key times before 0");
  const auto file = test::loadBytes(glb.bytes(), gltf::Tolerance::warn);
  REQUIRE(file);
  CHECK(file->clips[0].tracks[0]->times == std::vector<float>{-0.5F, 0.0F, 0.5F});
}

TEST_CASE("Channels of a small file that share their keys are refused before they fill the memory") {
  // 8192 keys of 4 numbers: 160 KiB, for which 13631488 values may be read, 40960 of them for each channel.
  const auto [channels, isTaken] = GENERATE(table<std::size_t, bool>({{332, true}, {333, false}}));
  constexpr std::size_t keys = 8192;
  GlbBuilder glb;
  glb.json = gltf::Json{{"asset", {{"version", "2.0"}}}};
  std::vector<float> times;
  std::vector<float> turns;
  for (std::size_t key = 0; key < keys; ++key) {
    times.push_back(static_cast<float>(key) / 8.0F);
    turns.insert(turns.end(), {0.0F, 0.0F, 0.0F, 1.0F});
  }
  const int input = glb.floats(times, "SCALAR", 1);
  const int output = glb.floats(turns, "VEC4", 4);
  gltf::Json clip{{"samplers", {{{"input", input}, {"output", output}}}}};
  for (std::size_t node = 0; node < channels; ++node) {
    glb.json["nodes"].push_back({{"name", "bone"}});
    clip["channels"].push_back({{"sampler", 0}, {"target", {{"node", node}, {"path", "rotation"}}}});
  }
  glb.json["animations"] = gltf::Json::array({clip});
  const auto file = test::loadBytes(glb.bytes());
  CHECK(file.ok() == isTaken);
  if (!file) {
    CHECK(file.error().where == "animations[0].samplers[0]");
    CHECK(file.error().what == "the animations decode to more data than the program takes into memory");
  }
}
