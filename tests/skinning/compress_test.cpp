#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"
#include "skinning/compress/compress.h"
#include "skinning/compress/flattening.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

CompressedSequence compressed(const MeshSequence& sequence, int bones, StretchOption stretch,
                              WeightOption weights) {
  CompressSettings settings;
  settings.bones = bones;
  settings.stretch = stretch;
  settings.weights = weights;
  auto result = compress(sequence, settings);
  REQUIRE(result);
  return result.value();
}

} // namespace

TEST_CASE("a tube that was skinned to rigid bones comes back") {
  const MeshSequence sequence = skinAllFrames(test::wavingTube(8, 30));
  CHECK(compressed(sequence, 8, StretchOption::none, WeightOption::fitted).metrics.rmsePercent < 0.5);
  CHECK(compressed(sequence, 8, StretchOption::measured, WeightOption::fitted).metrics.rmsePercent < 0.1);
  CHECK(compressed(sequence, 16, StretchOption::none, WeightOption::geodesic).metrics.rmsePercent < 1.0);
}

TEST_CASE("bones neither flip nor drift: a wave that comes back leaves every bone as it was") {
  const auto result =
      compressed(skinAllFrames(test::wavingTube(8, 60)), 8, StretchOption::none, WeightOption::geodesic);
  const SkinnedSequence& skinned = result.skinned;
  for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
    for (std::size_t k = 1; k < skinned.frameCount(); ++k) {
      CHECK(glm::dot(skinned.pose(k, b).rotation, skinned.pose(k - 1, b).rotation) > 0.98);
      // The tube bends around y only: no turn about its own axis.
      CHECK(std::abs(skinned.pose(k, b).rotation.x) < 0.02);
    }
  }
}

TEST_CASE("without stretch a row that is too long lies along the body instead of folding up in it") {
  for (const WeightOption weights : {WeightOption::geodesic, WeightOption::fitted}) {
    const auto result =
        compressed(test::shorteningTube(12, 2.0, 0.06, 0.1), 30, StretchOption::none, weights);
    const SkinnedSequence& skinned = result.skinned;
    REQUIRE(result.model);
    for (std::size_t k = 1; k < skinned.frameCount(); ++k) {
      std::vector<Vec3> joints;
      for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
        joints.push_back(skinned.pose(k, b).position);
      }
      const SkinBone& last = skinned.bones.back();
      joints.emplace_back(skinMatrix(last, skinned.pose(k, skinned.bones.size() - 1)) * Vec4(last.end, 1.0));
      const double curvature = result.model->measured[k].curvatureRadians;
      CHECK(totalCurvature(joints) < 1.2 * curvature + 0.05);
      CHECK(polylineLength(joints) == Approx(result.model->restLength).epsilon(1e-3));
    }
    // What is left is that the row is too long: at most half of that, at the ends.
    CHECK(result.metrics.largestPercent < 8.0);
    CHECK(result.metrics.rmsePercent > 1.0);
  }
}

TEST_CASE("bones in a row hang together in every frame") {
  for (const StretchOption option : {StretchOption::none, StretchOption::elastic}) {
    const auto result =
        compressed(test::shorteningTube(16, 2.0, 0.06, 0.1), 10, option, WeightOption::geodesic);
    const SkinnedSequence& skinned = result.skinned;
    REQUIRE(skinned.chained);
    for (std::size_t k = 0; k < skinned.frameCount(); ++k) {
      for (std::size_t b = 0; b + 1 < skinned.bones.size(); ++b) {
        const Vec3 end(skinMatrix(skinned.bones[b], skinned.pose(k, b)) * Vec4(skinned.bones[b].end, 1.0));
        CHECK(glm::length(end - skinned.pose(k, b + 1).position) < 1e-6);
      }
    }
  }
}

TEST_CASE("the elastic model finds how a body shortens and how gravity flattens it, and beats no stretch") {
  const double shortening = 0.06;
  const double flattening = 0.15;
  const MeshSequence sequence = test::shorteningTube(24, 2.0, shortening, flattening);
  CompressSettings settings;
  settings.bones = 12;
  settings.weights = WeightOption::geodesic;
  settings.body.firstFittedFrame = 1;
  const auto elastic = compress(sequence, settings);
  REQUIRE(elastic);
  REQUIRE(elastic->model);
  const BodyStretch& model = *elastic->model;
  CHECK(model.length.at(model.measured.back().curvatureRadians) ==
        Approx(10.0 * (1.0 - 2.0 * shortening)).epsilon(0.01));
  CHECK(model.length.line.slope < 0.0);
  CHECK(model.length.line.rSquared > 0.99);
  CHECK(model.compressions[6] == Approx(flattening).epsilon(0.1));
  CHECK(model.modulusFitted);
  settings.stretch = StretchOption::none;
  const auto none = compress(sequence, settings);
  settings.stretch = StretchOption::measured;
  const auto measured = compress(sequence, settings);
  REQUIRE(none);
  REQUIRE(measured);
  CHECK(elastic->metrics.mse < 0.25 * none->metrics.mse);
  CHECK(measured->metrics.mse < elastic->metrics.mse);
  REQUIRE(elastic->fittedMetrics);
  CHECK(elastic->fittedMetrics->mse < elastic->metrics.mse * 1.1);
}

TEST_CASE("the first frame is the bind pose, as long as it is, whatever the fit says of it") {
  // Settles by 4 % after the first frame, as simulations do: the fit knows nothing of the length at rest.
  MeshSequence sequence = test::shorteningTube(24, 2.0, 0.06, 0.0);
  for (std::size_t i = sequence.vertexCount; i < sequence.positions.size(); ++i) {
    sequence.positions[i] *= 0.96F;
  }
  const auto result = compressed(sequence, 12, StretchOption::elastic, WeightOption::geodesic);
  CHECK(result.model->factors.front().along == 1.0);
  CHECK(result.model->length.at(0.0) < 0.98 * result.model->restLength);
  MeshSequence first = skinAllFrames(result.skinned);
  first.positions.resize(first.vertexCount);
  MeshSequence rest = sequence;
  rest.positions.resize(rest.vertexCount);
  const auto off = compareSequences(rest, first);
  REQUIRE(off);
  CHECK(off->rmsePercent < 0.1);
}

TEST_CASE("a modulus that is given is used, stiff segments are flattened less") {
  const MeshSequence sequence = test::shorteningTube(8, 1.0, 0.05, 0.1);
  CompressSettings settings;
  settings.bones = 10;
  settings.weights = WeightOption::geodesic;
  settings.body.youngModulus = 1e5;
  const auto soft = compress(sequence, settings);
  settings.body.moduli.ranges.push_back({2, 5, 1e6});
  const auto ribs = compress(sequence, settings);
  REQUIRE(soft);
  REQUIRE(ribs);
  CHECK_FALSE(soft->model->modulusFitted);
  CHECK(soft->model->youngModulus == Approx(1e5));
  CHECK(ribs->model->compressions[3] == Approx(0.1 * soft->model->compressions[3]).epsilon(1e-6));
  CHECK(ribs->model->compressions[7] == Approx(soft->model->compressions[7]).epsilon(1e-6));
  const StretchFactors& factors = soft->model->factors.back();
  CHECK(factors.along * factors.withLoad * factors.sideways == Approx(1.0));
}

TEST_CASE("a compression tells how far it is, and stops when it is told to") {
  const MeshSequence sequence = test::shorteningTube(12, 2.0, 0.06, 0.1);
  CompressSettings settings;
  settings.bones = 8;
  std::vector<double> shares;
  REQUIRE(compress(sequence, settings, [&](double share) {
    shares.push_back(share);
    return true;
  }));
  REQUIRE(shares.size() > 3);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() == 1.0);
  const std::size_t steps = shares.size();
  for (std::size_t last = 1; last <= steps; ++last) {
    std::size_t told = 0;
    const auto stopped = compress(sequence, settings, [&](double) { return ++told < last; });
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().what.find("stopped") != std::string::npos);
    CHECK(told <= last + 2);
  }
}

TEST_CASE("fitted weights are not negative, at most four, and sum to 1") {
  const auto result =
      compressed(test::shorteningTube(12, 2.0, 0.06, 0.1), 10, StretchOption::measured, WeightOption::fitted);
  for (const Influences& influences : result.skinned.influences) {
    float sum = 0.0F;
    for (const float weight : influences.weights) {
      CHECK(weight >= 0.0F);
      sum += weight;
    }
    CHECK(sum == Approx(1.0F).epsilon(1e-5));
  }
}

TEST_CASE("the same input gives the same bytes, however many threads work") {
  const MeshSequence sequence = test::shorteningTube(10, 2.0, 0.06, 0.1);
  const auto first = compressed(sequence, 10, StretchOption::elastic, WeightOption::fitted);
  const auto second = compressed(sequence, 10, StretchOption::elastic, WeightOption::fitted);
  CHECK(first.skinned.influences == second.skinned.influences);
  for (std::size_t i = 0; i < first.skinned.poses.size(); ++i) {
    CHECK(first.skinned.poses[i].rotation == second.skinned.poses[i].rotation);
    CHECK(first.skinned.poses[i].position == second.skinned.poses[i].position);
  }
}

TEST_CASE("a body that branches (a ring) can be measured, or stretches row by row of a tree of bones") {
  MeshSequence ring = test::still(test::torus(2.0, 0.5, 48, 12));
  const auto rest = ring.positions;
  for (int k = 1; k < 6; ++k) {
    for (const glm::vec3& p : rest) {
      ring.positions.push_back(p * glm::vec3(1.0F + 0.02F * static_cast<float>(k), 1.0F, 1.0F));
    }
  }
  CompressSettings settings;
  settings.bones = 8;
  const auto elastic = compress(ring, settings);
  REQUIRE(elastic);
  CHECK_FALSE(elastic->model);
  CHECK_FALSE(elastic->chains.empty());
  CHECK_THAT(elastic->warnings.front(), Catch::Contains("branches") && Catch::Contains("row of bones"));
  settings.joints = JointOption::free;
  const auto apart = compress(ring, settings);
  REQUIRE_FALSE(apart);
  CHECK_THAT(apart.error().line(), Catch::Contains("branches"));
  settings.stretch = StretchOption::measured;
  const auto measured = compress(ring, settings);
  REQUIRE(measured);
  CHECK(measured->metrics.rmsePercent < 0.1);
  CHECK_FALSE(measured->warnings.empty());
}

TEST_CASE("an arm of a few large triangles makes a body branch") {
  MeshSequence body = test::shorteningTube(6, 1.0, 0.05, 0.1);
  const MeshSequence rest = body;
  for (std::size_t i = 0; i < body.positions.size(); ++i) {
    const glm::vec3 at = rest.frame(0)[i % body.vertexCount];
    if (std::abs(at.x - 4.0F) < 0.35F && at.y > 0.3F) {
      body.positions[i].y += 4.0F;
    }
  }
  CompressSettings settings;
  settings.bones = 10;
  settings.joints = JointOption::free;
  const auto elastic = compress(body, settings);
  REQUIRE_FALSE(elastic);
  CHECK_THAT(elastic.error().line(),
             Catch::Contains("branches") && Catch::Contains("--stretch measured --weights fitted"));
  settings.stretch = StretchOption::measured;
  CHECK(compress(body, settings));
}

TEST_CASE("a short trunk between long arms makes a body branch") {
  const int half = GENERATE(7, 8, 12); // of the trunk's height, in cells; it is 4 wide, as the arms are thick
  const test::Shape shape = test::cubes({-26, -20, -3}, {26, 20, 3}, 0.5, [&](int x, int y, int z) {
    const bool arms = x >= -24 && x < 24 && y >= -2 && y < 2;
    const bool trunk = x >= -2 && x < 2 && y >= -half && y < half;
    return z >= -2 && z < 2 && (arms || trunk);
  });
  MeshSequence body = test::still(shape);
  for (int k = 1; k < 8; ++k) { // The arms flap, what is below them swings to and fro.
    for (const glm::vec3& p : shape.positions) {
      const float time = 0.5F * static_cast<float>(k);
      body.positions.emplace_back(p.x, p.y + 0.02F * std::sin(time) * p.x * p.x,
                                  p.z + 0.3F * std::sin(2.0F * time) * std::min(0.0F, p.y + 1.0F));
    }
  }
  CompressSettings settings;
  settings.bones = 10;
  settings.joints = JointOption::free;
  const auto elastic = compress(body, settings);
  REQUIRE_FALSE(elastic);
  CHECK_THAT(elastic.error().line(),
             Catch::Contains("branches") && Catch::Contains("--stretch measured --weights fitted"));
}

TEST_CASE("bodies of several parts are refused with what helps") {
  MeshSequence two = test::still(test::tube(10.0, 0.5, 40, 10));
  const auto count = static_cast<std::uint32_t>(two.vertexCount);
  const std::vector<Triangle> triangles = two.triangles;
  for (const Triangle& t : triangles) {
    two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  for (std::uint32_t v = 0; v < count; ++v) {
    two.positions.push_back(two.positions[v] + glm::vec3(0.0F, 3.0F, 0.0F));
  }
  two.vertexCount *= 2;
  CompressSettings settings;
  settings.bones = 8;
  settings.joints = JointOption::free;
  const auto refused = compress(two, settings);
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().line(), Catch::Contains("--stretch measured --weights fitted"));
}

TEST_CASE("an error out of proportion is told with what helps") {
  const MeshSequence sequence = test::shorteningTube(12, 2.0, 0.06, 0.1);
  const auto rigid = compressed(sequence, 12, StretchOption::none, WeightOption::geodesic);
  REQUIRE(rigid.metrics.rmsePercent > 1.0);
  REQUIRE_FALSE(rigid.warnings.empty());
  CHECK_THAT(rigid.warnings.back(), Catch::Contains("off by") && Catch::Contains("--stretch elastic"));
  CHECK(compressed(sequence, 12, StretchOption::measured, WeightOption::fitted).warnings.empty());
}

TEST_CASE("triangles wound at random change neither mass nor fit, and that is told") {
  const MeshSequence sequence = test::shorteningTube(8, 2.0, 0.06, 0.1);
  MeshSequence random = sequence;
  for (std::size_t t = 0; t < random.triangles.size(); ++t) {
    if ((t * 2654435761U >> 7U) % 2 == 0) {
      std::swap(random.triangles[t][0], random.triangles[t][1]);
    }
  }
  const auto wanted = compressed(sequence, 10, StretchOption::elastic, WeightOption::geodesic);
  const auto result = compressed(random, 10, StretchOption::elastic, WeightOption::geodesic);
  CHECK(result.model->mass == Approx(wanted.model->mass).epsilon(1e-6));
  CHECK(result.model->length.line.rSquared == Approx(wanted.model->length.line.rSquared).margin(1e-6));
  CHECK(result.metrics.mse == Approx(wanted.metrics.mse).epsilon(1e-3));
  REQUIRE_FALSE(result.warnings.empty());
  CHECK_THAT(result.warnings.front(), Catch::Contains("turned outwards"));
}

TEST_CASE("vertices of no triangle count in no fit and in no error") {
  const MeshSequence sequence = test::shorteningTube(8, 2.0, 0.06, 0.1);
  MeshSequence loose = sequence;
  loose.positions.clear();
  loose.vertexCount += 1;
  for (Triangle& triangle : loose.triangles) {
    for (std::uint32_t& corner : triangle) {
      ++corner;
    }
  }
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    loose.positions.emplace_back(0.0F, 100.0F + 10.0F * static_cast<float>(k), 0.0F);
    loose.positions.insert(loose.positions.end(), sequence.frame(k).begin(), sequence.frame(k).end());
  }
  const auto wanted = compressed(sequence, 10, StretchOption::measured, WeightOption::fitted);
  const auto result = compressed(loose, 10, StretchOption::measured, WeightOption::fitted);
  CHECK(result.metrics.rmsePercent == Approx(wanted.metrics.rmsePercent).epsilon(1e-9));
  REQUIRE(result.skinned.bindPositions.size() == loose.vertexCount);
  CHECK(result.skinned.triangles == loose.triangles);
  CHECK(result.skinned.influences[1] == wanted.skinned.influences[0]);
  CHECK_THAT(result.warnings.front(), Catch::Contains("1 vertices of no triangle"));
}

TEST_CASE("a mesh with open and crowded edges still compresses") {
  MeshSequence sequence = test::shorteningTube(6, 1.0, 0.05, 0.1);
  sequence.triangles.resize(sequence.triangles.size() - 3);
  sequence.triangles.push_back({0, 1, 20});
  CHECK(compressed(sequence, 8, StretchOption::elastic, WeightOption::geodesic).metrics.rmsePercent < 2.0);
}

TEST_CASE("what cannot be compressed is refused with one line") {
  const MeshSequence tube = test::shorteningTube(3, 1.0, 0.05, 0.1);
  CompressSettings settings;
  for (const int bones : {0, -3, 5000}) {
    settings.bones = bones;
    CHECK(compress(tube, settings).error().line().find("bones") != std::string::npos);
  }
  settings.bones = 8;
  CHECK_FALSE(compress(MeshSequence{}, settings));
  settings.body.youngModulus = -1.0;
  CHECK(compress(tube, settings).error().line().find("modulus") != std::string::npos);
}

TEST_CASE("one frame, or a body that never moves, is still a clip") {
  MeshSequence still = test::still(test::tube(10.0, 0.5, 40, 10));
  CHECK(compressed(still, 6, StretchOption::elastic, WeightOption::fitted).metrics.rmsePercent < 0.01);
  still.positions.insert(still.positions.end(), still.positions.begin(), still.positions.end());
  CHECK(compressed(still, 6, StretchOption::measured, WeightOption::fitted).metrics.rmsePercent < 0.01);
}

TEST_CASE("gravity's flattening gives back the modulus that it was made with") {
  const MeshSequence with = test::shorteningTube(2, 0.0, 0.0, 0.12);
  const MeshSequence without = test::shorteningTube(2, 0.0, 0.0, 0.0);
  BodyStretchSettings settings;
  const auto flattening = gravityFlattening(with, without, settings);
  REQUIRE(flattening);
  CHECK(flattening->height == Approx(0.88).epsilon(1e-3));
  CHECK(flattening->width == Approx(1.0 / 0.88).epsilon(1e-3));
  CHECK(flattening->compression == Approx(0.12).epsilon(0.01));
  CHECK(flattening->predictedHeight == Approx(1.0 - flattening->compression));
  CHECK(flattening->predictedWidth == Approx(1.0 / (1.0 - flattening->compression)));
  CHECK(flattening->length == Approx(1.0).epsilon(1e-2));
  // Eq. 6 for a cylinder of water: q = m g pi / (2 E l w), m = density * w^2 pi / 4 * l.
  CHECK(flattening->youngModulus == Approx(1000.0 * 9.81 * pi * pi * 1.0 / (8.0 * 0.12)).epsilon(0.1));
}

TEST_CASE("flattening is measured where the body has come to, with the length that gravity took") {
  MeshSequence with = test::shorteningTube(2, 0.0, 0.0, 0.12);
  MeshSequence without = test::shorteningTube(2, 0.0, 0.0, 0.0);
  for (glm::vec3& p : with.frame(1)) {
    p.x *= 0.9F;
  }
  for (MeshSequence* const sequence : {&with, &without}) {
    for (glm::vec3& p : sequence->frame(0)) {
      p = {p.z, p.y, -p.x}; // it turns from along z to along x
    }
  }
  const auto flattening = gravityFlattening(with, without, {});
  REQUIRE(flattening);
  CHECK(flattening->height == Approx(0.88).epsilon(0.01));
  CHECK(flattening->width == Approx(1.0 / 0.88).epsilon(0.01));
  CHECK(flattening->length == Approx(0.9).epsilon(0.01));
}

TEST_CASE("a tolerance is not met by what is off beside a first frame without an extent, and names the bones "
          "that were made") {
  MeshSequence sequence = skinAllFrames(test::wavingTube(8, 6));
  std::ranges::fill(sequence.frame(0), glm::vec3(0.0F));
  CompressSettings settings;
  settings.stretch = StretchOption::measured;
  settings.tolerancePercent = 0.01;
  const auto result = compress(sequence, settings);
  REQUIRE(result);
  CHECK(result->metrics.rmsePercent > *settings.tolerancePercent);
  const auto told = [&](const std::string& text) {
    return std::ranges::any_of(result->warnings, [&](const std::string& warning) {
      return warning.find(text) != std::string::npos;
    });
  };
  CHECK(told("is not met: " + std::to_string(result->skinned.bones.size()) + " bones are off"));
  CHECK(told("parts of the diagonal of frame 1"));
}

TEST_CASE("a sequence of one frame is told to make no clip") {
  const MeshSequence still = test::still(test::tube(10.0, 0.5, 40, 10));
  const auto result = compressed(still, 6, StretchOption::measured, WeightOption::fitted);
  REQUIRE_FALSE(result.warnings.empty());
  CHECK_THAT(result.warnings.back(), Catch::Contains("one frame") && Catch::Contains("no clip"));
}
