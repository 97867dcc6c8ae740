#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/batch/options.h"
#include "app/batch/verb.h"
#include "app/schema/parse_text.h"
#include "app/schema/trail_schema.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/captured_stream.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr const char* dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";

/// A command line that a verb refuses, and the reason that it has to tell: 2 where the arguments alone are
/// wrong, 1 where the files are needed to see it.
struct RefusedLine {
  std::vector<std::string> words;
  std::string reason;
  int exitCode = 1;
};

/// The texts of the reasons that the verbs' sources give by themselves: what stands first in each Error.
std::vector<std::string> reasonsInSources() {
  // Told by the program as a whole, when memory or disk are full: tests/trust tries them. Of a body that is a
  // trunk alone, which no character here is. And of a clip of years, which odd_files_test.cpp makes.
  const std::set<std::string> ofTheMachine{
      "there is not enough memory for this", "the report cannot be written",
      "no limb but the trunk was found",
      "lasts {:.3g} frames, more than {:g}: a key may stand at a wrong time"};
  const std::regex first(R"re(Error\{(?:fmt::format\()?"([^"]+)")re");
  std::vector<std::string> reasons;
  for (const auto& entry : std::filesystem::directory_iterator(STRETCH_SOURCE_DIR "/app/batch")) {
    // Batches start processes: tests/batch/commands.sh runs them, with their refusals.
    const bool isAsked = entry.path().extension() == ".cpp" && entry.path().filename() != "batch.cpp";
    const std::string text = isAsked ? *readText(entry.path()) : std::string();
    for (std::sregex_iterator found(text.begin(), text.end(), first), end; found != end; ++found) {
      if (!ofTheMachine.contains((*found)[1])) {
        reasons.push_back((*found)[1]);
      }
    }
  }
  return reasons;
}

/// A reason as it is told, with any text where its source has a field.
std::regex toldAs(const std::string& reason) {
  const std::string plain = std::regex_replace(reason, std::regex(R"([.()+*?^$\[\]|])"), R"(\$&)");
  return std::regex(std::regex_replace(plain, std::regex(R"(\{[^}]*\})"), ".*"));
}

void checkThatEveryReasonIsTold(const std::vector<RefusedLine>& lines) {
  const std::vector<std::string> reasons = reasonsInSources();
  CHECK(reasons.size() > 15);
  for (const std::string& reason : reasons) {
    INFO("no command line is refused with: " << reason);
    CHECK(std::ranges::any_of(
        lines, [&](const RefusedLine& line) { return std::regex_search(line.reason, toldAs(reason)); }));
  }
}

/// Options of trails that say something against one another.
std::vector<RefusedLine> refusedTrailOptions(const std::string& out, const std::string& trails) {
  return {
      {{"exaggerate", dummy, "-o", out, "--recipe", trails, "--scale", "3"},
       "--scale: stands beside --recipe",
       2},
      {{"exaggerate", dummy, "-o", out, "--recipe", trails, "--camera", "front", "--no-pull"},
       "--no-pull: stands beside --recipe",
       2},
      {{"exaggerate", dummy, "-o", out, "--recipe", trails, "--range", "21:27"},
       "--range: stands beside --recipe",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--scale", "4"},
       "--scale: is given twice for one limb",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--range", "1:4", "--scale", "2", "--range",
        "5:9"},
       "--range: is given twice for one limb",
       2},
      {{"exaggerate", dummy, "-o", out, "--axes", "x", "--axes", "y", "--limb", "left-arm", "--scale", "2"},
       "--axes: is given twice for one limb",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--axes", "xyx"},
       "--axes: 'xyx' is not possible",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--axes", ""},
       "--axes: is empty",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--ease-in", "0.6,0.1",
        "--ease-out", "0.4,0.9"},
       "both eases together take the whole path"},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--ease-in", "0.6,0.51"},
       "ease_in: the value 0.51 is beyond the half"},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--ease-out", "0.2,0.49"},
       "ease_out: the value 0.49 is short of the half"},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--turn-to-view", "20"},
       "the path is turned to the view, of no camera"},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--space", "view"},
       "--space view: counts along the axes of a view, and no option gives one"},
  };
}

std::vector<RefusedLine> refusedExaggerations(const std::string& out, const std::string& trails) {
  return {
      {{"exaggerate", dummy, "-o", out}, "no limb was named", 2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm"}, "--limb left-arm: has no scale"},
      {{"exaggerate", dummy, "-o", out, "--recipe", trails, "--limb", "left-arm", "--scale", "2"},
       "--limb: stands beside --recipe",
       2},
      {{"exaggerate", dummy, "-o", out, "--auto", "--limb", "left-arm", "--scale", "2"},
       "--auto: stands beside trails of your own",
       2},
      {{"exaggerate", dummy, "-o", out, "--auto", "--recipe", trails},
       "--auto: stands beside trails of your own",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--style", "Subtle"},
       "--style: is for every moment at once",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--strength", "1"},
       "--strength: is for every moment at once",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--style-arm", "2"},
       "--style-arm: is for every moment at once",
       2},
      {{"exaggerate", dummy, "-o", out, "--all-clips"}, "--limb: no limb was named", 2},
      {{"exaggerate", dummy, "-o", out, "--all-clips", "--limb", "left-arm", "--scale", "2", "--limb",
        "left-amr", "--scale", "2"},
       "left-amr"},
      {{"exaggerate", dummy, "-o", out, "--all-clips", "--limb", "left-arm"},
       "--limb left-arm: has no scale"},
      {{"exaggerate", dummy, "-o", out, "--all-clips", "--recipe", trails},
       "--all-clips: stands beside --recipe, which names its clip",
       2},
      {{"exaggerate", dummy, "-o", out, "--all-clips", "--limb", "left-arm", "--scale", "2", "--range",
        "900:950"},
       "--all-clips: none of the limbs can be exaggerated in any clip"},
      {{"exaggerate", dummy, "-o", out, "--auto", "--range", "1:20"},
       "--auto: stands beside trails of your own",
       2},
      {{"exaggerate", dummy, "-o", out, "--auto", "--all-clips", "--clip", "Guard"},
       "--clip: stands beside --all-clips",
       2},
      {{"exaggerate", dummy, "-o", out, "--auto", "--loops"}, "is found by --auto itself", 2},
      {{"exaggerate", dummy, "-o", out, "--auto", "--style", "anime"}, "names no style, or several"},
      {{"exaggerate", dummy, "-o", out, "--auto", "--style-arm", "0.5"}, "do not rise"},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--influences", "4"},
       "counts with --form volume alone",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--keep-skeleton", "--form",
        "volume"},
       "--keep-skeleton: stands beside --form",
       2},
      {{"exaggerate", dummy, "-o", out, "--limb", "left-arm", "--scale", "2", "--key-every-frame",
        "--key-frames", "whole"},
       "--key-every-frame: stands beside --key-frames",
       2},
  };
}

std::vector<RefusedLine> refusedStyles(const std::string& out) {
  const std::string styleOut = out + ".json";
  return {
      {{"styles", "--style", "Subtle", "--name", "Mine", "-o", styleOut},
       "--name: says how a style is taken",
       2},
      {{"styles", "--style", "Subtle", "-o", out}, "an output has to end in .json", 2},
      {{"styles", "-o", styleOut}, "says no style", 2},
      {{"styles", "--style", "Subtle", "--take", dummy, "-o", styleOut}, "stands beside --take", 2},
      {{"styles", "--take", dummy, "-o", styleOut}, "no trail of the clip is exaggerated"},
  };
}

} // namespace

TEST_CASE("A range is two frames in order") {
  CHECK(parseRange("3:12.5", "--range").value() == Vec2(3.0, 12.5));
  CHECK(parseRange("-5:500", "--range").value() == Vec2(-5.0, 500.0));
  for (const char* text : {"12:3", "12", "a:b", ""}) {
    INFO(text);
    const Result<Vec2> range = parseRange(text, "--range");
    REQUIRE_FALSE(range);
    CHECK(range.error().where == "--range");
  }
}

TEST_CASE("A file that cannot be opened is named") {
  const test::TemporaryFolder folder;
  const std::string text = folder.write("notes.txt", "no model").string();
  CHECK(openDocument(FileArguments{text}).error().where.rfind(text, 0) == 0);
  CHECK(openDocument(FileArguments{folder.path().string()}).error().what == "is a folder");
}

TEST_CASE("Every verb that opens a file refuses a broken one in one line, and writes nothing") {
  const test::TemporaryFolder folder;
  const std::string broken = folder.write("broken.glb", "no model").string();
  const std::string output = (folder / "out.glb").string();
  const std::vector<std::vector<std::string>> calls{
      {"info", broken},
      {"check", broken},
      {"trail", broken, "--limb", "left-arm"},
      {"exaggerate", broken, "-o", output, "--limb", "left-arm", "--scale", "2"},
      {"elastic", broken, "-o", output},
      {"pose", broken, "-o", output, "--pin-feet"},
      {"resave", broken, "-o", output},
      {"rig", broken, "-o", output},
      {"bind", broken, "-o", output},
      {"import-clip", broken, "-o", output, "--from", dummy},
      {"import-clip", dummy, "-o", output, "--from", broken},
      {"compress", broken, "-o", output},
      {"compare", broken, dummy},
      {"compare", dummy, broken},
  };
  for (const std::vector<std::string>& call : calls) {
    INFO(call[0]);
    const test::VerbAnswer answer = test::runVerb(call);
    CHECK(answer.exitCode == 1);
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("Exaggerating writes nothing when a limb, its scale or its range is wrong") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  CHECK(test::exitCodeOf({"exaggerate", dummy, "-o", output}) == 2);
  CHECK(test::exitCodeOf({"exaggerate", dummy, "-o", output, "--limb", "left-arm"}) == 1);
  CHECK(test::exitCodeOf({"exaggerate", dummy, "-o", output, "--limb", "third-arm", "--scale", "2"}) == 1);
  CHECK(test::exitCodeOf({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "2", "--range",
                          "900:990"}) == 1);
  CHECK(test::exitCodeOf({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "much"}) == 2);
  CHECK(test::exitCodeOf({"exaggerate", dummy, "--limb", "left-arm", "--scale", "2"}) == 2);
  CHECK(test::exitCodeOf({"bend", dummy}) == 2);
  CHECK(folder.fileCount() == 0);
  CHECK(test::exitCodeOf({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "2"}) == 0);
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("A wrong argument is told in one line") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  const std::vector<std::vector<std::string>> wrong = {
      {"elastic", dummy, "-o", output, "--fps", "nan"},
      {"elastic", dummy, "-o", output, "--fps", "1e9"},
      {"elastic", dummy, "-o", output, "--fps", "0"},
      {"elastic", dummy, "-o", output, "--density", "0"},
      {"elastic", dummy, "-o", output, "--young", "nan"},
      {"elastic", dummy, "-o", output, "--softness", "3"},
      {"compress", "frames", "-o", output, "--skip", "-1"},
      {"compress", "frames", "-o", output, "--fps", "fast"},
      {"compress", "frames"},
      {"import-clip", dummy, "-o", output, "--from", dummy, "--name", ""},
      {"elastic", dummy, "-o", output, "--limb", ""},
      {"pose", dummy, "-o", output, "--recipe", ""},
      {"bend", dummy},
      {}};
  for (const std::vector<std::string>& words : wrong) {
    INFO((words.empty() ? "" : words.back()));
    const test::CapturedStream errors(stderr);
    const int exitCode = test::exitCodeOf(words);
    const std::string told = errors.text();
    CHECK(exitCode == 2);
    CHECK(std::count(told.begin(), told.end(), '\n') == 1);
    CHECK(told.size() < 200);
    CHECK_THAT(told, Catch::Contains(words.size() > 4 ? words[words.size() - 2] : ""));
  }
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("A limb that is named twice is refused, and nothing is written") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"elastic", dummy, "-o", output, "--limb", "left-arm", "--limb", "left-arm"},
        {"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "2", "--limb", "left-arm",
         "--scale", "3"}}) {
    const test::VerbAnswer answer = test::runVerb(words);
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains("left-arm"));
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
  }
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("A range of weight that the clip has in part is cut, with a warning, one outside is refused") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "out.glb").string();
  {
    const test::CapturedStream errors(stderr);
    CHECK(test::exitCodeOf({"elastic", dummy, "-o", output, "--range", "900:990"}) == 1);
    CHECK_THAT(errors.text(), Catch::Contains("outside the clip") && Catch::Contains("0 to 60"));
    CHECK(folder.fileCount() == 0);
  }
  const test::CapturedStream errors(stderr);
  CHECK(test::exitCodeOf({"elastic", dummy, "-o", output, "--range", "0:1000"}) == 0);
  CHECK_THAT(errors.text(), Catch::Contains("cut to the frames 0 to 60"));
}

TEST_CASE("Moduli of bones that a limb does not have are refused") {
  const test::TemporaryFolder folder;
  const std::string moduli =
      folder.write("moduli.json", R"({"segments": [{"from": 0, "to": 7, "young": 5000}]})").string();
  const test::CapturedStream errors(stderr);
  CHECK(test::exitCodeOf({"elastic", dummy, "-o", (folder / "out.glb").string(), "--moduli", moduli}) == 1);
  CHECK_THAT(errors.text(), Catch::Contains("names bone 7, and the last one is 1"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("No verb writes over what it reads, under any name, unless that is asked for") {
  const test::TemporaryFolder folder;
  std::filesystem::copy_file(dummy, folder / "in.glb");
  const std::string file = (folder / "in.glb").string();
  std::filesystem::create_symlink("in.glb", folder / "other.glb");
  const std::string other = (folder / "other.glb").string();
  const std::string before = readText(file).value();
  const std::vector<std::vector<std::string>> verbs = {
      {"resave", file},
      {"elastic", file},
      {"compress", file},
      {"exaggerate", file, "--limb", "left-arm", "--scale", "2"}};
  for (const std::vector<std::string>& verb : verbs) {
    for (const std::string& output : {file, other}) {
      INFO(verb.front());
      std::vector<std::string> words = verb;
      words.insert(words.end(), {"-o", output});
      const test::CapturedStream errors(stderr);
      CHECK(test::exitCodeOf(words) == 1);
      CHECK_THAT(errors.text(), Catch::Contains("--in-place"));
      CHECK(readText(file).value() == before);
    }
  }
  CHECK(test::exitCodeOf(
            {"exaggerate", file, "--limb", "left-arm", "--scale", "2", "-o", file, "--in-place"}) == 0);
  CHECK(readText(file).value() != before);
}

TEST_CASE("A report in one line says the same as one over many") {
  const test::VerbAnswer lines = test::runVerb({"info", dummy, "--json"});
  const test::VerbAnswer line = test::runVerb({"info", dummy, "--json-line"});
  REQUIRE(lines.exitCode == 0);
  REQUIRE(line.exitCode == 0);
  CHECK(std::count(line.output.begin(), line.output.end(), '\n') == 1);
  CHECK(std::count(lines.output.begin(), lines.output.end(), '\n') > 10);
  CHECK(gltf::Json::parse(line.output) == gltf::Json::parse(lines.output));
}

TEST_CASE("The version is what the program was built as") {
  const test::VerbAnswer answer = test::runVerb({"--version"});
  CHECK(answer.exitCode == 0);
  CHECK(answer.output == "stretch-engine under test\n");
}

TEST_CASE("A word that is no verb is answered with the verb that was probably meant, and all of them") {
  for (const auto& [word, meant] : {std::pair{"stretch", "exaggerate"}, std::pair{"exagerate", "exaggerate"},
                                    std::pair{"convert", "resave"}, std::pair{"inof", "info"}}) {
    INFO(word);
    const test::VerbAnswer answer = test::runVerb({word, dummy});
    CHECK(answer.exitCode == 2);
    CHECK_THAT(answer.told, Catch::Contains("there is no verb '" + std::string(word) + "'") &&
                                Catch::Contains("did you mean '" + std::string(meant) + "'?"));
  }
  const test::VerbAnswer answer = test::runVerb({"photograph", dummy});
  CHECK_THAT(answer.told, !Catch::Contains("did you mean") && Catch::Contains("the verbs are info, moments"));
}

TEST_CASE("A clip named in another case is refused with the name that the file has") {
  const test::VerbAnswer answer = test::runVerb({"trail", dummy, "--limb", "left-arm", "--clip", "guard"});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains("did you mean 'Guard'?"));
}

TEST_CASE("An option that switches something off says so") {
  const std::vector<Setting<rig::TrailSettings>>& settings = trailSchema();
  const auto pull =
      std::ranges::find(settings, "--no-pull", [](const auto& setting) { return setting.option; });
  REQUIRE(pull != settings.end());
  CHECK(optionHelp(*pull).starts_with("Switches this off: "));
}

namespace {

std::vector<RefusedLine> refusedPoses(const std::string& out, const std::string& trails) {
  return {
      {{"pose", dummy, "-o", out}, "nothing was asked for", 2},
      {{"pose", dummy, "-o", out, "--pose", "Bow"}, "'Bow' is no pose of the library"},
      {{"pose", dummy, "-o", out, "--pose", "Bow", "--pose-frame", "61"},
       "frame 61 lies outside the clip, which has the frames 0 to 60"},
      {{"pose", dummy, "-o", out, "--pose", "Bow", "--pose-amount", "1.5"}, "1.5 is no amount"},
      {{"pose", dummy, "-o", out, "--pose", "Bow", "--pose-range", "4:9"},
       "the range 4:9 does not hold frame 0"},
      {{"pose", dummy, "-o", out, "--pose", trails}, "is missing"},
      {{"import-clip", dummy, "-o", out, "--from", std::string(dummy) + "#Guard", "--from-clip", "#0"},
       "names a clip beside the one of --from"},
      {{"pose", dummy, "-o", out, "--recipe", trails}, "holds no adjustments, pins, grips or props"},
  };
}

/// Options of a compression that do not count, and those that do not go with a stream to which frames are
/// added.
std::vector<RefusedLine> refusedCompressions(const std::string& out, const std::string& tube,
                                             const std::string& moduli) {
  return {
      {{"compress", tube, "-o", out, "--append", tube, "--stream", tube},
       "the bones are those of the stream that is there",
       2},
      {{"compress", tube, "-o", out, "--append", tube, "--open-stream"},
       "the bones are those of the stream that is there",
       2},
      {{"compress", tube, "-o", out, "--append", tube, "--skeleton", dummy},
       "the bones are those of the stream that is there",
       2},
      {{"compress", tube, "-o", out, "--append", tube, "--moduli", moduli},
       "the bones are those of the stream that is there",
       2},
      {{"compress", tube, "-o", out, "--append", tube, "--curvature", out + ".csv"},
       "the bones are those of the stream that is there",
       2},
      {{"compress", tube, "-o", out, "--append", tube, "--bones", "3"},
       "--bones: frames that are appended take their bones from the stream",
       2},
      {{"compress", tube, "-o", out, "--scale-limit", "3"}, "--scale-limit: does not count here"},
      {{"compress", tube, "-o", out, "--influences", "8", "--weights", "geodesic"},
       "--influences: does not count here"},
  };
}

} // namespace

TEST_CASE("Every refusal of a verb tells its reason in one line and writes nothing") {
  const test::TemporaryFolder inputs;
  const test::TemporaryFolder outputs;
  const std::string out = (outputs / "out.glb").string();
  test::writeObjFrames(test::shorteningTube(3, 0.1, 0.2, 0.1), inputs / "tube", "tube");
  test::writeObjFrames(skinning::skinAllFrames(test::armedBody(3)), inputs / "armed", "armed");
  const std::string tube = (inputs / "tube").string();
  const std::string moduli =
      inputs.write("moduli.json", R"({"segments": [{"from": 0, "to": 7, "young": 5000}]})").string();
  const std::string trails =
      inputs.write("trails.json", R"({"version": 1, "trails": [{"limb": "left-arm", "scale": 2}]})").string();
  std::vector<RefusedLine> lines = refusedExaggerations(out, trails);
  const std::vector<RefusedLine> others{
      {{"bind", dummy, "-o", out}, "the file has a skeleton already; bind to it with --keep-joints"},
      {{"bind", dummy, "-o", out, "--keep-joints", "--locators", moduli}, "joints are either kept or made"},
      {{"bind", dummy, "-o", out, "--locators", moduli, "--plan", "biped"}, "--plan", 2},
      {{"bind", dummy, "-o", out, "--keep-joints", "--plan", "biped"}, "--plan", 2},
      {{"rig", dummy, "-o", out, "--locators", moduli, "--plan", "biped"}, "--plan", 2},
      {{"compare", tube, tube, tube}, "two are compared, 3 were named"},
      {{"compare", tube, tube, "--gravity", "0,-5,0"}, "--gravity: counts for a flattening alone", 2},
      {{"compare", tube, tube, "--mass", "3"}, "--mass: counts for a flattening alone", 2},
      {{"compare", tube, tube, "--metres-per-unit", "0.5"},
       "--metres-per-unit: counts for a flattening alone",
       2},
      {{"compare", tube, tube, "--clip", "#1"}, "neither of the two has clips to choose from"},
      {{"compress", tube, "-o", out, "--bones", "3", "--stream", moduli}, "the folder cannot be made"},
      {{"compress", tube, "-o", out, "--moduli", moduli, "--tolerance", "1"},
       "it names segments of a number of bones that is not known"},
      {{"compress", tube, "-o", out, "--moduli", moduli, "--bones", "3"},
       "names bone 7, and the last one is 2"},
      {{"compress", (inputs / "armed").string(), "-o", out, "--bones", "6", "--stretch", "measured",
        "--curvature", (outputs / "table.csv").string(), "--stream", (outputs / "stream").string()},
       "the body has no centre line, so there is no curvature to write"},
      {{"compress", tube, "-o", out, "--open-stream"}, "there is no stream to write", 2},
      {{"compress", tube, "-o", out, "--curvature", out}, "out.glb: is written twice"},
      {{"compress", tube, "-o", out, "--skip", "3"},
       "3 frames are skipped, and the sequence has 3; give at most 2"},
      {{"elastic", dummy, "-o", out, "--range", "60:70"},
       "the range lies outside the clip, which has the frames 0 to 60"},
      {{"resave", dummy, "-o", dummy}, "is read and would be written over"},
      {{"trail", tube, "--limb", "left-arm"}, "is a sequence of meshes, no character with joints"},
      {{"rig", dummy, "-o", out}, "the file has a skeleton already, and no joint is made"},
  };
  for (const std::vector<RefusedLine>& more :
       {others, refusedStyles(out), refusedPoses(out, trails), refusedTrailOptions(out, trails),
        refusedCompressions(out, tube, moduli)}) {
    lines.insert(lines.end(), more.begin(), more.end());
  }
  for (const RefusedLine& line : lines) {
    INFO(line.reason);
    const test::VerbAnswer answer = test::runVerb(line.words);
    CHECK(answer.exitCode == line.exitCode);
    CHECK_THAT(answer.told, Catch::Contains(line.reason));
    CHECK(std::count(answer.told.begin(), answer.told.end(), '\n') == 1);
    CHECK(outputs.fileCount() == 0);
  }
  checkThatEveryReasonIsTold(lines);
}

TEST_CASE("An option's text that is no UTF-8 is refused in one line as any other") {
  const test::TemporaryFolder folder;
  const test::VerbAnswer answer =
      test::runVerb({"exaggerate", dummy, "-o", (folder / "out.glb").string(), "--key-frames", "whole\xB9"});
  CHECK(answer.exitCode == 2);
  CHECK_THAT(answer.told, Catch::Contains("--key-frames: ") && Catch::Contains(" is not possible"));
  CHECK(folder.fileCount() == 0);
  const std::string odd = (folder / "n\xB9.glb").string();
  CHECK(test::runVerb({"info", odd, "--json"}).exitCode == 1);
}

TEST_CASE("check answers 1 for a file that cannot be opened, with or without a report as JSON, else 0") {
  const test::TemporaryFolder folder;
  const std::string whole = *readText(dummy);
  const std::string cut = folder.write("cut.glb", whole.substr(0, whole.size() / 2)).string();
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{}, {"--json"}, {"--json-line"}}) {
    std::vector<std::string> broken{"check", cut};
    broken.insert(broken.end(), more.begin(), more.end());
    CHECK(test::runVerb(broken).exitCode == 1);
    broken[1] = dummy;
    CHECK(test::runVerb(broken).exitCode == 0);
  }
  CHECK(test::runVerb({"check", (folder / "gone.glb").string()}).exitCode == 1);
}
