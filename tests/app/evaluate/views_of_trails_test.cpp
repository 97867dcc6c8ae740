// Where a trail is looked at from, in words, and what of it leaves the picture.
#include "app/evaluate/seen.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "core/math/rotation.h"
#include "rig/limb.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The punch, twice as long, judged by a camera of the file that looks down from above: 2 high and 4 wide,
/// the character's front below in its picture, its left to the right.
Document filmedPunch(const Vec3& place) {
  Document document = test::withNewTrail(test::boxer(), {});
  Scene scene = *document.scene;
  const NodeIndex node = test::addNode(scene, "Crane", NodeIndex::none, place);
  scene.nodes[at(node)].rest.rotation = axisAngle(Vec3(1.0, 0.0, 0.0), -0.5 * pi);
  scene.cameras.push_back(
      {.name = "Crane", .node = node, .kind = CameraKind::orthographic, .halfHeight = 1.0, .aspect = 2.0});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.trails.front().settings.sight.camera = "Crane";
  return document;
}

bool leavesThePicture(const Vec3& place) {
  const Document document = filmedPunch(place);
  const rig::MotionState motion = prepareMotion(document, 0);
  const std::vector<std::string> lines = seenWarnings(document, motion, motion.trails.front());
  return std::ranges::any_of(lines, [](const std::string& line) {
    return line.starts_with("the limb leaves the safe frame of 'Crane'");
  });
}

} // namespace

TEST_CASE("A view is told from where the character faces, its own left and right") {
  const Document document = test::boxer(); // faces +Z
  const auto words = [&](const Vec3& towardsEye) {
    return viewInWords(document, 0, glm::normalize(towardsEye));
  };
  CHECK(words({0.0, 0.0, 1.0}) == "from the front");
  CHECK(words({1.0, 0.0, 0.0}) == "from 90 degrees to its left");
  CHECK(words({-1.0, 0.0, 1.0}) == "from 45 degrees to its right");
  CHECK(words({0.0, 0.0, -1.0}) == "from 180 degrees to its left");
  CHECK(words({0.0, 1.0, 1.0}) == "from the front, 45 degrees above");
  CHECK(words({-1.0, -1.0, 0.0}) == "from 90 degrees to its right, 45 degrees below");
}

TEST_CASE("A limb leaves the safe frame at nine tenths of the picture, up and down and to the sides") {
  const Document document = filmedPunch({0.0, 5.0, 0.0});
  const rig::MotionState motion = prepareMotion(document, 0);
  const rig::SolvedTrail& trail = motion.trails.front();
  const FrameState frame = evaluate(document, motion, trail.tipSeconds);
  const Vec3 tip = rig::leadingPosition(trail.limb, frame);
  const Vec3 base = rig::stayingPosition(trail.limb, frame);
  REQUIRE(tip.z > base.z + 0.5);
  CHECK_FALSE(leavesThePicture({tip.x, 5.0, tip.z - 0.89}));
  CHECK(leavesThePicture({tip.x, 5.0, tip.z - 0.91}));
  const double outwards = tip.x < base.x ? -1.0 : 1.0;
  CHECK_FALSE(leavesThePicture({tip.x - outwards * 1.79, 5.0, 0.5 * tip.z}));
  CHECK(leavesThePicture({tip.x - outwards * 1.81, 5.0, 0.5 * tip.z}));
  CHECK_FALSE(leavesThePicture({tip.x, 5.0, tip.z + 3.0})); // it was out of the picture before
}

TEST_CASE("From above a level punch is seen as long as it is, with all that it is carried") {
  const Document document = test::withNewTrail(test::boxer(), {});
  const rig::MotionState motion = prepareMotion(document, 0);
  const rig::SolvedTrail& trail = motion.trails.front();
  const std::optional<Seen> above = seenBy(document, motion, trail, cameraFrom({0.0, 1.0, 0.0}));
  REQUIRE(above);
  CHECK(above->ratio == Approx(2.0).epsilon(1e-3));
  CHECK(above->of == Approx(2.0).epsilon(1e-3));
  CHECK(above->share == Approx(1.0).epsilon(1e-3));
  CHECK(seenPath(document, motion, trail, cameraFrom({0.0, 1.0, 0.0})) > 1.0);
}
