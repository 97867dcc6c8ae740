#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "skinning/compress/compress.h"
#include "skinning/export/clip_writer.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// Largest distance between what we skin and what the glTF reader skins of the written file, in diagonals.
double differenceAfterSaving(const SkinnedSequence& skinned, bool quantise) {
  const test::TemporaryFolder folder;
  const EncodedClip clip = encodeGltf(skinned, {quantise, 1e-6});
  REQUIRE(gltf::save(clip.source, folder.path() / "clip.glb"));
  const auto read = readAnimatedGltf(folder.path() / "clip.glb");
  REQUIRE(read);
  const auto metrics = compareSequences(skinAllFrames(skinned), *read);
  REQUIRE(metrics);
  return metrics->largestPercent / 100.0;
}

SkinnedSequence compressedTube(StretchOption option) {
  CompressSettings settings;
  settings.bones = 10;
  settings.stretch = option;
  auto result = compress(test::shorteningTube(12, 2.0, 0.06, 0.1), settings);
  REQUIRE(result);
  return result->skinned;
}

} // namespace

TEST_CASE("the written file, skinned by the glTF reader, shows our vertices") {
  for (const StretchOption option : {StretchOption::none, StretchOption::elastic, StretchOption::measured}) {
    const SkinnedSequence skinned = compressedTube(option);
    CHECK(differenceAfterSaving(skinned, false) < 1e-5);
    CHECK(differenceAfterSaving(skinned, true) < 1e-4);
  }
}

TEST_CASE("a weight that rounds to nothing is written with joint 0") {
  SkinnedSequence skinned = test::wavingTube(4, 3);
  skinned.influences[0] = {{2, 3, 0, 0}, {1.0F - 1e-6F, 1e-6F, 0.0F, 0.0F}};
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "clip.glb";
  REQUIRE(gltf::save(encodeGltf(skinned, {true, 1e-6}).source, file));
  const auto read = gltf::load(file);
  REQUIRE(read);
  const VertexInfluences& written = read->scene->meshes[0].primitives[0].influences[0];
  CHECK(written.joints[0] > 0);
  CHECK(written.weights[0] == 1.0F);
  CHECK(written.joints[1] == 0);
}

TEST_CASE("a load that turns around the body is written with stretch axes of its own") {
  SkinnedSequence skinned = test::wavingTube(6, 10);
  for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
    for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
      BonePose& pose = skinned.pose(k, b);
      pose.scale = Vec3(1.0, 0.8 + 0.01 * static_cast<double>(b), 1.2);
      pose.stretchAxes = glm::angleAxis(0.3 * static_cast<double>(k), Vec3(1.0, 0.0, 0.0));
    }
  }
  CHECK(differenceAfterSaving(skinned, false) < 1e-5);
  CHECK(differenceAfterSaving(skinned, true) < 1e-4);
}

TEST_CASE("what is shared or constant is stored once: a chain costs its rotations, its root and one course "
          "of stretch") {
  const SkinnedSequence none = compressedTube(StretchOption::none);
  CHECK(encodeGltf(none, {true, 1e-6}).bytesPerFrame <= 4.0 + 12.0 + 10.0 * 8.0);
  CHECK(encodeGltf(none, {false, 1e-6}).bytesPerFrame <= 4.0 + 12.0 + 10.0 * 16.0);
  const SkinnedSequence elastic = compressedTube(StretchOption::elastic);
  CHECK(encodeGltf(elastic, {true, 1e-6}).bytesPerFrame <= 4.0 + 12.0 + 12.0 + 12.0 + 10.0 * 8.0);
  const SkinnedSequence measured = compressedTube(StretchOption::measured);
  CHECK(encodeGltf(measured, {true, 1e-6}).bytesPerFrame <= 4.0 + 10.0 * (8.0 + 12.0 + 12.0));
}

TEST_CASE("bytes per frame and bytes once are all the bytes of the file's binary part") {
  const SkinnedSequence skinned = compressedTube(StretchOption::elastic);
  const EncodedClip clip = encodeGltf(skinned, {true, 1e-6});
  CHECK(clip.bytesPerFrame * static_cast<double>(skinned.frameCount()) +
            static_cast<double>(clip.bytesOnce) ==
        Approx(static_cast<double>(clip.source.buffers[0].size())));
}

TEST_CASE("a clip in which nothing moves has no channels and is written without an animation") {
  SkinnedSequence skinned = test::wavingTube(4, 1);
  const EncodedClip clip = encodeGltf(skinned);
  CHECK_FALSE(clip.source.json->contains("animations"));
}

TEST_CASE("courses are alike where every number is, from the first to the last, and as many as the other's") {
  const Course course{1.0F, 2.0F, 3.0F, 4.0F};
  CHECK(areAlike(course, course, 0.0));
  CHECK_FALSE(areAlike(course, {1.0F, 2.0F, 3.0F}, 10.0));
  CHECK_FALSE(areAlike(course, {1.0F, 2.0F, 3.0F, 4.0F, 5.0F}, 10.0));
  for (std::size_t i = 0; i < course.size(); ++i) {
    for (const float step : {-0.5F, 0.5F}) {
      CAPTURE(i, step);
      Course other = course;
      other[i] += step;
      CHECK(areAlike(course, other, 0.5));
      CHECK_FALSE(areAlike(course, other, 0.49));
    }
  }
}
