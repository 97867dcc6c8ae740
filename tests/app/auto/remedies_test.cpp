// What is tried against a fault that trails of a clip show together: the least that is left to try, one thing
// at a time.
#include <catch2/catch.hpp>

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/auto/remedies.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

/// A trail of the stepper's leg or an arm in a loop from frame 1 on. Frames below 0 count from its end.
struct Tried {
  Document document = twoLeggedStepper();
  ClipGround ground = clipGround(document, 0);
  AutoPlan plan;

  explicit Tried(const char* limb, double startFrame, double endFrame) {
    ground.turnFrames = ground.lastFrame - 1.0;
    ground.wraps = true;
    ground.endsMeet = true;
    ground.stands.clear();
    PlannedTrail planned;
    planned.trail.limb = limb;
    rig::TrailSettings& settings = planned.trail.settings;
    settings.startFrame = startFrame < 0.0 ? ground.lastFrame + startFrame : startFrame;
    settings.endFrame = endFrame < 0.0 ? ground.lastFrame + endFrame : endFrame;
    settings.releaseFrames = 6.0;
    settings.scale = 1.5;
    settings.bend = rig::Bend::keep;
    plan.trails.push_back(planned);
    plan.leftOut.resize(1);
  }
  const rig::TrailSettings& lowered(FaultKind kind, double depth = 0.0) {
    lower(ground, plan, {0, kind, depth});
    REQUIRE(plan.trails.size() == 1);
    return plan.trails.front().trail.settings;
  }
  rig::TrailSettings& settings() { return plan.trails.front().trail.settings; }
};

} // namespace

TEST_CASE("A foot that is moved while it still stands starts when that is over, and only then gets less") {
  Tried step("left-leg", 10, 24);
  step.ground.stands["left-leg"] = {{2.0, 12.0}};
  CHECK(step.lowered(FaultKind::stand).startFrame == 12.0);
  CHECK(step.settings().scale == 1.5);
  CHECK(step.lowered(FaultKind::stand).startFrame == 12.0);
  CHECK(step.settings().scale == Approx(1.0 + 0.7 * 0.5));
  CHECK(step.plan.trails.front().why == "the foot carries the body there");
  // Not one of which hardly anything would be left, nor for a stand that is over or comes later, nor for
  // another fault.
  for (const auto& [stand, startFrame] : {std::pair(Vec2(2.0, 23.0), 10.0),
                                          {Vec2(2.0, 22.0), 22.0},
                                          {Vec2(2.0, 10.0), 10.0},
                                          {Vec2(11.0, 13.0), 10.0},
                                          {Vec2(10.0, 13.0), 13.0}}) {
    Tried other("left-leg", 10, 24);
    other.ground.stands["left-leg"] = {stand};
    CHECK(other.lowered(FaultKind::stand).startFrame == startFrame);
  }
  Tried longer("left-leg", 10, 24);
  longer.ground.stands["left-leg"] = {{2.0, 12.0}};
  CHECK(longer.lowered(FaultKind::lengths).startFrame == 10.0);
  Tried arm("left-arm", 10, 24);
  arm.ground.stands["left-leg"] = {{2.0, 12.0}};
  CHECK(arm.lowered(FaultKind::stand).startFrame == 10.0);
}

TEST_CASE("A foot along the ground is lifted by what is missing, three hundredths of the height in all") {
  Tried step("left-leg", 10, 24);
  const double height = step.document.body.height;
  step.settings().axes = levelAxes;
  const auto lift = [&] {
    return step.settings().spheres.empty() ? 0.0 : step.settings().spheres.back().offset.y / height;
  };
  step.lowered(FaultKind::floor, 0.02 * height);
  CHECK(lift() == Approx(0.022));
  step.lowered(FaultKind::floor, 0.007 * height);
  CHECK(lift() == Approx(0.0297));
  CHECK(step.settings().scale == 1.5);
  step.lowered(FaultKind::floor, 0.001 * height); // it would hang in the air
  CHECK(step.settings().scale == Approx(1.35));
  CHECK(lift() == Approx(0.7 * 0.0297));
  // A foot that may go up and down goes along the ground first; an arm is not lifted, nor is a foot against
  // another fault or by nothing.
  Tried free("left-leg", 10, 24);
  free.settings().axes = allAxes;
  CHECK(free.lowered(FaultKind::floor, 0.01 * height).axes == levelAxes);
  CHECK(free.settings().spheres.empty());
  CHECK(free.settings().scale == 1.5);
  for (const auto& [limb, kind, depth] : {std::tuple("left-arm", FaultKind::floor, 0.01),
                                          {"left-leg", FaultKind::stand, 0.01},
                                          {"left-leg", FaultKind::floor, 0.0}}) {
    Tried other(limb, 10, 24);
    other.settings().axes = levelAxes;
    CHECK(other.lowered(kind, depth * height).spheres.empty());
    CHECK(other.settings().scale == Approx(1.35));
  }
}

TEST_CASE("What would open the seam of a loop keeps still over it, unless its foot stands by then") {
  Tried held("left-leg", -20, -2);
  CHECK(held.lowered(FaultKind::seam).endFrame == held.ground.lastFrame - 2.0);
  const double still = held.settings().lingerFrames;
  CHECK(still > 2.0);
  CHECK(*held.settings().releaseFrames >= still + 3.0);
  CHECK(held.settings().scale == 1.5);
  for (const auto& [stand, keepsStill] : {std::pair(3.0, false), {12.0, true}}) {
    CAPTURE(stand);
    Tried step("left-leg", -20, -2);
    step.ground.stands["left-leg"] = {{stand, 16.0}};
    CHECK((step.lowered(FaultKind::seam).lingerFrames > 0.0) == keepsStill);
    Tried arm("left-arm", -20, -2);
    arm.ground.stands["left-leg"] = {{stand, 16.0}};
    CHECK(arm.lowered(FaultKind::seam).lingerFrames > 0.0);
  }
  // Then its bend is kept as it is.
  Tried bent("left-leg", -20, -2);
  bent.ground.stands["left-leg"] = {{3.0, 16.0}};
  bent.settings().bend = rig::Bend::straighten;
  CHECK(bent.lowered(FaultKind::seam).bend == rig::Bend::keep);
  CHECK(bent.settings().scale == 1.5);
}

TEST_CASE("What holds its pose lets go before anything else, and what is too little is left out") {
  Tried held("left-arm", 10, 20);
  held.settings().lingerFrames = 2.0;
  CHECK(held.lowered(FaultKind::lengths).lingerFrames == 0.0);
  CHECK(*held.settings().releaseFrames == 4.0);
  CHECK(held.settings().scale == 1.5);
  held.settings().scale = 1.08;
  CHECK(held.lowered(FaultKind::lengths).scale == Approx(1.056));
  lower(held.ground, held.plan, {0, FaultKind::lengths});
  CHECK(held.plan.trails.empty());
  CHECK(held.plan.leftOut == std::vector<std::string>{"it would leave the style's lengths"});
}

TEST_CASE("A loop whose first key stands on frame 1 is where it was a frame sooner than it is long") {
  const Document start = stepper();
  Track leg = turnsOf(start, "left-leg");
  for (const auto& [frame, angle] : {std::pair(1, 0.0), {10, 0.8}, {25, 0.0}}) {
    addKey(leg, frame, glm::angleAxis(angle, Vec3(-1.0, 0.0, 0.0)));
  }
  Document document = withTracks(start, {leg});
  Clip clip = document.clips->front();
  clip.startSeconds = 1.0 / 30.0;
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  const ClipGround ground = clipGround(document, 0);
  CHECK(ground.lastFrame == 25.0);
  CHECK(ground.turnFrames == 24.0);
  CHECK(ground.aTurnLater(3.0) == 27.0);
  CHECK(ground.aTurnLater(1.0) == 25.0);
  CHECK(ground.aTurnLater(0.0) == 25.0); // the first key's pose, which is held before it
  CHECK(ground.wraps);
  const ClipGround whole = clipGround(swinger(), 0);
  CHECK(whole.turnFrames == whole.lastFrame);
}

TEST_CASE("A trail ends before a seam where at least half of its range is left by then") {
  // Without a way back over the seam three frames are left for it: the last frame but four is its end.
  const auto tried = [](const char* limb, double startFrame, double endFrame) {
    Tried trail(limb, startFrame, endFrame);
    trail.ground.wraps = false;
    trail.settings().startFrame = trail.ground.lastFrame + startFrame;
    trail.settings().endFrame = trail.ground.lastFrame + endFrame;
    trail.settings().lingerFrames = 0.0;
    return trail;
  };
  for (const auto& [startFrame, endFrame, ends] : {std::tuple(-8.0, 0.0, true),
                                                   {-7.0, 0.0, false},
                                                   {-6.0, -2.0, true},
                                                   {-5.0, -2.0, false},
                                                   {-30.0, -1.0, true}}) {
    CAPTURE(startFrame, endFrame);
    Tried arm = tried("left-arm", startFrame, endFrame);
    const double last = arm.ground.lastFrame;
    const rig::TrailSettings& now = arm.lowered(FaultKind::seam);
    CHECK(now.endFrame == (ends ? last - 4.0 : last + endFrame));
    CHECK(*now.releaseFrames == (ends ? 3.0 : 6.0));
    CHECK(now.scale == Approx(ends ? 1.5 : 1.35));
    CHECK(now.startFrame == last + startFrame);
  }
  // A leg's step may end no more than a twelfth of a second earlier.
  for (const auto& [endFrame, ends] : {std::pair(-1.0, false), {-2.0, true}, {-1.5, true}}) {
    Tried leg = tried("left-leg", -20.0, endFrame);
    CHECK((leg.lowered(FaultKind::seam).endFrame == leg.ground.lastFrame - 4.0) == ends);
  }
}

TEST_CASE("Whose way back is not given comes back over half of its range, before a seam") {
  Tried arm("left-arm", -24, -8);
  arm.settings().releaseFrames.reset();
  CHECK(arm.lowered(FaultKind::seam).releaseFrames == 7.0);
  CHECK(arm.settings().scale == 1.5);
  Tried shorter("left-arm", -20, -8); // It is back two frames before the end.
  shorter.settings().releaseFrames.reset();
  shorter.settings().bend = rig::Bend::straighten;
  CHECK_FALSE(shorter.lowered(FaultKind::seam).releaseFrames);
  CHECK(shorter.settings().bend == rig::Bend::keep);
}

TEST_CASE("What would pass the other side's limb keeps its way along the line between their bases") {
  using Axes = std::array<bool, 3>;
  // The thighs stand beside each other; the left foot is ahead and lifted at the tip.
  Tried leg("left-leg", 10, 25);
  CHECK(leg.lowered(FaultKind::sides).axes == Axes{false, true, true});
  CHECK(leg.settings().scale == 1.5);
  CHECK(leg.lowered(FaultKind::sides).scale == Approx(1.35)); // Only once.
  CHECK(leg.settings().axes == Axes{false, true, true});
  Tried arm("right-arm", 10, 25);
  CHECK(arm.lowered(FaultKind::sides).axes == Axes{false, true, true});
  Tried level("left-leg", 10, 25);
  level.settings().axes = levelAxes;
  CHECK(level.lowered(FaultKind::sides).axes == levelAxes);
  CHECK(level.settings().scale == Approx(1.35));
  // Another fault, a limb in the middle, what follows, and a limb without another side lose no axis.
  Tried lengths("left-leg", 10, 25);
  CHECK(lengths.lowered(FaultKind::lengths).axes == allAxes);
  Tried spine("spine", 10, 25);
  CHECK(spine.lowered(FaultKind::sides).axes == allAxes);
  Tried follows("left-leg", 10, 25);
  follows.plan.trails.front().follows = true;
  CHECK(follows.lowered(FaultKind::sides).axes == allAxes);
  Tried single("left-leg", 10, 25);
  std::erase_if(single.ground.limbs, [](const rig::Limb& limb) { return limb.id == "right-leg"; });
  CHECK(single.lowered(FaultKind::sides).axes == allAxes);
  CHECK(single.settings().scale == Approx(1.35));
}

TEST_CASE(
    "What a trail adds is what its scale differs from 1 by, and of one that follows how far it is pulled") {
  Tried arm("left-arm", 10, 24);
  const auto excess = [&] { return excessOf(arm.ground, arm.plan.trails.front()); };
  CHECK(excess() == Approx(0.5));
  arm.settings().scale = 0.7;
  CHECK(excess() == Approx(0.3));
  arm.settings().spheres = {{10.0, Vec3(0.0), {}}, {24.0, Vec3(0.0, 0.3, 0.0), {}}};
  CHECK(excess() == Approx(0.3)); // A foot is lifted so.
  arm.plan.trails.front().follows = true;
  CHECK(excess() == Approx(0.3 + 0.3 / 0.6)); // of an arm of 0.6
}

TEST_CASE("A trail over a loop's first key starts a frame after that, wherever in the clip it stands") {
  for (const auto& [firstKey, startFrame] :
       {std::pair(0.0, 2.0), {0.5, 2.0}, {3.5, 5.0}, {16.5, 18.0}, {17.5, 2.0}}) {
    CAPTURE(firstKey);
    Tried arm("left-arm", 2, 20);
    Clip clip = arm.document.clips->front();
    clip.startSeconds = firstKey / clip.framesPerSecond;
    arm.document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
    CHECK(arm.lowered(FaultKind::seam).startFrame == startFrame);
  }
}
