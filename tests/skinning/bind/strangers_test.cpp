// What vertices follow of bones that are no relatives of their own: all relations of joints, and shares by
// how far bones are from each other along the skeleton.
#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

#include "skinning/bind/strange_patches.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// 0 is the root, with children 1 and 2; 3 and 4 are those of 1, 5 is that of 2, 6 that of 3, 7 that of 6;
/// 8 is a root of its own.
const std::vector<BindJoint> family{{Vec3(0, 0, 0), -1}, {Vec3(1, 0, 0), 0}, {Vec3(-1, 0, 0), 0},
                                    {Vec3(2, 0, 0), 1},  {Vec3(1, 1, 0), 1}, {Vec3(-2, 0, 0), 2},
                                    {Vec3(3, 0, 0), 3},  {Vec3(4, 0, 0), 6}, {Vec3(0, 5, 0), -1}};

Influences followsAlone(std::size_t joint) {
  Influences row;
  row.bones[0] = static_cast<std::uint16_t>(joint);
  row.weights[0] = 1.0F;
  return row;
}

std::vector<int> joints(const std::vector<Influences>& weights) {
  std::vector<int> found;
  found.reserve(weights.size());
  for (const Influences& row : weights) {
    found.push_back(row.bones[0]);
  }
  return found;
}

/// A fan of six vertices around vertex 0, or as many strips side by side as it takes.
std::vector<Triangle> fan() {
  std::vector<Triangle> triangles;
  for (std::uint32_t v = 1; v <= 6; ++v) {
    triangles.push_back({0, v, v % 6 + 1});
  }
  return triangles;
}

std::vector<std::uint32_t> unwelded(std::size_t count) {
  std::vector<std::uint32_t> welded(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    welded[v] = v;
  }
  return welded;
}

/// The distance of two joints in generations: up to the one that both descend from, and down again.
std::pair<int, int> generationsOf(int a, int b) {
  std::map<int, int> above;
  int up = 0;
  for (int joint = a; joint >= 0; joint = family[static_cast<std::size_t>(joint)].parent) {
    above[joint] = up++;
  }
  int down = 0;
  for (int joint = b; joint >= 0; joint = family[static_cast<std::size_t>(joint)].parent, ++down) {
    if (above.contains(joint)) {
      return {above[joint], down};
    }
  }
  return {99, 99};
}

} // namespace

TEST_CASE(
    "A patch keeps its joint among parents, grandparents, siblings and children, among others it does not") {
  const auto count = static_cast<int>(family.size());
  for (int inner = 0; inner < count; ++inner) {
    for (int outer = 0; outer < count; ++outer) {
      const auto [up, down] = generationsOf(inner, outer);
      const bool areRelatives = (up == 0 && down <= 2) || (down == 0 && up <= 2) || (up == 1 && down == 1);
      std::vector<Influences> weights(7, followsAlone(static_cast<std::size_t>(outer)));
      weights[0] = followsAlone(static_cast<std::size_t>(inner));
      takeInPatches(fan(), unwelded(7), family, weights);
      CAPTURE(inner, outer);
      CHECK(joints(weights) ==
            std::vector<int>{areRelatives ? inner : outer, outer, outer, outer, outer, outer, outer});
    }
  }
}

TEST_CASE("One relative among its neighbours is enough for a patch to keep its joint") {
  std::vector<Influences> weights(7, followsAlone(8));
  weights[0] = followsAlone(3);
  weights[4] = followsAlone(1);
  takeInPatches(fan(), unwelded(7), family, weights);
  CHECK(joints(weights)[0] == 3);
}

TEST_CASE(
    "A mesh that follows one joint all over keeps it, and so does one of two pieces that do not touch") {
  std::vector<Influences> weights(7, followsAlone(5));
  takeInPatches(fan(), unwelded(7), family, weights);
  CHECK(joints(weights) == std::vector<int>(7, 5));
  std::vector<Influences> two{followsAlone(3), followsAlone(3), followsAlone(3),
                              followsAlone(8), followsAlone(8), followsAlone(8)};
  takeInPatches({{0, 1, 2}, {3, 4, 5}}, unwelded(6), family, two);
  CHECK(joints(two) == std::vector<int>{3, 3, 3, 8, 8, 8});
}

TEST_CASE("A large patch is filled from its border inwards, with the mean of what lies around each vertex") {
  // A row of eleven squares, those in the middle follow a stranger: a patch smaller than those beside it.
  std::vector<Triangle> row;
  for (std::uint32_t i = 0; i < 11; ++i) {
    const std::uint32_t a = 2 * i;
    row.push_back({a, a + 1, a + 2});
    row.push_back({a + 1, a + 3, a + 2});
  }
  std::vector<Influences> weights;
  for (std::size_t v = 0; v < 24; ++v) {
    weights.push_back(followsAlone(v < 8 ? 1 : v < 14 ? 8 : 3));
  }
  takeInPatches(row, unwelded(24), family, weights);
  for (std::size_t v = 0; v < 24; ++v) {
    CAPTURE(v);
    CHECK(weights[v].bones[0] == (v < 11 ? 1 : 3)); // each half from its side
    float sum = 0.0F;
    for (const float weight : weights[v].weights) {
      sum += weight;
    }
    CHECK(sum == Approx(1.0F));
  }
}

TEST_CASE("A corner of a single triangle gets the mean of what both others follow") {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    std::vector<Influences> weights(3, followsAlone(1));
    weights[(corner + 1) % 3] = followsAlone(3);
    weights[corner] = followsAlone(8);
    takeInPatches({{0, 1, 2}}, unwelded(3), family, weights);
    CAPTURE(corner);
    CHECK(weights[corner].bones[0] == 1);
    CHECK(weights[corner].bones[1] == 3);
    CHECK(weights[corner].weights[0] == Approx(0.5F));
    CHECK(weights[corner].weights[1] == Approx(0.5F));
  }
}

TEST_CASE("Vertices at one place have what the first of them has, where a patch is taken in") {
  std::vector<Triangle> triangles = fan();
  triangles.push_back({7, 1, 2}); // 7 lies where 0 does
  std::vector<std::uint32_t> welded = unwelded(8);
  welded[7] = 0;
  std::vector<Influences> weights(8, followsAlone(8));
  weights[0] = followsAlone(3);
  weights[7] = followsAlone(3);
  takeInPatches(triangles, welded, family, weights);
  CHECK(joints(weights) == std::vector<int>(8, 8));
}

TEST_CASE("A vertex follows other bones by their kinship with its own, the rest is given out again") {
  const std::vector<BoneLine> lines =
      boneLines(family, [](const Vec3& place, const Vec3& along) { return place + 0.5 * along; });
  const SkeletonWays ways(family, lines);
  const auto linesOf = [&](std::size_t joint) {
    std::vector<std::size_t> found;
    for (std::size_t line = 0; line < lines.size(); ++line) {
      if (lines[line].joint == joint) {
        found.push_back(line);
      }
    }
    return found;
  };
  std::vector<glm::vec3> places;
  std::vector<Influences> weights;
  for (int i = 0; i < 40; ++i) {
    const auto number = static_cast<float>(i);
    places.emplace_back(-2.5F + 0.17F * number, 0.3F + 0.01F * number, 0.1F * static_cast<float>(i % 5));
    Influences row;
    row.bones = {static_cast<std::uint16_t>(i % 8), static_cast<std::uint16_t>((i + 2) % 8),
                 static_cast<std::uint16_t>((i + 5) % 8)};
    row.weights = {0.5F, 0.3F, 0.2F};
    weights.push_back(row);
  }
  weights[7] = followsAlone(4);
  const std::vector<Influences> before = weights;
  dropStrangers(places, lines, ways, weights);
  for (std::size_t v = 0; v < places.size(); ++v) {
    std::map<int, double> wanted;
    double sum = 0.0;
    const auto [own, toOwn] = nearestOnBones(lines, linesOf(before[v].bones[0]), Vec3(places[v]));
    for (std::size_t i = 0; i < 3 && before[v].weights[i] > 0.0F; ++i) {
      const auto [other, toOther] = nearestOnBones(lines, linesOf(before[v].bones[i]), Vec3(places[v]));
      const double kin = i == 0 ? 1.0 : ways.kinship(own, other, toOwn + toOther);
      wanted[before[v].bones[i]] = static_cast<double>(before[v].weights[i]) * kin;
      sum += wanted[before[v].bones[i]];
    }
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      CAPTURE(v, i);
      if (weights[v].weights[i] > 0.0F) {
        CHECK(static_cast<double>(weights[v].weights[i]) ==
              Approx(wanted[weights[v].bones[i]] / sum).margin(1e-6));
        wanted.erase(weights[v].bones[i]);
      }
    }
    CHECK(std::ranges::all_of(wanted, [](const auto& left) { return left.second < 1e-9; }));
  }
}
