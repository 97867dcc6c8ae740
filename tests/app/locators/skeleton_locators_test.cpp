// Locators of a character that has a skeleton, and files of locators that say too little.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/locators/fit_locators.h"
#include "app/schema/locator_json.h"
#include "core/gltf/json/json.h"
#include "rig/body/evidence/bind_pose.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

/// The boxer on legs of one bone each, taken for a biped; where its right hand is, is estimated.
Document stiffBoxer() {
  Document document = test::boxer();
  Scene scene = *document.scene;
  for (const auto& [place, side] : {std::pair(rig::biped::leftLeg, 1.0), {rig::biped::rightLeg, -1.0}}) {
    rig::Limb leg;
    static_cast<rig::LimbPlace&>(leg) = place;
    leg.id = rig::limbName(place);
    leg.joints = {test::addNode(scene, leg.id + " hip", document.body.hips, {0.1 * side, 0.0, 0.0})};
    leg.endNode = test::addNode(scene, leg.id + " foot", leg.joints.front(), {0.0, -0.8, 0.0});
    leg.restLength = 0.8;
    leg.confidence = 0.9;
    document.body.limbs.push_back(leg);
  }
  rig::Limb& arm = *std::ranges::find(document.body.limbs, "right-arm", &rig::Limb::id);
  arm.endNode = NodeIndex::none;
  arm.endOffset = {-0.25, 0.0, 0.0};
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.body.isBiped = true;
  return document;
}

rig::Locator locatorOf(const Document& document, const char* name) {
  const Result<FittedLocators> fitted = fitLocators(document);
  REQUIRE(fitted);
  CHECK(fitted->isOfSkeleton);
  const rig::Locator* const locator = rig::findLocator(fitted->locators, name);
  CAPTURE(name);
  REQUIRE(locator != nullptr);
  return *locator;
}

bool standsAt(const rig::Locator& locator, const Vec3& place, double confidence) {
  return glm::distance(locator.position, place) < 1e-9 && locator.confidence == confidence;
}

} // namespace

TEST_CASE("What a skeleton does not have of a biped is guessed between what it has, and told as unsure") {
  const Document document = stiffBoxer();
  const auto isAt = [&](const char* name, const Vec3& place, double confidence) {
    CAPTURE(name);
    CHECK(standsAt(locatorOf(document, name), place, confidence));
  };
  constexpr double guessed = 0.2;
  isAt("leftUpperLeg", {0.1, 1.0, 0.0}, 0.9);
  isAt("leftLowerLeg", {0.1, 0.6, 0.0}, guessed); // of one bone: half-way down
  isAt("leftFoot", {0.1, 0.2, 0.0}, 0.9);
  isAt("rightLowerArm", {-0.5, 1.5, 0.0}, 1.0);
  isAt("rightHand", {-0.75, 1.5, 0.0}, guessed);
  isAt("hips", {0.0, 1.0, 0.0}, 1.0);
  isAt("spine", {0.0, 1.2, 0.0}, 1.0);
  isAt("head", {0.0, 1.5 + 0.08 * 1.8, 0.0}, guessed);
  const rig::Locators fitted = fitLocators(document)->locators;
  CHECK(rig::findLocator(fitted, "neck") == nullptr);
  std::vector<std::string> unsure = unsureLocators(fitted);
  std::ranges::sort(unsure);
  CHECK(unsure == std::vector<std::string>{"head", "leftLowerLeg", "rightHand", "rightLowerLeg"});
}

TEST_CASE("Hips that are not known stand between the legs, and a spine a fifth of the way to the shoulders") {
  Document document = stiffBoxer();
  rig::Limb& spine = *std::ranges::find(document.body.limbs, "spine", &rig::Limb::id);
  spine.joints.insert(spine.joints.begin(), document.body.hips); // which are no joint of the spine for
                                                                 // locators
  CHECK(standsAt(locatorOf(document, "chest"), {0.0, 1.2, 0.0}, 1.0));
  CHECK(standsAt(locatorOf(document, "spine"), {0.0, 1.1, 0.0}, 0.2));
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id == "spine"; });
  document.body.hips = NodeIndex::none;
  CHECK(standsAt(locatorOf(document, "hips"), {0.0, 1.0, 0.0}, 0.2));
  CHECK(standsAt(locatorOf(document, "spine"), {0.0, 1.1, 0.0}, 0.2));
}

TEST_CASE("The trunk's locators of a skeleton stand at its own joints: hips, spine, neck and head") {
  const Document document = test::openedFile(test::posedCharacter);
  const Result<FittedLocators> fitted = fitLocators(document);
  REQUIRE(fitted);
  CHECK(fitted->isOfSkeleton);
  const std::vector<Mat4> bind = rig::bindPoseWorlds(*document.scene);
  const auto isAt = [&](const char* name, NodeIndex joint) {
    const rig::Locator* const locator = rig::findLocator(fitted->locators, name);
    REQUIRE(locator != nullptr);
    CAPTURE(name);
    CHECK(glm::length(locator->position - positionOf(bind[at(joint)])) < 1e-6);
  };
  isAt("hips", document.body.hips);
  isAt("neck", findLimb(document, "neck")->joints.front());
  isAt("head", document.body.head);
  isAt("leftUpperArm", findLimb(document, "left-arm")->joints.front());
  isAt("leftHand", findLimb(document, "left-arm")->endNode);
  isAt("rightLowerLeg", findLimb(document, "right-leg")->joints.back());
  isAt("rightFoot", findLimb(document, "right-leg")->endNode);
}

TEST_CASE("A file without a list of locators is refused, whatever else it is") {
  for (const Json& json : {Json::object(), Json{{"plan", "biped"}}, Json::array(), Json("locators"), Json(3),
                           Json{{"locators", 3}}, Json{{"locators", Json::object()}}}) {
    const Result<rig::Locators> read = locatorsFromJson(json);
    CAPTURE(json.dump());
    REQUIRE_FALSE(read);
    CHECK(read.error().what == "holds no locators");
  }
}
