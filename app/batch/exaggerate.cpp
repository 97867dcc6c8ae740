#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "app/batch/auto_options.h"
#include "app/batch/options.h"
#include "app/batch/output.h"
#include "app/batch/output_file.h"
#include "app/batch/pose_report.h"
#include "app/batch/trail_options.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/clip_facts.h"
#include "app/recipe/replay.h"
#include "core/gltf/json/json.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

struct ExaggerateArguments {
  FileArguments input;
  OutputArguments output;
  std::string recipe;
  bool loops = false;
  AutoArguments every;
  JsonOutput json;
};

Result<Recipe> wantedTrails(const ExaggerateArguments& arguments, const std::vector<TrailRequest>& requests,
                            Document& document) {
  if (!arguments.recipe.empty()) {
    return loadRecipe(arguments.recipe, arguments.input, document);
  }
  const Result<int> clip = clipOfArguments(arguments.input, document);
  return clip ? recipeOf(requests, *clip, document) : Result<Recipe>(clip.error());
}

Result<PlacedTrails> appliedRecipe(const Document& document, const Recipe& recipe) {
  Result<PlacedTrails> placed = withRecipe(document, recipe);
  for (std::size_t i = 0; placed && i < placed->trailIds.size(); ++i) {
    Result<Document> applied = applyTrail(placed->document, placed->trailIds[i]);
    if (!applied) {
      return applied.error();
    }
    placed->document = std::move(*applied);
  }
  return placed;
}

// The last text of an option that may come more than once; empty without it.
std::string lastOf(const CommandLine& line, const std::string& option) {
  std::string last;
  for (const auto& [name, text] : line.inOrder()) {
    last = name == option ? text : last;
  }
  return last;
}

// A recipe's trails are judged by the camera that the command names, where they name none.
void setCamera(const std::string& camera, Recipe& recipe) {
  for (rig::Trail& trail : recipe.trails) {
    if (!trail.settings.sight.hasCamera()) {
      trail.settings.sight.camera = camera;
    }
  }
}

// What the arguments say against one another.
Status checkWays(const ExaggerateArguments& arguments, const CommandLine& line) {
  const std::vector<TrailRequest> requests = requestsOf(line);
  const std::vector<std::string> trailOptions = trailOptionsOf(line);
  if (arguments.every.wanted && (!arguments.recipe.empty() || !trailOptions.empty())) {
    return Error{"stands beside trails of your own", "--auto",
                 "leave out --recipe and all options of a trail, or --auto"};
  }
  if (arguments.every.allClips && !arguments.input.clip.empty()) {
    return Error{"stands beside --all-clips", "--clip", "give one of the two"};
  }
  if (arguments.every.wanted && arguments.loops) {
    return Error{"is found by --auto itself", "--loops", "leave it out"};
  }
  if (arguments.every.allClips && !arguments.recipe.empty()) {
    return Error{"stands beside --recipe, which names its clip", "--all-clips", "give one of the two"};
  }
  if (const std::string own = arguments.every.ownOption(); !arguments.every.wanted && !own.empty()) {
    return Error{"is for every moment at once", own, "give --auto as well"};
  }
  if (!arguments.every.wanted && arguments.recipe.empty() && requests.empty()) {
    return Error{"no limb was named", "--limb",
                 "name one, such as --limb left-arm, or give --auto or a --recipe"};
  }
  const auto other = std::ranges::find_if(trailOptions, [](const std::string& option) {
    return option != "--camera"; // it judges a recipe's trails, too
  });
  if (!arguments.recipe.empty() && other != trailOptions.end()) {
    return Error{"stands beside --recipe", *other, "give all trails by --limb, or all in the recipe"};
  }
  return checkTrailOptions(line);
}

// Places trails and tells what became of them.
Result<gltf::Json> exaggerated(const Recipe& recipe, bool loops, Document& document) {
  Result<PlacedTrails> placed =
      appliedRecipe(loops ? setLooping(document, recipe.clip, true) : document, recipe);
  if (!placed) {
    return placed.error();
  }
  const Document before = std::exchange(document, std::move(placed->document));
  gltf::Json report = exaggerationJson(document, recipe.clip, placed->trailIds);
  addGaveWay(before, document, report);
  if (!recipe.adjustments.empty() || !recipe.holds.empty()) {
    addPoseReport(document, recipe.clip, recipe.adjustments, report);
  } else {
    addFlips(document, recipe.clip, placed->trailIds, report);
  }
  return report;
}

// The trails that were named, or of the recipe.
Result<gltf::Json> exaggeratedClip(const ExaggerateArguments& arguments,
                                   const std::vector<TrailRequest>& requests, const std::string& camera,
                                   Document& document) {
  Result<Recipe> recipe = wantedTrails(arguments, requests, document);
  if (!recipe) {
    return recipe.error();
  }
  if (arguments.recipe.empty()) {
    return exaggerated(*recipe, arguments.loops, document);
  }
  setCamera(camera, *recipe);
  Result<gltf::Json> report = exaggerated(*recipe, arguments.loops, document);
  return report ? std::move(report) : inFile(arguments.recipe, report.error());
}

// The named trails that can be in a clip; why the others cannot is told.
gltf::Json exaggeratedWherePossible(const std::vector<TrailRequest>& requests, int clip, bool loops,
                                    const std::shared_ptr<CharacterFacts>& character, Document& document) {
  std::vector<int> ids;
  gltf::Json left = gltf::Json::array();
  for (const TrailRequest& request : requests) {
    Document changed = document;
    Result<Recipe> recipe = recipeOf({request}, clip, changed);
    if (recipe) {
      recipe->trails.front().colour = static_cast<int>(ids.size()) % dealtColours;
    }
    Result<PlacedTrails> placed =
        recipe ? appliedRecipe(loops ? setLooping(changed, clip, true) : changed, *recipe)
               : Result<PlacedTrails>(recipe.error());
    if (placed) {
      document = std::move(placed->document);
      ids.push_back(placed->trailIds.front());
    } else {
      left.push_back(request.limb + ": " + withoutPlace(placed.error()));
    }
  }
  gltf::Json report = exaggerationJson(document, clip, ids, character);
  addFlips(document, clip, ids, report);
  report.erase("warnings");
  report["left_out"] = std::move(left);
  return report;
}

Result<gltf::Json> exaggeratedClips(const ExaggerateArguments& arguments,
                                    const std::vector<TrailRequest>& requests, Document& document) {
  if (Status known = checkRequests(requests, document); !known) {
    return known.error();
  }
  gltf::Json clips = gltf::Json::array();
  const Document before = document;
  const auto character = std::make_shared<CharacterFacts>(document);
  for (int clip = 0; clip < static_cast<int>(document.clips->size()); ++clip) {
    clips.push_back(exaggeratedWherePossible(requests, clip, arguments.loops, character, document));
  }
  if (std::ranges::all_of(clips, [](const gltf::Json& clip) { return clip["trails"].empty(); })) {
    return Error{"none of the limbs can be exaggerated in any clip", "--all-clips",
                 "exaggerate one --clip to see why"};
  }
  gltf::Json report{{"clips", std::move(clips)}, {"warnings", documentWarnings(document)}};
  addGaveWay(before, document, report);
  return report;
}

void printClips(const gltf::Json& report) {
  for (const gltf::Json& clip : report["clips"]) {
    const auto name = clip["clip"].get<std::string>();
    fmt::print("{}:\n", name);
    printExaggeration(clip, name);
    for (const gltf::Json& left : clip["left_out"]) {
      fmt::print("left out: {}\n", left.get<std::string>());
    }
  }
  printWarnings(report["warnings"]);
}

Status runExaggerate(const ExaggerateArguments& arguments, const std::vector<TrailRequest>& requests,
                     const std::string& camera) {
  if (Status apart = checkOutput(arguments.output.file, {arguments.input.file, arguments.recipe}); !apart) {
    return apart;
  }
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const bool isAuto = arguments.every.wanted;
  Result<gltf::Json> report = isAuto ? autoExaggerated(arguments.every, arguments.input, *document)
                              : arguments.every.allClips
                                  ? exaggeratedClips(arguments, requests, *document)
                                  : exaggeratedClip(arguments, requests, camera, *document);
  if (!report) {
    return report.error();
  }
  if (Status saved = saveReported(*document, arguments.output, *report); !saved) {
    return saved;
  }
  if (arguments.json) {
    arguments.json.print(*report);
    return Success{};
  }
  if (isAuto) {
    printAuto(*report);
  } else if (arguments.every.allClips) {
    printClips(*report);
  } else {
    printExaggeration(*report);
  }
  printSaved(*report);
  return Success{};
}

} // namespace

Verb exaggerateVerb() {
  return {"exaggerate", "Exaggerates limbs of a clip, re-keys it and saves the file.", [](CommandLine& line) {
            const auto arguments = std::make_shared<ExaggerateArguments>();
            line.examples({"dummy.glb -o punch.glb --limb left-arm --range 21:27 --scale 3 --axes xz",
                           "dummy.glb -o punch.glb --recipe refined-punch.json",
                           "dummy.glb -o cartoon.glb --auto --style \"Rubber hose\" --all-clips"});
            addFileArguments(line, arguments->input);
            addPlan(line, arguments->input);
            addOutputArguments(line, arguments->output);
            addClipArguments(line, arguments->input);
            line.option("--recipe", arguments->recipe, "A recipe (JSON) instead of --limb and its options");
            line.flag("--loops", arguments->loops,
                      "The clip is played as a loop: a limb's way back at its end goes on at its start");
            addAutoOptions(line, arguments->every);
            addTrailOptions(line);
            addJson(line, arguments->json);
            line.checkTogether(
                [arguments](const CommandLine& given) { return checkWays(*arguments, given); });
            return [arguments, line] {
              return runExaggerate(*arguments, requestsOf(line), lastOf(line, "--camera"));
            };
          }};
}

} // namespace stretch::app
