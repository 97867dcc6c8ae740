#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/matrix.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/quality.h"
#include "app/evaluate/trail_look.h"
#include "core/math/rotation.h"
#include "rig/limb.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/standing_leg.h"
#include "tests/support/nodes.h"

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
  track.node = document.body.hips;
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

// A triangle under the left upper arm; one corner follows the chest.
void addSleeve(Document& document) {
  Scene scene = *document.scene;
  const rig::Limb& arm = *findLimb(document, "left-arm");
  const FrameState rest = evaluateOriginal(document, 0, 0.0);
  const NodeIndex chest = scene.nodes[at(arm.joints.front())].parent;
  const glm::vec3 shoulder(positionOf(rest.worlds[at(arm.joints.front())]));
  Primitive primitive;
  primitive.positions = {shoulder + glm::vec3(0.1F, -0.01F, 0.0F), shoulder + glm::vec3(0.1F, 0.01F, 0.0F),
                         shoulder + glm::vec3(0.12F, 0.01F, 0.0F)};
  for (const std::uint16_t joint : std::initializer_list<std::uint16_t>{0, 1, 1}) {
    VertexInfluences influences;
    influences.joints[0] = joint;
    influences.weights = {1.0F};
    primitive.influences.push_back(influences);
  }
  primitive.indices = {0, 1, 2};
  scene.meshes.push_back({"sleeve", {primitive}, {}});
  scene.skins.push_back(
      {"skin",
       {chest, arm.joints.front()},
       {glm::inverse(rest.worlds[at(chest)]), glm::inverse(rest.worlds[at(arm.joints.front())])}});
  Node holder;
  holder.mesh = static_cast<int>(scene.meshes.size()) - 1;
  holder.skin = static_cast<int>(scene.skins.size()) - 1;
  scene.roots.emplace_back(scene.nodes.size());
  scene.nodes.push_back(holder);
  document.scene = std::make_shared<const Scene>(std::move(scene));
}

void addHead(Document& document) {
  Scene scene = *document.scene;
  document.body.head = test::addNode(scene, "Head", findLimb(document, "spine")->endNode, {0.0, 0.3, 0.0});
  document.scene = std::make_shared<const Scene>(std::move(scene));
}

// A small mesh of its own under a node.
void addRigidPart(Document& document, const std::string& name, NodeIndex parent, const Vec3& offset) {
  Scene scene = *document.scene;
  Primitive primitive;
  primitive.positions = {{-0.05F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}, {0.0F, 0.05F, 0.05F}};
  primitive.indices = {0, 1, 2};
  scene.meshes.push_back({name, {primitive}, {}});
  const NodeIndex node = test::addNode(scene, name, parent, offset);
  scene.nodes[at(node)].mesh = static_cast<int>(scene.meshes.size()) - 1;
  scene.roots.emplace_back(node);
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

TEST_CASE("a pose that folds the arm up is told of a trail that was fine without it") {
  const Document document = punching(10.0, 2.0);
  REQUIRE(warningsOf(document).empty());
  rig::Adjustment folded;
  folded.controller = "left-hand";
  folded.keys.resize(1);
  const rig::Limb& arm = *findLimb(document, "left-arm");
  const FrameState tip = evaluateOriginal(document, 0, 10.0 / 30.0);
  const std::vector<Vec3> points = rig::limbPoints(arm, tip);
  folded.keys[0].move = 0.95 * (points.front() - points.back());
  const Result<Document> posed = placeAdjustments(document, {&folded, 1});
  REQUIRE(posed);
  CHECK_FALSE(warningsOf(*posed).empty());
}

TEST_CASE("a limb pulled out of bounds is told with its frame") {
  Document document = punching(10.0, 2.0);
  document.trails.front().settings.spheres = {{5.0, Vec3(3.0, 0.0, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings.front(), Contains("the limb is") && Contains("times its own length"));
  CHECK_THAT(warnings.front(), Contains("worst at 5)"));
}

TEST_CASE("the last frame of a clip is looked at, though its time in a file lies just before the frame") {
  Document document = punching(25.0, 2.0);
  std::vector<Clip> clips = *document.clips;
  clips.front().endSeconds = static_cast<double>(25.0F / 30.0F);
  REQUIRE(clips.front().endSeconds * 30.0 < 25.0);
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  document.trails.front().settings.spheres = {{25.0, Vec3(3.0, 0.0, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE_FALSE(warnings.empty());
  CHECK_THAT(warnings.front(), Contains("times its own length") && Contains("worst at 25)"));
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

TEST_CASE("something is found on a trail wherever it is looked for first") {
  Document document = punching(20.0, 2.0);
  addFlight(document);
  const rig::MotionState motion = prepareMotion(document, 0);
  const TrailLook look(std::make_shared<ClipFacts>(document, 0), motion.trails.front(), LookAt::limbAndMesh);
  const Findings found = look.findings(motion);
  REQUIRE(found.any());
  const double worst = found.worstFrames().back();
  CHECK(look.foundAt(motion, {worst, found.firstFrame()}) == worst);
  CHECK(look.foundAt(motion, {}) == found.firstFrame());
  CHECK(look.foundAt(motion, {found.firstFrame() - 1.0}) == found.firstFrame());
  const rig::MotionState calm = prepareMotion(punching(20.0, 1.0), 0);
  CHECK_FALSE(look.foundAt(calm, found.worstFrames()));
}

TEST_CASE("the advice stays the same while the scale is changed, and it helps") {
  const auto adviceAt = [](double scale) {
    Document document = punching(10.0, scale);
    document.trails.front().settings.spheres = {{5.0, Vec3(0.0, 1.2, 0.0)}};
    addHead(document);
    const std::vector<std::string> warnings = warningsOf(document);
    return warnings.empty() ? std::string() : warnings.front().substr(warnings.front().find("; "));
  };
  CHECK(adviceAt(4.0) == adviceAt(4.5));
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
  CHECK_THAT(warnings.front(), Contains("a vertex is") && Contains("from its place"));
  const rig::MotionState motion = prepareMotion(document, 0);
  CHECK(motionWarnings(document, motion, motion.trails.front(), LookAt::limb).empty());
}

TEST_CASE("a head may go as much farther than its neck's end as it is away from the neck's base, no more") {
  const auto warningsOfNeck = [](float beyondEnd, const Vec3& pulledOnTheWay) {
    Document document = punching(10.0, 1.2);
    document.trails.front().settings.spheres = {{5.0, pulledOnTheWay}, {10.0, Vec3(0.0, 0.15, 0.0)}};
    rig::Limb& limb = *std::ranges::find(document.body.limbs, "left-arm", &rig::Limb::id);
    static_cast<rig::LimbPlace&>(limb) = rig::biped::neck;
    addStaff(document, beyondEnd);
    return warningsOf(document);
  };
  CHECK(warningsOfNeck(1.2F, Vec3(0.0)).empty());
  CHECK_FALSE(warningsOfNeck(1.2F, Vec3(0.0, 0.4, 0.0)).empty());
  CHECK_FALSE(warningsOfNeck(0.0F, Vec3(0.0, 0.4, 0.0)).empty());
}

TEST_CASE("a mesh that is torn is told with the frame, where the mesh is looked at") {
  Document document = punching(10.0, 2.0);
  addSleeve(document);
  CHECK(warningsOf(document).empty());
  // The arm goes up, and the seam under it, which hardly opens in the source, opens wide.
  document.trails.front().settings.spheres = {{3.0, Vec3(0.0, 0.9, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  const auto torn = std::find_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("an edge of the mesh is") != std::string::npos;
  });
  REQUIRE(torn != warnings.end());
  CHECK_THAT(*torn, Contains("times its length at frame"));
  const rig::MotionState motion = prepareMotion(document, 0);
  for (const std::string& warning : motionWarnings(document, motion, motion.trails.front(), LookAt::limb)) {
    CHECK_THAT(warning, !Contains("an edge of the mesh"));
  }
}

TEST_CASE("an elbow above the head that the source has not is told, with what helps") {
  Document document = punching(10.0, 3.0);
  addHead(document);
  CHECK(warningsOf(document).empty());
  document.trails.front().settings.spheres = {{10.0, Vec3(0.0, 1.6, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  const auto raised = std::find_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("the elbow is") != std::string::npos;
  });
  REQUIRE(raised != warnings.end());
  CHECK_THAT(*raised, Contains("above the head at frame") && Contains("; "));
}

TEST_CASE("a hand below the floor is told, and stopping there helps") {
  Document document = punching(10.0, 2.0);
  test::addStandingLeg(document);
  CHECK(warningsOf(document).empty());
  document.trails.front().settings.scale = 3.0;
  document.trails.front().settings.spheres = {{10.0, Vec3(0.0, -1.6, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  const auto sunk = std::find_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("the hand is") != std::string::npos;
  });
  REQUIRE(sunk != warnings.end());
  CHECK_THAT(*sunk, Contains("below the floor at frame") && Contains("stop the limb's end at the floor"));
  document.trails.front().settings.stopAt = rig::StopPlane{Vec3(0.0), Vec3(0.0, -1.0, 0.0)};
  CHECK(warningsOf(document).empty());
}

TEST_CASE("a glove that hangs on the body instead of the hand is named, one on the hand is not") {
  Document document = punching(10.0, 2.0);
  const NodeIndex spine = findLimb(document, "spine")->joints.front();
  const NodeIndex hand = findLimb(document, "left-arm")->endNode;
  Document worn = document;
  addRigidPart(worn, "Glove", hand, Vec3(0.0));
  CHECK(warningsOf(worn).empty());
  addRigidPart(document, "Glove", spine, Vec3(0.8, 0.3, 0.0));
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings.front(),
             Contains("the mesh \"Glove\" stands at the limb's end but hangs on \"Spine\"") &&
                 Contains("hang it on \"LeftHand\""));
  Document buckle = punching(10.0, 2.0);
  addRigidPart(buckle, "Buckle", spine, Vec3(0.0, 0.0, 0.1));
  CHECK(warningsOf(buckle).empty());
}

TEST_CASE("a limb that reaches below all that the body does in the clip is told, where no leg stands") {
  Document document = punching(10.0, 1.0);
  document.trails.front().settings.spheres = {{10.0, Vec3(0.0, -0.4, 0.0)}};
  CHECK(warningsOf(document).empty()); // The hand is at 1.1, the hips are at 1.
  document.trails.front().settings.spheres = {{10.0, Vec3(0.0, -0.65, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE_FALSE(warnings.empty());
  CHECK_THAT(warnings.back(), Contains("the limb is 0.15 below the lowest place of the body in the clip") &&
                                  Contains("stop the limb's end at the floor, below y = 1"));
}

TEST_CASE("a surface below all that the body does is told, though the joints in it are not there") {
  Document document = punching(10.0, 1.0);
  addRigidPart(document, "Claw", findLimb(document, "left-arm")->endNode, Vec3(0.0, -0.3, 0.0));
  const auto told = [&](double lower) {
    document.trails.front().settings.spheres = {{10.0, Vec3(0.0, -lower, 0.0)}};
    const std::vector<std::string> warnings = warningsOf(document);
    const auto found = std::ranges::find_if(
        warnings, [](const std::string& warning) { return warning.starts_with("the limb's surface is"); });
    return found == warnings.end() ? std::string() : *found;
  };
  CHECK(told(0.15).empty()); // The claw is at 1.05, the hips are at 1.
  CHECK_THAT(told(0.4), Contains("0.2 below the lowest place of the body in the clip"));
  CHECK_THAT(told(0.4), Contains("at frame") && Contains("10"));
}

TEST_CASE("a joint that a path folds through to its other side is told with its frames") {
  Document document = punching(10.0, 1.0);
  document.trails.front().settings.bend = rig::Bend::straighten;
  rig::Limb& arm = document.body.limbs[static_cast<std::size_t>(
      std::ranges::find(document.body.limbs, "left-arm", &rig::Limb::id) - document.body.limbs.begin())];
  Scene scene = *document.scene;
  const NodeIndex wrist = arm.endNode;
  arm.endNode = test::addNode(scene, "LeftFingers", wrist, {0.3, 0.0, 0.0});
  arm.joints.push_back(wrist);
  arm.restLength = 0.9;
  const auto bend = [&](NodeIndex node, double radians) {
    scene.nodes[at(node)].rest.rotation = axisAngle(Vec3(0.0, 1.0, 0.0), radians);
  };
  bend(arm.joints[1], 0.35);
  bend(arm.joints[2], -0.35);
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const auto told = [&] {
    const std::vector<std::string> warnings = warningsOf(document);
    const auto found = std::ranges::find_if(warnings, [](const std::string& warning) {
      return warning.starts_with("a joint bends the other way");
    });
    return found == warnings.end() ? std::string() : *found;
  };
  const FrameState there = evaluateOriginal(document, 0, 5.0 / 30.0);
  const Vec3 reach = rig::endPosition(arm, there) - positionOf(there.worlds[at(arm.joints.front())]);
  document.trails.front().settings.spheres = {{5.0, -0.4 * reach, {}}};
  CHECK(told().empty()); // It folds, as it does in the clip.
  document.trails.front().settings.spheres = {{5.0, -0.97 * reach, {}}};
  CHECK_THAT(told(), Contains("than in the clip, by") && Contains("at frame"));
}

TEST_CASE("a hand that is carried off and brought back is told as that, not as a vertex") {
  Document document = punching(10.0, 1.0);
  addStaff(document, 0.01F);
  document.trails.front().settings.spheres = {{5.0, Vec3(0.0, 0.1, 0.0)}, {10.0, Vec3(0.0, 0.02, 0.0)}};
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings.front(), Contains("the hand is carried 0.102 away, at the tip only 0.02, at frames"));
}

TEST_CASE("a limb that jumps where its stop lets it go is told, and that it may stop nowhere") {
  Document document = punching(10.0, 1.5);
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.front().edit([](Track& track) { // The hand rests up to frame 6.
    track.times = {0.0F, 6.0F / 30.0F, 10.0F / 30.0F, 20.0F / 30.0F};
    std::copy_n(track.values.begin(), 4, track.values.begin() + 4);
  });
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  rig::TrailSettings& settings = document.trails.front().settings;
  settings.axes = {false, false, false};
  settings.stopAt = rig::StopPlane{{0.0, 1.49, 0.0}, {0.0, -1.0, 0.0}}; // Just below where the hand is.
  for (const double frame : {3.0, 6.0, 8.0, 10.0}) {
    settings.spheres.push_back({frame, Vec3(0.5, -0.2, 0.0), {}});
  }
  const std::vector<std::string> warnings = warningsOf(document);
  REQUIRE_FALSE(warnings.empty());
  CHECK_THAT(warnings.front(), Contains("the hand jumps by 0.") && Contains("where it stops at frame") &&
                                   Contains("set Stop at to Nowhere"));
  settings.stopAt.reset();
  CHECK(warningsOf(document).empty());
}

TEST_CASE("a limb that is beyond its stop leaves it without a jump") {
  Document document = punching(10.0, 1.0);
  rig::TrailSettings& settings = document.trails.front().settings;
  settings.stopAt = rig::StopPlane{{0.0, 1.52, 0.0}, {0.0, -1.0, 0.0}}; // Just above where the hand is.
  settings.spheres = {{5.0, Vec3(0.3, 0.0, 0.0)}, {6.0, Vec3(0.3, 0.05, 0.0)}, {10.0, Vec3(0.3, 0.2, 0.0)}};
  CHECK(warningsOf(document).empty());
}
