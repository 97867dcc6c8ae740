#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/edits/trail/place_trails.h"
#include "app/edits/trail/trail_edits.h"
#include "app/recipe/recipe.h"
#include "app/recipe/replay.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
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
