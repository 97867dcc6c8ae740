// A stream read by nothing but its description, docs/stream.md.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/json.h"
#include "core/gltf/load_as_it_stands.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"

using namespace stretch;
using namespace stretch::test;
using gltf::Json;

namespace {

/// A client: it has the base, and shows the frame that it is given.
class StreamClient {
public:
  explicit StreamClient(const std::filesystem::path& base) {
    auto loaded = gltf::loadAsItStands(base);
    REQUIRE(loaded);
    file_ = std::move(loaded).value();
    format_ = (*file_.source->json)["extras"]["stretch_stream"];
    REQUIRE(format_["version"] == 1);
    REQUIRE(file_.clips.empty());
  }

  [[nodiscard]] std::size_t frameBytes() const { return format_["frameBytes"].get<std::size_t>(); }

  [[nodiscard]] std::vector<Vec3> show(std::span<const std::uint8_t> frame) const {
    REQUIRE(frame.size() == frameBytes());
    REQUIRE(frame[0] == 'S');
    REQUIRE(frame[1] == 'F');
    REQUIRE(frame[2] == 1);
    Pose pose = restPose(*file_.scene);
    std::size_t at = 8;
    for (const Json& course : format_["courses"]) {
      const bool isRotation = course["path"] == "rotation";
      const std::vector<double> value =
          numbers(frame, at, course["componentType"] == 5122, isRotation ? 4 : 3);
      for (const Json& node : course["nodes"]) {
        set(pose.locals[node.get<std::size_t>()], course["path"].get<std::string>(), value);
      }
    }
    CHECK(at == frame.size());
    return skinning::skinnedPositions(*file_.scene, frameOf(*file_.scene, pose, 0.0));
  }

private:
  static std::vector<double> numbers(std::span<const std::uint8_t> frame, std::size_t& at, bool isShort,
                                     std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      if (isShort) {
        std::int16_t whole = 0;
        std::memcpy(&whole, frame.data() + at, sizeof(whole));
        values.push_back(whole / 32767.0);
      } else {
        float number = 0.0F;
        std::memcpy(&number, frame.data() + at, sizeof(number));
        values.push_back(static_cast<double>(number));
      }
      at += isShort ? 2 : 4;
    }
    return values;
  }

  static void set(Transform& local, const std::string& path, const std::vector<double>& value) {
    if (path == "rotation") {
      local.rotation = glm::normalize(Quat(value[3], value[0], value[1], value[2]));
    } else {
      (path == "scale" ? local.scale : local.translation) = Vec3(value[0], value[1], value[2]);
    }
  }

  gltf::Loaded file_;
  Json format_;
};

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    most = std::max(most, glm::distance(a[v], b[v]));
  }
  return most;
}

} // namespace

TEST_CASE("a client shows every frame of a stream, in any order, as the clip has it") {
  const TemporaryFolder folder;
  const MeshSequence tube = shorteningTube(7, 2.0, 0.06, 0.1);
  writeObjFrames(tube, folder / "tube", "tube");
  const std::string stretch = GENERATE("none", "elastic", "measured");
  const bool quantised = GENERATE(false, true);
  std::vector<std::string> words{"compress",  (folder / "tube").string(),
                                 "-o",        (folder / "out.glb").string(),
                                 "--stream",  (folder / "s").string(),
                                 "--stretch", stretch,
                                 "--bones",   "6",
                                 "--json"};
  if (quantised) {
    words.emplace_back("--quantise");
  }
  const VerbAnswer answer = runVerb(words);
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  const StreamClient client(folder / "s" / "base.glb");
  const Bytes frames = readBytes(folder / "s" / "frames.bin");
  CHECK(Json::parse(answer.output)["stream"]["bytes_per_frame"] == client.frameBytes());
  REQUIRE(frames.size() == 7 * client.frameBytes());
  const auto clip = gltf::loadAsItStands(folder / "out.glb");
  REQUIRE(clip);
  const double diagonal = boxDiagonal(tube.frame(0));
  for (const std::size_t k : {6, 0, 3, 5, 1}) {
    const auto bytes = std::span(frames).subspan(k * client.frameBytes(), client.frameBytes());
    const double seconds = static_cast<double>(k) / tube.framesPerSecond;
    const FrameState shown =
        frameOf(*clip->scene, samplePose(*clip->scene, clip->clips.at(0), seconds), seconds);
    CHECK(farthest(client.show(bytes), skinning::skinnedPositions(*clip->scene, shown)) < 1e-5 * diagonal);
  }
  // A frame of a stream takes its header more than the clip's, and needs no time.
  const double clipBytes = Json::parse(answer.output)["bytes_per_frame"].get<double>();
  CHECK(static_cast<double>(client.frameBytes()) == Approx(clipBytes - 4.0 + 8.0));
}

TEST_CASE("a stream needs a folder that can be made") {
  const TemporaryFolder folder;
  writeObjFrames(shorteningTube(3, 1.0, 0.0, 0.0), folder / "tube", "tube");
  const auto file = folder.write("taken", "no folder");
  const VerbAnswer answer =
      runVerb({"compress", (folder / "tube").string(), "-o", (folder / "out.glb").string(), "--bones", "3",
               "--stream", (file / "s").string()});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains("taken"));
}
