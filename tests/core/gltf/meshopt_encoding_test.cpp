#include "core/gltf/packed/meshopt_encoding.h"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/core/compressed_files.h"

using namespace stretch;
using gltf::Json;
using gltf::Source;

namespace {

constexpr const char* extension = "EXT_meshopt_compression";

Json viewOf(const Source& source, std::size_t accessor) {
  return (
      *source.json)["bufferViews"][(*source.json)["accessors"][accessor]["bufferView"].get<std::size_t>()];
}

bool isPacked(const Source& source, std::size_t accessor) {
  return viewOf(source, accessor).contains("extensions");
}

/// The file written with its views packed, and read again.
gltf::Loaded reopened(const Source& source) {
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(source, folder.path() / "packed.glb"));
  Result<gltf::Loaded> loaded = gltf::load(folder.path() / "packed.glb");
  if (!loaded) {
    FAIL(loaded.error().line());
  }
  CHECK(loaded->warnings.empty());
  return std::move(loaded).value();
}

/// A file of lists that the packing holds and of some that it does not, with an image.
struct Lists {
  Lists() {
    file.json = Json::parse(R"({"asset": {"version": "2.0"}})");
    strides[add(file.floats({1, 2, 3, 4, 5, 6}, "VEC3", 3))] = 12;
    strides[add(file.floats({1, 2, 3, 4, 5, 6}, "VEC2", 2))] = 8;
    strides[add(file.floats(std::vector<float>(32, 2.0F), "MAT4", 16))] = 64;
    strides[add(file.floats({0, 1, 2}, "SCALAR", 1))] = 4;
    strides[add(file.accessor<std::uint8_t>({1, 2, 3, 4, 5, 6, 7, 8}, 5121, "VEC4", 4))] = 4;
    strides[add(file.accessor<std::int16_t>({1, 2, 3, 4, 5, 6, 7, 8}, 5122, "VEC2", 2))] = 4;
    file.json["bufferViews"].back()["byteStride"] = 4;
    strides[triangles(file.accessor<std::uint16_t>({0, 1, 2}, 5123, "SCALAR", 1))] = 2;
    strides[triangles(file.accessor<std::uint32_t>({0, 1, 70000}, 5125, "SCALAR", 1))] = 4;
    asTheyAre.push_back(add(file.accessor<std::int8_t>({1, 2, 3}, 5120, "VEC3", 3)));
    asTheyAre.push_back(add(file.accessor<std::uint16_t>({1, 2, 3}, 5123, "VEC3", 3)));
    asTheyAre.push_back(triangles(file.accessor<std::uint8_t>({0, 1, 2}, 5121, "SCALAR", 1)));
    asTheyAre.push_back(triangles(file.accessor<std::uint16_t>({0, 1, 2, 3}, 5123, "SCALAR", 1)));
    file.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 4}, {"byteLength", 5}}); // an image
    source.json = file.json;
    source.buffers = {file.binary};
  }

  static std::size_t add(int accessor) { return static_cast<std::size_t>(accessor); }

  std::size_t triangles(int accessor) {
    file.json["bufferViews"].back()["target"] = 34963;
    corners.insert(add(accessor));
    return add(accessor);
  }

  test::GlbBuilder file;
  std::map<std::size_t, int> strides; ///< Of the lists that can be packed.
  std::set<std::size_t> corners;
  std::vector<std::size_t> asTheyAre;
  Source source;
};

std::vector<std::uint8_t> bytesOfView(const Source& source, const Json& view) {
  const auto start = source.buffers[0].begin() + view["byteOffset"].get<std::ptrdiff_t>();
  return {start, start + view["byteLength"].get<std::ptrdiff_t>()};
}

} // namespace

TEST_CASE("A file that was packed opens as the plain one, and takes fewer bytes") {
  const gltf::Loaded plain = test::loaded(test::tubeBuilder());
  const Source packed = gltf::withMeshopt(*plain.source);
  CHECK(packed.buffers[0].size() * 5 < 3 * plain.source->buffers[0].size());
  const gltf::Loaded back = reopened(packed);
  const Primitive& found = back.scene->meshes[0].primitives[0];
  const Primitive& expected = plain.scene->meshes[0].primitives[0];
  CHECK(found.positions == expected.positions);
  CHECK(found.normals == expected.normals);
  CHECK(found.texCoords == expected.texCoords);
  REQUIRE(found.influences.size() == expected.influences.size());
  for (std::size_t i = 0; i < found.influences.size(); ++i) {
    CHECK(found.influences[i].joints == expected.influences[i].joints);
    CHECK(found.influences[i].weights == expected.influences[i].weights);
  }
  // The codec may turn a triangle's corners around, in their order.
  REQUIRE(found.indices.size() == expected.indices.size());
  const auto sortedTriangles = [](const std::vector<std::uint32_t>& indices) {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      std::vector<std::uint32_t> corners{indices[i], indices[i + 1], indices[i + 2]};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      triangles.push_back(corners);
    }
    return triangles;
  };
  CHECK(sortedTriangles(found.indices) == sortedTriangles(expected.indices));
  REQUIRE(back.clips.size() == plain.clips.size());
  for (std::size_t clip = 0; clip < back.clips.size(); ++clip) {
    REQUIRE(back.clips[clip].tracks.size() == plain.clips[clip].tracks.size());
    for (std::size_t i = 0; i < back.clips[clip].tracks.size(); ++i) {
      CHECK(back.clips[clip].tracks[i]->times == plain.clips[clip].tracks[i]->times);
      CHECK(back.clips[clip].tracks[i]->values == plain.clips[clip].tracks[i]->values);
    }
  }
}

TEST_CASE("Lists of whole four bytes and triangles of 16 and 32 bits are packed, and told with their stride "
          "and count") {
  const Lists lists;
  const Source packed = gltf::withMeshopt(lists.source);
  for (const auto& [one, stride] : lists.strides) {
    INFO(one);
    const Json view = viewOf(packed, one);
    REQUIRE(isPacked(packed, one));
    CHECK(view["buffer"] == 1);
    CHECK(view["byteOffset"] == viewOf(lists.source, one)["byteOffset"]);
    const Json& held = view["extensions"][extension];
    CHECK(held["buffer"] == 0);
    CHECK(held["byteOffset"].get<std::size_t>() % 4 == 0);
    CHECK(held["byteStride"] == stride);
    CHECK(held["count"] == (*packed.json)["accessors"][one]["count"]);
    CHECK(held["mode"] == (lists.corners.contains(one) ? "TRIANGLES" : "ATTRIBUTES"));
    CHECK(gltf::storedBytes(packed.json, one) == held["byteLength"].get<std::size_t>());
  }
  CHECK((*packed.json)["buffers"] == Json{{{"byteLength", packed.buffers[0].size()}},
                                          {{"byteLength", lists.source.buffers[0].size()},
                                           {"extensions", {{extension, {{"fallback", true}}}}}}});
  CHECK((*packed.json)["extensionsUsed"] == Json{extension});
  CHECK((*packed.json)["extensionsRequired"] == Json{extension});
}

TEST_CASE("What the packing cannot hold stays as it is: elements off four bytes, other indices, images") {
  const Lists lists;
  const Source packed = gltf::withMeshopt(lists.source);
  for (const std::size_t one : lists.asTheyAre) {
    INFO(one);
    CHECK_FALSE(isPacked(packed, one));
    const Json before = viewOf(lists.source, one);
    const Json after = viewOf(packed, one);
    CHECK(after["buffer"] == 0);
    CHECK(after["byteOffset"].get<std::size_t>() % 4 == 0);
    CHECK(bytesOfView(packed, after) == bytesOfView(lists.source, before));
    CHECK(gltf::storedBytes(packed.json, one) == before["byteLength"].get<std::size_t>());
  }
  const Json& image = (*packed.json)["bufferViews"].back();
  CHECK_FALSE(image.contains("extensions"));
  CHECK(bytesOfView(packed, image) == bytesOfView(lists.source, (*lists.source.json)["bufferViews"].back()));
  CHECK(packed.buffers[0].size() % 4 == 0);
}
