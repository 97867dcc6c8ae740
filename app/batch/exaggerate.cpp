#include <memory>

#include "app/batch/output.h"
#include "app/batch/trail_options.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
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

Status runExaggerate(const ExaggerateArguments& arguments, const std::vector<TrailRequest>& requests) {
  if (arguments.recipe.empty() && requests.empty()) {
    return Error{"no limb was named", "--limb", "name one, such as --limb left-arm, or give a --recipe"};
  }
  if (!arguments.recipe.empty() && !requests.empty()) {
    return Error{"stands beside --recipe", "--limb", "give all trails by --limb, or all in the recipe"};
  }
  if (Status apart = checkOutput(arguments.output.file, {arguments.input.file, arguments.recipe}); !apart) {
    return apart;
  }
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<Recipe> recipe = wantedTrails(arguments, requests, *document);
  if (!recipe) {
    return recipe.error();
  }
  if (arguments.loops) {
    *document = setLooping(*document, recipe->clip, true);
  }
  const Result<PlacedTrails> placed = appliedRecipe(*document, *recipe);
  if (!placed) {
    return placed.error();
  }
  gltf::Json report = exaggerationJson(placed->document, recipe->clip, placed->trailIds);
  if (Status saved = saveReported(placed->document, arguments.output, report); !saved) {
    return saved;
  }
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    printExaggeration(report);
    printSaved(report);
  }
  return Success{};
}

} // namespace

Verb exaggerateVerb() {
  return {"exaggerate", "Exaggerates limbs of a clip, re-keys it and saves the file.", [](CommandLine& line) {
            const auto arguments = std::make_shared<ExaggerateArguments>();
            line.examples({"dummy.glb -o punch.glb --limb left-arm --range 21:27 --scale 3 --axes xz",
                           "dummy.glb -o punch.glb --recipe refined-punch.json"});
            addFileArguments(line, arguments->input);
            addPlan(line, arguments->input);
            addOutputArguments(line, arguments->output);
            addClipArguments(line, arguments->input);
            line.option("--recipe", arguments->recipe, "A recipe (JSON) instead of --limb and its options");
            line.flag("--loops", arguments->loops,
                      "The clip is played as a loop: a limb's way back at its end goes on at its start");
            addTrailOptions(line);
            addJson(line, arguments->json);
            return [arguments, line] { return runExaggerate(*arguments, requestsOf(line)); };
          }};
}

} // namespace stretch::app
