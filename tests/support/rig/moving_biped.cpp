#include "tests/support/rig/moving_biped.h"
#include "rig/limb.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/naming_schemes.h"

namespace stretch::test {

namespace {

constexpr double framesPerSecond = 24.0;

std::vector<double> numbersOf(const Quat& q) {
  return {q.x, q.y, q.z, q.w};
}
std::vector<double> numbersOf(const Vec3& v) {
  return {v.x, v.y, v.z};
}

void appendAll(const std::vector<double>& numbers, std::vector<float>& out) {
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(out),
                 [](double n) { return static_cast<float>(n); });
}

template <typename Keys>
std::vector<double> tangentAt(const Keys& keys, std::size_t i) {
  const std::size_t before = i > 0 ? i - 1 : i;
  const std::size_t after = i + 1 < keys.size() ? i + 1 : i;
  std::vector<double> a = numbersOf(keys[before].second);
  const std::vector<double> b = numbersOf(keys[after].second);
  const double seconds = std::max(1e-9, keys[after].first - keys[before].first);
  std::transform(a.begin(), a.end(), b.begin(), a.begin(),
                 [&](double x, double y) { return (y - x) / seconds; });
  return a;
}

template <typename Keys>
Track trackOf(NodeIndex node, Channel channel, Interpolation interpolation, const Keys& keys) {
  Track track;
  track.node = node;
  track.channel = channel;
  track.interpolation = interpolation;
  track.width = channel == Channel::rotation ? 4 : 3;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    track.times.push_back(static_cast<float>(keys[i].first));
    if (interpolation == Interpolation::cubicSpline) {
      appendAll(tangentAt(keys, i), track.values);
    }
    appendAll(numbersOf(keys[i].second), track.values);
    if (interpolation == Interpolation::cubicSpline) {
      appendAll(tangentAt(keys, i), track.values);
    }
  }
  return track;
}

Quat turn(const Vec3& axis, double degrees) {
  return axisAngle(glm::normalize(axis), degrees * pi / 180.0);
}

const std::vector<double>& keySeconds() {
  static const std::vector<double> seconds{0.0, 0.25, 0.5, 0.75, 1.0};
  return seconds;
}

// Turns on top of the rest rotation, one for each key time.
void addTurns(MovingBiped& moving, Interpolation interpolation, const std::string& key, const Vec3& axis,
              const std::vector<double>& degrees) {
  const NodeIndex node = moving.node.at(key);
  RotationKeys keys;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    keys.emplace_back(keySeconds()[i], turn(axis, degrees[i]) * moving.scene.nodes[at(node)].rest.rotation);
  }
  moving.clip.tracks.emplace_back(rotationTrack(node, interpolation, keys));
}

} // namespace

const rig::Limb& MovingBiped::limb(const std::string& id) const {
  const auto found = std::ranges::find(body.limbs, id, &rig::Limb::id);
  REQUIRE(found != body.limbs.end());
  return *found;
}

Track rotationTrack(NodeIndex node, Interpolation interpolation, const RotationKeys& keys) {
  return trackOf(node, Channel::rotation, interpolation, keys);
}

Track vectorTrack(NodeIndex node, Channel channel, Interpolation interpolation, const VectorKeys& keys) {
  return trackOf(node, channel, interpolation, keys);
}

SyntheticBiped namedBody(const BodyOptions& options) {
  SyntheticBiped body = makeBody(options);
  applyNames(body, namingSchemes().front());
  return body;
}

MovingBiped still(const SyntheticBiped& body) {
  MovingBiped moving;
  BuiltBiped built = build(body);
  moving.scene = std::move(built.scene);
  moving.node = std::move(built.node);
  moving.body = rig::detectBody(moving.scene);
  moving.clip.name = "still";
  moving.clip.sourceIndex = 0;
  moving.clip.framesPerSecond = framesPerSecond;
  return moving;
}

void addPunch(MovingBiped& moving, Interpolation interpolation) {
  addTurns(moving, interpolation, "upperArm.l", {0.2, 1, 0.3}, {30, 50, -75, -30, 30});
  addTurns(moving, interpolation, "foreArm.l", {0, 1, 0.1}, {-100, -120, -12, -70, -100});
  addTurns(moving, interpolation, "hand.l", {1, 0, 0}, {0, 20, 40, 10, 0});
  addTurns(moving, interpolation, "thigh.l", {1, 0, 0}, {10, -20, -70, -20, 10});
  addTurns(moving, interpolation, "shin.l", {1, 0, 0}, {20, 70, 15, 40, 20});
  addTurns(moving, interpolation, "spine0", {1, 0.4, 0}, {0, -5, 18, 6, 0});
  addTurns(moving, interpolation, "spine1", {1, 0.4, 0}, {0, -5, 12, 6, 0});
  const NodeIndex hips = moving.node.at("hips");
  const Vec3 rest = moving.scene.nodes[at(hips)].rest.translation;
  VectorKeys travel;
  for (const double seconds : keySeconds()) {
    travel.emplace_back(seconds, rest + Vec3(0.02, -0.05 * seconds, 0.3 * seconds));
  }
  moving.clip.tracks.emplace_back(vectorTrack(hips, Channel::translation, interpolation, travel));
  moving.clip.name = "punch";
  moving.clip.startSeconds = 0.0;
  moving.clip.endSeconds = 1.0;
}

MovingBiped punchingBiped(Interpolation interpolation) {
  MovingBiped moving = still(namedBody());
  addPunch(moving, interpolation);
  return moving;
}

Clip keyedOnEveryFrame(const Clip& clip) {
  Clip dense = clip;
  for (CopyOnWrite<Track>& leaf : dense.tracks) {
    leaf.edit([&](Track& track) {
      const Track sparse = track;
      track.interpolation = Interpolation::linear;
      track.times.clear();
      track.values.clear();
      for (double frame = 0.0; frame <= clip.endSeconds * clip.framesPerSecond + 1e-6; frame += 1.0) {
        std::vector<double> value(static_cast<std::size_t>(track.width));
        sampleTrack(sparse, frame / clip.framesPerSecond, value.data());
        track.times.push_back(static_cast<float>(frame / clip.framesPerSecond));
        appendAll(value, track.values);
      }
    });
  }
  return dense;
}

rig::Trail connectedTrail(const std::string& limb, double startFrame, double endFrame, double scale) {
  rig::Trail trail;
  trail.id = 1;
  trail.limb = limb;
  trail.settings.startFrame = startFrame;
  trail.settings.endFrame = endFrame;
  trail.settings.scale = scale;
  trail.exaggerated = true;
  trail.connected = true;
  return trail;
}

rig::MotionInput motionInput(const MovingBiped& moving, const std::vector<rig::Trail>& trails, bool loops) {
  rig::MotionInput input;
  input.scene = &moving.scene;
  input.clip = &moving.clip;
  input.clipIndex = 0;
  input.hips = moving.body.hips;
  input.limbs = moving.body.limbs;
  input.trails = trails;
  input.loops = loops;
  return input;
}

rig::MotionState solved(const MovingBiped& moving, const std::vector<rig::Trail>& trails, bool loops) {
  return rig::solveMotion(motionInput(moving, trails, loops));
}

FrameState atFrame(const MovingBiped& moving, const rig::MotionState& motion, double frame) {
  return rig::evaluateMotion(moving.scene, moving.clip, motion, frame / moving.clip.framesPerSecond);
}

FrameState sourceAtFrame(const MovingBiped& moving, double frame) {
  const double seconds = frame / moving.clip.framesPerSecond;
  return frameOf(moving.scene, samplePose(moving.scene, moving.clip, seconds), seconds);
}

double lengthOf(const rig::Limb& limb, const FrameState& frame) {
  const std::vector<Vec3> points = rig::limbPoints(limb, frame.worlds);
  return glm::length(points.back() - points.front());
}

double largestNodeMiss(const FrameState& a, const FrameState& b) {
  double miss = 0.0;
  for (std::size_t node = 0; node < a.worlds.size(); ++node) {
    miss = std::max(miss, glm::length(positionOf(a.worlds[node]) - positionOf(b.worlds[node])));
  }
  return miss;
}

double largestMatrixMiss(const FrameState& a, const FrameState& b) {
  double miss = 0.0;
  for (std::size_t node = 0; node < a.worlds.size(); ++node) {
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        miss = std::max(miss, std::abs(a.worlds[node][column][row] - b.worlds[node][column][row]));
      }
    }
  }
  return miss;
}

} // namespace stretch::test
