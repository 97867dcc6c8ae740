// Small pieces of compression: rows of bones, groups of faces, the strongest weights, meshes made usable.
#include <cmath>
#include <memory>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/gltf/import/mesh_surface.h"
#include "skinning/compress/chain_stretch.h"
#include "skinning/compress/usable_mesh.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/export/mesh_grid.h"
#include "skinning/fit/joint_tree.h"
#include "skinning/geometry/shape_diameter.h"
#include "skinning/weights/geodesic_weights.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

std::vector<SkinBone> treeOf(const std::vector<int>& parents) {
  std::vector<SkinBone> bones;
  for (std::size_t b = 0; b < parents.size(); ++b) {
    SkinBone bone;
    bone.parent = parents[b];
    bone.pivot = Vec3(static_cast<double>(b), 0.0, 10.0 * static_cast<double>(b));
    bones.push_back(bone);
  }
  return bones;
}

Influences rowOf(std::initializer_list<std::pair<int, float>> weights) {
  Influences row;
  std::size_t i = 0;
  for (const auto& [bone, weight] : weights) {
    row.bones[i] = static_cast<std::uint16_t>(bone);
    row.weights[i++] = weight;
  }
  return row;
}

} // namespace

TEST_CASE("Rows of a tree end where it branches, every bone in one of them, parents' rows first") {
  using Rows = std::vector<std::vector<std::size_t>>;
  CHECK(rowsOfTree(treeOf({-1})) == Rows{{0}});
  CHECK(rowsOfTree(treeOf({-1, 0, 1, 2})) == Rows{{0, 1, 2, 3}});
  CHECK(rowsOfTree(treeOf({-1, 0, 1, 1, 2})) == Rows{{0, 1}, {2, 4}, {3}});
  CHECK(rowsOfTree(treeOf({1, -1, 0, 1})) == Rows{{1}, {0, 2}, {3}});
  CHECK(rowsOfTree(treeOf({-1, -1, 1})) == Rows{{0}, {1, 2}});
  CHECK(rowsOfTree({}).empty());
}

TEST_CASE("Bones of a tree come parents first, whatever their numbers") {
  const std::vector<std::size_t> order = orderOfTree(treeOf({3, 0, -1, 2, 3}));
  REQUIRE(order.size() == 5);
  const auto placeOf = [&](std::size_t bone) { return std::ranges::find(order, bone) - order.begin(); };
  CHECK(placeOf(2) < placeOf(3));
  CHECK(placeOf(3) < placeOf(0));
  CHECK(placeOf(3) < placeOf(4));
  CHECK(placeOf(0) < placeOf(1));
}

TEST_CASE(
    "A bone stretches along the axis of its that lies nearest to it, the first of those that lie as near") {
  const auto stretchedAxis = [](const Vec3& along) {
    SkinnedSequence sequence;
    sequence.bones = {{Vec3(0.0), along}};
    Influences whole;
    whole.weights[0] = 1.0F;
    for (const Vec3& joint : {Vec3(0.0), along}) {
      for (int i = 0; i < 12; ++i) {
        sequence.bindPositions.emplace_back(joint * (0.99 + 0.001 * i));
        sequence.influences.push_back(whole);
      }
    }
    sequence.poses.resize(2);
    sequence.poses[1].scale = Vec3(1.5);
    const std::vector<ChainStretch> rows = stretchRows(sequence, LengthModel::measuredMean, 0);
    REQUIRE(rows.size() == 1);
    const Vec3 scale = sequence.pose(1, 0).scale;
    int axis = -1;
    for (const int i : {0, 1, 2}) {
      const auto at = static_cast<std::size_t>(i);
      axis = scale[at] > 1.1 ? i : axis;
      CHECK((scale[at] > 1.1 || scale[at] == Approx(1.0 / std::sqrt(rows[0].most))));
    }
    CHECK(sequence.pose(0, 0).scale == Vec3(1.0));
    return axis;
  };
  CHECK(stretchedAxis({2.0, 1.0, -1.0}) == 0);
  CHECK(stretchedAxis({1.0, -2.0, 1.0}) == 1);
  CHECK(stretchedAxis({1.0, 1.0, 2.0}) == 2);
  CHECK(stretchedAxis({1.0, 1.0, 0.0}) == 0);
  CHECK(stretchedAxis({-1.0, 1.0, 0.0}) == 0);
  CHECK(stretchedAxis({0.0, 1.0, 1.0}) == 1);
  CHECK(stretchedAxis({1.0, 0.0, 1.0}) == 0);
  CHECK(stretchedAxis({1.0, 1.0, -1.0}) == 0);
}

TEST_CASE("The middle of what hangs on a bone is the mean of its children's places") {
  const auto middles = middlesOfChildren(treeOf({-1, 0, 0, 1}));
  REQUIRE(middles.size() == 4);
  CHECK(middles[0] == Vec3(1.5, 0.0, 15.0));
  CHECK(middles[1] == Vec3(3.0, 0.0, 30.0));
  CHECK_FALSE(middles[2]);
  CHECK_FALSE(middles[3]);
}

TEST_CASE("Of weights the four largest stay, the first of equal ones, and make up the whole") {
  CHECK(strongestFour({0.5, 0.0, 1.5}) == rowOf({{2, 0.75F}, {0, 0.25F}}));
  CHECK(strongestFour({1.0, 1.0, 1.0, 1.0, 1.0, 1.0}) ==
        rowOf({{0, 0.25F}, {1, 0.25F}, {2, 0.25F}, {3, 0.25F}}));
  CHECK(strongestFour({1.0, 2.0, 5.0, 4.0, 5.0, 2.0}) ==
        rowOf({{2, 0.3125F}, {4, 0.3125F}, {3, 0.25F}, {1, 0.125F}}));
  CHECK(strongestFour({0.0, 0.0}) == rowOf({{0, 1.0F}}));
  CHECK(strongestFour({}) == rowOf({{0, 1.0F}}));
  CHECK(strongestFour({3.0}) == rowOf({{0, 1.0F}}));
}

TEST_CASE("The mean of a group of faces counts each by its area, and leaves out those of no group") {
  const std::vector<glm::vec3> places{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 3, 0}, {1, 1, 1}};
  // Areas 1, 3 and 1, and one without any.
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 1, 3}, {2, 1, 0}, {4, 4, 4}};
  CHECK(meanByGroup(places, triangles, {10.0, 2.0, 100.0, 7.0}, {0, 0, -1, 1}, 3) ==
        std::vector<double>{4.0, 0.0, 0.0});
  CHECK(meanByGroup(places, triangles, {10.0, 2.0, 100.0, 7.0}, {1, 0, 1, 0}, 2) ==
        std::vector<double>{2.0, 55.0});
}

TEST_CASE("By a single ray a box is as thick as it is wide, below every face, and a mesh without faces is "
          "refused") {
  const test::Shape box = test::box({2, 2, 2}, 3.0);
  const auto measured =
      shapeDiameters(box.positions, box.triangles, {.coneDegrees = 1.0, .rays = 1, .smoothingRounds = 0});
  REQUIRE(measured);
  CHECK(measured->facesWithoutHit == 0);
  for (const double face : measured->faces) {
    CHECK(face == Approx(6.0).epsilon(1e-3));
  }
  for (const double vertex : measured->vertices) {
    CHECK(vertex == Approx(6.0).epsilon(1e-3));
  }
  CHECK_FALSE(shapeDiameters(box.positions, {}));
  CHECK_FALSE(shapeDiameters({}, {}));
}

TEST_CASE("Rays count by how near they are to the normal, those within a degree alike") {
  // From the floor of a deep shaft only the ceiling 2 above it is met straight on, walls farther off it are
  // not.
  const test::Shape slab = test::box({40, 1, 40}, 1.0);
  const auto measured =
      shapeDiameters(slab.positions, slab.triangles, {.coneDegrees = 120.0, .rays = 3, .smoothingRounds = 0});
  REQUIRE(measured);
  // Three rays of equal solid angle in a cone of 60 degrees to either side: cosines 1 - 0.5 (i + 0.5) / 3.
  std::vector<std::pair<double, double>> rays;
  for (int i = 0; i < 3; ++i) {
    const double cosine = 1.0 - 0.5 * (i + 0.5) / 3.0;
    rays.emplace_back(1.0 / cosine, 1.0 / (std::acos(cosine) * 180.0 / pi));
  }
  double mean = 0.0;
  double square = 0.0;
  for (const auto& [length, weight] : rays) {
    mean += length / 3.0;
    square += length * length / 3.0;
  }
  const double deviation = std::sqrt(square - mean * mean);
  double sum = 0.0;
  double weights = 0.0;
  for (const auto& [length, weight] : rays) {
    if (std::abs(length - rays[1].first) <= deviation) {
      sum += weight * length;
      weights += weight;
    }
  }
  // In the middle of the large sides.
  for (std::size_t f = 0; f < slab.triangles.size(); ++f) {
    const Triangle& t = slab.triangles[f];
    const glm::vec3 middle = (slab.positions[t[0]] + slab.positions[t[1]] + slab.positions[t[2]]) / 3.0F;
    const bool isLevel =
        slab.positions[t[0]].y == slab.positions[t[1]].y && slab.positions[t[1]].y == slab.positions[t[2]].y;
    if (isLevel && std::abs(middle.x - 20.0F) < 5.0F && std::abs(middle.z - 20.0F) < 5.0F) {
      CHECK(measured->faces[f] == Approx(sum / weights).epsilon(2e-3));
    }
  }
}

TEST_CASE(
    "A grid around places has their middle and half of their longest side, and stands for none of no size") {
  const MeshGrid grid = gridAround(std::vector<glm::vec3>{{1, 2, 3}, {5, 0, 3}, {2, 10, 3}});
  CHECK(grid.centre == Vec3(3.0, 5.0, 3.0));
  CHECK(grid.halfSize == 5.0);
  const MeshGrid point = gridAround(std::vector<glm::vec3>{{1, 2, 3}});
  CHECK(point.centre == Vec3(1.0, 2.0, 3.0));
  CHECK(point.halfSize == 1.0);
  CHECK(gridAround({}).halfSize == 1.0);
}

TEST_CASE("A frame of a sequence takes twelve bytes for each vertex") {
  MeshSequence sequence;
  sequence.vertexCount = 10;
  CHECK(sourceBytesPerFrame(sequence) == 120);
}

TEST_CASE("A sound mesh is used as it is") {
  const MeshSequence sound = test::still(test::tube(4.0, 1.0, 3, 6));
  const UsableMesh usable = usableMesh(sound);
  CHECK_FALSE(usable.changed);
  CHECK(usable.warnings.empty());
  SkinnedSequence skinned;
  skinned.influences = {rowOf({{3, 1.0F}})};
  giveBackVertices(usable, sound, skinned);
  CHECK(skinned.influences.size() == 1);
}

TEST_CASE("Vertices of no triangle are left out and given back, on the first bone") {
  MeshSequence sequence;
  sequence.name = "sheet";
  sequence.clipName = "wave";
  sequence.surface = std::make_shared<const gltf::MeshSurface>();
  sequence.vertexCount = 5;
  sequence.framesPerSecond = 12.0;
  sequence.frameNames = {"a", "b"};
  sequence.triangles = {{1, 2, 4}};
  for (int frame = 0; frame < 2; ++frame) {
    for (int v = 0; v < 5; ++v) {
      sequence.positions.emplace_back(v, v * v, frame);
    }
  }
  const UsableMesh usable = usableMesh(sequence);
  REQUIRE(usable.changed);
  CHECK(usable.vertices == std::vector<std::uint32_t>{1, 2, 4});
  CHECK(usable.warnings ==
        std::vector<std::string>{"2 vertices of no triangle count in no fit and in no error"});
  CHECK(usable.changed->vertexCount == 3);
  CHECK(usable.changed->name == "sheet");
  CHECK(usable.changed->framesPerSecond == 12.0);
  CHECK(usable.changed->frameNames.size() == 2);
  CHECK(usable.changed->triangles == std::vector<Triangle>{{0, 1, 2}});
  CHECK(usable.changed->positions ==
        std::vector<glm::vec3>{{1, 1, 0}, {2, 4, 0}, {4, 16, 0}, {1, 1, 1}, {2, 4, 1}, {4, 16, 1}});
  SkinnedSequence skinned = withoutBones(*usable.changed);
  skinned.influences = {rowOf({{5, 1.0F}}), rowOf({{6, 1.0F}}), rowOf({{7, 1.0F}})};
  giveBackVertices(usable, sequence, skinned);
  CHECK(skinned.clipName == "wave");
  CHECK(skinned.surface == sequence.surface);
  CHECK(skinned.triangles == sequence.triangles);
  CHECK(skinned.bindPositions ==
        std::vector<glm::vec3>(sequence.positions.begin(), sequence.positions.begin() + 5));
  CHECK(skinned.influences == std::vector<Influences>{rowOf({{0, 1.0F}}), rowOf({{5, 1.0F}}),
                                                      rowOf({{6, 1.0F}}), rowOf({{0, 1.0F}}),
                                                      rowOf({{7, 1.0F}})});
}
