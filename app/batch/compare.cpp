#include <array>
#include <filesystem>
#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/sequence_report.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/schema/sequence_schema.h"
#include "core/base/number.h"
#include "core/gltf/json/json.h"
#include "skinning/compress/flattening.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::app {

namespace {

constexpr std::array bodySettings{"gravity", "mass", "metres_per_unit"};

struct CompareArguments {
  std::vector<std::string> words;
  std::string clip;
  bool flattening = false;
  SettingTexts body;
  skinning::StedSettings sted;
  JsonOutput json;
};

/// One side of the comparison: a path, or a base mesh and its cache.
using Words = std::vector<std::string>;

/// A cache belongs to the mesh before it; everything else is a side of its own.
std::vector<Words> sidesOf(const Words& words, bool (*isBase)(const std::filesystem::path&)) {
  std::vector<Words> sides;
  for (const std::string& word : words) {
    const bool joins = !sides.empty() && sides.back().size() == 1 && skinning::isPointCache(word) &&
                       isBase(sides.back().front());
    if (joins) {
      sides.back().push_back(word);
    } else {
      sides.push_back({word});
    }
  }
  return sides;
}

/// A glTF before a cache is a side of its own, unless there would be too many.
Result<std::pair<Words, Words>> twoSides(const Words& words) {
  std::vector<Words> sides = sidesOf(words, skinning::isMeshFile);
  if (sides.size() > 2) {
    sides = sidesOf(words, skinning::isBaseMesh);
  }
  if (sides.size() != 2) {
    return Error{fmt::format("two are compared, {} were named", sides.size()), "compare",
                 "name two: each an animated glTF, a folder of frames, or a BASE mesh and its CACHE"};
  }
  return std::pair(sides[0], sides[1]);
}

bool isGltf(const Words& side) {
  return side.size() == 1 && skinning::isGltfFile(side.front());
}

/// `clip`: of a glTF, by name or #index. `framesPerSecond` 0: at the rate that the file's own keys suggest.
Result<MeshSequence> readSide(const Words& side, const std::string& clip, double framesPerSecond) {
  return isGltf(side) ? skinning::readAnimatedGltf(side.front(), clip, {}, framesPerSecond)
                      : readSequenceWords(side);
}

/// Oddities of both sides, each with the file that it is about: of several clips which one was taken, too.
gltf::Json warningsOf(const std::pair<Words, Words>& sides, const MeshSequence& reference,
                      const MeshSequence& other) {
  gltf::Json warnings = gltf::Json::array();
  for (const auto& [side, sequence] :
       {std::pair(&sides.first, &reference), std::pair(&sides.second, &other)}) {
    for (const std::string& warning : sequence->warnings) {
      warnings.push_back(std::filesystem::path(side->front()).filename().string() + ": " + warning);
    }
  }
  return warnings;
}

gltf::Json flatteningJson(const skinning::Flattening& flattening) {
  return {{"height", flattening.height},
          {"width", flattening.width},
          {"length", flattening.length},
          {"compression", flattening.compression},
          {"predicted_height", flattening.predictedHeight},
          {"predicted_width", flattening.predictedWidth},
          {"young", flattening.youngModulus}};
}

Status addFlattening(const CompareArguments& arguments, const MeshSequence& with, const MeshSequence& without,
                     gltf::Json& report) {
  skinning::CompressSettings settings;
  if (Status set = setFromTexts(sequenceSchema(), arguments.body, settings); !set) {
    return set;
  }
  const auto flattening = skinning::gravityFlattening(with, without, settings.body);
  if (!flattening) {
    return flattening.error();
  }
  report["flattening"] = flatteningJson(*flattening);
  return Success{};
}

void printFlattening(const gltf::Json& report) {
  const auto number = [&](const char* key) { return report[key].get<double>(); };
  fmt::print(
      "gravity at mid-body, last frames: height x {:.3f}, width x {:.3f}, length x {:.3f}\n"
      "the model comes closest with q {:.3f} (height x {:.3f}, width x {:.3f}): a modulus of {:.4g} Pa\n",
      number("height"), number("width"), number("length"), number("compression"), number("predicted_height"),
      number("predicted_width"), number("young"));
}

Status runCompare(const CompareArguments& arguments) {
  const Result<std::pair<Words, Words>> sides = twoSides(arguments.words);
  if (!sides) {
    return sides.error();
  }
  if (!arguments.clip.empty() && !isGltf(sides->first) && !isGltf(sides->second)) {
    return Error{"neither of the two has clips to choose from", "--clip", "leave it out"};
  }
  Result<MeshSequence> reference = readSide(sides->first, arguments.clip, 0.0);
  // Both are looked at on the frames of the reference, whatever keys the other one has.
  const bool hasRate = reference && isGltf(sides->first);
  Result<MeshSequence> other =
      readSide(sides->second, arguments.clip, hasRate ? reference->framesPerSecond : 0.0);
  if (!reference || !other) {
    return reference ? other.error() : reference.error();
  }
  skinning::joinUntilAlike(*reference, *other);
  const Result<skinning::SequenceMetrics> metrics =
      skinning::compareSequences(*reference, *other, arguments.sted);
  if (!metrics) {
    return metrics.error();
  }
  gltf::Json report = metricsJson(*metrics);
  report["warnings"] = warningsOf(*sides, *reference, *other);
  if (const std::string frame = skinning::frameOfErrors(*reference); !frame.empty()) {
    report["warnings"].push_back(frame);
  }
  if (arguments.flattening) {
    if (Status done = addFlattening(arguments, *reference, *other, report); !done) {
      return done;
    }
  }
  if (arguments.json) {
    arguments.json.print(report);
    return Success{};
  }
  printMetrics(report);
  if (arguments.flattening) {
    printFlattening(report["flattening"]);
  }
  printWarnings(report["warnings"]);
  return Success{};
}

void addStedOptions(CommandLine& line, skinning::StedSettings& sted) {
  const auto check = [](double least, const char* what) {
    return [least, what](const std::string& text) {
      const auto number = stretch::parseNumber(text);
      return number && *number >= least ? std::string() : "'" + text + "' is no " + what;
    };
  };
  line.option("--sted-rings", sted.rings, "Rings of triangles around a vertex that are its neighbourhood")
      .between(1, 8)
      .showDefault()
      .group("STED");
  line.option("--sted-window", sted.window, "Frame steps of the temporal part, odd")
      .check([](const std::string& text) {
        const auto number = stretch::parseNumber<int>(text);
        return number && *number >= 1 && *number % 2 == 1 ? std::string()
                                                          : "'" + text + "' is no odd number from 1 on";
      })
      .showDefault()
      .group("STED");
  line.option("--sted-dt", sted.timeStep,
              "Length that a step in time counts for; 0: a tenth of the mean edge")
      .check(check(0.0, "number from 0 on"))
      .showDefault()
      .group("STED");
  line.option("--sted-c", sted.c, "Weight of the temporal part")
      .check(check(0.0, "number from 0 on"))
      .showDefault()
      .group("STED");
}

Status checkBody(const CompareArguments& arguments) {
  for (const char* const name : bodySettings) {
    const SettingFacts& setting = *findSetting(sequenceSchema(), name);
    if (!arguments.flattening && textOf(arguments.body, setting) != nullptr) {
      return Error{"counts for a flattening alone", setting.option,
                   "give --flattening as well, or leave it out"};
    }
  }
  return Success{};
}

} // namespace

Verb compareVerb() {
  return {
      "compare", "Compares two animated files or sequences with the same topology.", [](CommandLine& line) {
        const auto arguments = std::make_shared<CompareArguments>();
        line.examples({"dummy.glb punch.glb", "dummy.glb punch.glb --clip Guard"});
        line.options("FILES", arguments->words,
                     "The reference and what is compared with it: each an animated glTF, a folder of "
                     "frames, or BASE CACHE (a mesh and its .pc2 or .mdd)")
            .required()
            .takes(2, 4);
        line.option("--clip", arguments->clip, "Name or #index of the clip of each glTF; default: its first");
        line.flag("--flattening", arguments->flattening,
                  "A ran with gravity, B without: how flat A is, and the modulus that explains it");
        for (const char* const name : bodySettings) {
          addSettingOption(line, *findSetting(sequenceSchema(), name), arguments->body, "Flattening");
        }
        addStedOptions(line, arguments->sted);
        addJson(line, arguments->json);
        line.checkTogether([arguments](const CommandLine&) { return checkBody(*arguments); });
        return [arguments] { return runCompare(*arguments); };
      }};
}

} // namespace stretch::app
