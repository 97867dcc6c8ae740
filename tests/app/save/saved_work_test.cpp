#include <optional>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/body/limb_edits.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/files/saved_work.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/locator_text.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

Document trailed() {
  NewTrail trail;
  trail.limb = "left-arm";
  trail.settings.endFrame = 10.0;
  trail.settings.scale = 2.0;
  trail.settings.spheres = {{5.0, Vec3(0.0, 0.1, 0.0)}};
  trail.exaggerated = true;
  trail.connected = true;
  const Result<CreatedTrail> first = createTrail(setLooping(test::boxer(), 0, true), trail);
  REQUIRE(first);
  trail.limb = "spine";
  trail.settings.scale = 1.2;
  trail.settings.stopAt = rig::StopPlane{Vec3(0.0, 2.0, 0.0), Vec3(0.0, 1.0, 0.0)};
  const Result<CreatedTrail> second = createTrail(first->document, trail);
  REQUIRE(second);
  Document document = *applyTrail(second->document, first->trailId);
  WeightedLimb weight;
  weight.limb = "right-arm";
  weight.settings.stiffness = 0.5;
  document.weights.push_back(weight);
  return document;
}

void collect(Json& json, std::vector<Json*>& values) {
  if (json.is_structured()) {
    for (const auto& [key, value] : json.items()) {
      values.push_back(&value);
      collect(value, values);
    }
  }
}

Json oddValue(std::mt19937& random) {
  const std::vector<Json> odd{nullptr,
                              true,
                              "odd",
                              0,
                              -1,
                              3,
                              1000000,
                              -2147483648LL,
                              1e300,
                              -1e300,
                              1e-300,
                              0.5,
                              Json::array(),
                              Json::object(),
                              Json::array({0, 0, 0}),
                              Json::array({1, 0})};
  return odd[random() % odd.size()];
}

void checkPlayable(const Document& document) {
  const rig::MotionState motion = prepareMotion(document, 0);
  for (const double seconds : {-1.0, 0.0, 0.1, 0.34, 0.5, 10.0}) {
    const FrameState frame = evaluate(document, motion, seconds);
    CHECK(frame.worlds.size() == document.scene->nodes.size());
  }
}

} // namespace

TEST_CASE("Clips are read at the rate again that was set for them") {
  Document document = trailed();
  Document source = withoutWork(document);
  const double own = clipOf(source, 0).framesPerSecond;
  setFramesPerSecond(document, 60.0);
  const Json work = workOf(document);
  REQUIRE(restoreWork(work, source));
  CHECK(clipOf(source, 0).framesPerSecond == 60.0);
  CHECK(source.trails == document.trails);
  Json broken = work;
  broken["rates"][0]["frames_per_second"] = 0.0;
  CHECK_THAT(test::refusal(restoreWork(broken, source)), Catch::Contains("rates"));
  setFramesPerSecond(document, own);
  CHECK_FALSE(workOf(document).contains("rates"));
}

TEST_CASE("Work comes back as it was saved") {
  const Document document = trailed();
  Document restored = test::boxer();
  REQUIRE(restoreWork(workOf(document), restored));
  CHECK(restored.trails == document.trails);
  CHECK(restored.loopingClips == document.loopingClips);
  CHECK(restored.weights == document.weights);
  CHECK(restored.nextTrailId == document.nextTrailId);
  CHECK(workOf(restored) == workOf(document));
}

TEST_CASE("Nothing about a trail is lost on the way into a file and back") {
  Document document = trailed();
  rig::Trail& trail = document.trails.back();
  trail.follow = false;
  trail.pinned = true;
  trail.visible = false;
  trail.colour = 3;
  trail.group = 2;
  trail.groupName = "one-two";
  trail.controlFrames = {0.0, 4.0, 10.0};
  trail.connected = false;
  trail.settings.space = rig::TrailSpace::view;
  trail.settings.viewAxes = Mat3(0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0);
  trail.settings.axes = {true, false, true};
  trail.settings.pivot = rig::Pivot::end;
  trail.settings.reference = rig::Reference::rest;
  trail.settings.bend = rig::Bend::straighten;
  trail.settings.remap = rig::RemapKind::linear;
  trail.settings.easeIn = {0.3, 0.2};
  trail.settings.easeOut = {0.2, 0.8};
  trail.settings.stretchSwitch = 0.5;
  trail.settings.volume = 0.25;
  trail.settings.releaseFrames = 3.5;
  trail.settings.overshoot = 0.1;
  trail.settings.pull = false;
  trail.settings.blend = 1.5;
  trail.settings.stayInWorld = true;
  trail.settings.turnEnd = true;
  Document restored = test::boxer();
  REQUIRE(restoreWork(workOf(document), restored));
  CHECK(restored.trails == document.trails);
}

TEST_CASE("Work takes the place of what is there, and nothing is left without it") {
  Document document = trailed();
  REQUIRE(restoreWork(workOf(trailed()), document));
  CHECK(document.trails == trailed().trails);
  CHECK(document.weights.size() == 1);
  CHECK(workOf(withoutWork(document)).is_null());
}

TEST_CASE("A limb corrected by hand is work, even without a trail") {
  const Document found = test::boxer();
  rig::Limb arm = *findLimb(found, "left-arm");
  arm.joints.erase(arm.joints.begin());
  const Result<Document> corrected = correctLimb(found, arm);
  REQUIRE(corrected);
  REQUIRE_FALSE(workOf(*corrected).is_null());
  Document restored = found;
  REQUIRE(restoreWork(workOf(*corrected), restored));
  CHECK(restored.limbsCorrected);
  CHECK(findLimb(restored, "left-arm")->joints == arm.joints);
}

TEST_CASE("A document without work saves none") {
  CHECK(workOf(test::boxer()).is_null());
}

TEST_CASE(
    "Limbs that cannot be, trails twice and clips that are not there are refused, and nothing changes") {
  Json work = workOf(trailed());
  SECTION("a joint twice") {
    work["limbs"][0]["joints"][1] = work["limbs"][0]["joints"][0];
  }
  SECTION("a joint that the file does not have") {
    work["limbs"][0]["joints"][0] = 99;
  }
  SECTION("no length") {
    work["limbs"][1]["rest_length"] = 0.0;
  }
  SECTION("a trail twice") {
    work["trails"][1]["id"] = work["trails"][0]["id"];
  }
  SECTION("the weight of a limb twice") {
    work["elastic"].push_back(work["elastic"][0]);
  }
  SECTION("a clip that is not there") {
    work["trails"][0]["clip"] = 7;
  }
  SECTION("another version") {
    work["version"] = 2;
  }
  Document document = test::boxer();
  const Status restored = restoreWork(work, document);
  REQUIRE_FALSE(restored);
  CHECK_FALSE(restored.error().line().empty());
  CHECK(document.body.limbs == test::boxer().body.limbs);
  CHECK(workOf(document).is_null());
}

TEST_CASE("A trail that no edit would make is left out of the work with a warning, the others stay") {
  Json work = workOf(trailed());
  std::size_t left = 1;
  SECTION("a range without length") {
    work["trails"][0]["range"] = {5, 5};
  }
  SECTION("a limb that the character does not have") {
    work["trails"][0]["limb"] = "third-arm";
  }
  SECTION("an overlap") {
    work["trails"][1]["limb"] = work["trails"][0]["limb"];
  }
  SECTION("a range after the end of the clip stays: the file may have been read at another rate") {
    work["trails"][0]["range"] = {400, 500};
    left = 2;
  }
  Document document = test::boxer();
  REQUIRE(restoreWork(work, document));
  CHECK(document.trails.size() == left);
  CHECK(document.warnings.size() == 2 - left);
}

TEST_CASE("A new trail gets a number above all of a file's, in whatever order they stand in it") {
  Json work = workOf(trailed());
  work["trails"][0]["id"] = 9;
  work["trails"][1]["id"] = 4;
  Document document = test::boxer();
  REQUIRE(restoreWork(work, document));
  NewTrail wanted;
  wanted.limb = "right-arm";
  wanted.settings.endFrame = 10.0;
  const Result<CreatedTrail> created = createTrail(document, wanted);
  REQUIRE(created);
  CHECK(created->trailId == 10);
}

TEST_CASE("A scale of an earlier version that is out of reach today is the largest there is") {
  Json work = workOf(trailed());
  work["trails"][0]["scale"] = 1000.0;
  Document document = test::boxer();
  REQUIRE(restoreWork(work, document));
  CHECK(document.trails[0].settings.scale == rig::largestStretch);
  CHECK(document.trails[1].settings.scale == Approx(1.2));
}

TEST_CASE("Holds that make no sense are refused, whichever of their kinds they are") {
  const std::string kind = GENERATE("pins", "grips", "props");
  Json work = workOf(trailed());
  work[kind] = {{{"clip", 0}, {"stretch", "far"}}};
  const Document before = test::boxer();
  Document document = before;
  CHECK(test::refusal(restoreWork(work, document)) != "accepted");
  CHECK(sameDocument(document, before));
}

TEST_CASE("Work of earlier versions says with which settings a trail was applied") {
  Json work = workOf(trailed());
  Json& trail = work["trails"][0];
  trail["connected"] = false;
  trail["applied"] = Json::object();
  for (const char* key : {"range", "scale", "spheres"}) {
    trail["applied"][key] = trail[key];
  }
  Document document = test::boxer();
  REQUIRE(restoreWork(work, document));
  CHECK(document.trails[0].applied);
  CHECK(document.trails[0].connected);
  trail["applied"]["scale"] = 4.0;
  REQUIRE(restoreWork(work, document));
  CHECK_FALSE(document.trails[0].applied);
  CHECK(document.trails[0].connected);
  trail["applied"] = nullptr;
  REQUIRE(restoreWork(work, document));
  CHECK_FALSE(document.trails[0].connected);
}

TEST_CASE("Whatever the work of a file holds, it is refused or it plays") {
  const Json work = workOf(trailed());
  std::mt19937 random(99);
  int taken = 0;
  for (int round = 0; round < 600; ++round) {
    Json broken = work;
    std::vector<Json*> values;
    collect(broken, values);
    *values[random() % values.size()] = oddValue(random);
    Document document = test::boxer();
    if (restoreWork(broken, document)) {
      ++taken;
      checkPlayable(document);
    }
  }
  CHECK(taken > 50);
}

TEST_CASE("Locators are part of the work: kept, restored, and none when they are gone", "[locators]") {
  Document document = test::boxer();
  CHECK(workOf(document).is_null());
  document.locators = *locatorsFromJson(test::locatorText());
  const Json work = workOf(document);
  Document restored = test::boxer();
  CHECK_FALSE(sameDocument(restored, document));
  REQUIRE(restoreWork(work, restored));
  CHECK(restored.locators == document.locators);
  CHECK(withoutWork(restored).locators.empty());
  Json damaged = work;
  damaged["locators"]["locators"].erase(0);
  CHECK_THAT(test::refusal(restoreWork(damaged, restored)), Catch::Contains("locators"));
}

TEST_CASE("A chain that a file keeps twice is read once, with a warning") {
  Document document = test::boxer();
  const Result<rig::Limb> chain = rig::chainLimb(*document.scene, "Hips", "Chest");
  REQUIRE(chain);
  document = *addChain(document, *chain);
  Json work = workOf(document);
  work["chains"].push_back(work["chains"][0]);
  Document restored = test::boxer();
  REQUIRE(restoreWork(work, restored));
  REQUIRE(restored.chains.size() == 1);
  CHECK(restored.chains.front().joints == chain->joints);
  REQUIRE(restored.warnings.size() == 1);
  CHECK(restored.warnings.front() ==
        "the limb Hips..Chest is kept twice in the file: the second is left out");
}

TEST_CASE("A limb is read by its kind, side and row, or by the number of a biped's, and refused where there "
          "is none") {
  const Json work = workOf(trailed());
  const auto placeOf = [&](const Json& kind) -> std::optional<rig::LimbPlace> {
    Json changed = work;
    changed["limbs"][0]["kind"] = kind;
    Document document = test::boxer();
    if (!restoreWork(changed, document)) {
      return std::nullopt;
    }
    return static_cast<const rig::LimbPlace&>(document.body.limbs.front());
  };
  const auto inBody = [](const char* kind, int side, int row) {
    return Json{{"kind", kind}, {"side", side}, {"row", row}};
  };
  CHECK(placeOf(inBody("leg", 1, 2)) == rig::LimbPlace{rig::LimbKind::leg, rig::LimbSide::right, 2});
  CHECK(placeOf(inBody("tail", 2, 0)) == rig::LimbPlace{rig::LimbKind::tail, rig::LimbSide::middle, 0});
  CHECK_FALSE(placeOf(inBody("tail", 3, 0)));
  CHECK_FALSE(placeOf(inBody("leg", -1, 1)));
  CHECK_FALSE(placeOf(inBody("leg", 0, -1)));
  CHECK_FALSE(placeOf(inBody("branch", 0, 1)));
  const std::vector<rig::LimbPlace> numbered{rig::biped::leftArm,  rig::biped::rightArm, rig::biped::leftLeg,
                                             rig::biped::rightLeg, rig::biped::spine,    rig::biped::neck,
                                             rig::LimbPlace{}};
  for (std::size_t number = 0; number < numbered.size(); ++number) {
    CAPTURE(number);
    CHECK(placeOf(number) == numbered[number]);
  }
  CHECK_FALSE(placeOf(7));
  CHECK_FALSE(placeOf(-1));
}

TEST_CASE("Limbs of a plan that this version does not know are read all the same") {
  Json work = workOf(trailed());
  work["plan"] = "centipede";
  Document document = test::boxer();
  const std::string plan = document.body.plan;
  REQUIRE(restoreWork(work, document));
  CHECK(document.body.plan == plan);
  CHECK(document.trails == trailed().trails);
}

TEST_CASE("A limb is refused by any part that the file's skeleton cannot have, and taken up to that") {
  const Json work = workOf(trailed());
  const auto isTaken = [&](const char* key, const Json& value) {
    Json changed = work;
    changed["limbs"][0][key] = value;
    Document document = test::boxer();
    return test::refusal(restoreWork(changed, document)) == "accepted";
  };
  const int nodes = static_cast<int>(test::boxer().scene->nodes.size());
  CHECK(isTaken("end", nodes - 1));
  CHECK(isTaken("end", -1)); // It ends in no joint.
  CHECK_FALSE(isTaken("end", nodes));
  CHECK(isTaken("joints", Json::array({nodes - 1})));
  CHECK_FALSE(isTaken("joints", Json::array({nodes})));
  CHECK_FALSE(isTaken("joints", Json::array({-1})));
  CHECK_FALSE(isTaken("joints", Json::array()));
  CHECK(isTaken("rest_length", 0.001));
  CHECK_FALSE(isTaken("rest_length", -0.1));
  CHECK_FALSE(isTaken("end_offset", Json::array({1.0, 2.0})));
}

TEST_CASE("A rate is refused of a clip that is not there or has one, and where nothing can play so fast") {
  const auto told = [](const Json& rates) {
    Json work = workOf(trailed());
    work["rates"] = rates;
    Document document = test::boxer();
    return test::refusal(restoreWork(work, document));
  };
  const auto rate = [](int clip, double framesPerSecond) {
    return Json{{"clip", clip}, {"frames_per_second", framesPerSecond}};
  };
  CHECK(told(Json::array({rate(0, 12.0)})) == "accepted");
  for (const Json& wrong :
       {Json::array({rate(1, 12.0)}), Json::array({rate(-1, 12.0)}), Json::array({rate(0, 1000001.0)}),
        Json::array({rate(0, -12.0)}), Json::array({rate(0, 12.0), rate(0, 24.0)})}) {
    CAPTURE(wrong.dump());
    CHECK_THAT(told(wrong), Catch::StartsWith("rates: "));
  }
}
