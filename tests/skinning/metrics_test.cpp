#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "skinning/metrics.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A tube that waves.
MeshSequence waving(int frames) {
  MeshSequence sequence = test::still(test::tube(4.0, 0.5, 16, 8));
  const auto rest = sequence.positions;
  sequence.positions.clear();
  for (int k = 0; k < frames; ++k) {
    for (const glm::vec3& p : rest) {
      sequence.positions.push_back(
          p + glm::vec3(0.0F, 0.3F * std::sin(p.x + 0.2F * static_cast<float>(k)), 0.0F));
    }
  }
  return sequence;
}

MeshSequence moved(const MeshSequence& sequence, const glm::quat& rotation, const glm::vec3& shift) {
  MeshSequence result = sequence;
  for (glm::vec3& p : result.positions) {
    p = rotation * p + shift;
  }
  return result;
}

MeshSequence shaken(const MeshSequence& sequence, float size) {
  MeshSequence result = sequence;
  for (std::size_t i = 0; i < result.positions.size(); ++i) {
    result.positions[i].z += size * std::sin(12.9898F * static_cast<float>(i % 977));
  }
  return result;
}

SequenceMetrics compared(const MeshSequence& a, const MeshSequence& b) {
  const auto metrics = compareSequences(a, b);
  REQUIRE(metrics);
  return *metrics;
}

} // namespace

TEST_CASE("identical sequences are no distance apart by any measure") {
  const MeshSequence sequence = waving(12);
  const SequenceMetrics metrics = compared(sequence, sequence);
  CHECK(metrics.mse == 0.0);
  CHECK(metrics.rmsePercent == 0.0);
  CHECK(metrics.kgError == 0.0);
  CHECK(metrics.sted == 0.0);
}

TEST_CASE("a shift by a known distance gives its square, its share of the diagonal and of the spread") {
  const MeshSequence sequence = waving(5);
  const SequenceMetrics metrics =
      compared(sequence, moved(sequence, glm::quat(1, 0, 0, 0), glm::vec3(0.0F, 0.3F, 0.4F)));
  CHECK(metrics.mse == Approx(0.25).epsilon(1e-5));
  const double diagonal = boxDiagonal(sequence.frame(0));
  CHECK(metrics.rmsePercent == Approx(50.0 / diagonal).epsilon(1e-5));
  CHECK(metrics.largestPercent == Approx(50.0 / diagonal).epsilon(1e-5));
  double spread = 0.0;
  for (std::size_t k = 0; k < sequence.frameCount(); ++k) {
    Vec3 centroid(0.0);
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      centroid += Vec3(sequence.frame(k)[v]) / static_cast<double>(sequence.vertexCount);
    }
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      const Vec3 off = Vec3(sequence.frame(k)[v]) - centroid;
      spread += glm::dot(off, off);
    }
  }
  CHECK(metrics.kgError ==
        Approx(100.0 * std::sqrt(0.25 * static_cast<double>(sequence.positions.size()) / spread))
            .epsilon(1e-5));
}

TEST_CASE("distances are told in parts of the reference's size, not of the other's") {
  const MeshSequence sequence = waving(5);
  MeshSequence larger = sequence;
  for (glm::vec3& p : larger.positions) {
    p *= 2.0F;
  }
  const SequenceMetrics metrics = compared(sequence, larger);
  CHECK(metrics.rmsePercent ==
        Approx(100.0 * std::sqrt(metrics.mse) / boxDiagonal(sequence.frame(0))).epsilon(1e-6));
}

TEST_CASE("the largest distance is that of any frame") {
  const MeshSequence sequence = waving(5);
  for (const std::size_t frame : {0U, 2U, 4U}) {
    MeshSequence off = sequence;
    off.frame(frame)[3].y += 0.5F;
    CHECK(compared(sequence, off).largestPercent ==
          Approx(50.0 / boxDiagonal(sequence.frame(0))).epsilon(1e-5));
  }
}

TEST_CASE("a jump in time counts in every step whose window it lies in, by its weight") {
  MeshSequence still = waving(1);
  for (int frame = 1; frame < 12; ++frame) {
    still.positions.insert(still.positions.end(), still.positions.begin(),
                           still.positions.begin() + static_cast<std::ptrdiff_t>(still.vertexCount));
  }
  MeshSequence jumping = still;
  for (std::size_t frame = 6; frame < 12; ++frame) {
    for (std::size_t v = 0; v < still.vertexCount; ++v) {
      jumping.frame(frame)[v].x += 0.3F;
    }
  }
  StedSettings settings;
  settings.timeStep = 0.4;
  settings.window = GENERATE(1, 3, 5);
  settings.c = GENERATE(0.5, 2.0);
  const auto metrics = compareSequences(still, jumping, settings);
  REQUIRE(metrics);
  // One of 11 steps is hypot(0.3, 0.4) long in place of 0.4, a quarter more; a window of w steps that holds
  // it deviates by sqrt(w - 1) / w of that, and w windows do.
  const double wanted = 0.25 * std::sqrt(settings.window - 1.0) / 11.0;
  CHECK(metrics->stedTemporal == Approx(wanted).margin(1e-5));
  CHECK(metrics->sted == Approx(settings.c * wanted).margin(1e-5));
}

TEST_CASE("STED does not see where a sequence is, the squared error does") {
  const MeshSequence sequence = waving(12);
  const glm::quat turn = glm::angleAxis(0.7F, glm::normalize(glm::vec3(1, 2, 3)));
  const SequenceMetrics metrics = compared(sequence, moved(sequence, turn, glm::vec3(3, 1, 2)));
  CHECK(metrics.mse > 1.0);
  CHECK(metrics.sted < 1e-4);
}

TEST_CASE("one constant rigid transform of both sequences leaves STED unchanged") {
  const MeshSequence a = waving(12);
  const MeshSequence b = shaken(a, 0.02F);
  const glm::quat turn = glm::angleAxis(1.1F, glm::normalize(glm::vec3(-1, 2, 0.5F)));
  const double before = compared(a, b).sted;
  CHECK(before > 0.01);
  CHECK(compared(moved(a, turn, glm::vec3(1, 2, 3)), moved(b, turn, glm::vec3(1, 2, 3))).sted ==
        Approx(before).epsilon(1e-3));
}

TEST_CASE("STED grows with noise, and its temporal part with noise in time alone") {
  const MeshSequence a = waving(12);
  CHECK(compared(a, shaken(a, 0.02F)).sted > compared(a, shaken(a, 0.01F)).sted);
  MeshSequence jumping = a;
  for (std::size_t k = 1; k < a.frameCount(); k += 2) {
    for (std::size_t v = 0; v < a.vertexCount; ++v) {
      jumping.frame(k)[v].x += 0.01F * static_cast<float>(k % 3);
    }
  }
  const SequenceMetrics metrics = compared(a, jumping);
  CHECK(metrics.stedSpatial < 1e-4);
  CHECK(metrics.stedTemporal > 1e-2);
  CHECK(metrics.stedSettings.timeStep > 0.0);
}

TEST_CASE("sequences that do not match are refused") {
  const MeshSequence a = waving(4);
  CHECK(compareSequences(a, waving(5)).error().line().find("4 frames against 5") != std::string::npos);
  CHECK_FALSE(compareSequences(a, test::still(test::sphere(1))));
}

namespace {

/// Frames of one triangle.
MeshSequence triangleOver(const std::vector<std::vector<glm::vec3>>& frames) {
  MeshSequence sequence;
  sequence.name = "triangle";
  sequence.vertexCount = 3;
  sequence.triangles = {{0, 1, 2}};
  for (const std::vector<glm::vec3>& frame : frames) {
    sequence.positions.insert(sequence.positions.end(), frame.begin(), frame.end());
  }
  return sequence;
}

// With the sides 3, 4 and 5.
const std::vector<glm::vec3> rightTriangle{{0.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.0F}, {0.0F, 4.0F, 0.0F}};

} // namespace

TEST_CASE(
    "the spatial part of STED is how unequally the edges around each vertex changed, by their lengths") {
  const MeshSequence reference = triangleOver({rightTriangle});
  const MeshSequence other = triangleOver({{{0.0F, 0.0F, 0.0F}, {3.6F, 0.0F, 0.0F}, {0.0F, 4.0F, 0.0F}}});
  // The sides became 1.2, 1 and hypot(3.6, 4) / 5 times as long.
  const double third = std::hypot(3.6, 4.0) / 5.0 - 1.0;
  const double mean = (3.0 * 0.2 + 5.0 * third) / 12.0;
  const double square = (3.0 * 0.04 + 5.0 * third * third) / 12.0;
  const SequenceMetrics metrics = compared(reference, other);
  CHECK(metrics.stedSpatial == Approx(std::sqrt(square - mean * mean)).epsilon(1e-5));
  CHECK(metrics.stedTemporal == 0.0); // of one frame
  CHECK(metrics.sted == Approx(metrics.stedSpatial));
  CHECK(metrics.mse == Approx(0.36 / 3.0).epsilon(1e-5));
  CHECK(metrics.rmsePercent == Approx(100.0 * std::sqrt(0.12) / 5.0).epsilon(1e-5));
  CHECK(metrics.largestPercent == Approx(100.0 * 0.6 / 5.0).epsilon(1e-5));
  // From the centroid (1, 4/3, 0): 1 + 16/9, 4 + 16/9 and 1 + 64/9.
  CHECK(metrics.kgError == Approx(100.0 * std::sqrt(0.36 / (6.0 + 96.0 / 9.0))).epsilon(1e-5));
  CHECK(metrics.stedSettings.timeStep == Approx(0.4)); // a tenth of the mean edge
  // An edge of the reference that has no length has no share.
  const MeshSequence flat = triangleOver({{{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 4.0F, 0.0F}}});
  const SequenceMetrics opened = compared(flat, reference);
  CHECK(opened.stedSpatial == Approx(0.5 * 0.25).epsilon(1e-5)); // 4 and 5 where both were 4
  CHECK(opened.kgError > 0.0);
}

TEST_CASE("the diagonal and the edges are those of the reference's first frame") {
  std::vector<glm::vec3> large = rightTriangle;
  std::vector<glm::vec3> off = rightTriangle;
  for (glm::vec3& place : large) {
    place *= 10.0F;
  }
  off[1].z = 1.0F;
  const MeshSequence reference = triangleOver({rightTriangle, large});
  const MeshSequence other = triangleOver({off, large});
  const SequenceMetrics metrics = compared(reference, other);
  CHECK(metrics.largestPercent == Approx(20.0));
  CHECK(metrics.mse == Approx(1.0 / 6.0));
  CHECK(metrics.rmsePercent == Approx(20.0 * std::sqrt(1.0 / 6.0)).epsilon(1e-5));
  CHECK(metrics.stedSettings.timeStep == Approx(0.4));
  const double spread = 6.0 + 96.0 / 9.0;
  CHECK(metrics.kgError == Approx(100.0 * std::sqrt(1.0 / (spread + 100.0 * spread))).epsilon(1e-5));
}

TEST_CASE("the neighbourhood of a vertex is as many rings of triangles as are asked for") {
  // A strip of four triangles: the far edge changes alone.
  MeshSequence strip;
  strip.vertexCount = 6;
  strip.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
  strip.positions = {{0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {1.0F, 0.0F, 0.0F},
                     {1.0F, 1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {2.0F, 1.0F, 0.0F}};
  MeshSequence other = strip;
  other.positions[5].x = 2.5F;
  const auto spatial = [&](int rings) {
    StedSettings settings;
    settings.rings = rings;
    const auto metrics = compareSequences(strip, other, settings);
    REQUIRE(metrics);
    return metrics->stedSpatial;
  };
  // Edges 3-5 (1 long, 1.5 after) and 4-5 (1 long) belong to the last triangle.
  const double slanted = std::hypot(0.5, 1.0) - 1.0;
  const auto deviation = [&](double others) {
    const double whole = others + 2.0;
    const double mean = (0.5 + slanted) / whole;
    return std::sqrt((0.25 + slanted * slanted) / whole - mean * mean);
  };
  const double diagonal = std::sqrt(2.0);
  // One ring: 3 sees the triangles 2 to 4, 4 the last two, 5 the last.
  const double lastTriangle = diagonal;          // 3-4
  const double lastTwo = 2.0 + diagonal;         // 2-3, 2-4 and 3-4
  const double lastThree = 3.0 + 2.0 * diagonal; // 1-2, 1-3 and 2-3 too
  const double all = 5.0 + 2.0 * diagonal;       // 0-1 and 0-2 too
  CHECK(spatial(1) ==
        Approx((deviation(lastThree) + deviation(lastTwo) + deviation(lastTriangle)) / 6.0).epsilon(1e-5));
  // Two: 1 to 4 see all, as 2 and 3 do or 2 alone; 5 what 3 sees, and 0 not the last.
  CHECK(spatial(2) == Approx((4.0 * deviation(all) + deviation(lastThree)) / 6.0).epsilon(1e-5));
  CHECK(spatial(3) == Approx(deviation(all)).epsilon(1e-5));
}

TEST_CASE("sequences of other vertices, frames and triangles are refused, each with both counts") {
  const MeshSequence one = triangleOver({rightTriangle});
  const auto refused = [&](const MeshSequence& a, const MeshSequence& b) {
    const auto metrics = compareSequences(a, b);
    REQUIRE_FALSE(metrics);
    return metrics.error().line();
  };
  MeshSequence four = one;
  four.vertexCount = 4;
  four.positions.emplace_back(1.0F);
  const std::string place = "triangle against triangle: ";
  CHECK(refused(one, four) == place + "3 vertices against 4; compare sequences of one mesh");
  CHECK(refused(one, triangleOver({rightTriangle, rightTriangle})) ==
        place + "1 frames against 2; compare the same range of frames");
  MeshSequence twice = one;
  twice.triangles.push_back({0, 2, 1});
  CHECK(refused(one, twice) == place + "1 triangles against 2; compare sequences of one mesh");
  MeshSequence none;
  none.name = "triangle";
  CHECK(refused(none, none) == place + "0 vertices against 0; compare sequences of one mesh");
  const MeshSequence frameless = triangleOver({});
  CHECK(refused(frameless, frameless) == place + "0 frames against 0; compare the same range of frames");
}

TEST_CASE(
    "errors of a body that grows from a point are parts of the first frame that it is seen in, and told "
    "so") {
  MeshSequence growing = waving(3);
  std::ranges::fill(growing.frame(0), glm::vec3(1.0F, 2.0F, 3.0F));
  MeshSequence off = growing;
  off.frame(2)[3].y += 0.5F;
  const SequenceMetrics metrics = compared(growing, off);
  CHECK(metrics.largestPercent == Approx(50.0 / boxDiagonal(std::as_const(growing).frame(1))).epsilon(1e-5));
  CHECK_THAT(frameOfErrors(growing), Catch::Contains("of frame 1"));
  CHECK(frameOfErrors(waving(3)).empty());
}

TEST_CASE("an error of nothing is told where two are equal alone, also where neither has an extent") {
  MeshSequence point = waving(2);
  std::ranges::fill(point.positions, glm::vec3(1.0F));
  MeshSequence off = point;
  CHECK(compared(point, off).rmsePercent == 0.0);
  off.frame(1)[0].x += 1.0F;
  const SequenceMetrics metrics = compared(point, off);
  CHECK(metrics.rmsePercent == 100.0);
  CHECK(metrics.largestPercent == 100.0);
  CHECK(metrics.kgError == 100.0);
  CHECK(compared(point, point).kgError == 0.0);
}
