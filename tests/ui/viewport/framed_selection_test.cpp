// What the camera is brought before: the selection with room around it, and the character's front.
#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "ui/viewport/viewport_scene.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

bool isBetween(const Box& box, const Vec3& low, const Vec3& high) {
  return glm::distance(box.minimum, low) < 1e-6 && glm::distance(box.maximum, high) < 1e-6;
}

} // namespace

TEST_CASE("To the selection belong the bones of each limb that is selected, and nothing where none is") {
  app::Session session(test::boxer()); // Its arms begin 0.2 beside the middle and are 0.6 long, 1.5 high.
  CHECK(selectionBox(session, {}).empty());
  app::selectLimb(session, "left-arm", false);
  CHECK(isBetween(selectionBox(session, {}), {0.2, 1.5, 0.0}, {0.8, 1.5, 0.0}));
  app::selectLimb(session, "right-arm", true);
  CHECK(isBetween(selectionBox(session, {}), {-0.8, 1.5, 0.0}, {0.8, 1.5, 0.0}));
}

TEST_CASE("Around a selected controller there is room of three twentieths of the character's height") {
  app::Session session(test::boxer());
  app::selectControllers(session, {"right-hand"});
  const std::vector<rig::PlacedController> placed = session.controllersAt(session.view().frame);
  const auto hand = std::ranges::find(placed, "right-hand", &rig::PlacedController::id);
  REQUIRE(hand != placed.end());
  const Vec3 room(0.15 * 1.8);
  CHECK(isBetween(selectionBox(session, {}), hand->placeWorld - room, hand->placeWorld + room));
}

TEST_CASE("To a selected trail belongs the flesh of the hand all along its path, a third of the arm or so") {
  app::Session session(test::withNewTrail(test::boxer(), {.startFrame = 2.0, .endFrame = 12.0}));
  ShownTrails shown;
  updateShownTrails(session, shown);
  REQUIRE(shown.trails.size() == 1);
  app::selectTrail(session, shown.trails.front().id);
  const std::vector<Vec3>& path = shown.trails.front().drawn.exaggerated;
  const auto farthest = std::ranges::max_element(path, {}, &Vec3::z); // The punch goes along z.
  REQUIRE(farthest->z > 0.6);
  const Box box = selectionBox(session, shown);
  CHECK(box.maximum.z == Approx(farthest->z + 0.3 * 0.6));
  const auto [lowest, highest] = std::ranges::minmax_element(path, {}, &Vec3::y);
  CHECK(box.minimum.y == Approx(lowest->y - 0.3 * 0.6));
  CHECK(box.maximum.y == Approx(highest->y + 0.3 * 0.6));
  CHECK(fleshRadius(session.document(), 99) == 0.0);
}

TEST_CASE("The front view is that of the scene's axes which the character faces most") {
  const double turn = GENERATE(0.0, 0.6, 1.0, -1.0, 3.0);
  CAPTURE(turn);
  app::Document document = test::boxer();
  Scene scene = *document.scene;
  scene.nodes[at(document.body.hips)].rest.rotation = glm::angleAxis(turn, Vec3(0.0, 1.0, 0.0));
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const double quarters = std::abs(turn) < 0.7 ? 0.0 : turn > 2.0 ? 2.0 : turn > 0.0 ? 1.0 : -1.0;
  CHECK(facingYaw(document, 0) == Approx(quarters * 0.5 * pi));
}
