// What is told of bones, runs and frames that do not fit the mesh.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "skinning/body/given_skeleton.h"
#include "skinning/compress/compress.h"
#include "skinning/compress/flattening.h"
#include "skinning/compress/usable_mesh.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A block of 6 x 2 x 3 units: its diagonal is 7.
MeshSequence block() {
  return test::still(test::box({6, 2, 3}, 1.0));
}

/// What is told of bones with such pivots in the block; empty where they are taken.
std::string toldOfBones(const std::vector<Vec3>& pivots) {
  std::vector<SkinBone> bones(pivots.size());
  for (std::size_t b = 0; b < pivots.size(); ++b) {
    bones[b].pivot = pivots[b];
  }
  const Status taken = checkSkeleton(bones, block());
  return taken ? std::string() : taken.error().line();
}

/// What is told of a sequence that one bone along it follows, with measured stretch.
std::vector<std::string> toldOfOneBone(const MeshSequence& sequence) {
  SkinBone bone;
  bone.end = Vec3(10.0, 0.0, 0.0);
  bone.name = "trunk";
  CompressSettings settings;
  settings.skeleton = {bone};
  settings.stretch = StretchOption::measured;
  settings.weights = WeightOption::geodesic;
  const auto result = compress(sequence, settings);
  REQUIRE(result);
  return result->warnings;
}

/// A tube along x that is pulled to so many times its length, frame by frame.
MeshSequence pulledTube(const std::vector<float>& lengths) {
  MeshSequence sequence = test::still(test::tube(10.0, 0.5, 60, 12));
  const std::vector<glm::vec3> rest = sequence.positions;
  for (const float length : lengths) {
    for (const glm::vec3& place : rest) {
      sequence.positions.emplace_back(length * place.x, place.y, place.z);
    }
  }
  return sequence;
}

} // namespace

TEST_CASE("a bone that is scaled below a half or above twice is told with how far and in which frames") {
  CHECK(toldOfOneBone(pulledTube({0.6F, 1.9F})).empty());
  CHECK(toldOfOneBone(pulledTube({0.4F, 3.0F})) ==
        std::vector<std::string>{"1 bone is scaled below 0.5 or above 2, most of all trunk from 0.4 to 3 "
                                 "(frames 1 and 2): --scale-limit 2 keeps them within that, more bones may "
                                 "need less"});
  for (const float length : {0.4F, 3.0F}) {
    CAPTURE(length);
    CHECK(toldOfOneBone(pulledTube({length})).size() == 1);
  }
}

TEST_CASE("where bones that stretch freely are too few to follow a body, more of them are advised") {
  const std::vector<std::string> told = toldOfOneBone(test::shorteningTube(4, 1.5, 0.0, 0.0));
  CHECK(std::ranges::count_if(told, [](const std::string& warning) {
          return warning.ends_with("of the body's size on average: give more --bones");
        }) == 1);
}

TEST_CASE("bones span from a quarter of the mesh to four times as much, and both sizes are told beyond") {
  const auto apart = [](double units) { return toldOfBones({Vec3(1.0), Vec3(1.0 + units, 1.0, 1.0)}); };
  CHECK(apart(1.8).empty()); // A quarter of 7 is 1.75.
  CHECK_THAT(apart(1.5), Catch::Contains("its bones span 1.5 units and the mesh 7"));
  CHECK(apart(27.0).empty());
  CHECK_THAT(apart(35.0), Catch::Contains("its bones span 35 units and the mesh 7"));
  CHECK(toldOfBones({Vec3(1.0)}).empty()); // One bone spans nothing.
}

TEST_CASE("half of the bones lie in the mesh or a tenth of its size beside it, and how many do is told") {
  const Vec3 beside(6.6, 1.0, 1.0);
  const Vec3 below(0.0, -0.8, 0.0);
  const Vec3 above(6.0, 4.0, 0.0);
  const Vec3 behind(0.0, 0.0, -2.0);
  CHECK(toldOfBones({Vec3(1.0), beside, below, above}).empty());
  CHECK_THAT(toldOfBones({beside, below, above, behind}),
             Catch::Contains("only 1 of its 4 bones lie in the mesh") &&
                 Catch::Contains("where the first frame of the mesh does"));
}

TEST_CASE("a skeleton has the bones that it has: no tolerance asks for more of them") {
  const SkinnedSequence truth = test::armedBody(3);
  CompressSettings settings;
  settings.skeleton = truth.bones;
  settings.tolerancePercent = 1.0;
  const auto refused = compress(skinAllFrames(truth), settings, [](double) { return false; });
  REQUIRE_FALSE(refused);
  CHECK(refused.error().line() ==
        "--tolerance: a skeleton has the bones that it has; leave out --tolerance or --skeleton");
}

TEST_CASE("flattening is asked of two runs of one body, under gravity") {
  const MeshSequence run = test::shorteningTube(2, 0.0, 0.0, 0.12);
  MeshSequence other = run;
  other.triangles.pop_back();
  other.name = "cut open";
  const auto unlike = gravityFlattening(run, other, {});
  REQUIRE_FALSE(unlike);
  CHECK_THAT(unlike.error().line(), Catch::Contains("different meshes") && Catch::Contains("cut open"));
  BodyStretchSettings weightless;
  weightless.gravity = Vec3(0.0);
  const auto still = gravityFlattening(run, run, weightless);
  REQUIRE_FALSE(still);
  CHECK_THAT(still.error().line(), Catch::Contains("without gravity there is nothing to compare"));
}

TEST_CASE("how many triangles were turned outwards is told, of how many") {
  MeshSequence wound = block();
  const std::size_t count = wound.triangles.size();
  std::swap(wound.triangles[0][0], wound.triangles[0][1]);
  std::swap(wound.triangles[5][0], wound.triangles[5][1]);
  const UsableMesh usable = usableMesh(wound);
  REQUIRE(usable.warnings.size() == 1);
  CHECK(usable.warnings[0] == "neighbouring triangles are wound against each other: 2 of " +
                                  std::to_string(count) + " have been turned outwards");
  REQUIRE(usable.changed);
  CHECK(usable.changed->triangles.size() == count);
  CHECK(usableMesh(*usable.changed).warnings.empty());
}
