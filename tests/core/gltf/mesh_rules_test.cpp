// What a file may say of its meshes: weights of their targets, indices, attributes and the skins that move
// them.
#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;
using test::GlbBuilder;

namespace {

constexpr const char* partOfProp = "meshes[1].primitives[0]";

Json& propIn(GlbBuilder& glb) {
  return glb.json["meshes"][1]["primitives"][0];
}

/// The arm, whose prop has two morph targets.
GlbBuilder withTwoTargets() {
  GlbBuilder glb = test::armBuilder();
  const Json places{{"POSITION", propIn(glb)["attributes"]["POSITION"]}};
  propIn(glb)["targets"] = {places, places};
  return glb;
}

/// The arm, whose prop is one triangle of so many vertices, with the last index as it is given.
template <typename Index>
GlbBuilder withIndices(std::size_t vertices, int componentType, Index last) {
  GlbBuilder glb = test::armBuilder();
  const int places = glb.floats(std::vector<float>(3 * vertices), "VEC3", 3);
  glb.json["accessors"].back()["min"] = {0, 0, 0};
  glb.json["accessors"].back()["max"] = {0, 0, 0};
  propIn(glb)["attributes"]["POSITION"] = places;
  propIn(glb)["indices"] = glb.accessor(std::vector<Index>{0, 1, last}, componentType, "SCALAR", 1);
  return glb;
}

std::string toldOfIndices(const GlbBuilder& glb) {
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
  if (file) {
    return "";
  }
  CHECK(file.error().where == std::string(partOfProp) + ".indices");
  return file.error().what;
}

} // namespace

TEST_CASE("A mesh has a weight for each of its targets: that which it says, or none") {
  struct Case {
    std::vector<float> said;
    std::vector<float> wanted;
    bool isTold;
  };
  for (const Case& one : {Case{{}, {0.0F, 0.0F}, false},
                          {{0.25F, 0.5F}, {0.25F, 0.5F}, false},
                          {{0.25F}, {0.25F, 0.0F}, true},
                          {{0.25F, 0.5F, 0.75F}, {0.25F, 0.5F}, true}}) {
    CAPTURE(one.said.size());
    GlbBuilder glb = withTwoTargets();
    if (!one.said.empty()) {
      glb.json["meshes"][1]["weights"] = one.said;
    }
    const gltf::Loaded file = test::loaded(glb);
    CHECK(file.scene->meshes[1].morphWeights == one.wanted);
    CHECK(test::warnsOf(file, "meshes[1].weights: does not have one weight for each morph target") ==
          one.isTold);
    CHECK(file.warnings.size() == (one.isTold ? 1 : 0));
  }
}

TEST_CASE("Parts of one mesh have as many targets each") {
  for (const std::size_t targets : {1U, 2U, 3U}) {
    CAPTURE(targets);
    GlbBuilder glb = withTwoTargets();
    Json second = propIn(glb);
    second["targets"] = Json::array();
    for (std::size_t i = 0; i < targets; ++i) {
      second["targets"].push_back(propIn(glb)["targets"][0]);
    }
    glb.json["meshes"][1]["primitives"].push_back(second);
    const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
    CHECK(file.ok() == (targets == 2));
    if (!file) {
      CHECK(file.error().where == "meshes[1]");
      CHECK(file.error().what == "has primitives with different numbers of morph targets");
    }
  }
}

TEST_CASE("The largest number of an index's size is none, though there is a vertex of that number") {
  CHECK(toldOfIndices(withIndices<std::uint8_t>(256, 5121, 254)).empty());
  CHECK(toldOfIndices(withIndices<std::uint8_t>(256, 5121, 255)) ==
        "holds 255, which restarts primitives and is no index");
  CHECK(toldOfIndices(withIndices<std::uint8_t>(255, 5121, 255)) ==
        "refers to vertex 255, but there are 255");
  CHECK(toldOfIndices(withIndices<std::uint16_t>(65536, 5123, 255)).empty());
  CHECK(toldOfIndices(withIndices<std::uint16_t>(65536, 5123, 65535)) ==
        "holds 65535, which restarts primitives and is no index");
  CHECK(toldOfIndices(withIndices<std::uint32_t>(65536, 5125, 65535)).empty());
}

TEST_CASE(
    "Attributes of a mesh are those of glTF, or begin with an underscore, and have a value for each vertex") {
  const auto toldWith = [](const char* name, const auto& accessorOf) {
    GlbBuilder glb = test::armBuilder();
    const int accessor = accessorOf(glb);
    propIn(glb)["attributes"][name] = accessor;
    const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
    CHECK((file || file.error().where == std::string(partOfProp) + ".attributes." + name));
    CHECK(test::loadBytes(glb.bytes(), gltf::Tolerance::warn)); // nothing reads it
    return file ? std::string() : file.error().what;
  };
  const auto six = [](GlbBuilder& glb) { return glb.floats({1, 2, 3, 4, 5, 6}, "SCALAR", 1); };
  const auto five = [](GlbBuilder& glb) { return glb.floats({1, 2, 3, 4, 5}, "SCALAR", 1); };
  const auto large = [](GlbBuilder& glb) {
    return glb.accessor(std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6}, 5125, "SCALAR", 1);
  };
  const std::string unfit = "its accessor has a type or number of elements that an attribute cannot have";
  CHECK(toldWith("_HEAT", six).empty());
  CHECK(toldWith("_HEAT", five) == unfit);
  CHECK(toldWith("_HEAT", large) == unfit);
  CHECK(toldWith("HEAT", six) == "is not an attribute that glTF knows");
  CHECK(toldWith("TANGENT", five) == unfit);
}

TEST_CASE(
    "Texture coordinates of whole numbers are those of KHR_mesh_quantization, of one or two bytes each") {
  const auto isTaken = [](bool isQuantized, const auto& accessorOf) {
    GlbBuilder glb = test::armBuilder();
    const int accessor = accessorOf(glb);
    propIn(glb)["attributes"]["TEXCOORD_0"] = accessor;
    if (isQuantized) {
      glb.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    }
    const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
    CHECK((file || file.error().where == std::string(partOfProp) + ".attributes.TEXCOORD_0"));
    return bool(file);
  };
  const auto small = [](GlbBuilder& glb) {
    return glb.accessor(std::vector<std::uint16_t>(12, 3), 5123, "VEC2", 2);
  };
  const auto large = [](GlbBuilder& glb) {
    return glb.accessor(std::vector<std::uint32_t>(12, 3), 5125, "VEC2", 2);
  };
  CHECK(isTaken(true, small));
  CHECK_FALSE(isTaken(false, small));
  CHECK_FALSE(isTaken(true, large));
  CHECK_FALSE(isTaken(false, large));
}

TEST_CASE("Vertices follow joints that every skin has which moves their mesh, in whichever order") {
  const bool isSmallFirst = GENERATE(true, false);
  CAPTURE(isSmallFirst);
  GlbBuilder glb = test::armBuilder();
  glb.json["skins"].push_back({{"joints", {0, 1}}});
  for (const std::size_t node : {3U, 4U}) {
    glb.json["nodes"][node]["mesh"] = 0;
    glb.json["nodes"][node]["skin"] = (node == 3) == isSmallFirst ? 1 : 0;
  }
  const Result<gltf::Loaded> file = test::loadBytes(glb.bytes());
  REQUIRE_FALSE(file);
  CHECK(file.error().where == "meshes[0].primitives[0].attributes.JOINTS_0");
  CHECK(file.error().what == "vertex 4 follows joint 2, but the skin has 2");
}
