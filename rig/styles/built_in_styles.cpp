#include "rig/styles/style.h"

namespace stretch::rig {

namespace {

// Scales of arm, torso and leg as measured; nobody squashes, and five times is the most that was seen in any
// (docs/exaggeration.md, How far cartoons go). A limb straightens first, as in the
// thesis. All else was not measured.
Style measured(const char* name, double arm, double torso, double leg) {
  Style style;
  style.name = name;
  style.origin = StyleOrigin::measured;
  style.bend = Bend::straighten;
  style.arm.usual = arm;
  style.torso.usual = torso;
  style.leg.usual = leg;
  style.other.usual = arm;
  return style;
}

Style ours(const char* name) {
  Style style;
  style.name = name;
  style.origin = StyleOrigin::ours;
  style.bend = Bend::straighten;
  return style;
}

// Long soft limbs that swing past and come back.
Style rubberHose() {
  Style style = ours("Rubber hose");
  style.arm = {0.6, 2.5, 5.0};
  style.leg = {0.6, 2.2, 4.0};
  style.torso = {0.7, 1.4, 2.0};
  style.other = {0.6, 2.2, 4.0};
  style.release = 0.8;
  style.overshoot = 0.3;
  style.spread = {0.8, 0.5, 1.0};
  return style;
}

// The stretch comes late and all at once, and is gone as fast.
Style snappy() {
  Style style = ours("Snappy");
  style.arm = {0.8, 1.8, 3.0};
  style.leg = {0.8, 1.6, 2.5};
  style.torso = {0.9, 1.2, 1.5};
  style.other = {0.8, 1.6, 2.5};
  style.easeIn = {0.6, 0.1};
  style.release = 0.4;
  style.overshoot = 0.15;
  style.spread = {0.5, 0.3, 0.0};
  return style;
}

// To be felt and not seen.
Style subtle() {
  Style style = ours("Subtle");
  style.arm = {0.9, 1.2, 1.5};
  style.leg = {0.9, 1.15, 1.4};
  style.torso = {0.95, 1.06, 1.2};
  style.other = {0.9, 1.2, 1.5};
  style.spread = {0.7, 0.3, 0.0};
  return style;
}

// Slow to start and slow to come back, with limbs that give way to their weight.
Style heavy() {
  Style style = ours("Heavy");
  style.arm = {0.7, 1.5, 2.5};
  style.leg = {0.7, 1.3, 2.0};
  style.torso = {0.8, 1.2, 1.5};
  style.other = {0.7, 1.4, 2.0};
  style.easeIn = {0.4, 0.1};
  style.release = 1.2;
  style.spread = {0.6, 0.6, 2.0};
  style.weight = {0.5, 0.8, 0.9};
  return style;
}

} // namespace

const std::vector<Style>& builtInStyles() {
  static const std::vector<Style> styles{measured("Duck Amuck (1953)", 2.0, 2.0, 2.0),
                                         measured("Fast and Furry-ous (1949)", 2.25, 1.75, 1.5),
                                         measured("Tortoise Wins by a Hare (1943)", 2.4, 1.3, 1.6),
                                         measured("The Great Piggy Bank Robbery (1946)", 2.0, 1.5, 4.0),
                                         measured("Stop! Look! and Hasten! (1955)", 2.0, 1.12, 2.0),
                                         measured("What's Opera, Doc? (1957)", 1.4, 1.4, 1.4),
                                         measured("Average of the six", 2.008, 1.512, 2.083),
                                         rubberHose(),
                                         snappy(),
                                         subtle(),
                                         heavy()};
  return styles;
}

} // namespace stretch::rig
