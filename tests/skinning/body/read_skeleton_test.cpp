// The bones that are taken from a file: where they end, of which skin they are, and which cannot be taken.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "skinning/body/given_skeleton.h"
#include "skinning/export/encode_gltf.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/refusal.h"
#include "tests/support/skinning/bodies.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

template <typename Change>
Result<std::vector<SkinBone>> skeletonAfter(const Change& change) {
  const test::TemporaryFolder folder;
  gltf::Source source = encodeGltf(test::armedBody(2)).source;
  change(source);
  REQUIRE(gltf::save(source, folder / "body.glb"));
  return readSkeleton(folder / "body.glb");
}

} // namespace

TEST_CASE(
    "a bone of a file reaches to the middle of those that hang on it, a last one half as far as before") {
  const auto bones = skeletonAfter([](gltf::Source& /*source*/) {});
  REQUIRE(bones);
  const auto endOf = [&](const std::string& name) {
    const auto bone = std::ranges::find(*bones, name, &SkinBone::name);
    REQUIRE(bone != bones->end());
    return bone->end;
  };
  const auto isAt = [&](const std::string& name, const Vec3& place) {
    CAPTURE(name);
    CHECK(glm::distance(endOf(name), place) < 1e-4);
  };
  isAt("trunk", Vec3(0.0, 5.0 / 3.0, 0.0)); // between the head and both arms
  isAt("head", Vec3(0.0, 9.0, 0.0));        // which begins 12 above the trunk
  isAt("upper_left", Vec3(5.0, 1.0, 0.0));
  isAt("lower_left", Vec3(7.0, 1.0, 0.0));
  isAt("lower_right", Vec3(-7.0, 1.0, 0.0));
}

TEST_CASE("of several skins of a file the one with the most joints is taken") {
  const auto bones = skeletonAfter([](gltf::Source& source) {
    gltf::Json& skins = (*source.json)["skins"];
    const gltf::Json first = skins[0]["joints"][0];
    skins.push_back({{"joints", gltf::Json::array({first})}});
  });
  REQUIRE(bones);
  CHECK(bones->size() == 6);
}

TEST_CASE("a file without a skin, and one whose bind matrices lead nowhere, give no bones") {
  const test::TemporaryFolder folder;
  test::twoSheets().write(folder / "sheets.glb");
  CHECK_THAT(test::refusal(readSkeleton(folder / "sheets.glb")),
             Catch::Contains("the file holds no skin, so there are no bones to take"));
  const auto flat = skeletonAfter([](gltf::Source& source) {
    const gltf::Json& json = *source.json;
    const gltf::Json& accessor =
        json["accessors"][json["skins"][0]["inverseBindMatrices"].get<std::size_t>()];
    const gltf::Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    constexpr std::size_t bytesOfMatrix = 64;
    constexpr std::size_t bytesOfAxis = 12; // of the second bone's x
    const std::size_t first = view.value("byteOffset", std::size_t{0}) +
                              accessor.value("byteOffset", std::size_t{0}) + bytesOfMatrix;
    std::fill_n(source.buffers.front().begin() + static_cast<std::ptrdiff_t>(first), bytesOfAxis,
                std::uint8_t{0});
  });
  CHECK_THAT(test::refusal(flat), Catch::Contains("the bind matrix of 'head' cannot be inverted"));
}

TEST_CASE(
    "a bone hangs on the nearest bone above it, and a leaf that carries a stretch stands for its joint") {
  const auto told = [](const std::vector<gltf::Json>& nodes, const std::vector<int>& joints) {
    const test::TemporaryFolder folder;
    test::GlbBuilder glb = test::twoSheets();
    const int first = static_cast<int>(glb.json["nodes"].size());
    REQUIRE(first == 2);
    for (const gltf::Json& node : nodes) {
      glb.json["nodes"].push_back(node);
    }
    glb.json["scenes"][0]["nodes"].push_back(first);
    glb.json["skins"].push_back({{"joints", joints}});
    glb.write(folder / "bones.glb");
    const auto bones = readSkeleton(folder / "bones.glb");
    REQUIRE(test::refusal(bones) == "accepted");
    std::string text;
    for (const SkinBone& bone : *bones) {
      text += bone.name + " on " + std::to_string(bone.parent) + ", ";
    }
    return text;
  };
  using gltf::Json;
  const Json hips{{"name", "hips"}, {"children", {3}}};
  const Json between{{"name", "between"}, {"children", {4}}};
  const Json knee{{"name", "knee"}, {"translation", {0, -1, 0}}};
  const Json kneeThatStretches{{"name", "knee"}, {"translation", {0, -1, 0}}, {"children", {4}}};
  const Json leaf{{"name", "stretch_knee"}, {"scale", {1, 2, 1}}};
  const Json pelvis{{"name", "pelvis"}, {"scale", {1, 2, 1}}};
  CHECK(told({hips, between, knee}, {2, 4}) == "hips on -1, knee on 0, ");
  CHECK(told({hips, kneeThatStretches, leaf}, {2, 4}) == "hips on -1, knee on 0, ");
  CHECK(told({hips, pelvis}, {2, 3}) == "hips on -1, pelvis on 0, "); // where the hips are, and a bone
}
