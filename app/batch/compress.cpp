#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>

#include <fmt/core.h>
#include <unistd.h>

#include "app/batch/options.h"
#include "app/batch/sequence_report.h"
#include "app/batch/verb.h"
#include "app/schema/trail_description.h"
#include "core/gltf/edits.h"
#include "core/gltf/json.h"
#include "skinning/compress/compress.h"
#include "skinning/elastic/moduli.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::app {

namespace {

struct CompressArguments {
  std::vector<std::string> sequence;
  std::string output;
  std::string stretch = "elastic";
  std::string weights = "fitted";
  std::string length = "line";
  std::string moduli;
  std::string gravity;
  int bones = 30;
  std::size_t skip = 0;
  double young = 0.0;
  double mass = 0.0;
  double metresPerUnit = 1.0;
  double framesPerSecond = 0.0;
  bool quantise = false;
  bool json = false;
};

Result<skinning::CompressSettings> settingsOf(const CompressArguments& arguments) {
  skinning::CompressSettings settings;
  settings.bones = arguments.bones;
  settings.stretch = arguments.stretch == "none"      ? skinning::StretchOption::none
                     : arguments.stretch == "elastic" ? skinning::StretchOption::elastic
                                                      : skinning::StretchOption::measured;
  settings.weights =
      arguments.weights == "geodesic" ? skinning::WeightOption::geodesic : skinning::WeightOption::fitted;
  settings.body.lengthModel =
      arguments.length == "line" ? skinning::LengthModel::line : skinning::LengthModel::monotone;
  settings.body.firstFittedFrame = arguments.skip;
  settings.body.metresPerUnit = arguments.metresPerUnit;
  if (arguments.young > 0.0) {
    settings.body.youngModulus = arguments.young;
  }
  if (arguments.mass > 0.0) {
    settings.body.mass = arguments.mass;
  }
  if (!arguments.gravity.empty()) {
    const Result<Vec3> gravity = parseVector(arguments.gravity, "--gravity");
    if (!gravity) {
      return gravity.error();
    }
    settings.body.gravity = *gravity;
  }
  if (!arguments.moduli.empty()) {
    Result<skinning::SegmentModuli> moduli = loadModuli(arguments.moduli);
    if (!moduli) {
      return moduli.error();
    }
    settings.body.moduli = std::move(*moduli);
  }
  return settings;
}

/// Tells how far the work is where somebody looks: at a terminal.
skinning::Proceed terminalProgress() {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  return [](double share) {
    fmt::print(stderr, "\rcompressing: {:.0f} %{}", 100.0 * share, share < 1.0 ? "" : "\r\033[K");
    std::fflush(stderr);
    return true;
  };
}

Status runCompress(const CompressArguments& arguments) {
  const Result<skinning::CompressSettings> settings = settingsOf(arguments);
  if (!settings) {
    return settings.error();
  }
  Result<MeshSequence> sequence = readSequenceWords(arguments.sequence);
  if (!sequence) {
    return sequence.error();
  }
  if (arguments.framesPerSecond > 0.0) {
    sequence->framesPerSecond = arguments.framesPerSecond;
  }
  // Told to the user and nothing else: no result depends on the clock.
  const auto start = std::chrono::steady_clock::now();
  const Result<skinning::CompressedSequence> compressed =
      skinning::compress(*sequence, *settings, terminalProgress());
  if (!compressed) {
    return compressed.error();
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  skinning::EncodeSettings encoding;
  encoding.quantise = arguments.quantise;
  const skinning::EncodedClip encoded = skinning::encodeGltf(compressed->skinned, encoding);
  if (const Status saved = gltf::save(encoded.source, arguments.output); !saved) {
    return saved;
  }
  gltf::Json report = compressionJson(*sequence, *compressed, encoded);
  report["seconds"] = seconds;
  if (arguments.json) {
    std::cout << report.dump(1) << '\n';
  } else {
    printCompression(report);
  }
  return Success{};
}

} // namespace

Verb compressVerb() {
  return {
      "compress", "Turns a mesh sequence into a small skinned clip.", [](CommandLine& line) {
        const auto arguments = std::make_shared<CompressArguments>();
        line.options("SEQUENCE", arguments->sequence,
                     "A folder of OBJ or PLY frames, BASE.obj CACHE.pc2, an animated glTF, or a "
                     "Sibernetic folder")
            .required()
            .takes(1, 2);
        line.option("-o,--output", arguments->output, "The .glb to write").required();
        line.option("--bones", arguments->bones, "Bones along the body").between(1, 1000).showDefault();
        line.option("--stretch", arguments->stretch, "none, elastic (the model) or measured")
            .oneOf({"none", "elastic", "measured"})
            .showDefault();
        line.option("--weights", arguments->weights, "geodesic or fitted to the frames")
            .oneOf({"geodesic", "fitted"})
            .showDefault();
        line.option("--length", arguments->length,
                    "Length as a function of curvature: the paper's line, or a monotone curve")
            .oneOf({"line", "monotone"})
            .showDefault();
        line.option("--skip", arguments->skip, "Settling frames that no fit uses");
        line.option("--young", arguments->young, "Young's modulus [Pa]; default: fitted").positive();
        line.option("--mass", arguments->mass, "Mass of the body [kg]; default: that of water").positive();
        line.option("--moduli", arguments->moduli, "JSON of moduli by segment");
        line.option("--gravity", arguments->gravity, "x,y,z [m/s^2]; default: 0,-9.81,0");
        line.option("--metres-per-unit", arguments->metresPerUnit, "Scale of the mesh")
            .positive()
            .showDefault();
        line.option("--fps", arguments->framesPerSecond, "Frames per second of the clip").positive();
        line.flag("--quantise", arguments->quantise, "Rotations and weights as 16-bit integers");
        line.flag("--json", arguments->json, "Print one JSON document");
        return [arguments] { return runCompress(*arguments); };
      }};
}

} // namespace stretch::app
