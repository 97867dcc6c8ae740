#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <fmt/core.h>

#include "app/batch/output.h"
#include "app/batch/output_file.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/document.h"
#include "app/edits/trail/starting_settings.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/frame_count.h"
#include "app/named.h"
#include "app/schema/parse_text.h"
#include "app/schema/weight_schema.h"
#include "app/things/place.h"
#include "core/anim/frames.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct ElasticArguments {
  FileArguments input;
  OutputArguments output;
  std::vector<std::string> limbs;
  std::string range;
  std::string moduli;
  SettingTexts settings;
  JsonOutput json;
};

Status readModuli(const std::string& path, WeightSettings& settings) {
  const Result<skinning::SegmentModuli> moduli = loadModuli(path);
  if (!moduli) {
    return moduli.error();
  }
  settings.moduli = moduli->ranges;
  settings.youngModulus = moduli->youngModulus ? moduli->youngModulus : settings.youngModulus;
  return Success{};
}

Result<WeightSettings> settingsOf(const ElasticArguments& arguments, WeightSettings settings) {
  if (!arguments.moduli.empty()) {
    if (const Status read = readModuli(arguments.moduli, settings); !read) {
      return read.error();
    }
  }
  if (const Status set = setFromTexts(weightSchema(), arguments.settings, settings); !set) {
    return set.error();
  }
  if (!arguments.range.empty()) {
    const Result<Vec2> range = parseRange(arguments.range, "--range");
    if (!range) {
      return range.error();
    }
    settings.rangeFrames = *range;
  }
  return settings;
}

std::vector<std::string> allButTrunk(const Document& document) {
  std::vector<std::string> limbs;
  for (const rig::Limb& limb : document.body.limbs) {
    if (!isTrunk(limb)) {
      limbs.push_back(limb.id);
    }
  }
  return limbs;
}

/// A range that the clip has in part is cut to that part; the answer says so, else it is empty.
Result<std::string> cutToClip(const Document& document, int clip, WeightSettings& settings) {
  const double last = lastFrame(clipOf(document, clip));
  if (!settings.rangeFrames || (settings.rangeFrames->x >= 0.0 && settings.rangeFrames->y <= last)) {
    return std::string();
  }
  if (settings.rangeFrames->x >= last || settings.rangeFrames->y <= 0.0) {
    return Error{fmt::format("the range lies outside the clip, which has the frames 0 to {:g}", last),
                 "--range", "give frames of the clip"};
  }
  settings.rangeFrames =
      Vec2(std::max(0.0, settings.rangeFrames->x), std::min(last, settings.rangeFrames->y));
  return fmt::format("the range is cut to the frames {:g} to {:g}, which the clip has",
                     settings.rangeFrames->x, settings.rangeFrames->y);
}

Status addLimbs(const ElasticArguments& arguments, int clip, const std::optional<Vec2>& rangeFrames,
                Document& document) {
  const std::vector<std::string> wanted = arguments.limbs.empty() ? allButTrunk(document) : arguments.limbs;
  if (wanted.empty()) {
    return Error{"no limb but the trunk was found", document.source->path.string(),
                 "name a limb of the trunk or a chain, such as --limb JOINT_A..JOINT_B"};
  }
  std::vector<WeightedLimb> weights;
  for (const std::string& name : wanted) {
    const Result<rig::Limb> limb = findOrAddLimb(document, name, "--limb");
    if (!limb) {
      return limb.error();
    }
    Result<WeightSettings> settings = settingsOf(arguments, usualWeight(document, limb->id));
    if (!settings) {
      return settings.error();
    }
    settings->rangeFrames = rangeFrames;
    if (Status known = checkModuli(settings->moduli, limb->joints.size(), limb->id + ": moduli"); !known) {
      return known;
    }
    weights.push_back({limb->id, clip, true, std::move(*settings)});
  }
  Result<Placed> placed = placeOf<WeightedLimb>(document, std::move(weights), Entry::request);
  if (!placed) {
    return placed.error();
  }
  document = std::move(placed->document);
  return Success{};
}

Status runElastic(const ElasticArguments& arguments) {
  if (Status apart = checkOutput(arguments.output.file, {arguments.input.file, arguments.moduli}); !apart) {
    return apart;
  }
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<int> clip = clipOfArguments(arguments.input, *document);
  if (!clip) {
    return clip.error();
  }
  if (Status bounded = checkFrameCount(clipOf(*document, *clip)); !bounded) {
    return bounded;
  }
  Result<WeightSettings> settings = settingsOf(arguments, {});
  if (!settings) {
    return settings.error();
  }
  const Result<std::string> cut = cutToClip(*document, *clip, *settings);
  if (!cut) {
    return cut.error();
  }
  if (Status added = addLimbs(arguments, *clip, settings->rangeFrames, *document); !added) {
    return added;
  }
  EvaluationCache cache;
  Json report;
  report["clip"] = clipOf(*document, *clip).name;
  report["elastic"] = weightJson(*document, *clip, cache);
  report["warnings"] = documentWarnings(*document);
  if (!cut->empty()) {
    report["warnings"].push_back(*cut);
  }
  if (Status saved = saveReported(*document, arguments.output, report, cache); !saved) {
    return saved;
  }
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    printWeight(report["elastic"]);
    printWarnings(report["warnings"]);
    printSaved(report);
  }
  return Success{};
}

} // namespace

Verb elasticVerb() {
  return {"elastic", "Gives limbs of a clip weight: they sag, squash and stretch by their own load.",
          [](CommandLine& line) {
            const auto arguments = std::make_shared<ElasticArguments>();
            line.examples({"dummy.glb -o heavy.glb --stiffness 0.6"});
            addFileArguments(line, arguments->input);
            addPlan(line, arguments->input);
            addOutputArguments(line, arguments->output);
            addClipArguments(line, arguments->input);
            line.repeated("--limb", arguments->limbs,
                          "A limb, as often as wanted; default: all but those of the trunk");
            line.option("--range", arguments->range, "First and last frame, A:B; default: the whole clip")
                .check(problemOfRange);
            addSettingOptions(line, weightSchema(), arguments->settings, "Weight");
            line.option("--moduli", arguments->moduli,
                        "Moduli of single bones (JSON), counted from the limb's base")
                .group("Weight");
            addJson(line, arguments->json);
            return [arguments] { return runElastic(*arguments); };
          }};
}

} // namespace stretch::app
