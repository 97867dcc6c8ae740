#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "skinning/bind/bind_weights.h"
#include "skinning/bind/mirrored_weights.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/weight_of.h"

using namespace stretch;
using skinning::BindJoint;
using skinning::Influences;
using test::weightOf;

namespace {

/// A body of cubes that is the same on both sides of x = 0, with vertices in the middle, and its joints.
struct Body {
  skinning::SkinnedSequence mesh = test::armedBody(1);
  std::vector<BindJoint> joints;
  std::vector<std::size_t> otherSide{0, 1, 4, 5, 2, 3}; // of each joint
};

Body body() {
  Body made;
  for (const skinning::SkinBone& bone : made.mesh.bones) {
    made.joints.push_back({bone.pivot, bone.parent});
  }
  return made;
}

/// The largest difference between what a vertex follows and what the one opposite follows on its own side.
double unlikeness(const Body& body, const std::vector<Influences>& weights) {
  const auto keyOf = [](const glm::vec3& p) {
    return std::tuple(std::lround(p.x * 100.0F), std::lround(p.y * 100.0F), std::lround(p.z * 100.0F));
  };
  std::map<std::tuple<long, long, long>, std::size_t> at;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    at[keyOf(body.mesh.bindPositions[v])] = v;
  }
  double most = 0.0;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const glm::vec3& place = body.mesh.bindPositions[v];
    const std::size_t other = at.at(keyOf({-place.x, place.y, place.z}));
    for (std::size_t joint = 0; joint < body.joints.size(); ++joint) {
      most = std::max(
          most, std::abs(weightOf(weights[v], joint) - weightOf(weights[other], body.otherSide[joint])));
    }
  }
  return most;
}

Influences all(std::uint16_t joint) {
  Influences row;
  row.bones[0] = joint;
  row.weights[0] = 1.0F;
  return row;
}

} // namespace

TEST_CASE("A body that is the same on both sides is bound the same on both, its middle to both alike") {
  const Body symmetric = body();
  const auto bound =
      skinning::bindWeights(symmetric.mesh.bindPositions, symmetric.mesh.triangles, symmetric.joints);
  REQUIRE(bound);
  CHECK(unlikeness(symmetric, bound->influences) < 1e-5);
}

TEST_CASE("What a vertex follows on one side is shared with what the other follows on its own") {
  const std::vector<glm::vec3> places{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {2, 3, 0}};
  const std::vector<BindJoint> joints{{Vec3(0, 0, 0), -1}, {Vec3(2, 0, 0), 0}, {Vec3(-2, 0, 0), 0}};
  std::vector<Influences> weights{all(1), all(0), all(1), all(1)};
  skinning::mirrorWeights(places, joints, weights);
  CHECK(weightOf(weights[0], 1) == Approx(0.5)); // its own, and of the other side's trunk the trunk
  CHECK(weightOf(weights[0], 0) == Approx(0.5));
  CHECK(weightOf(weights[1], 2) == Approx(0.5));
  CHECK(weightOf(weights[2], 1) == Approx(0.5)); // in the middle
  CHECK(weightOf(weights[2], 2) == Approx(0.5));
  CHECK(weights[3] == all(1)); // nothing is opposite
}

TEST_CASE("Of a skeleton that is not the same on both sides nothing is shared") {
  const std::vector<glm::vec3> places{{1, 0, 0}, {-1, 0, 0}};
  const auto joints = GENERATE(
      // one hand holds something
      std::vector<BindJoint>{
          {Vec3(0, 0, 0), -1}, {Vec3(2, 0, 0), 0}, {Vec3(-2, 0, 0), 0}, {Vec3(-3, 0, 0), 2}},
      // a row of joints, which is the same forth and back but for what hangs on what
      std::vector<BindJoint>{{Vec3(-1, 0, 0), -1}, {Vec3(0, 0, 0), 0}, {Vec3(1, 0, 0), 1}},
      // a trunk without sides
      std::vector<BindJoint>{{Vec3(0, 0, 0), -1}, {Vec3(0, 1, 0), 0}}, std::vector<BindJoint>{});
  std::vector<Influences> weights{all(1), all(0)};
  skinning::mirrorWeights(places, joints, weights);
  CHECK(weights == std::vector<Influences>{all(1), all(0)});
}

TEST_CASE("The sides of a body lie along whichever axis of its space they do") {
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const auto along = [axis](double way) {
      Vec3 place(0.0);
      place[axis] = way;
      return place;
    };
    const std::vector<glm::vec3> places{glm::vec3(along(1.0)), glm::vec3(along(-1.0))};
    const std::vector<BindJoint> joints{{Vec3(0.0), -1}, {along(2.0), 0}, {along(-2.0), 0}};
    std::vector<Influences> weights{all(1), all(0)};
    skinning::mirrorWeights(places, joints, weights);
    CAPTURE(axis);
    CHECK(weightOf(weights[0], 1) == Approx(0.5));
    CHECK(weightOf(weights[1], 2) == Approx(0.5));
  }
}

TEST_CASE("Of two joints at one place the first goes with the first of the other side") {
  const std::vector<glm::vec3> places{{1, 0, 0}, {-1, 0, 0}};
  const std::vector<BindJoint> joints{
      {Vec3(0, 0, 0), -1}, {Vec3(2, 0, 0), 0}, {Vec3(2, 0, 0), 1}, {Vec3(-2, 0, 0), 0}, {Vec3(-2, 0, 0), 3}};
  std::vector<Influences> weights{all(2), all(3)};
  skinning::mirrorWeights(places, joints, weights);
  CHECK(weightOf(weights[0], 1) == Approx(0.5));
  CHECK(weightOf(weights[0], 2) == Approx(0.5));
  CHECK(weightOf(weights[1], 3) == Approx(0.5));
  CHECK(weightOf(weights[1], 4) == Approx(0.5));
}

TEST_CASE("The sides of a body lie about its own middle, wherever it stands") {
  const std::vector<glm::vec3> places{{8, 0, 0}, {6, 0, 0}, {7, 1, 0}};
  const std::vector<BindJoint> joints{{Vec3(7, 0, 0), -1}, {Vec3(9, 0, 0), 0}, {Vec3(5, 0, 0), 0}};
  std::vector<Influences> weights{all(1), all(0), all(1)};
  skinning::mirrorWeights(places, joints, weights);
  CHECK(weightOf(weights[0], 1) == Approx(0.5));
  CHECK(weightOf(weights[0], 0) == Approx(0.5));
  CHECK(weightOf(weights[1], 2) == Approx(0.5));
  CHECK(weightOf(weights[2], 1) == Approx(0.5));
  CHECK(weightOf(weights[2], 2) == Approx(0.5));
}
