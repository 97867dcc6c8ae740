#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "rig/limb.h"
#include "rig/motion/solve_steps.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// Length of the limb at the tip over the source's there.
double ratioAtTip(const MovingBiped& moving, const Trail& trail) {
  const MotionState motion = solved(moving, {trail});
  const Limb& limb = moving.limb(trail.limb);
  const double frame = motion.trails.front().tipSeconds * moving.clip.framesPerSecond;
  return lengthOf(limb, atFrame(moving, motion, frame)) / lengthOf(limb, sourceAtFrame(moving, frame));
}

// Part of the way from the first of these places to the last that is passed at each.
std::vector<double> partsOfWay(const std::vector<Vec3>& places) {
  std::vector<double> ways{0.0};
  for (std::size_t i = 1; i < places.size(); ++i) {
    ways.push_back(ways.back() + glm::length(places[i] - places[i - 1]));
  }
  for (double& way : ways) {
    way /= std::max(ways.back(), 1e-12);
  }
  return ways;
}

// How many times as far from its start the path has to get for its tip to be `wanted` away from the base.
double growthTo(double wanted, const Vec3& start, const Vec3& tip, const Vec3& base) {
  double low = 1.0;
  double high = 100.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (glm::length(start + middle * (tip - start) - base) < wanted ? low : high) = middle;
  }
  return low;
}

} // namespace

TEST_CASE("at the tip the limb is as many times as long as the scale says") {
  const MovingBiped moving = punchingBiped();
  for (const std::string limb : {"left-arm", "left-leg"}) {
    for (const Bend bend : {Bend::keep, Bend::straighten}) {
      for (const double scale : {0.5, 2.0, 3.0}) {
        for (const TrailSpace space : {TrailSpace::world, TrailSpace::root, TrailSpace::base}) {
          for (const Pivot pivot : {Pivot::start, Pivot::end}) {
            Trail trail = connectedTrail(limb, 0, 12, scale);
            trail.settings.bend = bend;
            trail.settings.space = space;
            trail.settings.pivot = pivot;
            CAPTURE(limb, bend == Bend::keep, scale, static_cast<int>(space), pivot == Pivot::start);
            CHECK(ratioAtTip(moving, trail) == Approx(scale).epsilon(1e-4));
          }
        }
      }
    }
  }
}

TEST_CASE("the spine and the neck come to their length too") {
  MovingBiped moving = still(namedBody({.spineJoints = 4, .neckJoints = 2}));
  addPunch(moving, Interpolation::linear);
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    for (const double scale : {0.5, 1.5, 2.0}) {
      for (const std::string limb : {"spine", "neck"}) {
        Trail trail = connectedTrail(limb, 0, 12, scale);
        trail.settings.bend = bend;
        CAPTURE(limb, bend == Bend::keep, scale);
        CHECK(ratioAtTip(moving, trail) == Approx(scale).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("the hand is at the drawn trail on every frame of the range") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    for (const double scale : {0.5, 2.0}) {
      Trail trail = connectedTrail("left-arm", 0, 12, scale);
      trail.settings.bend = bend;
      trail.settings.easeIn = {0.4, 0.1};
      const MotionState motion = solved(moving, {trail});
      const DrawnTrail drawn =
          pathsAt(moving.scene, moving.clip, motion, 0, drawnFrames(moving.clip, motion.trails[0], 2));
      for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
        CAPTURE(bend == Bend::keep, scale, drawn.frames[i]);
        const Vec3 hand = endPosition(arm, atFrame(moving, motion, drawn.frames[i]).worlds);
        CHECK(glm::length(hand - drawn.exaggerated[i]) < 1e-5 * moving.body.height);
        CHECK(glm::length(endPosition(arm, sourceAtFrame(moving, drawn.frames[i]).worlds) -
                          drawn.original[i]) < 1e-12);
      }
    }
  }
}

TEST_CASE("the hand gets farther from the start of its path the more of its way it has come") {
  const std::string limb = GENERATE("left-arm", "left-leg");
  const double scale = GENERATE(2.0, 3.0);
  const RemapKind remap = GENERATE(RemapKind::linear, RemapKind::spline);
  CAPTURE(limb, scale, remap == RemapKind::linear);
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail(limb, 0, 12, scale);
  trail.settings.remap = remap;
  const MotionState motion = solved(moving, {trail});
  std::vector<Vec3> path;
  for (int frame = 0; frame <= 12; ++frame) {
    path.push_back(limbPoints(moving.limb(limb), sourceAtFrame(moving, frame).worlds).back());
  }
  const FrameState last = sourceAtFrame(moving, 12);
  const Vec3 base = limbPoints(moving.limb(limb), last.worlds).front();
  const double growth = growthTo(scale * lengthOf(moving.limb(limb), last), path.front(), path.back(), base);
  const std::vector<double> ratios = partsOfWay(path);
  for (std::size_t frame = 0; frame < path.size(); ++frame) {
    CAPTURE(frame);
    const double ratio = ratios[frame];
    const double weight = remap == RemapKind::linear ? ratio : ratio * ratio * (3.0 - 2.0 * ratio);
    const Vec3 wanted = path[frame] + weight * (growth - 1.0) * (path[frame] - path.front());
    const FrameState after = atFrame(moving, motion, static_cast<double>(frame));
    CHECK(glm::length(limbPoints(moving.limb(limb), after.worlds).back() - wanted) < 1e-5);
  }
}

TEST_CASE("with the rest reference the limb is as many rest lengths long") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  Trail trail = connectedTrail("left-arm", 0, 12, 1.5);
  trail.settings.reference = Reference::rest;
  CHECK(lengthOf(arm, atFrame(moving, solved(moving, {trail}), 12)) ==
        Approx(1.5 * arm.restLength).epsilon(1e-4));
}

TEST_CASE("a scale below the smallest is taken as it and reported") {
  const MovingBiped moving = punchingBiped();
  const Trail trail = connectedTrail("left-arm", 0, 12, 0.0);
  CHECK(ratioAtTip(moving, trail) == Approx(smallestScale).epsilon(1e-4));
  REQUIRE_FALSE(solved(moving, {trail}).trails.front().warnings.empty());
}

TEST_CASE("an axis that is off does not move the hand along it") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  Trail trail = connectedTrail("left-arm", 0, 12, 2.5);
  trail.settings.axes = {true, false, true};
  const MotionState motion = solved(moving, {trail});
  for (double frame = 0.0; frame <= 18.0; frame += 0.5) {
    const double before = endPosition(arm, sourceAtFrame(moving, frame).worlds).y;
    CHECK(endPosition(arm, atFrame(moving, motion, frame).worlds).y == Approx(before).margin(1e-5));
  }
  CHECK(ratioAtTip(moving, trail) == Approx(2.5).epsilon(1e-4));
}

TEST_CASE("in the view's space the axes are the camera's") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
  trail.settings.space = TrailSpace::view;
  trail.settings.viewAxes = glm::mat3_cast(axisAngle(glm::normalize(Vec3(1, 2, 3)), 0.7));
  trail.settings.axes = {true, true, false};
  const MotionState motion = solved(moving, {trail});
  const Vec3 moved = endPosition(arm, atFrame(moving, motion, 12).worlds) -
                     endPosition(arm, sourceAtFrame(moving, 12).worlds);
  CHECK(glm::length(moved) > 0.1);
  CHECK(std::abs(glm::dot(moved, trail.settings.viewAxes[2])) < 1e-5);
  CHECK(ratioAtTip(moving, trail) == Approx(2.0).epsilon(1e-4));
}

TEST_CASE("keeping the bend keeps the elbow's angle on every frame") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  for (const double scale : {0.5, 3.0}) {
    const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 12, scale)});
    for (double frame = 0.0; frame <= 18.0; frame += 0.5) {
      CAPTURE(scale, frame);
      const double before = innerAngle(limbPoints(arm, sourceAtFrame(moving, frame).worlds));
      CHECK(innerAngle(limbPoints(arm, atFrame(moving, motion, frame).worlds)) ==
            Approx(before).margin(1e-6));
    }
  }
}

TEST_CASE("a lowered switch lets the hand fall short, pointing at the target") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  Trail trail = connectedTrail("left-arm", 0, 12, 3.0);
  trail.settings.stretchSwitch = 0.5;
  const MotionState motion = solved(moving, {trail});
  const std::vector<Vec3> points = limbPoints(arm, atFrame(moving, motion, 12).worlds);
  const Vec3 target = pathsAt(moving.scene, moving.clip, motion, 0, {12.0}).exaggerated[0];
  CHECK(glm::length(points.back() - points.front()) ==
        Approx(2.0 * lengthOf(arm, sourceAtFrame(moving, 12))).epsilon(1e-4));
  CHECK(angleBetween(points.back() - points.front(), target - points.front()) < 1e-5);
}

TEST_CASE("half the blend is half of the way, for the path and for the limb") {
  const MovingBiped moving = punchingBiped();
  const Limb& arm = moving.limb("left-arm");
  Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
  const Vec3 original = endPosition(arm, sourceAtFrame(moving, 12).worlds);
  const Vec3 full = endPosition(arm, atFrame(moving, solved(moving, {trail}), 12).worlds);
  trail.settings.blend = 1.0;
  const Vec3 half = endPosition(arm, atFrame(moving, solved(moving, {trail}), 12).worlds);
  CHECK(glm::length(half - 0.5 * (original + full)) < 1e-5);
}

TEST_CASE("the hand and the foot keep their orientation, or turn with the limb when asked to") {
  const MovingBiped moving = punchingBiped();
  const auto hand = at(moving.node.at("hand.l"));
  Trail trail = connectedTrail("left-arm", 0, 12, 2.5);
  const auto turnOfHand = [&] {
    const Quat before = rotationOf(sourceAtFrame(moving, 8).worlds[hand]);
    const Quat after = rotationOf(atFrame(moving, solved(moving, {trail}), 8).worlds[hand]);
    return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(before, after))));
  };
  CHECK(turnOfHand() < 1e-6);
  trail.settings.turnEnd = true;
  CHECK(turnOfHand() > 1e-3);
}

TEST_CASE("a new trail starts at the hips where the body travels, else in the world") {
  MovingBiped moving = punchingBiped();
  const NodeIndex hips = moving.body.hips;
  const Limb& arm = moving.limb("left-arm");
  const auto space = [&] { return startingSpace(moving.scene, moving.clip, arm, hips, Vec2(0, 12)); };
  CHECK(space() == TrailSpace::world);
  const int track = findTrack(moving.clip, hips, Channel::translation);
  moving.clip.tracks[static_cast<std::size_t>(track)].edit([](Track& travel) {
    for (float& number : travel.values) {
      number *= 10.0F;
    }
  });
  CHECK(space() == TrailSpace::root);
  CHECK(startingSpace(moving.scene, moving.clip, arm, NodeIndex::none, Vec2(0, 12)) == TrailSpace::world);
  // Outside the clip nothing moves, however far a range goes.
  CHECK(startingSpace(moving.scene, moving.clip, arm, hips, Vec2(-1e30, 1e30)) == space());
  CHECK(startingSpace(moving.scene, moving.clip, arm, hips, Vec2(1e29, 1e30)) == TrailSpace::world);
  // What lies before the clip takes no time from what is looked at.
  const double lateSeconds = 1.1 * longestFrames / moving.clip.framesPerSecond;
  for (CopyOnWrite<Track>& one : moving.clip.tracks) {
    one.edit([&](Track& later) {
      for (float& time : later.times) {
        time += static_cast<float>(lateSeconds);
      }
    });
  }
  setEndsFromKeys(moving.clip);
  CHECK(startingSpace(moving.scene, moving.clip, arm, hips, Vec2(0, 1e30)) == TrailSpace::root);
}

TEST_CASE("a new trail starts at the hips where the body travels within its range, not before or after it") {
  MovingBiped moving = still(namedBody());
  const NodeIndex hips = moving.body.hips;
  const Vec3 stands = moving.scene.nodes[at(hips)].rest.translation;
  const Vec3 arrived = stands + Vec3(0.0, 0.0, 2.0);
  moving.clip.tracks.emplace_back(
      vectorTrack(hips, Channel::translation, Interpolation::linear,
                  {{0.0, stands}, {0.25, stands}, {0.75, arrived}, {1.0, arrived}}));
  moving.clip.tracks.emplace_back(
      rotationTrack(moving.node.at("upperArm.l"), Interpolation::linear,
                    {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, axisAngle(Vec3(0.0, 0.0, 1.0), 1.0)}}));
  setEndsFromKeys(moving.clip);
  const auto space = [&](double startFrame, double endFrame) {
    return startingSpace(moving.scene, moving.clip, moving.limb("left-arm"), hips,
                         Vec2(startFrame, endFrame));
  };
  CHECK(space(0.0, 6.0) == TrailSpace::world);
  CHECK(space(6.0, 18.0) == TrailSpace::root);
  CHECK(space(18.0, 24.0) == TrailSpace::world);
}

TEST_CASE("a body whose hips carry no arm travels as they do") {
  MovingBiped moving = still(namedBody());
  const NodeIndex hips = moving.body.hips;
  const Limb& arm = moving.limb("left-arm");
  const NodeIndex top = moving.scene.nodes[at(arm.joints.front())].parent; // the collar bone
  const NodeIndex before = moving.scene.nodes[at(top)].parent;
  const NodeIndex root = moving.scene.nodes[at(hips)].parent;
  std::erase(moving.scene.nodes[at(before)].children, top);
  moving.scene.nodes[at(top)].parent = root;
  moving.scene.nodes[at(root)].children.push_back(top);
  const Vec3 stands = moving.scene.nodes[at(hips)].rest.translation;
  moving.clip.tracks.emplace_back(vectorTrack(hips, Channel::translation, Interpolation::linear,
                                              {{0.0, stands}, {0.5, stands + Vec3(0.0, 0.0, 2.0)}}));
  setEndsFromKeys(moving.clip);
  CHECK(startingSpace(moving.scene, moving.clip, arm, hips, Vec2(0, 12)) == TrailSpace::root);
}
