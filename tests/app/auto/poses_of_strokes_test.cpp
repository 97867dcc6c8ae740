// What an animator sees of the poses that a limb comes to: which are held, folded, bent, in the air or near
// the ground, and what limbs that do the same have in common.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "app/auto/planned_trail.h"
#include "app/auto/poses_of_strokes.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

/// The boxer whose arms are turned forwards by these angles, mirrored on the right.
Document turnedArms(const std::vector<std::pair<double, double>>& left,
                    const std::vector<std::pair<double, double>>& right) {
  const Document boxer = test::boxer();
  std::vector<Track> tracks;
  for (const bool isLeft : {true, false}) {
    tracks.push_back(turnsOf(boxer, isLeft ? "left-arm" : "right-arm"));
    for (const auto& [frame, angle] : isLeft ? left : right) {
      addKey(tracks.back(), frame, glm::angleAxis(isLeft ? -angle : angle, Vec3(0.0, 1.0, 0.0)));
    }
  }
  return withTracks(boxer, tracks);
}

rig::Moment momentOf(const char* limb, rig::MomentKind kind, double start, double tip, double strength) {
  return {limb, kind, start, tip, tip, strength};
}

rig::Moment strike(const char* limb, double start, double tip, double strength = 20.0) {
  return momentOf(limb, rig::MomentKind::stroke, start, tip, strength);
}

const rig::TrailSettings& settingsOf(const AutoPlan& plan, const char* limb) {
  const auto found = std::ranges::find(plan.trails, std::string(limb),
                                       [](const PlannedTrail& planned) { return planned.trail.limb; });
  REQUIRE(found != plan.trails.end());
  return found->trail.settings;
}

double letGoAt(const rig::TrailSettings& settings) {
  return settings.endFrame + settings.lingerFrames;
}

/// The stepper with a right leg that does what the left one does.
Document hopper() {
  const Document document = twoLeggedStepper();
  std::vector<Track> tracks(2, *document.clips->front().tracks.front());
  tracks[1].node = findLimb(document, "right-leg")->joints.front();
  return withTracks(document, tracks);
}

/// A ground of three frames on which a limb of one bone, a leg or an arm beside a spine, is as told.
struct PosedLimb {
  Document document = test::boxer();
  ClipGround ground{document};
  rig::Limb limb;

  PosedLimb(rig::LimbKind kind, const std::vector<std::vector<Vec3>>& poses) {
    document.body.height = 1.0;
    limb.kind = kind;
    limb.side = rig::LimbSide::left;
    limb.id = "limb";
    ground.limbs = {limb, *findLimb(document, "spine")};
    ground.lastFrame = static_cast<double>(poses.size()) - 1.0;
    ground.turnFrames = ground.lastFrame;
    ground.lowestVertices.assign(poses.size(), 0.3);
    for (const std::vector<Vec3>& pose : poses) {
      ground.places.push_back({pose, {Vec3(0.0, 1.0, 0.0), Vec3(0.0, 1.5, 0.0)}});
    }
  }
  [[nodiscard]] Vec2 all() const { return {0.0, ground.lastFrame}; }
};

/// An arm whose hand goes away from the body by a metre from frame 0 to 1, at 10 fps, and is so
/// far from it on each frame after that.
struct ReachingArm : PosedLimb {
  explicit ReachingArm(const std::vector<double>& after) : PosedLimb(rig::LimbKind::arm, posesOf(after)) {
    ground.framesPerSecond = 10.0;
  }

private:
  static std::vector<std::vector<Vec3>> posesOf(const std::vector<double>& after) {
    std::vector<double> distances{1.0, 2.0};
    distances.insert(distances.end(), after.begin(), after.end());
    std::vector<std::vector<Vec3>> poses;
    std::ranges::transform(distances, std::back_inserter(poses), [](double distance) {
      return std::vector<Vec3>{Vec3(0.0), Vec3(distance, 0.0, 0.0)};
    });
    return poses;
  }
};

rig::Trail reachingTrail() {
  rig::Trail trail;
  trail.limb = "limb";
  trail.settings.startFrame = 0.0;
  trail.settings.endFrame = 1.0;
  return trail;
}

} // namespace

TEST_CASE("A limb keeps its exaggeration while it holds its pose, and settles in one that it stays in") {
  for (const auto& [back, held] : {std::pair(12.0, 2.0), {16.0, 6.0}, {28.0, 0.0}}) {
    const Document document = turnedArms(
        {{0, 0.0}, {4, 0.0}, {10, 1.4}, {back, 1.4}, {back + 1.0, 1.0}, {back + 8.0, 0.0}, {60, 0.0}},
        {{0, 0.0}, {60, 0.0}});
    const ClipGround ground = clipGround(document, 0);
    const AutoPlan plan = planTrails(ground, {strike("left-arm", 4, 10)}, in("Average"), {});
    const rig::TrailSettings& settings = settingsOf(plan, "left-arm");
    CAPTURE(back);
    CHECK(settings.lingerFrames == held);
    CHECK(*settings.releaseFrames - settings.lingerFrames >= 5.0);
    // What is weak beside a stronger stroke, as the way back to rest, is not held.
    const AutoPlan weak =
        planTrails(ground, {strike("right-arm", 0, 40, 40.0), strike("left-arm", 4, 10)}, in("Average"), {});
    CHECK(settingsOf(weak, "left-arm").lingerFrames == 0.0);
  }
}

TEST_CASE("A clip on held poses holds what goes round for as long, and comes back as suddenly as itself") {
  const auto planned = [](double heldUntil, double backAt, rig::MomentKind kind = rig::MomentKind::cycle) {
    const Document document = turnedArms({{0, 0.0},
                                          {4, 0.0},
                                          {10, 1.4},
                                          {heldUntil, 1.4},
                                          {backAt, 0.0},
                                          {20, 0.0},
                                          {22, 0.8},
                                          {40, 0.0},
                                          {60, 0.0}},
                                         {{0, 0.0}, {60, 0.0}});
    const ClipGround ground = clipGround(document, 0);
    // The next one leaves eight frames for the way back.
    const AutoPlan plan = planTrails(ground,
                                     {momentOf("left-arm", kind, 4, 10, 20.0),
                                      momentOf("left-arm", rig::MomentKind::cycle, 16, 20, 19.0),
                                      momentOf("right-arm", rig::MomentKind::stroke, 30, 40, 60.0)},
                                     in("Average"), {});
    return settingsOf(plan, "left-arm");
  };
  CHECK(planned(13, 14).lingerFrames == 3.0);
  CHECK(*planned(13, 14).releaseFrames == 8.0);
  CHECK(planned(13, 19).lingerFrames == 3.0);
  // With one frame left where the limb is off by then, else with two.
  CHECK(planned(17, 18).lingerFrames == 7.0);
  CHECK(*planned(17, 18).releaseFrames == 8.0);
  CHECK(planned(17, 25).lingerFrames == 6.0);
  CHECK(planned(10, 14).lingerFrames == 0.0);
  // What is struck once beside something stronger is not held.
  CHECK(planned(13, 14, rig::MomentKind::stroke).lingerFrames == 0.0);
}

TEST_CASE("Both sides that strike at once are let go at once, and are back at once") {
  const Document document = turnedArms({{0, 0.0}, {4, 0.0}, {10, 1.4}, {20, 0.0}, {60, 0.0}},
                                       {{0, 0.0}, {4, 0.0}, {12, 1.4}, {20, 0.0}, {60, 0.0}});
  const ClipGround ground = clipGround(document, 0);
  const AutoPlan plan =
      planTrails(ground, {strike("left-arm", 4, 10), strike("right-arm", 4, 12)}, in("Average"), {});
  const rig::TrailSettings& left = settingsOf(plan, "left-arm");
  const rig::TrailSettings& right = settingsOf(plan, "right-arm");
  CHECK(left.endFrame == 10.0);
  CHECK(right.endFrame == 12.0);
  CHECK(letGoAt(left) == letGoAt(right));
  CHECK(windowOf(left).y == windowOf(right).y);
  // Of ways whose returns are not equally long, and that are not held.
  const Document later = turnedArms({{0, 0.0}, {2, 0.0}, {18, 1.4}, {36, 0.0}, {60, 0.0}},
                                    {{0, 0.0}, {4, 0.0}, {20, 1.4}, {36, 0.0}, {60, 0.0}});
  const ClipGround unlike = clipGround(later, 0);
  for (const double rightTip : {18.0, 20.0}) {
    const AutoPlan slow =
        planTrails(unlike, {strike("left-arm", 2, 18), strike("right-arm", 4, rightTip)}, in("Average"), {});
    CHECK(windowOf(settingsOf(slow, "left-arm")).y == windowOf(settingsOf(slow, "right-arm")).y);
  }
}

TEST_CASE("Of two legs that do the same at once, as strongly, none is left behind") {
  const Document document = hopper();
  const ClipGround ground = clipGround(document, 0);
  for (const auto& [strength, isLeft] : {std::pair(18.0, true), {12.0, false}}) {
    const std::vector<rig::Moment> both{strike("left-leg", 12, 20), strike("right-leg", 12, 20, strength)};
    AutoPlan plan = planTrails(ground, both, in("Average"), {{1, "it cannot be"}});
    settle(ground, both, in("Average"), plan);
    CAPTURE(strength, plan.leftOut[0]);
    CHECK((plan.leftOut[0] == "the limb on the other side cannot do the same") == isLeft);
  }
}

TEST_CASE("An arm is bent on purpose where it is bent on the last of its way") {
  const auto isBent = [](const std::vector<double>& elbows) {
    std::vector<std::vector<Vec3>> poses;
    std::ranges::transform(elbows, std::back_inserter(poses), [](double elbow) {
      return std::vector<Vec3>{Vec3(0.0), Vec3(0.4, elbow, 0.0), Vec3(0.8, 0.0, 0.0)};
    });
    const PosedLimb posed(rig::LimbKind::arm, poses);
    return isPosedBent(posed.ground, posed.limb, posed.all(), 1.0);
  };
  CHECK(isBent({0.0, 0.0, 0.0, 0.3, 0.3, 0.0}));
  CHECK_FALSE(isBent({0.3, 0.3, 0.0, 0.0, 0.0, 0.0}));
  CHECK_FALSE(isBent({0.5, 0.5, 0.4, 0.3, 0.1, 0.0})); // a punch, straight when it hits
  CHECK_FALSE(isBent({0.0, 0.0, 0.3, 0.0}));           // on no more than half of it
}

TEST_CASE("An arm is bent where its hand is nearer than 0.85 of its bones, but not where its elbow would be "
          "thrown out") {
  // Two bones of half a metre each, and how far apart their ends are.
  const auto isBent = [](double apart, double scale) {
    const double elbow = std::sqrt(0.25 - 0.25 * apart * apart);
    const std::vector<Vec3> arm{Vec3(0.0), Vec3(0.5 * apart, elbow, 0.0), Vec3(apart, 0.0, 0.0)};
    const PosedLimb posed(rig::LimbKind::arm, std::vector<std::vector<Vec3>>(2, arm));
    return isPosedBent(posed.ground, posed.limb, posed.all(), scale);
  };
  CHECK(isBent(0.84, 1.0));
  CHECK_FALSE(isBent(0.86, 1.0));
  // The elbow is 0.4 from the line between shoulder and hand, and may be 0.7 from it.
  CHECK(isBent(0.6, 1.74));
  CHECK_FALSE(isBent(0.6, 1.76));
}

TEST_CASE("A leg that is drawn up is not lengthened, nor is an arm that folds in before the chest") {
  const auto folds = [](rig::LimbKind kind, const std::vector<Vec3>& ends) {
    std::vector<std::vector<Vec3>> poses;
    std::ranges::transform(ends, std::back_inserter(poses), [](const Vec3& end) {
      return std::vector<Vec3>{Vec3(0.2, 1.4, 0.0), end};
    });
    const PosedLimb posed(kind, poses);
    return foldsIn(posed.ground, posed.limb, posed.all());
  };
  CHECK(folds(rig::LimbKind::leg, {{0.2, 0.4, 0}, {0.2, 0.6, 0}, {0.2, 0.9, 0}}));
  CHECK_FALSE(folds(rig::LimbKind::leg, {{0.2, 0.4, 0}, {0.2, 0.9, 0}, {0.2, 0.5, 0.3}})); // a kick
  CHECK(folds(rig::LimbKind::arm, {{1.2, 1.4, 0}, {0.5, 1.4, 0}, {0.2, 1.4, 0.6}}));
  CHECK_FALSE(folds(rig::LimbKind::arm, {{1.2, 1.4, 0}, {0.9, 1.4, 0.7}, {0.2, 1.4, 0.6}})); // a swing
  CHECK_FALSE(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.5, 1.4, 0}, {0.2, 1.4, 1.0}}));   // a punch
  // To less than six tenths of what it reached, a hand to less than seven tenths of its way to the trunk.
  CHECK(folds(rig::LimbKind::leg, {{0.2, 0.4, 0}, {0.2, 0.5, 0}, {0.2, 0.81, 0}}));
  CHECK_FALSE(folds(rig::LimbKind::leg, {{0.2, 0.4, 0}, {0.2, 0.5, 0}, {0.2, 0.79, 0}}));
  CHECK(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.67, 1.4, 0}, {0.2, 1.4, 0.6}}));
  CHECK_FALSE(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.69, 1.4, 0}, {0.2, 1.4, 0.6}}));
  CHECK(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.5, 1.4, 0}, {0.69, 1.4, 0}}));
  CHECK_FALSE(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.5, 1.4, 0}, {0.71, 1.4, 0}}));
  CHECK_FALSE(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.5, 1.4, 0}, {0.0, 2.3, 0}})); // over the head
  CHECK_FALSE(folds(rig::LimbKind::arm, {{1.0, 1.4, 0}, {0.5, 1.4, 0}, {0.0, 0.2, 0}})); // between the legs
}

TEST_CASE("A leg in the air that does not reach for the ground keeps its foot's height and its knee") {
  const auto isUp = [](const std::vector<Vec3>& ends, double above) {
    std::vector<std::vector<Vec3>> poses;
    std::ranges::transform(ends, std::back_inserter(poses), [](const Vec3& end) {
      return std::vector<Vec3>{Vec3(0.0, 1.0, 0.0), end};
    });
    PosedLimb posed(rig::LimbKind::leg, poses);
    posed.ground.lowestVertices.assign(poses.size(), above);
    return isUpInTheAir(posed.ground, posed.limb, posed.all());
  };
  CHECK(isUp({{0, 0.4, 0}, {0, 0.5, 0.3}}, 0.3));
  CHECK_FALSE(isUp({{0, 0.4, 0}, {0, 0.5, 0.3}}, 0.05)); // on the ground
  CHECK_FALSE(isUp({{0, 0.6, 0}, {0, 0.4, 0.3}}, 0.3));  // reaches for it
  CHECK_FALSE(isUp({{0, 0.4, 0}, {0, 1.2, 0.3}}, 0.3));  // kicks up
  // By more than 0.06 of the height, and no more than a tenth longer than it was.
  CHECK(isUp({{0, 0.4, 0}, {0, 0.35, 0}}, 0.061));
  CHECK_FALSE(isUp({{0, 0.4, 0}, {0, 0.35, 0}}, 0.059));
  CHECK_FALSE(isUp({{0, 0.4, 0}, {0, 0.33, 0}}, 0.061));
  PosedLimb onABox(rig::LimbKind::leg,
                   {{Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.4, 0.0)}, {Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.5, 0.3)}});
  CHECK(isUpInTheAir(onABox.ground, onABox.limb, onABox.all()));
  onABox.ground.stands["other leg"] = {{0.0, 0.0}};
  CHECK(isUpInTheAir(onABox.ground, onABox.limb, onABox.all())); // it leaves the ground before the tip
  onABox.ground.stands["other leg"] = {{0.0, 1.0}};
  CHECK_FALSE(isUpInTheAir(onABox.ground, onABox.limb, onABox.all()));
}

TEST_CASE("An arm that swings past the ground gets longer along it") {
  const auto sweeps = [](double hand, double scale) {
    const PosedLimb posed(rig::LimbKind::arm, {{Vec3(0, 0.8, 0), Vec3(0, 0.8, -0.4)},
                                               {Vec3(0, 0.8, 0), Vec3(0, hand, 0)},
                                               {Vec3(0, 0.8, 0), Vec3(0, 0.7, 0.4)}});
    return sweepsGround(posed.ground, posed.limb, posed.all(), scale);
  };
  CHECK(sweeps(0.45, 2.0));
  CHECK_FALSE(sweeps(0.55, 2.0));
  CHECK_FALSE(sweeps(0.45, 1.5));
  CHECK_FALSE(sweeps(0.15, 2.0)); // It does in the clip.
  PosedLimb caped(rig::LimbKind::arm, {{Vec3(0, 0.8, 0), Vec3(0, 0.8, -0.4)},
                                       {Vec3(0, 0.8, 0), Vec3(0, 0.45, 0)},
                                       {Vec3(0, 0.8, 0), Vec3(0, 0.7, 0.4)}});
  caped.ground.lowestVertex = -0.15; // of a cape that dips below the floor
  CHECK_FALSE(sweepsGround(caped.ground, caped.limb, caped.all(), 2.0));
  caped.ground.floor = 0.0;
  CHECK(sweepsGround(caped.ground, caped.limb, caped.all(), 2.0));
  Document document = turnedArms({{0, 0.0}, {12, 1.4}, {24, 0.0}}, {{0, 0.0}, {24, 0.0}});
  ClipGround ground = clipGround(document, 0);
  const auto isLevel = [&] {
    const rig::Moment swing = momentOf("left-arm", rig::MomentKind::cycle, 0, 12, 9.0);
    return !settingsOf(planTrails(ground, {swing}, in("Average"), {}), "left-arm").axes[1];
  };
  for (LimbPlaces& places : ground.places) {
    places.front().back().y = places.front().front().y - 0.4;
    ground.lowestVertex = places.front().back().y - 0.5 * document.body.height;
  }
  CHECK_FALSE(isLevel());
  ground.lowestVertex += 0.29 * document.body.height;
  CHECK(isLevel());
}

TEST_CASE("An arm that points down and is swept along the ground gets longer along it") {
  const auto isLevel = [](const Vec3& from, const Vec3& to) {
    const PosedLimb posed(rig::LimbKind::arm, {{Vec3(0.0), from}, {Vec3(0.0), to}});
    return goesLevel(posed.ground, posed.limb, posed.all());
  };
  CHECK(isLevel({-0.7, -0.4, 0.0}, {0.2, -0.3, 0.7}));
  CHECK_FALSE(isLevel({-0.7, 0.1, 0.0}, {0.2, 0.0, 0.7}));  // at the height of the shoulder
  CHECK_FALSE(isLevel({-0.7, 0.2, 0.0}, {0.2, -0.3, 0.7})); // goes down
  // By less than a quarter of its way up or down, and down by more than a quarter of its length in the end.
  CHECK(isLevel({-0.5, -0.75, 0.0}, {0.5, -0.5, 0.0}));
  CHECK_FALSE(isLevel({-0.5, -0.77, 0.0}, {0.5, -0.5, 0.0}));
  CHECK(isLevel({-0.97, -0.26, 0.0}, {0.97, -0.26, 0.0}));
  CHECK_FALSE(isLevel({-0.97, -0.24, 0.0}, {0.97, -0.24, 0.0}));
  const Document document = turnedArms({{0, 0.0}, {10, 1.4}, {20, 0.0}}, {{0, 0.0}, {20, 0.0}});
  ClipGround ground = clipGround(document, 0);
  const auto axesOf = [&] {
    return settingsOf(planTrails(ground, {strike("left-arm", 0, 10)}, in("Average"), {}), "left-arm").axes;
  };
  CHECK(axesOf()[1]);
  for (LimbPlaces& places : ground.places) {
    places.front().back().y -= 0.5;
  }
  CHECK_FALSE(axesOf()[1]);
}

TEST_CASE("A beat that comes again is as large each time, and the beat back is its own") {
  const Document document =
      turnedArms({{0, 0.0}, {6, 1.4}, {12, 0.0}, {18, 1.4}, {24, 0.0}, {60, 0.0}}, {{0, 0.0}, {60, 0.0}});
  const ClipGround ground = clipGround(document, 0);
  const std::vector<rig::Moment> beats{momentOf("left-arm", rig::MomentKind::cycle, 0, 6, 9.0),
                                       momentOf("left-arm", rig::MomentKind::cycle, 12, 18, 4.0),
                                       momentOf("left-arm", rig::MomentKind::cycle, 18, 24, 6.0)};
  AutoPlan plan = planTrails(ground, beats, in("Average"), {});
  settle(ground, beats, in("Average"), plan);
  REQUIRE(plan.trails.size() == 3);
  CHECK(plan.trails[0].trail.settings.scale == Approx(plan.trails[1].trail.settings.scale));
  CHECK(plan.trails[0].trail.settings.scale != Approx(plan.trails[2].trail.settings.scale));
  // One that is too feeble to be seen takes nothing from the others.
  std::vector<rig::Moment> feeble = beats;
  feeble[1].strength = 2.0;
  AutoPlan without = planTrails(ground, feeble, in("Subtle"), {});
  settle(ground, feeble, in("Subtle"), without);
  CHECK(std::ranges::any_of(without.trails, [](const PlannedTrail& planned) { return planned.moment == 0; }));
}

TEST_CASE("A plan leaves out what folds in, and takes no leg of a body in the air nearer the ground") {
  const Document document = stepper();
  ClipGround ground = clipGround(document, 0);
  const auto plan = [&] { return planTrails(ground, {strike("left-leg", 12, 20)}, in("Average"), {}); };
  const rig::TrailSettings grounded = settingsOf(plan(), "left-leg");
  CHECK(grounded.axes[1]);
  CHECK(grounded.bend == rig::Bend::straighten);
  ground.lowestVertex = *ground.floor;
  ground.lowestVertices.assign(ground.places.size(), *ground.floor + document.body.height);
  const rig::TrailSettings up = settingsOf(plan(), "left-leg");
  CHECK_FALSE(up.axes[1]);
  CHECK(up.bend == rig::Bend::keep);
  const auto leg = static_cast<std::size_t>(std::ranges::find(ground.limbs, "left-leg", &rig::Limb::id) -
                                            ground.limbs.begin());
  std::vector<Vec3>& points = ground.places[20][leg];
  points.back() = points.front() + 0.5 * (points.back() - points.front());
  CHECK(plan().leftOut[0] == "the limb folds in");
}

TEST_CASE("A foot is on the ground where it is the lowest of the body, and that near the ground") {
  const Document document = twoLeggedStepper();
  const double height = document.body.height;
  const rig::Limb& leg = *findLimb(document, "left-leg");
  ClipGround ground{document, 0};
  ground.lastFrame = 3.0;
  ground.turnFrames = 3.0;
  ground.lowestVertices = {0.0, 0.0, 0.09 * height, 0.11 * height};
  ground.soles["left-leg"] = {0.04 * height, 0.06 * height, 0.13 * height, 0.15 * height};
  CHECK(isOnGround(ground, leg, {0.0, 0.0}));
  CHECK_FALSE(isOnGround(ground, leg, {1.0, 1.0})); // above what is lowest
  CHECK(isOnGround(ground, leg, {2.0, 2.0}));
  CHECK_FALSE(isOnGround(ground, leg, {3.0, 3.0})); // the body is in the air
  CHECK_FALSE(isOnGround(ground, leg, {0.0, 1.0})); // at all frames
  CHECK_FALSE(isOnGround(ground, leg, {3.0, 9.0})); // the last one stays
  ground.soles["left-leg"][3] = ground.lowestVertices[3] = 0.0;
  CHECK(isOnGround(ground, leg, {3.0, 9.0}));
  CHECK_FALSE(isOnGround(ground, *findLimb(document, "left-arm"), {0.0, 0.0}));
  ground.soles["left-leg"][0] = height; // in a loop it goes on at the start
  ground.wraps = true;
  CHECK_FALSE(isOnGround(ground, leg, {3.0, 3.0 + ground.lastFrame}));
  ground.lowestVertices.clear();
  CHECK_FALSE(isOnGround(ground, leg, {3.0, 3.0}));
}

TEST_CASE(
    "The sole of a foot is known at each frame of a clip, and a stroke that would drag it back is left out") {
  const Document document = twoLeggedStepper();
  ClipGround ground = clipGround(document, 0);
  REQUIRE(ground.soles.size() == 2);
  REQUIRE(ground.soles["left-leg"].size() == 51);
  CHECK(ground.soles["left-leg"][25] - ground.soles["left-leg"][0] ==
        Approx(1.0 - std::cos(0.7)).margin(1e-4));
  CHECK(ground.soles["right-leg"][25] == Approx(ground.soles["right-leg"][0]));
  ground.stands.clear();
  ground.slides.clear();
  ground.lowestVertices.assign(51, ground.soles["right-leg"][0]);
  const auto whyNot = [&](rig::MomentKind kind) {
    return planTrails(ground, {momentOf("left-leg", kind, 14.0, 25.0, 20.0)}, in("Opera"), {}).leftOut[0];
  };
  CHECK(whyNot(rig::MomentKind::stroke).empty()); // it comes back through the air
  ground.soles["left-leg"] = ground.soles["right-leg"];
  CHECK(whyNot(rig::MomentKind::stroke) == "the foot would be dragged back along the ground");
  CHECK(whyNot(rig::MomentKind::cycle).empty());
  ground.stands["left-leg"] = {{29.0, 40.0}}; // it is back before it is put down
  CHECK(whyNot(rig::MomentKind::stroke).empty());
  ground.stands.clear();
  ground.soles["left-leg"][30] += 1.0; // a sixth of a second later
  CHECK(whyNot(rig::MomentKind::stroke).empty());
  ground.soles["left-leg"][30] -= 1.0;
  ground.soles["left-leg"][31] += 1.0;
  CHECK_FALSE(whyNot(rig::MomentKind::stroke).empty());
}

TEST_CASE(
    "A struck pose is held while the hand stays within 0.15 of its way, or goes on by 0.3, for less than "
    "0.4 seconds") {
  const auto held = [](const std::vector<double>& after, double mostFrames = 9.0) {
    return heldFor(ReachingArm(after).ground, reachingTrail(), mostFrames);
  };
  CHECK(held({1.86, 1.0}) == 1.0);
  CHECK(held({1.84, 1.0}) == 0.0);
  CHECK(held({2.29, 1.0}) == 1.0);
  CHECK(held({2.31, 1.0}) == 0.0);
  CHECK(held({2.2, 2.2, 1.0}) == 1.0); // What does not go on any more has left its pose.
  CHECK(held({2.0, 2.0, 2.0, 1.0}) == 3.0);
  CHECK(held({2.0, 2.0, 2.0, 1.0}, 2.9) == 2.0);
  CHECK(held({2.0, 2.0, 2.0, 2.0, 1.0}) == 0.0); // It stays in it.
  CHECK(held({2.0, 2.0}) == 0.0);
}

TEST_CASE("What goes round stands still by a thousandth of its way, and comes back in two frames, or in one "
          "where half of its way is gone by then") {
  const auto still = [](const std::vector<double>& after, double mostFrames = 9.0) {
    return stillFor(ReachingArm(after).ground, reachingTrail(), mostFrames);
  };
  CHECK(still({2.0009, 1.0}) == 1.0);
  CHECK(still({2.0011, 1.0}) == 0.0);
  CHECK(still({2.0, 2.0, 2.0, 1.49}, 4.0) == 3.0);
  CHECK(still({2.0, 2.0, 2.0, 1.51}, 4.0) == 2.0);
}

TEST_CASE("A body without legs crawls while the end of its trunk stays within 0.15 of the height from the "
          "ground") {
  const auto isCrawling = [](rig::LimbKind kind, const std::vector<double>& heights, bool hasLegs = false) {
    std::vector<std::vector<Vec3>> poses;
    std::ranges::transform(heights, std::back_inserter(poses), [](double height) {
      return std::vector<Vec3>{Vec3(0.0, 0.5, 0.0), Vec3(0.3, height, 0.0)};
    });
    PosedLimb posed(kind, poses);
    posed.ground.lowest = -0.1;
    if (hasLegs) {
      posed.ground.soles.emplace("left-leg", std::vector<double>());
    }
    return crawls(posed.ground, posed.limb, posed.all());
  };
  CHECK(isCrawling(rig::LimbKind::spine, {0.04, 0.0, 0.04}));
  CHECK_FALSE(isCrawling(rig::LimbKind::spine, {0.06, 0.0, 0.0}));
  CHECK_FALSE(isCrawling(rig::LimbKind::spine, {0.0, 0.06, 0.0}));
  CHECK_FALSE(isCrawling(rig::LimbKind::spine, {0.0, 0.0, 0.06}));
  CHECK_FALSE(isCrawling(rig::LimbKind::arm, {0.04, 0.0, 0.04}));
  CHECK_FALSE(isCrawling(rig::LimbKind::spine, {0.04, 0.0, 0.04}, true));
}

TEST_CASE(
    "Two sides do the same where both start and end within a twelfth of a second or share half of the time, "
    "at most three times as strongly, as a mirror shows it") {
  const Document document = test::boxer();
  ClipGround ground{document, 0};
  ground.limbs = allLimbs(document);
  ground.lastFrame = ground.turnFrames = 30.0;
  // From frame 10 on the left arm points ahead; the right one has gone so many degrees beside that.
  const auto strikeAside = [&](double degrees) {
    const double angle = degrees * pi / 180.0;
    const Vec3 way = std::cos(angle) * Vec3(0.6, 0.0, 0.6) + std::sin(angle) * Vec3(0.0, 0.8485, 0.0);
    ground.places.clear();
    for (int frame = 0; frame <= 30; ++frame) {
      LimbPlaces places;
      for (const rig::Limb& limb : ground.limbs) {
        const double side = limb.id == "left-arm" ? 1.0 : -1.0;
        const Vec3 base(0.2 * side, 1.5, 0.0);
        const Vec3 struck = limb.id == "left-arm" ? Vec3(-0.6, 0.0, 0.6) : way;
        places.push_back({base, base + Vec3(0.6 * side, 0.0, 0.0) + (frame < 10 ? Vec3(0.0) : struck)});
      }
      ground.places.push_back(places);
    }
  };
  strikeAside(0.0);
  const rig::Moment left = strike("left-arm", 4, 12, 6.0);
  const auto withRight = [&](double start, double tip, double strength) {
    return arePartners(ground, left, strike("right-arm", start, tip, strength));
  };
  CHECK(withRight(6.4, 12.0, 6.0));
  CHECK_FALSE(withRight(6.6, 12.0, 6.0));
  CHECK(withRight(4.0, 20.0, 6.0)); // Half of the longer one is at the same time.
  CHECK_FALSE(withRight(4.0, 20.2, 6.0));
  const rig::Moment quick = strike("left-arm", 9, 10, 6.0);
  CHECK(arePartners(ground, quick, strike("right-arm", 9, 12.4, 6.0)));
  CHECK_FALSE(arePartners(ground, quick, strike("right-arm", 9, 12.6, 6.0)));
  CHECK(withRight(4.0, 12.0, 17.9));
  CHECK_FALSE(withRight(4.0, 12.0, 18.1));
  CHECK(withRight(4.0, 12.0, 2.01));
  CHECK_FALSE(withRight(4.0, 12.0, 1.99));
  // What goes round is done in turn.
  CHECK_FALSE(withRight(0.0, 25.0, 6.0));
  CHECK(arePartners(ground, momentOf("left-arm", rig::MomentKind::cycle, 4, 12, 6.0),
                    momentOf("right-arm", rig::MomentKind::cycle, 0, 25, 6.0)));
  for (const char* const none : {"left-arm", "spine", "tail"}) {
    CHECK_FALSE(arePartners(ground, left, strike(none, 4, 12, 6.0)));
    CHECK_FALSE(arePartners(ground, strike(none, 4, 12, 6.0), left));
  }
  strikeAside(59.0);
  CHECK(withRight(4.0, 12.0, 6.0));
  strikeAside(61.0);
  CHECK_FALSE(withRight(4.0, 12.0, 6.0));
}
