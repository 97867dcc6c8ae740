// Checks on real simulations and meshes. They run where the environment variable STRETCH_DATA names the
// folder that holds them, and are told as skipped elsewhere.
#include <catch2/catch.hpp>

#include <filesystem>

#include "skinning/compress/compress.h"
#include "skinning/compress/flattening.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/real_files.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr double fullResolutionMetres = 2.026319e-06;
const Vec3 simulatedGravity(0.0, -9.8, 0.0);

MeshSequence worm(const std::string& base, const std::string& cache) {
  auto sequence = readSequence({test::realFiles() / "worm" / base, test::realFiles() / "worm" / cache});
  REQUIRE(sequence);
  return std::move(sequence.value());
}

MeshSequence crawl() {
  return worm("worm_base.obj", "worm_crawl.pc2");
}
MeshSequence halfSwim() {
  return worm("worm_half_swim_base.obj", "worm_half_swim.pc2");
}

CompressedSequence compressed(const MeshSequence& sequence, int bones, StretchOption stretch,
                              std::size_t skip = 0) {
  CompressSettings settings;
  settings.bones = bones;
  settings.stretch = stretch;
  settings.body.gravity = simulatedGravity;
  settings.body.metresPerUnit = fullResolutionMetres;
  settings.body.firstFittedFrame = skip;
  auto result = compress(sequence, settings);
  REQUIRE(result);
  return std::move(result.value());
}

LineFit lineOver(const BodyStretch& model, std::size_t first, std::size_t last) {
  return fitLine({model.measured.begin() + static_cast<std::ptrdiff_t>(first),
                  model.measured.begin() + static_cast<std::ptrdiff_t>(last)});
}

} // namespace

TEST_CASE("a crawling worm: measured stretch halves the error of rigid bones, elastic lies between none and "
          "measured",
          "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const MeshSequence sequence = crawl();
  CHECK(compressed(sequence, 10, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.391);
  CHECK(compressed(sequence, 20, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.218);
  const double measured = compressed(sequence, 30, StretchOption::measured).metrics.mse;
  const double elastic = compressed(sequence, 30, StretchOption::elastic, 5).metrics.mse;
  const double none = compressed(sequence, 30, StretchOption::none).metrics.mse;
  CHECK(measured < elastic);
  CHECK(elastic < 0.5 * none);
}

TEST_CASE("a crawling worm of 31 joints: an elastic frame is at most 1 / 138 of its positions", "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const MeshSequence sequence = crawl();
  const auto elastic = compressed(sequence, 31, StretchOption::elastic, 5);
  const EncodedClip clip = encodeGltf(elastic.skinned, {true, 1e-6});
  CHECK(static_cast<double>(sourceBytesPerFrame(sequence)) / clip.bytesPerFrame >= 138.0);
}

TEST_CASE("a crawling worm's length follows its curvature while activation grows, then saturates", "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const auto result = compressed(crawl(), 30, StretchOption::none);
  const BodyStretch& model = *result.model;
  const LineFit growing = lineOver(model, 5, 26);
  const LineFit constant = lineOver(model, 25, model.measured.size());
  CHECK(growing.rSquared > 0.97);
  CHECK(growing.slope < -6.0);
  CHECK(constant.rSquared < 0.3);
  CHECK(model.length.monotone.rSquared > 0.95);
}

TEST_CASE(
    "a swimming worm with real mesh defects compresses with a warning, its length is a line of its curvature",
    "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const MeshSequence sequence = halfSwim();
  CHECK(sequence.warnings.size() == 2);
  CHECK(compressed(sequence, 20, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.087);
  const auto thirty = compressed(sequence, 30, StretchOption::measured, 10);
  CHECK(thirty.metrics.rmsePercent <= 0.5 * 0.070);
  CHECK(thirty.model->length.line.rSquared == Approx(0.975).margin(0.01));
}

TEST_CASE("gravity flattens a lying worm as the particles say, and a modulus explains it", "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  BodyStretchSettings settings;
  settings.gravity = simulatedGravity;
  settings.metresPerUnit = fullResolutionMetres;
  const auto flattening = gravityFlattening(worm("worm_base.obj", "worm_gravity.pc2"),
                                            worm("worm_base.obj", "worm_no_gravity.pc2"), settings);
  REQUIRE(flattening);
  CHECK(flattening->width == Approx(1.146).margin(0.005));
  CHECK(flattening->height == Approx(0.791).margin(0.005));
  CHECK(flattening->predictedHeight > flattening->height);
  CHECK(flattening->predictedWidth > flattening->width);
  CHECK(flattening->youngModulus > 1.0);
  CHECK(flattening->youngModulus < 10.0);
}

TEST_CASE("a hundred frames of a bone that bends: measured stretch halves the error of rigid bones",
          "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const auto sequence = readSequence({test::realFiles() / "mesh-sequence" / "dem-bones" / "frames"});
  REQUIRE(sequence);
  CHECK(sequence->frameCount() == 100);
  CHECK(compressed(*sequence, 10, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.353);
  CHECK(compressed(*sequence, 30, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.168);
}

TEST_CASE("a wolf is followed at half the error of rigid bones", "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const auto wolf = readSequence({test::realFiles() / "mesh-sequence" / "wolf"});
  REQUIRE(wolf);
  CHECK(compressed(*wolf, 10, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.402);
  CHECK(compressed(*wolf, 20, StretchOption::measured).metrics.rmsePercent <= 0.5 * 0.141);
}

TEST_CASE("frames without leading zeros and morph-target clips are read as sequences", "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const auto wolf = readSequence({test::realFiles() / "mesh-sequence" / "wolf"});
  REQUIRE(wolf);
  CHECK(wolf->frameCount() == 21);
  CHECK(wolf->frameNames[1] == "wolf-2.obj");
  const auto morph = readSequence({test::realFiles() / "mesh-sequence" / "morph" / "MorphStressTest.gltf"});
  REQUIRE(morph);
  CHECK(morph->frameCount() > 10);
}

TEST_CASE("a crawling worm without stretch: the row turns at most 1.2 times as much as the body", "[data]") {
  if (!test::hasRealFiles()) {
    return;
  }
  const CompressedSequence result = compressed(crawl(), 30, StretchOption::none);
  const SkinnedSequence& skinned = result.skinned;
  REQUIRE(result.model);
  for (std::size_t k = 1; k < skinned.frameCount(); ++k) {
    std::vector<Vec3> joints;
    for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
      joints.push_back(skinned.pose(k, b).position);
    }
    const SkinBone& last = skinned.bones.back();
    joints.emplace_back(skinMatrix(last, skinned.pose(k, skinned.bones.size() - 1)) * Vec4(last.end, 1.0));
    INFO("frame " << k);
    CHECK(totalCurvature(joints) < 1.2 * result.model->measured[k].curvatureRadians + 0.05);
  }
}
