#include <catch2/catch.hpp>

#include <map>
#include <string>

#include "core/gltf/json/json.h"
#include "core/gltf/source/glb.h"
#include "core/gltf/source/json_text.h"
#include "core/gltf/source/uri.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::gltf;

namespace {

Glb sample() {
  Glb glb;
  glb.json = R"({"a":1})";
  glb.hasBinary = true;
  glb.binary = {1, 2, 3, 4, 5};
  glb.others = {{0x12345678, {9, 9, 9, 9}}};
  return glb;
}

Bytes sampleBytes() {
  return writeGlb(sample()).value();
}

} // namespace

TEST_CASE("Chunks of a GLB survive writing and reading") {
  const Result<Glb> read = readGlb(sampleBytes());
  REQUIRE(read.ok());
  CHECK(read->json == R"({"a":1} )");
  CHECK(read->binary == Bytes{1, 2, 3, 4, 5, 0, 0, 0});
  CHECK(read->others == sample().others);
  CHECK(read->warnings.empty());
}

TEST_CASE("Every truncation of a GLB is refused") {
  const Bytes whole = sampleBytes();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CHECK_FALSE(readGlb(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))).ok());
  }
}

namespace {

void appendNumber(Bytes& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

// A GLB of these chunks as they are, and loose bytes behind them that its header counts in.
Bytes glbOf(const std::vector<GlbChunk>& chunks, std::size_t loose = 0) {
  Bytes body;
  for (const GlbChunk& chunk : chunks) {
    appendNumber(body, static_cast<std::uint32_t>(chunk.bytes.size()));
    appendNumber(body, chunk.type);
    body.insert(body.end(), chunk.bytes.begin(), chunk.bytes.end());
  }
  body.resize(body.size() + loose);
  Bytes bytes{'g', 'l', 'T', 'F'};
  appendNumber(bytes, 2);
  appendNumber(bytes, static_cast<std::uint32_t>(12 + body.size()));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

} // namespace

TEST_CASE("What is wrong with the chunks of a GLB is told") {
  const GlbChunk json{GlbChunk::jsonType, {'{', '}', ' ', ' '}};
  const GlbChunk binary{GlbChunk::binaryType, {1, 2, 3, 4}};
  REQUIRE(readGlb(glbOf({json, binary})).ok());
  const auto whatOf = [](const Bytes& bytes) {
    const Result<Glb> read = readGlb(bytes);
    return read ? std::string("nothing") : read.error().what;
  };
  CHECK(whatOf(glbOf({json, binary, binary})) == "has two BIN chunks");
  CHECK(whatOf(glbOf({json, json})) == "has two JSON chunks");
  CHECK(whatOf(glbOf({binary, json})) == "its first chunk is not JSON");
  CHECK(whatOf(glbOf({{GlbChunk::jsonType, {}}, binary})) == "its JSON chunk is empty");
  for (std::size_t loose = 1; loose < 8; ++loose) {
    CHECK(whatOf(glbOf({json, binary}, loose)) == "ends within the header of a chunk");
  }
  Bytes longer = glbOf({json, binary});
  longer[longer.size() - 12] = 5;
  CHECK(whatOf(longer) == "a chunk reaches past the end");
}

TEST_CASE("A chunk that is not padded, and one padded with zeros, are read with a warning") {
  const Result<Glb> unpadded = readGlb(glbOf({{GlbChunk::jsonType, {'{', '}'}}}));
  REQUIRE(unpadded.ok());
  CHECK(unpadded->warnings == std::vector<std::string>{"a chunk is not padded to 4 bytes"});
  const Result<Glb> zeros = readGlb(glbOf({{GlbChunk::jsonType, {'{', '}', 0, 0}}}));
  REQUIRE(zeros.ok());
  CHECK(zeros->json == "{}");
  CHECK(zeros->warnings == std::vector<std::string>{"the JSON chunk is padded with zeros instead of spaces"});
}

TEST_CASE("Bytes after the end of a GLB are warned of") {
  Bytes bytes = sampleBytes();
  bytes.push_back(0);
  CHECK(readGlb(bytes)->warnings.size() == 1);
}

TEST_CASE("JSON that is not allowed is refused, order of keys kept otherwise") {
  const std::string nested = std::string(300, '[') + std::string(300, ']');
  for (const auto& [text, reason] :
       std::map<std::string, std::string>{{"\xEF\xBB\xBF{}", "starts with a byte order mark"},
                                          {"[]", "is not a JSON object"},
                                          {"{", "is no valid JSON"},
                                          {R"({"a":1e999})", "holds a number out of range"},
                                          {"{\"a\":\"\xFF\"}", "is no valid JSON"},
                                          {R"({"a":)" + nested + "}", "is nested deeper than 256 levels"}}) {
    CHECK_THAT(test::refusal(parseJson(text)), Catch::StartsWith("JSON: " + reason));
  }
  CHECK(parseJson(R"({"b":"[[{\"","a":12345678901})")->dump() == R"({"b":"[[{\"","a":12345678901})");
}

TEST_CASE("A deep nesting of a hundred thousand brackets is refused, not recursed into") {
  CHECK_THAT(test::refusal(parseJson(R"({"a":)" + std::string(100000, '['))),
             Catch::StartsWith("JSON: is nested deeper than 256 levels"));
}

TEST_CASE("Brackets nest where they stand outside of texts, and to 256 levels") {
  const auto nested = [](std::size_t depth) { // the object itself is one level
    return std::string(depth - 1, '[') + std::string(depth - 1, ']');
  };
  CHECK(parseJson(R"({"a":)" + nested(256) + "}").ok());
  CHECK_FALSE(parseJson(R"({"a":)" + nested(257) + "}").ok());
  CHECK(parseJson(R"({"a":)" + nested(200) + R"(,"b":)" + nested(200) + "}").ok());
  const std::string brackets(300, '[');
  CHECK(parseJson(R"({"a":")" + brackets + R"(","b":1})").ok());
  CHECK(parseJson(R"({"a":"\"{{)" + brackets + R"(","b":1})").ok());
  CHECK(parseJson(R"({")" + brackets + R"(":{"a":")" + std::string(300, '{') + R"("}})").ok());
  CHECK_THAT(test::refusal(parseJson(R"({"a":"\\","b":)" + nested(257) + "}")),
             Catch::Contains("nested deeper than 256"));
  CHECK(parseAnyJson(nested(257)).is_array()); // no object around it
  CHECK(parseAnyJson(nested(258)).is_discarded());
}

TEST_CASE("Base64 gives back what it took") {
  Bytes bytes;
  for (int length = 0; length < 9; ++length) {
    const auto data = decodeDataUri("data:application/octet-stream;base64," + encodeBase64(bytes));
    REQUIRE(data.has_value());
    CHECK(data->bytes == bytes);
    CHECK(data->mediaType == "application/octet-stream");
    bytes.push_back(static_cast<std::uint8_t>(255 - 31 * length));
  }
}

TEST_CASE("Data URIs that are not base64 are taken as written") {
  const std::optional<DataUri> data = decodeDataUri("data:text/plain,a%20b");
  REQUIRE(data.has_value());
  CHECK(data->bytes == Bytes{'a', ' ', 'b'});
}

TEST_CASE("Malformed data URIs are refused") {
  const char* const uri = GENERATE("data:", "data:;base64", "data:;base64,A", "data:;base64,A*==");
  CHECK_FALSE(decodeDataUri(uri).has_value());
}

TEST_CASE("Relative URIs are paths, others are not") {
  CHECK(relativePath("a%20b/c.bin") == std::filesystem::path("a b/c.bin"));
  CHECK(relativePath("100%.bin") == std::filesystem::path("100%.bin"));
  for (const char* const uri :
       {"", "http://example.com/a.bin", "file:///etc/passwd", "/etc/passwd", "C:a.bin", "a%00b", "dir/"}) {
    CHECK_FALSE(relativePath(uri).has_value());
  }
  CHECK(escapesFolder("../a.png"));
  CHECK(escapesFolder("b/../../a.png"));
  CHECK_FALSE(escapesFolder("b/../a.png"));
  CHECK(relativePath(percentEncoded("ö #1%.bin")) == std::filesystem::path(u8"ö #1%.bin"));
}
