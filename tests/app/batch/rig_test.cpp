#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/files/save.h"
#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "app/schema/locator_json.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/detection.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/skinning/tube_person.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using test::runVerb;
using test::TubePerson;

namespace {

constexpr double height = 1.8;

struct PersonFile {
  test::TemporaryFolder folder;
  TubePerson person = test::tubePerson({.armsDown = 0.5});
  std::string mesh = (folder.path() / "person.gltf").string();
  std::string output = (folder.path() / "out.glb").string();
  std::string places = (folder.path() / "places.json").string();

  PersonFile() { test::writeMeshFile(mesh, person.positions, person.triangles); }
};

Vec3 placeOfNode(const Document& document, const std::string& name) {
  const Result<NodeIndex> node = rig::jointByName(*document.scene, name);
  REQUIRE(node);
  return positionOf(rig::bindPoseWorlds(*document.scene)[at(*node)]);
}

} // namespace

TEST_CASE("rig makes joints where the body has them, and all six limbs are found on them", "[locators]") {
  const PersonFile file;
  const test::VerbAnswer answer = runVerb({"rig", file.mesh, "-o", file.output});
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  const Result<Document> rigged = openDocument(file.output);
  REQUIRE(rigged);
  CHECK(rigged->body.isBiped);
  CHECK(rigged->body.limbs.size() == 6);
  for (const auto& [name, place] : file.person.joints) {
    INFO(name);
    CHECK(glm::distance(placeOfNode(*rigged, name), place) < 0.05 * height);
  }
  // What the mesh is made of is as it was.
  CHECK(vertexCount(*rigged->scene) == file.person.positions.size());
  CHECK(rigged->locators.list.size() == 22);
}

TEST_CASE("Locators that are written, moved and given back are where the joints then are", "[locators]") {
  const PersonFile file;
  REQUIRE(runVerb({"rig", file.mesh, "-o", file.places, "--locators-only"}).exitCode == 0);
  Result<rig::Locators> locators = loadLocators(file.places);
  REQUIRE(locators);
  rig::Locator& elbow = *rig::findLocator(*locators, "leftLowerArm");
  elbow.position += Vec3(0.0, -0.07, 0.02);
  REQUIRE(writeText(file.places, locatorsToJson(*locators).dump()));
  REQUIRE(runVerb({"rig", file.mesh, "-o", file.output, "--locators", file.places}).exitCode == 0);
  const Result<Document> rigged = openDocument(file.output);
  REQUIRE(rigged);
  for (const rig::Locator& locator : locators->list) {
    INFO(locator.name);
    CHECK(glm::distance(placeOfNode(*rigged, locator.name), locator.position) < 1e-5);
  }
}

TEST_CASE("rig --json tells what it did, and which locators are guessed", "[locators]") {
  const PersonFile file;
  const TubePerson armless = test::tubePerson({.hasArms = false});
  test::writeMeshFile(file.mesh, armless.positions, armless.triangles);
  const test::VerbAnswer answer = runVerb({"rig", file.mesh, "-o", file.output, "--json"});
  REQUIRE(answer.exitCode == 0);
  const gltf::Json report = gltf::Json::parse(answer.output);
  CHECK(report["plan"] == "biped");
  CHECK(report["from"] == "mesh");
  CHECK(report["joints"] == 22);
  CHECK(report["unsure"].dump().find("leftHand") != std::string::npos);
  CHECK(report["unsure"].dump().find("leftFoot") == std::string::npos);
  CHECK(report["warnings"].size() == 1);
}

TEST_CASE("A character with a skeleton gives its locators and gets no joint", "[locators]") {
  const PersonFile file;
  const Document before = test::openedFile(test::posedCharacter);
  REQUIRE(runVerb({"rig", test::posedCharacter, "-o", file.places, "--locators-only"}).exitCode == 0);
  Result<rig::Locators> locators = loadLocators(file.places);
  REQUIRE(locators);
  const rig::Limb& arm = *findLimb(before, "left-arm");
  CHECK(glm::distance(rig::findLocator(*locators, "leftUpperArm")->position,
                      positionOf(rig::bindPoseWorlds(*before.scene)[at(arm.joints.front())])) < 1e-6);
  const test::VerbAnswer unasked = runVerb({"rig", test::posedCharacter, "-o", file.output});
  CHECK(unasked.exitCode == 1);
  CHECK(unasked.told.find("has a skeleton already") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(file.output));
  const std::size_t nodes = before.scene->nodes.size();
  REQUIRE(runVerb({"rig", test::posedCharacter, "-o", file.output, "--locators", file.places}).exitCode == 0);
  CHECK(openDocument(file.output)->scene->nodes.size() == nodes);
}

TEST_CASE("A moved locator corrects the limb of a skeleton: it goes by the nearest joint", "[locators]") {
  const Document before = test::openedFile(test::posedCharacter);
  rig::Locators locators = fitLocators(before)->locators;
  const Result<Document> same = withLimbsAt(before, locators);
  REQUIRE(same);
  CHECK(same->body.limbs == before.body.limbs);
  const rig::Limb& arm = *findLimb(before, "left-arm");
  const NodeIndex hand = arm.endNode;
  const NodeIndex finger = before.scene->nodes[at(hand)].children.empty()
                               ? NodeIndex::none
                               : before.scene->nodes[at(hand)].children.front();
  REQUIRE(finger.exists());
  rig::findLocator(locators, "leftHand")->position =
      positionOf(rig::bindPoseWorlds(*before.scene)[at(finger)]);
  const Result<Document> corrected = withLimbsAt(before, locators);
  REQUIRE(corrected);
  CHECK(findLimb(*corrected, "left-arm")->endNode == finger);
  CHECK(corrected->limbsCorrected);
  rig::findLocator(locators, "leftHand")->position = rig::findLocator(locators, "rightFoot")->position;
  const Result<Document> torn = withLimbsAt(before, locators);
  REQUIRE_FALSE(torn);
  CHECK(torn.error().line().find("leftHand") != std::string::npos);
}

TEST_CASE("What rig cannot do is told in one line, and nothing is written", "[locators]") {
  const PersonFile file;
  test::writeMeshFile(file.mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const test::VerbAnswer triangle = runVerb({"rig", file.mesh, "-o", file.output});
  CHECK(triangle.exitCode == 1);
  CHECK(triangle.told.find("by hand") != std::string::npos);
  CHECK(triangle.told.find("person.gltf") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(file.output));
  CHECK(runVerb({"rig", file.mesh, "-o", file.output, "--plan", "centipede"}).exitCode == 2);
  CHECK(runVerb({"rig", file.mesh, "-o", file.output, "--locators", "missing.json"}).exitCode == 1);
  CHECK(runVerb({"rig", file.mesh, "-o", file.mesh}).exitCode == 1);
}

TEST_CASE("rig --json tells no joint where none was made", "[locators]") {
  const PersonFile file;
  const auto jointsOf = [](const std::vector<std::string>& words) {
    const test::VerbAnswer answer = runVerb(words);
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    return gltf::Json::parse(answer.output)["joints"].get<int>();
  };
  CHECK(jointsOf({"rig", file.mesh, "-o", file.places, "--locators-only", "--json"}) == 0);
  CHECK(jointsOf({"rig", file.mesh, "-o", file.output, "--locators", file.places, "--json"}) == 22);
  CHECK(jointsOf({"rig", test::posedCharacter, "-o", file.places, "--locators-only", "--json"}) == 0);
  CHECK(jointsOf({"rig", test::posedCharacter, "-o", file.output, "--locators", file.places, "--json"}) == 0);
}

TEST_CASE("rig tells in words how many locators of which body there are, and whether a skeleton has them",
          "[locators]") {
  const PersonFile file;
  const auto told = [&](const std::string& character) {
    const test::VerbAnswer answer = runVerb({"rig", character, "-o", file.places, "--locators-only"});
    REQUIRE(answer.exitCode == 0);
    return answer.output;
  };
  const auto count = [&] { return std::to_string(loadLocators(file.places)->list.size()); };
  const std::string ofSkeleton = told(test::posedCharacter);
  CHECK_THAT(ofSkeleton, Catch::StartsWith(count() + " locators of ") &&
                             Catch::Contains(", at the limbs of its skeleton\n") &&
                             !Catch::Contains("limbs: "));
  const std::string ofMesh = told(file.mesh);
  CHECK_THAT(ofMesh, Catch::StartsWith(count() + " locators of ") && !Catch::Contains("skeleton"));
}
