#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>

#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;
using test::armBuilder;
using test::GlbBuilder;
using test::loadBytes;

namespace {

/// Numbers that a file may store the values of keys as.
struct Stored {
  const char* title;
  int component;
  std::size_t bytes; ///< Of each.
  std::uint32_t one; ///< What stands for 1.
  bool isFraction;
  bool turns; ///< Whether turns and weights may be such.
};

const std::vector<Stored> storedKinds{{"bytes", 5120, 1, 127, true, true},
                                      {"unsigned bytes", 5121, 1, 255, true, true},
                                      {"shorts", 5122, 2, 32767, true, true},
                                      {"unsigned shorts", 5123, 2, 65535, true, true},
                                      {"unsigned", 5125, 4, 0xFFFFFFFFU, true, false},
                                      {"whole bytes", 5120, 1, 1, false, false},
                                      {"whole shorts", 5123, 2, 1, false, false}};

/// Two keys whose `width` values are all 1; elements begin at multiples of four bytes. Answers the accessor.
int onesAs(const Stored& kind, std::size_t width, GlbBuilder& glb) {
  const std::size_t element = (kind.bytes * width + 3) / 4 * 4;
  std::vector<std::uint8_t> bytes(2 * element);
  const bool isScalar = width == 2; // of weights: each a value of its own
  for (std::size_t i = 0; i < 2 * width; ++i) {
    const std::size_t place = isScalar ? i * kind.bytes : i / width * element + i % width * kind.bytes;
    std::memcpy(bytes.data() + place, &kind.one, kind.bytes);
  }
  const int made = glb.accessor(bytes, 5121,
                                isScalar     ? "SCALAR"
                                : width == 3 ? "VEC3"
                                             : "VEC4",
                                bytes.size());
  Json& accessor = glb.json["accessors"][static_cast<std::size_t>(made)];
  accessor["componentType"] = kind.component;
  accessor["normalized"] = kind.isFraction;
  accessor["count"] = isScalar ? 4 : 2;
  if (!isScalar && element != kind.bytes * width) {
    glb.json["bufferViews"].back()["byteStride"] = element;
  }
  return made;
}

/// A file whose one clip drives a part of a node with these values at 0 and 1 seconds.
GlbBuilder drivenBy(const Stored& kind, const std::string& path, std::size_t width, std::size_t node) {
  GlbBuilder glb = armBuilder();
  Json& primitive = glb.json["meshes"][0]["primitives"][0];
  primitive["targets"] = {{{"POSITION", primitive["attributes"]["POSITION"]}},
                          {{"POSITION", primitive["attributes"]["POSITION"]}}};
  const int output = onesAs(kind, width, glb);
  const int input = glb.floats({0, 1}, "SCALAR", 1);
  glb.json["accessors"].back()["min"] = {0};
  glb.json["accessors"].back()["max"] = {1};
  glb.json["animations"] = {{{"name", "one"},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}},
                             {"samplers", {{{"input", input}, {"output", output}}}}}};
  return glb;
}

} // namespace

TEST_CASE("A file without scenes shows every node that no other holds") {
  GlbBuilder glb = armBuilder();
  glb.json["scenes"] = Json::array({{{"nodes", {5}}}, {{"nodes", {0}}}});
  glb.json["scene"] = 1;
  CHECK(test::loaded(glb).scene->roots == std::vector{NodeIndex(0)});
  glb.json.erase("scene");
  CHECK(test::loaded(glb).scene->roots == std::vector{NodeIndex(5)}); // the first one
  glb.json.erase("scenes");
  const gltf::Loaded all = test::loaded(glb);
  const Scene& scene = *all.scene;
  std::vector<NodeIndex> parentless;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!scene.nodes[i].parent.exists()) {
      parentless.emplace_back(i);
    }
  }
  REQUIRE(parentless.size() > 1);
  CHECK(scene.roots == parentless);
}

TEST_CASE("Values of keys are floats or, of turns and of weights, fractions in integers of 8 or 16 bits") {
  const Json nodes = armBuilder().json["nodes"];
  const auto skinned = static_cast<std::size_t>(
      std::ranges::find_if(nodes, [](const Json& node) { return node.value("mesh", -1) == 0; }) -
      nodes.begin());
  REQUIRE(skinned < nodes.size());
  for (const auto& [path, width] : {std::pair("rotation", 4U), std::pair("weights", 2U),
                                    std::pair("translation", 3U), std::pair("scale", 3U)}) {
    for (const Stored& kind : storedKinds) {
      CAPTURE(path, kind.title);
      const GlbBuilder glb = drivenBy(kind, path, width, width == 2 ? skinned : 1);
      const Result<gltf::Loaded> file = loadBytes(glb.bytes(), gltf::Tolerance::warn);
      REQUIRE(file.ok() == (kind.turns && width != 3));
      if (!file) {
        CHECK(file.error().where == "animations[0].samplers[0].output");
        CHECK(file.error().what == "its accessor has a type that animations[0].channels[0] cannot use");
        continue;
      }
      REQUIRE(file->clips[0].tracks.size() == 1);
      CHECK(file->clips[0].tracks[0]->values == std::vector<float>(2 * std::size_t{width}, 1.0F));
    }
  }
}

TEST_CASE("Bounds of an accessor are as many as its elements have numbers, and agree with them") {
  struct Case {
    Json min;
    Json max;
    bool isSound;
  };
  const auto one = GENERATE(values<Case>({{{0, 0, -1}, {2, 4, 3}, true},
                                          {{0, 0, -1}, nullptr, true},
                                          {{0, 0, -1.0001}, {2, 4, 3.0001}, true},
                                          {{0, 0, -1.01}, {2, 4, 3}, false},
                                          {{0, 0, -1}, {2, 4.01, 3}, false},
                                          {{0, 0, -0.9}, {2, 4, 3}, false},
                                          {{0, 0}, {2, 4}, false},
                                          {{0}, {2}, false},
                                          {{0, 0, -1, 0}, {2, 4, 3, 0}, false}}));
  CAPTURE(one.min.dump(), one.max.dump());
  GlbBuilder glb = armBuilder();
  const int accessor = glb.floats({0, 4, 3, 2, 0, -1}, "VEC3", 3);
  glb.json["accessors"][static_cast<std::size_t>(accessor)]["min"] = one.min;
  if (!one.max.is_null()) {
    glb.json["accessors"][static_cast<std::size_t>(accessor)]["max"] = one.max;
  }
  const Result<gltf::Loaded> file = loadBytes(glb.bytes());
  CHECK(file.ok() == one.isSound);
  INFO((file ? std::string() : file.error().line()));
  CHECK((one.isSound || file.error().where == "accessors[" + std::to_string(accessor) + "]"));
}
