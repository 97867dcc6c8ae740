// A stream read by nothing but its description, docs/stream.md.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/glb_builder.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/shapes.h"

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
  CHECK_FALSE(std::filesystem::exists(folder / "out.glb"));
}

TEST_CASE("where the table or a file of the stream cannot be written there is no clip either") {
  const TemporaryFolder folder;
  writeObjFrames(shorteningTube(3, 1.0, 0.0, 0.0), folder / "tube", "tube");
  const std::string taken = GENERATE("s/base.glb", "s/frames.bin", "table.csv");
  std::filesystem::create_directories(folder / taken); // A folder in the place of the file.
  const VerbAnswer answer =
      runVerb({"compress", (folder / "tube").string(), "-o", (folder / "out.glb").string(), "--bones", "3",
               "--stream", (folder / "s").string(), "--curvature", (folder / "table.csv").string()});
  CAPTURE(taken, answer.told);
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains(taken));
  CHECK_FALSE(std::filesystem::exists(folder / "out.glb"));
}

namespace {

/// Frames of a sequence as a sequence of their own.
MeshSequence framesOf(const MeshSequence& sequence, std::size_t first, std::size_t count) {
  MeshSequence part = sequence;
  const auto at = [&](std::size_t frame) {
    return sequence.positions.begin() + static_cast<std::ptrdiff_t>(frame * sequence.vertexCount);
  };
  part.positions.assign(at(first), at(first + count));
  return part;
}

} // namespace

TEST_CASE("frames of a longer simulation are appended to a stream, and any of them is shown by itself") {
  const TemporaryFolder folder;
  const MeshSequence tube = shorteningTube(12, 2.0, 0.06, 0.1);
  writeObjFrames(framesOf(tube, 0, 8), folder / "begun", "tube");
  writeObjFrames(framesOf(tube, 8, 4), folder / "later", "tube");
  const std::string stretch = GENERATE("none", "elastic", "measured");
  const bool quantised = GENERATE(false, true);
  std::vector<std::string> words{"compress",  (folder / "begun").string(),
                                 "-o",        (folder / "begun.glb").string(),
                                 "--stream",  (folder / "s").string(),
                                 "--stretch", stretch,
                                 "--bones",   "8",
                                 "--json",    "--open-stream"};
  if (quantised) {
    words.emplace_back("--quantise");
  }
  const VerbAnswer made = runVerb(words);
  INFO(made.told);
  REQUIRE(made.exitCode == 0);
  const Json told = Json::parse(made.output)["stream"];
  CHECK(told["bytes_per_frame"] == told["open_bytes_per_frame"]);
  CHECK(told["changing_bytes_per_frame"] <= told["open_bytes_per_frame"]);
  const Bytes base = readBytes(folder / "s" / "base.glb");
  const Bytes before = readBytes(folder / "s" / "frames.bin");
  const VerbAnswer appended =
      runVerb({"compress", (folder / "later").string(), "-o", (folder / "later.glb").string(), "--append",
               (folder / "s").string(), "--tolerance", "4%", "--json"});
  INFO(appended.told);
  REQUIRE(appended.exitCode == 0);
  const Json report = Json::parse(appended.output);
  CHECK(report["first_number"] == 8);
  CHECK(readBytes(folder / "s" / "base.glb") == base);
  const Bytes frames = readBytes(folder / "s" / "frames.bin");
  REQUIRE(frames.size() == before.size() / 8 * 12);
  CHECK(std::equal(before.begin(), before.end(), frames.begin()));
  const StreamClient client(folder / "s" / "base.glb");
  const double diagonal = boxDiagonal(tube.frame(8));
  double largest = 0.0;
  for (const std::size_t k : {11, 8, 10, 9}) {
    const auto bytes = std::span(frames).subspan(k * client.frameBytes(), client.frameBytes());
    CHECK(bytes[4] == k);
    const std::vector<Vec3> shown = client.show(bytes);
    const auto source = tube.frame(k);
    REQUIRE(shown.size() == source.size());
    largest = std::max(largest, farthest(shown, {source.begin(), source.end()}));
  }
  CHECK(100.0 * largest / diagonal == Approx(report["largest_percent"].get<double>()).margin(1e-3));
  if (stretch != "none") {
    CHECK(report["rmse_percent"] < 1.0);
  }
}

TEST_CASE(
    "a stream takes no frames of another mesh, none that its bones do not follow, and none behind a cut") {
  const TemporaryFolder folder;
  const MeshSequence tube = shorteningTube(8, 2.0, 0.06, 0.1);
  writeObjFrames(framesOf(tube, 0, 2), folder / "begun", "tube");
  writeObjFrames(framesOf(tube, 5, 3), folder / "later", "tube");
  writeObjFrames(still(torus(2.0, 0.5, 24, 12)), folder / "ring", "ring");
  const auto run = [&](const std::string& sequence, const std::vector<std::string>& more) {
    std::vector<std::string> words{"compress", (folder / sequence).string(), "-o",
                                   (folder / (sequence + ".glb")).string()};
    words.insert(words.end(), more.begin(), more.end());
    return runVerb(words);
  };
  const std::string stream = (folder / "s").string();
  REQUIRE(run("begun", {"--stream", stream, "--bones", "2", "--stretch", "none"}).exitCode == 0);
  const Bytes before = readBytes(folder / "s" / "frames.bin");
  const auto refused = [&](const VerbAnswer& answer, const char* why, int exitCode = 1) {
    CHECK(answer.exitCode == exitCode);
    CHECK_THAT(answer.told, Catch::Contains(why));
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
    CHECK(readBytes(folder / "s" / "frames.bin") == before);
  };
  refused(run("ring", {"--append", stream}), "another mesh");
  refused(run("later", {"--append", stream, "--tolerance", "0.01%"}), "more than 0.01 %");
  refused(run("later", {"--append", stream, "--stream", (folder / "t").string()}), "leave out --stream", 2);
  refused(run("later", {"--append", stream, "--bones", "4"}), "--bones", 2);
  refused(run("later", {"--append", (folder / "nowhere").string()}), "nowhere");
  Bytes cut(before.begin(), before.end() - 3);
  REQUIRE(writeFile(folder / "s" / "frames.bin", cut));
  const VerbAnswer answer = run("later", {"--append", stream, "--tolerance", "50%"});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains("no whole number of frames"));
}
