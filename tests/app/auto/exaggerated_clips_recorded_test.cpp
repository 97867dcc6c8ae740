// What whole clips become in each style, from moments to trails, holds and the reasons that are given.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/auto/exaggerate_clip.h"
#include "app/edits/pose/hold_edits.h"
#include "app/evaluate/clip_moments.h"
#include "core/anim/frames.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/nodes.h"
#include "tests/support/recorded.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

/// A boxer with both legs; some hold a stick before the chest, some have a weight on a hand or a foot.
Document drawnBody(Row& row) {
  Document document = twoLeggedStepper();
  document.body.size = 1.8;
  Scene scene = *document.scene;
  Primitive block;
  block.positions = {{-0.05F, -0.05F, 0.0F}, {0.05F, -0.05F, 0.0F}, {0.0F, 0.1F, 0.05F}};
  block.indices = {0, 1, 2};
  scene.meshes.push_back({"Block", {block}, {}});
  if (row.once(3)) {
    const NodeIndex chest = findLimb(document, "spine")->endNode;
    const NodeIndex hand = findLimb(document, "left-arm")->endNode;
    const bool isOnChest = row.once(2);
    const NodeIndex stick = addNode(scene, "Stick", isOnChest ? chest : hand,
                                    isOnChest ? Vec3(row.around(0.3), 0.1, 0.5) : Vec3(0.1, 0.0, 0.0));
    scene.nodes[at(stick)].mesh = 0;
  }
  for (const char* const limb : {"left-arm", "left-leg", "right-leg"}) {
    if (row.once(4)) {
      const NodeIndex weight = addNode(scene, std::string(limb) + " weight",
                                       findLimb(document, limb)->endNode, {0.0, row.around(0.1), 0.05});
      scene.nodes[at(weight)].mesh = 0;
    }
  }
  document.scene = std::make_shared<const Scene>(std::move(scene));
  return document;
}

Vec3 axisOf(Row& row, bool isArm) {
  return glm::normalize(row.vector(0.5) + (isArm ? Vec3(0.0, -1.0, 0.0) : Vec3(-1.0, 0.0, 0.0)));
}

/// A limb that goes to and fro so often in a loop, on the other side half a turn later or at once.
void addSwings(Row& row, const Document& document, std::vector<Track>& tracks, int frames, double rounds) {
  for (const char* const kind : {"arm", "leg"}) {
    if (row.once(4)) {
      continue;
    }
    const bool isArm = kind == std::string("arm");
    const Vec3 axis = axisOf(row, isArm);
    const double width = row.between(0.1, 0.8);
    const double middle = row.around(0.6);
    const double later = row.once(3) ? 0.0 : pi;
    const double sharp = row.between(0.0, 0.8);
    for (const char* const side : {"left", "right"}) {
      const bool isLeft = side == std::string("left");
      tracks.push_back(turnsOf(document, (std::string(side) + "-" + kind).c_str()));
      const Vec3 mirrored = isLeft ? axis : Vec3(axis.x, -axis.y, -axis.z);
      for (int frame = 0; frame <= frames; ++frame) {
        const double turn = 2.0 * pi * rounds * frame / frames + (isLeft ? 0.0 : later);
        addKey(tracks.back(), frame,
               glm::angleAxis(middle + width * std::sin(turn + sharp * std::sin(turn)), mirrored));
      }
    }
  }
}

/// Limbs that wind up, strike, stay there and come back, some on both sides at once.
void addStrikes(Row& row, const Document& document, std::vector<Track>& tracks, int frames) {
  for (const rig::Limb& limb : document.body.limbs) {
    if (row.once(3)) {
      continue;
    }
    tracks.push_back(turnsOf(document, limb.id.c_str()));
    const Vec3 axis = axisOf(row, isArm(limb));
    const double width = isTrunk(limb) ? 0.5 : 1.6;
    double angle = row.around(0.4);
    for (double frame = 0.0; frame < frames; frame += std::floor(row.between(3.0, 12.0))) {
      addKey(tracks.back(), frame, glm::angleAxis(angle, axis));
      angle = row.once(3) ? angle : row.around(width);
    }
    addKey(tracks.back(), frames, glm::angleAxis(angle, axis));
  }
}

Document drawnClip(Row& row) {
  const Document document = drawnBody(row);
  std::vector<Track> tracks;
  const int frames = 20 + static_cast<int>(row.between(0.0, 30.0));
  if (row.once(2)) {
    addSwings(row, document, tracks, frames, row.once(2) ? 1.0 : 2.0);
  } else {
    addStrikes(row, document, tracks, frames);
  }
  if (tracks.empty()) {
    tracks.push_back(turnsOfPunch(document, "right-arm"));
  }
  return withTracks(document, std::move(tracks));
}

Document atRate(Document document, double framesPerSecond) {
  Clip clip = document.clips->front();
  clip.framesPerSecond = framesPerSecond;
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  return document;
}

/// Work that somebody has begun: a trail, holds, weight, on limbs of either side.
Document withWorkBegun(Row& row, Document document) {
  const double last = endInFrames(document.clips->front());
  const auto rangeOf = [&](double longest) {
    const double first = std::floor(row.between(0.0, 0.7 * last));
    return Vec2(first, std::min(last, first + std::floor(row.between(3.0, longest))));
  };
  if (row.once(2)) {
    const Vec2 range = rangeOf(12.0);
    document = withNewTrail(document, {row.once(2) ? "left-arm" : "right-leg", range.x, range.y});
  }
  rig::Holds holds;
  if (row.once(2)) {
    rig::Pin pin;
    pin.limb = row.once(2) ? "left-leg" : "right-arm";
    pin.time = {rangeOf(10.0), {2.0, 2.0}};
    pin.atFrame = pin.time.rangeFrames.x;
    holds.pins = {pin};
  }
  if (row.once(2)) {
    holds.grips = {{"right-arm", "left-arm", 0, {rangeOf(20.0), {1.0, 2.0}}, {}, row.between(0.0, 1.0)}};
  }
  if (const Result<Document> held = placeHolds(document, holds)) {
    document = *held;
  }
  if (row.once(2)) {
    WeightedLimb weight;
    weight.limb = row.once(2) ? "left-arm" : "right-arm";
    weight.settings.amount = row.between(0.3, 1.0);
    document.weights = {weight};
  }
  return document;
}

std::string vectorText(const Vec3& v) {
  return fmt::format("({:.4f} {:.4f} {:.4f})", v.x, v.y, v.z);
}

std::string settingsText(const rig::TrailSettings& s) {
  std::string text = fmt::format(
      "{:.2f} to {:.2f} , scale {:.4f} , axes {:d}{:d}{:d} , space {:d} , bend {:d} , back {:.3f} , "
      "held {:.3f} , turn {:.1f} , beyond {:.2f} , stays {:d}",
      s.startFrame, s.endFrame, s.scale, s.axes[0], s.axes[1], s.axes[2], static_cast<int>(s.space),
      static_cast<int>(s.bend), s.releaseFrames.value_or(-1.0), s.lingerFrames, s.turnLimitDegrees,
      s.overshoot, s.stayInWorld);
  text += s.stopAt ? " , stops at " + vectorText(s.stopAt->point) : "";
  text += s.spheres.empty() ? "" : " , pulled by " + vectorText(s.spheres.back().offset);
  return text;
}

std::string keysText(const std::vector<rig::OffsetKey>& keys) {
  std::string text;
  for (const rig::OffsetKey& key : keys) {
    text += fmt::format(" {:.2f}:{:.2f}", key.frame, key.value);
  }
  return text;
}

std::string clipText(const AutoClip& made, const Document& before) {
  std::string text = made.madeLoop ? "  a loop\n" : "";
  for (const AutoMoment& one : made.moments) {
    text += fmt::format("  {} of {} , {:.2f} to {:.2f} : scale {:.4f}{} , {}\n",
                        rig::momentKindName(one.moment.kind), one.moment.limb, one.moment.startFrame,
                        one.moment.tipFrame, one.scale, one.isLevel ? " , level" : "", one.why);
  }
  for (const rig::Trail& trail : made.document.trails) {
    text += fmt::format("   trail of {} in group {} , {}\n", trail.limb, trail.group,
                        settingsText(trail.settings));
  }
  for (const rig::Grip& grip : made.document.holds.grips) {
    text += fmt::format("   {} on {} , {:.2f} to {:.2f} , blends {:.2f} {:.2f} , stretch {:.2f}\n",
                        grip.follower, grip.leader, grip.time.rangeFrames.x, grip.time.rangeFrames.y,
                        grip.time.blendFrames.x, grip.time.blendFrames.y, grip.stretch);
  }
  for (const rig::Prop& prop : made.document.holds.props) {
    text += "   held: " + prop.node;
    for (const rig::PropHand& hand : prop.hands) {
      text += " " + hand.limb + keysText(hand.keys);
    }
    text += "\n";
  }
  for (const std::string& note : made.notes) {
    text += "   " + note + "\n";
  }
  CHECK(made.document.clips == before.clips);
  return text;
}

/// The same as the second of two clips, of which the first holds still.
Document asSecond(const Document& document) {
  Document both = document;
  Clip still = document.clips->front();
  still.name = "still";
  for (auto& track : still.tracks) {
    track.edit([](Track& keys) {
      keys.times.resize(1);
      keys.values.resize(static_cast<std::size_t>(keys.width));
    });
  }
  both.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{still, document.clips->front()});
  return both;
}

template <typename List>
bool areAllOf(const List& list, int clip) {
  return std::ranges::all_of(list, [&](const auto& thing) { return thing.clip == clip; });
}

} // namespace

TEST_CASE("What drawn clips become in each style is as it was looked at", "[exaggerated-clips]") {
  std::string text;
  Row row(41);
  const std::vector<rig::Style>& styles = rig::builtInStyles();
  for (std::size_t i = 0; i < 48; ++i) {
    const Document document = drawnClip(row);
    const double strength = row.once(3) ? row.between(0.3, 2.0) : 1.0;
    const rig::Style& style = styles[i % styles.size()];
    const AutoClip made = exaggerateClip(document, 0, momentsOf(document, 0), AutoSettings{style, strength});
    text +=
        fmt::format("clip {} , {} , strength {:.2f}\n", i, style.name, strength) + clipText(made, document);
  }
  compareWithRecord("exaggerated-clips", text, 2e-3);
}

TEST_CASE("What drawn clips become in which work was begun is as it was looked at", "[exaggerated-clips]") {
  std::string text;
  Row row(83);
  const std::vector<rig::Style>& styles = rig::builtInStyles();
  for (std::size_t i = 0; i < 32; ++i) {
    Document document = drawnClip(row);
    const double rate = row.oneOf(std::array{24.0, 30.0, 60.0});
    document = atRate(document, rate);
    document = withWorkBegun(row, std::move(document));
    const rig::Style& style = styles[i % styles.size()];
    std::vector<rig::Moment> moments = momentsOf(document, 0);
    AutoSettings settings{style};
    if (moments.size() > 2 && row.once(3)) { // one that gets no trail
      settings.beside = {moments.front()};
      moments.erase(moments.begin());
    }
    const AutoClip made = exaggerateClip(document, 0, moments, settings);
    text +=
        fmt::format("clip {} , {} , {} frames per second\n", i, style.name, rate) + clipText(made, document);
  }
  compareWithRecord("exaggerated-clips-in-work", text, 2e-3);
}

TEST_CASE("The second clip becomes what it would become as the first, and holds there",
          "[exaggerated-clips]") {
  Row row(41);
  const std::vector<rig::Style>& styles = rig::builtInStyles();
  std::size_t held = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    CAPTURE(i);
    const Document document = drawnClip(row);
    const AutoSettings settings{styles[i % styles.size()]};
    const std::vector<rig::Moment> moments = momentsOf(document, 0);
    const AutoClip first = exaggerateClip(document, 0, moments, settings);
    const Document both = asSecond(document);
    CHECK(momentsOf(both, 1) == moments);
    const AutoClip second = exaggerateClip(both, 1, moments, settings);
    CHECK(clipText(second, both) == clipText(first, document));
    CHECK(areAllOf(first.document.trails, 0));
    CHECK(areAllOf(second.document.trails, 1));
    CHECK(areAllOf(second.document.holds.grips, 1));
    CHECK(areAllOf(second.document.holds.props, 1));
    CHECK(areAllOf(second.document.weights, 1));
    CHECK(second.document.loopingClips == (second.madeLoop ? std::vector<int>{1} : std::vector<int>{}));
    held += second.document.holds.props.size();
  }
  CHECK(held > 3);
}
