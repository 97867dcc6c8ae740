#include "app/schema/trail_schema.h"

#include <fmt/core.h>

#include "app/schema/schema_rows.h"
#include "rig/ik/limb_shape.h"

namespace stretch::app {

namespace {

using rig::TrailSettings;

Schema<TrailSettings> tipSettings() {
  return {
      setting<TrailSettings>({.name = "scale",
                              .maximum = rig::largestStretch,
                              .help = "How long the limb becomes at the tip, in lengths of itself.",
                              .row = {.section = "tip",
                                      .maximum = rig::largestScale,
                                      .step = 0.05,
                                      .fineStep = 0.01,
                                      .prefix = "\xC3\x97"}},
                             &TrailSettings::scale),
      setting<TrailSettings>({.name = "axes",
                              .help = "Active axes of the trail's space, any of x, y, z.",
                              .row = {.section = "tip"}},
                             &TrailSettings::axes),
      setting<TrailSettings>({.name = "pivot",
                              .choices = {{"start"}, {"end"}},
                              .help = "The end of the range that stays where it is.",
                              .row = {.section = "tip"}},
                             &TrailSettings::pivot),
      setting<TrailSettings>({.name = "turn_limit",
                              .maximum = rig::freeTurnDegrees,
                              .unit = "degrees",
                              .help =
                                  "So far at most the scale turns the limb about its base; beyond that it "
                                  "grows straight out.",
                              .row = {.section = "space", .label = "Turn limit", .step = 1.0}},
                             &TrailSettings::turnLimitDegrees),
  };
}

Schema<TrailSettings> transitionSettings() {
  return {
      setting<TrailSettings>({.name = "ease_in",
                              .unit = "fraction,value",
                              .help = "Ease-in: fraction of the path and value there, P,V.",
                              .row = {.section = "transition", .label = "Ease-in"}},
                             &TrailSettings::easeIn),
      setting<TrailSettings>({.name = "ease_out",
                              .unit = "fraction,value",
                              .help = "Ease-out: fraction of the path from its end and value there, P,V.",
                              .row = {.section = "transition", .label = "Ease-out"}},
                             &TrailSettings::easeOut),
      setting<TrailSettings>({.name = "remap",
                              .choices = {{"spline"}, {"linear"}},
                              .help = "Shape of the transition along the path.",
                              .row = {.section = "transition", .label = "Curve"}},
                             &TrailSettings::remap),
  };
}

Schema<TrailSettings> limbSettings() {
  return {
      setting<TrailSettings>({.name = "bend",
                              .choices = {{"keep"}, {"straighten"}},
                              .help = "Keep the limb's bend, or straighten it before it stretches.",
                              .row = {.section = "limb"}},
                             &TrailSettings::bend),
      setting<TrailSettings>({.name = "blend",
                              .maximum = 2.0,
                              .help = "0 original, 1 half-way, 2 exaggerated.",
                              .row = {.section = "limb", .percent = true, .shownFactor = 0.5}},
                             &TrailSettings::blend),
      setting<TrailSettings>({.name = "switch",
                              .maximum = 1.0,
                              .help = "How much of the wanted length the limb takes on.",
                              .row = {.section = "limb", .label = "Stretch", .percent = true}},
                             &TrailSettings::stretchSwitch),
      setting<TrailSettings>({.name = "volume",
                              .maximum = 1.0,
                              .help = "Volume preservation: 0 keeps the thickness, 1 the volume.",
                              .row = {.section = "limb", .percent = true}},
                             &TrailSettings::volume),
      setting<TrailSettings>(
          {.name = "turn_end", .help = "The hand or foot turns with the limb.", .row = {.section = "limb"}},
          &TrailSettings::turnEnd),
  };
}

Schema<TrailSettings> releaseSettings() {
  return {
      setting<TrailSettings>(
          {.name = "release",
           .maximum = 100000.0,
           .unit = "frames",
           .help = "Frames after the tip over which the limb comes back to the original motion; default: "
                   "to the next key, or longer where the limb would go back faster than it came.",
           .row = {.section = "release", .step = 1.0}},
          &TrailSettings::releaseFrames),
      setting<TrailSettings>(
          {.name = "linger",
           .maximum = 100000.0,
           .unit = "frames",
           .help =
               "Frames of the release for which the limb keeps all of its exaggeration before it comes back.",
           .row = {.section = "release", .step = 1.0}},
          &TrailSettings::lingerFrames),
      setting<TrailSettings>({.name = "overshoot",
                              .maximum = 1.0,
                              .unit = "of the tip's offset",
                              .help = "How far the release swings past the original.",
                              .row = {.section = "release", .percent = true}},
                             &TrailSettings::overshoot),
  };
}

Schema<TrailSettings> spaceSettings() {
  return {
      setting<TrailSettings>({.name = "space",
                              .choices = {{"world"}, {"root"}, {"base"}, {"view"}},
                              .help =
                                  "Where the path is exaggerated; the axes of a view are asked for in the "
                                  "editor and in recipes alone.",
                              .row = {.section = "space"}},
                             &TrailSettings::space),
      setting<TrailSettings>({.name = "reference",
                              .choices = {{"pose"}, {"rest"}},
                              .help = "The length that the scale multiplies.",
                              .row = {.section = "space"}},
                             &TrailSettings::reference),
      setting<TrailSettings>({.name = "pull",
                              .help = "Pull the tip to the wanted length where its line does not reach it.",
                              .row = {.section = "space", .label = "Pull the rest"}},
                             &TrailSettings::pull),
      setting<TrailSettings>(
          {.name = "stay_in_world",
           .help = "The hand or foot keeps its place in the world while trails nearer to the hips "
                   "move the body: a hand on a ledge, a planted foot.",
           .row = {.section = "space", .label = "Keep place"}},
          &TrailSettings::stayInWorld),
  };
}

Schema<TrailSettings> sightSettings() {
  return {
      setting<TrailSettings>(
          {.name = "camera",
           .help = "Camera that judges the trail: one of the file, or front, side, top, three-quarter.",
           .row = {.section = "sight"}},
          [](auto& s) -> auto& { return s.sight.camera; }),
      setting<TrailSettings>(
          {.name = "as_seen",
           .help = "The scale counts in the limb's length in the camera's picture.",
           .row = {.section = "sight", .label = "Scale as seen"}},
          [](auto& s) -> auto& { return s.sight.asSeen; }),
      setting<TrailSettings>(
          {.name = "keep_depth",
           .help = "Scaled as seen, the path grows parallel to the picture and keeps its distance.",
           .row = {.section = "sight", .label = "Keep depth"}},
          [](auto& s) -> auto& { return s.sight.keepDepth; }),
      setting<TrailSettings>(
          {.name = "turn_to_view",
           .maximum = 90.0,
           .unit = "degrees",
           .help = "So far at most the path is turned about the limb's base, for the "
                   "camera to see more of it, where the scale does not count as seen.",
           .row = {.section = "sight", .label = "Turn to view", .step = 1.0}},
          [](auto& s) -> auto& { return s.sight.turnDegrees; }),
  };
}

} // namespace

Status checkEases(const rig::Ease& easeIn, const rig::Ease& easeOut) {
  if (easeIn.percent + easeOut.percent >= 1.0) {
    return Error{"both eases together take the whole path", "ease_in", "give fractions whose sum is below 1"};
  }
  if (easeIn.percent > 0.0 && easeIn.value > easeHalf) {
    return Error{fmt::format("the value {:g} is beyond the half", easeIn.value), "ease_in",
                 "give a value from 0 to 0.5"};
  }
  if (easeOut.percent > 0.0 && easeOut.value < easeHalf) {
    return Error{fmt::format("the value {:g} is short of the half", easeOut.value), "ease_out",
                 "give a value from 0.5 to 1"};
  }
  return Success{};
}

const Schema<TrailSettings>& trailSchema() {
  static const Schema<TrailSettings> schema =
      joined<TrailSettings>({tipSettings(), transitionSettings(), limbSettings(), releaseSettings(),
                             spaceSettings(), sightSettings()});
  return schema;
}

} // namespace stretch::app
