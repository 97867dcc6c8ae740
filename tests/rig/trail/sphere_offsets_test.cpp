#include "rig/trail/sphere_offsets.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/frames.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

const std::vector<double> controls{0.0, 4.0, 7.0, 12.0, 14.0, 20.0, 26.0};

Vec3 slopeAt(const SphereOffsets& offsets, double frame, double step) {
  return (offsets.at(frame + step) - offsets.at(frame)) / step;
}

} // namespace

TEST_CASE("no sphere pulled: no offset anywhere") {
  const SphereOffsets offsets(controls, {});
  CHECK(offsets.empty());
  CHECK(offsets.at(5.0) == Vec3(0.0));
}

TEST_CASE("a pulled sphere has its offset at its frame and the path moves smoothly to it") {
  const SphereOffsets offsets(controls, {{12.0, Vec3(0.3, -0.1, 0.2)}});
  CHECK(offsets.at(12.0) == Vec3(0.3, -0.1, 0.2));
  for (const double frame : controls) {
    CAPTURE(frame);
    const Vec3 jump = offsets.at(frame + 1e-7) - offsets.at(frame - 1e-7);
    CHECK(glm::length(jump) < 1e-6);
    if (frame > controls.front() && frame < controls.back()) {
      const double step = 1e-4;
      CHECK(glm::length(slopeAt(offsets, frame, step) - slopeAt(offsets, frame, -step)) < 1e-3);
    }
  }
}

TEST_CASE("nothing moves beyond the second neighbours of a pulled sphere") {
  const SphereOffsets offsets(controls, {{12.0, Vec3(0.3, -0.1, 0.2)}});
  for (const double frame : {0.0, 1.3, 3.9, 20.001, 22.0, 26.0}) {
    const bool beyond = frame <= 4.0 || frame >= 20.0;
    CAPTURE(frame);
    REQUIRE(beyond);
    CHECK(glm::length(offsets.at(frame)) == 0.0);
  }
  CHECK(glm::length(offsets.at(5.0)) > 0.0);
  CHECK(glm::length(offsets.at(19.0)) > 0.0);
}

TEST_CASE("equal steps of offset give a straight ramp, however the spheres are spaced") {
  std::vector<SphereOffset> pulled;
  pulled.reserve(controls.size());

  for (const double frame : controls) {
    pulled.push_back({frame, Vec3(0.01, 0.02, -0.005) * frame});
  }
  const SphereOffsets offsets(controls, pulled);
  for (double frame = 0.0; frame <= 26.0; frame += 0.37) {
    CHECK(glm::length(offsets.at(frame) - Vec3(0.01, 0.02, -0.005) * frame) < 1e-12);
  }
}

TEST_CASE("all spheres pulled alike carry the path as it is") {
  std::vector<SphereOffset> pulled;
  pulled.reserve(controls.size());

  for (const double frame : controls) {
    pulled.push_back({frame, Vec3(0.1, 0.0, 0.0)});
  }
  const SphereOffsets offsets(controls, pulled);
  for (double frame = -3.0; frame <= 30.0; frame += 0.31) {
    CHECK(glm::length(offsets.at(frame) - Vec3(0.1, 0, 0)) < 1e-12);
  }
}

TEST_CASE("a sphere pulled at a frame that is no control frame becomes one") {
  const SphereOffsets offsets({0.0, 10.0}, {{5.0, Vec3(1, 0, 0)}});
  CHECK(offsets.at(5.0) == Vec3(1, 0, 0));
  CHECK(offsets.at(0.0) == Vec3(0.0));
  CHECK(offsets.at(10.0) == Vec3(0.0));
}

TEST_CASE("one sphere alone moves the whole path") {
  const SphereOffsets offsets({}, {{5.0, Vec3(1, 0, 0)}});
  CHECK(offsets.at(0.0) == Vec3(1, 0, 0));
  CHECK(offsets.at(9.0) == Vec3(1, 0, 0));
}

TEST_CASE(
    "a sphere with a tangent of its own has that slope on both sides, and its neighbours keep their place") {
  const Vec3 tangent(0.0, 0.4, -0.1);
  const SphereOffsets offsets(controls, {{12.0, Vec3(0.3, -0.1, 0.2), tangent}});
  CHECK(offsets.at(12.0) == Vec3(0.3, -0.1, 0.2));
  CHECK(glm::length(slopeAt(offsets, 12.0, 1e-5) - tangent) < 1e-3);
  CHECK(glm::length(slopeAt(offsets, 12.0, -1e-5) - tangent) < 1e-3);
  CHECK(glm::length(offsets.slopeAt(12.0) - tangent) < 1e-12);
  for (const double frame : controls) {
    CHECK(glm::length(offsets.at(frame)) == Approx(frame == 12.0 ? glm::length(Vec3(0.3, -0.1, 0.2)) : 0.0));
  }
}

TEST_CASE("a sphere that is pulled a hair behind a control frame has its tangent there") {
  const Vec3 tangent(0.0, 0.4, -0.1);
  const SphereOffsets offsets(controls, {{12.0 + 0.5 * frameTolerance, Vec3(0.3, -0.1, 0.2), tangent}});
  CHECK(offsets.at(12.0) == Vec3(0.3, -0.1, 0.2));
  CHECK(glm::length(offsets.slopeAt(12.0) - tangent) < 1e-12);
}

TEST_CASE("a tangent bends the path between the neighbours of its sphere and nowhere else") {
  const SphereOffsets offsets(controls, {{12.0, Vec3(0.0), Vec3(0.0, 0.4, 0.0)}});
  CHECK(offsets.at(13.0).y > 0.05);
  CHECK(offsets.at(10.0).y < -0.05);
  for (const double frame : {5.0, 7.0, 14.0, 15.0}) {
    CHECK(offsets.at(frame).y == 0.0);
  }
}

TEST_CASE("the slope between spheres is that of the curve") {
  const SphereOffsets offsets(controls, {{12.0, Vec3(0.3, -0.1, 0.2), Vec3(0.1, 0.0, 0.0)}});
  for (const double frame : {5.0, 7.0, 9.3, 12.0, 13.1, 20.0}) {
    CAPTURE(frame);
    CHECK(glm::length(offsets.slopeAt(frame) - slopeAt(offsets, frame, 1e-6)) < 1e-4);
  }
  CHECK(offsets.slopeAt(-1.0) == Vec3(0.0));
  CHECK(offsets.slopeAt(30.0) == Vec3(0.0));
}
