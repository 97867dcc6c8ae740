#include <filesystem>
#include <sstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "core/base/file.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/recorded.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/tube_person.h"

using namespace stretch;
using namespace stretch::app;
using test::runVerb;
using test::TemporaryFolder;

namespace {

constexpr double recordTolerance = 1e-3;

std::vector<std::string> wordsOf(std::string line, const std::string& folder) {
  for (std::size_t at = line.find("IN/"); at != std::string::npos;
       at = line.find("IN/", at + folder.size())) {
    line.replace(at, 3, folder + "/");
  }
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

/// What each of the command lines tells, one after the other in one folder, IN.
std::string tellings(const std::vector<std::string>& lines, const TemporaryFolder& folder) {
  const std::string path = folder.path().string();
  std::string text;
  for (const std::string& line : lines) {
    const test::VerbAnswer answer = runVerb(wordsOf(line, path));
    std::string told = test::withoutClock(answer.output) + answer.told;
    for (std::size_t at = told.find(path); at != std::string::npos; at = told.find(path, at)) {
      told.replace(at, path.size(), "IN");
    }
    text += fmt::format("{}\n exit {}\n{}\n", line, answer.exitCode, told);
  }
  return text;
}

/// Command lines that are refused, or whose answer says that nothing is there.
const char* const refused[] = {"info",
                               "info IN/gone.glb",
                               "info IN/work.json",
                               "trail IN/dummy.glb --limb tail",
                               "trail IN/dummy.glb --limb left-arm --range 9:2",
                               "trail IN/dummy.glb --limb left-arm --range x",
                               "trail IN/dummy.glb --limb left-arm --range 0:900",
                               "trail IN/dummy.glb --limb left-arm --clip 9",
                               "trail IN/dummy.glb --limb left-arm --clip #7",
                               "trail IN/dummy.glb --limb left-arm --fps 0",
                               "trail IN/dummy.glb --limb Head..Hips",
                               "trail IN/dummy.glb --limb Hips..Nobody",
                               "exaggerate IN/dummy.glb -o IN/dummy.glb --limb left-arm",
                               "exaggerate IN/dummy.glb -o IN/none/out.glb --limb left-arm",
                               "exaggerate IN/dummy.glb -o IN/out.obj --limb left-arm",
                               "pose IN/dummy.glb -o IN/out.glb",
                               "pose IN/dummy.glb -o IN/out.glb --recipe IN/unknown.json",
                               "pose IN/dummy.glb -o IN/out.glb --recipe IN/late.json",
                               "pose IN/dummy.glb -o IN/out.glb --offsets IN/table.csv",
                               "pose IN/dummy.glb -o IN/out.glb --prop IN/gone.glb",
                               "pose IN/dummy.glb -o IN/out.glb --pin-feet --units feet",
                               "elastic IN/dummy.glb -o IN/out.glb --limb tail",
                               "elastic IN/dummy.glb -o IN/out.glb --gravity 1,2",
                               "elastic IN/dummy.glb -o IN/out.glb --young 0",
                               "elastic IN/dummy.glb -o IN/out.glb --moduli IN/none.json",
                               "rig IN/dummy.glb -o IN/out.glb",
                               "bind IN/dummy.glb -o IN/out.glb --locators IN/places.json",
                               "bind IN/dummy.glb -o IN/out.glb --weights none",
                               "import-clip IN/dummy.glb -o IN/out.glb --from IN/gone.glb",
                               "import-clip IN/dummy.glb -o IN/out.glb --from IN/dummy.glb#Nine",
                               "import-clip IN/dummy.glb -o IN/out.glb --from IN/dummy.glb --name x",
                               "compress IN/gone -o IN/out.glb",
                               "compress IN/dummy.glb -o IN/out.glb --bones 0",
                               "compress IN/dummy.glb -o IN/out.glb --stretch much",
                               "compress IN/dummy.glb -o IN/out.glb --clip nine",
                               "compare IN/dummy.glb IN/gone.glb",
                               "compare IN/dummy.glb",
                               "flatten --mass 1",
                               "flatten --mass -1 --young 1 --length 1 --width 1",
                               "resave IN/dummy.glb -o IN/dummy.glb",
                               "dance IN/dummy.glb"};

/// Trails of the verb exaggerate that are refused.
const char* const refusedTrails[] = {"",
                                     "--scale 2",
                                     "--limb left-arm --scale -1",
                                     "--limb left-arm --scale x",
                                     "--limb left-arm --axes q",
                                     "--limb left-arm --axes xx",
                                     "--limb left-arm --pivot middle",
                                     "--limb left-arm --ease-in 2,0",
                                     "--limb left-arm --ease-out 0.1",
                                     "--limb left-arm --release -2",
                                     "--limb left-arm --blend 7",
                                     "--limb left-arm --limb left-arm",
                                     "--limb left-arm --recipe IN/work.json",
                                     "--recipe IN/broken.json",
                                     "--recipe IN/twice.json",
                                     "--recipe IN/none.json",
                                     "--recipe IN/gone.json",
                                     "--plan worm --limb left-arm",
                                     "--limb left-arm --space moon",
                                     "--limb left-arm --switch 2",
                                     "--limb left-arm --volume -1"};

void addClip(const TemporaryFolder& folder) {
  std::filesystem::copy_file(test::posedCharacter, folder / "dummy.glb");
  folder.write("work.json", R"({"version": 1,
    "trails": [{"limb": "left-arm", "range": [21, 27], "scale": 3, "axes": "xz"}],
    "adjustments": [{"controller": "hips", "range": [0, 30], "keys": [{"frame": 10, "move": [0, -0.1, 0]}]},
                    {"attribute": "right-arm.stretch", "keys": [{"frame": 4, "value": 0.5}]}],
    "pins": [{"limb": "left-leg", "range": [2, 12]}],
    "grips": [{"follower": "right-arm", "leader": "left-arm", "range": [30, 40]}]})");
}

} // namespace

TEST_CASE("What the verbs tell of work in plain words is as it was looked at") {
  const TemporaryFolder folder;
  addClip(folder);
  test::compareWithRecord(
      "plain-tellings",
      tellings(
          {"exaggerate IN/dummy.glb -o IN/punch.glb --limb left-arm --range 21:27 --scale 3 --overshoot 0.3",
           "exaggerate IN/punch.glb -o IN/two.glb --limb right-arm --range 30:40 --scale 2 --loops",
           "info IN/two.glb", "check IN/two.glb", "pose IN/dummy.glb -o IN/posed.glb --recipe IN/work.json",
           "info IN/posed.glb", "pose IN/dummy.glb -o IN/planted.glb --pin-feet", "info IN/planted.glb",
           "elastic IN/two.glb -o IN/heavy.glb --limb left-leg --range 0:20 --amount 0.5",
           "info IN/heavy.glb", "trail IN/dummy.glb --limb left-arm --range 21:27",
           "trail IN/two.glb --limb spine --clip Guard",
           "import-clip IN/dummy.glb -o IN/more.glb --from IN/punch.glb --from-clip Guard --name Second",
           "info IN/more.glb", "resave IN/two.glb -o IN/again.gltf",
           "flatten --mass 2 --young 30000 --length 0.5 --width 0.2 --angle 20",
           "compare IN/dummy.glb IN/punch.glb"},
          folder),
      recordTolerance);
}

TEST_CASE("What the verbs tell of sequences and meshes in plain words is as it was looked at") {
  const TemporaryFolder folder;
  test::writeObjFrames(test::shorteningTube(6, 0.15, 0.4, 0.1), folder / "tube", "tube");
  const test::TubePerson person = test::tubePerson({.armsDown = 0.5});
  test::writeMeshFile(folder / "person.gltf", person.positions, person.triangles);
  const std::string measured =
      "compress IN/tube -o IN/measured.glb --bones 3 --stretch measured --stream IN/stream --open-stream";
  test::compareWithRecord(
      "plain-tellings-of-meshes",
      tellings({"compress IN/tube -o IN/tube.glb --bones 4", "info IN/tube.glb", measured,
                "compress IN/tube -o IN/more.glb --append IN/stream", "compare IN/tube IN/tube.glb",
                "compare IN/tube IN/tube --flattening",
                "rig IN/person.gltf -o IN/places.json --locators-only", "rig IN/person.gltf -o IN/rigged.glb",
                "info IN/rigged.glb", "bind IN/person.gltf -o IN/bound.glb --locators IN/places.json",
                "info IN/bound.glb", "info IN/person.gltf"},
               folder),
      recordTolerance);
}

TEST_CASE("What the verbs refuse, and why, is as it was looked at") {
  const TemporaryFolder folder;
  addClip(folder);
  folder.write("broken.json", R"({"version": 1, "trails": [{"limb": "left-arm", "range": [9, 2]}]})");
  folder.write(
      "twice.json",
      R"({"version": 1, "trails": [{"limb": "left-arm", "range": [2, 9], "scale": 2, "scale": 3}]})");
  folder.write("none.json", R"({"version": 1})");
  folder.write("unknown.json",
               R"({"version": 1, "adjustments": [{"controller": "third-hand", "keys": [{"frame": 1}]}]})");
  folder.write("late.json", R"({"version": 1, "pins": [{"limb": "left-leg", "range": [2, 5000]}]})");
  folder.write("table.csv", "controller,frame,move_y\nright-hand,ten,0.2\n");
  folder.write("places.json", R"({"locators": []})");
  std::vector<std::string> lines(std::begin(refused), std::end(refused));
  for (const char* const own : refusedTrails) {
    lines.push_back("exaggerate IN/dummy.glb -o IN/out.glb " + std::string(own));
  }
  test::compareWithRecord("refusals", tellings(lines, folder), recordTolerance);
}
