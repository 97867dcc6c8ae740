#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "app/document.h"
#include "app/evaluate/evaluate.h"
#include "app/schema/trail_json.h"
#include "core/gltf/json.h"
#include "rig/motion/solve.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct TrailArguments {
  FileArguments input;
  std::string limb;
  std::string clip;
  std::string range;
  bool json = false;
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
  return json;
}

Status runTrail(const TrailArguments& arguments) {
  Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Result<int> clip = findClip(*document, arguments.clip);
  const Result<rig::Limb> limb = findOrAddLimb(*document, arguments.limb);
  if (!clip || !limb) {
    return clip ? limb.error() : clip.error();
  }
  Vec2 range = rig::defaultRange(*document->scene, clipOf(*document, *clip), *limb);
  if (!arguments.range.empty()) {
    const Result<Vec2> given = rangeOf(arguments.range, clipOf(*document, *clip));
    if (!given) {
      return given.error();
    }
    range = *given;
  }
  rig::Trail trail;
  trail.limb = limb->id;
  trail.clip = *clip;
  trail.settings.startFrame = range.x;
  trail.settings.endFrame = range.y;
  document->trails = {trail};
  const Json json = trailJson(prepareMotion(*document, *clip));
  if (arguments.json) {
    std::cout << json.dump(1) << '\n';
    return Success{};
  }
  for (std::size_t i = 0; i < json["frames"].size(); ++i) {
    const Json& point = json["points"][i];
    fmt::print("frame {:8.3f}  {:10.5f} {:10.5f} {:10.5f}\n", json["frames"][i].get<double>(),
               point[0].get<double>(), point[1].get<double>(), point[2].get<double>());
  }
  return Success{};
}

} // namespace

Verb trailVerb() {
  return {"trail", "Prints a limb's original path of motion, world space, metres.", [](CommandLine& line) {
            const auto arguments = std::make_shared<TrailArguments>();
            addFileArguments(line, arguments->input);
            line.option("--limb", arguments->limb,
                        "left-arm, right-arm, left-leg, right-leg, spine, neck or JOINT_A..JOINT_B")
                .required();
            line.option("--clip", arguments->clip, "Name or #index of the clip; default: the first");
            line.option("--range", arguments->range, "First and last frame, A:B");
            addFramesPerSecond(line, arguments->input);
            line.flag("--json", arguments->json, "Print one JSON document");
            return [arguments] { return runTrail(*arguments); };
          }};
}

} // namespace stretch::app
