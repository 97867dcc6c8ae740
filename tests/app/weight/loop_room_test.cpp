// What a clip that loops has before its first sample and after its last one.
#include "app/weight/loop.h"

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A loop has a turn before its samples and a fifth of a second after them, no more than a turn") {
  const LoopRoom usual = loopRoom(true, 11, 12.0);
  CHECK(usual.before == 10);
  CHECK(usual.after == 3); // 2.4 samples
  const LoopRoom quick = loopRoom(true, 11, 120.0);
  CHECK(quick.before == 10);
  CHECK(quick.after == 10);
  for (const LoopRoom& none : {loopRoom(false, 11, 12.0), loopRoom(true, 2, 12.0), loopRoom(true, 1, 12.0)}) {
    CHECK(none.before == 0);
    CHECK(none.after == 0);
  }
}

TEST_CASE("What a loop shows comes from its own end and goes on with its own beginning") {
  std::vector<char> turn{'a', 'b', 'c', 'd', 'a'}; // the last shows the first again
  wrapList(turn, loopRoom(true, turn.size(), 6.0));
  CHECK(turn == std::vector<char>{'a', 'b', 'c', 'd', 'a', 'b', 'c', 'd', 'a', 'b', 'c'});
  std::vector<char> once{'a', 'b', 'c'};
  wrapList(once, {});
  CHECK(once == std::vector<char>{'a', 'b', 'c'});
}

TEST_CASE("A limb on a loop that travels goes on at an even pace, whatever turn it is in") {
  const Vec3 onBase(0.0, 0.5, 0.25);
  std::vector<std::vector<Vec3>> joints;
  for (int sample = 0; sample < 5; ++sample) {
    const Vec3 base(2.0 * sample, 1.0, -1.0 * sample);
    joints.push_back({base, base + onBase});
  }
  std::vector<std::vector<Vec3>> once = joints;
  wrapJoints(joints, loopRoom(true, 5, 10.0));
  REQUIRE(joints.size() == 4 + 5 + 2);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    CAPTURE(k);
    const double sample = static_cast<double>(k) - 4.0;
    const Vec3 base(2.0 * sample, 1.0, -sample);
    CHECK(joints[k] == std::vector<Vec3>{base, base + onBase});
  }
  const std::vector<std::vector<Vec3>> wanted = once;
  wrapJoints(once, {});
  CHECK(once == wanted);
}
