#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/gltf/source/json_text.h"
#include "tests/support/app/locator_text.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

Json& entryOf(Json& json, const std::string& name) {
  for (Json& entry : json["locators"]) {
    if (entry["name"] == name) {
      return entry;
    }
  }
  throw std::runtime_error("no locator " + name);
}

std::string problemOf(const Json& json) {
  const Result<rig::Locators> read = locatorsFromJson(json);
  return read ? std::string() : read.error().line();
}

bool tells(const Json& json, const std::string& first, const std::string& second) {
  const std::string line = problemOf(json);
  INFO(line);
  CHECK(line.find('\n') == std::string::npos);
  CHECK(line.find(first) != std::string::npos);
  CHECK(line.find(second) != std::string::npos);
  return !line.empty();
}

} // namespace

TEST_CASE("Locators read back what was written, whatever order they stand in", "[locators]") {
  Json text = test::locatorText();
  entryOf(text, "leftHand")["confidence"] = 0.25;
  const Result<rig::Locators> read = locatorsFromJson(text);
  REQUIRE(read);
  CHECK(rig::findLocator(*read, "leftHand")->confidence == 0.25);
  CHECK(rig::findLocator(*read, "rightHand")->position == Vec3(-0.7, 1.45, 0.0));
  Json written = locatorsToJson(*read);
  std::reverse(written["locators"].begin(), written["locators"].end());
  const Result<rig::Locators> again = locatorsFromJson(written);
  REQUIRE(again);
  REQUIRE(again->list.size() == 22);
  for (const rig::Locator& locator : again->list) {
    const rig::Locator* const first = rig::findLocator(*read, locator.name);
    CHECK(locator.position == first->position);
    CHECK(std::abs(glm::dot(locator.orientation, first->orientation)) == Approx(1.0));
  }
  CHECK(again->list.front().name == "hips");
}

TEST_CASE("What a set of locators lacks or has too much of is told in one line that names it", "[locators]") {
  const Json whole = test::locatorText();
  REQUIRE(problemOf(whole).empty());
  Json json = whole;
  entryOf(json, "leftHand")["name"] = "leftPaw";
  CHECK(tells(json, "leftPaw", "not a joint"));
  json = whole;
  json["locators"].push_back(entryOf(json, "leftHand"));
  CHECK(tells(json, "leftHand", "twice"));
  json = whole;
  json["locators"].erase(7); // leftUpperArm
  json["locators"].erase(0); // hips
  CHECK(tells(json, "hips", "leftUpperArm"));
  json = whole;
  entryOf(json, "spine")["position"] = {0.0, "high", 0.0};
  CHECK(tells(json, "spine.position", "three numbers"));
  json = whole;
  entryOf(json, "spine")["position"] = {0.0, 1e300, 0.0};
  CHECK(tells(json, "spine.position", "finite"));
  json = whole;
  entryOf(json, "head")["position"] = entryOf(json, "neck")["position"];
  CHECK(tells(json, "head", "neck"));
  json = whole;
  entryOf(json, "spine")["orientation"] = {0.0, 0.0, 0.0, 0.0};
  CHECK(tells(json, "spine.orientation", "no turn"));
  json = whole;
  entryOf(json, "spine")["confidence"] = 2.0;
  CHECK(tells(json, "spine.confidence", "0 to 1"));
  json = whole;
  entryOf(json, "spine")["pose"] = 1;
  CHECK(tells(json, "spine", "pose"));
  json = whole;
  json["plan"] = "centipede";
  CHECK(tells(json, "centipede", "biped"));
  json["plan"] = "quadruped";
  CHECK(tells(json, "not a joint of the plan quadruped", "leftHip"));
  CHECK(tells(Json::array(), "no locators", "plan"));
  CHECK(tells(Json{{"locators", 5}}, "no locators", "plan"));
}

TEST_CASE("Locators at the edge of what they may be are read, and turns of any length as turns",
          "[locators]") {
  Json json = test::locatorText();
  entryOf(json, "hips")["position"] = {0.0, 0.0, -1e9};
  entryOf(json, "leftHand")["confidence"] = 0;
  entryOf(json, "rightHand")["confidence"] = 1;
  entryOf(json, "head")["orientation"] = {0.0, 0.0, 3.0, 4.0};
  entryOf(json, "neck")["orientation"] = {0.0, 0.6, 0.0, 0.8};
  const Result<rig::Locators> read = locatorsFromJson(json);
  REQUIRE(read);
  CHECK(rig::findLocator(*read, "hips")->position.z == -1e9);
  CHECK(rig::findLocator(*read, "leftHand")->confidence == 0.0);
  const Quat turn = rig::findLocator(*read, "head")->orientation;
  CHECK(turn.z == Approx(0.6));
  CHECK(turn.w == Approx(0.8));
  CHECK(rig::findLocator(*read, "neck")->orientation.y == 0.6); // to the last digit
  CHECK(rig::findLocator(*read, "leftHand")->orientation == Quat(1.0, 0.0, 0.0, 0.0));
  for (const Json& wrong : {Json(-0.01), Json(1.01), Json("sure"), Json(nullptr)}) {
    json = test::locatorText();
    entryOf(json, "spine")["confidence"] = wrong;
    CHECK(tells(json, "spine.confidence: " + wrong.dump() + " is not a confidence", "0 to 1"));
  }
  json = test::locatorText();
  entryOf(json, "spine")["position"] = {1.1e9, 0.0, 0.0};
  CHECK(tells(json, "spine.position", "up to 1e9"));
  json = test::locatorText();
  entryOf(json, "spine")["orientation"] = {0.0, 0.0, 0.0, 1e-7};
  CHECK(tells(json, "spine.orientation", "no turn"));
  json = test::locatorText();
  json["locators"][3].erase("name");
  CHECK(tells(json, "locators[3]: names no joint", "leftUpperArm"));
  json = test::locatorText();
  json["locators"][3].erase("position");
  CHECK(tells(json, "upperChest.position", "three numbers"));
  json = test::locatorText();
  json["pose"] = "rest";
  CHECK(tells(json, "pose: is not a part of a file of locators", "give plan and locators"));
}

TEST_CASE("A file of locators that is none is told with its name", "[locators]") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "places.json";
  for (const std::string text : {"{\"plan\": \"biped\", \"locators\": [", "{\"locators\": [{}]}",
                                 R"({"locators": [{"name": "hips", "position": [1e999, 0, 0]}]})"}) {
    REQUIRE(writeText(path, text));
    const Result<rig::Locators> read = loadLocators(path);
    REQUIRE_FALSE(read);
    CHECK(read.error().line().find("places.json") != std::string::npos);
  }
  CHECK_FALSE(loadLocators(folder.path() / "missing.json"));
}
