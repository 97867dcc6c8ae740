#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/source.h"
#include "skinning/compress/compress.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/export/key_plan.h"
#include "skinning/export/read_back.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

// A body of bones that turn slowly to and fro about their beginnings.
SkinnedSequence slowlyTurningBody() {
  SkinnedSequence slow = test::armedBody(2);
  constexpr std::size_t frames = 90;
  slow.poses.clear();
  for (std::size_t k = 0; k < frames; ++k) {
    for (std::size_t b = 0; b < slow.bones.size(); ++b) {
      const double angle = 0.15 * std::sin(2.0 * pi * static_cast<double>(k) / 60.0 + static_cast<double>(b));
      slow.poses.push_back({slow.bones[b].pivot, glm::angleAxis(angle, Vec3(0.0, 0.0, 1.0)), Vec3(1.0),
                            Quat(1.0, 0.0, 0.0, 0.0)});
      slow.bones[b].parent = -1;
    }
  }
  return slow;
}

SkinnedSequence measuredBody() {
  CompressSettings settings;
  settings.bones = 6;
  settings.stretch = StretchOption::measured;
  auto result = compress(skinAllFrames(test::armedBody(48)), settings);
  REQUIRE(result);
  return std::move(result).value().skinned;
}

struct WrittenClip {
  EncodedClip clip;
  double largestPercent = 0.0; ///< Of the file, against what was encoded.
  std::size_t fileBytes = 0;
  double seconds = 0.0;
  double framesPerSecond = 0.0;
};

WrittenClip written(const SkinnedSequence& skinned, const EncodeSettings& settings) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "clip.glb";
  WrittenClip result;
  result.clip = encodeGltf(skinned, settings);
  REQUIRE(gltf::save(result.clip.source, path));
  const auto loaded = gltf::load(path);
  REQUIRE(loaded);
  REQUIRE(loaded->clips.size() == 1);
  result.seconds = loaded->clips.front().endSeconds;
  result.framesPerSecond = loaded->clips.front().framesPerSecond;
  const auto error = errorOfFile(path, result.clip, skinAllFrames(skinned));
  REQUIRE(error);
  result.largestPercent = error->largestPercent;
  result.fileBytes = std::filesystem::file_size(path);
  return result;
}

bool isRequired(const EncodedClip& clip, const char* extension) {
  const gltf::Json& json = clip.source.json;
  for (const char* const list : {"extensionsUsed", "extensionsRequired"}) {
    if (!json.contains(list) || std::ranges::find(json[list], extension) == json[list].end()) {
      return false;
    }
  }
  return true;
}

} // namespace

TEST_CASE("smooth turns keep less than a third of their keys") {
  const SkinnedSequence slow = slowlyTurningBody();
  const WrittenClip every = written(slow, {});
  REQUIRE(every.clip.keys == slow.frameCount() * slow.bones.size());
  EncodeSettings settings;
  settings.keyTolerancePercent = 0.2;
  const WrittenClip reduced = written(slow, settings);
  CHECK(reduced.largestPercent <= 0.202);
  CHECK(3 * reduced.clip.keys < every.clip.keys);
}

TEST_CASE("a body that grows from a point leaves out keys by the size that it comes to") {
  SkinnedSequence grown = slowlyTurningBody();
  constexpr double seed = 1e-5; // of its size, as it begins
  for (glm::vec3& position : grown.bindPositions) {
    position *= static_cast<float>(seed);
  }
  for (std::size_t i = 0; i < grown.poses.size(); ++i) {
    const bool isFirst = i < grown.bones.size();
    grown.poses[i].position *= isFirst ? seed : 1.0;
    grown.poses[i].scale = Vec3(isFirst ? 1.0 : 1.0 / seed);
  }
  for (SkinBone& bone : grown.bones) {
    bone.pivot *= seed;
    bone.end *= seed;
  }
  const WrittenClip every = written(grown, {});
  EncodeSettings settings;
  settings.keyTolerancePercent = 0.2;
  const WrittenClip reduced = written(grown, settings);
  CHECK(reduced.largestPercent <= 0.21);
  CHECK(2 * reduced.clip.keys < every.clip.keys);
}

TEST_CASE("a body that never moves has two equal keys, by which the clip lasts, whatever their tolerance") {
  SkinnedSequence still = test::armedBody(6);
  for (std::size_t k = 1; k < still.frameCount(); ++k) {
    for (std::size_t b = 0; b < still.bones.size(); ++b) {
      still.pose(k, b) = still.pose(0, b);
    }
  }
  for (const double tolerance : {0.0, 0.1, 5.0}) {
    EncodeSettings settings;
    settings.keyTolerancePercent = tolerance;
    const WrittenClip clip = written(still, settings);
    CHECK(clip.clip.keys == 2);
    CHECK(clip.clip.samplers == 1);
    CHECK(clip.framesPerSecond == still.framesPerSecond);
    CHECK(clip.seconds == Approx(5.0 / still.framesPerSecond));
    CHECK(clip.largestPercent < 1e-3);
  }
}

TEST_CASE("a bone that hardly moves stands still, and keeps no key") {
  SkinnedSequence quiet = test::armedBody(24);
  for (std::size_t k = 0; k < quiet.frameCount(); ++k) {
    quiet.pose(k, 1).scale = Vec3(1.0 + (k % 2 == 0 ? 1e-4 : -1e-4), 1.0, 1.0);
  }
  EncodeSettings settings;
  settings.keyTolerancePercent = 0.1;
  CHECK(encodeGltf(quiet, settings).samplers < encodeGltf(quiet).samplers);
}

TEST_CASE("keys are left out as far as the mesh allows, and no vertex of any frame is farther off") {
  const SkinnedSequence skinned = measuredBody();
  const WrittenClip every = written(skinned, {});
  CHECK(every.largestPercent < 1e-3);
  std::size_t before = every.clip.keys;
  for (const double tolerance : {0.02, 0.2}) {
    EncodeSettings settings;
    settings.keyTolerancePercent = tolerance;
    const WrittenClip reduced = written(skinned, settings);
    CHECK(reduced.largestPercent <= 1.01 * tolerance);
    CHECK(reduced.largestPercent > 0.3 * tolerance);
    CHECK(reduced.clip.keyErrorPercent == Approx(reduced.largestPercent).epsilon(0.02));
    CHECK(reduced.clip.keys < before);
    CHECK(reduced.clip.bytesPerFrame < every.clip.bytesPerFrame);
    before = reduced.clip.keys;
  }
  CHECK(2 * before < every.clip.keys);
}

TEST_CASE("a quantised mesh is as it was to a few ten-thousandths of its size, in fewer bytes") {
  const SkinnedSequence skinned = measuredBody();
  EncodeSettings settings;
  settings.quantise = true;
  const WrittenClip floats = written(skinned, settings);
  settings.quantiseMesh = true;
  const WrittenClip integers = written(skinned, settings);
  CHECK(integers.largestPercent < 0.01);
  CHECK(static_cast<double>(integers.clip.bytesOnce) < 0.8 * static_cast<double>(floats.clip.bytesOnce));
  CHECK(isRequired(integers.clip, "KHR_mesh_quantization"));
  CHECK_FALSE(isRequired(floats.clip, "KHR_mesh_quantization"));
}

TEST_CASE("meshopt changes no vertex and takes less") {
  const SkinnedSequence skinned = measuredBody();
  for (const bool integers : {false, true}) {
    EncodeSettings settings;
    settings.quantise = integers;
    settings.quantiseMesh = integers;
    const WrittenClip plain = written(skinned, settings);
    settings.meshopt = true;
    const WrittenClip packed = written(skinned, settings);
    CHECK(packed.largestPercent == plain.largestPercent);
    CHECK(static_cast<double>(packed.clip.source.buffers[0].size()) <
          0.8 * static_cast<double>(plain.clip.source.buffers[0].size()));
    CHECK(isRequired(packed.clip, "EXT_meshopt_compression"));
  }
}

TEST_CASE("keys stay where leaving them out would take more than it saves") {
  const SkinnedSequence skinned = measuredBody();
  const EncodedClip every = encodeGltf(skinned);
  const auto bytesOf = [](const EncodedClip& clip) {
    return clip.source.buffers[0].size() + clip.bytesOfJson;
  };
  for (const double tolerance : {1e-4, 3e-4, 1e-3, 3e-3}) {
    EncodeSettings settings;
    settings.keyTolerancePercent = tolerance;
    CHECK(bytesOf(encodeGltf(skinned, settings)) <= bytesOf(every));
  }
}

TEST_CASE("a clip with two keys has the rate and the frames that it had") {
  SkinnedSequence sliding = test::armedBody(31);
  for (std::size_t k = 0; k < sliding.frameCount(); ++k) {
    for (std::size_t b = 0; b < sliding.bones.size(); ++b) {
      const Vec3 away(0.1 * static_cast<double>(k), 0.0, 0.0);
      sliding.pose(k, b) = {sliding.bones[b].pivot + away, Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0),
                            Quat(1.0, 0.0, 0.0, 0.0)};
    }
  }
  EncodeSettings settings;
  settings.keyTolerancePercent = 0.1;
  const EncodedClip clip = encodeGltf(sliding, settings);
  CHECK(clip.keys == 2);
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(clip.source, folder.path() / "clip.glb"));
  const auto read = readAnimatedGltf(folder.path() / "clip.glb");
  REQUIRE(read);
  CHECK(read->framesPerSecond == sliding.framesPerSecond);
  CHECK(read->frameCount() == sliding.frameCount());
}

TEST_CASE("the bytes that are told are those of the file") {
  const SkinnedSequence skinned = measuredBody();
  for (const bool meshopt : {false, true}) {
    EncodeSettings settings;
    settings.meshopt = meshopt;
    const WrittenClip result = written(skinned, settings);
    const double told = result.clip.bytesPerFrame * static_cast<double>(skinned.frameCount()) +
                        static_cast<double>(result.clip.bytesOnce + result.clip.bytesOfJson);
    constexpr double headers = 28.0;
    CHECK(static_cast<double>(result.fileBytes) - told >= headers - 0.5);
    CHECK(static_cast<double>(result.fileBytes) - told < headers + 3.5);
  }
}

TEST_CASE("what a file is off by leaves out vertices that no triangle draws, as every error does") {
  const SkinnedSequence body = test::armedBody(4);
  MeshSequence source = skinAllFrames(body);
  SkinnedSequence loose = body;
  loose.bindPositions.emplace_back(0.0F, 50.0F, 0.0F);
  Influences first;
  first.weights[0] = 1.0F;
  loose.influences.push_back(first);
  source = skinAllFrames(loose);
  for (std::size_t k = 0; k < source.frameCount(); ++k) {
    source.frame(k).back().y += 10.0F * static_cast<float>(k);
  }
  const test::TemporaryFolder folder;
  const EncodedClip clip = encodeGltf(loose);
  REQUIRE(gltf::save(clip.source, folder / "loose.glb"));
  const auto error = errorOfFile(folder / "loose.glb", clip, source);
  REQUIRE(error);
  CHECK(error->largestPercent < 1e-3);
}

TEST_CASE("of two bones that could each stand still only one does where both would move the mesh too far") {
  SkinnedSequence jerk = test::armedBody(60);
  constexpr double by = 0.07;
  for (std::size_t k = 0; k < jerk.frameCount(); ++k) {
    for (std::size_t b = 0; b < jerk.bones.size(); ++b) { // The trunk carries all, the head goes as far
                                                          // again.
      const double away = k != 30 ? 0.0 : b == 1 ? 2.0 * by : by;
      jerk.pose(k, b) = {jerk.bones[b].pivot + Vec3(away, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0),
                         Quat(1.0, 0.0, 0.0, 0.0)};
    }
  }
  const auto plan = planKeys(encodeGltf(jerk).source, jerk.frameCount(), by / 0.7, {}, {});
  REQUIRE(plan);
  REQUIRE(plan->size() == 2);
  CHECK(std::ranges::count_if(*plan, [](const auto& keys) { return keys.size() == 1; }) == 1);
}

TEST_CASE("a file that shows other vertices than were written is no measure of them, and both are told") {
  const SkinnedSequence body = test::armedBody(2);
  const test::TemporaryFolder folder;
  EncodedClip clip = encodeGltf(body);
  REQUIRE(gltf::save(clip.source, folder / "body.glb"));
  const std::size_t count = clip.places.size();
  clip.places.pop_back();
  const auto error = errorOfFile(folder / "body.glb", clip, skinAllFrames(body));
  REQUIRE_FALSE(error);
  CHECK(error.error().what ==
        std::to_string(count - 1) + " vertices were written and " + std::to_string(count) + " are read");
}

TEST_CASE("leaving out keys tells how far it is, never back, and ends where it is stopped") {
  const SkinnedSequence slow = slowlyTurningBody();
  EncodeSettings settings;
  settings.keyTolerancePercent = 0.2;
  for (const std::size_t most : {1U, 3U, 10U, 40U}) {
    CAPTURE(most);
    std::vector<double> shares;
    const std::optional<EncodedClip> stopped = encodeGltf(slow, settings, [&](double share) {
      shares.push_back(share);
      return shares.size() < most;
    });
    CHECK_FALSE(stopped.has_value());
    REQUIRE(shares.size() == most);
    CHECK(std::ranges::is_sorted(shares));
    CHECK(shares.front() == 0.0);
    CHECK(shares.back() < 0.5);
  }
}
