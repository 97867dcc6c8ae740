#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "app/batch/weight_report.h"
#include "app/document.h"
#include "app/edits/weight_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/quality.h"
#include "app/files/save.h"
#include "app/recipe/recipe.h"
#include "app/schema/trail_json.h"
#include "core/gltf/json.h"
#include "rig/limb_points.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct ExaggerateArguments {
  FileArguments input;
  std::string output;
  std::string clip;
  std::string recipe;
  SaveOptions save;
  bool json = false;
};

// One "--limb" with the options that follow it; options before the first one hold for every trail.
struct TrailRequest {
  std::string limb;
  std::string range;
  std::vector<std::pair<const TrailSetting*, std::string>> settings;
  bool noPull = false;
};

std::vector<TrailRequest> requestsOf(const CommandLine& line) {
  TrailRequest common;
  std::vector<TrailRequest> requests;
  for (const auto& [name, text] : line.inOrder()) {
    if (name == "--limb") {
      requests.push_back(common);
      requests.back().limb = text;
      continue;
    }
    TrailRequest& request = requests.empty() ? common : requests.back();
    if (name == "--range") {
      request.range = text;
    } else if (name == "--no-pull") {
      request.noPull = true;
    }
    for (const TrailSetting& setting : trailSettings()) {
      if (name == setting.option) {
        request.settings.emplace_back(&setting, text);
      }
    }
  }
  return requests;
}

bool namesScale(const TrailRequest& request) {
  return std::any_of(request.settings.begin(), request.settings.end(),
                     [](const auto& named) { return named.first->name == "scale"; });
}

Result<rig::Trail> trailOf(const TrailRequest& request, int clip, Document& document) {
  if (!namesScale(request)) {
    return Error{"has no scale", "--limb " + request.limb, "say how long it becomes, such as --scale 2"};
  }
  const Result<rig::Limb> limb = findOrAddLimb(document, request.limb);
  if (!limb) {
    return limb.error();
  }
  rig::Trail trail;
  trail.limb = limb->id;
  trail.clip = clip;
  const Result<Vec2> range =
      request.range.empty() ? Result<Vec2>(rig::defaultRange(*document.scene, clipOf(document, clip), *limb))
                            : rangeOf(request.range, clipOf(document, clip));
  if (!range) {
    return range.error();
  }
  trail.settings.startFrame = range->x;
  trail.settings.endFrame = range->y;
  trail.settings.pull = !request.noPull;
  for (const auto& [setting, text] : request.settings) {
    const Result<Json> value = parseSettingText(*setting, text);
    if (!value) {
      return value.error();
    }
    if (const Status set = setTrailSetting(*setting, *value, trail.settings); !set) {
      return Error{set.error().what, setting->option, set.error().remedy};
    }
  }
  return trail;
}

Result<Recipe> plannedTrails(const ExaggerateArguments& arguments, const std::vector<TrailRequest>& requests,
                             Document& document) {
  if (!arguments.recipe.empty()) {
    return loadRecipe(arguments.recipe, document);
  }
  const Result<int> clip = findClip(document, arguments.clip);
  if (!clip) {
    return clip.error();
  }
  Recipe plan;
  plan.clip = *clip;
  for (const TrailRequest& request : requests) {
    Result<rig::Trail> trail = trailOf(request, *clip, document);
    if (!trail) {
      return trail.error();
    }
    plan.trails.push_back(std::move(*trail));
  }
  return plan;
}

bool overlapInTime(const rig::Trail& a, const rig::Trail& b) {
  return a.limb == b.limb && a.clip == b.clip && a.settings.startFrame < b.settings.endFrame &&
         b.settings.startFrame < a.settings.endFrame;
}

// Puts the new trails and the weight of limbs in, applied. A trail that the file already carries on the same
// limb at the same time is replaced.
Result<std::vector<int>> applyTrails(const Recipe& plan, Document& document) {
  std::vector<int> ids;
  for (const rig::Trail& wanted : plan.trails) {
    const auto overlapsNew = [&](int id) { return overlapInTime(*findTrail(document, id), wanted); };
    if (std::any_of(ids.begin(), ids.end(), overlapsNew)) {
      return Error{"two trails on " + wanted.limb + " overlap in time", "--limb",
                   "give them ranges apart from each other"};
    }
    std::erase_if(document.trails, [&](const rig::Trail& old) { return overlapInTime(old, wanted); });
    rig::Trail trail = wanted;
    trail.id = document.nextTrailId++;
    trail.exaggerated = true;
    trail.connected = true;
    trail.applied = trail.settings;
    ids.push_back(trail.id);
    document.trails.push_back(std::move(trail));
  }
  for (const WeightedLimb& wanted : plan.weights) {
    Result<Document> changed = setWeight(document, wanted);
    if (!changed) {
      return changed.error();
    }
    document = std::move(*changed);
  }
  return ids;
}

Json trailReport(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& solved) {
  const double tipSeconds = solved.tipSeconds;
  Json warnings = solved.warnings;
  for (const std::string& warning : motionWarnings(document, motion, solved)) {
    warnings.push_back(warning);
  }
  const double before = rig::limbLength(solved.limb, evaluateOriginal(document, motion.clip, tipSeconds));
  const double after = rig::limbLength(solved.limb, evaluate(document, motion, tipSeconds));
  const double reference =
      solved.settings.reference == rig::Reference::pose ? before : solved.limb.restLength;
  const double wanted = solved.settings.scale * reference;
  constexpr double tolerance = 1e-4;
  return {{"limb", solved.limb.id},
          {"range", {solved.settings.startFrame, solved.settings.endFrame}},
          {"tip", vectorToJson(solved.path.toWorld(solved.settings.pivot == rig::Pivot::start
                                                       ? solved.path.samples.back()
                                                       : solved.path.samples.front(),
                                                   solved.tip.tip))},
          {"trail_scale", solved.tip.trailScale ? Json(*solved.tip.trailScale) : Json(nullptr)},
          {"moved", solved.tip.moved},
          {"reached", solved.tip.outcome != rig::TipOutcome::nothingToScale &&
                          std::abs(after - wanted) <= tolerance * wanted},
          {"pulled", solved.tip.outcome == rig::TipOutcome::pulled},
          {"release", solved.release.seconds() * motion.framesPerSecond},
          {"limb_length_before", before},
          {"limb_length_after", after},
          {"warnings", std::move(warnings)}};
}

Json reportOf(const Document& document, int clip, const std::vector<int>& ids) {
  Json report;
  report["clip"] = clipOf(document, clip).name;
  report["trails"] = Json::array();
  rig::MotionState motion = prepareMotion(document, clip);
  motion.weights.clear(); // What the trails do by themselves.
  for (const int id : ids) {
    const auto solved = std::find_if(motion.trails.begin(), motion.trails.end(),
                                     [&](const rig::SolvedTrail& trail) { return trail.trail.id == id; });
    if (solved != motion.trails.end()) {
      report["trails"].push_back(trailReport(document, motion, *solved));
    }
  }
  if (hasWeight(document, clip)) {
    report["elastic"] = weightJson(document, clip);
  }
  report["warnings"] = document.warnings;
  return report;
}

void printTrails(const Json& report) {
  for (const Json& trail : report["trails"]) {
    fmt::print("{}: frames {:g} to {:g}, {:.4g} -> {:.4g} long{}\n", trail["limb"].get<std::string>(),
               trail["range"][0].get<double>(), trail["range"][1].get<double>(),
               trail["limb_length_before"].get<double>(), trail["limb_length_after"].get<double>(),
               trail["pulled"].get<bool>() ? " (pulled)" : "");
    for (const Json& warning : trail["warnings"]) {
      fmt::print(stderr, "warning: {}\n", warning.get<std::string>());
    }
  }
  if (report.contains("elastic")) {
    printWeight(report["elastic"]);
  }
}

Status runExaggerate(const ExaggerateArguments& arguments, const std::vector<TrailRequest>& requests) {
  if (arguments.recipe.empty() && requests.empty()) {
    return Error{"no limb was named", "--limb", "name one, such as --limb left-arm, or give a --recipe"};
  }
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<Recipe> plan = plannedTrails(arguments, requests, *document);
  if (!plan) {
    return plan.error();
  }
  const Result<std::vector<int>> ids = applyTrails(*plan, *document);
  if (!ids) {
    return ids.error();
  }
  const Json report = reportOf(*document, plan->clip, *ids);
  if (const Status saved = saveDocument(*document, arguments.output, arguments.save); !saved) {
    return saved;
  }
  if (arguments.json) {
    std::cout << report.dump(1) << '\n';
  } else {
    printTrails(report);
  }
  return Success{};
}

std::string optionHelp(const TrailSetting& setting) {
  std::string choices;
  for (const std::string& choice : setting.choices) {
    choices += (choices.empty() ? " (" : ", ") + choice;
  }
  return setting.help + (choices.empty() ? "" : choices + ")") +
         (setting.unit.empty() ? "" : " [" + setting.unit + "]");
}

// The command line names the option itself.
std::string withoutPlace(Error error) {
  error.where.clear();
  return error.line();
}

// A value that no trail can have is a wrong argument: found before any file is opened.
std::string checkSettingText(const TrailSetting& setting, const std::string& text) {
  const Result<Json> value = parseSettingText(setting, text);
  rig::TrailSettings scratch;
  if (!value) {
    return withoutPlace(value.error());
  }
  const Status set = setTrailSetting(setting, *value, scratch);
  return set ? std::string() : withoutPlace(set.error());
}

std::string checkRangeText(const std::string& text) {
  const Result<Vec2> range = parseRange(text);
  return range ? std::string() : withoutPlace(range.error());
}

void addTrailOptions(CommandLine& line) {
  constexpr const char* group = "Trail (each --limb starts the next)";
  line.ordered("--limb", "left-arm, right-arm, left-leg, right-leg, spine, neck or JOINT_A..JOINT_B")
      .group(group);
  line.ordered("--range", "First and last frame, A:B; default: to the frame at which the limb's end is "
                          "farthest from its start")
      .check(checkRangeText)
      .group(group);
  for (const TrailSetting& setting : trailSettings()) {
    if (setting.kind == SettingKind::flag && !setting.option.empty()) {
      line.orderedFlag(setting.option, optionHelp(setting)).group(group);
    } else if (!setting.option.empty()) {
      line.ordered(setting.option, optionHelp(setting))
          .check([&setting](const std::string& text) { return checkSettingText(setting, text); })
          .group(group);
    }
  }
  line.orderedFlag("--no-pull",
                   "Leave the tip at the closest approach where its line does not reach the wanted length")
      .group(group);
}

} // namespace

Verb exaggerateVerb() {
  return {"exaggerate", "Exaggerates limbs of a clip, re-keys it and saves the file.", [](CommandLine& line) {
            const auto arguments = std::make_shared<ExaggerateArguments>();
            addFileArguments(line, arguments->input);
            line.option("-o,--output", arguments->output, "The .glb or .gltf to write").required();
            line.option("--clip", arguments->clip, "Name or #index of the clip; default: the first");
            addFramesPerSecond(line, arguments->input);
            line.option("--recipe", arguments->recipe, "A recipe (JSON) instead of --limb and its options");
            addTrailOptions(line);
            line.flag("--key-every-frame", arguments->save.keyEveryFrame,
                      "A key on every frame of range and release");
            line.flag("--keep-skeleton", arguments->save.keepSkeleton,
                      "Stretch through translations only: no bind joints");
            line.flag("--clean", arguments->save.clean, "Leave the program's own data out of the file");
            line.flag("--json", arguments->json, "Print one JSON document");
            return [arguments, line] { return runExaggerate(*arguments, requestsOf(line)); };
          }};
}

} // namespace stretch::app
