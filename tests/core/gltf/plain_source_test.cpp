#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/source/plain_parts.h"

using namespace stretch;
using gltf::Bytes;
using gltf::Json;
using gltf::PlainSource;
using gltf::Source;

namespace {

Source twoBuffers() {
  Source source;
  source.json = Json::parse(R"({"buffers": [{"byteLength": 4}, {"byteLength": 3}]})");
  source.buffers = {{1, 2, 3, 4}, {5, 6, 7}};
  return source;
}

std::optional<Bytes> named(const char* json) {
  const Source source = twoBuffers();
  const auto bytes = gltf::namedBytes(source, Json::parse(json));
  return bytes ? std::optional(Bytes(bytes->begin(), bytes->end())) : std::nullopt;
}

} // namespace

TEST_CASE("Bytes are named by their buffer, from where on and how many, all within it") {
  CHECK(named(R"({"buffer": 0, "byteLength": 4})") == Bytes{1, 2, 3, 4});
  CHECK(named(R"({"buffer": 0, "byteOffset": 1, "byteLength": 2})") == Bytes{2, 3});
  CHECK(named(R"({"buffer": 1, "byteOffset": 2, "byteLength": 1})") == Bytes{7});
  CHECK_FALSE(named(R"({"buffer": 1, "byteOffset": 2, "byteLength": 2})"));
  CHECK_FALSE(named(R"({"buffer": 1, "byteOffset": 4, "byteLength": 1})"));
  CHECK_FALSE(named(R"({"buffer": 1, "byteOffset": 3, "byteLength": 0})"));
  CHECK_FALSE(named(R"({"buffer": 1})"));
  CHECK_FALSE(named(R"({"buffer": 2, "byteLength": 1})"));
  CHECK_FALSE(named(R"({"buffer": -1, "byteLength": 1})"));
  CHECK_FALSE(named(R"({"byteLength": 1})"));
  CHECK_FALSE(named(R"({"buffer": 0, "byteOffset": 9007199254740991, "byteLength": 2})"));
}

TEST_CASE("A buffer of decoded bytes is added behind the others") {
  PlainSource plain{twoBuffers(), {}, 0, 0};
  CHECK(gltf::addPlainBuffer(plain, {9, 9}) == 2);
  CHECK(gltf::addPlainBuffer(plain, {8}) == 3);
  CHECK(plain.decodedBytes == 3);
  CHECK((*plain.source.json)["buffers"][2]["byteLength"] == 2);
  CHECK(plain.source.buffers[2] == Bytes{9, 9});
  CHECK(plain.source.buffers[3] == Bytes{8});
  CHECK(plain.source.buffers[0] == Bytes{1, 2, 3, 4});
}

TEST_CASE("A file decodes to 4 MiB and 256 bytes from each of its own, 1.5 GiB at most, all parts together") {
  const auto left = [](std::size_t packed, std::size_t decoded) {
    PlainSource plain;
    plain.packedBytes = packed;
    plain.decodedBytes = decoded;
    return gltf::bytesLeftToDecode(plain);
  };
  constexpr std::size_t small = 4194304;
  CHECK(left(0, 0) == small);
  CHECK(left(1000, 0) == small + 256000);
  CHECK(left(1000, 250000) == small + 6000);
  CHECK(left(0, small) == 0);
  CHECK(left(0, small + 1) == 0);
  CHECK(left(100000000, 0) == 1610612736);
  CHECK(left(100000000, 10) == 1610612726);
}

TEST_CASE("A buffer is a fallback where its extension says so") {
  CHECK(gltf::isFallbackBuffer(
      Json::parse(R"({"extensions": {"EXT_meshopt_compression": {"fallback": true}}})")));
  CHECK_FALSE(gltf::isFallbackBuffer(
      Json::parse(R"({"extensions": {"EXT_meshopt_compression": {"fallback": false}}})")));
  CHECK_FALSE(gltf::isFallbackBuffer(Json::parse(R"({"extensions": {"EXT_meshopt_compression": {}}})")));
  CHECK_FALSE(gltf::isFallbackBuffer(Json::parse(R"({"fallback": true})")));
}

TEST_CASE("A file that packs nothing is plain as it is") {
  gltf::Problems problems;
  CHECK_FALSE(gltf::plainSource(twoBuffers(), problems));
  CHECK_FALSE(gltf::withPlainViews(twoBuffers(), problems));
  CHECK_FALSE(problems.hasErrors());
}
