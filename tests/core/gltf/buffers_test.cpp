// Where the bytes of a file's buffers come from, and what is told where they are not there.
#include <functional>

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/read/read.h"
#include "core/gltf/source/problems.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;
using gltf::Bytes;
using gltf::Json;

namespace {

struct ReadBuffers {
  std::vector<Bytes> bytes;
  std::vector<gltf::Problem> told;
};

/// Buffers of a .gltf in a folder that holds "data.bin" with 1 2 3 4 5.
ReadBuffers buffersOf(const Json& buffers, const Bytes& chunk = {}) {
  const test::TemporaryFolder folder;
  const std::filesystem::path inner = folder.path() / "inner";
  std::filesystem::create_directories(inner);
  test::writeBytes(inner / "data.bin", {1, 2, 3, 4, 5});
  test::writeBytes(folder.path() / "outside.bin", {9});
  gltf::Source source;
  source.path = inner / "model.gltf";
  source.json = Json{{"buffers", buffers}};
  source.hasBinaryChunk = !chunk.empty();
  if (!chunk.empty()) {
    source.buffers = {chunk};
  }
  gltf::Problems problems;
  gltf::readBuffers(source, problems);
  return {source.buffers, problems.list()};
}

void checkTold(const ReadBuffers& read, gltf::Severity severity, const std::string& where,
               const std::string& what) {
  REQUIRE(read.told.size() == 1);
  CHECK(read.told[0].severity == severity);
  CHECK(read.told[0].where == where);
  CHECK(read.told[0].what == what);
}

} // namespace

TEST_CASE("Bytes of a buffer come from its URI, the file that it names or the chunk beside the JSON") {
  const ReadBuffers read =
      buffersOf(Json::parse(R"([{"byteLength": 2, "uri": "data:application/octet-stream;base64,AQID"},
      {"byteLength": 5, "uri": "data.bin"}, {"byteLength": 1, "uri": "data:application/gltf-buffer;base64,Bw=="}])"));
  CHECK(read.told.empty());
  CHECK(read.bytes == std::vector<Bytes>{{1, 2, 3}, {1, 2, 3, 4, 5}, {7}});
  const ReadBuffers chunk = buffersOf(Json::parse(R"([{"byteLength": 4}])"), {4, 3, 2, 1});
  CHECK(chunk.told.empty());
  CHECK(chunk.bytes == std::vector<Bytes>{{4, 3, 2, 1}});
}

TEST_CASE("A buffer that is not there is told, and has no bytes") {
  using gltf::Severity;
  const auto read = [](const char* json) {
    ReadBuffers one = buffersOf(Json::array({Json::parse(json)}));
    CHECK(one.bytes == std::vector<Bytes>{{}});
    return one;
  };
  checkTold(read(R"({"byteLength": 1})"), Severity::warning, "buffers[0]",
            "has neither a uri nor a BIN chunk; its values are taken as zeros");
  checkTold(read(R"({"byteLength": 1, "uri": "data:application/octet-stream;base64,A"})"), Severity::error,
            "buffers[0].uri", "is a malformed data URI");
  checkTold(read(R"({"byteLength": 1, "uri": "http://example.org/a.bin"})"), Severity::violation,
            "buffers[0].uri", "'http://example.org/a.bin' is no relative path and is not read");
  checkTold(read(R"({"byteLength": 1, "uri": "../outside.bin"})"), Severity::warning, "buffers[0].uri",
            "'../outside.bin' lies outside the file's folder and is not read");
  checkTold(read(R"({"byteLength": 1, "uri": "gone.bin"})"), Severity::warning, "buffers[0].uri",
            "'gone.bin' cannot be read");
  CHECK(read(R"({"byteLength": 1, "extensions": {"EXT_meshopt_compression": {"fallback": true}}})")
            .told.empty());
}

TEST_CASE("A buffer's URI of another media type breaks the rules and is read") {
  const ReadBuffers read =
      buffersOf(Json::parse(R"([{"byteLength": 1, "uri": "data:image/png;base64,Bw=="}])"));
  checkTold(read, gltf::Severity::violation, "buffers[0].uri",
            "has the media type 'image/png', not application/octet-stream");
  CHECK(read.bytes == std::vector<Bytes>{{7}});
}

TEST_CASE("A buffer that says more bytes than there are is refused, a chunk may be padded by three") {
  const auto said = [](std::size_t length, const Bytes& chunk) {
    return buffersOf(Json::array({Json{{"byteLength", length}}}), chunk);
  };
  checkTold(said(5, {1, 2, 3, 4}), gltf::Severity::error, "buffers[0]", "says 5 bytes, but there are only 4");
  CHECK(said(4, {1, 2, 3, 4}).told.empty());
  CHECK(said(1, {1, 2, 3, 4}).told.empty());
  checkTold(said(1, {1, 2, 3, 4, 5}), gltf::Severity::warning, "buffers[0]",
            "says 1 bytes, but the BIN chunk has 5");
  // Only of a chunk: a file beside may be longer.
  CHECK(buffersOf(Json::parse(R"([{"byteLength": 1, "uri": "data.bin"}])")).told.empty());
  checkTold(buffersOf(Json::parse(R"([{"byteLength": 6, "uri": "data.bin"}])")), gltf::Severity::error,
            "buffers[0]", "says 6 bytes, but there are only 5");
  // The chunk is the first buffer's alone.
  const ReadBuffers two = buffersOf(Json::parse(R"([{"byteLength": 2}, {"byteLength": 1}])"), {1, 2});
  checkTold(two, gltf::Severity::warning, "buffers[1]",
            "has neither a uri nor a BIN chunk; its values are taken as zeros");
}

TEST_CASE(
    "What an edit adds goes behind the first buffer, and into a new one where that one's file is missing") {
  const bool isThere = GENERATE(true, false);
  CAPTURE(isThere);
  const test::TemporaryFolder folder;
  test::GlbBuilder glb = test::armBuilder();
  glb.json["buffers"] = {{{"uri", "first.bin"}, {"byteLength", 8}},
                         {{"uri", "second.bin"}, {"byteLength", glb.binary.size()}}};
  for (Json& view : glb.json["bufferViews"]) {
    view["buffer"] = 1;
  }
  if (isThere) {
    test::writeBytes(folder / "first.bin", Bytes(8, 1));
  }
  test::writeBytes(folder / "second.bin", glb.binary);
  const Result<gltf::Loaded> file = gltf::load(folder.write("model.gltf", glb.json.dump()));
  REQUIRE(file);
  gltf::Edits edits;
  edits.clips = {{0, {{NodeIndex(1), Channel::scale, Interpolation::linear, 3, {0.0F}, {1, 2, 3}, -1}}}};
  const Result<gltf::Source> changed = gltf::patched(*file->source, edits);
  REQUIRE(changed);
  const Json& json = changed->json;
  const std::size_t grown = isThere ? 0 : 2;
  CHECK(changed->buffers.size() == (isThere ? 2 : 3));
  CHECK(json["bufferViews"].back()["buffer"] == grown);
  CHECK(json["buffers"][0].contains("uri") == !isThere);
  CHECK(changed->buffers[0].empty() == !isThere);
  CHECK(changed->buffers[1] == file->source->buffers[1]);
  CHECK(changed->buffers[grown].size() == (isThere ? 8U : 0U) + 4 * sizeof(float));
}
