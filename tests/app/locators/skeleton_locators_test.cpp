// Locators of a character that has a skeleton, and files of locators that say too little.
#include <string>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/locators/fit_locators.h"
#include "app/schema/locator_json.h"
#include "core/gltf/json/json.h"
#include "rig/body/evidence/bind_pose.h"
#include "tests/support/app/posed_file.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

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
