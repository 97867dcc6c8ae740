#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/batch/library_pose.h"
#include "app/batch/output.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/frame_count.h"
#include "app/evaluate/hand_place.h"
#include "app/evaluate/hold_report.h"
#include "app/evaluate/planted_feet.h"
#include "app/evaluate/pops.h"
#include "app/evaluate/prop_flips.h"
#include "app/recipe/offset_table.h"
#include "app/recipe/recipe.h"
#include "app/schema/schema_json.h"
#include "core/anim/frames.h"
#include "core/gltf/json/json.h"
#include "rig/adjust/apply_adjustments.h"
#include "rig/motion/evaluate.h"

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

// Where the controller was asked to be at a frame and where it came to; nothing where it only turns.
std::optional<Json> placesAt(const Document& document, const rig::MotionState& motion,
                             const std::string& controller, double frame) {
  const Clip& clip = clipOf(document, motion.clip);
  FrameState state = rig::sampledFrame(*document.scene, clip, frame / clip.framesPerSecond);
  const std::vector<rig::AskedPlace> asked =
      rig::applyAdjustments(*document.scene, motion.adjustments, state);
  const auto own = std::ranges::find(asked, controller, &rig::AskedPlace::controller);
  if (own == asked.end()) {
    return std::nullopt;
  }
  const Vec3 reached = rig::controllerPlace(motion.adjustments, controller, state);
  return Json{{"frame", frame},
              {"asked", vectorToJson(own->place)},
              {"reached", vectorToJson(reached)},
              {"missed_by", glm::length(reached - own->place)}};
}

// How the ends were held, and which elbows and knees pop; what the document's own trails make of the body is
// in it.
void addMotionReports(const Document& document, int clip, Json& report) {
  const rig::MotionState motion = prepareMotion(document, clip);
  for (const LimbPop& pop : limbPops(document, motion)) {
    report["warnings"].push_back(popWarning(pop));
  }
  for (const PropFlip& flip : propFlips(document, motion)) {
    report["warnings"].push_back(flipWarning(flip));
  }
  report["holds"] = Json::array();
  for (const HoldReport& hold : holdReports(document, motion)) {
    Json entry{{"hold", holdWord(hold.kind)},
               {"limb", hold.limb},
               {"reached", hold.framesFallShort.empty()},
               {"farthest", hold.farthest},
               {"falls_short_at", hold.framesFallShort}};
    report["holds"].push_back(std::move(entry));
    if (const std::string warning = holdWarning(hold); !warning.empty()) {
      report["warnings"].push_back(warning);
    }
  }
}

void warnOfMiss(const std::string& controller, const Json& place, double height, Json& warnings) {
  constexpr double seen = 1e-3; // of the height
  const double miss = place["missed_by"].get<double>();
  if (miss > seen * height) {
    warnings.push_back(
        fmt::format("{} misses its place at frame {:g} by {:.4g}: its limb is not to stretch so far",
                    controller, place["frame"].get<double>(), miss));
  }
}

Json poseJson(const Document& document, const Recipe& recipe) {
  const rig::MotionState motion = prepareMotion(adjustedOnly(document), recipe.clip);
  Json report{{"clip", clipOf(document, recipe.clip).name},
              {"controllers", Json::array()},
              {"warnings", documentWarnings(document)}};
  const bool hasMore = !recipe.trails.empty() || !recipe.weights.empty();
  if (hasMore) {
    report["warnings"].push_back(
        "trails and weight of the recipe are left out: 'exaggerate --recipe' plays them");
  }
  for (const rig::Adjustment& adjustment : recipe.adjustments) {
    Json keys = Json::array();
    for (const rig::OffsetKey& key : adjustment.keys) {
      const std::optional<Json> place = placesAt(document, motion, adjustment.controller, key.frame);
      keys.push_back(place.value_or(Json{{"frame", key.frame}}));
      if (place) {
        warnOfMiss(adjustment.controller, *place, document.body.height, report["warnings"]);
      }
    }
    report["controllers"].push_back({{"controller", adjustment.controller}, {"keys", std::move(keys)}});
  }
  addMotionReports(document, recipe.clip, report);
  report["added_files"] = addedFilesToJson(document);
  return report;
}

std::string placeText(const Json& place) {
  return fmt::format("{:.4f} {:.4f} {:.4f}", place[0].get<double>(), place[1].get<double>(),
                     place[2].get<double>());
}

void printHold(const Json& hold) {
  const std::string held = hold["reached"].get<bool>()
                               ? fmt::format("held, at most {:.4g} away", hold["farthest"].get<double>())
                               : fmt::format("falls short by up to {:.4g}", hold["farthest"].get<double>());
  fmt::print("{} of {}: {}\n", hold["hold"].get<std::string>(), hold["limb"].get<std::string>(), held);
}

void printTakenPose(const Json& pose) {
  fmt::print("{}: frame {:g}: taken by {} controllers\n", pose["name"].get<std::string>(),
             pose["frame"].get<double>(), pose["controllers"].size());
  for (const Json& missed : pose["missed"]) {
    fmt::print("warning: {} is held elsewhere\n", missed.get<std::string>());
  }
}

void printPose(const Json& report) {
  if (report.contains("pose")) {
    printTakenPose(report["pose"]);
  }
  for (const Json& controller : report["controllers"]) {
    for (const Json& key : controller["keys"]) {
      const std::string place =
          key.contains("asked")
              ? fmt::format("asked for {}, reached {}", placeText(key["asked"]), placeText(key["reached"]))
              : std::string("set");
      fmt::print("{}: frame {:g}: {}\n", controller["controller"].get<std::string>(),
                 key["frame"].get<double>(), place);
    }
  }
  for (const Json& hold : report["holds"]) {
    printHold(hold);
  }
  for (const Json& warning : report["warnings"]) {
    fmt::print("warning: {}\n", warning.get<std::string>());
  }
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

Result<Recipe> wantedPose(const PoseArguments& arguments, Document& document) {
  const bool asksMore = arguments.pinsFeet || !arguments.prop.empty() || !arguments.library.pose.empty();
  if (arguments.recipe.empty() && arguments.offsets.empty() && !asksMore) {
    return Error{"nothing was asked for", "--recipe",
                 "give a recipe, a table of offset keys by --offsets, --pose, --prop or --pin-feet"};
  }
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
  if (recipe && recipe->adjustments.empty() && recipe->holds.empty() && !asksMore) {
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
  Json taken = Json::object();
  if (Status took = takePose(arguments.library, recipe->clip, *posed, taken); !took) {
    return took;
  }
  Json report = poseJson(*posed, *recipe);
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
        line.option("--offsets", arguments->offsets,
                    "A table of offset keys, CSV or JSON, one key a row; beside a recipe or alone");
        line.option("--units", arguments->units, "What the table counts moves in")
            .oneOf({"limb_lengths", "metres"})
            .showDefault();
        line.flag("--pin-feet", arguments->pinsFeet, "Pins each foot wherever it stands");
        line.option("--prop", arguments->prop,
                    "A file with a thing that is put into a hand, and added to the output");
        line.option("--prop-hand", arguments->hand, "The arm whose hand takes it")
            .oneOf({"left-arm", "right-arm", "both"})
            .showDefault();
        line.option("--prop-frame", arguments->propFrame, "Frame at which the hand takes it").showDefault();
        addPoseRequest(line, arguments->library);
        addClipArguments(line, arguments->input);
        addJson(line, arguments->json);
        return [arguments] { return runPose(*arguments); };
      }};
}

} // namespace stretch::app
