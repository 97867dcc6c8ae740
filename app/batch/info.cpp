#include <algorithm>
#include <memory>

#include <fmt/core.h>

#include "app/batch/extension_report.h"
#include "app/batch/options.h"
#include "app/batch/sequence_report.h"
#include "app/batch/trail_report.h"
#include "app/batch/verb.h"
#include "app/document.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/recipe/recipe_parts.h"
#include "app/schema/hold_json.h"
#include "app/schema/trail_schema.h"
#include "core/gltf/json/json.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::app {

namespace {

using gltf::Json;

struct InfoArguments {
  FileArguments input;
  JsonOutput json;
};

Json jointJson(const Scene& scene, NodeIndex node) {
  return {{"name", scene.nodes[at(node)].name}, {"node", node.value}};
}

Json limbJson(const Scene& scene, const rig::Limb& limb) {
  Json joints = Json::array();
  for (const NodeIndex joint : limb.joints) {
    joints.push_back(jointJson(scene, joint));
  }
  if (limb.endNode.exists()) {
    joints.push_back(jointJson(scene, limb.endNode));
  }
  const std::string end = limb.endNode.exists() ? scene.nodes[at(limb.endNode)].name : "estimated";
  Json json{{"limb", limb.id},
            {"joints", joints},
            {"end", end},
            {"rest_length", limb.restLength},
            {"confidence", limb.confidence},
            {"reasons", limb.reasons}};
  if (limb.ledByFirst) {
    json["led_by"] = scene.nodes[at(limb.joints.front())].name;
  }
  return json;
}

Json controllersJson(const Document& document) {
  const rig::ControllerList list = controllersOf(document);
  Json controllers = Json::array();
  for (const rig::Controller& controller : list.controllers) {
    Json entry{{"controller", controller.id}, {"moves", controller.moves}, {"turns", controller.turns}};
    if (controller.node.exists()) {
      entry["joint"] = jointJson(*document.scene, controller.node);
    }
    controllers.push_back(std::move(entry));
  }
  for (const rig::Attribute& attribute : list.attributes) {
    controllers.push_back({{"attribute", attribute.id},
                           {"minimum", attribute.minimum},
                           {"maximum", attribute.maximum},
                           {"standard", attribute.standard}});
  }
  return controllers;
}

Json meshJson(const Mesh& mesh) {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  for (const Primitive& primitive : mesh.primitives) {
    vertices += primitive.positions.size();
    triangles += primitive.indices.size() / 3;
  }
  return {{"name", mesh.name}, {"vertices", vertices}, {"triangles", triangles}};
}

/// Whether a clip moves the node, or one that carries it.
bool movesNode(const Scene& scene, const Clip& clip, NodeIndex node) {
  return std::ranges::any_of(clip.tracks, [&](const CopyOnWrite<Track>& track) {
    return isAncestorOrSelf(scene, track->node, node);
  });
}

Json cameraJson(const Document& document, const SceneCamera& camera) {
  const bool isPerspective = camera.kind == CameraKind::perspective;
  Json json{{"name", camera.name},
            {"node", camera.node.value},
            {"kind", isPerspective ? "perspective" : "orthographic"},
            {"aspect", camera.aspect ? Json(*camera.aspect) : Json(nullptr)},
            {"animated_in", Json::array()}};
  if (isPerspective) {
    json["field_of_view"] = camera.fieldOfViewRadians * 180.0 / pi;
    json["focal_length"] = focalLength(camera.fieldOfViewRadians);
  } else {
    json["height"] = 2.0 * camera.halfHeight;
  }
  for (const Clip& clip : *document.clips) {
    if (movesNode(*document.scene, clip, camera.node)) {
      json["animated_in"].push_back(clip.name);
    }
  }
  return json;
}

/// "camera Shot: perspective, 39.6 degrees (33.3 mm), animated in punch".
void printCamera(const Json& camera) {
  const bool isPerspective = camera.contains("field_of_view");
  std::string clips;
  for (const Json& clip : camera["animated_in"]) {
    clips += (clips.empty() ? ", animated in " : ", ") + clip.get<std::string>();
  }
  fmt::print("camera {}: {}{}\n", camera["name"].get<std::string>(),
             isPerspective
                 ? fmt::format("perspective, {:.4g} degrees ({:.3g} mm)",
                               camera["field_of_view"].get<double>(), camera["focal_length"].get<double>())
                 : fmt::format("orthographic, {:.4g} high", camera["height"].get<double>()),
             clips);
}

/// How far the artist is with a trail.
const char* stateOf(const rig::Trail& trail) {
  return !trail.exaggerated ? "path only"
         : !trail.connected ? "disconnected"
         : trail.applied    ? "applied"
                            : "connected";
}

Json trailJson(const Document& document, const rig::Trail& trail) {
  Json json{{"limb", trail.limb},
            {"clip", clipOf(document, trail.clip).name},
            {"range", {trail.settings.startFrame, trail.settings.endFrame}},
            {"scale", trail.settings.scale},
            {"state", stateOf(trail)}};
  addNames(trail, json);
  return json;
}

Json onClip(const Document& document, int clip, Json json) {
  json["clip"] = clipOf(document, clip).name;
  return json;
}

/// What controllers change and what is held, as recipes write it; lengths in world units.
void addPosing(const Document& document, Json& info) {
  const rig::ControllerList list = controllersOf(document);
  const AdjustmentUnits units = unitsOf(1.0, true);
  for (const char* key : {"adjustments", "pins", "grips", "props"}) {
    info[key] = Json::array();
  }
  for (const rig::Adjustment& adjustment : document.adjustments) {
    const bool isAttribute = list.attribute(adjustment.controller) != nullptr;
    info["adjustments"].push_back(
        onClip(document, adjustment.clip, adjustmentToJson(adjustment, isAttribute, units)));
  }
  for (const rig::Pin& pin : document.holds.pins) {
    info["pins"].push_back(onClip(document, pin.clip, pinToJson(pin, units)));
  }
  for (const rig::Grip& grip : document.holds.grips) {
    info["grips"].push_back(onClip(document, grip.clip, gripToJson(grip)));
  }
  for (const rig::Prop& prop : document.holds.props) {
    info["props"].push_back(onClip(document, prop.clip, propToJson(prop, units)));
  }
}

/// The work that the file carries.
void addWork(const Document& document, Json& info) {
  addPosing(document, info);
  info["added_files"] = addedFilesToJson(document);
  info["trails"] = Json::array();
  for (const rig::Trail& trail : document.trails) {
    info["trails"].push_back(trailJson(document, trail));
  }
  info["loops"] = Json::array();
  for (const int clip : document.loopingClips) {
    info["loops"].push_back(clipOf(document, clip).name);
  }
}

Json infoOf(const Document& document) {
  const Scene& scene = *document.scene;
  Json info;
  info["meshes"] = Json::array();
  for (const Mesh& mesh : scene.meshes) {
    info["meshes"].push_back(meshJson(mesh));
  }
  info["joints"] = Json::array();
  for (const Skin& skin : scene.skins) {
    Json joints = Json::array();
    for (const NodeIndex joint : skin.joints) {
      joints.push_back(jointJson(scene, joint));
    }
    info["joints"].push_back(std::move(joints));
  }
  info["clips"] = Json::array();
  for (const Clip& clip : *document.clips) {
    info["clips"].push_back({{"name", clip.name},
                             {"seconds", clip.endSeconds},
                             {"frames", frameCount(clip)},
                             {"keys", keyCount(clip)},
                             {"fps", clip.framesPerSecond}});
  }
  info["cameras"] = Json::array();
  for (const SceneCamera& camera : scene.cameras) {
    info["cameras"].push_back(cameraJson(document, camera));
  }
  info["biped"] = document.body.isBiped;
  info["plan"] = document.body.plan;
  info["plan_confidence"] = document.body.planConfidence;
  info["plan_reasons"] = document.body.planReasons;
  info["height"] = document.body.height;
  info["limbs"] = Json::array();
  for (const rig::Limb& limb : document.body.limbs) {
    info["limbs"].push_back(limbJson(scene, limb));
  }
  info["controllers"] = controllersJson(document);
  addWork(document, info);
  info["extensions"] = extensionsJson(gltf::extensionsOf(document.source->json));
  info["warnings"] = documentWarnings(document);
  return info;
}

std::string jointNames(const Json& limb) {
  std::string names;
  for (const Json& joint : limb["joints"]) {
    const auto name = joint["name"].get<std::string>();
    names +=
        (names.empty() ? "" : " > ") + (name.empty() ? fmt::format("#{}", joint["node"].get<int>()) : name);
  }
  return limb["end"] == "estimated" ? names + " > (end estimated)" : names;
}

/// "left-arm   frames 21 to 27 of punch, x3, connected, the jab, group 1 (both arms)".
std::string trailLine(const Json& trail) {
  std::string line = fmt::format("{:<10} frames {:g} to {:g} of {}, x{:g}, {}",
                                 trail["limb"].get<std::string>(), trail["range"][0].get<double>(),
                                 trail["range"][1].get<double>(), trail["clip"].get<std::string>(),
                                 trail["scale"].get<double>(), trail["state"].get<std::string>());
  line += trail.contains("name") ? ", named " + trail["name"].get<std::string>() : "";
  line += trail.contains("group") ? fmt::format(", group {}", trail["group"].get<int>()) : "";
  line += trail.contains("group_name") ? " (" + trail["group_name"].get<std::string>() + ")" : "";
  return line;
}

std::string framesTold(const Json& entry) {
  const std::string clip = entry["clip"].get<std::string>();
  return entry.contains("range") ? fmt::format("frames {:g} to {:g} of {}", entry["range"][0].get<double>(),
                                               entry["range"][1].get<double>(), clip)
                                 : "all of " + clip;
}

void printPosing(const Json& info) {
  for (const Json& adjustment : info["adjustments"]) {
    const char* const key = adjustment.contains("controller") ? "controller" : "attribute";
    fmt::print("offset {:<10} {}, {} keys\n", adjustment[key].get<std::string>(), framesTold(adjustment),
               adjustment["keys"].size());
  }
  for (const Json& pin : info["pins"]) {
    fmt::print("pin    {:<10} {}\n", pin["limb"].get<std::string>(), framesTold(pin));
  }
  for (const Json& grip : info["grips"]) {
    fmt::print("grip   {:<10} follows {}, {}\n", grip["follower"].get<std::string>(),
               grip["leader"].get<std::string>(), framesTold(grip));
  }
  for (const Json& prop : info["props"]) {
    std::string hands;
    for (const auto& [limb, keys] : prop["hands"].items()) {
      hands += (hands.empty() ? "" : ", ") + limb;
    }
    fmt::print("prop   {:<10} in {}, {}\n", prop["node"].get<std::string>(), hands, framesTold(prop));
  }
}

void printPlan(const Json& info) {
  std::string reasons;
  for (const Json& reason : info["plan_reasons"]) {
    reasons += (reasons.empty() ? "" : "; ") + reason.get<std::string>();
  }
  fmt::print("plan   {} (confidence {:.2f}): {}\n", info["plan"].get<std::string>(),
             info["plan_confidence"].get<double>(), reasons);
}

void printInfo(const Json& info) {
  for (const Json& mesh : info["meshes"]) {
    fmt::print("mesh   {}: {} vertices, {} triangles\n", mesh["name"].get<std::string>(),
               mesh["vertices"].get<int>(), mesh["triangles"].get<int>());
  }
  for (std::size_t i = 0; i < info["joints"].size(); ++i) {
    fmt::print("skin   #{}: {} joints\n", i, info["joints"][i].size());
  }
  for (const Json& clip : info["clips"]) {
    fmt::print("clip   {}: {:.3f} s, {} frames at {:g} fps, {} keys\n", clip["name"].get<std::string>(),
               clip["seconds"].get<double>(), clip["frames"].get<std::int64_t>(), clip["fps"].get<double>(),
               clip["keys"].get<int>());
  }
  for (const Json& camera : info["cameras"]) {
    printCamera(camera);
  }
  printPlan(info);
  for (const Json& limb : info["limbs"]) {
    const std::string leads = limb.contains("led_by") ? ", led by " + limb["led_by"].get<std::string>() : "";
    fmt::print("limb   {:<10} {} ({:.3f} long, confidence {:.2f}{})\n", limb["limb"].get<std::string>(),
               jointNames(limb), limb["rest_length"].get<double>(), limb["confidence"].get<double>(), leads);
  }
  for (const Json& trail : info["trails"]) {
    fmt::print("trail  {}\n", trailLine(trail));
  }
  printPosing(info);
  for (const Json& clip : info["loops"]) {
    fmt::print("loop   {}\n", clip.get<std::string>());
  }
  for (const Json& extension : info["extensions"]) {
    fmt::print("{}\n", extensionLine(extension));
  }
  for (const Json& warning : info["warnings"]) {
    fmt::print("warning: {}\n", warning.get<std::string>());
  }
}

// A folder of frames and the like: no joints, no limbs.
Status runSequenceInfo(const InfoArguments& arguments) {
  const Result<MeshSequence> sequence = readSequenceWords({arguments.input.file});
  if (!sequence) {
    return sequence.error();
  }
  Json info;
  info["sequence"] = {{"name", sequence->name},
                      {"frames", sequence->frameCount()},
                      {"vertices", sequence->vertexCount},
                      {"triangles", sequence->triangles.size()},
                      {"fps", sequence->framesPerSecond}};
  info["warnings"] = sequence->warnings;
  info["warnings"].push_back("a sequence of meshes has no joints: make a skinned clip of it by compress");
  if (arguments.json) {
    arguments.json.print(info);
    return Success{};
  }
  fmt::print("sequence {}: {} frames at {:g} fps, {} vertices, {} triangles\n", sequence->name,
             sequence->frameCount(), sequence->framesPerSecond, sequence->vertexCount,
             sequence->triangles.size());
  for (const Json& warning : info["warnings"]) {
    fmt::print("warning: {}\n", warning.get<std::string>());
  }
  return Success{};
}

Status runInfo(const InfoArguments& arguments) {
  if (isSequence(arguments.input.file)) {
    return runSequenceInfo(arguments);
  }
  const Result<Document> document = openDocument(arguments.input);
  if (!document) {
    return document.error();
  }
  const Json info = infoOf(*document);
  if (arguments.json) {
    arguments.json.print(info);
  } else {
    printInfo(info);
  }
  return Success{};
}

} // namespace

Verb infoVerb() {
  return {
      "info",
      "Tells what a file holds: meshes, joints, clips, cameras, limbs found, saved trails, offsets, holds "
      "and loops, extensions, "
      "warnings.",
      [](CommandLine& line) {
        const auto arguments = std::make_shared<InfoArguments>();
        line.examples({"punch.glb", "--json punch.glb"});
        addFileArguments(line, arguments->input);
        addPlan(line, arguments->input);
        addJson(line, arguments->json);
        return [arguments] { return runInfo(*arguments); };
      }};
}

} // namespace stretch::app
