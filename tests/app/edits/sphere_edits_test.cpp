#include <catch2/catch.hpp>

#include "app/edits/body/limb_edits.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr int trailId = 1;

Document withTrail(rig::TrailSettings settings = {}) {
  settings.startFrame = 0.0;
  settings.endFrame = 10.0;
  Result<CreatedTrail> created = createTrail(test::boxer(), {"left-arm", 0, settings, true, true});
  REQUIRE(created);
  return std::move(created->document);
}

const rig::TrailSettings& settingsOf(const Document& document) {
  return findTrail(document, trailId)->settings;
}

Document moved(const Document& document, const std::vector<SphereMove>& moves) {
  Result<Document> result = moveSpheres(document, trailId, moves);
  REQUIRE(result);
  return std::move(result).value();
}

} // namespace

TEST_CASE("Pulls add up, stay in order of time, and vanish when they cancel out") {
  const Document once = moved(withTrail(), {{5.0, Vec3(0.1, 0.0, 0.0)}, {2.0, Vec3(0.0, 1.0, 0.0)}});
  REQUIRE(settingsOf(once).spheres.size() == 2);
  CHECK(settingsOf(once).spheres[0].frame == 2.0);
  const Document twice = moved(once, {{5.0, Vec3(0.25, 0.0, 0.0)}});
  CHECK(settingsOf(twice).spheres[1].offset.x == Approx(0.35));
  const Document back = moved(once, {{2.0, Vec3(0.0, -1.0, 0.0)}, {5.0, Vec3(-0.1, 0.0, 0.0)}});
  CHECK(settingsOf(back) == settingsOf(withTrail()));
}

TEST_CASE("Spheres are put back one by one or set outright") {
  const Document pulled = moved(withTrail(), {{2.0, Vec3(1.0)}, {5.0, Vec3(2.0)}});
  const Result<Document> cleared = clearSpheres(pulled, trailId, std::vector<double>{5.0, 7.0});
  REQUIRE(cleared);
  REQUIRE(settingsOf(*cleared).spheres.size() == 1);
  CHECK(settingsOf(*cleared).spheres[0].frame == 2.0);
  const Result<Document> set = setSphereOffset(pulled, trailId, {5.0, Vec3(0.5)});
  REQUIRE(set);
  CHECK(settingsOf(*set).spheres[1].offset == Vec3(0.5));
}

TEST_CASE("With follow off a pull leaves the character alone until it is connected") {
  const Result<Document> alone = setFollow(withTrail(), trailId, false);
  REQUIRE(alone);
  CHECK_FALSE(findTrail(moved(*alone, {{5.0, Vec3(1.0)}}), trailId)->connected);
  CHECK(findTrail(moved(withTrail(), {{5.0, Vec3(1.0)}}), trailId)->connected);
}

TEST_CASE("Soft falloff moves the neighbours less, and nothing outside of its radius") {
  const std::vector<PlacedSphere> spheres{{0, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {2, 0, 0}}, {3, {4, 0, 0}}};
  const std::vector<double> selected{1.0};
  const auto moves = softMoves({}, spheres, selected, Vec3(0, 1, 0), 2.0);
  REQUIRE(moves.size() == 3);
  CHECK(moves[1].delta.y == Approx(1.0));
  CHECK(moves[0].delta.y == Approx(0.5625)); // (1 - (1/2)^2)^2
  CHECK(moves[2].delta.y == Approx(0.5625));
  CHECK(softMoves({}, spheres, selected, Vec3(0, 1, 0), 0.0).size() == 1);
}

TEST_CASE("In view space pulls are stored along the view's axes") {
  rig::TrailSettings settings;
  settings.space = rig::TrailSpace::view;
  settings.viewAxes = Mat3(Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(1, 0, 0)); // Seen from +X.
  CHECK(toTrailAxes(settings, Vec3(0, 0, -2)).x == Approx(2.0));
  CHECK(toTrailAxes(settings, Vec3(3, 0, 0)).z == Approx(3.0));
  settings.space = rig::TrailSpace::world;
  CHECK(toTrailAxes(settings, Vec3(3, 0, 0)).x == Approx(3.0));
}

TEST_CASE("A mirrored trail lies on the other limb, reflected across the body") {
  const Document pulled = moved(withTrail(), {{5.0, Vec3(0.3, 0.2, 0.1)}});
  const Result<CreatedTrail> mirrored = mirrorTrail(pulled, *findTrail(pulled, trailId));
  REQUIRE(mirrored);
  const rig::Trail& trail = *findTrail(mirrored->document, mirrored->trailId);
  CHECK(trail.limb == "right-arm");
  REQUIRE(trail.settings.spheres.size() == 1);
  CHECK(trail.settings.spheres[0].offset.x == Approx(-0.3));
  CHECK(trail.settings.spheres[0].offset.y == Approx(0.2));
  CHECK(trail.settings.spheres[0].offset.z == Approx(0.1));

  SECTION("twice gives the same settings back") {
    const Result<CreatedTrail> back =
        mirrorTrail(mirrored->document, *findTrail(mirrored->document, mirrored->trailId));
    REQUIRE(back);
    CHECK(back->trailId == trailId);
    CHECK(settingsOf(back->document).spheres[0].offset.x == Approx(0.3));
  }
}

TEST_CASE("Mirroring view axes keeps them an orientation and reflects what they carry") {
  rig::TrailSettings settings;
  settings.space = rig::TrailSpace::view;
  settings.viewAxes = Mat3(Vec3(0.6, 0, -0.8), Vec3(0, 1, 0), Vec3(0.8, 0, 0.6));
  settings.spheres = {{1.0, Vec3(0.5, 0.25, -1.0)}};
  const Vec3 world = settings.viewAxes * settings.spheres[0].offset;
  const rig::TrailSettings mirrored = mirroredSettings(settings, Vec3(1, 0, 0), Vec3(0.0));
  const Vec3 mirroredWorld = mirrored.viewAxes * mirrored.spheres[0].offset;
  CHECK(mirroredWorld.x == Approx(-world.x));
  CHECK(mirroredWorld.y == Approx(world.y));
  CHECK(mirroredWorld.z == Approx(world.z));
  CHECK(glm::determinant(mirrored.viewAxes) == Approx(1.0));
}

TEST_CASE("The spine has no other side") {
  CHECK_THAT(test::refusal(otherSide(test::boxer(), "spine")),
             Catch::StartsWith("spine: this limb has no other side"));
  CHECK_THAT(test::refusal(otherSide(test::boxer(), "tail")),
             Catch::StartsWith("tail: the character has no such limb"));
  CHECK(*otherSide(test::boxer(), "right-arm") == "left-arm");
}

TEST_CASE("A limb corrected by hand takes the place of the one that was found") {
  const Document document = test::boxer();
  rig::Limb corrected = *findLimb(document, "left-arm");
  corrected.joints = {NodeIndex(4)};
  const Result<Document> changed = correctLimb(document, corrected);
  REQUIRE(changed);
  CHECK(changed->body.limbs.size() == document.body.limbs.size());
  CHECK(findLimb(*changed, "left-arm")->joints == std::vector{NodeIndex(4)});

  corrected.joints = {NodeIndex(99)};
  CHECK_THAT(test::refusal(correctLimb(document, corrected)),
             Catch::StartsWith("left-arm: the limb names joints that the character does not have"));
  rig::Limb leg = *findLimb(document, "left-arm");
  static_cast<rig::LimbPlace&>(leg) = rig::biped::leftLeg;
  const Result<Document> added = correctLimb(document, leg);
  REQUIRE(added);
  REQUIRE(added->body.limbs.size() == document.body.limbs.size() + 1);
  CHECK(added->body.limbs[2].id == "left-leg"); // In the order of kinds, before the spine.
}

TEST_CASE("A chain is added once") {
  rig::Limb chain;
  chain.id = "LeftArm..LeftHand";
  chain.joints = {NodeIndex(3), NodeIndex(4)};
  chain.endNode = NodeIndex(5);
  const Result<Document> once = addChain(test::boxer(), chain);
  REQUIRE(once);
  CHECK(findLimb(*once, chain.id) != nullptr);
  CHECK_THAT(test::refusal(addChain(*once, chain)), Catch::Contains("this chain is there already"));
}

TEST_CASE("A tangent stays on a sphere that is not pulled, and goes when it is taken back") {
  const Document start = withTrail();
  const Result<Document> bent = setSphereTangent(start, trailId, 5.0, Vec3(0.0, 0.2, 0.0));
  REQUIRE(bent);
  REQUIRE(settingsOf(*bent).spheres.size() == 1);
  CHECK(settingsOf(*bent).spheres[0].offset == Vec3(0.0));
  CHECK(settingsOf(*bent).spheres[0].tangent == Vec3(0.0, 0.2, 0.0));
  const Document pulled = moved(*bent, {{5.0, Vec3(1.0)}});
  CHECK(settingsOf(pulled).spheres[0].tangent == Vec3(0.0, 0.2, 0.0));
  const Result<Document> back = setSphereTangent(*bent, trailId, 5.0, std::nullopt);
  REQUIRE(back);
  CHECK(settingsOf(*back) == settingsOf(start));
}

TEST_CASE("Spheres are removed with what they were pulled by, those at the ends are put back instead") {
  const Document pulled = moved(withTrail(), {{0.0, Vec3(0.5)}, {5.0, Vec3(1.0)}});
  const std::vector<double> present{0.0, 5.0, 10.0};
  const Result<Document> removed = removeSpheres(pulled, trailId, present, std::vector<double>{0.0, 5.0});
  REQUIRE(removed);
  CHECK(settingsOf(*removed).spheres.empty());
  CHECK(findTrail(*removed, trailId)->controlFrames == std::vector<double>{0.0, 10.0});
  const Result<Document> end = removeSpheres(pulled, trailId, present, std::vector<double>{0.0});
  REQUIRE(end);
  CHECK(findTrail(*end, trailId)->controlFrames.empty());
  CHECK(settingsOf(*end).spheres.size() == 1);
}

TEST_CASE("Spheres that were set by hand go along when the whole range moves") {
  const Result<Document> set = setControlFrames(withTrail(), trailId, {0.0, 4.0, 10.0});
  REQUIRE(set);
  rig::TrailSettings settings = settingsOf(*set);
  settings.startFrame += 3.0;
  settings.endFrame += 3.0;
  CHECK(findTrail(*setTrailSettings(*set, trailId, settings), trailId)->controlFrames ==
        std::vector<double>{3.0, 7.0, 13.0});
  settings = settingsOf(*set);
  settings.endFrame += 3.0;
  CHECK(findTrail(*setTrailSettings(*set, trailId, settings), trailId)->controlFrames ==
        std::vector<double>{0.0, 4.0, 10.0});
}

TEST_CASE("A limb is made of joints that the character has, with an end that it has or none") {
  const Document document = test::boxer();
  const NodeIndex past(document.scene->nodes.size());
  rig::Limb chain;
  chain.id = "LeftArm..LeftHand";
  chain.joints = {NodeIndex(3), NodeIndex(4)};
  CHECK(addChain(document, chain));
  const auto refused = [&](const std::vector<NodeIndex>& joints, NodeIndex end) {
    rig::Limb limb = chain;
    limb.joints = joints;
    limb.endNode = end;
    std::string told = test::refusal(addChain(document, limb));
    static_cast<rig::LimbPlace&>(limb) = rig::biped::leftArm;
    CHECK(test::refusal(correctLimb(document, limb)) == told);
    return told;
  };
  const std::string told = "LeftArm..LeftHand: the limb names joints that the character does not have; "
                           "pick its joints again";
  CHECK(refused({}, NodeIndex(5)) == told);
  CHECK(refused({NodeIndex(3), past}, NodeIndex(5)) == told);
  CHECK(refused({NodeIndex(3), NodeIndex::none}, NodeIndex(5)) == told);
  CHECK(refused({NodeIndex(3), NodeIndex(4)}, past) == told);
}

TEST_CASE("A limb that was set by hand is taken for sure, and its document for one to be saved") {
  const Document document = test::boxer();
  REQUIRE_FALSE(document.limbsCorrected);
  rig::Limb arm = *findLimb(document, "left-arm");
  arm.confidence = 0.3;
  arm.reasons = {"its name"};
  const Result<Document> corrected = correctLimb(document, arm);
  REQUIRE(corrected);
  CHECK(corrected->limbsCorrected);
  CHECK(findLimb(*corrected, "left-arm")->confidence == 1.0);
  CHECK(findLimb(*corrected, "left-arm")->reasons == std::vector<std::string>{"set by hand"});
  arm.kind = rig::LimbKind::chain;
  CHECK_THAT(test::refusal(correctLimb(document, arm)), Catch::Contains("a chain is not a limb of the body"));
}
