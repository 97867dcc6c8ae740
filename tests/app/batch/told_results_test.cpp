// What a verb did is told, also where it did less than a reader may take for granted.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/foreign_text.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using gltf::Json;
using test::runVerb;
using test::TemporaryFolder;

namespace {

const std::string dummyFile = test::posedCharacter;
const std::string swingFile = STRETCH_SOURCE_DIR "/assets/dummy_swing.glb";

/// The bundled character whose second clip, Guard, is stretched.
std::string stretchedGuardIn(const TemporaryFolder& folder) {
  std::string file = (folder / "guard.glb").string();
  REQUIRE(
      runVerb({"exaggerate", dummyFile, "-o", file, "--limb", "left-arm", "--scale", "3", "--clip", "Guard"})
          .exitCode == 0);
  return file;
}

Json jsonOf(std::vector<std::string> words, int exitCode = 0) {
  words.emplace_back("--json");
  const test::VerbAnswer answer = runVerb(words);
  INFO(answer.told);
  REQUIRE(answer.exitCode == exitCode);
  return Json::parse(answer.output);
}

} // namespace

TEST_CASE("compare looks at the clip that is named, and says which of several it took", "[compare]") {
  const TemporaryFolder folder;
  const std::string guard = stretchedGuardIn(folder);
  const Json first = jsonOf({"compare", dummyFile, guard});
  CHECK(first["rmse_percent"].get<double>() < 1e-3);
  REQUIRE(first["warnings"].size() == 2);
  CHECK(first["warnings"][0] == "dummy.glb: the first of 2 clips was taken, 'One-two punch'");
  CHECK_THAT(runVerb({"compare", dummyFile, guard}).told,
             Catch::Contains("warning: guard.glb: the first of 2 clips was taken"));
  for (const char* const name : {"Guard", "#1"}) {
    const Json named = jsonOf({"compare", dummyFile, guard, "--clip", name});
    CHECK(named["rmse_percent"].get<double>() > 0.5);
    CHECK(named["warnings"].empty());
  }
  const test::VerbAnswer missing = runVerb({"compare", dummyFile, guard, "--clip", "Kick"});
  CHECK(missing.exitCode == 1);
  CHECK_THAT(missing.told, Catch::Contains("Kick"));
}

TEST_CASE("check --before says which clips it compared, and refuses where there is none", "[check]") {
  const TemporaryFolder folder;
  const std::string guard = stretchedGuardIn(folder);
  const Json report = jsonOf({"check", guard, "--before", dummyFile});
  CHECK(report["compared_clips"] == Json{"One-two punch", "Guard"});
  CHECK(report["clips_not_compared"]["in_file"].empty());
  CHECK_THAT(runVerb({"check", guard, "--before", dummyFile}).output,
             Catch::Contains("before 2 clips compared: 'One-two punch', 'Guard'; "));
  const std::string more = (folder / "more.glb").string();
  REQUIRE(runVerb({"import-clip", dummyFile, "-o", more, "--from", swingFile, "--name", "Swing"}).exitCode ==
          0);
  const Json added = jsonOf({"check", more, "--before", dummyFile});
  CHECK(added["clips_not_compared"] == Json{{"in_file", {"Swing"}}, {"in_source", Json::array()}});
  const test::VerbAnswer swapped = runVerb({"check", dummyFile, "--before", more});
  CHECK(swapped.exitCode == 0);
  CHECK_THAT(swapped.output, Catch::Contains("before not compared, in " + more + " alone: 'Swing'"));
  const test::VerbAnswer other = runVerb({"check", swingFile, "--before", dummyFile});
  CHECK(other.exitCode == 1);
  CHECK_THAT(other.told, Catch::Contains("has no clip of the same name as one of the other"));
}

TEST_CASE("check says of a file that the other verbs refuse that they do", "[check]") {
  const TemporaryFolder folder;
  Json json = Json::parse(R"({"asset": {"version": "2.0"}, "nodes": [{"rotation": [0, 0, 0, 2]}],
                              "scenes": [{"nodes": [0]}]})");
  const std::string file = folder.write("turned.gltf", json.dump()).string();
  REQUIRE(runVerb({"info", file}).exitCode == 1);
  const test::VerbAnswer words = runVerb({"check", file});
  CHECK(words.exitCode == 0);
  CHECK_THAT(words.output,
             Catch::Contains("the other verbs refuse this file") && Catch::Contains("--tolerant"));
  CHECK(jsonOf({"check", file})["refused"] == true);
  CHECK(jsonOf({"check", dummyFile})["refused"] == false);
  const std::string broken =
      folder.write("broken.gltf", R"({"asset": {"version": "2.0"}, "nodes": 7)").string();
  CHECK(jsonOf({"check", broken}, 1)["refused"] == true);
  CHECK_THAT(runVerb({"check", broken}).output, !Catch::Contains("--tolerant"));
  CHECK_THAT(runVerb({"check", dummyFile}).output, !Catch::Contains("refuse"));
}

TEST_CASE("moments of several files name the one that was lost, and the one without the clip", "[moments]") {
  const Json list = jsonOf({"moments", dummyFile, "missing.glb", swingFile}, 1);
  REQUIRE(list.size() > 1);
  CHECK(list.back()["file"] == "missing.glb");
  CHECK_THAT(list.back()["error"].get<std::string>(), Catch::Contains("missing.glb"));
  CHECK(list.front().contains("limb"));
  const test::VerbAnswer answer = runVerb({"moments", dummyFile, swingFile, "--clip", "Guard"});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains(swingFile + ": --clip: there is no clip 'Guard'"));
}

TEST_CASE("pose tells of attributes and turns what was asked and what came of it", "[pose]") {
  const TemporaryFolder folder;
  const Json recipe = Json::parse(R"({"version": 1, "adjustments": [
      {"attribute": "left-hand.curl", "keys": [{"frame": 0, "value": 99}]},
      {"attribute": "right-hand.curl", "keys": [{"frame": 4, "value": 0.5}]},
      {"controller": "hips", "keys": [{"frame": 12, "turn": [0, 20, 0]}]},
      {"controller": "head", "keys": [{"frame": 12, "turn": [0, 0, 30]}]}]})");
  const test::Posed posed = test::pose(folder, recipe, {"--json"});
  REQUIRE(posed.answer.exitCode == 0);
  const Json report = Json::parse(posed.answer.output);
  const Json& controllers = report["controllers"];
  CHECK(controllers[0]["keys"][0] == Json{{"frame", 0.0}, {"asked", 99.0}, {"reached", 1.0}});
  CHECK(controllers[1]["keys"][0] == Json{{"frame", 4.0}, {"asked", 0.5}, {"reached", 0.5}});
  for (const auto& [index, degrees] : {std::pair(2, 20.0), std::pair(3, 30.0)}) {
    const Json& turn = controllers[static_cast<std::size_t>(index)]["keys"][0]["turn"];
    CHECK(turn["asked_degrees"].get<double>() == Approx(degrees));
    CHECK(turn["reached_degrees"].get<double>() == Approx(degrees).margin(0.1));
  }
  CHECK_THAT(report["warnings"].dump(),
             Catch::Contains("left-hand.curl is asked for 99 at frame 0, and goes to 1 at most") &&
                 !Catch::Contains("right-hand.curl"));
  const std::string file = folder.write("recipe.json", recipe.dump()).string();
  const test::VerbAnswer told =
      runVerb({"pose", dummyFile, "-o", (folder / "told.glb").string(), "--recipe", file});
  CHECK_THAT(told.output, Catch::Contains("left-hand.curl: frame 0: asked for 99, reached 1\n") &&
                              Catch::Contains("asked to turn 30 degrees, turned 30"));
}

TEST_CASE("exaggerate tells the tip where the limb's end is then: at the end of the range that is no pivot",
          "[exaggerate]") {
  const TemporaryFolder folder;
  const std::string file = (folder / "out.glb").string();
  for (const auto& [pivot, frame] : {std::pair("start", 27.0), std::pair("end", 21.0)}) {
    CAPTURE(pivot);
    const Json told = jsonOf({"exaggerate", dummyFile, "-o", file, "--limb", "left-arm", "--range", "21:27",
                              "--scale", "2", "--space", "base", "--pivot", pivot, "--clean"});
    const app::Document saved = app::openDocument(file).value();
    const FrameState shown = app::evaluateOriginal(saved, 0, frame / app::clipOf(saved, 0).framesPerSecond);
    const Json& tip = told["trails"][0]["tip"];
    const Vec3 hand = rig::endPosition(*app::findLimb(saved, "left-arm"), shown);
    CHECK(glm::distance(Vec3(tip[0], tip[1], tip[2]), hand) < 1e-4);
  }
}

TEST_CASE("Options that say how something else is done are refused without it", "[arguments]") {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const std::string table = folder.write("table.csv", "controller,frame,move_y\nhips,12,-0.1\n").string();
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--pose-amount", "0.5"},
                                               {"--pose-frame", "3"},
                                               {"--pose-range", "1:9"},
                                               {"--pose-mirrored"},
                                               {"--prop-hand", "both"},
                                               {"--prop-frame", "3"}}) {
    std::vector<std::string> words{"pose", dummyFile, "-o", out, "--offsets", table};
    words.insert(words.end(), more.begin(), more.end());
    const test::VerbAnswer answer = runVerb(words);
    INFO(more.front());
    CHECK(answer.exitCode == 2);
    CHECK_THAT(answer.told, Catch::Contains(more.front() + " requires --p"));
  }
  CHECK(runVerb({"pose", dummyFile, "-o", out, "--pin-feet", "--units", "metres"}).exitCode == 2);
  const test::VerbAnswer clips = runVerb(
      {"import-clip", dummyFile, "-o", out, "--from", dummyFile + "#Guard", "--from-clip", "One-two punch"});
  CHECK(clips.exitCode == 1);
  CHECK_THAT(clips.told, Catch::Contains("--from-clip: names a clip beside the one of --from"));
  CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("An option that no verb has is named, and not what is missing because of it", "[arguments]") {
  for (const char* const word : {"--bogus", "-d.glb"}) {
    const test::VerbAnswer answer = runVerb({"info", word});
    CHECK(answer.exitCode == 2);
    CHECK_THAT(answer.told, Catch::Contains("there is no option '" + std::string(word) + "'"));
  }
  CHECK_THAT(runVerb({"info"}).told, Catch::Contains("FILE is required"));
}

TEST_CASE("resave tells what was left out of a foreign file, as info does", "[resave]") {
  const TemporaryFolder folder;
  const std::string marching = STRETCH_SOURCE_DIR "/tests/ui/files/marching.bvh";
  const Json warnings = jsonOf({"info", marching})["warnings"];
  REQUIRE_FALSE(warnings.empty());
  const test::VerbAnswer answer = runVerb({"resave", marching, "-o", (folder / "march.glb").string()});
  REQUIRE(answer.exitCode == 0);
  for (const Json& warning : warnings) {
    CHECK_THAT(answer.told, Catch::Contains("warning: " + warning.get<std::string>() + "\n"));
  }
}

TEST_CASE("trail and elastic tell a range that the clip cuts", "[arguments]") {
  const TemporaryFolder folder;
  const char* const cut = "the range is cut to the frames 0 to 10, which the clip has";
  CHECK_THAT(runVerb({"trail", dummyFile, "--limb", "left-arm", "--range", "-5:10"}).told,
             Catch::Contains(cut));
  CHECK_THAT(jsonOf({"trail", dummyFile, "--limb", "left-arm", "--range", "-5:10"})["warnings"].dump(),
             Catch::Contains(cut));
  CHECK_THAT(jsonOf({"trail", dummyFile, "--limb", "left-arm", "--range", "1:10"})["warnings"].dump(),
             !Catch::Contains("cut"));
  CHECK_THAT(runVerb({"elastic", dummyFile, "-o", (folder / "out.glb").string(), "--range", "-5:10"}).told,
             Catch::Contains(cut));
}

TEST_CASE("A limb of joints without names is shown by their numbers", "[info]") {
  const TemporaryFolder folder;
  const std::string file = (folder / "dummy.gltf").string();
  REQUIRE(runVerb({"resave", dummyFile, "-o", file}).exitCode == 0);
  const Json limb = jsonOf({"info", file})["limbs"][0];
  std::string chain;
  Json json = Json::parse(readText(file).value());
  for (const Json& joint : limb["joints"]) {
    const auto node = joint["node"].get<std::size_t>();
    json["nodes"][node].erase("name");
    chain += (chain.empty() ? "#" : " > #") + std::to_string(node);
  }
  const std::string nameless = folder.write("nameless.gltf", json.dump()).string();
  CHECK_THAT(runVerb({"info", nameless}).output, Catch::Contains(chain));
}

TEST_CASE("Limbs that keep their thickness are told, whatever volume their trails have", "[output]") {
  const TemporaryFolder folder;
  const std::vector<std::string> words{"exaggerate", dummyFile,  "-o",      (folder / "out.glb").string(),
                                       "--limb",     "left-arm", "--scale", "2",
                                       "--volume",   "1"};
  CHECK_THAT(runVerb(words).output, !Catch::Contains("thickness"));
  std::vector<std::string> translated = words;
  translated.emplace_back("--keep-skeleton");
  CHECK_THAT(runVerb(translated).output,
             Catch::Contains("limbs keep their thickness, and no volume of a trail is written"));
}

TEST_CASE("A single mesh is told how a verb of characters takes it, and what a clip cannot follow",
          "[bind]") {
  const TemporaryFolder folder;
  test::writeObjFrames(test::shorteningTube(1, 0.1, 0.2, 0.1), folder / "tube", "tube");
  std::string mesh;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "tube")) {
    mesh = entry.path().string();
  }
  const test::VerbAnswer answer = runVerb({"bind", mesh, "-o", (folder / "out.glb").string()});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains(mesh + ": is read as a frame of a sequence of meshes") &&
                              Catch::Contains("save the mesh as .glb"));
}

TEST_CASE("A limb that flips on its trail's way is told once, by a recipe with holds and in every clip, too",
          "[told]") {
  const TemporaryFolder folder;
  const std::string leap = STRETCH_SOURCE_DIR "/assets/dummy_leap.glb";
  const std::string output = (folder / "out.glb").string();
  const auto flipsIn = [](const Json& report) {
    const std::string text = report.dump();
    std::vector<std::string> flips;
    for (std::size_t place = text.find(" flips at "); place != std::string::npos;
         place = text.find(" flips at ", place + 1)) {
      flips.push_back(text.substr(place - 12, 31));
    }
    return flips;
  };
  const std::vector<std::string> once{"the left leg flips at frame 20:"};
  const Json flipped = jsonOf({"exaggerate", leap, "-o", output, "--limb", "left-leg", "--scale", "2.5"});
  CHECK(flipsIn(flipped["trails"][0]["warnings"]) == once);
  CHECK(flipsIn(flipped) == once);
  CHECK(flipsIn(jsonOf({"exaggerate", leap, "-o", output, "--limb", "left-leg", "--scale", "1.2"})).empty());
  const Json every =
      jsonOf({"exaggerate", leap, "-o", output, "--limb", "left-leg", "--scale", "2.5", "--all-clips"});
  CHECK(flipsIn(every["clips"][0]["trails"][0]["warnings"]) == once);
  const std::string recipe =
      folder
          .write("recipe.json",
                 R"({"version": 1, "trails": [{"limb": "left-leg", "scale": 2.5, "space": "root"}],
                                    "pins": [{"limb": "right-arm", "range": [0, 2], "at": 0}]})")
          .string();
  CHECK(flipsIn(jsonOf({"exaggerate", leap, "-o", output, "--recipe", recipe})) == once);
}
