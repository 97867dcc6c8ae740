#include <catch2/catch.hpp>

#include "app/edits/trail/style_edits.h"
#include "tests/support/refusal.h"

using namespace stretch;

namespace {

rig::Limb limbOf(const rig::LimbPlace& place, const char* id) {
  rig::Limb limb;
  static_cast<rig::LimbPlace&>(limb) = place;
  limb.id = id;
  return limb;
}

rig::Trail trailOf(int id, const char* limb) {
  rig::Trail trail;
  trail.id = id;
  trail.limb = limb;
  trail.settings.startFrame = 2.0;
  trail.settings.endFrame = 12.0;
  trail.exaggerated = true;
  return trail;
}

/// Trails 1 to 3 on an arm, a leg and the spine of the one clip "Punch".
app::Document threeTrails() {
  app::Document document;
  Clip clip;
  clip.name = "Punch";
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  document.body.limbs = {limbOf(rig::biped::leftArm, "left-arm"), limbOf(rig::biped::leftLeg, "left-leg"),
                         limbOf(rig::biped::spine, "spine")};
  document.trails = {trailOf(1, "left-arm"), trailOf(2, "left-leg"), trailOf(3, "spine")};
  return document;
}

const rig::Style& style(const char* name) {
  const rig::Style* const found = rig::styleNamed(rig::builtInStyles(), name);
  REQUIRE(found != nullptr);
  return *found;
}

} // namespace

TEST_CASE("A style scales arms, legs and body as its cartoon does, and only the trails that are named") {
  const app::Document before = threeTrails();
  const rig::Style& piggyBank = style("piggy bank");
  const Result<app::Document> after = app::applyStyle(before, {1, 2}, piggyBank);
  REQUIRE(after.ok());
  CHECK(after->trails[0].settings.scale == 2.0);
  CHECK(after->trails[1].settings.scale == 4.0);
  CHECK(after->trails[2].settings == before.trails[2].settings);
  CHECK(app::hasStyle(*after, {1, 2}, piggyBank));
  CHECK_FALSE(app::hasStyle(*after, {1, 2, 3}, piggyBank));
  CHECK_FALSE(app::hasStyle(*after, {1, 2}, style("duck amuck")));
}

TEST_CASE(
    "A style gives a trail its ease, its way back in lengths of the range, and its swing, and the next one "
    "takes them back") {
  const Result<app::Document> snappy = app::applyStyle(threeTrails(), {1}, style("Snappy"));
  REQUIRE(snappy.ok());
  const rig::TrailSettings& settings = snappy->trails[0].settings;
  CHECK(settings.easeIn == rig::Ease{0.6, 0.1});
  CHECK(settings.releaseFrames == Approx(4.0)); // 0.4 of ten frames
  CHECK(settings.overshoot == 0.15);
  CHECK((settings.startFrame == 2.0 && settings.endFrame == 12.0));
  const Result<app::Document> amuck = app::applyStyle(*snappy, {1}, style("Duck"));
  REQUIRE(amuck.ok());
  CHECK(amuck->trails[0].settings.easeIn.percent == 0.0);
  CHECK_FALSE(amuck->trails[0].settings.releaseFrames);
  CHECK(amuck->trails[0].settings.overshoot == 0.0);
}

TEST_CASE("A style for a trail that is not there is refused") {
  CHECK_THAT(test::refusal(app::applyStyle(threeTrails(), {7}, style("Subtle"))),
             Catch::StartsWith("trail 7: there is no such trail"));
}

TEST_CASE("A style that is taken from a clip has the settings of its trails and the weight of its limbs") {
  app::Document document = threeTrails();
  document.trails[0].settings.scale = 2.4;
  document.trails[0].settings.releaseFrames = 5.0;
  document.trails[0].settings.overshoot = 0.2;
  document.trails[0].settings.axes = {true, false, true};
  document.trails[1].settings.scale = 1.6;
  document.trails[2].settings.scale = 1.1;
  document.weights = {{"left-arm", 0, true, {}}};
  document.weights[0].settings.amount = 0.4;
  document.weights[0].settings.stiffness = 2.0;
  const Result<rig::Style> taken = app::styleOfClip(document, 0, "");
  REQUIRE(taken.ok());
  CHECK(taken->name == "Punch");
  CHECK(taken->origin == rig::StyleOrigin::own);
  CHECK(taken->arm.usual == 2.4);
  CHECK(taken->leg.usual == 1.6);
  CHECK(taken->torso.usual == 1.1);
  CHECK(taken->other.most == 2.4);
  CHECK(taken->release == Approx(0.5));
  CHECK(taken->overshoot == 0.2);
  CHECK(taken->axes == rig::AxesRule::level);
  CHECK(taken->weight == rig::StyleWeight{0.4, 2.0, 0.7});
  CHECK(app::styleOfClip(document, 0, "Mine")->name == "Mine");
}

TEST_CASE("Paths that are not exaggerated, and those of other clips, are no style") {
  app::Document document = threeTrails();
  for (rig::Trail& trail : document.trails) {
    trail.exaggerated = trail.id == 1;
    trail.clip = trail.id == 1 ? 1 : 0;
  }
  CHECK_THAT(test::refusal(app::styleOfClip(document, 0, "")),
             Catch::Contains("no trail of the clip is exaggerated"));
}

TEST_CASE("A style has the weight that is the most in its clip, of those that are on") {
  app::Document document = threeTrails();
  const auto weighed = [](const char* limb, int clip, bool on, double amount) {
    app::WeightedLimb weight{limb, clip, on, {}};
    weight.settings.amount = amount;
    weight.settings.stiffness = 10.0 * amount;
    return weight;
  };
  document.weights = {weighed("spine", 0, true, 0.3), weighed("left-arm", 0, true, 0.4),
                      weighed("left-leg", 0, true, 0.2), weighed("left-leg", 0, false, 0.9),
                      weighed("left-arm", 1, true, 0.8)};
  const Result<rig::Style> taken = app::styleOfClip(document, 0, "");
  REQUIRE(taken.ok());
  CHECK(taken->weight.amount == 0.4);
  CHECK(taken->weight.stiffness == 4.0);
}

TEST_CASE("The style of a clip without a name is called a style all the same") {
  app::Document document = threeTrails();
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>(1));
  CHECK(app::styleOfClip(document, 0, "")->name == "My style");
}

TEST_CASE("A trail that was held out lets go at once in a style that says nothing of its way back") {
  app::Document document = threeTrails();
  document.trails[0].settings.releaseFrames = 6.0;
  document.trails[0].settings.lingerFrames = 3.0;
  const Result<app::Document> styled = app::applyStyle(document, {1}, style("Duck"));
  REQUIRE(styled.ok());
  CHECK(styled->trails[0].settings.lingerFrames == 0.0);
  CHECK_FALSE(styled->trails[0].settings.releaseFrames);
}
