// Every option of `render` does something: a picture with it and one without differ.
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "tests/support/app/camera_file.h"
#include "tests/support/app/option_rows.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/temporary_folder.h"
#include "ui/batch/render_verb.h"

using namespace stretch;
namespace fs = std::filesystem;
using test::OptionRow;

namespace {

struct Drawn {
  int exitCode = 0;
  std::map<std::string, Bytes> files;
  friend bool operator==(const Drawn&, const Drawn&) = default;
};

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

Drawn drawn(const std::string& line, const test::TemporaryFolder& inputs) {
  const test::TemporaryFolder outputs;
  std::vector<std::string> words{"render"};
  for (std::string word : wordsOf(line)) {
    for (const auto& [name, folder] :
         {std::pair<std::string, const test::TemporaryFolder&>{"IN/", inputs},
          std::pair<std::string, const test::TemporaryFolder&>{"OUT/", outputs}}) {
      if (word.starts_with(name)) {
        word = (folder / word.substr(name.size())).string();
      }
    }
    words.push_back(word);
  }
  Drawn result;
  result.exitCode = test::runVerb(words, {ui::renderVerb()}).exitCode;
  for (const fs::directory_entry& entry : fs::directory_iterator(outputs.path())) {
    result.files[entry.path().filename().string()] = readFile(entry.path()).value();
  }
  return result;
}

std::set<std::string> optionsInHelp() {
  std::set<std::string> options{"FILE"};
  std::istringstream lines(test::runVerb({"render", "--help"}, {ui::renderVerb()}).output);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  -")) {
      const std::string word = wordsOf(line).front();
      options.insert(word.substr(word.find("--"), word.find('=') - word.find("--")));
    }
  }
  options.erase("--help");
  return options;
}

} // namespace

TEST_CASE("Every option of render changes what it draws") {
  const test::TemporaryFolder inputs;
  fs::copy_file(STRETCH_SOURCE_DIR "/assets/dummy.glb", inputs / "dummy.glb");
  fs::copy_file(test::boxerWithCameras(inputs), inputs / "shot.glb");
  REQUIRE(test::runVerb({"exaggerate", (inputs / "dummy.glb").string(), "-o", (inputs / "punch.glb").string(),
                         "--limb", "left-arm", "--range", "21:27", "--scale", "3"})
              .exitCode == 0);
  inputs.write("punch.json",
               R"({"version": 1, "trails": [{"limb": "left-arm", "range": [21, 27], "scale": 2}]})");
  inputs.write("odd.gltf", R"({"asset": {"version": "2.0"}, "cameras": []})");
  test::writeObjFrames(test::shorteningTube(4, 2.0, 0.06, 0.1), inputs / "tube", "tube");
  REQUIRE(test::runVerb(
              {"compress", (inputs / "tube").string(), "-o", (inputs / "tube.glb").string(), "--bones", "2"})
              .exitCode == 0);
  const std::string small = " --size 96x64";
  const std::string at = "-o OUT/out.png --frame 27" + small;
  const std::string punch = "IN/punch.glb " + at;
  const std::string tube = "IN/tube -o OUT/out.png --frame 3" + small;
  const std::vector<OptionRow> rows = test::joinedRows(
      {{"FILE", "IN/dummy.glb " + at, punch},
       {"--tolerant", "IN/odd.gltf -o OUT/out.png" + small, "IN/odd.gltf --tolerant -o OUT/out.png" + small},
       {"--plan", "IN/dummy.glb " + at + " --trails IN/punch.json",
        "IN/dummy.glb " + at + " --trails IN/punch.json --plan quadruped"},
       {"--output", punch, "IN/punch.glb -o OUT/other.png --frame 27" + small},
       {"--video", punch, "IN/punch.glb --frames 26:27 --video OUT/out.gif" + small},
       {"--frame", punch, "IN/punch.glb -o OUT/out.png --frame 20" + small},
       {"--frames", punch, "IN/punch.glb -o OUT/out.png --frames 26:27" + small},
       {"--size", punch, "IN/punch.glb -o OUT/out.png --frame 27 --size 64x64"},
       {"--camera", "IN/shot.glb -o OUT/out.png" + small,
        "IN/shot.glb -o OUT/out.png --camera Side" + small}},
      test::joinedRows(test::rowsBehind(punch, {{"--clip", "", "--clip Guard"},
                                                {"--fps", "", "--fps 12"},
                                                {"--beside", "", "--beside IN/dummy.glb"},
                                                {"--sheet", "", "--sheet"},
                                                {"--view", "", "--view top"},
                                                {"--safe-frame", "", "--safe-frame"},
                                                {"--trails", "", "--trails IN/punch.json"},
                                                {"--no-trails", "", "--no-trails"},
                                                {"--ghosts", "", "--ghosts 1"},
                                                {"--skeleton", "", "--skeleton"},
                                                {"--weights", "", "--weights LeftHand"},
                                                {"--shade-as", "", "--shade-as three"}}),
                       test::rowsBehind(tube, {{"--over", "", "--over IN/tube.glb"},
                                               {"--look", "", "--look thickness"},
                                               {"--bones", "--look segments", "--look segments --bones 3"},
                                               {"--stages", "", "--stages --bones 2"}})));
  std::set<std::string> named;
  for (const OptionRow& row : rows) {
    INFO(row.without << "\n" << row.with);
    named.insert(row.option);
    const Drawn without = drawn(row.without, inputs);
    const Drawn with = drawn(row.with, inputs);
    // Without ffmpeg the refusal of a video is another answer than the picture.
    CHECK((without.exitCode == 0 || with.exitCode == 0));
    CHECK_FALSE(without == with);
  }
  CHECK(named == optionsInHelp());
}
