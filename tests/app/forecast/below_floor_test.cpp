// How far below the floor a character gets in a clip, when, and with what.
#include "app/forecast/below_floor.h"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// Two feet whose soles are on the floor.
struct Feet {
  Scene scene;
  NodeIndex left = addFoot("left");
  NodeIndex right = addFoot("right");

private:
  NodeIndex addFoot(const char* name) {
    Primitive foot;
    foot.positions = {{0.0F, 0.2F, 0.0F}, {0.0F, 0.0F, 0.0F}};
    const NodeIndex node = test::addNode(scene, name, NodeIndex::none, Vec3(0.0));
    scene.nodes[at(node)].mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({name, {foot}, {}});
    return node;
  }
};

/// A foot that is so deep at a second, and on the floor from a second before to a second after it.
Track dip(NodeIndex foot, double second, double depth) {
  Track track;
  track.node = foot;
  for (const auto& [seconds, height] :
       {std::pair(second - 1.0, 0.0), {second, -depth}, {second + 1.0, 0.0}}) {
    track.times.push_back(static_cast<float>(seconds));
    for (const double value : {0.0, height, 0.0}) {
      track.values.push_back(static_cast<float>(value));
    }
  }
  return track;
}

/// A clip from second 1 to second 48: the times at which it is looked at are a second apart.
Clip clipOfDips(const std::vector<Track>& tracks) {
  Clip clip;
  for (const Track& track : tracks) {
    clip.tracks.emplace_back(track);
  }
  clip.startSeconds = 1.0;
  clip.endSeconds = 48.0;
  return clip;
}

} // namespace

TEST_CASE("How far a character sinks below the floor is told of the time and the part that are deepest") {
  const Feet feet;
  for (const double second : {1.0, 20.0, 48.0}) {
    CAPTURE(second);
    const BelowFloor below = belowFloor(feet.scene, clipOfDips({dip(feet.left, second, 0.25)}));
    CHECK(below.depth == Approx(0.25));
    CHECK(below.seconds == Approx(second));
    CHECK(below.node == feet.left);
  }
  const BelowFloor both =
      belowFloor(feet.scene, clipOfDips({dip(feet.left, 30.0, 0.125), dip(feet.right, 10.0, 0.5)}));
  CHECK(both.depth == Approx(0.5));
  CHECK(both.seconds == Approx(10.0));
  CHECK(both.node == feet.right);
}

TEST_CASE("What stays on the floor, is above it or is not shown is not below it") {
  const Feet feet;
  for (const double height : {0.0, 0.5}) {
    const BelowFloor none = belowFloor(feet.scene, clipOfDips({dip(feet.left, 20.0, -height)}));
    CHECK(none.depth == 0.0);
    CHECK_FALSE(none.node.exists());
  }
  CHECK(belowFloor(Scene{}, clipOfDips({})).depth == 0.0);
}
