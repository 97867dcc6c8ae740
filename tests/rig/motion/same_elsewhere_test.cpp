// A motion that comes later, or of a body that is larger or turned, is the same motion there.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/rotation.h"
#include "tests/support/matrices.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// All that acts on a clip.
struct Work {
  std::vector<Trail> trails;
  std::vector<Adjustment> adjustments;
  Holds holds;
};

struct Setting {
  const char* what;
  std::function<void(Trail&)> change;
};

/// Ways in which the trail of a punch may be set, each of its own.
const std::vector<Setting>& settings() {
  static const std::vector<Setting> all{
      {"plain", [](Trail&) {}},
      {"pivot", [](Trail& t) { t.settings.pivot = Pivot::end; }},
      {"base", [](Trail& t) { t.settings.space = TrailSpace::base; }},
      {"root", [](Trail& t) { t.settings.space = TrailSpace::root; }},
      {"rest", [](Trail& t) { t.settings.reference = Reference::rest; }},
      {"straighten", [](Trail& t) { t.settings.bend = Bend::straighten; }},
      {"ease",
       [](Trail& t) {
         t.settings.easeIn = {0.3, 0.05}, t.settings.easeOut = {0.2, 0.95};
       }},
      {"linear", [](Trail& t) { t.settings.remap = RemapKind::linear; }},
      {"switch", [](Trail& t) { t.settings.stretchSwitch = 0.4; }},
      {"volume", [](Trail& t) { t.settings.volume = 0.3; }},
      {"release", [](Trail& t) { t.settings.releaseFrames = 5.0; }},
      {"linger", [](Trail& t) { t.settings.releaseFrames = 6.0, t.settings.lingerFrames = 2.0; }},
      {"overshoot", [](Trail& t) { t.settings.overshoot = 0.5; }},
      {"level",
       [](Trail& t) {
         t.settings.axes = {true, false, true};
       }},
      {"short", [](Trail& t) { t.settings.scale = 0.3; }},
      {"unpulled", [](Trail& t) { t.settings.scale = 0.3, t.settings.pull = false; }},
      {"turn limit", [](Trail& t) { t.settings.turnLimitDegrees = 10.0; }},
      {"blend", [](Trail& t) { t.settings.blend = 1.2; }},
      {"turned end", [](Trail& t) { t.settings.turnEnd = true; }},
      {"spheres",
       [](Trail& t) {
         t.settings.spheres = {{6.0, Vec3(0.1, 0.2, 0.0), {}}, {9.0, Vec3(0.0, 0.1, 0.1), {}}};
       }},
      {"tangent",
       [](Trail& t) {
         t.settings.spheres = {{7.0, Vec3(0.1, 0.2, 0.0), Vec3(0.02, 0.0, 0.01)}};
       }},
      {"stop",
       [](Trail& t) {
         t.settings.stopAt = StopPlane{Vec3(0.0, 0.0, 0.6), Vec3(0.0, 0.0, 1.0)};
       }},
  };
  return all;
}

Work workWith(const Setting& setting) {
  Work work;
  Trail punch = connectedTrail("left-arm", 4.0, 12.0, 1.6);
  setting.change(punch);
  Trail lean = connectedTrail("spine", 5.0, 13.0, 1.2);
  lean.id = 2;
  work.trails = {punch, lean};
  work.adjustments = {within(moved("hips", Vec3(0.04, -0.08, 0.05), 9.0), 3.0, 18.0),
                      within(turned("right-hand", Vec3(20, 10, -30), 8.0), 5.0, 12.0),
                      moved("left-knee", Vec3(0.2, 0.0, 0.1), 9.0)};
  work.holds.pins = {pinAt("right-arm", heldOver(6.0, 10.0, 2.0, 3.0), 7.0)};
  work.holds.pins[0].stretch = 0.5;
  Grip grip;
  grip.follower = "right-arm";
  grip.leader = "left-arm";
  grip.time = heldOver(15.0, 18.0, 1.0, 2.0);
  grip.relationFrame = 16.0;
  work.holds.grips = {grip};
  return work;
}

MotionState motionOf(const MovingBiped& moving, const Work& work) {
  MotionInput input = motionInput(moving, work.trails);
  input.adjustments = work.adjustments;
  return held(std::move(input), work.holds);
}

/// Farthest that a joint is from where it is wanted, frame by frame and between.
double farthest(const MovingBiped& moving, const Work& work, const MovingBiped& other, const Work& otherWork,
                double laterFrames, const std::function<Vec3(const Vec3&)>& wanted) {
  const MotionState motion = motionOf(moving, work);
  const MotionState otherMotion = motionOf(other, otherWork);
  double miss = 0.0;
  for (double frame = 0.25; frame < 24.0; frame += 1.75) {
    const FrameState here = atFrame(moving, motion, frame);
    const FrameState there = atFrame(other, otherMotion, frame + laterFrames);
    for (const auto& [key, node] : moving.node) {
      miss = std::max(miss, glm::length(wanted(positionOf(here.worlds[at(node)])) -
                                        positionOf(there.worlds[at(other.node.at(key))])));
    }
  }
  return miss;
}

/// Largest difference of any joint's place, turn or stretch.
double apart(const std::vector<FrameState>& one, const std::vector<FrameState>& other) {
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    largest = std::max(largest, largestMatrixMiss(one[i], other[i]));
    for (std::size_t node = 0; node < one[i].stretch.size() && node < other[i].stretch.size(); ++node) {
      largest = std::max(largest, largestDifference(one[i].stretch[node], other[i].stretch[node]));
    }
  }
  return largest;
}

MovingBiped punchingBodyOf(const std::function<void(SyntheticBiped&)>& change) {
  SyntheticBiped body = namedBody();
  change(body);
  MovingBiped moving = still(body);
  addPunch(moving, Interpolation::linear);
  return moving;
}

} // namespace

TEST_CASE("a motion that comes eight frames later is the same, whatever its trail is set to") {
  constexpr double later = 8.0;
  const MovingBiped moving = punchingBiped();
  MovingBiped delayed = moving;
  for (CopyOnWrite<Track>& leaf : delayed.clip.tracks) {
    leaf.edit([](Track& track) {
      for (float& time : track.times) {
        time += static_cast<float>(later / 24.0);
      }
    });
  }
  setEndsFromKeys(delayed.clip);
  for (const Setting& setting : settings()) {
    CAPTURE(setting.what);
    const Work work = workWith(setting);
    Work after = work;
    for (Trail& trail : after.trails) {
      trail.settings.startFrame += later;
      trail.settings.endFrame += later;
      for (SphereOffset& sphere : trail.settings.spheres) {
        sphere.frame += later;
      }
    }
    for (Adjustment& adjustment : after.adjustments) {
      adjustment.keys[0].frame += later;
      adjustment.rangeFrames =
          adjustment.rangeFrames ? std::optional(*adjustment.rangeFrames + Vec2(later)) : std::nullopt;
    }
    after.holds.pins[0].time.rangeFrames += Vec2(later);
    after.holds.pins[0].atFrame += later;
    after.holds.grips[0].time.rangeFrames += Vec2(later);
    *after.holds.grips[0].relationFrame += later;
    CHECK(farthest(moving, work, delayed, after, later, [](const Vec3& place) { return place; }) < 1e-5);
  }
}

TEST_CASE("a body ten times as large moves ten times as far, whatever its trail is set to") {
  constexpr double size = 10.0;
  const MovingBiped moving = punchingBiped();
  MovingBiped large = punchingBodyOf([](SyntheticBiped& body) { body.size = size; });
  for (CopyOnWrite<Track>& leaf : large.clip.tracks) {
    if (leaf->channel == Channel::translation) {
      const Vec3 restLarge = large.scene.nodes[at(leaf->node)].rest.translation;
      leaf.edit([&](Track& track) { // Its way as well.
        for (std::size_t i = 0; i < track.values.size(); ++i) {
          const auto rest = static_cast<float>(restLarge[i % 3]);
          track.values[i] = rest + static_cast<float>(size) * (track.values[i] - rest);
        }
      });
    }
  }
  for (const Setting& setting : settings()) {
    CAPTURE(setting.what);
    const Work work = workWith(setting);
    Work larger = work;
    for (Trail& trail : larger.trails) {
      for (SphereOffset& sphere : trail.settings.spheres) {
        sphere.offset *= size;
        sphere.tangent = sphere.tangent ? std::optional(size * *sphere.tangent) : std::nullopt;
      }
      if (trail.settings.stopAt) {
        trail.settings.stopAt->point *= size;
      }
    }
    for (Adjustment& adjustment : larger.adjustments) {
      adjustment.keys[0].move *= size;
    }
    CHECK(farthest(moving, work, large, larger, 0.0, [](const Vec3& place) { return size * place; }) <
          size * 1e-5);
  }
}

TEST_CASE("a body that is turned about moves as it does, turned, whatever its trail is set to") {
  const Quat turn = axisAngle(Vec3(0, 1, 0), 0.5 * pi);
  const MovingBiped moving = punchingBiped();
  MovingBiped turnedBody = moving;
  const NodeIndex top = turnedBody.scene.roots.front();
  turnedBody.scene.nodes[at(top)].rest.rotation = turn;
  for (const Setting& setting : settings()) {
    CAPTURE(setting.what);
    const Work work = workWith(setting);
    Work other = work;
    for (Trail& trail : other.trails) {
      for (SphereOffset& sphere : trail.settings.spheres) {
        sphere.offset = turn * sphere.offset;
        sphere.tangent = sphere.tangent ? std::optional(turn * *sphere.tangent) : std::nullopt;
      }
      if (trail.settings.stopAt) {
        trail.settings.stopAt->point = turn * trail.settings.stopAt->point;
        trail.settings.stopAt->normal = turn * trail.settings.stopAt->normal;
      }
    }
    for (Adjustment& adjustment : other.adjustments) {
      adjustment.keys[0].move = turn * adjustment.keys[0].move;
      adjustment.keys[0].turn = turn * adjustment.keys[0].turn;
    }
    CHECK(farthest(moving, work, turnedBody, other, 0.0, [&](const Vec3& place) { return turn * place; }) <
          1e-5);
  }
}

TEST_CASE("each setting of a trail makes a motion of its own, and its keys follow that") {
  const MovingBiped moving = punchingBiped();
  std::vector<std::vector<FrameState>> motions;
  for (const Setting& setting : settings()) {
    CAPTURE(setting.what);
    const Trail trail = workWith(setting).trails.front();
    const MotionState motion = solved(moving, {trail});
    motions.emplace_back();
    for (double frame = 0.25; frame < 24.0; frame += 1.75) {
      motions.back().push_back(atFrame(moving, motion, frame));
    }
    CHECK(worstMiss(moving, rekeyedOf(moving, {trail}), 0, 24) < 1e-4 * moving.body.height);
  }
  for (std::size_t i = 0; i < motions.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      CAPTURE(settings()[i].what, settings()[k].what);
      CHECK(apart(motions[i], motions[k]) > 1e-4);
    }
  }
}
