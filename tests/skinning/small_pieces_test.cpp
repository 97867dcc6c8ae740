// Small pieces that many parts stand on: weights that come together, the middle of a mesh, widths of bones.
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "core/anim/sampling.h"
#include "skinning/bind/weight_row.h"
#include "skinning/geometry/bone_widths.h"
#include "skinning/locate/middle_of_mesh.h"
#include "tests/support/nodes.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

std::vector<Vec3> placesOf(const test::Shape& shape, const Vec3& shift) {
  std::vector<Vec3> places;
  for (const glm::vec3& position : shape.positions) {
    places.push_back(Vec3(position) + shift);
  }
  return places;
}

/// A mesh of the shape, moved, each vertex hanging on one joint of a skin where one is given.
int addMesh(Scene& scene, const test::Shape& shape, const glm::vec3& shift, int joint = -1) {
  Primitive primitive;
  for (const glm::vec3& position : shape.positions) {
    primitive.positions.push_back(position + shift);
  }
  for (const Triangle& triangle : shape.triangles) {
    primitive.indices.insert(primitive.indices.end(), triangle.begin(), triangle.end());
  }
  if (joint >= 0) {
    VertexInfluences follows;
    follows.joints = {static_cast<std::uint16_t>(1 - joint), static_cast<std::uint16_t>(joint)};
    follows.weights = {0.25F, 0.75F};
    primitive.influences.assign(primitive.positions.size(), follows);
  }
  Mesh mesh;
  mesh.primitives.push_back(std::move(primitive));
  scene.meshes.push_back(std::move(mesh));
  return static_cast<int>(scene.meshes.size()) - 1;
}

std::vector<double> widthsIn(const Scene& scene, const std::vector<int>& boneOfNode, std::size_t bones) {
  return boneWidths(scene, frameOf(scene, restPose(scene), 0.0), boneOfNode, bones);
}

} // namespace

TEST_CASE("weights that come together are added by joint, and the strongest stay, the largest first") {
  WeightSum sum;
  sum.add(7, 0.25);
  sum.add(3, 0.5);
  sum.add(7, 0.75);
  sum.add(9, 0.25);
  sum.add(4, 0.0);
  sum.add(5, -1.0);
  CHECK(sum.of(7) == 1.0);
  CHECK(sum.of(3) == 0.5);
  CHECK(sum.of(4) == 0.0);
  CHECK(sum.of(5) == 0.0);
  const Influences three = sum.strongest(8);
  CHECK(three.bones == std::array<std::uint16_t, 8>{7, 3, 9});
  const std::vector<double> wanted{4.0 / 7.0, 2.0 / 7.0, 1.0 / 7.0};
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(static_cast<double>(three.weights[i]) == Approx(i < 3 ? wanted[i] : 0.0));
  }
  const Influences two = sum.strongest(2);
  CHECK(two.bones == std::array<std::uint16_t, 8>{7, 3});
  CHECK(static_cast<double>(two.weights[0]) == Approx(2.0 / 3.0));
  CHECK(static_cast<double>(two.weights[1]) == Approx(1.0 / 3.0));
  CHECK(two.weights[2] == 0.0F);
}

TEST_CASE("of equal weights the joint with the lower number comes first, and no more stay than a row holds") {
  WeightSum sum;
  for (std::uint16_t joint = 12; joint > 0; --joint) {
    sum.add(joint, 1.0);
  }
  const Influences row = sum.strongest(20);
  CHECK(row.bones == std::array<std::uint16_t, 8>{1, 2, 3, 4, 5, 6, 7, 8});
  for (const float weight : row.weights) {
    CHECK(weight == 0.125F);
  }
}

TEST_CASE("a row is added by its share, and where nothing was added all weight goes to the first joint") {
  Influences row;
  row.bones = {2, 6};
  row.weights = {0.75F, 0.25F};
  WeightSum sum;
  sum.add(row, 2.0);
  sum.add(6, 1.0);
  CHECK(sum.of(2) == 1.5);
  CHECK(sum.of(6) == 1.5);
  CHECK(sum.of(0) == 0.0);
  for (const std::size_t most : {1U, 4U, 8U}) {
    const Influences nothing = WeightSum().strongest(most);
    CHECK(nothing.bones == std::array<std::uint16_t, 8>{});
    CHECK(nothing.weights == std::array<float, 8>{1.0F});
  }
}

TEST_CASE("a place within a mesh comes to its middle across a direction, and one outside stays") {
  const test::Shape tube = test::tube(4.0, 0.5, 8, 64); // along x
  const Vec3 shift(10.0, -3.0, 7.0);
  const std::vector<Vec3> places = placesOf(tube, shift);
  for (const Vec3& off : {Vec3(0.0, 0.2, 0.1), Vec3(0.0, -0.3, 0.2), Vec3(0.0, 0.1, -0.4), Vec3(0.0)}) {
    for (const double length : {1.0, 3.0, -2.0}) {
      const Vec3 place = shift + Vec3(1.3, 0.0, 0.0) + off;
      const Vec3 middle = middleOfMesh(places, tube.triangles, place, {length, 0.0, 0.0});
      CHECK(middle.x == Approx(11.3));
      CHECK(middle.y == Approx(-3.0).margin(0.01));
      CHECK(middle.z == Approx(7.0).margin(0.01));
    }
  }
  for (const Vec3& outside :
       {Vec3(1.3, 0.8, 0.0), Vec3(1.3, 0.0, -0.8), Vec3(-1.0, 0.1, 0.1), Vec3(4.5, 0.1, 0.1)}) {
    CHECK(middleOfMesh(places, tube.triangles, shift + outside, {1.0, 0.0, 0.0}) == shift + outside);
  }
}

TEST_CASE("within two meshes the middle is that of the one that is met first") {
  test::Shape both = test::tube(4.0, 2.0, 8, 64);
  const test::Shape inner = test::tube(4.0, 0.5, 8, 64);
  const auto first = static_cast<std::uint32_t>(both.positions.size());
  for (const glm::vec3& position : inner.positions) {
    both.positions.push_back(position + glm::vec3(0.0F, 1.0F, 0.5F));
  }
  for (const Triangle& triangle : inner.triangles) {
    both.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  }
  const std::vector<Vec3> places = placesOf(both, Vec3(0.0));
  const Vec3 middle = middleOfMesh(places, both.triangles, {2.0, 1.2, 0.3}, {1.0, 0.0, 0.0});
  CHECK(middle.y == Approx(1.0).margin(0.01));
  CHECK(middle.z == Approx(0.5).margin(0.01));
}

TEST_CASE(
    "a bone is as wide as the surface that follows it most, in the pose, and one that none follows has no "
    "width") {
  const test::Shape thick = test::tube(4.0, 0.5, 16, 24);
  const test::Shape thin = test::tube(2.0, 0.25, 16, 24); // half as large in every way
  Scene rigid;
  const NodeIndex first = test::addNode(rigid, "First", NodeIndex::none, {0.0, 0.0, 0.0});
  const NodeIndex second = test::addNode(rigid, "Second", NodeIndex::none, {0.0, 5.0, 0.0});
  const NodeIndex third = test::addNode(rigid, "Third", NodeIndex::none, {0.0, 9.0, 0.0});
  rigid.nodes[at(first)].mesh = addMesh(rigid, thick, glm::vec3(0.0F));
  rigid.nodes[at(second)].mesh = addMesh(rigid, thin, glm::vec3(0.0F));
  rigid.nodes[at(third)].mesh = addMesh(rigid, thick, glm::vec3(0.0F));
  const std::vector<double> widths = widthsIn(rigid, {0, 1, -1}, 3);
  REQUIRE(widths.size() == 3);
  CHECK(widths[0] > 0.7);
  CHECK(widths[0] < 1.2);
  CHECK(widths[1] == Approx(0.5 * widths[0]).epsilon(0.01));
  CHECK(widths[2] == 0.0);
  rigid.nodes[at(second)].rest.scale = Vec3(6.0);
  CHECK(widthsIn(rigid, {0, 1, -1}, 2)[1] == Approx(3.0 * widths[0]).epsilon(0.01));
  CHECK(widthsIn(rigid, {1, 0, -1}, 2)[1] == Approx(widths[0]));
  Scene skinned;
  const NodeIndex left = test::addNode(skinned, "Left", NodeIndex::none, {0.0, 0.0, 0.0});
  const NodeIndex right = test::addNode(skinned, "Right", NodeIndex::none, {0.0, 0.0, 0.0});
  Skin skin;
  skin.joints = {left, right};
  skin.inverseBind = {Mat4(1.0), Mat4(1.0)};
  skinned.skins.push_back(skin);
  for (const int joint : {0, 1}) {
    const NodeIndex node = test::addNode(skinned, "Mesh", NodeIndex::none, {0.0, 0.0, 0.0});
    skinned.nodes[at(node)].mesh = addMesh(skinned, joint == 0 ? thick : thin,
                                           glm::vec3(0.0F, 5.0F * static_cast<float>(joint), 0.0F), joint);
    skinned.nodes[at(node)].skin = 0;
  }
  const std::vector<double> following = widthsIn(skinned, {0, 1, -1, -1}, 2);
  CHECK(following[0] == Approx(widths[0]).epsilon(0.01));
  CHECK(following[1] == Approx(0.5 * widths[0]).epsilon(0.01));
}
