#include <algorithm>
#include <functional>
#include <utility>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/motion/solve.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

using Part = std::pair<const char*, std::function<void(Trail&)>>;

MotionState solvedAfter(const MovingBiped& moving, const Trail& trail, const MotionState& before) {
  MotionInput input = motionInput(moving, {trail});
  input.previous = &before;
  return solveMotion(input);
}

MotionState solvedOnSameClip(const MovingBiped& moving, const Trail& trail, const MotionState& before) {
  MotionInput input = motionInput(moving, {trail});
  input.sameClip = &before;
  return solveMotion(input);
}

// A trail of which no setting is without effect.
Trail busyTrail() {
  Trail trail = connectedTrail("left-arm", 4.0, 12.0, 2.0);
  trail.settings.space = TrailSpace::view;
  trail.settings.viewAxes = glm::mat3_cast(axisAngle(glm::normalize(Vec3(1.0, 2.0, 3.0)), 0.7));
  trail.settings.spheres = {{7.3, Vec3(0.0, 0.1, 0.05), {}}};
  return trail;
}

// One change for each member of the settings: this binding has to name them all.
std::vector<Part> partsOfSettings() {
  [[maybe_unused]] const auto& [start, end, scale, axes, pivot, space, viewAxes, reference, bend, remap,
                                easeIn, easeOut, stretchSwitch, volume, release, linger, overshoot, pull,
                                turnLimit, blend, stay, turnEnd, stop, sight, spheres] = TrailSettings{};
  const std::vector<std::pair<const char*, std::function<void(TrailSettings&)>>> changes{
      {"start", [](TrailSettings& s) { s.startFrame = 2.0; }},
      {"end", [](TrailSettings& s) { s.endFrame = 14.0; }},
      {"scale", [](TrailSettings& s) { s.scale = 3.0; }},
      {"axes",
       [](TrailSettings& s) {
         s.axes = {true, false, true};
       }},
      {"pivot", [](TrailSettings& s) { s.pivot = Pivot::end; }},
      {"space", [](TrailSettings& s) { s.space = TrailSpace::base; }},
      {"axes of the view", [](TrailSettings& s) { s.viewAxes = Mat3(1.0); }},
      {"reference", [](TrailSettings& s) { s.reference = Reference::rest; }},
      {"bend", [](TrailSettings& s) { s.bend = Bend::straighten; }},
      {"remap", [](TrailSettings& s) { s.remap = RemapKind::linear; }},
      {"ease in",
       [](TrailSettings& s) {
         s.easeIn = {0.3, 0.2};
       }},
      {"ease out",
       [](TrailSettings& s) {
         s.easeOut = {0.3, 0.8};
       }},
      {"stretch", [](TrailSettings& s) { s.stretchSwitch = 0.5; }},
      {"volume", [](TrailSettings& s) { s.volume = 0.5; }},
      {"release", [](TrailSettings& s) { s.releaseFrames = 3.0; }},
      {"linger", [](TrailSettings& s) { s.lingerFrames = 2.0; }},
      {"overshoot", [](TrailSettings& s) { s.overshoot = 0.5; }},
      {"pull", [](TrailSettings& s) { s.pull = false; }},
      {"turn limit", [](TrailSettings& s) { s.turnLimitDegrees = 5.0; }},
      {"blend", [](TrailSettings& s) { s.blend = 1.0; }},
      {"stays in the world", [](TrailSettings& s) { s.stayInWorld = true; }},
      {"turns the end", [](TrailSettings& s) { s.turnEnd = true; }},
      {"stop",
       [](TrailSettings& s) {
         s.stopAt = StopPlane{Vec3(0.0, 0.5, 0.0), Vec3(0.0, -1.0, 0.0)};
       }},
      {"sight",
       [](TrailSettings& s) {
         s.sight.camera = "front";
         s.sight.asSeen = true;
       }},
      {"spheres", [](TrailSettings& s) { s.spheres.clear(); }},
  };
  std::vector<Part> parts;
  parts.reserve(changes.size());
  for (const auto& [name, change] : changes) {
    parts.emplace_back(name, [change = change](Trail& trail) { change(trail.settings); });
  }
  return parts;
}

// What of a trail beside its settings is solved.
std::vector<Part> partsOfTrail() {
  return {{"limb", [](Trail& trail) { trail.limb = "right-arm"; }},
          {"connected", [](Trail& trail) { trail.connected = false; }},
          {"frames of spheres",
           [](Trail& trail) {
             trail.controlFrames = {6.0, 9.0};
           }},
          {"id", [](Trail& trail) { trail.id += 1; }},
          {"nothing", [](Trail& /*trail*/) {}}};
}

void checkSamples(const std::vector<LimbSample>& kept, const std::vector<LimbSample>& fresh) {
  REQUIRE(kept.size() == fresh.size());
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    CHECK(kept[i].timeSeconds == fresh[i].timeSeconds);
    CHECK(kept[i].base == fresh[i].base);
    CHECK(kept[i].end == fresh[i].end);
    CHECK(kept[i].reference == fresh[i].reference);
  }
}

void checkSame(const PathTimes& kept, const PathTimes& fresh) {
  CHECK(kept.samples == fresh.samples);
  CHECK(kept.between == fresh.between);
  CHECK(kept.keys == fresh.keys);
  CHECK(kept.spacing.keysPerSecond == fresh.spacing.keysPerSecond);
  CHECK(kept.spacing.isDense == fresh.spacing.isDense);
  CHECK(kept.nextKeySeconds == fresh.nextKeySeconds);
}

void checkSame(const MovingBiped& moving, const MotionState& kept, const MotionState& fresh) {
  REQUIRE(kept.trails.size() == 1);
  REQUIRE(fresh.trails.size() == 1);
  const SolvedTrail& one = kept.trails.front();
  const SolvedTrail& other = fresh.trails.front();
  checkSamples(one.path.samples, other.path.samples);
  checkSamples(one.path.between, other.path.between);
  CHECK(one.path.ratios == other.path.ratios);
  CHECK(one.path.axes == other.path.axes);
  checkSame(one.times, other.times);
  CHECK(one.controlFrames == other.controlFrames);
  CHECK(one.windowStartSeconds == other.windowStartSeconds);
  CHECK(one.windowEndSeconds == other.windowEndSeconds);
  CHECK(one.trail == other.trail);
  for (double frame = 0.0; frame <= 20.0; frame += 2.5) {
    CHECK(atFrame(moving, kept, frame).worlds == atFrame(moving, fresh, frame).worlds);
  }
}

} // namespace

TEST_CASE("a trail that changed in any part is solved from the motion before as it is without that") {
  const MovingBiped moving = punchingBiped();
  const MotionState before = solved(moving, {busyTrail()});
  std::vector<Part> parts = partsOfSettings();
  const std::vector<Part> others = partsOfTrail();
  parts.insert(parts.end(), others.begin(), others.end());
  for (const auto& [name, change] : parts) {
    INFO(name);
    Trail changed = busyTrail();
    change(changed);
    const MotionState fresh = solved(moving, {changed});
    checkSame(moving, solvedAfter(moving, changed, before), fresh);
    checkSame(moving, solvedOnSameClip(moving, changed, before), fresh);
    // And back.
    checkSame(moving, solvedAfter(moving, busyTrail(), fresh), before);
  }
}

TEST_CASE("a limb of the same name that has other joints has the times of its own keys") {
  MovingBiped moving = punchingBiped();
  const auto arm = std::ranges::find(moving.body.limbs, "left-arm", &Limb::id);
  moving.clip.tracks.emplace_back(rotationTrack(
      arm->endNode, Interpolation::linear, {{7.0 / 24.0, Quat(1, 0, 0, 0)}, {8.0 / 24.0, Quat(1, 0, 0, 0)}}));
  const MotionState whole = solved(moving, {busyTrail()});
  arm->endNode = arm->joints.back();
  arm->joints.pop_back();
  const MotionState shorter = solved(moving, {busyTrail()});
  CHECK(whole.trails.front().times.keys.size() == shorter.trails.front().times.keys.size() + 2);
  checkSame(moving, solvedOnSameClip(moving, busyTrail(), whole), shorter);
}

TEST_CASE("every part of what a path is made from makes another path") {
  const PathKey key{"left-arm", 4.0, 12.0, Pivot::start, TrailSpace::world, Mat3(1.0)};
  const auto differs = [&](auto&& change) {
    PathKey other = key;
    change(other);
    return other != key;
  };
  // This binding has to name all parts.
  [[maybe_unused]] const auto& [limb, start, end, pivot, space, axes] = key;
  CHECK(differs([](PathKey& other) { other.limb = "right-arm"; }));
  CHECK(differs([](PathKey& other) { other.startFrame = 5.0; }));
  CHECK(differs([](PathKey& other) { other.endFrame = 11.0; }));
  CHECK(differs([](PathKey& other) { other.pivot = Pivot::end; }));
  CHECK(differs([](PathKey& other) { other.space = TrailSpace::view; }));
  CHECK(differs([](PathKey& other) { other.axes = Mat3(2.0); }));
  CHECK_FALSE(differs([](PathKey& /*other*/) {}));
}
