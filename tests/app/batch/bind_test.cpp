#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>

#include "app/bind/bind_mesh.h"
#include "app/document.h"
#include "app/evaluate/evaluate.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "rig/body/evidence/bind_pose.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/app/locator_text.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/core/two_sheets.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::openedFile;
using test::posedCharacter;
using test::runVerb;
using test::TemporaryFolder;
using test::VerbAnswer;

namespace {

// The bundled character as if nobody had rigged it: its mesh alone, without skin, joints or clips.
std::string statue(const TemporaryFolder& folder) {
  gltf::Source source = *openedFile(posedCharacter).source;
  Json& json = *source.json;
  const std::size_t holder = json["nodes"].size() - 1;
  REQUIRE(json["nodes"][holder].contains("mesh"));
  Json node = json["nodes"][holder];
  node.erase("skin");
  json["nodes"] = {node};
  json["scenes"] = {{{"nodes", {0}}}};
  json["scene"] = 0;
  json.erase("skins");
  json.erase("animations");
  for (Json& primitive : json["meshes"][0]["primitives"]) {
    primitive["attributes"].erase("JOINTS_0");
    primitive["attributes"].erase("WEIGHTS_0");
  }
  REQUIRE(gltf::save(source, folder / "statue.glb").ok());
  return (folder / "statue.glb").string();
}

// Locators at the joints of the bundled character, by the names that VRM gives them.
std::string locatorsOf(const TemporaryFolder& folder) {
  const std::map<std::string, std::string> names{
      {"hips", "Hips"},    {"spine", "Spine"},      {"chest", "Spine1"}, {"upperChest", "Spine2"},
      {"neck", "Neck"},    {"head", "Head"},        {"UpperArm", "Arm"}, {"LowerArm", "ForeArm"},
      {"Hand", "Hand"},    {"UpperLeg", "UpLeg"},   {"LowerLeg", "Leg"}, {"Foot", "Foot"},
      {"Toes", "ToeBase"}, {"Shoulder", "Shoulder"}};
  const Document character = openedFile(posedCharacter);
  const std::vector<Mat4> worlds = rig::bindPoseWorlds(*character.scene);
  Json json = test::locatorText();
  Json kept = Json::array();
  for (Json& locator : json["locators"]) {
    const std::string name = locator["name"];
    const bool isLeft = name.starts_with("left");
    const bool hasSide = isLeft || name.starts_with("right");
    const std::string part = hasSide ? name.substr(isLeft ? 4 : 5) : name;
    const std::string joint = (hasSide ? (isLeft ? "Left" : "Right") : "") + names.at(part);
    for (std::size_t node = 0; node < character.scene->nodes.size(); ++node) {
      if (character.scene->nodes[node].name.ends_with(joint) && character.scene->nodes[node].mesh < 0) {
        const Vec3 place = positionOf(worlds[node]);
        locator["position"] = {place.x, place.y, place.z};
        kept.push_back(locator);
        break;
      }
    }
  }
  json["locators"] = kept;
  std::string path = (folder / "locators.json").string();
  REQUIRE(writeText(path, json.dump(), MissingFolder::isError).ok());
  return path;
}

std::vector<Vec3> atRest(const Document& document) {
  return skinning::skinnedPositions(*document.scene,
                                    frameOf(*document.scene, restPose(*document.scene), 0.0));
}

Json reportOf(const VerbAnswer& answer) {
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  return Json::parse(answer.output);
}

} // namespace

TEST_CASE("A statue bound at locators stands as it stood, and its limbs are found") {
  const TemporaryFolder folder;
  const std::string mesh = statue(folder);
  const std::string out = (folder / "bound.glb").string();
  const Json report =
      reportOf(runVerb({"bind", mesh, "-o", out, "--locators", locatorsOf(folder), "--json"}));
  CHECK(report["joints"] > 15);
  CHECK(report["cubes"] > 1000);
  CHECK(report["megabytes"] > 0.0);
  const Document before = openedFile(mesh);
  const Document after = openedFile(out);
  CHECK(after.body.isBiped);
  CHECK(after.body.limbs.size() == 6);
  const std::vector<Vec3> stood = atRest(before);
  const std::vector<Vec3> stands = atRest(after);
  REQUIRE(stood.size() == stands.size());
  double largest = 0.0;
  for (std::size_t v = 0; v < stood.size(); ++v) {
    largest = std::max(largest, glm::distance(stood[v], stands[v]));
  }
  CHECK(largest < 1e-5 * after.body.height);
  const Json& json = after.source->json;
  CHECK(json["nodes"][1]["name"] == "hips");
  CHECK(json["materials"] == (*before.source->json)["materials"]);
}

TEST_CASE("Locators that are given for a bound file move its joints, and it is bound again at them") {
  const TemporaryFolder folder;
  const std::string bound = (folder / "bound.glb").string();
  const std::string places = (folder / "places.json").string();
  const std::string again = (folder / "again.glb").string();
  REQUIRE(runVerb({"bind", statue(folder), "-o", bound, "--locators", locatorsOf(folder)}).exitCode == 0);
  REQUIRE(runVerb({"rig", bound, "-o", places, "--locators-only"}).exitCode == 0);
  Json json = Json::parse(*readText(places));
  Json& hand =
      *std::ranges::find_if(json["locators"], [](const Json& one) { return one["name"] == "leftHand"; });
  const Vec3 wanted(hand["position"][0].get<double>(), hand["position"][1].get<double>() + 0.05,
                    hand["position"][2].get<double>());
  hand["position"][1] = wanted.y;
  REQUIRE(writeText(places, json.dump()));
  const Json report = reportOf(runVerb({"bind", bound, "-o", again, "--locators", places, "--json"}));
  const Document before = openedFile(bound);
  const Document after = openedFile(again);
  CHECK(report["joints"] == before.scene->skins[0].joints.size());
  CHECK(after.scene->nodes.size() == before.scene->nodes.size());
  CHECK(after.scene->skins.size() == 1);
  const std::vector<Mat4> worlds = rig::bindPoseWorlds(*after.scene);
  const auto joint = std::ranges::find(after.scene->nodes, "leftHand", &Node::name);
  CHECK(glm::distance(positionOf(worlds[static_cast<std::size_t>(joint - after.scene->nodes.begin())]),
                      wanted) < 1e-5);
  const std::vector<Vec3> stood = atRest(before);
  const std::vector<Vec3> stands = atRest(after);
  for (std::size_t v = 0; v < stood.size(); ++v) {
    REQUIRE(glm::distance(stood[v], stands[v]) < 1e-4);
  }
}

TEST_CASE("Binding again at the file's own joints changes weights and nothing else") {
  const TemporaryFolder folder;
  const std::string out = (folder / "again.gltf").string();
  const Json report = reportOf(runVerb({"bind", posedCharacter, "-o", out, "--keep-joints", "--json"}));
  const Document before = openedFile(posedCharacter);
  const Document after = openedFile(out);
  CHECK(report["joints"] == before.scene->skins[0].joints.size());
  CHECK((*after.source->json)["skins"] == (*before.source->json)["skins"]);
  CHECK((*after.source->json)["nodes"] == (*before.source->json)["nodes"]);
  CHECK((*after.source->json)["animations"] == (*before.source->json)["animations"]);
  const FrameState frame = evaluateOriginal(before, 0, 0.5);
  const std::vector<Vec3> artists = skinning::skinnedPositions(*before.scene, frame);
  const std::vector<Vec3> ours = skinning::skinnedPositions(*after.scene, frame);
  double sum = 0.0;
  for (std::size_t v = 0; v < artists.size(); ++v) {
    const double miss = glm::distance(artists[v], ours[v]) / before.body.height;
    sum += miss * miss;
  }
  CHECK(std::sqrt(sum / static_cast<double>(artists.size())) < 0.01);
}

TEST_CASE("A joint of a limb that no vertex follows any more is told") {
  Document document = openedFile(posedCharacter);
  const Result<BoundMeshes> whole = bindMeshes(document, {});
  REQUIRE(whole.ok());
  CHECK(whole->report.warnings.empty());
  Scene footless = *document.scene;
  for (Mesh& mesh : footless.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      std::vector<std::uint32_t> kept;
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const auto triangle = std::span(primitive.indices).subspan(i, 3);
        if (std::ranges::all_of(triangle, [&](std::uint32_t v) { return primitive.positions[v].y > 0.3F; })) {
          kept.insert(kept.end(), triangle.begin(), triangle.end());
        }
      }
      primitive.indices = kept;
    }
  }
  document.scene = std::make_shared<const Scene>(std::move(footless));
  const Result<BoundMeshes> bound = bindMeshes(document, {});
  REQUIRE(bound.ok());
  const auto told = [&](const std::string& joint) {
    return std::ranges::any_of(bound->report.warnings, [&](const std::string& warning) {
      return warning.starts_with("no vertex follows") && warning.find(joint + "\"") != std::string::npos;
    });
  };
  CHECK(told("LeftFoot"));
  CHECK(told("RightFoot"));
  CHECK_FALSE(told("LeftUpLeg"));
  CHECK_FALSE(told("LeftHand"));
}

TEST_CASE("What cannot be bound is said in one line, and nothing is written") {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const auto refused = [&](std::vector<std::string> words, const std::string& line, int code) {
    words.insert(words.begin(), "bind");
    words.insert(words.end(), {"-o", out});
    const VerbAnswer answer = runVerb(words);
    CHECK(answer.exitCode == code);
    CHECK(answer.told.find(line) != std::string::npos);
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(out));
  };
  const std::string locators = locatorsOf(folder);
  refused({posedCharacter}, "bind to it with --keep-joints", 1);
  refused({posedCharacter, "--keep-joints", "--locators", locators}, "either kept or made", 1);
  refused({posedCharacter, "--locators", locators}, "bound to a skeleton already", 1);
  refused({statue(folder), "--keep-joints"}, "no skeleton to bind to", 1);
  refused({posedCharacter, "--keep-joints", "--weights", "surface"}, "not closed", 1);
  refused({posedCharacter, "--keep-joints", "--weights", "magic"}, "magic", 2);
}
