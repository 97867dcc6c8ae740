#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/document.h"
#include "app/files/save.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

// Every way for a trail into a document, from the command line's end.

constexpr const char* character = STRETCH_SOURCE_DIR "/assets/dummy.glb";

Json recipeWith(const Json& trails) {
  Json recipe;
  recipe["version"] = 1;
  recipe["trails"] = trails;
  return recipe;
}

Json punch(double first, double last, double scale = 2.0) {
  return {{"limb", "left-arm"}, {"range", Json::array({first, last})}, {"scale", scale}};
}

std::vector<rig::Trail> trailsOf(const std::string& file) {
  const Result<Document> document = openDocument(file);
  REQUIRE(document.ok());
  return document->trails;
}

} // namespace

TEST_CASE("A range without length is refused wherever it comes from, and nothing is written") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const test::VerbAnswer words = test::runVerb(
      {"exaggerate", character, "-o", output, "--limb", "left-arm", "--scale", "2", "--range", "21:21"});
  CHECK(words.exitCode == 2);
  CHECK_THAT(words.told, Catch::Contains("--range") && Catch::Contains("no length"));
  const std::string recipe =
      folder.write("empty.json", recipeWith(Json::array({punch(21, 21)})).dump()).string();
  const test::VerbAnswer file = test::runVerb({"exaggerate", character, "-o", output, "--recipe", recipe});
  CHECK(file.exitCode == 1);
  CHECK_THAT(file.told, Catch::Contains("no length"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE(
    "The path of a limb in a clip of one key is a point that can be asked for, and nothing to exaggerate") {
  const test::TemporaryFolder folder;
  const std::string still = folder
                                .write("still.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": [0]}],
      "nodes": [{"name": "upper", "children": [1]}, {"name": "lower", "translation": [0, 1, 0], "children": [2]},
                {"name": "hand", "translation": [0, 1, 0]}],
      "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                      "samplers": [{"input": 0, "output": 1}]}],
      "buffers": [{"byteLength": 16, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAA=="}],
      "bufferViews": [{"buffer": 0, "byteLength": 4}, {"buffer": 0, "byteOffset": 4, "byteLength": 12}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 1, "type": "SCALAR", "min": [0], "max": [0]},
                    {"bufferView": 1, "componentType": 5126, "count": 1, "type": "VEC3"}]})")
                                .string();
  const test::VerbAnswer asked = test::runVerb({"trail", still, "--limb", "upper..hand"});
  INFO(asked.told);
  CHECK(asked.exitCode == 0);
  const std::string output = (folder / "out.glb").string();
  const test::VerbAnswer wanted =
      test::runVerb({"exaggerate", still, "-o", output, "--limb", "upper..hand", "--scale", "2"});
  CHECK(wanted.exitCode == 1);
  CHECK_THAT(wanted.told, Catch::Contains("no length"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("A limb that is not there is told before what else its trail lacks") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const test::VerbAnswer misspelt =
      test::runVerb({"exaggerate", character, "-o", output, "--limb", "leftarm"});
  CHECK(misspelt.exitCode != 0);
  CHECK_THAT(misspelt.told, Catch::Contains("no limb 'leftarm'") && Catch::Contains("left-arm"));
  const test::VerbAnswer unscaled =
      test::runVerb({"exaggerate", character, "-o", output, "--limb", "left-arm"});
  CHECK(unscaled.exitCode != 0);
  CHECK_THAT(unscaled.told, Catch::Contains("no scale"));
}

TEST_CASE("A range outside the clip is refused wherever it comes from") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const std::string recipe =
      folder.write("late.json", recipeWith(Json::array({punch(900, 990)})).dump()).string();
  CHECK(test::runVerb({"exaggerate", character, "-o", output, "--limb", "left-arm", "--scale", "2", "--range",
                       "900:990"})
            .exitCode == 1);
  CHECK(test::runVerb({"exaggerate", character, "-o", output, "--recipe", recipe}).exitCode == 1);
}

TEST_CASE("Two trails of one request may not overlap, one that the file carries is replaced") {
  const test::TemporaryFolder folder;
  const std::string first = (folder / "first.glb").string();
  const std::string second = (folder / "second.glb").string();
  const std::string twice =
      folder.write("twice.json", recipeWith(Json::array({punch(10, 20), punch(15, 25)})).dump()).string();
  const std::string later =
      folder.write("later.json", recipeWith(Json::array({punch(24, 30, 3.0)})).dump()).string();
  CHECK(test::runVerb({"exaggerate", character, "-o", first, "--recipe", twice}).exitCode == 1);
  CHECK(test::runVerb({"exaggerate", character, "-o", first, "--limb", "left-arm", "--scale", "2", "--range",
                       "10:20", "--limb", "left-arm", "--range", "15:25", "--scale", "2"})
            .exitCode == 1);
  REQUIRE(test::runVerb({"exaggerate", character, "-o", first, "--limb", "left-arm", "--scale", "2",
                         "--range", "21:27", "--limb", "spine", "--scale", "1.2", "--range", "21:27"})
              .exitCode == 0);
  REQUIRE(test::runVerb({"exaggerate", first, "-o", second, "--recipe", later}).exitCode == 0);
  const std::vector<rig::Trail> trails = trailsOf(second);
  REQUIRE(trails.size() == 2);
  CHECK(trails[0].limb == "spine");
  CHECK(trails[1].settings.scale == 3.0);
  CHECK(trails[1].connected);
}

TEST_CASE("A recipe is played on the clip that --clip names, whatever it names itself") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  Json recipe = recipeWith(Json::array({punch(2, 8)}));
  recipe["clip"] = "of another character";
  const std::string path = folder.write("other.json", recipe.dump()).string();
  CHECK(test::runVerb({"exaggerate", character, "-o", output, "--recipe", path}).exitCode == 1);
  REQUIRE(
      test::runVerb({"exaggerate", character, "-o", output, "--recipe", path, "--clip", "Guard"}).exitCode ==
      0);
  REQUIRE(trailsOf(output).size() == 1);
  CHECK(trailsOf(output).front().clip == 1);
  CHECK_THAT(
      test::runVerb({"exaggerate", character, "-o", output, "--recipe", path, "--clip", "no such clip"}).told,
      Catch::Contains("--clip"));
}

TEST_CASE("A recipe's mistakes are told in its own words, with their place in the file") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const auto told = [&](const Json& recipe) {
    const std::string path = folder.write("wrong.json", recipe.dump()).string();
    const test::VerbAnswer outcome = test::runVerb({"exaggerate", character, "-o", output, "--recipe", path});
    CHECK(outcome.exitCode == 1);
    CHECK_THAT(outcome.told, Catch::Contains("wrong.json"));
    CHECK_THAT(outcome.told,
               !Catch::Contains("--limb") && !Catch::Contains("--clip") && !Catch::Contains("--range"));
    return outcome.told;
  };
  Json limb = punch(21, 27);
  limb["limb"] = "third-arm";
  CHECK_THAT(told(recipeWith(Json::array({punch(10, 20), limb}))), Catch::Contains("trails[1].limb"));
  Json weight = recipeWith(Json::array());
  weight["elastic"] = Json::array({Json{{"limb", "third-arm"}}});
  CHECK_THAT(told(weight), Catch::Contains("elastic[0].limb"));
  Json clip = recipeWith(Json::array());
  clip["clip"] = "Swim";
  CHECK_THAT(told(clip), Catch::Contains("clip: there is no clip 'Swim'"));
  CHECK_THAT(told(recipeWith(Json::array({punch(27, 21)}))), Catch::Contains("trails[0].range"));
}

TEST_CASE("trail tells where the limb's end and its base are, at the frames that it tells") {
  const test::VerbAnswer answer =
      test::runVerb({"trail", character, "--limb", "left-arm", "--range", "10:20", "--json"});
  REQUIRE(answer.exitCode == 0);
  const Json report = Json::parse(answer.output);
  const Document document = test::openedFile(character);
  const rig::Limb& arm = *findLimb(document, "left-arm");
  const Json& frames = report["frames"];
  REQUIRE(frames.size() >= 11);
  REQUIRE(report["points"].size() == frames.size());
  REQUIRE(report["base"].size() == frames.size());
  CHECK(frames.front().get<double>() == Approx(10.0));
  CHECK(frames.back().get<double>() == Approx(20.0));
  const auto placeOf = [](const Json& place) {
    return Vec3(place[0].get<double>(), place[1].get<double>(), place[2].get<double>());
  };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double frame = frames[i].get<double>();
    CHECK(glm::length(placeOf(report["points"][i]) - test::endOf(document, "left-arm", frame)) < 1e-6);
    CHECK(glm::length(placeOf(report["base"][i]) - test::nodeOf(document, arm.joints.front(), frame)) < 1e-6);
  }
  for (const Json& frame : report["control_frames"]) {
    CHECK(frame.get<double>() >= 10.0);
    CHECK(frame.get<double>() <= 20.0);
  }
}

TEST_CASE("The space of a view is refused where no view can be given, and taken from a recipe that has one") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const test::VerbAnswer words = test::runVerb({"exaggerate", character, "-o", output, "--limb", "left-arm",
                                                "--scale", "2", "--range", "21:27", "--space", "view"});
  CHECK(words.exitCode == 1);
  CHECK_THAT(words.told, Catch::Contains("--space view") && Catch::Contains("view_axes"));
  CHECK(folder.fileCount() == 0);
  Json seen = punch(21, 27);
  seen["space"] = "view";
  seen["view_axes"] = Json::parse("[[0,0,-1],[0,1,0],[1,0,0]]");
  const std::string recipe = folder.write("side.json", recipeWith(Json::array({seen})).dump()).string();
  CHECK(test::runVerb({"exaggerate", character, "-o", output, "--recipe", recipe}).exitCode == 0);
}
