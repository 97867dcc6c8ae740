#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/edits/keys/import_clip.h"
#include "app/retarget/body_touch.h"
#include "app/retarget/retarget_figures.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "tests/support/rig/boxed_biped.h"

using namespace stretch;
using namespace stretch::app;
using test::addBox;
using test::MovingBiped;
using test::skeletonOf;

namespace {

const Vec3 chest(0.0, 1.2, 0.0);

// A biped of which a chest and the hands are shown, without these.
MovingBiped bare() {
  MovingBiped moving = test::bareBiped(test::namedBody({.toes = false, .fingers = false}));
  addBox(moving, "spine0", chest, Vec3(0.2));
  return moving;
}

// One hand is as far in front of the chest as is said, the other one far from anything.
MovingBiped showing(double gap, bool isLeft = true) {
  MovingBiped moving = bare();
  addBox(moving, isLeft ? "hand.l" : "hand.r", chest + Vec3(0.0, 0.0, 0.25 + gap), Vec3(0.05));
  addBox(moving, isLeft ? "hand.r" : "hand.l", Vec3(isLeft ? -3.0 : 3.0, 1.0, 0.0), Vec3(0.05));
  return moving;
}

// The hands are so far from each other, and far from the chest.
MovingBiped clapping(double gap) {
  MovingBiped moving = bare();
  addBox(moving, "hand.l", Vec3(0.05 + 0.5 * gap, 1.2, 2.0), Vec3(0.05));
  addBox(moving, "hand.r", Vec3(-0.05 - 0.5 * gap, 1.2, 2.0), Vec3(0.05));
  return moving;
}

FrameState atRest(const MovingBiped& moving) {
  return frameOf(moving.scene, restPose(moving.scene), 0.0);
}

Clip standingClip(const MovingBiped& moving, double metresPerSecond) {
  Clip clip;
  clip.framesPerSecond = 24.0;
  const NodeIndex hips = moving.node.at("hips");
  const Vec3 place = moving.scene.nodes[at(hips)].rest.translation;
  clip.tracks.emplace_back(test::vectorTrack(hips, Channel::translation, Interpolation::linear,
                                             {{0.0, place}, {1.0, place + Vec3(metresPerSecond, 0.0, 0.0)}}));
  setEndsFromKeys(clip);
  return clip;
}

RetargetReport reportOf(const MovingBiped& source, const MovingBiped& result) {
  const rig::Skeleton from = skeletonOf(source);
  const rig::Skeleton onto = skeletonOf(result);
  const Clip still = standingClip(source, 0.0);
  return retargetReport({from, still}, {onto, still}, {onto, still});
}

} // namespace

TEST_CASE("A hand is as far from the chest as its surface is, and from the other hand") {
  const MovingBiped moving = showing(0.07);
  const BodyTouch touch(skeletonOf(moving));
  const HandDistances hands = touch.handsAt(atRest(moving));
  REQUIRE((hands.toTrunk[rig::leftSide] && hands.toTrunk[rig::rightSide] && hands.toOther));
  CHECK(*hands.toTrunk[rig::leftSide] == Approx(0.07).epsilon(1e-4));
  CHECK(*hands.toTrunk[rig::rightSide] == Approx(2.75).epsilon(1e-4));
  CHECK(*hands.toOther > 2.5);
}

TEST_CASE("A hand within the chest is told with its share and its depth, and one beside it is not") {
  const MovingBiped within = showing(-0.08);
  const Inside inside = BodyTouch(skeletonOf(within)).insideAt(atRest(within));
  CHECK(inside.share == Approx(0.25)); // four of sixteen corners
  CHECK(inside.deepest == Approx(0.08).epsilon(1e-4));
  const MovingBiped beside = showing(0.01);
  CHECK(BodyTouch(skeletonOf(beside)).insideAt(atRest(beside)).share == 0.0);
}

TEST_CASE("What a hand holds within the chest is told apart from hands and forearms") {
  MovingBiped moving = test::still(test::namedBody());
  addBox(moving, "spine0", chest, Vec3(0.2));
  const Inside without = BodyTouch(skeletonOf(moving)).insideAt(atRest(moving));
  CHECK_FALSE(without.heldDeepest);
  MovingBiped beside = moving;
  addBox(moving, "hand.l", chest, Vec3(0.05));
  const Inside inside = BodyTouch(skeletonOf(moving)).insideAt(atRest(moving));
  CHECK(inside.share == Approx(without.share));
  CHECK(inside.deepest == Approx(without.deepest));
  REQUIRE(inside.heldDeepest);
  CHECK(*inside.heldDeepest > 0.1);
  CHECK(*inside.heldDeepest < 0.3);
  addBox(beside, "hand.l", chest + Vec3(0.0, 0.0, 1.0), Vec3(0.05));
  CHECK(BodyTouch(skeletonOf(beside)).insideAt(atRest(beside)).heldDeepest == 0.0);
  const RetargetReport report = reportOf(beside, moving);
  REQUIRE((report.source.held && report.result.held));
  CHECK(*report.source.held == 0.0);
  CHECK(*report.result.held == Approx(*inside.heldDeepest / skeletonOf(moving).height));
  CHECK(worseLines(report).front().starts_with("what the hands hold is inside trunk or head by up to"));
}

TEST_CASE("Feet that stand in the source are looked at in the result, and nothing else of it") {
  const MovingBiped moving = test::still(test::namedBody());
  const rig::Skeleton skeleton = skeletonOf(moving);
  const Clip still = standingClip(moving, 0.0);
  const Clip sliding = standingClip(moving, 0.036);
  const Clip running = standingClip(moving, 2.0);
  const RetargetReport report = retargetReport({skeleton, still}, {skeleton, sliding}, {skeleton, still});
  REQUIRE((report.source.slide && report.mapped.slide && report.result.slide));
  CHECK(*report.source.slide == Approx(0.0).margin(1e-9));
  CHECK(*report.mapped.slide == Approx(0.036 / skeleton.height).epsilon(1e-3));
  CHECK(*report.result.slide == Approx(0.0).margin(1e-9));
  const RetargetReport run = retargetReport({skeleton, running}, {skeleton, sliding}, {skeleton, sliding});
  CHECK_FALSE(run.result.slide);
  const gltf::Json json = reportToJson(report);
  CHECK(json["mapped"]["slide_percent"].get<double>() == Approx(100.0 * *report.mapped.slide));
  CHECK(json["mapped"]["slide_cm"].get<double>() == Approx(170.0 * *report.mapped.slide));
  CHECK(reportToJson(run)["result"]["slide_percent"].is_null());
}

TEST_CASE("Contact is the distance of the result's hand where the source's touches, and only there") {
  const MovingBiped touching = showing(0.005);
  const MovingBiped apart = showing(0.3);
  const rig::Skeleton near = skeletonOf(touching);
  const rig::Skeleton far = skeletonOf(apart);
  const Clip still = standingClip(touching, 0.0);
  const RetargetReport report = retargetReport({near, still}, {far, still}, {near, still});
  REQUIRE((report.mapped.contact && report.result.contact));
  CHECK(*report.mapped.contact == Approx(0.3 / far.height).epsilon(1e-3));
  CHECK(*report.result.contact == Approx(0.005 / near.height).epsilon(1e-2));
  const RetargetReport never = retargetReport({far, still}, {near, still}, {near, still});
  CHECK_FALSE(never.result.contact);
  const std::vector<std::string> lines = reportLines(report);
  const std::string told = fmt::format("hands that touch are off by {:.2f} cm at 1.7 m (as mapped {:.2f},",
                                       170.0 * *report.result.contact, 170.0 * *report.mapped.contact);
  CHECK(std::ranges::any_of(lines, [&](const std::string& line) { return line.starts_with(told); }));
}

TEST_CASE("Either hand that touches the chest counts, and both that touch each other") {
  for (const bool isLeft : {true, false}) {
    CAPTURE(isLeft);
    const RetargetReport report = reportOf(showing(0.005, isLeft), showing(0.2, isLeft));
    REQUIRE(report.result.contact);
    CHECK(*report.result.contact == Approx(0.2 / skeletonOf(showing(0.2)).height).epsilon(1e-3));
    // The hand that touches in the source is looked at, not the other one.
    const RetargetReport other = reportOf(showing(0.005, isLeft), showing(0.2, !isLeft));
    REQUIRE(other.result.contact);
    CHECK(*other.result.contact > 1.0);
  }
  const RetargetReport hands = reportOf(clapping(0.004), clapping(0.3));
  REQUIRE(hands.result.contact);
  CHECK(*hands.result.contact == Approx(0.3 / skeletonOf(clapping(0.3)).height).epsilon(1e-3));
  CHECK_FALSE(reportOf(clapping(0.3), clapping(0.004)).result.contact);
}

TEST_CASE(
    "What is within the trunk is told as a share of the limbs' vertices over the frames, and the deepest") {
  const RetargetReport report = reportOf(showing(0.3), showing(-0.08));
  const double height = skeletonOf(showing(0.0)).height;
  REQUIRE((report.source.inside && report.result.inside && report.result.deepest));
  CHECK(*report.source.inside == 0.0);
  CHECK(*report.result.inside == Approx(0.25));
  CHECK(*report.result.deepest == Approx(0.08 / height).epsilon(1e-3));
}

TEST_CASE("One foot that slides is told, whichever it is") {
  for (const char* leg : {"thigh.l", "thigh.r"}) {
    const MovingBiped moving = test::still(test::namedBody());
    const rig::Skeleton skeleton = skeletonOf(moving);
    const Clip still = standingClip(moving, 0.0);
    Clip swung = still;
    const NodeIndex node = moving.node.at(leg);
    const Quat rest = moving.scene.nodes[at(node)].rest.rotation;
    swung.tracks.emplace_back(test::rotationTrack(
        node, Interpolation::linear, {{0.0, rest}, {1.0, axisAngle({1.0, 0.0, 0.0}, 0.05) * rest}}));
    const RetargetReport report = retargetReport({skeleton, still}, {skeleton, still}, {skeleton, swung});
    REQUIRE(report.result.slide);
    CHECK(*report.result.slide > 0.01);
  }
}

TEST_CASE("What is worse than in the source is told with both figures, worst first, and nothing else") {
  RetargetReport report;
  report.source.slide = 0.001;
  report.result.slide = 0.021;
  report.source.floor = 0.02;
  report.result.floor = 0.022;
  report.result.contact = 0.05;
  const std::vector<std::string> lines = worseLines(report);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == "feet that stand slide 2.1 % of the height (0.1 in the source)");
  CHECK(lines[1] == "hands that touch are off by 8.5 cm at 1.7 m (0 in the source)");
  CHECK(worseLines({report.source, report.source, report.source}).empty());
}

TEST_CASE("Of imported clips what is worse is told before the warnings, the worst of each clip first, by its "
          "name") {
  RetargetReport report;
  report.result.slide = 0.021;
  report.result.contact = 0.05;
  NewClips brought;
  brought.warnings = {"names no unit"};
  CHECK(newsOf(brought) == brought.warnings);
  for (const std::string name : {"Walk", "Run"}) {
    NewClip clip;
    clip.clip.name = name;
    clip.report = report;
    brought.clips.push_back(clip);
  }
  NewClip copied;
  copied.clip.name = "Idle";
  brought.clips.push_back(copied);
  const std::vector<std::string> both = newsOf(brought);
  REQUIRE(both.size() == 5);
  CHECK(both[0] == "Walk: feet that stand slide 2.1 % of the height (0 in the source)");
  CHECK(both[1] == "Run: feet that stand slide 2.1 % of the height (0 in the source)");
  CHECK(both[2].starts_with("Walk: hands"));
  CHECK(both[4] == "names no unit");
  brought.clips.resize(1);
  CHECK(newsOf(brought).front() == "feet that stand slide 2.1 % of the height (0 in the source)");
}
