// Which joints of a skeleton follow which of another one.
#include "rig/retarget/joint_pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/rig/boxed_biped.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const JointPair* pairOf(const JointPairs& pairs, NodeIndex joint) {
  const auto found = std::ranges::find(pairs.pairs, joint, &JointPair::joint);
  return found == pairs.pairs.end() ? nullptr : &*found;
}

} // namespace

TEST_CASE("Hips follow hips, and so does what carries legs and trunk where that is another joint") {
  const MovingBiped from = still(namedBody());
  const MovingBiped onto = still(namedBody());
  const Skeleton source = skeletonOf(from);
  Skeleton apart = skeletonOf(onto);
  apart.carrier = onto.scene.nodes[at(apart.hips)].parent;
  REQUIRE(apart.carrier.exists());
  const JointPairs pairs = pairJoints(source, apart);
  for (const NodeIndex joint : {apart.hips, apart.carrier}) {
    const JointPair* const pair = pairOf(pairs, joint);
    REQUIRE(pair != nullptr);
    CHECK(pair->from == source.hips);
    CHECK(pair->share == 0.0);
  }
}

TEST_CASE("A spine of another number of joints is followed at its shares of the way, a joint at most once") {
  for (int fromCount = 1; fromCount <= 5; ++fromCount) {
    for (int ontoCount = 1; ontoCount <= 5; ++ontoCount) {
      CAPTURE(fromCount, ontoCount);
      const MovingBiped from = still(namedBody({.spineJoints = fromCount}));
      const MovingBiped onto = still(namedBody({.spineJoints = ontoCount}));
      const Skeleton source = skeletonOf(from);
      const Skeleton own = skeletonOf(onto);
      const JointPairs pairs = pairJoints(source, own);
      std::set<NodeIndex> joints;
      for (const JointPair& pair : pairs.pairs) {
        CHECK(joints.insert(pair.joint).second);
        CHECK(pair.share >= 0.0);
        CHECK(pair.share < 1.0);
      }
      std::vector<NodeIndex> row{source.hips};
      row.insert(row.end(), source.spine.begin(), source.spine.end());
      for (std::size_t i = 0; i < own.spine.size(); ++i) {
        const JointPair* const pair = pairOf(pairs, own.spine[i]);
        REQUIRE(pair != nullptr);
        const auto lower = static_cast<double>(std::ranges::find(row, pair->from) - row.begin());
        const double wanted =
            static_cast<double>((i + 1) * (row.size() - 1)) / static_cast<double>(own.spine.size());
        CHECK(lower + pair->share == Approx(wanted).margin(1e-9));
        const std::size_t next = std::min(row.size() - 1, static_cast<std::size_t>(lower) + 1);
        CHECK(pair->towards == row[next]);
      }
    }
  }
}

TEST_CASE("An arm of two bones follows one of a single bone with both, and one of a single bone its first") {
  const MovingBiped moving = still(namedBody());
  const Skeleton whole = skeletonOf(moving);
  Skeleton single = whole;
  REQUIRE(whole.arms[leftSide]->limb.joints.size() == 2);
  single.arms[leftSide]->limb.joints.pop_back();
  const std::vector<NodeIndex>& joints = whole.arms[leftSide]->limb.joints;
  const JointPairs both = pairJoints(single, whole);
  for (const NodeIndex joint : joints) {
    REQUIRE(pairOf(both, joint) != nullptr);
    CHECK(pairOf(both, joint)->from == joints.front());
  }
  const JointPairs first = pairJoints(whole, single);
  REQUIRE(pairOf(first, joints.front()) != nullptr);
  CHECK(pairOf(first, joints.front())->from == joints.front());
  CHECK(pairOf(first, joints.back()) == nullptr);
}

TEST_CASE("Parts that only the followed body has are told, each once, and none that only the other one has") {
  const MovingBiped from = still(namedBody());
  const MovingBiped onto = still(namedBody());
  Skeleton source = skeletonOf(from);
  Skeleton own = skeletonOf(onto);
  const auto left = [&] { return pairJoints(source, own).left; };
  using Parts = std::vector<std::string>;
  CHECK(left().empty());
  for (const std::size_t side : {leftSide, rightSide}) {
    REQUIRE((source.arms[side] && own.arms[side]));
    source.arms[side]->fingers = {{"thumb", {source.hips}}, {"ring", {source.hips}}};
    own.arms[side]->fingers = {{"index", {own.hips}}};
  }
  CHECK(left() == Parts{"the ring finger", "the thumb"});
  own.arms[leftSide]->fingers.clear();
  own.arms[rightSide]->fingers.clear();
  CHECK(left() == Parts{"fingers"});
  own.arms[rightSide]->shoulder = NodeIndex::none;
  CHECK(left() == Parts{"fingers", "shoulders"});
  own.arms[leftSide].reset();
  CHECK(left() == Parts{"the left arm", "shoulders", "fingers"});
  source.arms[rightSide].reset();
  CHECK(left() == Parts{"the left arm"});
  std::swap(source.arms[leftSide], source.arms[rightSide]);
  own.arms.fill(std::nullopt);
  CHECK(left() == Parts{"the right arm"});
  own.head = NodeIndex::none;
  own.legs[rightSide].toes = NodeIndex::none;
  CHECK(left() == Parts{"the head", "the right arm", "toes"});
}
