#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "core/math/rotation.h"
#include "skinning/surface_part.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::test;
using skinning::SurfacePart;

namespace {

// A strip along x, its left half on one joint, its right half on a child, blended between; weights of a
// vertex add up to `weight`.
Scene strip(float weight = 1.0F) {
  Scene scene;
  const NodeIndex root = addNode(scene, "root", NodeIndex::none, Vec3(0.0));
  const NodeIndex tip = addNode(scene, "tip", root, Vec3(2.0, 0.0, 0.0));
  const NodeIndex mesh = addNode(scene, "mesh", NodeIndex::none, Vec3(0.0));
  Primitive primitive;
  for (std::uint32_t column = 0; column < 9; ++column) {
    for (const float y : {0.0F, 0.5F}) {
      primitive.positions.emplace_back(0.5F * static_cast<float>(column), y, 0.0F);
      const float right = std::clamp(0.5F * static_cast<float>(column) - 1.5F, 0.0F, 1.0F);
      VertexInfluences influences;
      influences.joints = {0, 1};
      influences.weights = {weight * (1.0F - right), weight * right};
      primitive.influences.push_back(influences);
    }
    if (column > 0) {
      const std::uint32_t i = 2 * column;
      primitive.indices.insert(primitive.indices.end(), {i - 2, i, i - 1, i - 1, i, i + 1});
    }
  }
  scene.meshes.push_back({"strip", {primitive}, {}});
  Skin skin;
  skin.joints = {root, tip};
  skin.inverseBind = {Mat4(1.0), glm::inverse(toMatrix({Vec3(2.0, 0.0, 0.0), Quat(1, 0, 0, 0), Vec3(1.0)}))};
  scene.skins.push_back(skin);
  scene.nodes[at(mesh)].mesh = 0;
  scene.nodes[at(mesh)].skin = 0;
  return scene;
}

FrameState posed(const Scene& scene, const Transform& tip) {
  Pose pose = restPose(scene);
  pose.locals[1] = tip;
  return frameOf(scene, pose, 0.0);
}

} // namespace

TEST_CASE("places of the moved vertices and of their still neighbours are those of the whole part") {
  const Scene scene = strip();
  const SurfacePart part(scene, {false, true, false});
  const FrameState frame = posed(scene, {Vec3(2.0, 0.3, 0.0), axisAngle(Vec3(0, 0, 1), 0.7), Vec3(1.2)});
  std::vector<glm::vec3> all;
  std::vector<glm::vec3> parted;
  part.positions(frame, all);
  part.movedPositions(frame, parted);
  REQUIRE(part.movedCount() > 0);
  REQUIRE(parted.size() == all.size());
  REQUIRE(part.movedCount() < all.size());
  CHECK(parted.back() != all.back());
  part.stillPositions(frame, parted);
  CHECK(parted == all);
}

TEST_CASE("no moved vertex is farther from its place than its joints allow, and the bound is near it") {
  const float weight = GENERATE(1.0F, 0.5F, 3.0F);
  const Scene scene = strip(weight);
  const SurfacePart part(scene, {false, true, false});
  const FrameState rest = posed(scene, {Vec3(2.0, 0.0, 0.0), Quat(1, 0, 0, 0), Vec3(1.0)});
  CHECK(part.farthestMove(rest, rest) == 0.0);
  for (const Transform& tip : {Transform{Vec3(2.0, 0.3, 0.0), Quat(1, 0, 0, 0), Vec3(1.0)},
                               Transform{Vec3(2.0, 0.0, 0.0), axisAngle(Vec3(0, 0, 1), 1.5), Vec3(1.0)},
                               Transform{Vec3(2.0, 0.0, 0.0), Quat(1, 0, 0, 0), Vec3(3.0, 1.0, 1.0)},
                               Transform{Vec3(2.5, 1.0, 0.0), axisAngle(Vec3(0, 1, 0), -2.0), Vec3(0.5)}}) {
    const FrameState frame = posed(scene, tip);
    std::vector<glm::vec3> before;
    std::vector<glm::vec3> after;
    part.positions(rest, before);
    part.positions(frame, after);
    double farthest = 0.0;
    for (std::size_t i = 0; i < part.movedCount(); ++i) {
      farthest = std::max(farthest, static_cast<double>(glm::distance(before[i], after[i])));
    }
    const double bound = part.farthestMove(rest, frame);
    CAPTURE(farthest, bound);
    CHECK(farthest <= bound + 1e-5);
    CHECK(bound * std::min(1.0, static_cast<double>(weight)) < 2.5 * farthest); // weights that miss something
                                                                                // count as 1
  }
}
