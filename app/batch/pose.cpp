#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/batch/library_pose.h"
#include "app/batch/output.h"
#include "app/batch/output_file.h"
#include "app/batch/pose_report.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/evaluate/frame_count.h"
#include "app/evaluate/hand_place.h"
#include "app/evaluate/planted_feet.h"
#include "app/recipe/offset_table.h"
#include "app/recipe/recipe.h"
#include "core/anim/frames.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct PoseArguments {
  FileArguments input;
  OutputArguments output;
  std::string recipe;
  std::string offsets;                // a table of offset keys
  std::string units = "limb_lengths"; // of the table
  bool pinsFeet = false;
  std::string prop;
  std::string hand = "right-arm";
  double propFrame = 0.0;
  PoseRequest library;
  JsonOutput json;
};

Json poseJson(const Document& document, const Recipe& recipe) {
  Json report{{"clip", clipOf(document, recipe.clip).name},
              {"controllers", Json::array()},
              {"warnings", documentWarnings(document)}};
  const bool hasMore = !recipe.trails.empty() || !recipe.weights.empty();
  if (hasMore) {
    report["warnings"].push_back(
        "trails and weight of the recipe are left out: 'exaggerate --recipe' plays them");
  }
  addPoseReport(document, recipe.clip, recipe.adjustments, report);
  report["added_files"] = addedFilesToJson(document);
  return report;
}

void printTakenPose(const Json& pose) {
  fmt::print("{}: frame {:g}: taken by {} controllers\n", pose["name"].get<std::string>(),
             pose["frame"].get<double>(), pose["controllers"].size());
  for (const Json& missed : pose["missed"]) {
    fmt::print(stderr, "warning: {} is held elsewhere\n", missed.get<std::string>());
  }
}

void printPose(const Json& report) {
  if (report.contains("pose")) {
    printTakenPose(report["pose"]);
  }
  printPoseReport(report);
  printWarnings(report["warnings"]);
}

// What --pin-feet and --offsets without a recipe start from.
Result<Recipe> emptyRecipe(const PoseArguments& arguments, const Document& document) {
  const Result<int> clip = clipOfArguments(arguments.input, document);
  if (!clip) {
    return clip.error();
  }
  Recipe recipe;
  recipe.clip = *clip;
  return recipe;
}

bool asksBesideRecipe(const PoseArguments& arguments) {
  return arguments.pinsFeet || !arguments.prop.empty() || !arguments.library.pose.empty();
}

Status checkAsked(const PoseArguments& arguments) {
  const bool asks = !arguments.recipe.empty() || !arguments.offsets.empty() || asksBesideRecipe(arguments);
  return asks ? Status(Success{})
              : Status(Error{
                    "nothing was asked for", "--recipe",
                    "give a recipe, a table of offset keys by --offsets, --pose, --prop or --pin-feet"});
}

Result<Recipe> wantedPose(const PoseArguments& arguments, Document& document) {
  Result<Recipe> recipe = arguments.recipe.empty() ? emptyRecipe(arguments, document)
                                                   : loadRecipe(arguments.recipe, arguments.input, document);
  if (recipe && !arguments.offsets.empty()) {
    Result<std::vector<rig::Adjustment>> table =
        loadOffsetTable(arguments.offsets, document, recipe->clip, arguments.units);
    if (!table) {
      return table.error();
    }
    std::ranges::move(*table, std::back_inserter(recipe->adjustments));
  }
  if (recipe && recipe->adjustments.empty() && recipe->holds.empty() && !asksBesideRecipe(arguments)) {
    return Error{"holds no adjustments, pins, grips or props", arguments.recipe,
                 R"(give a list "adjustments", "pins", "grips" or "props", as docs/recipes.md tells)"};
  }
  return recipe;
}

Result<Document> withProp(const PoseArguments& arguments, const Recipe& recipe, const Document& document) {
  const std::vector<std::string> hands = arguments.hand == "both"
                                             ? std::vector<std::string>{"left-arm", "right-arm"}
                                             : std::vector<std::string>{arguments.hand};
  Result<AddedProp> added =
      putIntoHands(document, {arguments.prop, hands, recipe.clip, arguments.propFrame, {}});
  return added ? Result<Document>(std::move(added->document)) : Result<Document>(added.error());
}

// The adjustments and holds, and pins where the feet stand in the adjusted clip; a recipe's own pin stands in
// the place of one that was found.
Result<Document> posedBy(const PoseArguments& arguments, const Recipe& recipe, const Document& document) {
  Result<Document> posed = placeAdjustments(document, recipe.adjustments);
  if (posed && arguments.pinsFeet) {
    const Clip& clip = clipOf(*posed, recipe.clip);
    const Vec2 whole(0.0, wholeFrameAtMost(endInFrames(clip)));
    posed = placeHolds(*posed, plantedFeet(*posed, recipe.clip, whole));
  }
  if (posed) {
    posed = placeHolds(*posed, recipe.holds);
  }
  return posed && !arguments.prop.empty() ? withProp(arguments, recipe, *posed) : posed;
}

// The pose of the library that was asked for, and what is told of it; nothing where none was.
Status takePose(const PoseRequest& request, int clip, Document& document, Json& report) {
  if (request.pose.empty()) {
    return Success{};
  }
  Result<TakenPose> taken = withPose(document, clip, request);
  if (!taken) {
    return taken.error();
  }
  document = std::move(taken->document);
  report = {{"name", taken->name},
            {"frame", request.frame},
            {"controllers", taken->controllers},
            {"missed", taken->missed}};
  return Success{};
}

Status runPose(const PoseArguments& arguments) {
  if (Status apart =
          checkOutput(arguments.output.file, {arguments.input.file, arguments.recipe, arguments.offsets,
                                              arguments.prop, arguments.library.pose});
      !apart) {
    return apart;
  }
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<Recipe> recipe = wantedPose(arguments, *document);
  if (!recipe) {
    return recipe.error();
  }
  if (Status bounded = checkFrameCount(clipOf(*document, recipe->clip)); !bounded) {
    return bounded;
  }
  Result<Document> posed = posedBy(arguments, *recipe, *document);
  if (!posed) {
    return posed.error();
  }
  Json replaced{{"warnings", Json::array()}};
  addGaveWay(*document, *posed, replaced);
  Json taken = Json::object();
  if (Status took = takePose(arguments.library, recipe->clip, *posed, taken); !took) {
    return took;
  }
  Json report = poseJson(*posed, *recipe);
  report["warnings"].insert(report["warnings"].end(), replaced["warnings"].begin(),
                            replaced["warnings"].end());
  if (!taken.empty()) {
    report["pose"] = std::move(taken);
  }
  if (Status saved = saveReported(*posed, arguments.output, report); !saved) {
    return saved;
  }
  if (arguments.json) {
    arguments.json.print(report);
  } else {
    printPose(report);
    printSaved(report);
  }
  return Success{};
}

} // namespace

Verb poseVerb() {
  return {
      "pose",
      "Adjusts a clip by the controllers that a recipe or a table keys, a pose of the library, and the pins, "
      "grips and props that a recipe holds, puts the thing of another file into a hand, and saves the file.",
      [](CommandLine& line) {
        const auto arguments = std::make_shared<PoseArguments>();
        line.examples({"dummy.glb -o guard.glb --recipe low-guard.json",
                       "dummy.glb -o low.glb --offsets offsets.csv --units metres",
                       "dummy.glb -o guarded.glb --pose guard.json --pose-frame 12 --pose-range 6:20",
                       "dummy.glb -o armed.glb --prop bat.glb --prop-hand both"});
        addFileArguments(line, arguments->input);
        addPlan(line, arguments->input);
        addOutputArguments(line, arguments->output);
        line.option("--recipe", arguments->recipe, "A recipe (JSON) with adjustments, pins, grips or props");
        const DeclaredOption offsets =
            line.option("--offsets", arguments->offsets,
                        "A table of offset keys, CSV or JSON, one key a row; beside a recipe or alone");
        line.option("--units", arguments->units, "What the table counts moves in")
            .oneOf({"limb_lengths", "metres"})
            .showDefault()
            .needs(offsets);
        line.flag("--pin-feet", arguments->pinsFeet, "Pins each foot wherever it stands");
        const DeclaredOption prop =
            line.option("--prop", arguments->prop,
                        "A file with a thing that is put into a hand, and added to the output");
        line.option("--prop-hand", arguments->hand, "The arm whose hand takes it")
            .oneOf({"left-arm", "right-arm", "both"})
            .showDefault()
            .needs(prop);
        line.option("--prop-frame", arguments->propFrame, "Frame at which the hand takes it")
            .showDefault()
            .needs(prop);
        addPoseRequest(line, arguments->library);
        addClipArguments(line, arguments->input);
        addJson(line, arguments->json);
        line.checkTogether([arguments](const CommandLine&) { return checkAsked(*arguments); });
        return [arguments] { return runPose(*arguments); };
      }};
}

} // namespace stretch::app
