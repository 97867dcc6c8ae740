// What is refused and what is taken, each at the edge.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "skinning/compress/compress.h"
#include "skinning/elastic/limb_elasticity.h"
#include "skinning/geometry/shape_diameter.h"
#include "skinning/sequence/obj_surface.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

LimbMotion restingLimb() {
  LimbMotion motion;
  for (int frame = 0; frame < 8; ++frame) {
    motion.joints.push_back({Vec3(0.0), Vec3(0.0, -0.3, 0.0), Vec3(0.0, -0.6, 0.0)});
  }
  return motion;
}

bool isTaken(const LimbElasticity& settings) {
  return limbElasticity(limbSegments({0.3, 0.3}, {0.08, 0.08}), restingLimb(), settings).ok();
}

std::string ofBones(const MeshSequence& sequence, int bones) {
  CompressSettings settings;
  settings.bones = bones;
  const auto result = compress(sequence, settings);
  REQUIRE_FALSE(result);
  return result.error().line();
}

} // namespace

TEST_CASE("a limb may be of any material that is not harder or softer than none") {
  LimbElasticity light;
  light.density = 0.5;
  CHECK(isTaken(light));
  light.density = 0.0;
  CHECK(isTaken(light));
  light.density = -0.1;
  CHECK_FALSE(isTaken(light));
  LimbElasticity soft;
  soft.youngModulus = 1e-12;
  CHECK(isTaken(soft));
  soft.youngModulus = 0.0;
  CHECK_FALSE(isTaken(soft));
  LimbElasticity stiff;
  stiff.stiffness = 1e6;
  CHECK(isTaken(stiff));
  stiff.stiffness = 1.1e6;
  CHECK_FALSE(isTaken(stiff));
}

TEST_CASE("a mesh has at most one bone for every four vertices, and is told how many that are") {
  const MeshSequence small = test::still(test::sphere(0)); // An icosahedron has twelve.
  CHECK_THAT(ofBones(small, 4),
             Catch::Contains("4 bones for 12 vertices") && Catch::EndsWith("ask for 1 to 3 bones"));
  CHECK_THAT(ofBones(small, 0), Catch::EndsWith("ask for 1 to 3 bones"));
  const MeshSequence large = test::still(test::sphere(4));
  CHECK_THAT(ofBones(large, 1001),
             Catch::EndsWith("ask for 1 to " + std::to_string(large.vertexCount / 4) + " bones"));
}

TEST_CASE("a mesh of three vertices is too few for a bone") {
  const MeshSequence triangle = test::still({{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}});
  CHECK_THAT(ofBones(triangle, 1), Catch::Contains("3 vertices are too few for a bone") &&
                                       Catch::EndsWith("give a mesh of at least 4 vertices"));
}

TEST_CASE("a sequence of one frame is told to move nothing, and one of two is not") {
  const auto tells = [](int frames) {
    CompressSettings settings;
    settings.bones = 6;
    settings.stretch = StretchOption::measured;
    const auto result = compress(skinAllFrames(test::armedBody(frames)), settings);
    REQUIRE(result);
    return std::ranges::any_of(result->warnings, [](const std::string& warning) {
      return warning.starts_with("there is one frame: nothing moves");
    });
  };
  CHECK(tells(1));
  CHECK_FALSE(tells(2));
}

TEST_CASE("a given skeleton is measured against the first frame of the mesh") {
  const SkinnedSequence truth = test::armedBody(3);
  MeshSequence sequence = skinAllFrames(truth);
  const std::size_t vertices = sequence.vertexCount;
  for (std::size_t v = vertices; v < sequence.positions.size(); ++v) {
    sequence.positions[v] *= 40.0F; // It bursts after the first frame.
  }
  CompressSettings settings;
  settings.skeleton = truth.bones;
  const auto stop = [](double) { return false; }; // It is looked at before anything is fitted.
  const auto result = compress(sequence, settings, stop);
  CHECK((result.ok() || result.error().line().find("in the units of the mesh") == std::string::npos));
  for (std::size_t v = 0; v < vertices; ++v) {
    sequence.positions[v] *= 40.0F;
  }
  const auto refused = compress(sequence, settings, stop);
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().line(), Catch::Contains("in the units of the mesh"));
}

TEST_CASE("a face without area has no thickness of its own and takes over that beside it") {
  test::Shape ball = test::sphere(2);
  const auto whole = shapeDiameters(ball.positions, ball.triangles);
  REQUIRE(whole);
  const Triangle first = ball.triangles.front();
  ball.triangles.push_back({first[0], first[1], first[1]});
  const auto odd = shapeDiameters(ball.positions, ball.triangles, {.smoothingRounds = 0});
  REQUIRE(odd);
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    CHECK(odd->vertices[v] > 1.5);
    CHECK(odd->vertices[v] < 2.05);
  }
}

TEST_CASE("a folder of frames is named after the folder") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "wolf");
  for (const char* const name : {"wolf/a1.obj", "wolf/a2.obj"}) {
    folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
  }
  const auto sequence = readSequence({folder.path() / "wolf"});
  REQUIRE(sequence);
  CHECK(sequence->name == "wolf");
}

TEST_CASE("a cache whose mesh cannot be read is refused with what is wrong with that") {
  const test::TemporaryFolder folder;
  std::string cache("POINTCACHE2\0", 12);
  cache.append(200, '\1');
  folder.write("run.pc2", cache);
  folder.write("run.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  const auto sequence = readSequence({folder.path() / "run.obj", folder.path() / "run.pc2"});
  REQUIRE_FALSE(sequence);
  CHECK_THAT(sequence.error().line(), Catch::Contains("run.obj"));
}

TEST_CASE(
    "a sequence without frames and one without triangles are refused with the same line, which names both") {
  MeshSequence ball = test::still(test::sphere(1));
  ball.name = "ball";
  const std::string told = "ball: the sequence has no frames or no triangles; give a sequence with both";
  MeshSequence bare = ball;
  bare.triangles.clear();
  CHECK(ofBones(bare, 1) == told);
  ball.positions.clear();
  CHECK(ofBones(ball, 1) == told);
}
