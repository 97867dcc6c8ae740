#include <catch2/catch.hpp>

#include <algorithm>

#include "app/auto/exaggerate_clip.h"
#include "app/edits/trail/style_edits.h"
#include "app/evaluate/clip_moments.h"
#include "app/evaluate/evaluate.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;

namespace {

AutoSettings in(const char* name, double strength = 1.0) {
  const rig::Style* const style = rig::styleNamed(rig::builtInStyles(), name);
  REQUIRE(style != nullptr);
  return {*style, strength};
}

AutoClip exaggerated(const Document& document, const AutoSettings& settings) {
  return exaggerateClip(document, 0, momentsOf(document, 0), settings);
}

/// Straight length of the left arm at a frame over what the source has.
double armRatio(const Document& document, double frame) {
  const rig::Limb& arm = *findLimb(document, "left-arm");
  const double seconds = frame / clipOf(document, 0).framesPerSecond;
  return rig::limbLength(arm, evaluate(document, prepareMotion(document, 0), seconds)) /
         rig::limbLength(arm, evaluateOriginal(document, 0, seconds));
}

const AutoMoment& strongest(const AutoClip& made) {
  REQUIRE_FALSE(made.moments.empty());
  return made.moments.front();
}

} // namespace

TEST_CASE("The punch of a clip gets a trail over its moment with the style's scale, and the arm is as long") {
  const Document before = test::boxer();
  const AutoClip made = exaggerated(before, in("Opera"));
  const AutoMoment& punch = strongest(made);
  CHECK(punch.moment.limb == "left-arm");
  REQUIRE(punch.trailId > 0);
  const rig::Trail& trail = *findTrail(made.document, punch.trailId);
  CHECK((trail.exaggerated && trail.connected));
  CHECK(trail.settings.endFrame == punch.moment.endFrame);
  CHECK(punch.scale == trail.settings.scale);
  CHECK(armRatio(made.document, trail.settings.endFrame) == Approx(punch.scale).epsilon(1e-3));
  CHECK(before.trails.empty());
}

TEST_CASE("More strength makes the arm longer, and none leaves the clip as it was") {
  const Document before = test::boxer();
  const double usual = strongest(exaggerated(before, in("Subtle"))).scale;
  const double more = strongest(exaggerated(before, in("Subtle", 2.0))).scale;
  CHECK(usual > 1.0);
  CHECK(more > usual);
  const AutoClip none = exaggerated(before, in("Subtle", 0.0));
  CHECK(sameDocument(none.document, before));
  CHECK(strongest(none).why == "the strength is 0");
}

TEST_CASE("Only the moments that are asked for are exaggerated") {
  const Document before = test::boxer();
  const AutoClip none = exaggerateClip(before, 0, {}, in("Opera"));
  CHECK(none.moments.empty());
  CHECK(sameDocument(none.document, before));
}

TEST_CASE("A trail that is there keeps its limb to itself, and says so") {
  const rig::Moment punch = momentsOf(test::boxer(), 0).front();
  const Document before =
      test::withNewTrail(test::boxer(), {"left-arm", punch.startFrame, punch.endFrame, 1.3});
  const AutoClip made = exaggerated(before, in("Opera"));
  CHECK(strongest(made).trailId == 0);
  CHECK(strongest(made).why == "a trail is there already");
  CHECK(made.document.trails.front() == before.trails.front());
}

TEST_CASE("A limb that the character lacks and a landing of the whole body are left out with a reason") {
  const Document before = test::boxer();
  rig::Moment lacking = momentsOf(before, 0).front();
  rig::Moment landing = lacking;
  lacking.limb = "tail";
  landing.limb = rig::wholeBody;
  landing.kind = rig::MomentKind::landing;
  const AutoClip made = exaggerateClip(before, 0, {lacking, landing}, in("Opera"));
  REQUIRE(made.moments.size() == 2);
  CHECK(made.moments[0].why == "the character has no such limb");
  CHECK_THAT(made.moments[1].why, Catch::Contains("feet stay"));
  CHECK(made.trailIds.empty());
}

TEST_CASE("The spine that goes along with a punch is pulled, and complains of no length") {
  const AutoClip made = exaggerated(test::openedFile(test::posedCharacter), in("Snappy"));
  const rig::MotionState motion = prepareMotion(made.document, 0);
  const auto spine = std::ranges::find_if(
      motion.trails, [](const rig::SolvedTrail& solved) { return solved.limb.id == "spine"; });
  REQUIRE(spine != motion.trails.end());
  CHECK(spine->settings.scale == 1.0);
  CHECK_FALSE(spine->settings.spheres.empty());
  CHECK(spine->warnings.empty());
}

TEST_CASE("A style with weight gives it to arms that have a trail") {
  const AutoClip made = exaggerated(test::boxer(), in("Heavy"));
  REQUIRE_FALSE(made.trailIds.empty());
  const WeightedLimb* const weight = findWeight(made.document, "left-arm", 0);
  REQUIRE(weight != nullptr);
  CHECK(weight->settings.amount == 0.5);
  CHECK(weight->settings.stiffness == 0.8);
  CHECK(findWeight(made.document, "spine", 0) == nullptr);
  CHECK(exaggerated(test::boxer(), in("Opera")).document.weights.empty());
}

TEST_CASE("A style that is taken from a clip gives the same ratios where it is put on again") {
  const Document first = exaggerated(test::boxer(), in("Opera")).document;
  const Result<rig::Style> taken = styleOfClip(first, 0, "Taken");
  REQUIRE(taken.ok());
  const AutoClip again = exaggerateClip(test::boxer(), 0, momentsOf(test::boxer(), 0), {*taken, 1.0});
  const double tip = strongest(again).moment.endFrame;
  CHECK(armRatio(again.document, tip) == Approx(armRatio(first, tip)).epsilon(0.02));
}
