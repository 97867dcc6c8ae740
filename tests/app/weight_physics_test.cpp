#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/keys/rate_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/evaluation_input.h"
#include "app/weight/sample_clip.h"
#include "core/math/rotation.h"
#include "rig/limb.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double turnSeconds = 0.5;

// The boxer with another clip: its left arm whirls in a circle, one turn in turnSeconds, over whole turns;
// `travelPerSecond`: how far the hips get along x in each second.
Document whirling(int turns, double travelPerSecond) {
  constexpr double keysPerSecond = 30.0;
  Document document = test::boxer();
  Track arm;
  arm.node = findLimb(document, "left-arm")->joints.front();
  arm.channel = Channel::rotation;
  arm.width = 4;
  Track hips;
  hips.node = document.body.hips;
  const double seconds = turns * turnSeconds;
  for (int key = 0; key <= static_cast<int>(std::lround(seconds * keysPerSecond)); ++key) {
    const double t = key / keysPerSecond;
    const Quat turn = axisAngle(Vec3(0.0, 0.0, 1.0), 2.0 * pi * t / turnSeconds);
    arm.times.push_back(static_cast<float>(t));
    for (const double value : {turn.x, turn.y, turn.z, turn.w}) {
      arm.values.push_back(static_cast<float>(value));
    }
  }
  hips.times = {0.0F, static_cast<float>(seconds)};
  hips.values = {0.0F, 1.0F, 0.0F, static_cast<float>(travelPerSecond * seconds), 1.0F, 0.0F};
  Clip clip;
  clip.name = "whirl";
  clip.sourceIndex = 0;
  clip.endSeconds = seconds;
  clip.framesPerSecond = keysPerSecond;
  clip.tracks.emplace_back(std::move(arm));
  clip.tracks.emplace_back(std::move(hips));
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  return document;
}

Document heavy(const Document& document, const WeightSettings& settings = {}) {
  const Result<Document> weighted = setWeight(document, {"left-arm", 0, true, settings});
  REQUIRE(weighted);
  return *weighted;
}

// The left arm's length along its bones, in lengths of itself: its joints and their stretch.
double armLengths(const Document& document, double seconds) {
  const FrameState frame = evaluate(document, prepareMotion(document, 0), seconds);
  const std::vector<Vec3> points = rig::limbPoints(*findLimb(document, "left-arm"), frame);
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += glm::length(points[i] - points[i - 1]);
  }
  return length / 0.6;
}

double longest(const Document& document) {
  return weightReports(document, 0).front().longest;
}

} // namespace

TEST_CASE("a loop is in its swing from the first frame on, and ends as it begins") {
  for (const double travel : {0.0, 3.0}) {
    const Document once = heavy(whirling(2, travel));
    const Document loop = setLooping(once, 0, true);
    CAPTURE(travel);
    CHECK(armLengths(loop, 0.0) == Approx(armLengths(loop, 2 * turnSeconds)).epsilon(1e-3));
    // Two turns later the same: what came before the first frame was the end of the clip.
    CHECK(armLengths(loop, 0.0) == Approx(armLengths(loop, turnSeconds)).epsilon(1e-3));
    CHECK(std::abs(armLengths(once, 0.0) - armLengths(once, turnSeconds)) > 0.01);
  }
}

TEST_CASE("at whatever frame rate a clip is read, its limbs give way as much") {
  const auto longestAt = [](double framesPerSecond) {
    Document document = test::boxer(); // whose punch stops short
    setFramesPerSecond(document, framesPerSecond);
    return longest(heavy(document));
  };
  const double wanted = longestAt(24.0);
  REQUIRE(wanted > 1.02);
  for (const double framesPerSecond : {8.0, 12.0, 48.0, 120.0, 240.0}) {
    CAPTURE(framesPerSecond);
    CHECK(longestAt(framesPerSecond) == Approx(wanted).epsilon(0.01));
  }
}

TEST_CASE("At every time a limb gives way the same, whatever rate its clip is counted in") {
  const auto motionAt = [](double framesPerSecond) {
    Document document = whirling(3, 0.0);
    setFramesPerSecond(document, framesPerSecond);
    return heavy(document);
  };
  const Document slow = motionAt(24.0);
  for (const double framesPerSecond : {7.3, 25.0, 60.0, 144.0}) {
    CAPTURE(framesPerSecond);
    const Document fast = motionAt(framesPerSecond);
    for (double seconds = 0.0; seconds < 1.5; seconds += 0.037) {
      CHECK(armLengths(fast, seconds) == Approx(armLengths(slow, seconds)).epsilon(1e-9));
    }
  }
}

TEST_CASE("damping and inertia of a limb's weight reach its motion") {
  WeightSettings loose;
  loose.damping = 0.1;
  WeightSettings damped;
  damped.damping = 2.0;
  CHECK(longest(heavy(whirling(2, 0.0), loose)) > 1.02 * longest(heavy(whirling(2, 0.0), damped)));
  WeightSettings massless;
  massless.inertia = 0.0;
  CHECK(longest(heavy(whirling(2, 0.0), massless)) - 1.0 < 0.5 * (longest(heavy(whirling(2, 0.0))) - 1.0));
}

TEST_CASE("the weight of a range fades where the range begins or ends inside the clip, and only there") {
  const auto fadesOf = [](const Vec2& range) {
    WeightSettings settings;
    settings.rangeFrames = range;
    const rig::MotionState motion = prepareMotion(heavy(whirling(2, 0.0), settings), 0); // 30 frames
    const rig::LimbWeight& weight = motion.weights.front().weight;
    return Vec2(weight.fadeInSeconds, weight.fadeOutSeconds);
  };
  CHECK(fadesOf({0.0, 30.0}) == Vec2(0.0));
  CHECK(glm::distance(fadesOf({3.0, 27.0}), Vec2(0.2, 0.2)) < 1e-9);
  CHECK(glm::distance(fadesOf({3.0, 12.0}), Vec2(0.1, 0.1)) < 1e-9); // a third of it
  CHECK(glm::distance(fadesOf({0.0, 12.0}), Vec2(0.0, 0.4 / 3.0)) < 1e-9);
  CHECK(glm::distance(fadesOf({24.0, 30.0}), Vec2(0.2 / 3.0, 0.0)) < 1e-9);
  CHECK(fadesOf({-9.0, 300.0}) == Vec2(0.0));
}

TEST_CASE(
    "the weight of a range that ends with the clip stays to its end, however its last key was rounded") {
  WeightSettings settings;
  settings.rangeFrames = Vec2(0.0, 20.0);
  const Document document = heavy(test::boxer(), settings);
  const double end = clipOf(document, 0).endSeconds;
  REQUIRE(end > 20.0 / 30.0); // in single precision
  const rig::MotionState motion = prepareMotion(document, 0);
  const rig::LimbWeight& weight = motion.weights.front().weight;
  CHECK(weight.fadeInSeconds == 0.0);
  CHECK(weight.fadeOutSeconds == 0.0);
  CHECK(weight.endSeconds == end);
}

TEST_CASE("a limb is looked at from the clip's first key to its last, as one of a character of 1.75 m") {
  Document document = whirling(2, 1.0);
  document.body.size = 3.5;
  std::vector<Clip> clips = *document.clips;
  clips.front().startSeconds = 0.25;
  clips.front().endSeconds = 0.5;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  const EvaluationInput input = evaluationInput(heavy(document), 0);
  const SampledClip sampled = sampleClip(weightInput(input), prepareMotion(document, 0));
  CHECK(sampled.samplesPerSecond == Approx(120.0));
  REQUIRE(sampled.seconds.size() == 31);
  CHECK(sampled.seconds.front() == 0.25);
  CHECK(sampled.seconds.back() == Approx(0.5));
  REQUIRE(sampled.limbs.size() == 1);
  const SampledClip::OfLimb& arm = sampled.limbs.front();
  REQUIRE(arm.joints.size() == 31);
  for (const std::size_t sample : {0U, 15U, 30U}) {
    const FrameState frame = evaluateOriginal(document, 0, sampled.seconds[sample]);
    const std::vector<Vec3> points = rig::limbPoints(arm.limb, frame);
    REQUIRE(arm.joints[sample].size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(glm::distance(arm.joints[sample][i], 0.5 * points[i]) < 1e-9);
    }
    CHECK(arm.lowest[sample] == Approx(0.5 * points.back().y));
  }
}

TEST_CASE("an arm without a surface has bones six times as long as thick, and hangs a fortieth longer") {
  Document document = test::boxer();
  const rig::Limb arm = *findLimb(document, "left-arm");
  Scene scene = *document.scene;
  scene.nodes[at(arm.joints[1])].rest.translation.x = 0.4;
  scene.nodes[at(arm.endNode)].rest.translation.x = 0.2;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const WeightReport report = weightReports(heavy(document), 0).front();
  const std::vector<double> lengths{0.4 * 1.75, 0.2 * 1.75};
  REQUIRE(report.widths.size() == 2);
  REQUIRE(report.masses.size() == 2);
  for (std::size_t bone = 0; bone < 2; ++bone) {
    const double width = lengths[bone] / 6.0;
    CHECK(report.widths[bone] == Approx(width));
    CHECK(report.masses[bone] == Approx(1000.0 * 0.25 * pi * width * width * lengths[bone]));
  }
  // Each bone bears the half of itself. The upper arm, of four times its section, bears the forearm as well.
  const double forearm = 0.5 * lengths[1];
  const double upperArm = 0.5 * lengths[0] + 0.25 * lengths[1];
  const double mean = (lengths[0] * upperArm + lengths[1] * forearm) / (lengths[0] + lengths[1]);
  CHECK(report.youngModulus == Approx(1000.0 * 9.81 * mean / 0.025));
}
