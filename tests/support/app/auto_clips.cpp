#include "tests/support/app/auto_clips.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/evaluate/clip_moments.h"
#include "rig/trail/release.h"
#include "tests/support/app/boxer.h"
#include "tests/support/nodes.h"

namespace stretch::test {

using namespace stretch::app;

namespace {

// Forwards over the first third of a turn, back over the rest: 0 to 1 and 0 again.
double swing(double turns) {
  const double phase = turns - std::floor(turns);
  return phase < 0.3 ? rig::smoothstep(phase / 0.3) : 1.0 - rig::smoothstep((phase - 0.3) / 0.7);
}

} // namespace

AutoSettings in(const char* name, double strength) {
  const rig::Style* const style = rig::styleNamed(rig::builtInStyles(), name);
  REQUIRE(style != nullptr);
  return {*style, strength};
}

AutoClip exaggerated(const Document& document, const AutoSettings& settings) {
  return exaggerateClip(document, 0, momentsOf(document, 0), settings);
}

const AutoMoment& strongest(const AutoClip& made) {
  REQUIRE_FALSE(made.moments.empty());
  return made.moments.front();
}

const AutoMoment& momentAt(const AutoClip& made, const char* limb, double tip) {
  const auto found = std::ranges::find_if(made.moments, [&](const AutoMoment& one) {
    return one.moment.limb == limb && std::abs(one.moment.tipFrame - tip) <= 1.0;
  });
  REQUIRE(found != made.moments.end());
  return *found;
}

void addKey(Track& track, double frame, const Quat& turn) {
  track.times.push_back(static_cast<float>(frame / 30.0));
  for (const double value : {turn.x, turn.y, turn.z, turn.w}) {
    track.values.push_back(static_cast<float>(value));
  }
}

Track turnsOf(const Document& document, const char* limb) {
  Track track;
  track.node = findLimb(document, limb)->joints.front();
  track.channel = Channel::rotation;
  track.width = 4;
  return track;
}

Document withTracks(Document document, std::vector<Track> tracks) {
  Clip clip = document.clips->front();
  clip.tracks.clear();
  for (Track& track : tracks) {
    clip.endSeconds = static_cast<double>(track.times.back());
    clip.tracks.emplace_back(std::move(track));
  }
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  return document;
}

Track turnsOfPunch(const Document& document, const std::string& limb) {
  Track track = turnsOf(document, limb.c_str());
  for (const auto& [frame, angle] : {std::pair(0, 0.0), {5, 0.4}, {10, 1.4}, {20, 0.1}}) {
    addKey(track, frame, glm::angleAxis(angle, Vec3(0.0, limb == "left-arm" ? -1.0 : 1.0, 0.0)));
  }
  return track;
}

Document swinger(int lastKey) {
  constexpr int frames = 24;
  const Document document = test::boxer();
  std::vector<Track> tracks;
  for (const bool isLeft : {true, false}) {
    tracks.push_back(turnsOf(document, isLeft ? "left-arm" : "right-arm"));
    for (int frame = 0; frame <= lastKey; ++frame) {
      const double turns = static_cast<double>(frame) / frames + (isLeft ? 0.0 : 0.5);
      addKey(tracks.back(), frame,
             glm::angleAxis(0.1 + 1.2 * swing(turns), Vec3(0.0, isLeft ? -1.0 : 1.0, 0.0)));
    }
  }
  return withTracks(document, std::move(tracks));
}

Document stepper() {
  Document document = test::boxer();
  Scene scene = *document.scene;
  const NodeIndex thigh = test::addNode(scene, "LeftUpLeg", document.body.hips, {0.1, 0.0, 0.0});
  const NodeIndex shin = test::addNode(scene, "LeftLeg", thigh, {0.0, -0.5, 0.0});
  const NodeIndex foot = test::addNode(scene, "LeftFoot", shin, {0.0, -0.5, 0.0});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  rig::Limb leg;
  static_cast<rig::LimbPlace&>(leg) = rig::biped::leftLeg;
  leg.id = rig::limbName(rig::biped::leftLeg);
  leg.joints = {thigh, shin};
  leg.endNode = foot;
  leg.restLength = 1.0;
  document.body.limbs.push_back(leg);
  Track track = turnsOf(document, "left-leg");
  for (int frame = 0; frame <= 50; ++frame) {
    const double lifted = rig::smoothstep((frame - 10.0) / 15.0) - rig::smoothstep((frame - 25.0) / 15.0);
    addKey(track, frame, glm::angleAxis(0.7 * lifted, Vec3(-1.0, 0.0, 0.0)));
  }
  return withTracks(std::move(document), {track});
}

Document twoLeggedStepper() {
  Document document = stepper();
  Scene scene = *document.scene;
  const NodeIndex thigh = addNode(scene, "RightUpLeg", document.body.hips, {-0.1, 0.0, 0.0});
  const NodeIndex foot = addNode(scene, "RightFoot", thigh, {0.0, -1.0, 0.0});
  document.scene = std::make_shared<const Scene>(std::move(scene));
  rig::Limb leg = *findLimb(document, "left-leg");
  static_cast<rig::LimbPlace&>(leg) = rig::biped::rightLeg;
  leg.id = rig::limbName(rig::biped::rightLeg);
  leg.joints = {thigh};
  leg.endNode = foot;
  document.body.limbs.push_back(leg);
  return document;
}

} // namespace stretch::test
