#include <algorithm>

#include <catch2/catch.hpp>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "skinning/export/append_frames.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/export/frame_stream.h"
#include "tests/support/refusal.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using gltf::Json;

namespace {

/// The base of a stream of a waving tube, and what appending more frames to it says after a change of its
/// JSON.
struct Base {
  Base()
      : skinned(test::wavingTube(3, 4)), stream(streamOf(skinned, false, StreamCourses::all)),
        later(skinAllFrames(skinned)) {}

  template <typename Change>
  Result<AppendedFrames> appended(const Change& change, std::size_t framesBefore = 0,
                                  double mostPercent = 5.0) const {
    gltf::Source source = stream.base;
    change(*source.json);
    REQUIRE(gltf::save(source, folder.path() / "base.glb"));
    return framesForStream(folder.path() / "base.glb", later, framesBefore * stream.frameBytes, mostPercent);
  }

  template <typename Change>
  std::string refused(const Change& change) const {
    return test::refusal(appended(change));
  }

  test::TemporaryFolder folder;
  SkinnedSequence skinned;
  FrameStream stream;
  MeshSequence later;
};

void unchanged(Json& /*json*/) {}

} // namespace

TEST_CASE("Frames that are appended have the length of those before, and go on with their numbers") {
  const Base base;
  const auto more = base.appended(unchanged, 3);
  REQUIRE(more);
  CHECK(more->frameBytes == base.stream.frameBytes);
  CHECK(more->firstNumber == 3);
  CHECK(more->bytes.size() == base.later.frameCount() * base.stream.frameBytes);
  CHECK(more->metrics.rmsePercent < 0.5);
  CHECK(more->skinned.frameCount() == base.later.frameCount());
}

TEST_CASE("Bytes before that are no whole number of frames are refused") {
  const Base base;
  REQUIRE(base.appended(unchanged));
  const std::string told = test::refusal(
      framesForStream(base.folder.path() / "base.glb", base.later, base.stream.frameBytes + 1, 5.0));
  CHECK(told.find("which is no whole number of frames of " + std::to_string(base.stream.frameBytes)) !=
        std::string::npos);
}

TEST_CASE("A file that is no base of a stream is refused, whatever its extras hold") {
  const Base base;
  const std::string none = "the file is not the base of a stream of this version";
  CHECK(base.refused([](Json& json) { json.erase("extras"); }).find(none) != std::string::npos);
  CHECK(base.refused([](Json& json) { json["extras"] = 3; }).find(none) != std::string::npos);
  CHECK(base.refused([](Json& json) { json["extras"]["stretch_stream"] = "yes"; }).find(none) !=
        std::string::npos);
  CHECK(base.refused([](Json& json) { json["extras"]["stretch_stream"].erase("version"); }).find(none) !=
        std::string::npos);
  CHECK(base.refused([](Json& json) { json["extras"]["stretch_stream"]["version"] = 2; }).find(none) !=
        std::string::npos);
  CHECK(base.refused([](Json& json) { json["extras"]["stretch_stream"]["version"] = "1"; }).find(none) !=
        std::string::npos);
  CHECK(base.refused([](Json& json) {
              for (Json& node : json["nodes"]) {
                node.erase("skin");
              }
              json.erase("skins");
            })
            .find(none) != std::string::npos);
}

TEST_CASE("A base whose words of its frames do not fit together is refused") {
  const Base base;
  const auto refusedWith = [&](const auto& change) {
    const std::string told = base.refused([&](Json& json) { change(json["extras"]["stretch_stream"]); });
    INFO(told);
    CHECK(told.find("what the base says of its frames does not fit together") != std::string::npos);
  };
  refusedWith([](Json& stream) { stream["frameBytes"] = stream["frameBytes"].get<std::size_t>() + 4; });
  refusedWith([](Json& stream) { stream["frameBytes"] = "many"; });
  refusedWith([](Json& stream) { stream["frameBytes"] = -8; });
  refusedWith([](Json& stream) { stream["courses"].erase(0); });
  refusedWith([](Json& stream) { stream["courses"] = "none"; });
  refusedWith([](Json& stream) { stream["courses"][0] = 7; });
  refusedWith([](Json& stream) { stream["courses"][0]["nodes"][0] = 100000; });
  refusedWith([](Json& stream) { stream["courses"][0]["nodes"][0] = -1; });
  refusedWith([](Json& stream) { stream["courses"][0]["nodes"][0] = "first"; });
  refusedWith([](Json& stream) {
    stream["courses"][0]["path"] = 3;
    stream["courses"].erase(1);
  });
  refusedWith([](Json& stream) {
    stream["courses"][0]["componentType"] = "short";
    stream["courses"].erase(1);
  });
}

TEST_CASE("Frames of another mesh are refused with both counts, and frames that the bones cannot follow") {
  Base base;
  CHECK(test::refusal(base.appended(unchanged, 0, 0.0))
            .find("the bones of the base follow these frames with an error of") != std::string::npos);
  base.later.triangles.pop_back();
  const std::string other = test::refusal(base.appended(unchanged));
  CHECK(other.find("the base is of another mesh: it draws") != std::string::npos);
  CHECK(other.find(std::to_string(base.later.triangles.size() + 1) + " triangles, the sequence") !=
        std::string::npos);
  CHECK(other.find("and " + std::to_string(base.later.triangles.size())) != std::string::npos);
}

TEST_CASE("A second skin that another program left in the base of a stream changes no frame") {
  const Base base;
  const auto plain = base.appended(unchanged);
  const auto beside = base.appended([](Json& json) {
    Json joints = json["skins"][0]["joints"];
    std::reverse(joints.begin(), joints.end());
    json["skins"].push_back({{"joints", joints}});
  });
  REQUIRE(plain);
  REQUIRE(beside);
  CHECK(beside->bytes == plain->bytes);
}

TEST_CASE("The base of a stream has all triangles of its mesh, however many bytes they take") {
  SkinnedSequence tube = test::wavingTube(3, 4);
  tube.triangles.pop_back(); // Of an odd number of triangles the bytes do not end at a multiple of four.
  REQUIRE(tube.triangles.size() % 2 == 1);
  const auto indicesOf = [](const gltf::Source& source) {
    gltf::Problems problems;
    const Scene scene = gltf::importScene(source, problems, gltf::Pictures::headers);
    return scene.meshes.at(0).primitives.at(0).indices;
  };
  CHECK(indicesOf(streamOf(tube, false, StreamCourses::all).base) == indicesOf(encodeGltf(tube).source));
}

TEST_CASE("A frame of a stream tells its number in four bytes, the lowest first") {
  std::vector<std::uint8_t> bytes;
  putStreamHeader(0x01020304, bytes);
  CHECK(bytes == std::vector<std::uint8_t>{'S', 'F', streamVersion, 0, 4, 3, 2, 1});
}
