#include "app/schema/sequence_schema.h"

#include "app/schema/schema_rows.h"

namespace stretch::app {

namespace {

using skinning::CompressSettings;
using skinning::EncodeSettings;

Schema<CompressSettings> boneSettings() {
  return {
      setting<CompressSettings>(
          {.name = "bones",
           .minimum = 1.0,
           .maximum = 1000.0,
           .help = "Bones, in a row along the body or one for each part that moves alike.",
           .row = {.section = "options", .maximum = 100.0}},
          &CompressSettings::bones),
      setting<CompressSettings>(
          {.name = "tolerance",
           .minimum = 1e-6,
           .maximum = 100.0,
           .unit = "%",
           .help = "The error (RMSE, of the diagonal) that as few bones as possible have to meet, up to 128; "
                   "the number of bones does not count then.",
           .row = {.section = "options", .typed = true}},
          &CompressSettings::tolerancePercent),
      setting<CompressSettings>(
          {.name = "stretch",
           .choices = {{"none", "Bones turn; the body keeps its length and thickness."},
                       {"elastic",
                        "By the physical model: gravity flattens, curvature shortens. A handful of numbers."},
                       {"measured", "Scales fitted frame by frame: the best that bones with scales can do."}},
           .help = "How bones stretch: not at all, by the elastic model, or as measured.",
           .row = {.section = "options"}},
          &CompressSettings::stretch),
  };
}

Schema<CompressSettings> skinSettings() {
  return {
      setting<CompressSettings>(
          {.name = "weights",
           .choices = {{"auto",
                        "Fitted where bones are free; for a row both are tried and the better stays."},
                       {"geodesic", "By distance over the surface, from the first frame alone."},
                       {"fitted", "By least squares over the frames."}},
           .help = "How vertices hang on bones.",
           .row = {.section = "options"}},
          &CompressSettings::weights),
      setting<CompressSettings>(
          {.name = "joints",
           .choices = {{"tree", "Each bone hangs on another at the joint between them."},
                       {"free", "All bones stand side by side."}},
           .help = "How bones that were measured hang together; the mesh moves the same way.",
           .row = {.section = "options"}},
          &CompressSettings::joints),
      setting<CompressSettings>(
          {.name = "influences",
           .choices = {{"4", "What every viewer reads."},
                       {"8", "A second set of weights, which many viewers and engines leave out."}},
           .help = "The most bones that a vertex hangs on, where weights are fitted.",
           .row = {.section = "options"}},
          &CompressSettings::influences),
      setting<CompressSettings>(
          {.name = "scale_limit",
           .minimum = 1.0,
           .maximum = 10.0,
           .help = "How far bones that are measured may be scaled: by no more than this, no less than 1 over "
                   "it."},
          [](auto& s) -> auto& { return s.fit.largestScale; }),
  };
}

Schema<CompressSettings> fitSettings() {
  return {
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

const Schema<EncodeSettings>& clipSchema() {
  static const Schema<EncodeSettings> schema = {
      setting<EncodeSettings>({.name = "quantise",
                               .help = "Rotations and weights as 16-bit integers, as glTF allows.",
                               .row = {.section = "clip"}},
                              &EncodeSettings::quantise),
      setting<EncodeSettings>(
          {.name = "quantise_mesh",
           .help = "Positions, normals, texture coordinates and colours as integers (KHR_mesh_quantization).",
           .row = {.section = "clip", .label = "Pack mesh"}},
          &EncodeSettings::quantiseMesh),
      setting<EncodeSettings>({.name = "meshopt",
                               .help = "All data but images compressed (EXT_meshopt_compression).",
                               .row = {.section = "clip"}},
                              &EncodeSettings::meshopt),
      setting<EncodeSettings>(
          {.name = "key_tolerance",
           .maximum = 10.0,
           .unit = "%",
           .help = "How far leaving out keys may move a vertex in any frame, of the diagonal; 0: every frame "
                   "is a key.",
           .row = {.section = "clip", .label = "Keys off by", .maximum = 0.5, .step = 0.01}},
          &EncodeSettings::keyTolerancePercent),
  };
  return schema;
}

const Schema<CompressSettings>& sequenceSchema() {
  static const Schema<CompressSettings> schema =
      joined<CompressSettings>({boneSettings(), skinSettings(), fitSettings(), bodySettings()});
  return schema;
}

} // namespace stretch::app
