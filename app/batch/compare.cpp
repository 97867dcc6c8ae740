#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/batch/sequence_report.h"
#include "app/batch/verb.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::app {

namespace {

struct CompareArguments {
  std::string reference;
  std::string other;
  bool json = false;
};

// `framesPerSecond` 0: at the rate that the file's own keys suggest.
Result<MeshSequence> readAny(const std::string& path, double framesPerSecond) {
  return std::filesystem::is_directory(path) ? readSequenceWords({path})
                                             : skinning::readAnimatedGltf(path, {}, {}, framesPerSecond);
}

Status runCompare(const CompareArguments& arguments) {
  const Result<MeshSequence> reference = readAny(arguments.reference, 0.0);
  // Both are looked at on the frames of the reference, whatever keys the other one has.
  const bool hasRate = reference && !std::filesystem::is_directory(arguments.reference);
  const Result<MeshSequence> other = readAny(arguments.other, hasRate ? reference->framesPerSecond : 0.0);
  if (!reference || !other) {
    return reference ? other.error() : reference.error();
  }
  const Result<skinning::SequenceMetrics> metrics = skinning::compareSequences(*reference, *other);
  if (!metrics) {
    return metrics.error();
  }
  const gltf::Json report = metricsJson(*metrics);
  if (arguments.json) {
    std::cout << report.dump(1) << '\n';
  } else {
    printMetrics(report);
  }
  return Success{};
}

} // namespace

Verb compareVerb() {
  return {"compare", "Compares two animated files or sequences with the same topology.", [](CLI::App& app) {
            const auto arguments = std::make_shared<CompareArguments>();
            app.add_option("A", arguments->reference, "The reference: an animated glTF or a folder of frames")
                ->required();
            app.add_option("B", arguments->other, "What is compared with it")->required();
            app.add_flag("--json", arguments->json, "Print one JSON document");
            return [arguments] { return runCompare(*arguments); };
          }};
}

} // namespace stretch::app
