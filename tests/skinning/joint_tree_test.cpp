#include <catch2/catch.hpp>

#include <glm/gtc/quaternion.hpp>

#include "skinning/fit/joint_tree.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// A bone that hangs on another, or on none.
SkinBone boneAt(const Vec3& pivot, int parent) {
  SkinBone bone;
  bone.pivot = pivot;
  bone.parent = parent;
  return bone;
}

/// A strip along x whose bones each hold two columns, blended in between; bone b turns about z at each of
/// `hinges` against the bone before it, by `degrees` in each frame.
SkinnedSequence hinged(const std::vector<Vec3>& hinges, const std::vector<double>& degrees) {
  SkinnedSequence skinned;
  const std::size_t bones = hinges.size() + 1;
  skinned.bones.resize(bones);
  for (std::size_t b = 0; b < bones; ++b) {
    const auto x = static_cast<float>(2 * b);
    for (const float y : {-0.1F, 0.1F}) {
      const auto own = static_cast<std::uint16_t>(b);
      skinned.bindPositions.emplace_back(x, y, 0.0F);
      skinned.influences.push_back({{own}, {1.0F}});
      if (b + 1 < bones) {
        skinned.bindPositions.emplace_back(x + 1.0F, y, 0.0F);
        skinned.influences.push_back({{own, static_cast<std::uint16_t>(b + 1)}, {0.5F, 0.5F}});
      }
    }
  }
  for (const double angle : degrees) {
    Vec3 place(0.0);
    Quat turned(1.0, 0.0, 0.0, 0.0);
    for (std::size_t b = 0; b < bones; ++b) {
      if (b > 0) {
        const Vec3 hinge = place + turned * hinges[b - 1];
        turned = turned * glm::angleAxis(angle * pi / 180.0, Vec3(0.0, 0.0, 1.0));
        place = hinge - turned * hinges[b - 1];
      }
      skinned.poses.push_back({place, turned, Vec3(1.0), Quat(1.0, 0.0, 0.0, 0.0)});
    }
  }
  return skinned;
}

} // namespace

TEST_CASE("bones hang together at the hinges that they turn about, in whichever frames they turn") {
  const std::vector<Vec3> hinges{Vec3(1.2, 0.3, 0.0), Vec3(2.9, -0.2, 0.0), Vec3(5.1, 0.1, 0.0),
                                 Vec3(7.0, 0.4, 0.0)};
  const auto degrees = GENERATE(std::vector{70.0, 0.0, 0.0}, std::vector{0.0, 70.0, 0.0},
                                std::vector{0.0, 0.0, -70.0}, std::vector{20.0, -30.0, 50.0});
  SkinnedSequence skinned = hinged(hinges, degrees);
  const MeshSequence before = skinAllFrames(skinned);
  hangTogether(skinned);
  CHECK(skinned.bones[2].parent == -1); // as many joints to one end as to the other
  CHECK(skinned.bones[1].parent == 2);
  CHECK(skinned.bones[0].parent == 1);
  CHECK(skinned.bones[3].parent == 2);
  CHECK(skinned.bones[4].parent == 3);
  const std::vector<Vec3> places{hinges[0], hinges[1], Vec3(4.0, 0.0, 0.0), hinges[2], hinges[3]};
  for (const std::size_t bone : {0, 1, 2, 3, 4}) {
    CAPTURE(bone);
    CHECK(glm::distance(skinned.bones[bone].pivot, places[bone]) < 0.02);
  }
  CHECK(glm::distance(skinned.bones[1].end, skinned.bones[0].pivot) < 1e-9);
  CHECK(glm::distance(skinned.bones[2].end, 0.5 * (skinned.bones[1].pivot + skinned.bones[3].pivot)) < 1e-9);
  // A bone at the end reaches as far beyond its middle as it begins before it: half of two columns follows it
  // more.
  const double middle = (2.0 * 8.0 + 0.5 * 2.0 * 7.0) / 3.0;
  CHECK(skinned.bones[4].end.x == Approx(2.0 * middle - skinned.bones[4].pivot.x));
  const MeshSequence after = skinAllFrames(skinned);
  for (std::size_t i = 0; i < before.positions.size(); ++i) {
    CHECK(glm::distance(Vec3(before.positions[i]), Vec3(after.positions[i])) < 1e-5);
  }
}

TEST_CASE("bones that share no surface stand side by side") {
  SkinnedSequence skinned = hinged({Vec3(1.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0)}, {0.0, 30.0});
  for (Influences& influences : skinned.influences) {
    if (influences.bones[1] == 2) {
      influences = {{2}, {1.0F}};
    }
  }
  hangTogether(skinned);
  CHECK((skinned.bones[0].parent == 1) != (skinned.bones[1].parent == 0));
  CHECK(skinned.bones[2].parent == -1);
}

TEST_CASE("the order of a tree has parents first, and each bone once") {
  const std::vector<SkinBone> bones{boneAt(Vec3(0.0), 3), boneAt(Vec3(1.0), -1), boneAt(Vec3(2.0), 0),
                                    boneAt(Vec3(4.0), 1), boneAt(Vec3(5.0), -1), boneAt(Vec3(6.0), 3)};
  CHECK(orderOfTree(bones) == std::vector<std::size_t>{1, 4, 3, 0, 5, 2});
  const auto middles = middlesOfChildren(bones);
  REQUIRE(middles.size() == 6);
  CHECK(middles[0] == Vec3(2.0));
  CHECK(middles[1] == Vec3(4.0));
  CHECK(middles[3] == Vec3(3.0)); // between 0 and 6
  for (const std::size_t tip : {2, 4, 5}) {
    CHECK_FALSE(middles[tip]);
  }
}
