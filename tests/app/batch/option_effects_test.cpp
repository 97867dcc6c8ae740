// Every option that a verb's help lists has a row here, and does something: with it the answer is another.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/batch/verb.h"
#include "app/schema/locator_json.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/app/file_text.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/app/option_rows.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/report_text.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/boxed_biped.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/obj_frames.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/skinning/tube_person.h"

namespace fs = std::filesystem;
using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::joinedRows;
using test::OptionRow;
using test::rowsBehind;
using test::runVerb;
using test::TemporaryFolder;

namespace {

struct VerbTable {
  std::string verb;
  std::string always; ///< Flags of every line but of those whose row is about them.
  std::vector<OptionRow> rows;
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

/// The options and arguments that the verb's help lists: "--output" of "-o,--output", "FILE" of an argument.
std::set<std::string> optionsInHelp(const std::string& verb) {
  const test::VerbAnswer help = runVerb({verb, "--help"});
  REQUIRE(help.exitCode == 0);
  std::set<std::string> options;
  std::istringstream lines(help.output);
  bool areArguments = false;
  for (std::string line; std::getline(lines, line);) {
    areArguments = line == "Positionals:" || (areArguments && !line.empty());
    const std::vector<std::string> words = wordsOf(line);
    if (line.starts_with("  -")) {
      options.insert(words.front().substr(words.front().find("--")));
    } else if (areArguments && line.starts_with("  ") && line[2] != ' ') {
      options.insert(words.front());
    }
  }
  options.erase("--help");
  return options;
}

/// What one command line leads to.
struct Effect {
  int exitCode = 0;
  std::string output;
  std::string told;
  std::map<std::string, gltf::Bytes> files; ///< In the folder of outputs, by the path in it.
};

/// The report without what the clock says.
std::string withoutSeconds(const std::string& output) {
  Json report = Json::parse(output, nullptr, false);
  if (report.is_discarded() || !report.is_object() || report.erase("seconds") == 0) {
    return test::withoutClock(output);
  }
  return report.dump();
}

Effect effectOf(const std::string& line, const TemporaryFolder& inputs) {
  const TemporaryFolder outputs;
  std::vector<std::string> words = wordsOf(line);
  for (std::string& word : words) {
    word =
        replaced(replaced(word, "IN/", inputs.path().string() + "/"), "OUT/", outputs.path().string() + "/");
  }
  const test::VerbAnswer answer = runVerb(words);
  Effect effect{answer.exitCode,
                replaced(withoutSeconds(answer.output), outputs.path().string(), "OUT"),
                answer.told,
                {}};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(outputs.path())) {
    if (entry.is_regular_file()) {
      effect.files[fs::relative(entry.path(), outputs.path()).string()] = *readFile(entry.path());
    }
  }
  return effect;
}

/// Where both lines write files, the files have to differ: that a report repeats an option is no effect.
bool differs(const Effect& a, const Effect& b, const std::string& option) {
  const bool isOfReport = option.starts_with("--json") || a.files.empty();
  return a.exitCode != b.exitCode || (isOfReport ? a.output != b.output : a.files != b.files);
}

std::string lineOf(const VerbTable& table, const OptionRow& row, const std::string& own) {
  std::string line = table.verb;
  for (const std::string& word : wordsOf(table.always)) {
    line += row.option.starts_with(word) ? "" : ' ' + word;
  }
  return line + ' ' + own;
}

/// All that the command lines of a table lead to.
std::string recordOf(const std::map<std::string, Effect>& known, const TemporaryFolder& inputs) {
  std::string text;
  for (const auto& [line, effect] : known) {
    text += fmt::format("{}\n exit {}\n", line, effect.exitCode);
    text += line.find("--json-line") == std::string::npos ? test::reportText(effect.output) : "";
    text += effect.told;
    for (const auto& [name, bytes] : effect.files) {
      text += test::fileText(name, bytes);
    }
  }
  return replaced(text, inputs.path().string(), "IN");
}

void checkTable(const VerbTable& table, const TemporaryFolder& inputs) {
  std::set<std::string> rows;
  std::map<std::string, Effect> known; // by the words of a line that several rows start from
  for (const OptionRow& row : table.rows) {
    rows.insert(row.option);
    const std::string without = lineOf(table, row, row.without);
    const std::string with = lineOf(table, row, row.with);
    INFO(without << "\n" << with);
    for (const std::string& line : {without, with}) {
      if (!known.contains(line)) {
        known[line] = effectOf(line, inputs);
      }
    }
    INFO(known[without].told << known[with].told);
    // One of the two at least is done: two refusals in other words prove nothing.
    CHECK((known[without].exitCode == 0 || known[with].exitCode == 0));
    CHECK(differs(known[without], known[with], row.option));
  }
  // The same words have the same effect, else a difference would say nothing.
  const std::string last = lineOf(table, table.rows.back(), table.rows.back().with);
  const Effect again = effectOf(last, inputs);
  CHECK(again.output == known[last].output);
  CHECK(again.files == known[last].files);
  CHECK(rows == optionsInHelp(table.verb));
  const std::string difference =
      test::differenceFromRecord("verb-" + table.verb, recordOf(known, inputs), 1e-3);
  INFO(difference);
  CHECK(difference.empty());
}

void copyWithViolation(const fs::path& from, const fs::path& to) {
  const Result<gltf::Loaded> file = gltf::load(from);
  REQUIRE(file);
  gltf::Source source = *file->source;
  (*source.json)["cameras"] = Json::array(); // an empty array, which glTF does not allow
  REQUIRE(gltf::save(source, to));
}

/// The bundled character, and a copy that breaks the specification in a way that can be read.
void addCharacters(const TemporaryFolder& inputs) {
  for (const char* const name : {"dummy.glb", "copy.glb"}) {
    fs::copy_file(test::posedCharacter, inputs / name);
  }
  copyWithViolation(inputs / "dummy.glb", inputs / "odd.glb");
  inputs.write("moduli.json", R"({"segments": [{"from": 0, "to": 0, "young": 5000}]})");
}

/// A person without joints, the same with a violation, and locators of which one is moved.
void addPerson(const TemporaryFolder& inputs) {
  const test::TubePerson person = test::tubePerson({.armsDown = 0.5});
  test::writeMeshFile(inputs / "person.gltf", person.positions, person.triangles);
  fs::copy_file(inputs / "person.gltf", inputs / "copy.gltf");
  copyWithViolation(inputs / "person.gltf", inputs / "odd.glb");
  const std::string places = (inputs / "places.json").string();
  REQUIRE(runVerb({"rig", (inputs / "person.gltf").string(), "-o", places, "--locators-only"}).exitCode == 0);
  Json locators = Json::parse(*readText(places));
  Json& place = locators["locators"][1]["position"];
  place[1] = place[1].get<double>() + 0.03;
  REQUIRE(writeText(places, locators.dump()));
}

/// Two sequences of one tube, that bends and is flattened, and that only bends.
void addSequences(const TemporaryFolder& inputs) {
  test::writeObjFrames(test::shorteningTube(6, 0.15, 0.4, 0.1), inputs / "tube", "tube");
  test::writeObjFrames(test::shorteningTube(6, 0.15, 0.0, 0.0), inputs / "free", "free");
  inputs.write("moduli.json", R"({"segments": [{"from": 0, "to": 0, "young": 5000}]})");
}

/// Rows of every verb that reads a character and writes one. `own`: the words that it needs besides.
std::vector<OptionRow> fileRows(const std::string& file, const std::string& copy, const std::string& own) {
  const std::string in = "IN/" + file + ' ' + own;
  const std::string onCopy = "IN/" + copy + " -o IN/" + copy + ' ' + own;
  return {{"FILE", "IN/odd.glb -o OUT/out.glb " + own, in + " -o OUT/out.glb"},
          {"--tolerant", "IN/odd.glb -o OUT/out.glb " + own, "IN/odd.glb -o OUT/out.glb --tolerant " + own},
          {"--output", in + " -o OUT/out.glb", in + " -o OUT/other.glb"},
          {"--in-place", onCopy, onCopy + " --in-place"}};
}

const std::vector<OptionRow> reportRows{{"--json", "", "--json"}, {"--json-line", "", "--json-line"}};

/// What verbs have that key a clip of a character, but the option that only a stretch shows.
const std::vector<OptionRow> clipRows{
    {"--clean", "", "--clean"}, {"--fps", "", "--fps 12"}, {"--plan", "", "--plan quadruped"}};

} // namespace

TEST_CASE("Every option of info, check and trail changes what they tell") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  checkTable({"info", "--json",
              joinedRows({{"FILE", "IN/gone.glb", "IN/dummy.glb"},
                          {"--tolerant", "IN/odd.glb", "IN/odd.glb --tolerant"},
                          {"--plan", "IN/dummy.glb", "IN/dummy.glb --plan quadruped"}},
                         rowsBehind("IN/dummy.glb", reportRows))},
             inputs);
  checkTable({"check", "--json",
              joinedRows({{"FILE", "IN/odd.glb", "IN/dummy.glb"}},
                         rowsBehind("IN/dummy.glb", joinedRows({{"--engine", "", "--engine three,unreal"},
                                                                {"--before", "", "--before IN/copy.glb"}},
                                                               reportRows)))},
             inputs);
  const std::string arm = "IN/dummy.glb --limb left-arm";
  checkTable(
      {"trail", "--json",
       joinedRows({{"FILE", "IN/gone.glb --limb left-arm", arm},
                   {"--tolerant", "IN/odd.glb --limb left-arm", "IN/odd.glb --tolerant --limb left-arm"},
                   {"--limb", arm, "IN/dummy.glb --limb right-arm"}},
                  rowsBehind(arm, joinedRows({{"--plan", "", "--plan quadruped"},
                                              {"--clip", "", "--clip Guard"},
                                              {"--fps", "--range 2:10", "--range 2:10 --fps 12"},
                                              {"--range", "", "--range 20:27"}},
                                             reportRows)))},
      inputs);
}

TEST_CASE("Every option of moments changes what it tells") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  checkTable({"moments", "--json",
              joinedRows({{"FILE", "IN/gone.glb", "IN/dummy.glb"},
                          {"--tolerant", "IN/odd.glb", "IN/odd.glb --tolerant"}},
                         rowsBehind("IN/dummy.glb", joinedRows({{"--plan", "", "--plan quadruped"},
                                                                {"--clip", "", "--clip Guard"},
                                                                {"--fps", "", "--fps 12"},
                                                                {"--all-clips", "", "--all-clips"}},
                                                               reportRows)))},
             inputs);
}

TEST_CASE("Every option of exaggerate changes the keys that it writes") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  inputs.write("recipe.json",
               R"({"version": 1, "trails": [{"limb": "right-arm", "range": [21, 27], "scale": 2}]})");
  const std::string file = "IN/dummy.glb -o OUT/out.glb";
  const std::string arm = "--limb left-arm --range 21:27";
  fs::copy_file(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb", inputs / "leap.glb");
  checkTable(
      {"exaggerate", "--json --clean",
       joinedRows(
           joinedRows(fileRows("dummy.glb", "copy.glb", arm + " --scale 2"), test::styleRows()),
           rowsBehind(
               file,
               joinedRows(
                   {{"--recipe", arm + " --scale 2", "--recipe IN/recipe.json"},
                    {"--limb", arm + " --scale 2", "--limb right-arm --range 21:27 --scale 2"},
                    {"--range", "--limb left-arm --scale 2", "--limb left-arm --range 20:27 --scale 2"},
                    {"--scale", arm + " --scale 2", arm + " --scale 3"},
                    {"--loops", "--limb left-arm --scale 2 --range 45:58 --release 10",
                     "--limb left-arm --scale 2 --range 45:58 --release 10 --loops"},
                    {"--no-pull", arm + " --scale 0.3 --axes x", arm + " --scale 0.3 --axes x --no-pull"},
                    {"--stay-in-world", "--limb spine --range 21:27 --scale 2 " + arm + " --scale 1.5",
                     "--limb spine --range 21:27 --scale 2 " + arm + " --scale 1.5 --stay-in-world"}},
                   rowsBehind(
                       arm + " --scale 2",
                       joinedRows({{"--axes", "", "--axes xz"},
                                   {"--pivot", "", "--pivot end"},
                                   {"--turn-limit", "", "--turn-limit 5"},
                                   {"--ease-in", "", "--ease-in 0.5,0.2"},
                                   {"--ease-out", "", "--ease-out 0.3,0.5"},
                                   {"--remap", "", "--remap linear"},
                                   {"--bend", "", "--bend straighten"},
                                   {"--blend", "", "--blend 1"},
                                   {"--switch", "", "--switch 0.5"},
                                   {"--volume", "", "--volume 0"},
                                   {"--turn-end", "", "--turn-end"},
                                   {"--release", "", "--release 12"},
                                   {"--linger", "", "--linger 2"},
                                   {"--overshoot", "", "--overshoot 0.5"},
                                   {"--space", "", "--space base"},
                                   {"--reference", "", "--reference rest"},
                                   {"--as-seen", "--camera front", "--camera front --as-seen"},
                                   {"--camera", "--as-seen --camera front", "--as-seen --camera side"},
                                   {"--no-keep-depth", "--as-seen --camera front",
                                    "--as-seen --camera front --no-keep-depth"},
                                   {"--turn-to-view", "--camera front", "--camera front --turn-to-view 20"},
                                   {"--clip", "", "--clip Guard"},
                                   {"--keep-skeleton", "", "--keep-skeleton"},
                                   {"--form", "", "--form volume"},
                                   {"--influences", "--form volume", "--form volume --influences 4"},
                                   {"--key-frames", "", "--key-frames whole"},
                                   {"--key-frames", "--release 30", "--release 30 --key-frames every"},
                                   {"--key-every-frame", "--release 30", "--release 30 --key-every-frame"}},
                                  joinedRows(clipRows, reportRows))))))},
      inputs);
}

TEST_CASE("Every option of elastic changes the keys that it writes") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  const std::string arm = "--limb left-arm --clip Guard";
  checkTable(
      {"elastic", "--json --clean",
       joinedRows(
           fileRows("dummy.glb", "copy.glb", arm),
           rowsBehind("IN/dummy.glb -o OUT/out.glb",
                      joinedRows({{"--limb", arm, "--limb right-arm --clip Guard"},
                                  {"--clip", "--limb left-arm", arm},
                                  {"--key-every-frame", "--limb left-arm --range 10:30 --amount 0.1",
                                   "--limb left-arm --range 10:30 --amount 0.1 --key-every-frame"},
                                  {"--key-frames", "--limb left-arm --range 10:30 --amount 0.1",
                                   "--limb left-arm --range 10:30 --amount 0.1 --key-frames every"}},
                                 rowsBehind(arm, joinedRows({{"--keep-skeleton", "", "--keep-skeleton"},
                                                             {"--form", "", "--form volume"},
                                                             {"--influences", "--form volume",
                                                              "--form volume --influences 4"},
                                                             {"--range", "", "--range 2:10"},
                                                             {"--amount", "", "--amount 0.5"},
                                                             {"--stiffness", "", "--stiffness 2"},
                                                             {"--damping", "", "--damping 0.2"},
                                                             {"--inertia", "", "--inertia 0.3"},
                                                             {"--gravity", "", "--gravity 0,-5,0"},
                                                             {"--young", "", "--young 1500000"},
                                                             {"--density", "--young 1500000",
                                                              "--young 1500000 --density 1500"},
                                                             {"--moduli", "", "--moduli IN/moduli.json"}},
                                                            joinedRows(clipRows, reportRows))))))},
      inputs);
}

TEST_CASE("Every option of pose changes the keys that it writes") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  test::twoSheets().write(inputs / "sheets.glb");
  inputs.write("recipe.json", R"({"version": 1, "adjustments": [
      {"controller": "left-hand", "range": [2, 16], "keys": [{"frame": 10, "move": [0, 0.3, 0.1]}]}]})");
  inputs.write("low.json", R"({"version": 1, "adjustments": [
      {"controller": "left-foot", "range": [2, 16], "keys": [{"frame": 10, "move": [0, 0.3, 0.1]}]}]})");
  inputs.write("stretched.json", R"({"version": 1, "adjustments": [
      {"controller": "left-hand", "keys": [{"frame": 10, "move": [0.3, 2, 0.1]}]},
      {"attribute": "left-arm.stretch", "keys": [{"frame": 0, "value": 1}]}]})");
  inputs.write("table.csv", "controller,frame,move_y\nright-hand,10,0.2\n");
  inputs.write("guard.json", test::raisedHandPose);
  const std::string recipe = "--recipe IN/recipe.json";
  const std::string guard = "--pose IN/guard.json --pose-frame 10";
  const std::string prop = "--prop IN/sheets.glb";
  checkTable(
      {"pose", "--json --clean",
       joinedRows(
           fileRows("dummy.glb", "copy.glb", recipe),
           rowsBehind(
               "IN/dummy.glb -o OUT/out.glb",
               joinedRows(
                   {{"--recipe", "--pin-feet", "--pin-feet " + recipe},
                    {"--offsets", recipe, recipe + " --offsets IN/table.csv"},
                    {"--units", "--offsets IN/table.csv", "--offsets IN/table.csv --units metres"},
                    {"--clip", recipe, recipe + " --clip Guard"},
                    {"--key-every-frame", recipe, recipe + " --key-every-frame"},
                    {"--key-frames", "--recipe IN/low.json --pin-feet",
                     "--recipe IN/low.json --pin-feet --key-frames whole"},
                    {"--pin-feet", "--recipe IN/low.json", "--recipe IN/low.json --pin-feet"},
                    {"--pose", recipe, recipe + ' ' + guard},
                    {"--pose-frame", guard, "--pose IN/guard.json --pose-frame 12"},
                    {"--pose-range", guard, guard + " --pose-range 2:16"},
                    {"--pose-amount", guard, guard + " --pose-amount 0.5"},
                    {"--pose-mirrored", guard, guard + " --pose-mirrored"},
                    {"--prop", recipe, recipe + ' ' + prop},
                    {"--prop-hand", prop, prop + " --prop-hand left-arm"},
                    {"--prop-frame", prop, prop + " --prop-frame 24"},
                    {"--keep-skeleton", "--recipe IN/stretched.json",
                     "--recipe IN/stretched.json --keep-skeleton"},
                    {"--form", "--recipe IN/stretched.json", "--recipe IN/stretched.json --form volume"},
                    {"--influences", "--recipe IN/stretched.json --form volume",
                     "--recipe IN/stretched.json --form volume --influences 4"}},
                   rowsBehind(recipe, joinedRows(clipRows, reportRows)))))},
      inputs);
}

TEST_CASE("Every option of import-clip and resave changes the file that they write") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  const std::string from = "--from IN/other.glb";
  fs::copy_file(test::posedCharacter, inputs / "other.glb");
  const std::string one = from + " --from-clip Guard";
  const std::string crossing = "--from " + test::crossingArms(inputs / "crossing.glb");
  // Work that an import saves again shows what its keys are made by.
  REQUIRE(runVerb({"exaggerate", (inputs / "dummy.glb").string(), "-o", (inputs / "worked.glb").string(),
                   "--limb", "left-arm", "--range", "0:27", "--scale", "2"})
              .exitCode == 0);
  const std::vector<OptionRow> ofImport = joinedRows(
      fileRows("dummy.glb", "copy.glb", from),
      rowsBehind("IN/dummy.glb -o OUT/out.glb", joinedRows({{"--from", "--from IN/gone.glb", from},
                                                            {"--from-clip", from, one},
                                                            {"--name", one, one + " --name other"},
                                                            {"--touch", crossing, crossing + " --touch 0"}},
                                                           rowsBehind(from, reportRows))));
  const std::vector<OptionRow> ofWork =
      rowsBehind("IN/worked.glb -o OUT/out.glb " + one,
                 {{"--clean", "", "--clean"},
                  {"--keep-skeleton", "", "--keep-skeleton"},
                  {"--form", "", "--form volume"},
                  {"--influences", "--form volume", "--form volume --influences 4"},
                  {"--key-frames", "", "--key-frames whole"},
                  {"--key-every-frame", "", "--key-every-frame"}});
  checkTable({"import-clip", "--json --clean", joinedRows(ofImport, ofWork)}, inputs);
  checkTable({"resave", "", fileRows("dummy.glb", "copy.glb", "")}, inputs);
}

TEST_CASE("Every option of rig changes what it writes") {
  const TemporaryFolder inputs;
  addPerson(inputs);
  checkTable(
      {"rig", "--json",
       joinedRows(fileRows("person.gltf", "copy.gltf", "--locators IN/places.json"),
                  joinedRows({{"--locators-only", "IN/person.gltf -o OUT/out.glb",
                               "IN/person.gltf -o OUT/out.json --locators-only"}},
                             rowsBehind("IN/person.gltf -o OUT/out.glb",
                                        joinedRows({{"--locators", "", "--locators IN/places.json"},
                                                    {"--plan", "--plan worm", "--plan biped"}},
                                                   rowsBehind("--locators IN/places.json", reportRows)))))},
      inputs);
}

TEST_CASE("Every option of bind changes what it writes") {
  const TemporaryFolder inputs;
  addPerson(inputs);
  addSequences(inputs);
  fs::remove(inputs / "odd.glb");
  REQUIRE(
      runVerb({"compress", (inputs / "tube").string(), "-o", (inputs / "tube.glb").string(), "--bones", "3"})
          .exitCode == 0);
  fs::copy_file(inputs / "tube.glb", inputs / "copy.glb");
  copyWithViolation(inputs / "tube.glb", inputs / "odd.glb");
  const std::string surface = "--keep-joints --weights surface";
  const std::string tube = "IN/tube.glb -o OUT/out.glb ";
  const std::string person = "IN/person.gltf -o OUT/out.glb ";
  checkTable({"bind", "--json",
              joinedRows(fileRows("tube.glb", "copy.glb", surface),
                         joinedRows({{"--keep-joints", tube, tube + surface},
                                     {"--weights", tube + surface, tube + "--keep-joints"},
                                     {"--locators", person, person + "--locators IN/places.json"},
                                     {"--plan", person + "--plan spider", person + "--plan biped"}},
                                    rowsBehind(tube + surface, reportRows)))},
             inputs);
}

TEST_CASE("Every option of compress changes the files that it writes") {
  const TemporaryFolder inputs;
  addSequences(inputs);
  REQUIRE(runVerb({"compress", (inputs / "tube").string(), "-o", (inputs / "skeleton.glb").string(),
                   "--bones", "4", "--stretch", "measured", "--joints", "tree", "--stream",
                   (inputs / "stream").string(), "--open-stream"})
              .exitCode == 0);
  fs::copy_file(inputs / "skeleton.glb", inputs / "copy.glb");
  fs::copy_file(STRETCH_SOURCE_DIR "/assets/dummy.glb", inputs / "dummy.glb");
  const std::string few = "--bones 3";
  const std::string measured = few + " --stretch measured";
  checkTable(
      {"compress", "--json",
       joinedRows(
           {{"SEQUENCE", "IN/free -o OUT/out.glb --bones 3", "IN/tube -o OUT/out.glb --bones 3"},
            {"--output", "IN/tube -o OUT/out.glb --bones 3", "IN/tube -o OUT/other.glb --bones 3"},
            {"--clip", "IN/dummy.glb -o OUT/out.glb --bones 3",
             "IN/dummy.glb -o OUT/out.glb --bones 3 --clip #1"},
            {"--in-place", "IN/copy.glb -o IN/copy.glb --bones 3",
             "IN/copy.glb -o IN/copy.glb --bones 3 --in-place"}},
           rowsBehind(
               "IN/tube -o OUT/out.glb",
               joinedRows({{"--bones", few, "--bones 4"},
                           {"--tolerance", few, "--tolerance 3"},
                           {"--append", few, "--append IN/stream"},
                           {"--joints", measured, measured + " --joints free"},
                           {"--influences", "--bones 8 --stretch measured --weights fitted",
                            "--bones 8 --stretch measured --weights fitted --influences 8"},
                           {"--scale-limit", measured, measured + " --scale-limit 1.01"},
                           {"--open-stream", few + " --stream OUT/s", few + " --stream OUT/s --open-stream"}},
                          rowsBehind(few, joinedRows({{"--stretch", "", "--stretch none"},
                                                      {"--weights", "", "--weights geodesic"},
                                                      {"--length", "", "--length monotone"},
                                                      {"--skip", "", "--skip 1"},
                                                      {"--young", "", "--young 150000"},
                                                      {"--mass", "--young 150000", "--young 150000 --mass 3"},
                                                      {"--metres-per-unit", "--young 150000",
                                                       "--young 150000 --metres-per-unit 0.5"},
                                                      {"--gravity", "--young 150000",
                                                       "--young 150000 --gravity 0,-5,0"},
                                                      {"--quantise", "", "--quantise"},
                                                      {"--quantise-mesh", "", "--quantise-mesh"},
                                                      {"--meshopt", "", "--meshopt"},
                                                      {"--key-tolerance", "", "--key-tolerance 1"},
                                                      {"--skeleton", "", "--skeleton IN/skeleton.glb"},
                                                      {"--moduli", "", "--moduli IN/moduli.json"},
                                                      {"--curvature", "", "--curvature OUT/table.csv"},
                                                      {"--stream", "", "--stream OUT/s"},
                                                      {"--fps", "", "--fps 12"}},
                                                     reportRows)))))},
      inputs);
}

TEST_CASE("Every option of compare and flatten changes what they tell") {
  const TemporaryFolder inputs;
  addSequences(inputs);
  const std::string pair = "IN/tube IN/free";
  fs::copy_file(test::posedCharacter, inputs / "dummy.glb");
  checkTable(
      {"compare", "--json",
       joinedRows({{"FILES", "IN/tube IN/tube", pair},
                   {"--clip", "IN/dummy.glb IN/dummy.glb", "IN/dummy.glb IN/dummy.glb --clip Guard"}},
                  rowsBehind(pair, joinedRows({{"--flattening", "", "--flattening"},
                                               {"--gravity", "--flattening", "--flattening --gravity 0,-5,0"},
                                               {"--mass", "--flattening", "--flattening --mass 3"},
                                               {"--metres-per-unit", "--flattening",
                                                "--flattening --metres-per-unit 0.5"},
                                               {"--sted-rings", "", "--sted-rings 2"},
                                               {"--sted-window", "", "--sted-window 5"},
                                               {"--sted-dt", "", "--sted-dt 0.5"},
                                               {"--sted-c", "", "--sted-c 2"}},
                                              reportRows)))},
      inputs);
  const std::string worm = "--mass 2e-9 --young 3770 --length 0.88e-3 --width 0.085e-3";
  checkTable({"flatten", "--json",
              joinedRows({{"--mass", worm, replaced(worm, "2e-9", "1e-9")},
                          {"--young", worm, replaced(worm, "3770", "5000")},
                          {"--length", worm, replaced(worm, "0.88e-3", "0.8e-3")},
                          {"--width", worm, replaced(worm, "0.085e-3", "0.08e-3")}},
                         rowsBehind(worm, joinedRows({{"--angle", "", "--angle 30"},
                                                      {"--metres-per-unit", "", "--metres-per-unit 0.5"}},
                                                     reportRows)))},
             inputs);
}

TEST_CASE("Every option of styles changes what it tells or writes") {
  const TemporaryFolder inputs;
  addCharacters(inputs);
  for (const auto& [from, to] : {std::pair{"dummy.glb", "worked.glb"}, {"odd.glb", "odd-work.glb"}}) {
    REQUIRE(runVerb({"exaggerate", (inputs / from).string(), "--tolerant", "-o", (inputs / to).string(),
                     "--limb", "left-arm", "--range", "21:27", "--scale", "2"})
                .exitCode == 0);
  }
  const std::string take = "--take IN/worked.glb";
  checkTable({"styles", "--json",
              joinedRows({{"--style", "", "--style Subtle"},
                          {"--take", "--style Subtle", take},
                          {"--tolerant", "--take IN/odd-work.glb", "--take IN/odd-work.glb --tolerant"},
                          {"--output", take + " -o OUT/mine.json", take + " -o OUT/other.json"},
                          {"--plan", take, take + " --plan other"},
                          {"--name", take, take + " --name Mine"},
                          {"--clip", take, take + " --clip Guard"}},
                         rowsBehind(take, reportRows))},
             inputs);
}

TEST_CASE("Every verb has a table of its options") {
  const std::set<std::string> tables{"info",       "check",   "trail",    "moments", "styles",
                                     "exaggerate", "elastic", "pose",     "rig",     "import-clip",
                                     "resave",     "bind",    "compress", "compare", "flatten"};
  std::set<std::string> verbs;
  std::ranges::transform(batchVerbs(), std::inserter(verbs, verbs.end()), &Verb::name);
  CHECK(tables == verbs);
}
