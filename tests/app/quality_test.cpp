#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/matrix.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/quality.h"
#include "rig/limb.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;
using Catch::Matchers::Contains;

namespace {

Document punching(double endFrame, double scale) {
  Document document = test::boxer();
  rig::Trail trail;
  trail.id = 1;
  trail.limb = "left-arm";
  trail.settings.endFrame = endFrame;
  trail.settings.scale = scale;
  trail.exaggerated = true;
  trail.connected = true;
  document.trails.push_back(trail);
  return document;
}

// The body flies off to its right, away from where its left arm points at the end.
void addFlight(Document& document) {
  Track track;
  track.node = document.biped.hips;
  track.times = {0.0F, 20.0F / 30.0F};
  track.values = {0.0F, 1.0F, 0.0F, -3.0F, 1.0F, 0.0F};
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.emplace_back(std::move(track));
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
}

// A skinned mesh of one vertex, held by the left hand, so far beyond it along the arm.
void addStaff(Document& document, float beyondHand) {
  Scene scene = *document.scene;
  const rig::Limb& arm = *findLimb(document, "left-arm");
  const FrameState rest = evaluateOriginal(document, 0, 0.0);
  const Mat4& hand = rest.worlds[at(arm.joints.back())];
  Primitive primitive;
  const Vec3 end = rig::endPosition(arm, rest);
  primitive.positions = {glm::vec3(end) + glm::vec3(beyondHand, 0.0F, 0.0F)};
  VertexInfluences whole;
  whole.weights = {1.0F};
  primitive.influences = {whole};
  scene.meshes.push_back({"staff", {primitive}, {}});
  scene.skins.push_back({"skin", {arm.joints.back()}, {glm::inverse(hand)}});
  Node holder;
  holder.mesh = static_cast<int>(scene.meshes.size()) - 1;
  holder.skin = static_cast<int>(scene.skins.size()) - 1;
  scene.roots.emplace_back(scene.nodes.size());
  scene.nodes.push_back(holder);
  document.scene = std::make_shared<const Scene>(std::move(scene));
}

std::vector<std::string> warningsOf(const Document& document) {
  const rig::MotionState motion = prepareMotion(document, 0);
  return motionWarnings(document, motion, motion.trails.front());
}

} // namespace

TEST_CASE("a punch that is twice as long gives no cause for a warning") {
  CHECK(warningsOf(punching(10.0, 2.0)).empty());
}

TEST_CASE("a limb pulled out of bounds is told with its frame") {
  Document document = punching(10.0, 2.0);
  document.trails.front().settings.spheres = {{5.0, Vec3(3.0, 0.0, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings.front(), Contains("left-arm: the limb is") && Contains("times its own length"));
  CHECK_THAT(warnings.front(), Contains("worst at 5)"));
}

TEST_CASE("an arm that points the other way is told, and the advice that goes with it helps") {
  Document document = punching(20.0, 2.0);
  addFlight(document);
  const std::vector<std::string> warnings = warningsOf(document);
  const auto turned = std::find_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("degrees away from where it did") != std::string::npos;
  });
  REQUIRE(turned != warnings.end());
  CHECK_THAT(*turned, Contains("set the space to root"));
  document.trails.front().settings.space = rig::TrailSpace::root;
  CHECK(warningsOf(document).empty());
}

TEST_CASE("a trail that the character does not follow gives no warning") {
  Document document = punching(20.0, 2.0);
  addFlight(document);
  document.trails.front().connected = false;
  CHECK(warningsOf(document).empty());
}

TEST_CASE("a vertex that is thrown farther than the tip is told, where the mesh is looked at") {
  // The arm's end is pulled aside by less than the staff that turns with it.
  Document document = punching(10.0, 1.2);
  document.trails.front().settings.spheres = {{10.0, Vec3(0.0, 0.15, 0.0)}};
  addStaff(document, 0.0F);
  CHECK(warningsOf(document).empty());
  document = punching(10.0, 1.2);
  document.trails.front().settings.spheres = {{10.0, Vec3(0.0, 0.15, 0.0)}};
  addStaff(document, 1.2F);
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings.front(), Contains("left-arm: a vertex is") && Contains("from its place"));
  const rig::MotionState motion = prepareMotion(document, 0);
  CHECK(motionWarnings(document, motion, motion.trails.front(), LookAt::limb).empty());
}
