// What is told of bones, runs and frames that do not fit the mesh.
#include <catch2/catch.hpp>

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

} // namespace

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
