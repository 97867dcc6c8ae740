#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/edits/trail/place_trails.h"
#include "app/evaluate/clip_moments.h"
#include "app/evaluate/evaluate.h"
#include "app/named.h"
#include "app/schema/parse_text.h"
#include "app/schema/schema_json.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct TrailArguments {
  FileArguments input;
  std::string limb;
  std::string range;
  JsonOutput json;
};

Json trailJson(const rig::MotionState& motion) {
  const rig::SolvedTrail& solved = motion.trails.front();
  Json json;
  json["frames"] = Json::array();
  json["points"] = Json::array();
  json["base"] = Json::array();
  for (const rig::LimbSample& sample : solved.path.samples) {
    json["frames"].push_back(sample.timeSeconds * motion.framesPerSecond);
    json["points"].push_back(vectorToJson(sample.end));
    json["base"].push_back(vectorToJson(sample.base));
  }
  json["control_frames"] = solved.controlFrames;
  json["warnings"] = solved.warnings;
  return json;
}

// A path that is only looked at may be a single point, as in a clip of one key, which no trail could
// exaggerate.
bool isOneFrame(const Vec2& range, const Clip& clip) {
  return range.x == range.y && range.x >= 0.0 && range.x < static_cast<double>(frameCount(clip));
}

Status runTrail(const TrailArguments& arguments) {
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<int> clip = clipOfArguments(arguments.input, *document);
  const Result<rig::Limb> limb = findOrAddLimb(*document, arguments.limb, "--limb");
  if (!clip || !limb) {
    return clip ? limb.error() : clip.error();
  }
  const Result<Vec2> range = arguments.range.empty() ? defaultRange(*document, *clip, *limb)
                                                     : parseRange(arguments.range, "--range");
  if (!range) {
    return range.error();
  }
  document->trails.clear();
  rig::Trail trail;
  trail.limb = limb->id;
  trail.clip = *clip;
  trail.settings.startFrame = range->x;
  trail.settings.endFrame = range->y;
  if (isOneFrame(*range, clipOf(*document, *clip))) {
    document->trails.push_back(trail);
  } else {
    Result<PlacedTrails> placed = placeTrails(*document, {&trail, 1}, Entry::request);
    if (!placed) {
      return placed.error();
    }
    document = std::move(placed->document);
  }
  const Json json = trailJson(prepareMotion(*document, *clip));
  if (arguments.json) {
    arguments.json.print(json);
    return Success{};
  }
  for (std::size_t i = 0; i < json["frames"].size(); ++i) {
    const Json& point = json["points"][i];
    fmt::print("frame {:8.3f}  {:10.5f} {:10.5f} {:10.5f}\n", json["frames"][i].get<double>(),
               point[0].get<double>(), point[1].get<double>(), point[2].get<double>());
  }
  printWarnings(json["warnings"]);
  return Success{};
}

} // namespace

Verb trailVerb() {
  return {"trail", "Prints a limb's original path of motion, world space, metres.", [](CommandLine& line) {
            const auto arguments = std::make_shared<TrailArguments>();
            line.examples({"dummy.glb --limb left-arm --range 21:27"});
            addFileArguments(line, arguments->input);
            addPlan(line, arguments->input);
            line.option("--limb", arguments->limb, limbWords).required();
            addClipArguments(line, arguments->input);
            line.option("--range", arguments->range,
                        "First and last frame, A:B; default: the limb's strongest stroke")
                .check(problemOfRange);
            addJson(line, arguments->json);
            return [arguments] { return runTrail(*arguments); };
          }};
}

} // namespace stretch::app
