#include <algorithm>
#include <functional>
#include <map>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/files/save.h"
#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "app/schema/locator_json.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "rig/plan/body_plan.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/skinning/tube_creature.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using test::runVerb;
using test::TubePerson;

namespace {

using Move = std::function<Vec3(const Vec3&)>;

struct Body {
  std::string plan;
  TubePerson mesh;
  std::vector<std::string> limbs; ///< That are found in what is built at its locators.
};

std::vector<std::string> limbsOfLegs(int rows) {
  std::vector<std::string> limbs{"spine"};
  for (int row = 1; row <= rows; ++row) {
    const std::string number = row == 1 ? "" : "-" + std::to_string(row);
    limbs.push_back("left-leg" + number);
    limbs.push_back("right-leg" + number);
  }
  return limbs;
}

std::vector<Body> bodies() {
  return {{"biped",
           test::tubePerson({.armsDown = 0.5}),
           {"left-arm", "right-arm", "left-leg", "right-leg", "spine", "neck"}},
          {"quadruped",
           test::tubeQuadruped(),
           {"front-left-leg", "front-right-leg", "hind-left-leg", "hind-right-leg", "spine", "neck", "tail"}},
          {"bird",
           test::tubeBird(),
           {"left-leg", "right-leg", "spine", "neck", "tail", "left-wing", "right-wing"}},
          {"insect", test::tubeInsect(3), limbsOfLegs(3)},
          {"spider", test::tubeInsect(4), limbsOfLegs(4)}};
}

struct Files {
  test::TemporaryFolder folder;
  std::string mesh = (folder.path() / "body.gltf").string();
  std::string output = (folder.path() / "out.glb").string();
  std::string places = (folder.path() / "places.json").string();
};

void write(
    const Files& files, const TubePerson& body, const Move& move = [](const Vec3& p) { return p; }) {
  std::vector<Vec3> moved(body.positions.size());
  std::ranges::transform(body.positions, moved.begin(), move);
  test::writeMeshFile(files.mesh, moved, body.triangles);
}

rig::Locators fitted(const Files& files, const std::string& plan = {}) {
  const Result<Document> document = openDocument(files.mesh);
  REQUIRE(document);
  Result<FittedLocators> locators = fitLocators(*document, plan);
  INFO((locators ? std::string() : locators.error().line()));
  REQUIRE(locators);
  return locators->locators;
}

double sizeOf(const TubePerson& body) {
  Vec3 low = body.positions.front();
  Vec3 high = low;
  for (const Vec3& position : body.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

// Every joint that the body was made with is within a twelfth of its size, all of them within a
// twenty-fifth in the mean.
void checkPlaces(const Body& body, const rig::Locators& locators, const Move& move, double unit) {
  double sum = 0.0;
  for (const auto& [name, place] : body.mesh.joints) {
    const rig::Locator* const locator = rig::findLocator(locators, name);
    INFO(body.plan << " " << name);
    REQUIRE(locator != nullptr);
    const double miss = glm::distance(locator->position, move(place)) / (unit * sizeOf(body.mesh));
    INFO(100.0 * miss << " % of the size off");
    CHECK(miss < 1.0 / 12.0);
    sum += miss;
  }
  CHECK(sum / static_cast<double>(body.mesh.joints.size()) < 1.0 / 25.0);
}

} // namespace

TEST_CASE("A mesh gets the locators of the body that its shape shows, where its joints are", "[locators]") {
  const Files files;
  for (const Body& body : bodies()) {
    INFO(body.plan);
    write(files, body.mesh);
    const rig::Locators locators = fitted(files);
    CHECK(locators.plan == body.plan);
    CHECK(rig::missingLocators(locators).empty());
    checkPlaces(
        body, locators, [](const Vec3& p) { return p; }, 1.0);
  }
}

TEST_CASE("Locators are fitted to the shape that morph weights give a mesh at rest", "[locators]") {
  const Files files;
  const Body person = bodies().front();
  write(files, person.mesh);
  Result<Document> document = openDocument(files.mesh);
  REQUIRE(document);
  const Result<FittedLocators> plain = fitLocators(*document);
  Scene scene = *document->scene;
  for (Primitive& primitive : scene.meshes.front().primitives) {
    primitive.morphTargets = {{primitive.positions, {}}};
    primitive.positions.assign(primitive.positions.size(), glm::vec3(0.0F));
  }
  scene.meshes.front().morphWeights = {1.0F};
  document->scene = std::make_shared<const Scene>(std::move(scene));
  const Result<FittedLocators> morphed = fitLocators(*document);
  REQUIRE(plain);
  REQUIRE(morphed);
  for (const rig::Locator& locator : plain->locators.list) {
    const rig::Locator* const found = rig::findLocator(morphed->locators, locator.name);
    INFO(locator.name);
    REQUIRE(found != nullptr);
    CHECK(glm::distance(found->position, locator.position) < 1e-6);
  }
}

TEST_CASE("A creature may face anywhere and be of any size: left stays its left", "[locators]") {
  const Files files;
  for (const Body& body : bodies()) {
    for (const double degrees : {180.0, 30.0}) {
      for (const double unit : {1e-3, 1e3}) {
        const Quat turn = axisAngle(Vec3(0.0, 1.0, 0.0), degrees * pi / 180.0);
        const auto move = [&](const Vec3& p) { return unit * (turn * p + Vec3(3.0, -1.0, 7.0)); };
        INFO(body.plan << " turned by " << degrees << " degrees, times " << unit);
        write(files, body.mesh, move);
        const rig::Locators locators = fitted(files);
        CHECK(locators.plan == body.plan);
        checkPlaces(body, locators, move, unit);
      }
    }
  }
}

TEST_CASE("A quadruped without a tail gets the locators that it needs", "[locators]") {
  const Files files;
  const Body body{"quadruped", test::tubeQuadruped(false), {}};
  write(files, body.mesh);
  const rig::Locators locators = fitted(files);
  CHECK(locators.plan == "quadruped");
  checkPlaces(
      body, locators, [](const Vec3& p) { return p; }, 1.0);
  CHECK(rig::findLocator(locators, "tail1") == nullptr);
}

TEST_CASE("A creature's locators lie along its bones: legs look forward, feet and trunk up", "[locators]") {
  const Files files;
  for (const auto& [body, leg, trunk] :
       {std::tuple{test::tubeQuadruped(), std::string("leftElbow"), std::string("spine")},
        std::tuple{test::tubeBird(), std::string("rightKnee"), std::string("spine")},
        std::tuple{test::tubeInsect(4), std::string("leftLeg2Foot"), std::string("thorax")}}) {
    write(files, body);
    const rig::Locators locators = fitted(files);
    const auto axisOf = [&](const std::string& name, const Vec3& axis) {
      const rig::Locator* const locator = rig::findLocator(locators, name);
      REQUIRE(locator != nullptr);
      return locator->orientation * axis;
    };
    INFO(locators.plan);
    CHECK(axisOf(trunk, {0.0, 1.0, 0.0}).z > 0.9);
    CHECK(axisOf(trunk, {0.0, 0.0, 1.0}).y > 0.9);
    CHECK(axisOf(leg, {0.0, 1.0, 0.0}).y < -0.4);
    CHECK((leg.ends_with("Foot") ? axisOf(leg, {0.0, 0.0, 1.0}).y : axisOf(leg, {0.0, 0.0, 1.0}).z) > 0.3);
  }
}

TEST_CASE("The limbs of its plan are found in what rig and bind build at a creature's locators",
          "[locators]") {
  const Files files;
  for (const Body& body : bodies()) {
    write(files, body.mesh);
    for (const char* const verb : {"rig", "bind"}) {
      INFO(verb << " a " << body.plan);
      const test::VerbAnswer answer = runVerb({verb, files.mesh, "-o", files.output, "--plan", body.plan});
      INFO(answer.told);
      REQUIRE(answer.exitCode == 0);
      const Result<Document> built = openDocument(files.output);
      REQUIRE(built);
      CHECK(built->body.plan == body.plan);
      for (const std::string& limb : body.limbs) {
        INFO(limb);
        REQUIRE(findLimb(*built, limb) != nullptr);
        const rig::Limb& found = *findLimb(*built, limb);
        CHECK(found.confidence >= 0.5);
        const std::string side = limb.find("left") != std::string::npos    ? "left"
                                 : limb.find("right") != std::string::npos ? "right"
                                                                           : "";
        CHECK(built->scene->nodes[at(found.joints.front())].name.starts_with(side));
      }
    }
  }
}

TEST_CASE("Locators of each plan are written, moved and given back, and stay with what was built",
          "[locators]") {
  const Files files;
  for (const Body& body : bodies()) {
    INFO(body.plan);
    write(files, body.mesh);
    REQUIRE(runVerb({"rig", files.mesh, "-o", files.places, "--locators-only"}).exitCode == 0);
    Result<rig::Locators> locators = loadLocators(files.places);
    REQUIRE(locators);
    CHECK(locators->plan == body.plan);
    CHECK(*locators == fitted(files));
    rig::Locator& moved = locators->list.back();
    moved.position += Vec3(0.02, 0.01, -0.03);
    REQUIRE(writeText(files.places, locatorsToJson(*locators).dump()));
    REQUIRE(runVerb({"rig", files.mesh, "-o", files.output, "--locators", files.places}).exitCode == 0);
    const Result<Document> built = openDocument(files.output);
    REQUIRE(built);
    CHECK(built->locators.plan == body.plan);
    CHECK(isRigBuilt(*built));
    CHECK_FALSE(areLocatorsMoved(*built));
    // A second set of the same joints is refused; the joints tell their locators.
    const test::VerbAnswer again =
        runVerb({"rig", files.output, "-o", files.mesh + ".glb", "--locators", files.places});
    CHECK(again.exitCode == (body.plan == "biped" ? 0 : 1));
    REQUIRE(runVerb({"rig", files.output, "-o", files.places, "--locators-only"}).exitCode == 0);
    const Result<rig::Locators> ofJoints = loadLocators(files.places);
    REQUIRE(ofJoints);
    CHECK(glm::distance(rig::findLocator(*ofJoints, moved.name)->position, moved.position) < 1e-4);
  }
}

TEST_CASE("A body that is no biped is not made one, and one that is not clear is refused in one line",
          "[locators]") {
  const Files files;
  for (const TubePerson& body : {test::tubeStooping(), test::tubeInsect(6)}) {
    write(files, body);
    for (const char* const verb : {"rig", "bind"}) {
      const test::VerbAnswer answer = runVerb({verb, files.mesh, "-o", files.output});
      INFO(answer.told);
      CHECK(answer.exitCode == 1);
      CHECK(std::ranges::count(answer.told, '\n') == 1);
      CHECK(answer.told.find("--plan with one of biped, quadruped, bird, insect, spider") !=
            std::string::npos);
      CHECK_FALSE(std::filesystem::exists(files.output));
    }
  }
}

TEST_CASE("The plan that is asked for is fitted, whatever the shape looks like, if its legs are there",
          "[locators]") {
  const Files files;
  write(files, test::tubeInsect(4));
  CHECK(fitted(files, "insect").plan == "insect"); // the three longest pairs
  CHECK(fitted(files, "quadruped").plan == "quadruped");
  write(files, test::tubeQuadruped());
  const test::VerbAnswer few = runVerb({"rig", files.mesh, "-o", files.output, "--plan", "spider"});
  CHECK(few.exitCode == 1);
  CHECK(few.told.find("2 of the 4 pairs of legs of a spider") != std::string::npos);
  CHECK(std::ranges::count(few.told, '\n') == 1);
  const test::VerbAnswer forced =
      runVerb({"rig", files.mesh, "-o", files.output, "--plan", "biped", "--json"});
  REQUIRE(forced.exitCode == 0);
  CHECK(gltf::Json::parse(forced.output)["warnings"].dump().find("no biped") != std::string::npos);
}

TEST_CASE("Every plan of locators is one of a body plan, and its joints hang together", "[locators]") {
  REQUIRE(rig::locatorPlans().size() == 5);
  for (const rig::LocatorPlan& plan : rig::locatorPlans()) {
    INFO(plan.id);
    const rig::BodyPlan* const body = rig::planNamed(plan.id);
    REQUIRE(body != nullptr);
    int legs = 0;
    for (std::size_t i = 0; i < plan.joints.size(); ++i) {
      const rig::LocatorJoint& joint = plan.joints[i];
      INFO(joint.name);
      const auto parent = std::ranges::find(plan.joints, joint.parent, &rig::LocatorJoint::name);
      CHECK((joint.parent.empty() ? i == 0 : parent - plan.joints.begin() < static_cast<std::ptrdiff_t>(i)));
      CHECK(rig::findJoint(plan, rig::mirroredLocator(joint.name)) != nullptr);
      legs += joint.limb.kind == rig::LimbKind::leg && joint.along == 0.0 ? 1 : 0;
    }
    CHECK((plan.id == "biped" || legs == body->legs));
  }
}
