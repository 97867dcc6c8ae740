#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/document.h"
#include "app/evaluate/evaluate.h"
#include "app/evaluate/seen.h"
#include "core/gltf/json/json.h"
#include "rig/limb.h"
#include "rig/trail/seen_tip.h"
#include "tests/support/app/camera_file.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_verb.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::runVerb;
using test::TemporaryFolder;
using test::VerbAnswer;

namespace {

// From the command line to the report and the saved file.

struct Punch {
  VerbAnswer answer;
  std::string file;
  Json trail; ///< Of the report.
};

Punch punch(const std::string& character, const TemporaryFolder& folder,
            const std::vector<std::string>& more) {
  Punch made;
  made.file = (folder / "punch.glb").string();
  std::vector<std::string> words{"exaggerate", character, "-o",     made.file,  "--range", "21:27",
                                 "--scale",    "3",       "--limb", "left-arm", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  made.answer = runVerb(words);
  INFO(made.answer.told);
  REQUIRE(made.answer.exitCode == 0);
  made.trail = Json::parse(made.answer.output)["trails"][0];
  return made;
}

// Of the clean file's own keys against the source's: the left arm's length in the picture of a camera of the
// file at frame 27.
double seenInFile(const std::string& saved, const std::string& source, const std::string& camera) {
  const auto length = [&](const std::string& path) {
    const Document document = test::openedFile(path);
    const FrameState frame = evaluateOriginal(document, 0, 27.0 / clipOf(document, 0).framesPerSecond);
    const SceneCamera* const named = cameraNamed(*document.scene, camera);
    REQUIRE(named != nullptr);
    const rig::Limb& arm = *findLimb(document, "left-arm");
    return rig::seenLength(cameraIn(*named, frame).value(), rig::stayingPosition(arm, frame),
                           rig::leadingPosition(arm, frame))
        .value();
  };
  return length(saved) / length(source);
}

std::string warningsOf(const Json& trail) {
  return trail["warnings"].dump();
}

} // namespace

TEST_CASE("info lists the file's cameras with their lens and the clips that move them") {
  const TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const Json cameras = Json::parse(runVerb({"info", file, "--json"}).output)["cameras"];
  REQUIRE(cameras.size() == 3);
  CHECK(cameras[0]["name"] == "Side");
  CHECK(cameras[0]["kind"] == "perspective");
  CHECK(cameras[0]["field_of_view"].get<double>() == Approx(34.377).epsilon(1e-4));
  CHECK(cameras[0]["focal_length"].get<double>() == Approx(38.793).epsilon(1e-4));
  CHECK(cameras[0]["animated_in"].empty());
  CHECK(cameras[1]["animated_in"].size() == 1);
  CHECK(cameras[2]["kind"] == "orthographic");
  CHECK(cameras[2]["height"] == 2.0);
  const std::string text = runVerb({"info", file}).output;
  CHECK_THAT(text, Catch::Contains("camera Side: perspective, 34.38 degrees (38.8 mm)\n"));
  CHECK_THAT(text, Catch::Contains("camera Front: perspective, 34.38 degrees (38.8 mm), animated in "));
  CHECK_THAT(text, Catch::Contains("camera Flat: orthographic, 2 high\n"));
}

TEST_CASE("a punch is seen from the side, and from the front it is told that it points along the view") {
  const TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const Json side = punch(file, folder, {"--camera", "Side", "--clean"}).trail;
  CHECK(side["seen"]["camera"] == "Side");
  CHECK(side["seen"]["ratio"].get<double>() ==
        Approx(seenInFile((folder / "punch.glb").string(), file, "Side")).epsilon(1e-3));
  CHECK(side["seen"]["of"].get<double>() == Approx(3.0).epsilon(1e-3));
  CHECK(side["seen"]["share"].get<double>() > 0.8);
  CHECK(side["seen"]["path"].get<double>() > 1.5);
  CHECK_THAT(warningsOf(side), !Catch::Contains("along the view"));
  const Punch front = punch(file, folder, {"--camera", "front", "--axes", "xz"});
  CHECK(front.trail["seen"]["share"].get<double>() < smallestSeenShare);
  CHECK_THAT(warningsOf(front.trail), Catch::Contains("along the view") && Catch::Contains("--as-seen") &&
                                          Catch::Contains("look from") && Catch::Contains("'Side'"));
  const Json& eye = front.trail["best_view"]["direction"];
  CHECK(std::abs(eye[0].get<double>()) > 0.7); // from a side
  CHECK(eye[2].get<double>() > 0.1);           // that sees the face
  CHECK_FALSE(punch(file, folder, {}).trail.contains("seen"));
}

TEST_CASE("scaled as seen, the saved file's limb looks as long as it should through the file's camera") {
  const TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  for (const std::string camera : {"Side", "Front", "Flat"}) {
    for (const bool keepDepth : {true, false}) {
      CAPTURE(camera, keepDepth);
      std::vector<std::string> words{"--as-seen", "--camera", camera, "--scale", "1.8", "--clean"};
      if (!keepDepth) {
        words.emplace_back("--no-keep-depth");
      }
      const Punch made = punch(file, folder, words);
      REQUIRE(made.trail["reached"] == true);
      CHECK(made.trail["seen"]["of"] == 1.8);
      CHECK(made.trail["seen"]["ratio"].get<double>() == Approx(1.8).epsilon(1e-4));
      CHECK(seenInFile(made.file, file, camera) == Approx(1.8).epsilon(1e-3));
    }
  }
  const VerbAnswer text =
      runVerb({"exaggerate", file, "-o", (folder / "text.glb").string(), "--limb", "left-arm", "--range",
               "21:27", "--scale", "1.8", "--as-seen", "--camera", "Side"});
  CHECK_THAT(text.output, Catch::Contains(", seen x1.8 of x1.8\n"));
}

TEST_CASE("what the camera cannot see as long is told as not reached, with a better view") {
  const TemporaryFolder folder;
  const Punch made =
      punch(test::boxerWithCameras(folder), folder, {"--as-seen", "--camera", "Side", "--scale", "9"});
  CHECK(made.trail["reached"] == false);
  CHECK_THAT(warningsOf(made.trail), Catch::Contains("not reachable as seen: x") &&
                                         Catch::Contains(" of x9") && Catch::Contains("look from"));
}

TEST_CASE("a limb that leaves the safe frame of the file's camera is told") {
  const TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  CHECK_THAT(warningsOf(punch(file, folder, {"--camera", "Side"}).trail), !Catch::Contains("safe frame"));
  CHECK_THAT(warningsOf(punch(file, folder, {"--camera", "Side", "--scale", "6"}).trail),
             Catch::Contains("leaves the safe frame of 'Side'"));
}

TEST_CASE("a camera that is not there is refused with those that are, and a scale as seen by none") {
  const TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const std::vector<std::string> words{"exaggerate", file,       "-o",      (folder / "out.glb").string(),
                                       "--limb",     "left-arm", "--scale", "2"};
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--camera", "Shot"}, std::vector<std::string>{"--as-seen"}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    const VerbAnswer answer = runVerb(all);
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains("'Side', 'Front', 'Flat', front, side, top or three-quarter"));
  }
  CHECK_FALSE(std::filesystem::exists(folder / "out.glb"));
}

TEST_CASE("the camera of a trail is in recipe and saved work, and a recipe may be judged by another one") {
  const TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const Punch made = punch(file, folder, {"--as-seen", "--camera", "Front", "--scale", "1.8"});
  const Document saved = test::openedFile(made.file);
  REQUIRE(saved.trails.size() == 1);
  CHECK(saved.trails[0].settings.sight.camera == "Front");
  CHECK(saved.trails[0].settings.sight.asSeen);
  const Json trail{{"limb", "left-arm"}, {"range", {21, 27}}, {"scale", 1.8}};
  const auto judged = [&](Json more, const std::vector<std::string>& words) {
    more.update(trail);
    const std::string recipe =
        folder.write("recipe.json", Json{{"version", 1}, {"trails", Json::array({more})}}.dump()).string();
    std::vector<std::string> all{"exaggerate", file,   "-o",    (folder / "out.glb").string(),
                                 "--recipe",   recipe, "--json"};
    all.insert(all.end(), words.begin(), words.end());
    const VerbAnswer answer = runVerb(all);
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    return Json::parse(answer.output)["trails"][0];
  };
  const Json again = judged({{"as_seen", true}, {"camera", "Front"}}, {});
  CHECK(again["seen"]["ratio"] == made.trail["seen"]["ratio"]);
  CHECK(judged(Json::object(), {"--camera", "Side"})["seen"]["camera"] == "Side");
  CHECK(judged({{"camera", "front"}}, {"--camera", "Side"})["seen"]["camera"] == "front");
  const Json kept = judged(
      {{"seen_view",
        {{"kind", "orthographic"}, {"position", {0, 0, 0}}, {"right", {0, 0, -1}}, {"up", {0, 1, 0}}}}},
      {});
  CHECK(kept["seen"]["camera"].is_null());
  CHECK(kept["seen"]["ratio"] == judged({{"camera", "side"}}, {})["seen"]["ratio"]);
}
