// Heights and surfaces that all trails of a clip share, against a count over every frame and vertex.
#include "app/evaluate/clip_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "app/evaluate/evaluate.h"
#include "app/evaluate/quality.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/standing_leg.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// The left arm points down by these angles at the frames of its keys.
Document dipping(const std::vector<std::pair<double, double>>& keys) {
  const Document start = test::boxer();
  Track arm = test::turnsOf(start, "left-arm");
  for (const auto& [frame, angle] : keys) {
    test::addKey(arm, frame, glm::angleAxis(angle, Vec3(0.0, 0.0, -1.0)));
  }
  return test::withTracks(start, {arm});
}

NodeIndex handOf(const Document& document, const char* limb = "left-arm") {
  return findLimb(document, limb)->endNode;
}

/// A triangle that is carried by a node; its corners are 3, 4 and 5 tenths apart, the lowest so far above it.
void addTriangle(Document& document, NodeIndex parent, double above, const std::string& name = "Plate") {
  Scene scene = *document.scene;
  Primitive primitive;
  primitive.positions = {{0.0F, 0.4F, 0.0F}, {0.3F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}};
  primitive.indices = {0, 1, 2};
  scene.meshes.push_back({name, {primitive}, {}});
  const NodeIndex node = test::addNode(scene, name, parent, {0.0, above, 0.0});
  scene.nodes[at(node)].mesh = static_cast<int>(scene.meshes.size()) - 1;
  document.scene = std::make_shared<const Scene>(std::move(scene));
}

double heightOf(const Document& document, NodeIndex node, double frame) {
  return positionOf(evaluateOriginal(document, 0, frame / 30.0).worlds[at(node)]).y;
}

/// Where the hand is with the arm down by so much: the shoulder is 1.5 high, the arm 0.6 long.
double dippedHand(double angle) {
  return 1.5 - 0.6 * std::sin(angle);
}

} // namespace

TEST_CASE(
    "The lowest place of a body is that of its joints at any frame, the first and the last among them") {
  const auto keys = GENERATE(std::vector<std::pair<double, double>>{{0, 1.3}, {1, 0.0}, {20, 0.0}},
                             std::vector<std::pair<double, double>>{{0, 0.0}, {19, 0.0}, {20, 1.3}},
                             std::vector<std::pair<double, double>>{{0, 0.0}, {7, 1.3}, {8, 0.0}, {20, 0.0}});
  Document document = dipping(keys);
  document.body.hips = NodeIndex::none; // They are at 1.
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(dippedHand(1.3)));
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id != "right-arm"; });
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(1.5)); // That arm is level.
}

TEST_CASE("The lowest place of a body counts hips, fingers, ends that are no joint, and the rest pose") {
  Document document = dipping({{0, -0.5}, {20, -0.5}});        // Up all the time.
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(1.0)); // The hips.
  document.body.hips = NodeIndex::none;
  Scene scene = *document.scene;
  const NodeIndex finger = test::addNode(scene, "Finger", handOf(document, "right-arm"), {0.0, -0.6, 0.0});
  document.scene = std::make_shared<const Scene>(scene);
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(0.9));
  scene.nodes[at(finger)].rest.translation.y = 0.0;
  test::addNode(scene, "Lamp", NodeIndex::none, {0.0, 0.2, 0.0}); // No part of the body.
  document.scene = std::make_shared<const Scene>(scene);
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(1.2));
  rig::Limb& arm = document.body.limbs[1];
  arm.endNode = NodeIndex::none;
  arm.endOffset = Vec3(0.0, -1.0, 0.0);
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(0.5));
  arm.endOffset = Vec3(0.0);
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id == "spine"; });
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(1.5)); // At rest the left arm is level.
  document.body.limbs.clear();
  CHECK_FALSE(ClipFacts(document, 0).lowestPlace());
}

TEST_CASE("The lowest place of a body is no higher than at rest, whatever it does in the clip") {
  Document document = dipping({{0, -1.2}, {20, -1.2}}); // Up all the time.
  Scene scene = *document.scene;
  const NodeIndex shoulder = findLimb(document, "left-arm")->joints.front();
  scene.nodes[at(shoulder)].rest.rotation = glm::angleAxis(1.3, Vec3(0.0, 0.0, -1.0));
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.body.hips = NodeIndex::none;
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id != "left-arm"; });
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(dippedHand(1.3)));
}

TEST_CASE("Limbs that were marked by hand count for the lowest place as those that were found do") {
  Document document = dipping({{0, 0.0}, {20, 0.0}});
  rig::Limb marked;
  marked.id = "rope";
  Scene scene = *document.scene;
  marked.joints = {test::addNode(scene, "Rope", document.body.hips, {0.0, -0.3, 0.0})};
  marked.endNode = test::addNode(scene, "RopeEnd", marked.joints[0], {0.0, -0.4, 0.0});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.chains.push_back(marked);
  CHECK(*ClipFacts(document, 0).lowestPlace() == Approx(0.3));
}

TEST_CASE("Of a long clip the lowest place is looked for at 240 steps, its ends among them") {
  const double last = 480.0;
  const auto lowestWith = [&](double frame) {
    std::vector<std::pair<double, double>> keys{
        {0, 0.0}, {frame - 1.0, 0.0}, {frame, 1.3}, {frame + 1.0, 0.0}};
    keys.emplace_back(last, 0.0);
    Document document = dipping(keys);
    document.body.hips = NodeIndex::none;
    return *ClipFacts(document, 0).lowestPlace();
  };
  CHECK(lowestWith(300.0) == Approx(dippedHand(1.3)));
  CHECK(lowestWith(301.0) == Approx(1.2)); // Between two of them.
  CHECK(lowestWith(478.0) == Approx(dippedHand(1.3)));
}

TEST_CASE("Without a floor the ground is the lowest of joints and vertices in the clip and at rest") {
  const auto keys =
      GENERATE(std::vector<std::pair<double, double>>{{0, 1.3}, {1, -0.3}, {20, -0.3}},
               std::vector<std::pair<double, double>>{{0, -0.3}, {19, -0.3}, {20, 1.3}},
               std::vector<std::pair<double, double>>{{0, -0.3}, {8, 1.3}, {9, -0.3}, {20, -0.3}});
  Document document = dipping(keys);
  document.body.hips = NodeIndex::none;
  ClipFacts bare(document, 0);
  CHECK(bare.ground() == Approx(dippedHand(1.3)));
  addTriangle(document, handOf(document), -0.5);
  double lowest = std::numeric_limits<double>::infinity();
  for (double frame = 0.0; frame <= 20.0; frame += 1.0) { // The lowest corner is where the plate is.
    lowest = std::min(lowest, heightOf(document, NodeIndex(document.scene->nodes.size() - 1), frame));
    const Mat4 plate = evaluateOriginal(document, 0, frame / 30.0).worlds.back();
    lowest = std::min(lowest, Vec3(plate * Vec4(0.3, 0.0, 0.0, 1.0)).y);
  }
  lowest = std::min(lowest, 1.0); // At rest, with the hand at 1.5.
  ClipFacts facts(document, 0);
  CHECK(facts.ground() == Approx(lowest).margin(1e-6));
  CHECK(facts.ground() == Approx(lowest).margin(1e-6)); // Asked again.
}

TEST_CASE("A body that is bound lower than it ever is has no lower ground for that") {
  Document document = dipping({{0, 0.0}, {20, 0.0}});
  document.body.hips = NodeIndex::none;
  addTriangle(document, handOf(document), -0.5);
  const double ground = ClipFacts(document, 0).ground();
  Scene scene = *document.scene;
  Node& plate = scene.nodes.back();
  const Mat4 world = evaluateOriginal(document, 0, 0.0).worlds.back();
  VertexInfluences byHand;
  byHand.joints[0] = 1;
  byHand.weights[0] = 1.0F;
  Primitive& primitive = scene.meshes.back().primitives.front();
  for (glm::vec3& place : primitive.positions) {
    place = glm::vec3(world * Vec4(Vec3(place) - Vec3(0.0, 1.0, 0.0), 1.0));
    primitive.influences.push_back(byHand);
  }
  Skin skin;
  for (const auto& [joint, lower] :
       {std::pair(scene.nodes[at(findLimb(document, "left-arm")->joints.front())].parent, 0.0),
        std::pair(handOf(document), 1.0)}) {
    const Mat4 rest = evaluateOriginal(document, 0, 0.0).worlds[at(joint)];
    skin.joints.push_back(joint);
    skin.inverseBind.push_back(glm::inverse(rest) * glm::translate(Mat4(1.0), Vec3(0.0, lower, 0.0)));
  }
  plate.skin = static_cast<int>(scene.skins.size());
  scene.skins.push_back(skin);
  document.scene = std::make_shared<const Scene>(std::move(scene));
  CHECK(ClipFacts(document, 0).ground() == Approx(ground).margin(1e-6));
}

TEST_CASE("Without a floor what hangs lowest at rest alone is the ground, with one it is not") {
  Document document = dipping({{0, -1.5}, {20, -1.5}}); // Straight up.
  addTriangle(document, handOf(document), -1.2);        // At 0.3 at rest.
  const auto highest = [&] {
    double lowest = std::numeric_limits<double>::infinity();
    for (const double x : {0.0, 0.3}) {
      const Mat4 plate = evaluateOriginal(document, 0, 0.0).worlds.back();
      lowest = std::min(lowest, Vec3(plate * Vec4(x, 0.0, 0.0, 1.0)).y);
    }
    return lowest;
  };
  REQUIRE(highest() > 1.0);
  CHECK(ClipFacts(document, 0).ground() == Approx(0.3));
  test::addStandingLeg(document);
  ClipFacts standing(document, 0);
  REQUIRE(standing.standing().floor);
  CHECK(*standing.standing().floor == Approx(0.0).margin(1e-9));
  CHECK(standing.ground() > 1.0); // The lowest vertex is above the floor.
  addTriangle(document, document.body.hips, -1.4, "Skirt");
  CHECK(ClipFacts(document, 0).ground() == Approx(0.0).margin(1e-9)); // And no lower than that.
}

TEST_CASE("The ground is no higher than what is told of it without looking at the whole clip") {
  Document document = dipping({{0, 0.0}, {10, 1.3}, {20, 0.0}});
  document.body.hips = NodeIndex::none;
  addTriangle(document, handOf(document), -0.8);
  ClipFacts facts(document, 0);
  const double ground = facts.ground();
  REQUIRE(ground < 0.7 - 0.1); // That is where it is at first.
  ClipFacts afresh(document, 0);
  CHECK(afresh.groundAtMost() > ground + 0.1); // Asked before the ground is known.
  CHECK(afresh.ground() == ground);
  CHECK(afresh.groundAtMost() == ground);
}

TEST_CASE("A limb's surface is made once, another one for other nodes, with lengths of the bind pose") {
  Document document = dipping({{0, 1.0}, {20, 1.0}});
  addTriangle(document, handOf(document), 0.0, "Left plate");
  addTriangle(document, handOf(document, "right-arm"), 0.0, "Right plate");
  CharacterFacts facts(document);
  std::vector<bool> left(document.scene->nodes.size(), false);
  std::vector<bool> none = left;
  for (const NodeIndex node : withSubtrees(*document.scene, {findLimb(document, "left-arm")->joints[0]})) {
    left[at(node)] = true;
  }
  const auto surface = facts.surfaceOf(left);
  CHECK(facts.surfaceOf(left) == surface);
  CHECK(facts.surfaceOf(none) != surface);
  CHECK(facts.surfaceOf(none)->edges.lengths().empty());
  CHECK(facts.surfaceOf(left) == surface);
  std::vector<double> lengths = surface->edges.lengths();
  REQUIRE(lengths.size() == surface->part.edges().size());
  for (double& length : lengths) {
    length = std::round(1e4 * length) / 1e4;
  }
  std::ranges::sort(lengths);
  lengths.erase(std::unique(lengths.begin(), lengths.end()), lengths.end());
  CHECK(lengths == std::vector<double>{0.3, 0.4, 0.5});
}

TEST_CASE("Each trail is told the same by facts that all trails share as by its own") {
  Document document = test::swinger();
  addTriangle(document, handOf(document), -0.9, "Left plate");
  addTriangle(document, handOf(document, "right-arm"), -0.9, "Right plate");
  for (const auto& [id, limb, pulled] : {std::tuple(1, "left-arm", Vec3(0.0, -1.2, 0.0)),
                                         {2, "right-arm", Vec3(0.0, 1.4, 0.0)},
                                         {3, "spine", Vec3(0.0, 0.9, 0.0)}}) {
    rig::Trail trail;
    trail.id = id;
    trail.limb = limb;
    trail.exaggerated = trail.connected = true;
    trail.settings.endFrame = 8.0;
    trail.settings.scale = 1.3;
    trail.settings.spheres = {{4.0, pulled, {}}};
    document.trails.push_back(trail);
  }
  const rig::MotionState motion = prepareMotion(document, 0);
  REQUIRE(motion.trails.size() == 3);
  const auto character = std::make_shared<CharacterFacts>(document);
  const auto shared = std::make_shared<ClipFacts>(document, 0, character);
  std::vector<std::vector<std::string>> told;
  for (const rig::SolvedTrail& trail : motion.trails) {
    told.push_back(motionWarnings(shared, motion, trail));
    CHECK_FALSE(told.back().empty());
    CHECK(told.back() == motionWarnings(document, motion, trail));
  }
  CHECK(told[0] != told[1]);
  for (std::size_t i = motion.trails.size(); i-- > 0;) { // And again, the last one first.
    CHECK(motionWarnings(shared, motion, motion.trails[i]) == told[i]);
    const auto next = std::make_shared<ClipFacts>(document, 0, character);
    CHECK(motionWarnings(next, motion, motion.trails[i]) == told[i]);
  }
}
