#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "core/math/rotation.h"
#include "skinning/long_edges.h"
#include "skinning/surface_part.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::test;
using skinning::LongEdges;
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

const std::vector<bool> followsTip{false, true, false};
const Transform rest{Vec3(2.0, 0.0, 0.0), Quat(1, 0, 0, 0), Vec3(1.0)}; // of the tip

// Poses of the tip, one in four of them wild.
class AnyPose {
public:
  Transform next() {
    const double wild = ++count_ % 4 == 0 ? 4.0 : 0.5;
    return {Vec3(2.0, 0.0, 0.0) + wild * Vec3(any(), any(), any()),
            axisAngle(glm::normalize(Vec3(any(), any(), 1.1)), 3.0 * any()),
            Vec3(1.0 + 0.9 * any(), 1.0, 1.0 + wild * std::abs(any()))};
  }
  double any() { return any_(random_); }

private:
  int count_ = 0;
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> any_{-1.0, 1.0};
};

// Places of all vertices, worked out one by one.
std::vector<glm::vec3> placesIn(const SurfacePart& part, const FrameState& frame) {
  std::vector<glm::vec3> all;
  part.positions(frame, all);
  return all;
}

// The slow way: the lowest of all that are moved.
glm::vec3 lowestOf(const SurfacePart& part, const FrameState& frame) {
  std::vector<glm::vec3> all = placesIn(part, frame);
  all.resize(part.movedCount());
  return *std::ranges::min_element(all, {}, &glm::vec3::y);
}

} // namespace

TEST_CASE("The whole surface is all of its vertices without edges, and each has its place among all") {
  const Scene scene = strip();
  const SurfacePart part(scene, followsTip);
  const SurfacePart whole = SurfacePart::whole(scene);
  CHECK(whole.edges().empty());
  CHECK(whole.movedCount() == 18);
  REQUIRE(part.movedCount() > 0);
  REQUIRE(part.movedCount() < 18);
  CHECK(whole.slots().size() == 2);
  CHECK(part.slots().size() == 2); // the still neighbours follow one of them
  const FrameState frame = posed(scene, {Vec3(2.0, 0.3, 0.0), axisAngle(Vec3(0, 0, 1), 0.7), Vec3(1.2)});
  const std::vector<glm::vec3> all = placesIn(part, frame);
  for (std::size_t vertex = 0; vertex < all.size(); ++vertex) {
    CHECK(part.place(vertex, part.posed(frame)) == all[vertex]);
  }
}

TEST_CASE("The lowest vertex is that of all, and none where all are above the limit") {
  const Scene scene = strip(GENERATE(1.0F, 0.5F, 3.0F));
  const SurfacePart part(scene, followsTip);
  const SurfacePart whole = SurfacePart::whole(scene);
  AnyPose poses;
  int below = 0;
  for (int i = 0; i < 200; ++i) {
    const FrameState frame = posed(scene, poses.next());
    CHECK(*whole.lowest(whole.posed(frame)) == Vec3(lowestOf(whole, frame)));
    const glm::vec3 lowest = lowestOf(part, frame);
    const SurfacePart::Posed pose = part.posed(frame);
    CHECK(*part.lowest(pose) == Vec3(lowest));
    const double limit = poses.any();
    const bool isBelow = static_cast<double>(lowest.y) < limit;
    below += isBelow ? 1 : 0;
    CHECK(part.lowest(pose, limit).has_value() == isBelow);
    CHECK((!isBelow || *part.lowest(pose, limit) == Vec3(lowest)));
    CHECK_FALSE(part.lowest(pose, static_cast<double>(lowest.y)));
  }
  CHECK(below > 30);
  CHECK(below < 170);
  const SurfacePart nothing(scene, {false, false, false});
  CHECK_FALSE(nothing.lowest(nothing.posed(posed(scene, rest))));
}

TEST_CASE("Of several vertices that are as low the first is the lowest") {
  const Scene scene = strip();
  const SurfacePart whole = SurfacePart::whole(scene);
  const FrameState frame = posed(scene, rest);
  CHECK(*whole.lowest(whole.posed(frame)) == Vec3(placesIn(whole, frame).front()));
}

TEST_CASE("Joints rule out most edges of a part, and never one that is long") {
  constexpr double seen = 0.3; // shorter than the short sides of the strip
  const float weight = GENERATE(1.0F, 0.5F, 3.0F);
  const Scene scene = strip(weight);
  const SurfacePart part(scene, followsTip);
  const FrameState bind = posed(scene, rest);
  const LongEdges edges(part, bind, seen);
  REQUIRE(edges.lengths().size() == part.edges().size());
  const std::vector<glm::vec3> inBind = placesIn(part, bind);
  AnyPose poses;
  int longOnes = 0;
  for (int i = 0; i < 400; ++i) {
    const FrameState frame = posed(scene, poses.next());
    const double times = 1.5 + 9.0 * std::pow(std::abs(poses.any()), 3.0);
    const std::vector<std::uint32_t> told = edges.among(part, part.posed(frame), times);
    const std::vector<glm::vec3> all = placesIn(part, frame);
    for (std::uint32_t edge = 0; edge < edges.lengths().size(); ++edge) {
      const auto [moved, other] = part.edges()[edge];
      CHECK(edges.lengths()[edge] ==
            Approx(static_cast<double>(glm::distance(inBind[moved], inBind[other]))));
      const auto length = static_cast<double>(glm::distance(all[moved], all[other]));
      if (length > seen && length > times * edges.lengths()[edge]) {
        ++longOnes;
        CHECK(std::ranges::find(told, edge) != told.end());
      }
    }
  }
  CHECK(longOnes > 100);
  CHECK((weight != 1.0F || edges.among(part, part.posed(bind), 1.5).empty()));
  CHECK((weight == 1.0F || edges.among(part, part.posed(bind), 1.5).size() == part.edges().size()));
}

TEST_CASE("No moved vertex is farther from its place than its joints allow, and the bound is near it") {
  const float weight = GENERATE(1.0F, 0.5F, 3.0F);
  const Scene scene = strip(weight);
  const SurfacePart part(scene, followsTip);
  const FrameState bind = posed(scene, rest);
  for (const Transform& tip : {Transform{Vec3(2.0, 0.3, 0.0), Quat(1, 0, 0, 0), Vec3(1.0)},
                               Transform{Vec3(2.0, 0.0, 0.0), axisAngle(Vec3(0, 0, 1), 1.5), Vec3(1.0)},
                               Transform{Vec3(2.0, 0.0, 0.0), Quat(1, 0, 0, 0), Vec3(3.0, 1.0, 1.0)},
                               Transform{Vec3(2.5, 1.0, 0.0), axisAngle(Vec3(0, 1, 0), -2.0), Vec3(0.5)}}) {
    const FrameState frame = posed(scene, tip);
    const std::vector<glm::vec3> before = placesIn(part, bind);
    const std::vector<glm::vec3> after = placesIn(part, frame);
    const auto moves = part.farthestMoves(part.posed(bind), part.posed(frame));
    REQUIRE(moves.size() == part.slots().size());
    CHECK(std::ranges::is_sorted(moves, std::greater()));
    double farthest = 0.0;
    for (const auto& [bound, slot] : moves) {
      for (const std::uint32_t vertex : part.followersOf(slot)) {
        farthest = std::max(farthest, static_cast<double>(glm::distance(before[vertex], after[vertex])));
      }
      CHECK(farthest <= moves.front().first);
    }
    REQUIRE(farthest > 0.0);
    CHECK((weight != 1.0F || moves.front().first < 2.5 * farthest));
    CHECK((weight == 1.0F || std::isinf(moves.front().first)));
  }
}
