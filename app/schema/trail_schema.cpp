#include "app/schema/trail_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

using S = rig::TrailSettings;

Schema<S> tipSettings() {
  return {
      setting<S>({.name = "scale",
                  .maximum = 100.0,
                  .help = "How long the limb becomes at the tip, in lengths of itself.",
                  .row = {.section = "tip", .maximum = rig::largestScale, .prefix = "\xC3\x97"}},
                 &S::scale),
      setting<S>({.name = "axes",
                  .help = "Active axes of the trail's space, any of x, y, z.",
                  .row = {.section = "tip"}},
                 &S::axes),
      setting<S>({.name = "pivot",
                  .choices = {{"start"}, {"end"}},
                  .help = "The end of the range that stays where it is.",
                  .row = {.section = "tip"}},
                 &S::pivot),
  };
}

Schema<S> transitionSettings() {
  return {
      setting<S>({.name = "ease_in",
                  .unit = "fraction,value",
                  .help = "Ease-in: fraction of the path and value there, P,V.",
                  .row = {.section = "transition", .label = "Ease-in"}},
                 &S::easeIn),
      setting<S>({.name = "ease_out",
                  .unit = "fraction,value",
                  .help = "Ease-out: fraction of the path from its end and value there, P,V.",
                  .row = {.section = "transition", .label = "Ease-out"}},
                 &S::easeOut),
      setting<S>({.name = "remap",
                  .choices = {{"spline"}, {"linear"}},
                  .help = "Shape of the transition along the path.",
                  .row = {.section = "transition", .label = "Curve"}},
                 &S::remap),
  };
}

Schema<S> limbSettings() {
  return {
      setting<S>({.name = "bend",
                  .choices = {{"keep"}, {"straighten"}},
                  .help = "Keep the limb's bend, or straighten it before it stretches.",
                  .row = {.section = "limb"}},
                 &S::bend),
      setting<S>({.name = "blend",
                  .maximum = 2.0,
                  .help = "0 original, 1 half-way, 2 exaggerated.",
                  .row = {.section = "limb"}},
                 &S::blend),
      setting<S>({.name = "switch",
                  .maximum = 1.0,
                  .help = "How much of the wanted length the limb takes on.",
                  .row = {.section = "limb", .label = "Stretch", .percent = true}},
                 &S::stretchSwitch),
      setting<S>({.name = "volume",
                  .maximum = 1.0,
                  .help = "Volume preservation: 0 keeps the thickness, 1 the volume.",
                  .row = {.section = "limb", .percent = true}},
                 &S::volume),
      setting<S>({.name = "turn_end",
                  .help = "The hand or foot turns with the limb.",
                  .row = {.section = "limb"}},
                 &S::turnEnd),
  };
}

Schema<S> releaseSettings() {
  return {
      setting<S>({.name = "release",
                  .maximum = 100000.0,
                  .unit = "frames",
                  .help = "Frames after the tip over which the limb comes back to the original motion; default: "
                          "to the next key.",
                  .row = {.section = "release", .step = 1.0}},
                 &S::releaseFrames),
      setting<S>({.name = "overshoot",
                  .maximum = 1.0,
                  .unit = "of the tip's offset",
                  .help = "How far the release swings past the original.",
                  .row = {.section = "release", .percent = true}},
                 &S::overshoot),
  };
}

Schema<S> spaceSettings() {
  return {
      setting<S>({.name = "space",
                  .choices = {{"world"}, {"root"}, {"base"}, {"view"}},
                  .help = "Where the path is exaggerated.",
                  .row = {.section = "space"}},
                 &S::space),
      setting<S>({.name = "reference",
                  .choices = {{"pose"}, {"rest"}},
                  .help = "The length that the scale multiplies.",
                  .row = {.section = "space"}},
                 &S::reference),
      setting<S>({.name = "pull",
                  .help = "Pull the tip to the wanted length where its line does not reach it.",
                  .row = {.section = "space"}},
                 &S::pull),
      setting<S>({.name = "stay_in_world",
                  .help = "The limb's end is not carried along by inner trails.",
                  .row = {.section = "space"}},
                 &S::stayInWorld),
  };
}

} // namespace

const Schema<S>& trailSchema() {
  static const Schema<S> schema = joined<S>(
      {tipSettings(), transitionSettings(), limbSettings(), releaseSettings(), spaceSettings()});
  return schema;
}

} // namespace stretch::app
