// What a file may say of its views and accessors: each rule, with what is allowed yet beside what is not.
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>

#include "core/gltf/import/accessor.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Json;
using gltf::Severity;

namespace {

/// A mesh of three places (accessor 0, floats) with indices (1, bytes of 16 bits), weights (2) and values
/// that nothing uses (3, sparse), each in a view of its own.
gltf::Source soundSource() {
  test::GlbBuilder glb;
  glb.json = Json::parse(R"({"asset": {"version": "2.0"}, "bufferViews": [], "accessors": []})");
  glb.floats({0, 1, 2, 3, 4, 5, 6, 7, 8}, "VEC3", 3);
  glb.accessor<std::uint16_t>({0, 1, 2, 0, 2, 1}, 5123, "SCALAR", 1);
  glb.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
  glb.floats({0.5F, 1.5F, 2.5F, 3.5F}, "SCALAR", 1);
  const int places = glb.accessor<std::uint16_t>({1, 3}, 5123, "SCALAR", 1);
  const int values = glb.floats({7, 9}, "SCALAR", 1);
  glb.json["accessors"].erase(static_cast<std::size_t>(values));
  glb.json["accessors"].erase(static_cast<std::size_t>(places));
  glb.json["accessors"][3]["sparse"] = {{"count", 2},
                                        {"indices", {{"bufferView", 4}, {"componentType", 5123}}},
                                        {"values", {{"bufferView", 5}}}};
  glb.json["accessors"][0]["min"] = {0, 1, 2};
  glb.json["accessors"][0]["max"] = {6, 7, 8};
  glb.json["buffers"] = Json::array({Json{{"byteLength", glb.binary.size()}}});
  glb.json["meshes"] = Json::array(
      {Json{{"primitives",
             Json::array({Json{{"attributes", {{"POSITION", 0}, {"WEIGHTS_0", 2}}}, {"indices", 1}}})}}});
  gltf::Source source;
  source.json = glb.json;
  source.buffers = {glb.binary};
  source.hasBinaryChunk = true;
  return source;
}

/// What is told of the file after a change, as "kind place what".
std::vector<std::string> toldOf(const std::function<void(Json&, gltf::Bytes&)>& change,
                                const std::set<std::size_t>& rounded = {}) {
  gltf::Source source = soundSource();
  Json json = *source.json;
  change(json, source.buffers[0]);
  source.json = json;
  gltf::Problems problems;
  gltf::validateAccessors(source, rounded, problems);
  std::vector<std::string> told;
  for (const gltf::Problem& problem : problems.list()) {
    told.push_back((problem.severity == Severity::error       ? "error "
                    : problem.severity == Severity::violation ? "violation "
                                                              : "warning ") +
                   problem.where + " " + problem.what);
  }
  return told;
}

using Told = std::vector<std::string>;

Told toldAt(const char* place, const Json& value) {
  return toldOf([&](Json& json, gltf::Bytes&) { json[Json::json_pointer(place)] = value; });
}

void putFloat(gltf::Bytes& bytes, const Json& json, std::size_t view, std::size_t number, float value) {
  std::memcpy(bytes.data() + json["bufferViews"][view]["byteOffset"].get<std::size_t>() + 4 * number, &value,
              4);
}

} // namespace

TEST_CASE("A sound file has nothing told of its accessors") {
  CHECK(toldOf([](Json&, gltf::Bytes&) {}).empty());
}

TEST_CASE("A view ends with its buffer at the latest, and strides by fours, indices not at all") {
  const std::size_t size = soundSource().buffers[0].size();
  const Told past{"error bufferViews[5] reaches past the end of its buffer"};
  CHECK(toldAt("/bufferViews/5/byteLength", 9) == past);
  CHECK(toldAt("/buffers/0/byteLength", size - 1) == past);
  CHECK(toldAt("/buffers/0/byteLength", size + 1).empty());
  CHECK(toldAt("/bufferViews/0/byteStride", 14) ==
        Told{"error bufferViews[0].byteStride is not a multiple of 4"});
  CHECK(toldAt("/bufferViews/0/byteStride", 12).empty());
  const auto strided = [](int target) {
    return toldOf([target](Json& json, gltf::Bytes&) {
      json["bufferViews"][3]["byteStride"] = 4;
      json["bufferViews"][3]["target"] = target;
    });
  };
  CHECK(strided(34963) == Told{"violation bufferViews[3].byteStride is not allowed for indices"});
  CHECK(strided(34962).empty());
}

TEST_CASE(
    "An accessor ends with its view at the latest, strided or not, with its own bytes alone at the end") {
  const auto past = [](const char* place) {
    return Told{std::string("error ") + place + " reads past the end of its buffer view"};
  };
  CHECK(toldAt("/accessors/1/count", 7) == past("accessors[1]"));
  CHECK(toldAt("/accessors/1/count", 6).empty());
  CHECK(toldAt("/accessors/1/byteOffset", 2) == past("accessors[1]"));
  const auto strided = [](std::size_t stride, int count) {
    return toldOf([=](Json& json, gltf::Bytes&) {
      json["bufferViews"][2]["byteStride"] = stride;
      json["accessors"][2] = {{"bufferView", 2}, {"componentType", 5126}, {"count", count}, {"type", "VEC2"}};
    });
  };
  CHECK(strided(20, 3).empty()); // 2 * 20 + 8 of 48 bytes
  CHECK(strided(24, 3) == past("accessors[2]"));
  CHECK(strided(8, 6).empty());
  CHECK(strided(4, 3) == Told{"error accessors[2] has elements longer than their stride"});
}

TEST_CASE("The last column of a matrix needs no padding, those before it do") {
  const auto matrix = [](std::size_t bytes) {
    return toldOf([=](Json& json, gltf::Bytes&) {
      json["bufferViews"][3]["byteLength"] = bytes;
      json["accessors"][3] = {{"bufferView", 3}, {"componentType", 5121}, {"count", 1}, {"type", "MAT3"}};
    });
  };
  CHECK(matrix(11).empty()); // two columns of 4 and one of 3
  CHECK(matrix(10) == Told{"error accessors[3] reads past the end of its buffer view"});
}

TEST_CASE("Components lie at multiples of their size, counted from the buffer on") {
  const Told told{"violation accessors[1] is not aligned to the size of its components"};
  const auto shifted = [](std::size_t ofView, std::size_t ofAccessor) {
    return toldOf([=](Json& json, gltf::Bytes&) {
      json["bufferViews"][1]["byteOffset"] = json["bufferViews"][1]["byteOffset"].get<std::size_t>() + ofView;
      json["accessors"][1]["byteOffset"] = ofAccessor;
      json["accessors"][1]["count"] = 2;
    });
  };
  CHECK(shifted(1, 0) == told);
  CHECK(shifted(0, 1) == told);
  CHECK(shifted(1, 1).empty());
  CHECK(shifted(2, 0).empty());
}

TEST_CASE("A type that glTF does not know is told, and the accessor is not used") {
  const Told told{"warning accessors[3] has an unknown type or component type and is not used"};
  CHECK(toldAt("/accessors/3/type", "VEC7") == told);
  CHECK(toldAt("/accessors/3/componentType", 5124) == told);
}

TEST_CASE("Elements without data may be so many, and no more") {
  const auto without = [](std::size_t count) {
    return toldOf([count](Json& json, gltf::Bytes&) {
      json["accessors"][3] = {{"componentType", 5126}, {"count", count}, {"type", "SCALAR"}};
    });
  };
  CHECK(without(gltf::mostZeroElements).empty());
  CHECK(without(gltf::mostZeroElements + 1) == Told{"error accessors[3] has 16777217 elements, but no data"});
}

TEST_CASE("Sparse values have unsigned indices that grow, of elements that are there, and enough bytes") {
  const std::string where = "error accessors[3].sparse";
  CHECK(toldAt("/accessors/3/sparse/indices/componentType", 5126) ==
        Told{where + " has indices that are no unsigned integers"});
  CHECK(toldAt("/accessors/3/sparse/indices/componentType", 5122) ==
        Told{where + " has indices that are no unsigned integers"});
  CHECK(toldAt("/accessors/3/sparse/count", 5) == Told{where + " replaces more elements than there are"});
  CHECK(toldAt("/accessors/3/sparse/count", 3) ==
        Told{where + ".indices reads past the end of its buffer view",
             where + ".values reads past the end of its buffer view"});
  CHECK(toldAt("/accessors/3/sparse/indices/byteOffset", 2) ==
        Told{where + ".indices reads past the end of its buffer view"});
  const auto indices = [](std::uint16_t first, std::uint16_t second) {
    return toldOf([=](Json& json, gltf::Bytes& bytes) {
      const std::size_t at = json["bufferViews"][4]["byteOffset"];
      std::memcpy(bytes.data() + at, &first, 2);
      std::memcpy(bytes.data() + at + 2, &second, 2);
    });
  };
  const Told wrong{where + ".indices are not increasing or point past the last element"};
  CHECK(indices(0, 3).empty());
  CHECK(indices(2, 3).empty());
  CHECK(indices(2, 2) == wrong);
  CHECK(indices(3, 1) == wrong);
  CHECK(indices(0, 4) == wrong);
}

TEST_CASE("Vertex attributes that share a view say how far apart they are, once told for each view") {
  const auto shared = [](int attributes, bool isSaid) {
    return toldOf([=](Json& json, gltf::Bytes&) {
      Json& map = json["meshes"][0]["primitives"][0]["attributes"];
      for (int i = 1; i < attributes; ++i) {
        json["accessors"].push_back({{"bufferView", 0},
                                     {"componentType", 5126},
                                     {"count", 3},
                                     {"type", "SCALAR"},
                                     {"byteOffset", 4 * (i - 1)}});
        map["_MORE_" + std::to_string(i)] = json["accessors"].size() - 1;
      }
      if (isSaid) {
        json["bufferViews"][0]["byteStride"] = 12;
      }
    });
  };
  const Told told{"violation bufferViews[0] holds several vertex attributes, but has no byteStride"};
  CHECK(shared(1, false).empty());
  CHECK(shared(2, false) == told);
  CHECK(shared(3, false) == told);
  CHECK(shared(3, true).empty());
}

TEST_CASE("Attributes of morph targets share views as others do") {
  CHECK(toldOf([](Json& json, gltf::Bytes&) {
          json["accessors"].push_back(
              {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
          json["meshes"][0]["primitives"][0]["targets"] = Json::array({Json{{"POSITION", 4}}});
        }) == Told{"violation bufferViews[0] holds several vertex attributes, but has no byteStride"});
}

TEST_CASE("Least and largest values are what the values have, as near as text is rounded") {
  const Told told{"violation accessors[0] has a min or max that its values do not have"};
  for (const auto& [axis, least, most] : {std::tuple{0, 0.0, 6.0}, {1, 1.0, 7.0}, {2, 2.0, 8.0}}) {
    const std::string min = "/accessors/0/min/" + std::to_string(axis);
    const std::string max = "/accessors/0/max/" + std::to_string(axis);
    const double rounding = 1e-4 * most;
    CHECK(toldAt(min.c_str(), least + 0.9 * rounding).empty());
    CHECK(toldAt(min.c_str(), least - 0.9 * rounding).empty());
    CHECK(toldAt(min.c_str(), least + 1.2 * rounding) == told);
    CHECK(toldAt(min.c_str(), least - 1.2 * rounding) == told);
    CHECK(toldAt(max.c_str(), most + 0.9 * rounding).empty());
    CHECK(toldAt(max.c_str(), most - 1.2 * rounding) == told);
    CHECK(toldAt(max.c_str(), most + 1.2 * rounding) == told);
  }
  CHECK(toldAt("/accessors/0/max", Json::array({6, 7})) == told);
  CHECK(toldAt("/accessors/0/max", Json::array()).empty());
  CHECK(toldOf(
            [](Json& json, gltf::Bytes&) {
              json["accessors"][0]["min"] = {5, 5, 5};
            },
            {0})
            .empty()); // rounded
  CHECK(toldOf([](Json& json, gltf::Bytes&) { json["accessors"][0]["min"] = {5, 5, 5}; }, {1}) == told);
}

TEST_CASE("Least and largest values of fractions are not compared") {
  CHECK(toldOf([](Json& json, gltf::Bytes&) { json["accessors"][1]["min"] = {77}; }) ==
        Told{"violation accessors[1] has a min or max that its values do not have"});
  CHECK(toldOf([](Json& json, gltf::Bytes&) {
          json["accessors"][1]["min"] = {77};
          json["accessors"][1]["normalized"] = true;
        }).empty());
}

TEST_CASE("Values that are no finite numbers are told, but for weights, which can do without") {
  for (const float no : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    CHECK(toldOf([no](Json& json, gltf::Bytes& bytes) { putFloat(bytes, json, 0, 8, no); }) ==
          Told{"violation accessors[0] holds values that are no finite numbers"});
    CHECK(toldOf([no](Json& json, gltf::Bytes& bytes) { putFloat(bytes, json, 2, 11, no); }).empty());
    CHECK(toldOf([no](Json& json, gltf::Bytes& bytes) { putFloat(bytes, json, 3, 0, no); }) ==
          Told{"violation accessors[3] holds values that are no finite numbers"});
  }
}

TEST_CASE("Weights are accessors of the first and the second set of any primitive") {
  const Json json = Json::parse(
      R"({"meshes": [{"primitives": [{"attributes": {"WEIGHTS_0": 3, "WEIGHTS_1": 5, "WEIGHTS_2": 6}}]},
                                  {"primitives": [{"attributes": {"POSITION": 1}}, {}, {"attributes": {"WEIGHTS_0": 0}}]}]})");
  CHECK(gltf::weightAccessors(json) == std::set<int>{0, 3, 5});
  CHECK(gltf::weightAccessors(Json::object()).empty());
}

TEST_CASE("A data file that is missing is an error for each kind of accessor that the model uses") {
  const auto toldWith = [](const char* more, bool hasUri = true) {
    gltf::Source source;
    Json json = Json::parse(R"({"bufferViews": [{"buffer": 0, "byteLength": 8}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"}],
        "buffers": [{"byteLength": 8}]})");
    json.merge_patch(Json::parse(more));
    if (hasUri) {
      json["buffers"][0]["uri"] = "far.bin";
    }
    source.json = json;
    source.buffers.resize(1);
    gltf::Problems problems;
    gltf::validateAccessors(source, {}, problems);
    return problems.hasErrors() ? problems.firstError().line() : std::string();
  };
  const std::string told =
      "buffers[0]: its data ('far.bin') cannot be read, but the model needs it; put the file beside it";
  for (const char* use :
       {R"({"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})",
        R"({"meshes": [{"primitives": [{"attributes": {}, "indices": 0}]}]})",
        R"({"meshes": [{"primitives": [{"attributes": {}, "targets": [{"NORMAL": 0}]}]}]})",
        R"({"skins": [{"inverseBindMatrices": 0}]})", R"({"animations": [{"samplers": [{"input": 0}]}]})",
        R"({"animations": [{"samplers": [{"output": 0}]}]})"}) {
    CHECK(toldWith(use) == told);
    CHECK(toldWith(use, false).empty()); // left to an extension
  }
  CHECK(toldWith("{}").empty()); // nothing uses it
}
