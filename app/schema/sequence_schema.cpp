#include "app/schema/sequence_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

using skinning::CompressSettings;

Schema<CompressSettings> boneSettings() {
  return {
      setting<CompressSettings>({.name = "bones",
                                 .minimum = 1.0,
                                 .maximum = 1000.0,
                                 .help = "Bones in a row along the body.",
                                 .row = {.section = "options", .maximum = 100.0}},
                                &CompressSettings::bones),
      setting<CompressSettings>(
          {.name = "stretch",
           .choices = {{"none", "Bones turn; the body keeps its length and thickness."},
                       {"elastic",
                        "By the physical model: gravity flattens, curvature shortens. A handful of numbers."},
                       {"measured", "Scales fitted frame by frame: the best that bones with scales can do."}},
           .help = "How bones stretch: not at all, by the elastic model, or as measured.",
           .row = {.section = "options"}},
          &CompressSettings::stretch),
      setting<CompressSettings>(
          {.name = "weights",
           .choices = {{"geodesic", "By distance over the surface, from the first frame alone."},
                       {"fitted", "By least squares over the frames."}},
           .help = "How vertices hang on bones.",
           .row = {.section = "options"}},
          &CompressSettings::weights),
      setting<CompressSettings>(
          {.name = "length",
           .choices = {{"auto", "The line, or the monotone curve where that explains clearly more."},
                       {"line", "Length falls with curvature along a straight line, as in the paper."},
                       {"monotone", "Length never grows with curvature; copes with saturation."}},
           .help = "Length as a function of curvature.",
           .row = {.section = "options"}},
          [](auto& s) -> auto& { return s.body.lengthModel; }),
      setting<CompressSettings>(
          {.name = "skip",
           .maximum = 1e6,
           .unit = "frames",
           .help = "Settling frames at the start that no fit uses; they are in the clip all the same.",
           .row = {.section = "options", .maximum = 1.0}},
          [](auto& s) -> auto& { return s.body.firstFittedFrame; }),
  };
}

Schema<CompressSettings> bodySettings() {
  return {
      setting<CompressSettings>(
          {.name = "young",
           .minimum = 1e-12,
           .maximum = 1e15,
           .unit = "Pa",
           .help = "Young's modulus; default: the one that explains the frames best.",
           .row = {.section = "model", .label = "Modulus", .typed = true}},
          [](auto& s) -> auto& { return s.body.youngModulus; }),
      setting<CompressSettings>(
          {.name = "mass",
           .minimum = 1e-30,
           .maximum = 1e15,
           .unit = "kg",
           .help = "Mass of the body; default: that of water in the body's volume.",
           .row = {.section = "model", .typed = true}},
          [](auto& s) -> auto& { return s.body.mass; }),
      setting<CompressSettings>(
          {.name = "metres_per_unit",
           .minimum = 1e-12,
           .maximum = 1e12,
           .unit = "m",
           .help = "How long a unit of the mesh is.",
           .row = {.section = "model", .label = "Scale", .typed = true}},
          [](auto& s) -> auto& { return s.body.metresPerUnit; }),
      setting<CompressSettings>(
          {.name = "gravity",
           .minimum = -1e6,
           .maximum = 1e6,
           .unit = "m/s^2",
           .help = "Gravity along x, y, z of the mesh.",
           .row = {.section = "model", .typed = true}},
          [](auto& s) -> auto& { return s.body.gravity; }),
  };
}

} // namespace

const Schema<CompressSettings>& sequenceSchema() {
  static const Schema<CompressSettings> schema = joined<CompressSettings>({boneSettings(), bodySettings()});
  return schema;
}

} // namespace stretch::app
