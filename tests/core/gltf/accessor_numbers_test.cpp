// Numbers of accessors of every type, stride, place and kind of sparse values, against bytes that are read
// one by one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include <catch2/catch.hpp>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/accessor_layout.h"
#include "core/gltf/json/json.h"

using namespace stretch;
using gltf::ComponentType;
using gltf::Json;

namespace {

struct Type {
  const char* name;
  std::size_t columns;
  std::size_t rows;
};
constexpr std::array<Type, 7> everyType{{{"SCALAR", 1, 1},
                                         {"VEC2", 1, 2},
                                         {"VEC3", 1, 3},
                                         {"VEC4", 1, 4},
                                         {"MAT2", 2, 2},
                                         {"MAT3", 3, 3},
                                         {"MAT4", 4, 4}}};

struct Component {
  int number;
  std::size_t bytes;
};
constexpr std::array<Component, 6> everyComponent{
    {{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}}};

std::size_t paddedColumn(const Type& type, const Component& component) {
  std::size_t bytes = type.rows * component.bytes;
  while (type.columns > 1 && bytes % 4 != 0) {
    ++bytes;
  }
  return bytes;
}

/// A number by its bytes, the lowest first, as the specification has it.
double numberAt(const std::vector<std::uint8_t>& bytes, std::size_t at, const Component& component,
                bool isNormalized) {
  std::uint64_t whole = 0;
  for (std::size_t i = component.bytes; i-- > 0;) {
    whole = 256 * whole + bytes[at + i];
  }
  if (component.number == 5126) {
    const auto word = static_cast<std::uint32_t>(whole);
    float value = 0.0F;
    std::memcpy(&value, &word, 4);
    return static_cast<double>(value);
  }
  const bool isSigned = component.number == 5120 || component.number == 5122;
  const double range = std::pow(256.0, static_cast<double>(component.bytes));
  auto value = static_cast<double>(whole);
  if (isSigned && value >= 0.5 * range) {
    value -= range;
  }
  if (!isNormalized || component.number == 5125) {
    return value;
  }
  return isSigned ? std::max(value / (0.5 * range - 1.0), -1.0) : value / (range - 1.0);
}

struct Layout {
  Type type{};
  Component component{};
  std::size_t count = 0;
  std::size_t stride = 0; ///< 0: none is said.
  std::size_t viewOffset = 0;
  std::size_t offset = 0;
  bool isNormalized = false;
};

gltf::Source sourceOf(const Layout& layout, std::mt19937& chance) {
  gltf::Source source;
  std::vector<std::uint8_t> bytes(4000);
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(chance() % 7 == 0 ? 128 : chance());
  }
  if (layout.component.number == 5126) { // floats are to be numbers
    for (std::size_t i = 3; i < bytes.size(); i += 4) {
      bytes[i] = static_cast<std::uint8_t>(0x3f + 0x80 * (chance() % 2));
    }
  }
  source.buffers = {{1, 2, 3}, bytes};
  Json json = Json::object();
  Json view = {{"buffer", 1}, {"byteOffset", layout.viewOffset}, {"byteLength", 3000}};
  if (layout.stride > 0) {
    view["byteStride"] = layout.stride;
  }
  json["bufferViews"] = Json::array({Json{{"buffer", 0}}, view});
  Json accessor = {{"bufferView", 1},
                   {"byteOffset", layout.offset},
                   {"componentType", layout.component.number},
                   {"count", layout.count},
                   {"type", layout.type.name}};
  if (layout.isNormalized) {
    accessor["normalized"] = true;
  }
  json["accessors"] = Json::array({Json::object(), accessor});
  source.json = json;
  return source;
}

std::vector<double> expectedOf(const gltf::Source& source, const Layout& layout) {
  const std::size_t column = paddedColumn(layout.type, layout.component);
  const std::size_t stride = layout.stride > 0 ? layout.stride : layout.type.columns * column;
  std::vector<double> values;
  for (std::size_t e = 0; e < layout.count; ++e) {
    for (std::size_t c = 0; c < layout.type.columns; ++c) {
      for (std::size_t r = 0; r < layout.type.rows; ++r) {
        const std::size_t at =
            layout.viewOffset + layout.offset + e * stride + c * column + r * layout.component.bytes;
        values.push_back(numberAt(source.buffers[1], at, layout.component, layout.isNormalized));
      }
    }
  }
  return values;
}

void checkNumbers(const gltf::Source& source, const Layout& layout, const std::vector<double>& expected) {
  CAPTURE(layout.type.name, layout.component.number, layout.stride, layout.isNormalized);
  const std::vector<float> floats = gltf::readFloats(source, 1);
  REQUIRE(floats.size() == expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < floats.size(); ++i) {
    different +=
        std::abs(static_cast<double>(floats[i]) - expected[i]) <= 1e-6 * std::abs(expected[i]) ? 0 : 1;
  }
  CHECK(different == 0);
  const bool isUnsigned =
      layout.component.number == 5121 || layout.component.number == 5123 || layout.component.number == 5125;
  if (isUnsigned && !layout.isNormalized) {
    const std::vector<std::uint32_t> integers = gltf::readIntegers(source, 1);
    CHECK(std::ranges::equal(integers, expected,
                             [](std::uint32_t a, double b) { return static_cast<double>(a) == b; }));
  }
}

template <typename Use>
void forEachLayout(Use&& use) {
  for (const Type& type : everyType) {
    for (const Component& component : everyComponent) {
      for (const std::size_t more : {0U, 4U, 12U}) {
        for (const bool isNormalized : {false, true}) {
          const std::size_t size = type.columns * paddedColumn(type, component);
          const Layout layout{
              type,     component,      5,           more == 0 ? 0 : (size + 3) / 4 * 4 + more,
              4 * more, 8 * (more / 4), isNormalized};
          use(layout);
        }
      }
    }
  }
}

void makeSparse(gltf::Source& source, const Component& index, const std::vector<std::size_t>& targets) {
  Json json = *source.json;
  json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 3200}, {"byteLength", 100}});
  json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 3400}, {"byteLength", 600}});
  json["accessors"][1]["sparse"] = {
      {"count", targets.size()},
      {"indices", {{"bufferView", 2}, {"byteOffset", 4}, {"componentType", index.number}}},
      {"values", {{"bufferView", 3}, {"byteOffset", 8}}}};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    for (std::size_t byte = 0; byte < index.bytes; ++byte) {
      source.buffers[1][3204 + i * index.bytes + byte] =
          static_cast<std::uint8_t>(byte == 0 ? targets[i] : 0);
    }
  }
  source.json = json;
}

} // namespace

TEST_CASE("Numbers of every type of accessor are what its bytes say, strided, offset or as fractions") {
  std::mt19937 chance(5);
  forEachLayout([&](const Layout& layout) {
    const gltf::Source source = sourceOf(layout, chance);
    checkNumbers(source, layout, expectedOf(source, layout));
  });
}

TEST_CASE("Sparse values replace those of the elements that their indices name, of every size of index") {
  std::mt19937 chance(6);
  const std::vector<std::size_t> targets{0, 2, 4};
  forEachLayout([&](const Layout& layout) {
    for (const Component& index : {everyComponent[1], everyComponent[3], everyComponent[4]}) {
      gltf::Source source = sourceOf(layout, chance);
      makeSparse(source, index, targets);
      std::vector<double> expected = expectedOf(source, layout);
      Layout replaced = layout;
      replaced.stride = 0;
      replaced.viewOffset = 3400;
      replaced.offset = 8;
      replaced.count = targets.size();
      const std::vector<double> values = expectedOf(source, replaced);
      const std::size_t width = layout.type.columns * layout.type.rows;
      for (std::size_t i = 0; i < values.size(); ++i) {
        expected[targets[i / width] * width + i % width] = values[i];
      }
      checkNumbers(source, layout, expected);
      Json json = *source.json;
      json["accessors"][1].erase("bufferView"); // sparse values upon zeros
      source.json = json;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        expected[i] = std::ranges::count(targets, i / width) > 0 ? expected[i] : 0.0;
      }
      checkNumbers(source, layout, expected);
    }
  });
}

TEST_CASE("Elements without a view, or in a buffer without bytes, are zeros") {
  std::mt19937 chance(7);
  const Layout layout{everyType[2], everyComponent[5], 4, 0, 0, 0, false};
  gltf::Source source = sourceOf(layout, chance);
  source.buffers[1].clear();
  CHECK(gltf::readFloats(source, 1) == std::vector<float>(12, 0.0F));
  CHECK_FALSE(gltf::denseRun(source, 1, *gltf::shapeOf(source, 1)));
  source = sourceOf(layout, chance);
  const auto run = gltf::denseRun(source, 1, *gltf::shapeOf(source, 1));
  REQUIRE(run);
  CHECK(run->count == 4);
  CHECK(run->stride == 12);
  CHECK_FALSE(gltf::sparseRuns(source, 1, *gltf::shapeOf(source, 1)));
}

TEST_CASE("The shape of an accessor has its type's width, count and sizes, padded by columns") {
  std::mt19937 chance(8);
  forEachLayout([&](const Layout& layout) {
    const auto shape = gltf::shapeOf(sourceOf(layout, chance), 1);
    REQUIRE(shape);
    CHECK(shape->type == layout.type.name);
    CHECK(shape->width == static_cast<int>(layout.type.columns * layout.type.rows));
    CHECK(shape->count == layout.count);
    CHECK(static_cast<int>(shape->component) == layout.component.number);
    CHECK(shape->isNormalized == layout.isNormalized);
    CHECK(gltf::componentSize(shape->component) == layout.component.bytes);
    const std::size_t column = paddedColumn(layout.type, layout.component);
    CHECK(gltf::elementSize(*shape) == layout.type.columns * column);
    CHECK(gltf::lastElementSize(*shape) ==
          (layout.type.columns - 1) * column + layout.type.rows * layout.component.bytes);
    const std::vector<std::size_t> offsets = gltf::componentOffsets(*shape);
    REQUIRE(offsets.size() == layout.type.columns * layout.type.rows);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      CHECK(offsets[i] == i / layout.type.rows * column + i % layout.type.rows * layout.component.bytes);
    }
  });
}

TEST_CASE("A type or a component type that glTF does not know has no shape") {
  gltf::Source source;
  for (const auto& [type, component] : std::vector<std::pair<const char*, int>>{{"VEC5", 5126},
                                                                                {"", 5126},
                                                                                {"scalar", 5126},
                                                                                {"VEC3", 5124},
                                                                                {"VEC3", 5127},
                                                                                {"VEC3", 0},
                                                                                {"VEC3", 5119}}) {
    Json json = Json::object();
    json["accessors"] = Json::array({Json{{"type", type}, {"componentType", component}, {"count", 1}}});
    source.json = json;
    CHECK_FALSE(gltf::shapeOf(source, 0));
  }
}
