// Ways along a skeleton, and pieces of a mesh that move as one.
#include <catch2/catch.hpp>

#include "skinning/bind/skeleton_ways.h"
#include "skinning/bind/stiff_shells.h"
#include "skinning/bind/strange_patches.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// Hips at the origin with a leg to either side: a thigh 1 across and a shin 4 down, and a second root far
/// away.
const std::vector<BindJoint> legs{
    {Vec3(0.0), -1},           {Vec3(1.0, 0.0, 0.0), 0},   {Vec3(1.0, -4.0, 0.0), 1},
    {Vec3(-1.0, 0.0, 0.0), 0}, {Vec3(-1.0, -4.0, 0.0), 3}, {Vec3(0.0, 10.0, 0.0), -1}};

std::vector<BoneLine> linesOf(const std::vector<BindJoint>& joints) {
  return boneLines(joints, [](const Vec3& place, const Vec3& along) { return place + 0.5 * along; });
}

std::size_t lineBetween(const std::vector<BoneLine>& lines, int from, int to) {
  const auto found = std::ranges::find_if(
      lines, [&](const BoneLine& line) { return line.joint == from && line.endJoint == to; });
  REQUIRE(found != lines.end());
  return static_cast<std::size_t>(found - lines.begin());
}

Influences only(int joint) {
  Influences row;
  row.bones[0] = static_cast<std::uint16_t>(joint);
  row.weights[0] = 1.0F;
  return row;
}

} // namespace

TEST_CASE(
    "The nearest point of a bone lies between its ends, and the nearest bone is that of the shortest way") {
  const BoneLine line{0, Vec3(1.0, 0.0, 0.0), Vec3(5.0, 0.0, 0.0)};
  CHECK(nearestAlong(line, Vec3(2.0, 7.0, 0.0)) == Approx(0.25));
  CHECK(nearestAlong(line, Vec3(-3.0, 1.0, 0.0)) == 0.0);
  CHECK(nearestAlong(line, Vec3(9.0, 1.0, 0.0)) == 1.0);
  CHECK(nearestAlong({0, Vec3(1.0), Vec3(1.0)}, Vec3(5.0)) == 0.0);
  const std::vector<BoneLine> lines{
      line, {1, Vec3(0.0, 3.0, 0.0), Vec3(8.0, 3.0, 0.0)}, {2, Vec3(2.0, 1.0, 0.0), Vec3(2.0, 2.0, 0.0)}};
  const auto [near, distance] = nearestOnBones(lines, {0, 1}, Vec3(2.0, 2.5, 0.0));
  CHECK(near.line == 1);
  CHECK(near.along == Approx(0.25));
  CHECK(distance == Approx(0.5));
  const auto [first, far] = nearestOnBones(lines, {0}, Vec3(2.0, 2.5, 0.0));
  CHECK(first.line == 0);
  CHECK(far == Approx(2.5));
  CHECK(nearestOnBones(lines, {0, 1, 2}, Vec3(2.0, 1.9, 0.0)).first.line == 2);
}

TEST_CASE("The way between two places of a skeleton runs along its bones, by the joint that they share") {
  const std::vector<BoneLine> lines = linesOf(legs);
  const SkeletonWays ways(legs, lines);
  const std::size_t left = lineBetween(lines, 1, 2);
  const std::size_t right = lineBetween(lines, 3, 4);
  const std::size_t thigh = lineBetween(lines, 0, 1);
  CHECK(ways.between({left, 0.25}, {left, 0.75}) == Approx(2.0));
  CHECK(ways.between({left, 0.25}, {right, 0.75}) == Approx(1.0 + 2.0 + 3.0));
  CHECK(ways.between({right, 0.75}, {left, 0.25}) == Approx(6.0));
  CHECK(ways.between({thigh, 0.5}, {left, 0.5}) == Approx(0.5 + 2.0));
  CHECK(ways.between({left, 1.0}, {right, 1.0}) == Approx(10.0));
  // The last bones go on beyond their joints.
  const auto foot = static_cast<std::size_t>(
      std::ranges::find_if(lines, [](const BoneLine& line) { return line.joint == 2; }) - lines.begin());
  CHECK(ways.between({foot, 1.0}, {left, 0.5}) == Approx(2.0 + 2.0));
  // Of two roots the way goes straight from one to the other.
  const auto alone = static_cast<std::size_t>(
      std::ranges::find_if(lines, [](const BoneLine& line) { return line.joint == 5; }) - lines.begin());
  CHECK(ways.between({alone, 0.0}, {thigh, 0.0}) == Approx(10.0));
  CHECK(ways.between({left, 0.5}, {alone, 0.0}) == Approx(2.0 + 1.0 + 10.0));
}

TEST_CASE("Bones are kin while the way along them is at most two and a half times that across, strangers "
          "from four on") {
  const std::vector<BoneLine> lines = linesOf(legs);
  const SkeletonWays ways(legs, lines);
  const OnBone a{lineBetween(lines, 1, 2), 0.25};
  const OnBone b{lineBetween(lines, 3, 4), 0.75}; // 6 along the bones
  CHECK(ways.kinship(a, b, 6.0) == 1.0);
  CHECK(ways.kinship(a, b, 2.4) == 1.0);
  CHECK(ways.kinship(a, b, 6.0 / 3.25) == Approx(0.5));
  CHECK(ways.kinship(a, b, 1.5) == 0.0);
  CHECK(ways.kinship(a, b, 0.0) == 0.0);
  const double third = (4.0 - 6.0 / 2.0) / 1.5; // smoothly between
  CHECK(ways.kinship(a, b, 2.0) == Approx(third * third * (3.0 - 2.0 * third)));
}

TEST_CASE("Pieces of a mesh are what triangles or one place join, counted in the order of their vertices") {
  const std::vector<std::uint32_t> apart{0, 1, 2, 3, 4, 5, 6};
  CHECK(shellsOf(apart, {{0, 1, 2}, {3, 4, 5}}) == std::vector<std::size_t>{0, 0, 0, 1, 1, 1, 2});
  CHECK(shellsOf({0, 1, 2, 2, 4, 5, 6}, {{0, 1, 2}, {3, 4, 5}}) ==
        std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 1});
  CHECK(shellsOf(apart, {{4, 5, 6}, {6, 0, 4}}) == std::vector<std::size_t>{0, 1, 2, 3, 0, 0, 0});
  CHECK(shellsOf({}, {}).empty());
}

TEST_CASE("A patch among strangers gets what its neighbours have, and one among relatives keeps its own") {
  // A strip of vertices 0 to 6, joined each with the next two.
  std::vector<Triangle> strip;
  std::vector<std::uint32_t> welded;
  for (std::uint32_t v = 0; v < 7; ++v) {
    welded.push_back(v);
    if (v + 2 < 7) {
      strip.push_back({v, v + 1, v + 2});
    }
  }
  const auto jointsAfter = [&](int joint) {
    std::vector<Influences> weights(7, only(2));
    weights[3] = only(joint);
    takeInPatches(strip, welded, legs, weights);
    std::vector<int> joints;
    for (const Influences& row : weights) {
      CHECK(row.weights[0] == Approx(1.0));
      joints.push_back(row.bones[0]);
    }
    return joints;
  };
  CHECK(jointsAfter(4) == std::vector<int>(7, 2)); // the other leg's foot
  CHECK(jointsAfter(1)[3] == 1);                   // the own leg's knee
}
