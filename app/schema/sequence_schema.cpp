#include "app/schema/sequence_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

using S = skinning::CompressSettings;

Schema<S> boneSettings() {
  return {
      setting<S>({.name = "bones",
                  .minimum = 1.0,
                  .maximum = 1000.0,
                  .help = "Bones in a row along the body.",
                  .row = {.section = "options", .maximum = 100.0}},
                 &S::bones),
      setting<S>(
          {.name = "stretch",
           .choices = {{"none", "Bones turn; the body keeps its length and thickness."},
                       {"elastic",
                        "By the physical model: gravity flattens, curvature shortens. A handful of numbers."},
                       {"measured", "Scales fitted frame by frame: the best that bones with scales can do."}},
           .help = "How bones stretch: not at all, by the elastic model, or as measured.",
           .row = {.section = "options"}},
          &S::stretch),
      setting<S>({.name = "weights",
                  .choices = {{"geodesic", "By distance over the surface, from the first frame alone."},
                              {"fitted", "By least squares over the frames."}},
                  .help = "How vertices hang on bones.",
                  .row = {.section = "options"}},
                 &S::weights),
      setting<S>({.name = "length",
                  .choices = {{"line", "Length falls with curvature along a straight line, as in the paper."},
                              {"monotone", "Length never grows with curvature; copes with saturation."}},
                  .help = "Length as a function of curvature.",
                  .row = {.section = "options"}},
                 [](auto& s) -> auto& { return s.body.lengthModel; }),
      setting<S>({.name = "skip",
                  .maximum = 1e6,
                  .unit = "frames",
                  .help = "Settling frames at the start that no fit uses; they are in the clip all the same.",
                  .row = {.section = "options", .maximum = 1.0}},
                 [](auto& s) -> auto& { return s.body.firstFittedFrame; }),
  };
}

Schema<S> bodySettings() {
  return {
      setting<S>({.name = "young",
                  .minimum = 1e-12,
                  .maximum = 1e15,
                  .unit = "Pa",
                  .help = "Young's modulus; default: the one that explains the frames best.",
                  .row = {.section = "model"}},
                 [](auto& s) -> auto& { return s.body.youngModulus; }),
      setting<S>({.name = "mass",
                  .minimum = 1e-30,
                  .maximum = 1e15,
                  .unit = "kg",
                  .help = "Mass of the body; default: that of water in the body's volume.",
                  .row = {.section = "model"}},
                 [](auto& s) -> auto& { return s.body.mass; }),
      setting<S>({.name = "metres_per_unit",
                  .minimum = 1e-12,
                  .maximum = 1e12,
                  .unit = "m",
                  .help = "How long a unit of the mesh is.",
                  .row = {.section = "model", .label = "Scale"}},
                 [](auto& s) -> auto& { return s.body.metresPerUnit; }),
      setting<S>({.name = "gravity",
                  .minimum = -1e6,
                  .maximum = 1e6,
                  .unit = "m/s^2",
                  .help = "Gravity along x, y, z of the mesh.",
                  .row = {.section = "model"}},
                 [](auto& s) -> auto& { return s.body.gravity; }),
  };
}

} // namespace

const Schema<S>& sequenceSchema() {
  static const Schema<S> schema = joined<S>({boneSettings(), bodySettings()});
  return schema;
}

} // namespace stretch::app
