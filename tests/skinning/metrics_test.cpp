#include <catch2/catch.hpp>

#include <cmath>

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
