// How far joints and meshes are from the motion that they are to follow, counted over the whole skeleton and
// by hand.
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/rekey/joint_check.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// The punch with its left hand moved and closed, and channels of some of its joints.
struct Checked {
  MovingBiped moving;
  MotionState motion;
  ExactMotion exact;
  PartKeys keys;

  explicit Checked(MovingBiped biped)
      : moving(std::move(biped)),
        motion(adjusted(moving, {moved("left-hand", Vec3(0.02, 0.05, 0.03)), valued("left-hand.curl", 0.6)})),
        exact(moving.scene, moving.clip, motion) {}

  void addChannel(const std::string& key, Channel channel) {
    keys.channels.push_back({moving.node.at(key), channel, nullptr, false});
  }
  /// A span that stands still where the exact motion has the channel at a time.
  ChannelSpan exactly(std::size_t channel, double timeSeconds) {
    const Vec4 value =
        channelValue(exact.at(timeSeconds).pose, keys.channels[channel].node, keys.channels[channel].channel);
    return {0.0, 1.0, value, value, false, Vec4(0.0), Vec4(0.0)};
  }
  std::vector<ChannelSpan> exactly(double timeSeconds) {
    std::vector<ChannelSpan> spans;
    for (std::size_t i = 0; i < keys.channels.size(); ++i) {
      spans.push_back(exactly(i, timeSeconds));
    }
    return spans;
  }
  double missAt(const std::vector<ChannelSpan>& spans, double timeSeconds) {
    return JointCheck(exact, keys).missAt(keys, spans, timeSeconds);
  }
};

void setValue(ChannelSpan& span, const Vec4& value) {
  span.start = span.end = value;
}

Vec4 turnedBy(const Vec4& value, double radians) {
  const Quat turned = Quat(value.w, value.x, value.y, value.z) * axisAngle(Vec3(0, 0, 1), radians);
  return {turned.x, turned.y, turned.z, turned.w};
}

/// The farthest of all nodes below the channels, with the world of every one made from the topmost down.
double slowMiss(Checked& checked, const std::vector<ChannelSpan>& spans, double timeSeconds) {
  const Scene& scene = checked.moving.scene;
  const FrameState& wanted = checked.exact.at(timeSeconds);
  Pose pose = wanted.pose;
  std::vector<NodeIndex> changed;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const ChangedChannel& channel = checked.keys.channels[i];
    setChannelValue(pose.locals[at(channel.node)], channel.channel,
                    spans[i].at(channel.channel, timeSeconds));
    pose.usesMatrix[at(channel.node)] = false;
    changed.push_back(channel.node);
  }
  const std::vector<Mat4> worlds = worldMatrices(scene, pose);
  double miss = 0.0;
  for (const NodeIndex node : withSubtrees(scene, changed)) {
    const Mat4 apart = worlds[at(node)] - wanted.worlds[at(node)];
    double squares = 0.0;
    for (int i = 0; i < 9; ++i) {
      squares += apart[i / 3][i % 3] * apart[i / 3][i % 3];
    }
    miss = std::max(miss, std::sqrt(glm::dot(Vec3(apart[3]), Vec3(apart[3]))) +
                              checked.exact.reachOf(at(node)) * std::sqrt(squares / 2.0));
  }
  return miss;
}

} // namespace

TEST_CASE("channels that run as the exact motion does miss nothing") {
  Checked checked(punchingBiped());
  for (const char* key : {"upperArm.l", "foreArm.l", "hand.l"}) {
    checked.addChannel(key, Channel::rotation);
  }
  for (const double time : {0.0, 0.3, 0.77, 1.0}) {
    CHECK(checked.missAt(checked.exactly(time), time) < 1e-12);
  }
}

TEST_CASE("a joint that is moved takes along all below it by as much") {
  Checked checked(punchingBiped());
  checked.addChannel("hand.l", Channel::translation);
  std::vector<ChannelSpan> spans = checked.exactly(0.4);
  setValue(spans[0], spans[0].start + Vec4(0.03, -0.04, 0.0, 0.0));
  CHECK(checked.missAt(spans, 0.4) == Approx(0.05));
}

TEST_CASE("a joint that is turned swings the far end of its mesh, and all below it") {
  const auto [key, radians] =
      GENERATE(table<std::string, double>({{"upperArm.l", 0.02}, {"foreArm.l", 0.3}, {"hand.l", -1.1}}));
  Checked checked(punchingBiped());
  checked.addChannel(key, Channel::rotation);
  std::vector<ChannelSpan> spans = checked.exactly(0.4);
  setValue(spans[0], turnedBy(spans[0].start, radians));
  const double chord = 2.0 * std::sin(0.5 * std::abs(radians)); // of the unit circle
  const FrameState& frame = checked.exact.at(0.4);
  const Mat4& hinge = frame.worlds[at(checked.moving.node.at(key))];
  double farthest = 0.0;
  for (const NodeIndex node : withSubtrees(checked.moving.scene, {checked.moving.node.at(key)})) {
    const Vec3 from = positionOf(frame.worlds[at(node)]) - positionOf(hinge);
    const Vec3 axis = glm::normalize(transformVector(hinge, Vec3(0, 0, 1)));
    const double lever = glm::length(from - axis * glm::dot(axis, from));
    farthest = std::max(farthest, chord * (lever + checked.exact.reachOf(at(node))));
  }
  CHECK(checked.missAt(spans, 0.4) == Approx(farthest));
}

TEST_CASE("what is missed is the farthest of all nodes below the channels, however these lie to each other") {
  Row row(29);
  const std::vector<std::string> joints{"clavicle.l", "upperArm.l", "foreArm.l", "hand.l"};
  SyntheticBiped body = namedBody();
  body.shuffled = GENERATE(false, true);
  body.size = GENERATE(1.0, 40.0);
  Checked checked([&] {
    MovingBiped moving = still(body);
    addPunch(moving, Interpolation::linear);
    return moving;
  }());
  for (int i = 0; i < 40; ++i) {
    checked.keys.channels.clear();
    for (const std::string& joint : joints) { // In no order, a joint's parts beside each other or not.
      if (row.once(2)) {
        checked.keys.channels.insert(checked.keys.channels.begin(),
                                     {checked.moving.node.at(joint), Channel::rotation, nullptr, false});
      }
      if (row.once(3)) {
        checked.addChannel(joint, Channel::translation);
      }
      if (row.once(4)) {
        checked.addChannel(joint, Channel::scale);
      }
    }
    const double time = row.between(0.0, 1.0);
    std::vector<ChannelSpan> spans = checked.exactly(time);
    for (ChannelSpan& span : spans) {
      const double wrong = row.once(2) ? 0.2 : 0.0;
      span.start += wrong * Vec4(row.vector(1.0), 0.0);
      span.end = span.start + wrong * Vec4(row.vector(1.0), 0.0);
    }
    CHECK(checked.missAt(spans, time) == Approx(slowMiss(checked, spans, time)).margin(1e-12));
  }
}

TEST_CASE("a check is good for one time after another") {
  Checked checked(punchingBiped());
  checked.addChannel("foreArm.l", Channel::rotation);
  checked.addChannel("hand.l", Channel::translation);
  JointCheck check(checked.exact, checked.keys);
  std::vector<ChannelSpan> spans = checked.exactly(0.5);
  setValue(spans[0], turnedBy(spans[0].start, 0.4));
  for (const double time : {0.2, 0.9, 0.5, 0.2}) {
    CHECK(check.missAt(checked.keys, spans, time) == Approx(slowMiss(checked, spans, time)));
  }
  CHECK(check.missAt(checked.keys, checked.exactly(0.7), 0.7) < 1e-12);
}

TEST_CASE("a node that stands by a matrix of the file keeps it until a channel moves the node") {
  MovingBiped moving = punchingBiped();
  const NodeIndex ring = addNode(moving.scene, "ring", moving.node.at("finger1b.l"), Vec3(0.02, 0.0, 0.0));
  addNode(moving.scene, "gem", ring, Vec3(0.5, 0.0, 0.0));
  Mat4 sheared = toMatrix(moving.scene.nodes[at(ring)].rest);
  sheared[0][1] += 0.4; // No transform tells it.
  moving.scene.nodes[at(ring)].matrix = sheared;
  Checked checked(std::move(moving));
  REQUIRE(checked.exact.at(0.4).pose.usesMatrix[at(ring)]);
  checked.addChannel("hand.l", Channel::translation);
  std::vector<ChannelSpan> spans = checked.exactly(0.4);
  CHECK(checked.missAt(spans, 0.4) < 1e-12);
  setValue(spans[0], spans[0].start + Vec4(0.0, 0.0, 0.25, 0.0));
  CHECK(checked.missAt(spans, 0.4) == Approx(0.25));

  checked.keys.channels = {{ring, Channel::translation, nullptr, false}};
  spans = checked.exactly(0.4);
  setValue(spans[0], Vec4(0.02, 0.0, 0.0, 0.0));
  CHECK(checked.missAt(spans, 0.4) == Approx(0.5 * 0.4)); // Without its shear the gem is not where it was.
}

TEST_CASE("a channel of a node that hangs on nothing is checked as well") {
  Checked checked(punchingBiped());
  const NodeIndex root = checked.moving.scene.roots.front();
  REQUIRE_FALSE(checked.moving.scene.nodes[at(root)].parent.exists());
  checked.keys.channels.push_back({root, Channel::translation, nullptr, false});
  std::vector<ChannelSpan> spans = checked.exactly(0.4);
  setValue(spans[0], spans[0].start + Vec4(0.0, 0.5, 0.0, 0.0));
  CHECK(checked.missAt(spans, 0.4) == Approx(slowMiss(checked, spans, 0.4)));
}
