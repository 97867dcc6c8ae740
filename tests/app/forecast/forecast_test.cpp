#include <algorithm>
#include <iterator>
#include <numeric>

#include <catch2/catch.hpp>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/edits/keys/track_edits.h"
#include "app/files/save.h"
#include "app/forecast/clip_changes.h"
#include "app/forecast/engines.h"
#include "app/forecast/forecast.h"
#include "app/forecast/shading.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/nodes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

constexpr const char* punchGlb = STRETCH_SOURCE_DIR "/assets/dummy.glb";

std::string punchIn(const test::TemporaryFolder& folder, const SavedForm& form,
                    const std::string& limb = "left-arm") {
  const Result<Document> source = openDocument(punchGlb);
  REQUIRE(source);
  const Document document =
      test::withNewTrail(*source, {.limb = limb, .startFrame = 21.0, .endFrame = 27.0, .scale = 3.0});
  std::string file = (folder / "punch.glb").string();
  REQUIRE(saveDocument(document, file, {.clean = true, .form = form}));
  return file;
}

Json checked(const std::vector<std::string>& words) {
  std::vector<std::string> all{"check"};
  all.insert(all.end(), words.begin(), words.end());
  all.emplace_back("--json");
  const test::VerbAnswer answer = test::runVerb(all);
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output);
}

// The findings of an engine with an id.
std::vector<Json> found(const Json& report, const std::string& engine, const std::string& id) {
  std::vector<Json> findings;
  for (const Json& one : report["engines"]) {
    for (const Json& finding : one["findings"]) {
      if (one["engine"] == engine && finding["id"] == id) {
        findings.push_back(finding);
      }
    }
  }
  return findings;
}

bool isNotJudged(const Json& report, const std::string& engine, const std::string& subject) {
  return std::ranges::any_of(report["engines"], [&](const Json& one) {
    return one["engine"] == engine &&
           std::ranges::find(one["not_judged"], Json(subject)) != one["not_judged"].end();
  });
}

} // namespace

TEST_CASE("Shading by the plain matrix is forecast for the engines that have it, with limb, frame, share and "
          "remedy") {
  const test::TemporaryFolder folder;
  const Json report = checked({punchIn(folder, {}), "--engine", "all"});
  CHECK(report["engines"].size() == engines().size());
  for (const char* engine : {"three", "godot", "babylon"}) {
    const std::vector<Json> findings = found(report, engine, "shading-plain-matrix");
    REQUIRE(findings.size() == 1);
    CHECK(findings[0]["limb"] == "left-arm");
    CHECK(findings[0]["share"] > 0.2);
    CHECK(findings[0]["share"] < 0.4);
    CHECK(findings[0]["frame"] >= 25.0);
    CHECK(findings[0]["frame"] <= 29.0);
    CHECK(findings[0]["remedy"].get<std::string>().find("--form volume") != std::string::npos);
  }
  CHECK(found(report, "unreal", "shading-plain-matrix").empty());
  CHECK(isNotJudged(report, "unreal", "shading"));
  CHECK_FALSE(isNotJudged(report, "three", "shading"));
}

TEST_CASE("Corners and translations are shaded right everywhere, the source is, too") {
  const test::TemporaryFolder folder;
  for (const StretchForm form : {StretchForm::translation, StretchForm::volume}) {
    const Json report = checked({punchIn(folder, {form, 8}), "--engine", "three"});
    CHECK(found(report, "three", "shading-plain-matrix").empty());
  }
  CHECK(found(checked({punchGlb, "--engine", "all"}), "three", "shading-plain-matrix").empty());
}

TEST_CASE("Scale of joints is forecast to be left out where an engine does, and corners to play there") {
  const test::TemporaryFolder folder;
  const Json scale = checked({punchIn(folder, {}), "--engine", "unreal,roblox"});
  REQUIRE(scale["engines"].size() == 2);
  REQUIRE(found(scale, "roblox", "scale-not-supported").size() == 1);
  CHECK(found(scale, "roblox", "scale-not-supported")[0]["severity"] == "error");
  CHECK(found(scale, "roblox", "scale-not-supported")[0]["limb"] == "left-arm");
  CHECK(found(scale, "unreal", "scale-may-be-dropped").size() == 1);
  const Json corners = checked({punchIn(folder, {StretchForm::volume, 8}), "--engine", "unreal,roblox"});
  CHECK(found(corners, "roblox", "scale-not-supported").empty());
  CHECK(found(corners, "unreal", "scale-may-be-dropped").empty());
}

TEST_CASE("A humanoid rig leaves out the translation of hand and forearm, and not that of the upper legs") {
  const test::TemporaryFolder folder;
  const Json report = checked({punchIn(folder, {}), "--engine", "unity-humanoid,unity-generic"});
  const std::vector<Json> findings = found(report, "unity-humanoid", "translation-of-mapped-bones");
  REQUIRE(findings.size() == 1);
  CHECK(findings[0]["limb"] == "left-arm");
  CHECK(found(report, "unity-generic", "translation-of-mapped-bones").empty());
  CHECK(found(report, "unity-humanoid", "scale-of-mapped-bones").empty()); // leaves are not mapped
  CHECK(found(checked({punchGlb, "--engine", "unity-humanoid"}), "unity-humanoid",
              "translation-of-mapped-bones")
            .empty());
}

TEST_CASE("Culling by the box at rest is forecast where a limb leaves it") {
  const test::TemporaryFolder folder;
  const Json report = checked({punchIn(folder, {}), "--engine", "three,godot"});
  const std::vector<Json> culled = found(report, "three", "culled-by-the-box-at-rest");
  REQUIRE_FALSE(culled.empty());
  CHECK(culled[0]["clip"] == "One-two punch");
  CHECK(culled[0]["what"].get<std::string>().find("1.0") != std::string::npos);
  CHECK(isNotJudged(report, "godot", "culling"));
}

TEST_CASE("Influences beyond four are forecast to be left out by three.js, and four are not") {
  const test::TemporaryFolder folder;
  const Json eight = checked({punchIn(folder, {StretchForm::volume, 8}), "--engine", "three"});
  CHECK(found(eight, "three", "influences-left-out").size() == 1);
  const Json four = checked({punchIn(folder, {StretchForm::volume, 4}), "--engine", "three"});
  CHECK(found(four, "three", "influences-left-out").empty());
}

TEST_CASE("An engine that nobody knows is refused with those that are known") {
  const test::VerbAnswer answer = test::runVerb({"check", punchGlb, "--engine", "three,cryengine"});
  CHECK(answer.exitCode == 2);
  CHECK(answer.told.find("'cryengine'") != std::string::npos);
  CHECK(answer.told.find("roblox") != std::string::npos);
}

TEST_CASE("A check without engines and without a source tells of neither") {
  const Json report = checked({punchGlb});
  CHECK_FALSE(report.contains("engines"));
  CHECK_FALSE(report.contains("worse"));
}

namespace {

bool tells(const Json& worse, const std::string& id) {
  return std::ranges::any_of(worse, [&](const Json& change) { return change["id"] == id; });
}

} // namespace

TEST_CASE(
    "Before and after: nothing is worse in the source itself, and a leg that is stretched slides and sinks") {
  const test::TemporaryFolder folder;
  CHECK(checked({punchGlb, "--before", punchGlb})["worse"].empty());
  const Json worse = checked({punchIn(folder, {}, "left-leg"), "--before", punchGlb})["worse"];
  CHECK((tells(worse, "foot-slide") || tells(worse, "below-floor")));
  for (const Json& change : worse) {
    CHECK(change["result"] > change["source"]);
  }
}

TEST_CASE(
    "Before and after: what worsens is in the report of the verb that writes, as check tells it afterwards") {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "leg.glb").string();
  const test::VerbAnswer answer = test::runVerb({"exaggerate", punchGlb, "-o", out, "--limb", "left-leg",
                                                 "--range", "21:27", "--scale", "3", "--json"});
  REQUIRE(answer.exitCode == 0);
  const Json told = Json::parse(answer.output).value("worse", Json::array());
  const Json later = checked({out, "--before", punchGlb})["worse"];
  REQUIRE(told.size() == later.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    CHECK(told[i]["id"] == later[i]["id"]);
    CHECK(told[i]["result"].get<double>() ==
          Approx(later[i]["result"].get<double>()).epsilon(0.05).margin(0.02));
  }
}

TEST_CASE("Before and after: a body that jumps aside at the seam is no loop any more, whatever its travel") {
  const test::TemporaryFolder folder;
  const std::string recipe = folder
                                 .write("aside.json", R"({"version": 1, "adjustments": [{"controller": "body",
      "keys": [{"frame": 50, "move": [0, 0, 0]}, {"frame": 60, "move": [0.3, 0, 0]}]}]})")
                                 .string();
  const std::string out = (folder / "aside.glb").string();
  REQUIRE(test::runVerb({"pose", punchGlb, "-o", out, "--recipe", recipe}).exitCode == 0);
  const Json worse = checked({out, "--before", punchGlb})["worse"];
  const auto seam = std::ranges::find(worse, "loop-seam-place", [](const Json& one) { return one["id"]; });
  REQUIRE(seam != worse.end());
  CHECK((*seam)["result"].get<double>() == Approx(100.0 * 0.3 * 0.8 / 1.8).epsilon(0.05)); // legs are 0.8
                                                                                           // long, the
                                                                                           // body 1.8
}

TEST_CASE("Before and after: a file of another character is refused") {
  const test::VerbAnswer answer =
      test::runVerb({"check", punchGlb, "--before", STRETCH_SOURCE_DIR "/assets/dummy.glb.missing"});
  CHECK(answer.exitCode == 1);
}

namespace {

// A track in the punch of the bundled boxer: one key each second, with tangents of 5 where it is a curve.
Document withPunchTrack(const char* name, Channel channel, const std::vector<Vec3>& keys,
                        Interpolation interpolation = Interpolation::linear) {
  const Result<Document> source = openDocument(punchGlb);
  REQUIRE(source);
  const auto node = std::ranges::find(source->scene->nodes, name, &Node::name);
  REQUIRE(node != source->scene->nodes.end());
  Track track;
  track.node = NodeIndex(static_cast<std::size_t>(node - source->scene->nodes.begin()));
  track.channel = channel;
  track.width = 3;
  track.interpolation = interpolation;
  const bool isCurve = interpolation == Interpolation::cubicSpline;
  const auto add = [&](const Vec3& value) {
    for (const double number : {value.x, value.y, value.z}) {
      track.values.push_back(static_cast<float>(number));
    }
  };
  for (std::size_t key = 0; key < keys.size(); ++key) {
    track.times.push_back(static_cast<float>(key));
    for (const Vec3& value : isCurve ? std::vector<Vec3>{Vec3(5.0, 0.0, 0.0), keys[key], Vec3(0.0, 5.0, 0.0)}
                                     : std::vector<Vec3>{keys[key]}) {
      add(value);
    }
  }
  return setTracks(*source, 0, {track});
}

std::vector<ForecastFinding> findingsOf(const Document& document, const char* engine, const std::string& id) {
  const std::vector<EngineForecast> forecasts = forecast(document, {engine});
  REQUIRE(forecasts.size() == 1);
  std::vector<ForecastFinding> found;
  std::ranges::copy_if(forecasts[0].findings, std::back_inserter(found),
                       [&](const ForecastFinding& finding) { return finding.id == id; });
  return found;
}

Vec3 restOf(const char* name) {
  const Result<Document> source = openDocument(punchGlb);
  REQUIRE(source);
  return std::ranges::find(source->scene->nodes, name, &Node::name)->rest.translation;
}

} // namespace

TEST_CASE(
    "Scale that any one key has along any one axis is forecast, and one that every key and axis shares is "
    "not") {
  const auto isTold = [](const std::vector<Vec3>& keys, Interpolation interpolation = Interpolation::linear) {
    const Document document = withPunchTrack("LeftForeArm", Channel::scale, keys, interpolation);
    const std::vector<ForecastFinding> found = findingsOf(document, "roblox", "scale-not-supported");
    for (const ForecastFinding& finding : found) {
      CHECK(finding.what == "Roblox does not play 1 channels that scale joints (left-arm)");
      CHECK(finding.limb == "left-arm");
      CHECK(finding.clip == "One-two punch");
    }
    CHECK(findingsOf(document, "unreal", "scale-may-be-dropped").size() == found.size());
    CHECK(findingsOf(document, "three", "scale-not-supported").empty());
    return !found.empty();
  };
  for (std::size_t key = 0; key < 3; ++key) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      for (const auto& [scale, seen] : {std::pair(1.002, true), std::pair(1.0005, false),
                                        std::pair(0.998, true), std::pair(0.9995, false)}) {
        CAPTURE(key, axis, scale);
        std::vector<Vec3> keys(3, Vec3(1.0));
        keys[key][axis] = scale;
        CHECK(isTold(keys) == seen);
        if (axis == 0) {
          keys[key] = Vec3(scale);
          CHECK(isTold(keys) == seen);
          CHECK(isTold(keys, Interpolation::cubicSpline) == seen); // whatever its tangents are
        }
      }
    }
  }
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    Vec3 always(1.0);
    always[axis] = 1.2;
    CHECK(isTold({always, always}));
  }
  CHECK_FALSE(isTold({Vec3(2.0), Vec3(2.0)}));
}

TEST_CASE(
    "Bones of a humanoid map that move by more than a hundredth of their length are forecast to stay, but "
    "for those that a map lets move") {
  const auto isTold = [](const char* bone, double share) {
    const Vec3 rest = restOf(bone);
    const Vec3 moved = rest + Vec3(share * glm::length(rest), 0.0, 0.0);
    const Document document = withPunchTrack(bone, Channel::translation, {moved, rest});
    CHECK(findingsOf(document, "unity-generic", "translation-of-mapped-bones").empty());
    CHECK(findingsOf(document, "unity-humanoid", "scale-of-mapped-bones").empty());
    return !findingsOf(document, "unity-humanoid", "translation-of-mapped-bones").empty();
  };
  for (const char* const held :
       {"Spine", "LeftArm", "LeftForeArm", "RightForeArm", "LeftHand", "RightLeg", "LeftFoot", "Head"}) {
    CAPTURE(held);
    CHECK(isTold(held, 0.011));
    CHECK(isTold(held, -0.011));
    CHECK_FALSE(isTold(held, 0.009));
  }
  for (const char* const free :
       {"Hips", "LeftUpLeg", "RightUpLeg", "LeftHandThumb1", "Spine1", "Spine2", "Neck", "RightShoulder"}) {
    CAPTURE(free);
    CHECK_FALSE(isTold(free, 0.5));
  }
  for (const char* const bone : {"Hips", "LeftUpLeg", "RightForeArm", "LeftHand"}) {
    CAPTURE(bone);
    const Document document = withPunchTrack(bone, Channel::scale, {Vec3(1.5), Vec3(1.0)});
    const std::vector<ForecastFinding> found =
        findingsOf(document, "unity-humanoid", "scale-of-mapped-bones");
    REQUIRE(found.size() == 1);
    CHECK(found[0].what.starts_with("Unity, humanoid rig leaves out 1 channels that scale mapped bones ("));
    CHECK(findingsOf(document, "unity-generic", "scale-of-mapped-bones").empty());
    CHECK(findingsOf(document, "unity-humanoid", "translation-of-mapped-bones").empty());
  }
}

TEST_CASE(
    "A second leaf that is sheared is forecast where an engine holds no shear, and corners to play there") {
  Result<Document> document = openDocument(punchGlb);
  REQUIRE(document);
  CHECK(findingsOf(*document, "unreal", "shear").empty());
  Scene scene = *document->scene;
  const NodeIndex joint(static_cast<std::size_t>(std::ranges::find(scene.nodes, "LeftForeArm", &Node::name) -
                                                 scene.nodes.begin()));
  const NodeIndex leaf = test::addNode(scene, "leaf", joint, Vec3(0.0));
  const NodeIndex end = test::addNode(scene, "end", leaf, Vec3(0.0));
  scene.nodes[at(leaf)].rest.rotation = axisAngle(Vec3(0.0, 0.0, 1.0), 0.6);
  scene.nodes[at(leaf)].rest.scale = Vec3(2.0, 0.7, 0.7);
  scene.nodes[at(end)].rest.rotation = axisAngle(Vec3(0.0, 0.0, 1.0), -0.6);
  scene.nodes[at(end)].isBindLeaf = true;
  scene.bindChains = {{joint, leaf, end}};
  document->scene = std::make_shared<const Scene>(std::move(scene));
  const std::vector<ForecastFinding> found = findingsOf(*document, "unreal", "shear");
  REQUIRE(found.size() == 1);
  // The angle between what were right angles, 40.6 degrees, is so much less.
  CHECK(found[0].what == "Unreal holds no shear: 'end' is sheared by up to 49.4 degrees");
  CHECK(found[0].remedy == "save the stretch with --form volume");
  CHECK(findingsOf(*document, "three", "shear").empty());
}

TEST_CASE("Keys that are not lines are left unjudged by the engines that read them otherwise") {
  const std::string subject = "keys that are not LINEAR";
  const auto notJudged = [&](const Document& document, const char* engine) {
    const std::vector<std::string> subjects = forecast(document, {engine}).front().notJudged;
    return std::ranges::find(subjects, subject) != subjects.end();
  };
  for (const Interpolation kind : {Interpolation::linear, Interpolation::step, Interpolation::cubicSpline}) {
    Document document = withPunchTrack("Head", Channel::scale, {Vec3(1.0), Vec3(1.0)}, kind);
    Clip alone = clipOf(document, 0);
    std::erase_if(alone.tracks, [](const auto& track) { return track->channel != Channel::scale; });
    document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{alone});
    CHECK_FALSE(notJudged(document, "three"));
    CHECK_FALSE(notJudged(document, "babylon"));
    for (const char* const engine : {"godot", "unity-generic", "unity-humanoid", "unreal", "roblox"}) {
      CHECK(notJudged(document, engine) == (kind != Interpolation::linear));
    }
  }
}

TEST_CASE("Shading of a mesh without normals is left unjudged, since each program computes its own") {
  const test::TemporaryFolder folder;
  Result<Document> document = openDocument(punchIn(folder, {}));
  REQUIRE(document);
  const std::string subject = "shading of meshes without normals";
  const auto notJudged = [&](const char* engine) {
    const std::vector<std::string> subjects = forecast(*document, {engine}).front().notJudged;
    return std::ranges::find(subjects, subject) != subjects.end();
  };
  CHECK_FALSE(notJudged("three"));
  REQUIRE(findingsOf(*document, "three", "shading-plain-matrix").size() == 1);
  Scene bare = *document->scene;
  for (Mesh& mesh : bare.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      primitive.hasNormals = false;
    }
  }
  document->scene = std::make_shared<const Scene>(std::move(bare));
  CHECK(findingsOf(*document, "three", "shading-plain-matrix").empty());
  for (const char* engine : {"three", "godot", "babylon"}) {
    CHECK(notJudged(engine));
  }
  CHECK_FALSE(notJudged("unreal"));
}

TEST_CASE("Engines are asked for by their names, some, all, or none") {
  const Result<std::vector<std::string>> two = engineIdsOf("roblox,three");
  REQUIRE(two);
  CHECK(*two == std::vector<std::string>{"roblox", "three"});
  const std::vector<std::string> all{"three",          "godot",  "babylon", "unity-generic",
                                     "unity-humanoid", "unreal", "roblox"};
  REQUIRE(engineIdsOf("all"));
  CHECK(*engineIdsOf("all") == all);
  const std::string some = "some of three, godot, babylon, unity-generic, unity-humanoid, unreal, roblox, ";
  REQUIRE_FALSE(engineIdsOf("three,quake"));
  CHECK(engineIdsOf("three,quake").error().line() ==
        "--engine: 'quake' is no engine that is known here; give " + some + "or all");
  REQUIRE_FALSE(engineIdsOf(""));
  CHECK(engineIdsOf("").error().line() == "--engine: names no engine; give all, or " + some);
}

TEST_CASE(
    "A mesh that is more than a twentieth of the height beside its box at rest, on any side, may be culled") {
  const Result<Document> source = openDocument(punchGlb);
  REQUIRE(source);
  const auto carried = [](const Vec3& aside) {
    const Vec3 place = restOf("Hips") + aside;
    Document document = withPunchTrack("Hips", Channel::translation, {place});
    Clip still = clipOf(document, 0);
    std::erase_if(still.tracks, [](const auto& track) { return track->channel != Channel::translation; });
    still.endSeconds = 0.0;
    document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{still});
    return document;
  };
  const auto culledBy = [](const Document& document, const char* engine) {
    return findingsOf(document, engine, "culled-by-the-box-at-rest");
  };
  const auto told = [&](const Vec3& aside) {
    const std::vector<ForecastFinding> found = culledBy(carried(aside), "babylon");
    return found.empty() ? std::string() : found.front().what;
  };
  const double height = source->body.height;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      CAPTURE(axis, side);
      Vec3 aside(0.0);
      aside[axis] = 2.0 * side * height;
      CHECK_THAT(told(aside), Catch::Contains("the clip reaches 2.00 heights beyond the box at rest"));
      aside[axis] = 0.051 * side * height;
      CHECK_FALSE(told(aside).empty());
      aside[axis] = 0.049 * side * height;
      CHECK(told(aside).empty());
    }
  }
  const Document far = carried(Vec3(height, 0.0, 0.0));
  for (const char* const culls : {"three", "babylon", "unity-generic", "unity-humanoid"}) {
    CAPTURE(culls);
    REQUIRE(culledBy(far, culls).size() == 1);
    CHECK_FALSE(culledBy(far, culls).front().remedy.empty());
  }
  for (const char* const shows : {"godot", "unreal", "roblox"}) {
    CHECK(culledBy(far, shows).empty());
  }
}

TEST_CASE("What is not known of an engine is left open, and what is known is not") {
  for (const Engine& engine : engines()) {
    CAPTURE(engine.id);
    const auto isOpen = [&](const char* subject) {
      return std::ranges::find(engine.notJudged, subject) != engine.notJudged.end();
    };
    CHECK(isOpen("number of joints"));
    CHECK(isOpen("shading") == !engine.turnsNormalsPlainly);
    CHECK(isOpen("culling") == !engine.cullsByRestBox);
    CHECK(isOpen("influences of a vertex") == (engine.mostInfluences == 0));
    CHECK(engine.cullingRemedy.empty() == !engine.cullsByRestBox);
  }
}

TEST_CASE(
    "Influences that are left out are told with the vertices that have them and the most that one loses") {
  const test::TemporaryFolder folder;
  const Result<Document> document = openAsItStands(punchIn(folder, {StretchForm::volume, 8}));
  REQUIRE(document);
  std::size_t vertices = 0;
  std::size_t more = 0;
  double heaviest = 0.0;
  for (const Mesh& mesh : document->scene->meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      const std::vector<VertexInfluences>& written =
          primitive.onCorners.empty() ? primitive.influences : primitive.onCorners;
      vertices += written.size();
      for (const VertexInfluences& vertex : written) {
        const float left = std::accumulate(vertex.weights.begin() + 4, vertex.weights.end(), 0.0F);
        more += left > 0.0F ? 1 : 0;
        heaviest = std::max(heaviest, static_cast<double>(left));
      }
    }
  }
  const std::vector<ForecastFinding> found = findingsOf(*document, "three", "influences-left-out");
  REQUIRE(found.size() == 1);
  CHECK(found[0].clip.empty());
  REQUIRE(found[0].share);
  CHECK(*found[0].share == Approx(static_cast<double>(more) / static_cast<double>(vertices)));
  const std::string weighs = "the heaviest that is left out weighs ";
  CHECK_THAT(found[0].what, Catch::StartsWith(fmt::format("three.js reads 4 influences of a vertex: {} of {} "
                                                          "vertices have more, {}",
                                                          more, vertices, weighs)));
  CHECK(std::stod(found[0].what.substr(found[0].what.find(weighs) + weighs.size())) ==
        Approx(heaviest).margin(0.01));
}

TEST_CASE("A joint is of the limb that it is part of, ends, or hangs on, and the hips are of none") {
  const Result<Document> document = openDocument(punchGlb);
  REQUIRE(document);
  for (const auto& [name, limb] : {std::pair("LeftArm", "left-arm"),
                                   {"LeftHand", "left-arm"},
                                   {"LeftHandThumb1", "left-arm"},
                                   {"RightFoot", "right-leg"},
                                   {"RightToeBase", "right-leg"},
                                   {"Head", "neck"},
                                   {"Spine2", "spine"},
                                   {"LeftShoulder", "spine"},
                                   {"Hips", ""}}) {
    CAPTURE(name);
    const auto node = std::ranges::find(document->scene->nodes, name, &Node::name);
    REQUIRE(node != document->scene->nodes.end());
    CHECK(limbOfNode(*document, NodeIndex(static_cast<std::size_t>(node - document->scene->nodes.begin()))) ==
          limb);
  }
  CHECK(limbOfNode(*document, NodeIndex::none).empty());
}
