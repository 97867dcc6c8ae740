#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rig/motion/solve_holds.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/held_biped.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/rig/rekeyed_clip.h"
#include "tests/support/rig/soft_limbs.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct Mover {
  std::string title;
  MovingBiped moving;
  std::vector<std::string> limbs;
};

std::vector<Mover> movers() {
  const std::vector<std::string> limbs{"left-arm", "right-arm", "left-leg", "right-leg", "spine"};
  MovingBiped mixed = punchingBiped(Interpolation::step);
  return {{"straight keys", punchingBiped(Interpolation::linear), limbs},
          {"splines", punchingBiped(Interpolation::cubicSpline), limbs},
          {"steps", std::move(mixed), limbs},
          {"with a bat", bipedWithBat(), limbs},
          {"a horse", pawingHorse(), {"front-left-leg", "hind-left-leg", "neck", "tail"}},
          {"a snake", strikingSnake(), {"spine"}}};
}

Trail trailBy(Row& row, const std::string& limb, int id) {
  Trail trail = connectedTrail(limb, row.between(0.0, 8.0), row.between(10.0, 20.0), row.between(0.4, 3.0));
  trail.id = id;
  TrailSettings& settings = trail.settings;
  settings.axes = {!row.once(5), !row.once(5), !row.once(5)};
  settings.pivot = row.once(3) ? Pivot::end : Pivot::start;
  settings.space =
      row.oneOf(std::array{TrailSpace::world, TrailSpace::root, TrailSpace::base, TrailSpace::view});
  settings.viewAxes = Mat3(Vec3(0.6, 0.0, -0.8), Vec3(0.0, 1.0, 0.0), Vec3(0.8, 0.0, 0.6));
  settings.reference = row.once(3) ? Reference::rest : Reference::pose;
  settings.bend = row.once(2) ? Bend::straighten : Bend::keep;
  settings.remap = row.once(3) ? RemapKind::linear : RemapKind::spline;
  settings.easeIn = {row.once(2) ? 0.0 : row.between(0.0, 0.6), row.between(0.0, 0.4)};
  settings.easeOut = {row.once(2) ? 0.0 : row.between(0.0, 0.6), row.between(0.6, 1.0)};
  settings.stretchSwitch = row.once(3) ? row.between(0.0, 1.0) : 1.0;
  settings.volume = row.once(3) ? row.between(0.0, 1.0) : 1.0;
  settings.releaseFrames = row.once(2) ? std::optional(row.between(0.0, 9.0)) : std::nullopt;
  settings.overshoot = row.once(3) ? row.between(0.0, 0.6) : 0.0;
  settings.pull = !row.once(3);
  settings.blend = row.once(3) ? row.between(0.2, 2.0) : 2.0;
  settings.stayInWorld = row.once(4);
  settings.turnEnd = row.once(3);
  if (row.once(5)) {
    settings.stopAt = StopPlane{row.vector(0.8), row.vector(1.0) + Vec3(0.0, 0.0, 1.5)};
  }
  if (row.once(3)) {
    const double middle = 0.5 * (settings.startFrame + settings.endFrame);
    settings.spheres = {
        {middle, row.vector(0.2), row.once(2) ? std::optional(row.vector(0.02)) : std::nullopt}};
  }
  return trail;
}

std::vector<Adjustment> adjustmentsBy(Row& row, const MovingBiped& moving) {
  const ControllerList list = controllersOf(moving.scene, moving.body.limbs, moving.body.hips);
  std::vector<Adjustment> adjustments;
  const auto add = [&](const std::string& id, auto&& fill) {
    if (std::ranges::find(adjustments, id, &Adjustment::controller) != adjustments.end()) {
      return;
    }
    Adjustment adjustment{id, 0, row.once(3) ? std::optional(Vec2(2.0, 21.0)) : std::nullopt, {}};
    for (const double frame : {3.0, 9.0, 16.5}) {
      OffsetKey key;
      key.frame = frame;
      key.interpolation =
          row.oneOf(std::array{KeyInterpolation::automatic, KeyInterpolation::flat, KeyInterpolation::linear,
                               KeyInterpolation::stepped, KeyInterpolation::free});
      fill(key);
      adjustment.keys.push_back(key);
    }
    adjustments.push_back(std::move(adjustment));
  };
  for (std::uint32_t i = row.below(4); i > 0; --i) {
    const Controller& controller = row.oneOf(list.controllers);
    add(controller.id, [&](OffsetKey& key) {
      key.move = controller.moves ? row.vector(0.15) : Vec3(0.0);
      key.turn = controller.turns ? row.vector(0.5) : Vec3(0.0);
      key.moveSlope = controller.moves ? row.vector(0.01) : Vec3(0.0);
      key.turnSlope = controller.turns ? row.vector(0.03) : Vec3(0.0);
    });
  }
  for (std::uint32_t i = row.below(4); i > 0; --i) {
    const Attribute& attribute = row.oneOf(list.attributes);
    add(attribute.id, [&](OffsetKey& key) {
      key.value = row.between(attribute.minimum, attribute.maximum);
      key.valueSlope = 0.0;
    });
  }
  return adjustments;
}

HoldTime timeBy(Row& row) {
  return heldOver(row.between(2.0, 8.0), row.between(10.0, 18.0), row.between(0.0, 2.0),
                  row.between(0.0, 4.0));
}

Holds holdsBy(Row& row, const Mover& mover) {
  Holds holds;
  if (mover.limbs.size() < 2) {
    return holds;
  }
  if (row.once(3)) {
    Pin pin = pinAt(mover.limbs[1], timeBy(row), row.between(0.0, 24.0));
    pin.turns = !row.once(3);
    pin.stretch = row.once(2) ? row.between(0.0, 1.0) : 1.0;
    holds.pins.push_back(pin);
  }
  if (row.once(3)) {
    Grip grip{mover.limbs[0], mover.limbs[1], 0, timeBy(row), std::nullopt, row.between(0.0, 1.0)};
    grip.relationFrame = row.once(2) ? std::optional(row.between(0.0, 20.0)) : std::nullopt;
    holds.grips.push_back(grip);
  }
  if (mover.moving.node.contains("bat") && !row.once(3)) {
    Prop prop;
    prop.node = "bat";
    prop.time = row.once(2) ? std::optional(timeBy(row)) : std::nullopt;
    prop.boundFrame = row.once(3) ? std::nullopt : std::optional(row.between(0.0, 12.0));
    prop.move = row.vector(0.1);
    prop.turn = row.vector(0.3);
    for (const char* const arm : {"left-arm", "right-arm"}) {
      PropHand hand{arm, {}};
      for (const double frame : {1.0, 8.0, 15.0}) {
        OffsetKey key;
        key.frame = frame;
        key.value = row.between(0.0, 1.0);
        hand.keys.push_back(key);
      }
      prop.hands.push_back(hand);
    }
    prop.stretch = row.between(0.0, 1.0);
    holds.props.push_back(prop);
  }
  return holds;
}

std::vector<LimbWeight> weightsBy(Row& row, const Mover& mover) {
  std::vector<LimbWeight> weights;
  if (!row.once(3)) {
    return weights;
  }
  const std::string limb = row.oneOf(mover.limbs);
  const double along = row.between(-0.2, 0.2);
  const double planted = row.once(2) ? row.between(0.0, 1.0) : 0.0;
  LimbWeight weight = softLimb(mover.moving, limb, [&](double frame) {
    const double wave = std::sin(0.4 * frame);
    return SoftBones{1.0 + along * wave, 1.0 - 0.5 * along * wave, 1.0, Vec3(0.1, 1.0, 0.2), planted, 0.5};
  });
  weight.startSeconds = 2.0 / 24.0;
  weight.fadeInSeconds = row.between(0.0, 0.2);
  weight.fadeOutSeconds = row.between(0.0, 0.2);
  weights.push_back(std::move(weight));
  return weights;
}

std::string vectorText(const Vec3& value) {
  return fmt::format(" {:.4f} {:.4f} {:.4f}", value.x, value.y, value.z);
}

/// Where the ends of all limbs and the hips are, how the ends are turned, and how much everything is
/// stretched.
std::string frameText(const MovingBiped& moving, const FrameState& frame) {
  std::string text = "   hips" + vectorText(Vec3(frame.worlds[at(moving.body.hips)][3]));
  for (const Limb& limb : moving.body.limbs) {
    text += "\n    " + limb.id + vectorText(endPosition(limb, frame.worlds));
    const Quat turn = rotationOf(frame.worlds[at(limb.joints.back())]);
    text += " turned" + vectorText((turn.w < 0.0 ? -1.0 : 1.0) * Vec3(turn.x, turn.y, turn.z));
    if (!frame.stretch.empty()) {
      const Mat3& stretch = frame.stretch[at(limb.joints.front())];
      text += " stretched" + vectorText(Vec3(stretch[0][0], stretch[1][1], stretch[2][2])) +
              vectorText(Vec3(stretch[0][1], stretch[1][2], stretch[2][0]));
    }
  }
  return text + "\n";
}

std::string keysText(const MovingBiped& moving, const MotionState& motion, const RekeyOptions& options) {
  const RekeyedClip keys = rekey(moving.scene, moving.clip, motion, options);
  std::size_t count = 0;
  double times = 0.0;
  double values = 0.0;
  for (const Track& track : keys.tracks) {
    count += track.times.size();
    times += std::accumulate(track.times.begin(), track.times.end(), 0.0);
    values += std::accumulate(track.values.begin(), track.values.end(), 0.0, [](double sum, float value) {
      return sum + std::abs(static_cast<double>(value));
    });
  }
  std::string text = fmt::format("  {} tracks, {} keys, times {:.4f} , values {:.3f}\n", keys.tracks.size(),
                                 count, times, values);
  for (const StretchKeys& stretch : keys.stretches) {
    const auto sum = std::accumulate(stretch.scales.begin(), stretch.scales.end(), Vec3(0.0));
    text += fmt::format("  {} stretched: {} keys, {} axes, scales", moving.scene.nodes[at(stretch.node)].name,
                        stretch.times.size(), stretch.axes.size()) +
            vectorText(sum) + "\n";
  }
  return text;
}

MotionState motionBy(Row& row, const Mover& mover) {
  const MovingBiped& moving = mover.moving;
  std::vector<Trail> trails;
  for (std::size_t i = 0; i < mover.limbs.size(); ++i) {
    if (row.once(i == 0 ? 2 : 4)) {
      trails.push_back(trailBy(row, mover.limbs[i], static_cast<int>(i) + 1));
    }
  }
  MotionInput input = motionInput(moving, trails, row.once(4));
  input.adjustments = adjustmentsBy(row, moving);
  input.holds = holdsBy(row, mover);
  MotionState motion = solveMotion(input);
  setHolds(input, motion);
  setWeight(input, weightsBy(row, mover), motion);
  return motion;
}

std::string motionText(Row& row, const Mover& mover) {
  const MovingBiped& moving = mover.moving;
  const MotionState motion = motionBy(row, mover);
  std::string text;
  for (const SolvedTrail& trail : motion.trails) {
    text +=
        fmt::format("  {} from {:.4f} to {:.4f} , window {:.4f} to {:.4f} , wanted {:.4f} , reached {:.4f}\n",
                    trail.limb.id, trail.startSeconds, trail.endSeconds, trail.windowStartSeconds,
                    trail.windowEndSeconds, trail.tip.wantedLength, trail.tip.reachedLength);
    for (const std::string& warning : trail.warnings) {
      text += "   warns: " + warning + "\n";
    }
  }
  for (const double frame : {2.5, 9.0, 14.25, 20.5}) {
    text += fmt::format("  frame {}\n", frame) + frameText(moving, atFrame(moving, motion, frame));
  }
  RekeyOptions options;
  options.tolerance = 1e-3 * moving.body.height;
  options.places = row.once(5) ? KeyPlaces::everyFrame : KeyPlaces::needed;
  return text + keysText(moving, motion, options);
}

/// The keys of each track that changes, with their signs.
std::string signedKeysText(const MovingBiped& moving, const RekeyedClip& keys) {
  std::string text = fmt::format("  misses {:.5f}\n", keys.largestMiss);
  for (const Track& track : keys.tracks) {
    const auto perKey =
        static_cast<std::size_t>(track.width) * (track.interpolation == Interpolation::cubicSpline ? 3 : 1);
    std::vector<double> sums(perKey, 0.0);
    double times = 0.0;
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      times += static_cast<double>(i + 1) * static_cast<double>(track.times[i]);
      const auto gap = [&](std::size_t from) { // Tangents count by the way to the next key.
        return static_cast<double>(track.times[from + 1]) - static_cast<double>(track.times[from]);
      };
      for (std::size_t k = 0; k < perKey; ++k) {
        const std::size_t part = perKey == 3 * static_cast<std::size_t>(track.width) ? 3 * k / perKey : 1;
        const double length = part == 1   ? 1.0
                              : part == 0 ? (i > 0 ? gap(i - 1) : 0.0)
                                          : (i + 1 < track.times.size() ? gap(i) : 0.0);
        sums[k] += length * static_cast<double>(track.values[i * perKey + k]) * (i % 2 == 0 ? 1.0 : 0.7);
      }
    }
    text += fmt::format("  {} channel {} , {} keys from {:.4f} to {:.4f} , times {:.3f} , values",
                        moving.scene.nodes[at(track.node)].name, static_cast<int>(track.channel),
                        track.times.size(), track.times.front(), track.times.back(), times);
    for (const double sum : sums) {
      text += fmt::format(" {:.3f}", sum);
    }
    text += "\n";
  }
  for (const StretchKeys& stretch : keys.stretches) {
    text += fmt::format("  {} stretched from {:.4f} to {:.4f}", moving.scene.nodes[at(stretch.node)].name,
                        stretch.times.front(), stretch.times.back());
    for (std::size_t i = 0; i < stretch.scales.size(); i += 3) {
      text += vectorText(stretch.scales[i]) + " ,";
    }
    text += "\n";
  }
  return text;
}

/// The clip of a mover with all its keys so much later, at another rate, and here and there a key beside the
/// frames.
Mover later(Mover mover, double seconds, double framesPerSecond) {
  for (CopyOnWrite<Track>& leaf : mover.moving.clip.tracks) {
    leaf.edit([&](Track& track) {
      for (float& time : track.times) {
        time = static_cast<float>(seconds + 1.1 * static_cast<double>(time));
      }
    });
  }
  setEndsFromKeys(mover.moving.clip);
  mover.moving.clip.framesPerSecond = framesPerSecond;
  return mover;
}

} // namespace

TEST_CASE("The keys of motions at any rate, of clips that do not begin at 0, are as they were looked at") {
  std::string text;
  Row row(23);
  const std::vector<Mover> all = movers();
  for (int i = 0; i < 36; ++i) {
    const double rate = row.oneOf(std::array{24.0, 25.0, 30.0, 60.0});
    const Mover mover =
        later(all[static_cast<std::size_t>(i) % all.size()], row.once(3) ? 0.0 : row.between(0.0, 0.4), rate);
    const MotionState motion = motionBy(row, mover);
    RekeyOptions options;
    options.tolerance = 1e-4 * mover.moving.body.height;
    options.places = row.once(2) ? KeyPlaces::everyFrame : KeyPlaces::needed;
    text += fmt::format("{}: {} at {} frames per second\n", i, mover.title, rate) +
            signedKeysText(mover.moving, rekey(mover.moving.scene, mover.moving.clip, motion, options));
  }
  const std::string difference = differenceFromRecord("keys-of-motions", text, 2e-3);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("What trails, controllers, holds and weight make together is as it was looked at") {
  std::string text;
  Row row(11);
  const std::vector<Mover> all = movers();
  for (int i = 0; i < 48; ++i) {
    const Mover& mover = all[static_cast<std::size_t>(i) % all.size()];
    text += fmt::format("{}: {}\n", i, mover.title) + motionText(row, mover);
  }
  const std::string difference = differenceFromRecord("motions", text, 5e-4);
  INFO(difference);
  CHECK(difference.empty());
}
