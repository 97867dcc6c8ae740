#include <set>

#include <catch2/catch.hpp>

#include "rig/styles/style.h"

using namespace stretch;
using rig::LimbKind;

namespace {

const rig::Style& style(const char* name) {
  const rig::Style* const found = rig::styleNamed(rig::builtInStyles(), name);
  REQUIRE(found != nullptr);
  return *found;
}

rig::StyledLimb limb(LimbKind kind, double scale) {
  rig::StyledLimb made{kind, {}};
  made.settings.scale = scale;
  made.settings.endFrame = 10.0;
  return made;
}

} // namespace

TEST_CASE("The measured styles have the numbers of the episodes, and nothing that was not measured") {
  struct Measured {
    const char* name;
    double arm, torso, leg;
  };
  for (const Measured& one : {Measured{"Duck Amuck (1953)", 2.0, 2.0, 2.0},
                              {"Fast and Furry-ous (1949)", 2.25, 1.75, 1.5},
                              {"Tortoise Wins by a Hare (1943)", 2.4, 1.3, 1.6},
                              {"The Great Piggy Bank Robbery (1946)", 2.0, 1.5, 4.0},
                              {"Stop! Look! and Hasten! (1955)", 2.0, 1.12, 2.0},
                              {"What's Opera, Doc? (1957)", 1.4, 1.4, 1.4},
                              {"Average of the six", 2.008, 1.512, 2.083}}) {
    INFO(one.name);
    const rig::Style& found = style(one.name);
    CHECK(found.origin == rig::StyleOrigin::measured);
    CHECK(found.arm == rig::ScaleRange{1.0, one.arm, 5.0});
    CHECK(found.torso == rig::ScaleRange{1.0, one.torso, 5.0});
    CHECK(found.leg == rig::ScaleRange{1.0, one.leg, 5.0});
    rig::Style plain;
    plain.name = found.name;
    plain.origin = found.origin;
    plain.arm = found.arm;
    plain.torso = found.torso;
    plain.leg = found.leg;
    plain.other = found.other;
    plain.bend = rig::Bend::straighten; // as the thesis stretches a limb
    CHECK(found == plain);
  }
}

TEST_CASE("Every built-in style stretches the body no more than the limbs and has ranges that rise") {
  std::set<std::string> names;
  for (const rig::Style& one : rig::builtInStyles()) {
    INFO(one.name);
    CHECK(names.insert(one.name).second);
    CHECK(one.origin != rig::StyleOrigin::own);
    CHECK(one.torso.usual <= std::max(one.arm.usual, one.leg.usual));
    for (const rig::ScaleRange& range : {one.arm, one.leg, one.torso, one.other}) {
      CHECK((range.least <= 1.0 && range.usual > 1.0 && range.usual <= range.most && range.most <= 5.0));
    }
  }
}

TEST_CASE("A style is found by its name in any case, or by a part that no other one has") {
  CHECK(style("rubber HOSE").name == "Rubber hose");
  CHECK(style("opera").name == "What's Opera, Doc? (1957)");
  CHECK(rig::styleNamed(rig::builtInStyles(), "a") == nullptr);
  CHECK(rig::styleNamed(rig::builtInStyles(), "") == nullptr);
  CHECK(rig::styleNamed(rig::builtInStyles(), "anime") == nullptr);
}

TEST_CASE("A style of one's own is found before a built-in one of its name") {
  std::vector<rig::Style> styles = rig::builtInStyles();
  rig::Style own = style("Snappy");
  own.origin = rig::StyleOrigin::own;
  styles.push_back(own);
  CHECK(rig::styleNamed(styles, "snappy")->origin == rig::StyleOrigin::own);
}

TEST_CASE("A style that is taken stays within what a style may ask for") {
  rig::TrailSettings settings;
  settings.startFrame = 4.0;
  settings.endFrame = 5.0;
  settings.scale = 7.0;
  settings.releaseFrames = 200.0;
  const rig::Style taken =
      rig::styleOf({{LimbKind::arm, settings}}, std::string(98, 'a') + "\xC3\xA9\xC3\xA9");
  CHECK((taken.arm.usual == 5.0 && taken.arm.most == 5.0));
  CHECK(taken.release == 100.0);
  CHECK(taken.name == std::string(98, 'a') + "\xC3\xA9");
}

TEST_CASE("Neck and spine have the torso's range, a tail, a wing and a chain that of other limbs") {
  const rig::Style& hose = style("Rubber hose");
  CHECK(rig::scalesOf(hose, LimbKind::spine) == hose.torso);
  CHECK(rig::scalesOf(hose, LimbKind::neck) == hose.torso);
  CHECK(rig::scalesOf(hose, LimbKind::arm) == hose.arm);
  CHECK(rig::scalesOf(hose, LimbKind::leg) == hose.leg);
  for (const LimbKind kind : {LimbKind::tail, LimbKind::wing, LimbKind::fin, LimbKind::chain}) {
    CHECK(rig::scalesOf(hose, kind) == hose.other);
  }
}

TEST_CASE("A style's bend is that of arms and legs, and other limbs keep their own") {
  for (const rig::Bend own : {rig::Bend::keep, rig::Bend::straighten}) {
    rig::TrailSettings settings;
    settings.bend = own;
    rig::Style other = style("Snappy");
    other.bend = own == rig::Bend::keep ? rig::Bend::straighten : rig::Bend::keep;
    for (const LimbKind kind : {LimbKind::arm, LimbKind::leg}) {
      CHECK(rig::styledSettings(settings, other, kind, 1.0).bend == other.bend);
    }
    for (const LimbKind kind :
         {LimbKind::spine, LimbKind::neck, LimbKind::tail, LimbKind::wing, LimbKind::fin, LimbKind::chain}) {
      CHECK(rig::styledSettings(settings, other, kind, 1.0).bend == own);
    }
  }
}

TEST_CASE("Strength counts from no exaggeration, and stays in the style's range") {
  const rig::Style& subtle = style("Subtle"); // arms 1.2, at most 1.5
  CHECK(rig::styledScale(subtle, LimbKind::arm, 0.0) == 1.0);
  CHECK(rig::styledScale(subtle, LimbKind::arm, 0.5) == Approx(1.1));
  CHECK(rig::styledScale(subtle, LimbKind::arm, 1.0) == Approx(1.2));
  CHECK(rig::styledScale(subtle, LimbKind::arm, 2.0) == Approx(1.4));
  CHECK(rig::styledScale(subtle, LimbKind::arm, 5.0) == 1.5);
  CHECK(rig::styledScale(subtle, LimbKind::arm, -5.0) == 0.9);
}

TEST_CASE("A styled trail keeps its range, space and spheres, and a swing that is its limb's own") {
  rig::TrailSettings settings;
  settings.startFrame = 4.0;
  settings.endFrame = 14.0;
  settings.space = rig::TrailSpace::root;
  settings.spheres = {{6.0, Vec3(0.1), {}}};
  settings.overshoot = 0.5;
  rig::Style own = style("Heavy");
  own.axes = rig::AxesRule::level;
  own.volume = 0.25;
  const rig::TrailSettings styled = rig::styledSettings(settings, own, LimbKind::tail, 1.0);
  CHECK((styled.startFrame == 4.0 && styled.endFrame == 14.0));
  CHECK(styled.space == rig::TrailSpace::root);
  CHECK(styled.spheres == settings.spheres);
  CHECK(styled.overshoot == 0.5);
  CHECK(styled.scale == 1.4);
  CHECK(styled.releaseFrames == Approx(12.0));
  CHECK(styled.axes == std::array<bool, 3>{true, false, true});
  CHECK(styled.volume == 0.25);
}

TEST_CASE(
    "A style that is taken from trails gives each kind of limb the largest of its scales, and its range") {
  rig::StyledLimb strong = limb(LimbKind::arm, 3.0);
  strong.settings.easeIn = {0.5, 0.2};
  const rig::Style taken = rig::styleOf({limb(LimbKind::arm, 1.5), strong, limb(LimbKind::leg, 0.7)}, "Mine");
  CHECK(taken.name == "Mine");
  CHECK(taken.arm == rig::ScaleRange{1.0, 3.0, 3.0});
  CHECK(taken.leg == rig::ScaleRange{0.7, 0.7, 1.0});
  CHECK(taken.torso == rig::ScaleRange{1.0, 1.0, 1.0});
  CHECK(taken.easeIn == rig::Ease{0.5, 0.2});
  CHECK_FALSE(taken.release);
}

TEST_CASE("Settings that become a style and a trail again are the same") {
  rig::TrailSettings settings;
  settings.endFrame = 8.0;
  settings.scale = 2.75;
  settings.reference = rig::Reference::rest;
  settings.bend = rig::Bend::straighten;
  settings.remap = rig::RemapKind::linear;
  settings.easeIn = {0.2, 0.3};
  settings.easeOut = {0.3, 0.8};
  settings.releaseFrames = 6.0;
  settings.overshoot = 0.4;
  settings.volume = 0.5;
  rig::TrailSettings plain;
  plain.endFrame = 8.0;
  CHECK(rig::styledSettings(plain, rig::styleOf({{LimbKind::arm, settings}}, "A"), LimbKind::arm, 1.0) ==
        settings);
}

TEST_CASE("A style that is taken from level trails is level, and from one of no length has no release") {
  rig::StyledLimb one = limb(LimbKind::arm, 2.0);
  one.settings.axes = {true, false, true};
  one.settings.releaseFrames = 5.0;
  CHECK(rig::styleOf({one}, "Level").axes == rig::AxesRule::level);
  CHECK(rig::styleOf({one}, "Level").release == 0.5);
  one.settings.startFrame = one.settings.endFrame;
  CHECK_FALSE(rig::styleOf({one}, "Short").release);
}

TEST_CASE("A style that is taken from the trunk alone asks of limbs what it asks of the trunk") {
  const rig::Style taken = rig::styleOf({limb(LimbKind::spine, 1.5)}, "Trunk");
  for (const rig::ScaleRange& range : {taken.torso, taken.arm, taken.leg, taken.other}) {
    CHECK(range == rig::ScaleRange{1.0, 1.5, 1.5});
  }
}
