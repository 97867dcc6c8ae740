#include <map>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

Json punchRecipe() {
  return {{"version", 1},
          {"trails", {{{"limb", "left-arm"}, {"range", {0, 10}}, {"scale", 2.5}, {"axes", "xz"}}}}};
}

Result<Recipe> read(const Json& json) {
  Document document = test::boxer();
  return recipeFromJson(json, document);
}

} // namespace

TEST_CASE("A recipe sets what it names and leaves the rest at its defaults") {
  const Result<Recipe> recipe = read(punchRecipe());
  REQUIRE(recipe);
  REQUIRE(recipe->trails.size() == 1);
  rig::TrailSettings expected;
  expected.endFrame = 10.0;
  expected.scale = 2.5;
  expected.axes = {true, false, true};
  CHECK(recipe->trails[0].settings == expected);
  CHECK(recipe->trails[0].limb == "left-arm");
}

TEST_CASE("An offset fits another limb: it is in lengths of the limb unless metres are asked for") {
  Json json = punchRecipe();
  json["trails"][0]["spheres"] = {{{"frame", 5}, {"offset", {0, 0.5, 0}}}};
  CHECK(read(json)->trails[0].settings.spheres[0].offset.y == Approx(0.5 * 0.6));
  json["units"] = "metres";
  CHECK(read(json)->trails[0].settings.spheres[0].offset.y == Approx(0.5));
}

TEST_CASE("A range may be a part of the clip, or left out for the default range") {
  Json json = punchRecipe();
  json["trails"][0].erase("range");
  json["trails"][0]["range_of_clip"] = {0.25, 0.5};
  CHECK(read(json)->trails[0].settings.startFrame == Approx(5.0));
  CHECK(read(json)->trails[0].settings.endFrame == Approx(10.0));
  json["trails"][0].erase("range_of_clip");
  CHECK(read(json)->trails[0].settings.startFrame == 0.0);
  CHECK(read(json)->trails[0].settings.endFrame == Approx(10.0));
}

TEST_CASE("A chain that a recipe names joins the document") {
  Json json = punchRecipe();
  json["trails"][0]["limb"] = "Spine..LeftHand";
  Document document = test::boxer();
  REQUIRE(recipeFromJson(json, document));
  REQUIRE(document.chains.size() == 1);
  CHECK(document.chains[0].id == "Spine..LeftHand");
}

TEST_CASE("What a recipe cannot say is refused in a line that names it") {
  Json json = punchRecipe();
  std::string place;
  SECTION("an unknown key") {
    json["trials"] = Json::array();
    place = "trials";
  }
  SECTION("an unknown setting") {
    json["trails"][0]["scael"] = 2;
    place = "trails[0].scael";
  }
  SECTION("a value out of range") {
    json["trails"][0]["blend"] = 3;
    place = "trails[0].blend";
  }
  SECTION("a range that runs backwards") {
    json["trails"][0]["range"] = {10, 0};
    place = "trails[0].range";
  }
  SECTION("a part of the clip beyond its end") {
    json["trails"][0]["range_of_clip"] = {0.5, 1.5};
    place = "trails[0].range_of_clip";
  }
  SECTION("another version") {
    json["version"] = 9;
    place = "version";
  }
  SECTION("no limb") {
    json["trails"][0].erase("limb");
    place = "trails[0]";
  }
  SECTION("an unknown unit") {
    json["units"] = "feet";
    place = "units";
  }
  const Result<Recipe> recipe = read(json);
  REQUIRE_FALSE(recipe);
  CHECK(recipe.error().where == place);
  CHECK(recipe.error().line().find('\n') == std::string::npos);
}

TEST_CASE("A recipe written from a document makes the same trails in it again") {
  Document document = test::boxer();
  Json json = punchRecipe();
  json["trails"][0]["spheres"] = {{{"frame", 5}, {"offset", {0, 0.5, 0}}}};
  const Result<Recipe> recipe = recipeFromJson(json, document);
  REQUIRE(recipe);
  const Result<PlacedTrails> edited = withRecipe(document, *recipe);
  REQUIRE(edited);
  Document fresh = test::boxer();
  const Result<Recipe> again = recipeFromJson(recipeToJson(edited->document, 0), fresh);
  REQUIRE(again);
  REQUIRE(again->trails.size() == 1);
  CHECK(again->trails[0].settings == edited->document.trails[0].settings);
}

TEST_CASE("A file that is no recipe is told by its name") {
  const test::TemporaryFolder folder;
  Document document = test::boxer();
  const auto notJson = folder.write("notes.json", "scale: 3");
  CHECK(loadRecipe(notJson, document).error().where == notJson.string());
  CHECK(loadRecipe(folder / "missing.json", document).error().what == "there is no such file");
}

TEST_CASE("A character without a clip is not told as a fault of the recipe") {
  const test::TemporaryFolder folder;
  Document still = test::boxer();
  gltf::Source source = still.source ? *still.source : gltf::Source();
  source.path = "boxer.glb";
  still.source = std::make_shared<const gltf::Source>(std::move(source));
  still.clips = std::make_shared<const std::vector<Clip>>();
  const Result<Recipe> recipe = loadRecipe(folder.write("punch.json", punchRecipe().dump()), still);
  REQUIRE_FALSE(recipe);
  CHECK(recipe.error().line() ==
        "boxer.glb: animations: the file holds no clip; give a file with an animation");
}

TEST_CASE("A recipe that says one thing twice is refused in a line with its place") {
  const test::TemporaryFolder folder;
  Document document = test::boxer();
  const auto refused = [&](const std::string& text) {
    const Result<Recipe> recipe = loadRecipe(folder.write("twice.json", text), document);
    REQUIRE_FALSE(recipe);
    CHECK(recipe.error().line().find('\n') == std::string::npos);
    return recipe.error().where.substr((folder / "twice.json").string().size());
  };
  CHECK(refused(R"({"version": 1, "trails": [{"limb": "spine", "range": [0, 4]},
      {"limb": "left-arm", "range": [0, 10], "scale": 2, "scale": 3}]})") == ": trails[1].scale");
  CHECK(refused(R"({"version": 1, "trails": [], "trails": []})") == ": trails");
  CHECK(refused(R"({"version": 1, "trails": [], "props": [{"node": "Club", "hands": {
      "right-arm": [{"frame": 0, "value": 1}], "right-arm": [{"frame": 3, "value": 0}]}}]})") ==
        ": props[0].hands.right-arm");
  CHECK(refused(R"({"version": 1, "trails": [], "elastic": [{"limb": "left-arm"}, {"limb": "left-arm"}]})") ==
        ": elastic[1].limb");
}

TEST_CASE("A pin or a grip to a frame that the clip does not have is refused") {
  for (const char* const list : {"pins", "grips"}) {
    Json entry{{"range", {2, 1000000}}};
    entry[std::string(list) == "pins" ? "limb" : "follower"] = "left-arm";
    if (std::string(list) == "grips") {
      entry["leader"] = "right-arm";
    }
    Json json{{"version", 1}, {list, Json::array({entry})}};
    Document document = test::boxer();
    const Result<PlacedTrails> placed = withRecipe(document, *recipeFromJson(json, document));
    REQUIRE_FALSE(placed);
    CHECK(placed.error().where == "left-arm");
    CHECK_THAT(placed.error().what, Catch::Contains("2 to 1000000") || Catch::Contains("1e+06"));
    json[list][0]["range"] = {2, 20};
    CHECK(withRecipe(document, *recipeFromJson(json, document)));
  }
}
TEST_CASE("Every frame of a recipe that counts at half the clip's rate is twice as late in the clip") {
  const Json json = Json::parse(R"({
    "version": 1, "frames_per_second": 15,
    "trails": [{"limb": "left-arm", "range": [1, 5], "scale": 2, "release": 2,
                "spheres": [{"frame": 3, "offset": [0, 0.1, 0]}]}],
    "elastic": [{"limb": "right-arm", "range": [2, 6]}],
    "adjustments": [{"controller": "hips", "range": [1, 8], "keys": [{"frame": 4, "move": [0, -0.1, 0]}]}],
    "pins": [{"limb": "left-arm", "range": [1, 4], "blend": [1, 2], "at": 3}],
    "grips": [{"leader": "left-arm", "follower": "right-arm", "range": [5, 7], "blend": [1, 2], "relation": 6}],
    "props": [{"node": "Chest", "range": [2, 7], "blend": [1, 0], "bound_at": 3,
               "hands": {"right-arm": [{"frame": 4, "value": 1}]}}]})");
  const Result<Recipe> recipe = read(json);
  INFO((recipe ? std::string() : recipe.error().line()));
  REQUIRE(recipe);
  const rig::TrailSettings& trail = recipe->trails[0].settings;
  CHECK(Vec2(trail.startFrame, trail.endFrame) == Vec2(2, 10));
  CHECK(trail.releaseFrames == 4.0);
  CHECK(trail.spheres[0].frame == 6.0);
  CHECK(recipe->weights[0].settings.rangeFrames == Vec2(4, 12));
  CHECK(recipe->adjustments[0].rangeFrames == Vec2(2, 16));
  CHECK(recipe->adjustments[0].keys[0].frame == 8.0);
  const rig::Pin& pin = recipe->holds.pins[0];
  CHECK(pin.time == rig::HoldTime{Vec2(2, 8), Vec2(2, 4)});
  CHECK(pin.atFrame == 6.0);
  const rig::Grip& grip = recipe->holds.grips[0];
  CHECK(grip.time == rig::HoldTime{Vec2(10, 14), Vec2(2, 4)});
  CHECK(grip.relationFrame == 12.0);
  const rig::Prop& prop = recipe->holds.props[0];
  CHECK(prop.time == rig::HoldTime{Vec2(4, 14), Vec2(2, 0)});
  CHECK(prop.boundFrame == 6.0);
  CHECK(prop.hands[0].keys[0].frame == 8.0);
}

TEST_CASE("Groups of a recipe stay apart from the groups that are there") {
  Json json = punchRecipe();
  json["trails"][0]["group"] = 1;
  json["trails"].push_back({{"limb", "spine"}, {"range", {0, 10}}, {"scale", 1.5}, {"group", 1}});
  json["trails"].push_back({{"limb", "right-arm"}, {"range", {0, 10}}, {"scale", 1.5}});
  Json later = json;
  for (Json& trail : later["trails"]) {
    trail["range"] = {12, 18};
  }
  Result<PlacedTrails> once = withRecipe(test::boxer(), *read(json));
  REQUIRE(once);
  const Result<Recipe> again = recipeFromJson(later, once->document);
  REQUIRE(again);
  const Result<PlacedTrails> twice = withRecipe(once->document, *again);
  REQUIRE(twice);
  const std::vector<rig::Trail>& trails = twice->document.trails;
  REQUIRE(trails.size() == 6);
  std::map<std::pair<int, bool>, int> members; // by group, and whether it is of the later recipe
  for (const rig::Trail& trail : trails) {
    ++members[{trail.group, trail.settings.startFrame > 10.0}];
  }
  REQUIRE(members.size() == 4);
  CHECK(members[{0, false}] == 1);
  CHECK(members[{0, true}] == 1);
  for (const auto& [group, count] : members) {
    if (group.first > 0) {
      CHECK(count == 2);
      CHECK_FALSE(members.contains({group.first, !group.second}));
    }
  }
}

TEST_CASE("Weight that is off is no part of a recipe, nor is weight of another clip") {
  Document document = test::boxer();
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clips.front());
  clips.back().name = "again";
  document.clips = std::make_shared<const std::vector<Clip>>(clips);
  for (const WeightedLimb& weight :
       {WeightedLimb{"right-arm", 0, false, {}}, WeightedLimb{"left-arm", 0, true, {}},
        WeightedLimb{"spine", 1, true, {}}}) {
    Result<Document> changed = setWeight(document, weight);
    REQUIRE(changed);
    document = *changed;
  }
  const Json json = recipeToJson(document, 0);
  REQUIRE(json["elastic"].size() == 1);
  CHECK(json["elastic"][0]["limb"] == "left-arm");
}

TEST_CASE("Fractions of the clip win over frames that stand beside them, before or behind, and are "
          "refused out of order") {
  const auto rangeOf = [](const char* trail) {
    const Result<Recipe> recipe = read(Json::parse(
        R"({"version": 1, "trails": [{"limb": "left-arm", "scale": 2, )" + std::string(trail) + "}]}"));
    REQUIRE(recipe);
    return Vec2(recipe->trails[0].settings.startFrame, recipe->trails[0].settings.endFrame);
  };
  CHECK(rangeOf(R"("range": [1, 3], "range_of_clip": [0.25, 0.5])") == Vec2(5, 10));
  CHECK(rangeOf(R"("range_of_clip": [0.25, 0.5], "range": [1, 3])") == Vec2(5, 10));
  for (const Json& wrong :
       {Json{0.5, 0.25}, Json{0.5, 0.5}, Json{0.5, 1.5}, Json{-0.5, 0.5}, Json{0.5}, Json{0.1, 0.2, 0.3}}) {
    INFO(wrong.dump());
    Json json = punchRecipe();
    json["trails"][0]["range_of_clip"] = wrong;
    const Result<Recipe> refused = read(json);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().line(), Catch::Contains("is not a part of a clip"));
  }
}

TEST_CASE(
    "A prop is brought by lengths of the leg, by metres where they are asked for, and turned by degrees") {
  Document document = test::openedFile(test::posedCharacter);
  const double leg = findLimb(document, "left-leg")->restLength;
  REQUIRE(leg < 0.9);
  Json json =
      Json::parse(R"({"version": 1, "props": [{"node": "Hips", "move": [0, 0.5, 0], "turn": [0, 90, 0],
                              "hands": {"right-arm": [{"frame": 0, "value": 1}]}}]})");
  const auto propOf = [&] {
    const Result<Recipe> recipe = recipeFromJson(json, document);
    INFO((recipe ? std::string() : recipe.error().line()));
    REQUIRE(recipe);
    return recipe->holds.props.front();
  };
  CHECK(propOf().move.y == Approx(0.5 * leg));
  CHECK(propOf().turn.y == Approx(0.5 * pi));
  json["units"] = "metres";
  CHECK(propOf().move.y == Approx(0.5));
}

TEST_CASE(
    "Slopes of free keys come back from a saved file as the recipe has them: by length and degrees a frame") {
  const test::TemporaryFolder folder;
  const Json recipe =
      Json::parse(R"({"version": 1, "units": "metres", "adjustments": [{"controller": "hips", "keys": [
      {"frame": 12, "move": [0, -0.1, 0], "turn": [0, 15, 0], "interpolation": "free",
       "move_slope": [0, 0.01, 0], "turn_slope": [0, 3, 0]}]}]})");
  const test::Posed posed = test::pose(folder, recipe);
  INFO(posed.answer.told);
  REQUIRE(posed.answer.exitCode == 0);
  const Document document = test::openedFile(posed.path);
  const rig::OffsetKey& key = document.adjustments.at(0).keys.at(0);
  CHECK(key.moveSlope.y == Approx(0.01));
  CHECK(key.turn.y == Approx(15.0 * pi / 180.0));
  CHECK(key.turnSlope.y == Approx(3.0 * pi / 180.0));
  const Json written = recipeToJson(document, 0)["adjustments"][0]["keys"][0];
  CHECK(written["turn_slope"][1].get<double>() == Approx(3.0));
  CHECK(written["turn"][1].get<double>() == Approx(15.0));
}

TEST_CASE(
    "A recipe of the editor keeps where control spheres stand and whether the clip loops, and leaves out "
    "what is kept aside") {
  Document document = test::boxer();
  const Result<Recipe> punch = read(punchRecipe());
  REQUIRE(punch);
  Result<PlacedTrails> placed = withRecipe(document, *punch);
  REQUIRE(placed);
  document = setLooping(placed->document, 0, true);
  findTrail(document, placed->trailIds[0])->controlFrames = {2.0, 4.5, 8.0};
  rig::Trail aside = *findTrail(document, placed->trailIds[0]);
  aside.id = 0;
  aside.limb = "right-arm";
  aside.connected = false;
  const Result<PlacedTrails> both = placeTrails(document, {&aside, 1}, Entry::request);
  REQUIRE(both);

  const Json json = recipeToJson(both->document, 0);
  CHECK(json["trails"].size() == 1);
  CHECK(json["loops"] == true);
  const Result<Recipe> again = read(json);
  REQUIRE(again);
  REQUIRE(again->trails.size() == 1);
  CHECK(again->trails[0].controlFrames == std::vector<double>{2.0, 4.5, 8.0});
  const Result<PlacedTrails> replayed = withRecipe(test::boxer(), *again);
  REQUIRE(replayed);
  CHECK(isLooping(replayed->document, 0));
  CHECK(findTrail(replayed->document, replayed->trailIds[0])->controlFrames ==
        std::vector<double>{2.0, 4.5, 8.0});
  CHECK_FALSE(recipeToJson(withRecipe(test::boxer(), *punch)->document, 0).contains("loops"));
}

TEST_CASE("Frames of control spheres and the loop of a recipe are refused where they are something else") {
  Json json = punchRecipe();
  json["trails"][0]["control_frames"] = {1, "two"};
  REQUIRE_FALSE(read(json));
  CHECK_THAT(read(json).error().line(),
             Catch::Contains("control_frames") && Catch::Contains("list of frames"));
  json["trails"][0]["control_frames"] = 3;
  CHECK_FALSE(read(json));
  json["trails"][0].erase("control_frames");
  json["loops"] = 1;
  REQUIRE_FALSE(read(json));
  CHECK_THAT(read(json).error().line(), Catch::Contains("loops"));
}

TEST_CASE(
    "Colours and groups of trails are whole numbers, from none on, and others are refused by their place") {
  const auto refusalWith = [](const char* key, const Json& value) {
    Json json = punchRecipe();
    json["trails"][0][key] = value;
    const Result<Recipe> recipe = read(json);
    return recipe ? std::string() : recipe.error().where + ": " + recipe.error().what;
  };
  CHECK(refusalWith("colour", 0).empty());
  CHECK(refusalWith("colour", 7).empty());
  CHECK(refusalWith("group", 0).empty());
  CHECK(refusalWith("group", 1000000).empty());
  for (const Json& wrong : {Json(-1), Json(1.5), Json("red"), Json(nullptr)}) {
    CHECK(refusalWith("colour", wrong) == "trails[0].colour: " + wrong.dump() + " is not a colour");
    CHECK(refusalWith("group", wrong) == "trails[0].group: " + wrong.dump() + " is not a group");
  }
  CHECK(refusalWith("group", 1000001) == "trails[0].group: 1000001 is not a group");
  Json json = punchRecipe();
  json["trails"][0]["colour"] = 7;
  CHECK(read(json)->trails[0].colour == 7);
}

TEST_CASE("A recipe without trails brings at least one other thing, and each of its keys is of its kind") {
  const auto refusalOf = [](const Json& json) {
    const Result<Recipe> recipe = read(json);
    return recipe ? std::string() : recipe.error().where + ": " + recipe.error().what;
  };
  const std::string noTrails = "trails: there is no list of trails";
  CHECK(refusalOf({{"version", 1}}) == noTrails);
  CHECK(refusalOf({{"version", 1}, {"loops", true}}) == noTrails);
  CHECK(refusalOf({{"version", 1}, {"trails", 3}}) == noTrails);
  CHECK(refusalOf({{"version", 1}, {"trails", 3}, {"pins", Json::array()}}) == noTrails);
  for (const char* const list : {"elastic", "adjustments", "pins", "grips", "props"}) {
    CAPTURE(list);
    CHECK(refusalOf({{"version", 1}, {list, Json::array()}}).empty());
    CHECK(refusalOf({{"version", 1}, {list, 3}}) == std::string(list) + ": is not a list");
  }
  CHECK(refusalOf({{"version", 1}, {"references", Json::object()}}).empty());
  for (const Json& rate : {Json(0), Json(-24), Json("fast")}) {
    Json json = punchRecipe();
    json["frames_per_second"] = rate;
    CHECK(refusalOf(json) == "frames_per_second: is not a rate");
  }
  Json json = punchRecipe();
  json["clip"] = 0;
  CHECK(refusalOf(json) == "clip: 0 is not the name of a clip");
  json["clip"] = "#0";
  CHECK(refusalOf(json).empty());
}
