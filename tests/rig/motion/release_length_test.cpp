// How long ways back last, on straight paths on which each length is known.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/motion/release_length.h"
#include "rig/motion/solve.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

constexpr double releaseRate = 20.0;

/// Frames, units and factors that ways back are counted from.
struct StraightWay {
  double startFrame = 10.0;
  double endFrame = 22.0;
  Pivot pivot = Pivot::start;
  double speed = 3.0;        ///< Of the limb's end seen from its base, along x, units per second.
  double baseSpeed = 0.0;    ///< Of the limb's base, along z.
  Vec3 shift{0.5, 0.0, 0.0}; ///< Exaggeration at the tip, along the axes of the trail's space.
  Vec3 pull{0.0};
  std::vector<double> extraFrames = {}; ///< Beside the whole ones.
};

/// A trail that carries the end of a limb along x, farther by a share of its shift that grows evenly.
SolvedTrail solvedTrail(const StraightWay& way) {
  SolvedTrail solved;
  solved.settings.pivot = way.pivot;
  solved.settings.startFrame = way.startFrame;
  solved.settings.endFrame = way.endFrame;
  solved.times.spacing.keysPerSecond = releaseRate;
  solved.startSeconds = way.startFrame / releaseRate;
  solved.endSeconds = way.endFrame / releaseRate;
  const bool forwards = way.pivot == Pivot::start;
  solved.tipSeconds = forwards ? solved.endSeconds : solved.startSeconds;
  std::vector<double> frames = way.extraFrames;
  for (double frame = way.startFrame; frame <= way.endFrame; frame += 1.0) {
    frames.push_back(frame);
  }
  std::sort(frames.begin(), frames.end());
  for (const double frame : frames) {
    const double seconds = frame / releaseRate;
    const double passed = (frame - way.startFrame) / (way.endFrame - way.startFrame);
    const Vec3 base(4.0, 1.0, way.baseSpeed * seconds);
    solved.path.samples.push_back({seconds, base, base + Vec3(way.speed * seconds, 0.0, 0.0), Vec3(0.0)});
    solved.path.ratios.push_back(forwards ? passed : 1.0 - passed);
  }
  solved.remap = Remap(RemapKind::linear, {}, {});
  solved.tip.moved = true;
  solved.tip.shift = way.shift;
  solved.tip.pull = way.pull;
  return solved;
}

ReleaseLength releaseOf(const SolvedTrail& solved, double clipFrames = 100.0, bool loops = false,
                        double firstFrame = 0.0) {
  Clip clip;
  clip.framesPerSecond = releaseRate;
  clip.startSeconds = firstFrame / releaseRate;
  clip.endSeconds = clipFrames / releaseRate;
  MotionInput input;
  input.clip = &clip;
  input.loops = loops;
  return releaseLength(input, solved);
}

/// Least seconds in which an even stroke is gone back calmly: 1.5 times the way at the stroke's own speed.
double calmOf(double offset, double fastest, double overshoot = 0.0) {
  return 1.5 * (1.0 + overshoot) * offset / fastest;
}

} // namespace

TEST_CASE("a calm way back takes one and a half times the tip's way at the speed of the stroke") {
  StraightWay way;
  way.pivot = GENERATE(Pivot::start, Pivot::end);
  way.speed = GENERATE(1.0, 3.0);
  SolvedTrail solved = solvedTrail(way);
  const double stroke = 12.0 / releaseRate;
  const double fastest = way.speed + (way.pivot == Pivot::start ? 1.0 : -1.0) * 0.5 / stroke;
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.5, std::abs(fastest))));
  solved.settings.overshoot = 0.4;
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.5, std::abs(fastest), 0.4)));
  solved.settings.lingerFrames = 3.0;
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.5, std::abs(fastest), 0.4) + 3.0 / releaseRate));
}

TEST_CASE("the speed of a stroke is that of its exaggerated path, seen from the limb's base") {
  StraightWay way;
  way.baseSpeed = GENERATE(0.0, 5.0, -8.0); // The base's own way is no speed of the limb.
  way.pull = Vec3(0.0, 0.9, 0.0);
  SolvedTrail solved = solvedTrail(way);
  const double seconds = 12.0 / releaseRate;
  const Vec3 offset = way.shift + way.pull;
  const Vec3 velocity = Vec3(way.speed, 0.0, 0.0) + offset / seconds;
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(glm::length(offset), glm::length(velocity))));

  // Along a space that is turned by a quarter about z its x is the world's y.
  solved.path.axes = Mat3(Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1));
  const Vec3 turned(-offset.y, offset.x, 0.0);
  const Vec3 turnedVelocity = Vec3(way.speed, 0.0, 0.0) + turned / seconds;
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(glm::length(turned), glm::length(turnedVelocity))));
}

TEST_CASE("a way back lasts as long at whatever rate the frames of a densely keyed clip are counted") {
  test::MovingBiped moving = test::punchingBiped();
  moving.clip = test::keyedOnEveryFrame(moving.clip);
  const auto secondsAt = [&](double rate) {
    test::MovingBiped counted = moving;
    counted.clip.framesPerSecond = rate;
    const double frames = rate / moving.clip.framesPerSecond;
    const MotionInput input =
        motionInput(counted, {test::connectedTrail("left-arm", 4.0 * frames, 12.0 * frames, 2.0)});
    const SolvedTrail solved = solveMotion(input).trails.front();
    return std::pair(solved.calmReleaseSeconds, solved.release.seconds());
  };
  const auto [calm, release] = secondsAt(24.0);
  REQUIRE(release > 2.5 / 24.0);
  for (const double rate : {48.0, 72.0, 120.0}) {
    CAPTURE(rate);
    CHECK(secondsAt(rate).first == Approx(calm).epsilon(0.02));
    CHECK(std::abs(secondsAt(rate).second - release) < 1.0 / 24.0);
  }
}

TEST_CASE("the fastest part of a stroke tells its speed, wherever it is") {
  const std::size_t place = GENERATE(1U, 6U, 12U); // The first, a middle and the last step.
  StraightWay way;
  way.shift = Vec3(0.0, 0.0, 0.4);
  SolvedTrail solved = solvedTrail(way);
  for (std::size_t i = place; i < solved.path.samples.size(); ++i) {
    solved.path.samples[i].end.y += 1.0;
  }
  const double fastest = glm::length(Vec3(3.0, 1.0 * releaseRate, 0.4 * releaseRate / 12.0));
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.4, fastest)));
}

TEST_CASE("a leap within less than half a frame is counted over the whole of it") {
  const auto [beside, counted] = GENERATE(table<double, double>({{0.4, 1.0}, {0.6, 0.6}}));
  StraightWay way;
  way.extraFrames = {14.0 + beside};
  way.shift = Vec3(0.0, 0.0, 0.4);
  SolvedTrail solved = solvedTrail(way);
  for (std::size_t i = 5; i < solved.path.samples.size(); ++i) {
    solved.path.samples[i].end.y += 1.0; // Between frame 14 and the key beside it.
  }
  const double fastest = glm::length(Vec3(3.0, 1.0 / counted * releaseRate, 0.4 * releaseRate / 12.0));
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.4, fastest)));
}

TEST_CASE("control spheres count in the tip's way back and in the speed of the stroke") {
  SolvedTrail solved = solvedTrail({.shift = Vec3(0.0)});
  const Vec3 perFrame(0.0, 0.7 / 12.0, 0.0); // A ramp, straight in time.
  solved.offsets =
      SphereOffsets({10.0, 22.0}, {{10.0, Vec3(0.0), perFrame}, {22.0, 12.0 * perFrame, perFrame}});
  const double fastest = std::hypot(3.0, perFrame.y * releaseRate);
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.7, fastest)));
  solved.tip.outcome = TipOutcome::nothingToScale; // Spheres alone move it.
  solved.tip.shift = Vec3(9.0);
  CHECK(releaseOf(solved).calmSeconds == Approx(calmOf(0.7, fastest)));
}

TEST_CASE("a limb that stands still has no speed that a way back could be measured by") {
  SolvedTrail solved = solvedTrail({.speed = 0.0, .shift = Vec3(0.0)});
  CHECK(releaseOf(solved).calmSeconds == 0.0);
  solved.settings.lingerFrames = 5.0;
  CHECK(releaseOf(solved).calmSeconds == Approx(5.0 / releaseRate));
}

TEST_CASE("a way back whose length is asked for lasts as long, whatever is calm and where keys lie") {
  const double frames = GENERATE(0.0, 0.5, 7.0, 40.0);
  SolvedTrail solved = solvedTrail({});
  solved.times.nextKeySeconds = 0.3;
  solved.settings.releaseFrames = frames;
  const ReleaseLength length = releaseOf(solved);
  CHECK(length.wantedSeconds == Approx(frames / releaseRate));
  CHECK(length.seconds == Approx(frames / releaseRate));
}

TEST_CASE("a way back goes to the next key where that is three quarters of what is calm away, or more") {
  const Pivot pivot = GENERATE(Pivot::start, Pivot::end);
  SolvedTrail solved = solvedTrail({.pivot = pivot});
  const double calm = releaseOf(solved).calmSeconds;
  REQUIRE(calm > 2.0 / releaseRate);
  for (const double share : {0.751, 1.0, 1.9}) {
    CAPTURE(share);
    solved.times.nextKeySeconds = share * calm;
    CHECK(releaseOf(solved).wantedSeconds == Approx(share * calm)); // Between frames as the key is.
  }
  for (const double share : {0.1, 0.749}) {
    CAPTURE(share);
    solved.times.nextKeySeconds = share * calm;
    CHECK(releaseOf(solved).wantedSeconds * releaseRate == Approx(std::ceil(calm * releaseRate)));
  }
}

TEST_CASE("without a next key a way back takes a third of the range, or what is calm, to a whole frame") {
  const Pivot pivot = GENERATE(Pivot::start, Pivot::end);
  const double beside = GENERATE(0.0, 0.25); // A range that begins and ends between frames.
  CAPTURE(pivot == Pivot::start, beside);
  const auto wantedFrames = [&](double shift) {
    const SolvedTrail solved = solvedTrail({.startFrame = 10.0 + beside,
                                            .endFrame = 22.0 + beside,
                                            .pivot = pivot,
                                            .shift = Vec3(0.0, 0.0, shift)});
    return releaseOf(solved).wantedSeconds * releaseRate;
  };
  // From 22.25 a way back forwards ends on a whole frame after 0.75, one backwards from 10.25 after 0.25.
  const double rest = beside == 0.0 ? 0.0 : pivot == Pivot::start ? 1.0 - beside : beside;
  CHECK(wantedFrames(0.05) == Approx(4.0 + rest));
  const double calmFrames = calmOf(0.9, std::hypot(3.0, 0.9 * releaseRate / 12.0)) * releaseRate;
  REQUIRE(calmFrames > 5.0);
  CHECK(wantedFrames(0.9) == Approx(std::ceil(calmFrames - rest) + rest));
}

TEST_CASE("a way back ends with the clip, where it goes, and on a loop where the range begins again") {
  SolvedTrail solved = solvedTrail({});
  solved.settings.releaseFrames = 500.0;
  CHECK(releaseOf(solved, 30.0).seconds * releaseRate == Approx(8.0)); // from frame 22 to 30
  CHECK(releaseOf(solved, 30.0).wantedSeconds * releaseRate == Approx(500.0));
  CHECK(releaseOf(solved, 30.0, true).seconds * releaseRate == Approx(18.0)); // 30 frames, 12 in the range
  CHECK(releaseOf(solved, 30.0, true, 5.0).seconds * releaseRate == Approx(13.0));
  CHECK(releaseOf(solved, 22.0).seconds == 0.0);
  CHECK(releaseOf(solved, 20.0).seconds == 0.0); // A range past the end of a clip leaves nothing.

  SolvedTrail backwards = solvedTrail({.pivot = Pivot::end});
  backwards.settings.releaseFrames = 500.0;
  CHECK(releaseOf(backwards, 30.0).seconds * releaseRate == Approx(10.0));             // from frame 10 to 0
  CHECK(releaseOf(backwards, 30.0, false, 5.0).seconds * releaseRate == Approx(10.0)); // A clip plays from 0.
  CHECK(releaseOf(backwards, 30.0, false, -5.0).seconds * releaseRate == Approx(15.0));
  CHECK(releaseOf(backwards, 30.0, true).seconds * releaseRate == Approx(18.0));
}

TEST_CASE("no way back of a clip that claims to last for years goes on for years") {
  SolvedTrail solved = solvedTrail({});
  solved.settings.releaseFrames = 1e9;
  CHECK(releaseOf(solved, 1e8).seconds * releaseRate == Approx(100000.0));
  CHECK(releaseOf(solved, 1e8, true).seconds * releaseRate == Approx(100000.0));
}

TEST_CASE("a sphere pulls the pivot where its frame is the one that stays, and not at the tip") {
  SolvedTrail solved = solvedTrail({});
  CHECK_FALSE(pullsPivot(solved, releaseRate));
  const auto pulledAt = [&](double frame) {
    solved.offsets = SphereOffsets({10.0, 16.0, 22.0}, {{frame, Vec3(0.0, 0.1, 0.0), Vec3(0.0)}});
    solved.settings.pivot = Pivot::start;
    const bool atStart = pullsPivot(solved, releaseRate);
    solved.settings.pivot = Pivot::end;
    return std::pair(atStart, pullsPivot(solved, releaseRate));
  };
  CHECK(pulledAt(10.0) == std::pair(true, false));
  CHECK(pulledAt(16.0) == std::pair(false, false));
  CHECK(pulledAt(22.0) == std::pair(false, true));
}

namespace {

Track keysAtFrames(NodeIndex node, const std::vector<double>& frames, Channel channel = Channel::rotation) {
  Track track;
  track.node = node;
  track.channel = channel;
  track.width = channel == Channel::rotation ? 4 : 3;
  for (const double frame : frames) {
    track.times.push_back(static_cast<float>(frame / releaseRate));
    track.values.resize(track.values.size() + static_cast<std::size_t>(track.width), 0.5F);
  }
  return track;
}

/// Frames to the next key of nodes 1 and 2 from the tip of a range; -1 for none.
double framesToKey(const Clip& clip, double startFrame, double endFrame, Pivot pivot) {
  PathKey key;
  key.startFrame = startFrame;
  key.endFrame = endFrame;
  key.pivot = pivot;
  const std::vector<NodeIndex> nodes{NodeIndex(1), NodeIndex(2)};
  const std::optional<double> seconds = secondsToNextKey(clip, key, nodes, keySpacing(clip, nodes));
  return seconds ? *seconds * releaseRate : -1.0;
}

} // namespace

TEST_CASE("the next key is the nearest of the limb's nodes beyond the tip, on the side of the way back") {
  Clip clip;
  clip.framesPerSecond = releaseRate;
  clip.endSeconds = 60.0 / releaseRate;
  clip.tracks.emplace_back(keysAtFrames(NodeIndex(1), {3.0, 10.0, 14.0, 22.0, 40.0}));
  clip.tracks.emplace_back(keysAtFrames(NodeIndex(2), {5.5, 22.0, 31.25}, Channel::translation));
  clip.tracks.emplace_back(keysAtFrames(NodeIndex(3), {8.0, 24.0}));  // Of no joint of the limb.
  CHECK(framesToKey(clip, 10.0, 22.0, Pivot::start) == Approx(9.25)); // A key at the tip is none beyond it.
  CHECK(framesToKey(clip, 10.0, 22.0, Pivot::end) == Approx(4.5));
  CHECK(framesToKey(clip, 14.0, 22.0, Pivot::end) == Approx(4.0));
  CHECK(framesToKey(clip, 10.0, 33.0, Pivot::start) == Approx(7.0));
  CHECK(framesToKey(clip, 4.0, 22.0, Pivot::end) == Approx(1.0));
  CHECK(framesToKey(clip, 10.0, 40.0, Pivot::start) == -1.0);
  CHECK(framesToKey(clip, 3.0, 22.0, Pivot::end) == -1.0);
}

TEST_CASE("a clip that is keyed on every frame has no next key, and one keyed on every second frame has") {
  const double step = GENERATE(1.0, 2.0);
  std::vector<double> frames;
  for (double frame = 0.0; frame <= 60.0; frame += step) {
    frames.push_back(frame);
  }
  Clip clip;
  clip.framesPerSecond = releaseRate;
  clip.endSeconds = 60.0 / releaseRate;
  clip.tracks.emplace_back(keysAtFrames(NodeIndex(1), frames));
  CHECK(framesToKey(clip, 10.0, 22.0, Pivot::start) == Approx(step == 1.0 ? -1.0 : 2.0));
  CHECK(framesToKey(clip, 10.0, 22.0, Pivot::end) == Approx(step == 1.0 ? -1.0 : 2.0));
}
