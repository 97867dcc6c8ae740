#include "app/batch/trail_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/batch/pose_report.h"
#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/pops.h"
#include "app/evaluate/quality.h"
#include "app/evaluate/seen.h"
#include "app/evaluate/stopped.h"
#include "app/evaluate/way_back.h"
#include "app/schema/schema_json.h"
#include "app/things/place.h"
#include "core/gltf/json/json.h"
#include "rig/limb.h"

namespace stretch::app {

namespace {

using gltf::Json;

const char* spaceName(rig::TrailSpace space) {
  switch (space) {
  case rig::TrailSpace::root:
    return "root";
  case rig::TrailSpace::base:
    return "base";
  case rig::TrailSpace::view:
    return "view";
  case rig::TrailSpace::world:
    break;
  }
  return "world";
}

// The direction is the one towards the eye.
Json viewJson(const Document& document, int clip, const Vec3& towardsEye) {
  return {{"direction", vectorToJson(towardsEye)}, {"words", viewInWords(document, clip, towardsEye)}};
}

void addSeen(const Document& document, const rig::MotionState& motion, const rig::SolvedTrail& solved,
             Json& report) {
  const std::optional<Seen> seen =
      solved.camera ? seenBy(document, motion, solved, *solved.camera) : std::nullopt;
  if (seen) {
    const std::string& camera = solved.settings.sight.camera;
    report["seen"] = {{"camera", camera.empty() ? Json(nullptr) : Json(camera)},
                      {"ratio", seen->ratio},
                      {"of", seen->of},
                      {"share", seen->share},
                      {"path", seenPath(document, motion, solved, *solved.camera)}};
    report["best_view"] = viewJson(document, motion.clip, bestViewOf(document, motion, solved));
  }
  for (const std::string& warning : seenWarnings(document, motion, solved)) {
    report["warnings"].push_back(solved.limb.id + ": " + warning);
  }
  if (solved.tip.seen) {
    constexpr double tolerance = 1e-4;
    const Seen none{.ratio = 0.0, .of = 1.0};
    const Seen shown = seen.value_or(none);
    report["reached"] = solved.tip.reached() && std::abs(shown.ratio - shown.of) <= tolerance * shown.of;
  }
}

Json trailReport(const std::shared_ptr<ClipFacts>& facts, const rig::MotionState& motion,
                 const rig::SolvedTrail& solved) {
  const Document& document = facts->document();
  const double tipSeconds = solved.tipSeconds;
  Json warnings = solved.warnings;
  for (const std::string& warning : motionWarnings(facts, motion, solved)) {
    warnings.push_back(solved.limb.id + ": " + warning);
  }
  if (const auto problem = wayBackProblem(document, motion, solved)) {
    warnings.push_back(solved.limb.id + ": " + problem->what +
                       (problem->loopHelps ? "; --loops lets the way back go on at the clip's start" : ""));
  }
  const double before = rig::limbLength(solved.limb, evaluateOriginal(document, motion.clip, tipSeconds));
  const double after = rig::limbLength(solved.limb, evaluate(document, motion, tipSeconds));
  Json report{{"limb", solved.limb.id},
              {"range", {solved.settings.startFrame, solved.settings.endFrame}},
              {"space", spaceName(solved.settings.space)},
              {"tip", vectorToJson(solved.path.toWorld(solved.settings.pivot == rig::Pivot::start
                                                           ? solved.path.samples.back()
                                                           : solved.path.samples.front(),
                                                       solved.tip.tip))},
              {"trail_scale", solved.tip.trailScale ? Json(*solved.tip.trailScale) : Json(nullptr)},
              {"moved", solved.tip.moved},
              {"reached", hasWantedLength(document, motion, solved)},
              {"pulled", solved.tip.outcome == rig::TipOutcome::pulled},
              {"release", solved.release.seconds() * motion.framesPerSecond},
              {"limb_length_before", before},
              {"limb_length_after", after},
              {"warnings", std::move(warnings)}};
  addSeen(document, motion, solved, report);
  const bool reached = report["reached"].get<bool>(); // as seen, where the scale counts so
  const std::string held = reached ? std::string() : keptFromLength(document, motion, solved);
  const std::string kept = reached || !held.empty() ? held : keptBySettings(solved);
  if (!kept.empty()) {
    report["kept"] = kept;
  }
  if (kept == stoppedOnTheWay) {
    report["stopped"] = true;
  }
  return report;
}

} // namespace

Json exaggerationJson(const Document& document, int clip, const std::vector<int>& ids,
                      const std::shared_ptr<CharacterFacts>& character) {
  Json report;
  report["clip"] = clipOf(document, clip).name;
  report["trails"] = Json::array();
  EvaluationCache cache;
  rig::MotionState motion = *cache.motion(document, clip);
  motion.weights.clear(); // What the trails do by themselves.
  const auto facts = std::make_shared<ClipFacts>(document, clip, character);
  for (const int id : ids) {
    const auto solved = std::ranges::find_if(
        motion.trails, [&](const rig::SolvedTrail& trail) { return trail.trail.id == id; });
    if (solved != motion.trails.end()) {
      report["trails"].push_back(trailReport(facts, motion, *solved));
    }
  }
  if (hasWeight(document, clip)) {
    report["elastic"] = weightJson(document, clip, cache);
  }
  report["warnings"] = documentWarnings(document);
  return report;
}

namespace {

// The frames around its range and its way back; all of a loop where these go on beyond its seam.
FrameSpan movedFrames(const rig::MotionState& motion, const rig::SolvedTrail& solved) {
  const auto frameAt = [&](double seconds) { return std::llround(seconds * motion.framesPerSecond); };
  if (motion.loops &&
      (solved.windowStartSeconds < motion.startSeconds || solved.windowEndSeconds > motion.endSeconds)) {
    return {};
  }
  return {.first = frameAt(solved.windowStartSeconds) - 1, .last = frameAt(solved.windowEndSeconds) + 1};
}

} // namespace

void addFlips(const Document& document, int clip, const std::vector<int>& ids, Json& report) {
  const rig::MotionState motion = prepareMotion(document, clip);
  auto entry = report["trails"].begin();
  for (const int id : ids) {
    const std::optional<std::size_t> place = rig::placeOfTrail(motion, id);
    if (!place) {
      continue;
    }
    const rig::SolvedTrail& solved = motion.trails[*place];
    for (const LimbPop& pop : limbPops(document, motion, movedFrames(motion, solved))) {
      if (pop.limb == solved.limb.id && !pop.flipFrames.empty()) {
        (*entry)["warnings"].push_back(popWarning(pop));
      }
    }
    ++entry;
  }
}

namespace {

/// ", seen x1.4 of x3".
std::string seenText(const Json& trail) {
  return trail.contains("seen")
             ? fmt::format(", seen x{:.3g} of x{:.3g}", trail["seen"]["ratio"].get<double>(),
                           trail["seen"]["of"].get<double>())
             : std::string();
}

} // namespace

void printExaggeration(const Json& report, const std::string& clip) {
  for (const Json& trail : report["trails"]) {
    const auto space = trail["space"].get<std::string>();
    fmt::print("{}: frames {:g} to {:g}, {:.4g} -> {:.4g} long{}{}{}{}\n", trail["limb"].get<std::string>(),
               trail["range"][0].get<double>(), trail["range"][1].get<double>(),
               trail["limb_length_before"].get<double>(), trail["limb_length_after"].get<double>(),
               trail["pulled"].get<bool>() ? " (pulled)" : "", space == "root" ? ", seen from the hips" : "",
               trail.contains("kept") ? ", " + trail["kept"].get<std::string>() : "", seenText(trail));
    printWarnings(trail["warnings"], clip);
  }
  if (report.contains("controllers")) {
    printPoseReport(report);
  }
  if (report.contains("elastic")) {
    printWeight(report["elastic"], clip);
  }
  if (report.contains("warnings")) {
    printWarnings(report["warnings"]);
  }
}

gltf::Json addedFilesToJson(const Document& document) {
  gltf::Json files = gltf::Json::array();
  for (const gltf::AddedFile& file : document.addedFiles) {
    files.push_back({{"file", file.file}, {"node", file.name}});
  }
  return files;
}

gltf::Json documentWarnings(const Document& document) {
  gltf::Json warnings = document.warnings;
  for (const std::string& warning : document.body.warnings) {
    warnings.push_back(warning);
  }
  return warnings;
}

void addGaveWay(const Document& before, const Document& after, gltf::Json& report) {
  for (const std::string& line : gaveWay(before, after)) {
    report["warnings"].push_back(line);
  }
}

void printWarnings(const gltf::Json& warnings, const std::string& clip) {
  for (const gltf::Json& warning : warnings) {
    fmt::print(stderr, "warning: {}{}{}\n", clip, clip.empty() ? "" : ": ", warning.get<std::string>());
  }
}

gltf::Json weightJson(const Document& document, int clip, EvaluationCache& cache) {
  gltf::Json limbs = gltf::Json::array();
  for (const WeightReport& report : cache.weightReports(document, clip)) {
    limbs.push_back({{"limb", report.limb},
                     {"young", report.youngModulus},
                     {"widths", report.widths},
                     {"masses", report.masses},
                     {"shortest", report.shortest},
                     {"shortest_frame", report.shortestFrame},
                     {"longest", report.longest},
                     {"longest_frame", report.longestFrame},
                     {"warnings", report.warnings}});
  }
  return limbs;
}

void printWeight(const gltf::Json& limbs, const std::string& clip) {
  for (const gltf::Json& limb : limbs) {
    fmt::print("{}: {:.3g} to {:.3g} times its length (frames {:.4g} and {:.4g}), modulus {:.3g} Pa\n",
               limb["limb"].get<std::string>(), limb["shortest"].get<double>(), limb["longest"].get<double>(),
               limb["shortest_frame"].get<double>(), limb["longest_frame"].get<double>(),
               limb["young"].get<double>());
    printWarnings(limb["warnings"], clip);
  }
}

} // namespace stretch::app
