#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;
using test::nodeOf;
using test::openedFile;
using test::posedCharacter;

namespace {

struct Tabled {
  test::VerbAnswer answer;
  std::string path;
};

/// The verb `pose` with a table of this name and text.
Tabled poseByTable(const test::TemporaryFolder& folder, const std::string& name, const std::string& text,
                   const std::vector<std::string>& more = {}) {
  const std::string table = folder.write(name, text).string();
  Tabled tabled{{}, (folder / "posed.glb").string()};
  std::vector<std::string> words{"pose",      posedCharacter, "-o",      tabled.path,
                                 "--offsets", table,          "--units", "metres"};
  words.insert(words.end(), more.begin(), more.end());
  tabled.answer = test::runVerb(words);
  return tabled;
}

/// Two keys of the hips, a fist, an offset of the hand that ends inside the clip.
const std::string csvTable = "controller,frame,move_x,move_y,move_z,turn_y,value,interpolation,first,last\r\n"
                             "hips,24,0,-0.2,0.1,10,,flat,,\r\n"
                             "hips,12,0,-0.1,0,,,,,\r\n"
                             "\r\n"
                             "left-hand.curl,12,,,,,1,,,\r\n"
                             "\"left-hand\",12,0.1,,,,,linear,6,18\r\n";

} // namespace

TEST_CASE("a table of offset keys poses as the recipe with the same keys does") {
  const test::TemporaryFolder folder;
  const Tabled tabled = poseByTable(folder, "offsets.csv", csvTable, {"--clean"});
  REQUIRE(tabled.answer.exitCode == 0);
  const test::TemporaryFolder other;
  const Json hips = {
      {{"frame", 12}, {"move", {0, -0.1, 0}}},
      {{"frame", 24}, {"move", {0, -0.2, 0.1}}, {"turn", {0, 10, 0}}, {"interpolation", "flat"}}};
  const Json hand = {{{"frame", 12}, {"move", {0.1, 0, 0}}, {"interpolation", "linear"}}};
  const Json recipe{{"version", 1},
                    {"units", "metres"},
                    {"adjustments",
                     {{{"controller", "hips"}, {"keys", hips}},
                      {{"attribute", "left-hand.curl"}, {"keys", {{{"frame", 12}, {"value", 1}}}}},
                      {{"controller", "left-hand"}, {"range", {6, 18}}, {"keys", hand}}}}};
  const test::Posed posed = test::pose(other, recipe, {"--clean"});
  REQUIRE(posed.answer.exitCode == 0);
  CHECK(*readFile(tabled.path) == *readFile(posed.path));
}

TEST_CASE("a table as spreadsheets write it says the same: with a mark at its start, quotes and blanks") {
  const test::TemporaryFolder folder;
  const Tabled plain = poseByTable(folder, "plain.csv",
                                   "controller,frame,turn_x,turn_y,turn_z\n"
                                   "hips,12,5,10,15\n",
                                   {"--clean"});
  REQUIRE(plain.answer.exitCode == 0);
  const test::TemporaryFolder other;
  const Tabled written = poseByTable(other, "written.csv",
                                     "\xef\xbb\xbf\"controller\", frame ,\"turn_z\",turn_x,turn_y\r\n"
                                     " \t\r\n"
                                     "\"hips\",\"12\", 15,\t5 ,10\r\n",
                                     {"--clean"});
  INFO(written.answer.told);
  REQUIRE(written.answer.exitCode == 0);
  CHECK(*readFile(written.path) == *readFile(plain.path));
}

TEST_CASE("a table may be a list in JSON and stand beside a recipe") {
  const test::TemporaryFolder folder;
  const Json recipe{
      {"version", 1},
      {"units", "metres"},
      {"adjustments", {{{"controller", "hips"}, {"keys", {{{"frame", 0}, {"move", {0.1, 0, 0}}}}}}}}};
  const std::string recipeFile = folder.write("recipe.json", recipe.dump()).string();
  const Json table{{{"controller", "body"}, {"frame", 0}, {"move", {0, 0, 0.3}}}};
  const Tabled tabled =
      poseByTable(folder, "offsets.json", table.dump(), {"--recipe", recipeFile, "--json", "--clean"});
  REQUIRE(tabled.answer.exitCode == 0);
  const Json report = Json::parse(tabled.answer.output);
  CHECK(report["controllers"].size() == 2);
  const Document source = openedFile(posedCharacter);
  const Vec3 moved =
      nodeOf(openedFile(tabled.path), source.body.hips, 30) - nodeOf(source, source.body.hips, 30);
  CHECK(glm::length(moved - Vec3(0.1, 0.0, 0.3)) < 1e-4 * source.body.height);
}

TEST_CASE("a row that cannot be taken is told by its number in one line, and nothing is written") {
  const std::string head = "controller,frame,move_x,move_y,move_z,value\n";
  const std::string good = "hips,3,0,0.1,0,\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {head + good + "third-hand,12,0,0,0,\n",
       "row 3: controller: the character has no controller 'third-hand'"},
      {head + good + "hips,12,nan,0,0,\n", "row 3: move_x: 'nan' is not a number"},
      {head + good + "hips,12,inf,0,0,\n", "row 3: move_x: 'inf' is not a number"},
      {head + good + "hips,12,1e9,0,0,\n", "row 3: hips: the offset at frame 12 is out of proportion"},
      {head + good + "hips,1e9,0,0,0,\n", "row 3: hips: the key at frame 1e+09 lies outside"},
      {head + good + "hips,twelve,0,0,0,\n", "row 3: frame: 'twelve' is not a number"},
      {head + good + "hips,3,0,0.2,0,\n", "row 3: there is a key of hips at frame 3 already"},
      {head + good + "left-knee,12,0,0,0,7\n", "row 3: value: is not a part of a controller's key"},
      {head + good + "left-hand.curl,12,,,,1e9\n",
       "row 3: left-hand.curl: the value at frame 12 is out of proportion"},
      {head + good + "left-hand.curl,12,,,,\n", "row 3: "},
      {head + good + "hips,12,0,0,0,,9\n", "row 3: has 7 cells under 6 columns"},
      {head + good + ",12,0,0,0,\n", "row 3: names no controller"},
      {"controller,frame,colour\nhips,0,red\n", "row 1: 'colour' is not a column"},
      {"hips,0,0,0.1,0\n", "row 1: 'hips' is not a column"},
      {"frame,move_x\n0,1\n", "row 1: the table has no head"},
      {"controller,move_x\nhips,1\n", "row 1: the table has no head"},
      {"controller,frame,frame\nhips,0,1\n", "row 1: the column 'frame' stands there twice"},
      {head + "\n \n" + good + "hips,12,\"0,5\",0,0,\n", "row 5: move_x: '0,5' is not a number"},
      {head + "\"the \"\"hips\"\"\",3,0,0,0,\n",
       "row 2: controller: the character has no controller 'the \"hips\"'"},
      {head + good + "hips,3.0005,0,0.2,0,\n", "row 3: there is a key of hips at frame 3.0005 already"},
      {"controller,frame,last\nhips,3,9\n", "row 2: has only one end of a range"},
      {"controller,frame,first\nhips,3,0\n", "row 2: has only one end of a range"},
      {"controller,frame,move_x,interpolation\nhips,3,0,\x80\x7F\n", "offsets.csv: is no UTF-8 text"},
      {head, "holds no keys"},
      {"", "holds no keys"}};
  for (const auto& [table, told] : cases) {
    INFO(table);
    const test::TemporaryFolder folder;
    const Tabled tabled = poseByTable(folder, "offsets.csv", table);
    CHECK(tabled.answer.exitCode == 1);
    CHECK_THAT(tabled.answer.told, Catch::Contains(told));
    CHECK(std::ranges::count(tabled.answer.told, '\n') == 1);
    CHECK(folder.fileCount() == 1);
  }
}

TEST_CASE("a table in JSON that cannot be taken is told by its row, and nothing is written") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[{\"controller\": \"hips\", \"frame\": 0, \"move\": [0, NaN, 0]}]", "is not a list in JSON"},
      {"{\"controller\": \"hips\"}", "is not a list in JSON"},
      {"[{\"controller\": \"hips\", \"frame\": 0}, 7]", "row 2: 7 is not a key"},
      {"[{\"controller\": \"hips\", \"frame\": 0}, {\"controller\": \"tail\", \"frame\": 1}]",
       "row 2: controller: "},
      {"[{\"controller\": \"hips\", \"frame\": 0, \"move\": [0, 1e9, 0]}]", "row 1: hips: "},
      {"[{\"controller\": \"hips\", \"frame\": 0, \"move\": [0, 1]}]", "row 1: move"},
      {"[{\"controller\": 7, \"frame\": 0}]", "row 1: names no controller"}};
  for (const auto& [table, told] : cases) {
    INFO(table);
    const test::TemporaryFolder folder;
    const Tabled tabled = poseByTable(folder, "offsets.json", table);
    CHECK(tabled.answer.exitCode == 1);
    CHECK_THAT(tabled.answer.told, Catch::Contains(told));
    CHECK(std::ranges::count(tabled.answer.told, '\n') == 1);
    CHECK(folder.fileCount() == 1);
  }
}

TEST_CASE("a table beside a recipe whose grips lead in a circle writes nothing, in one line") {
  const test::TemporaryFolder folder;
  const Json grips{{{"leader", "left-arm"}, {"follower", "right-arm"}, {"range", {0, 9}}},
                   {{"leader", "right-arm"}, {"follower", "left-arm"}, {"range", {0, 9}}}};
  const std::string recipe =
      folder.write("recipe.json", Json{{"version", 1}, {"grips", grips}}.dump()).string();
  const Tabled tabled = poseByTable(folder, "offsets.csv", csvTable, {"--recipe", recipe});
  CHECK(tabled.answer.exitCode == 1);
  CHECK_THAT(tabled.answer.told, Catch::Contains("grips lead in a circle"));
  CHECK(std::ranges::count(tabled.answer.told, '\n') == 1);
  CHECK(folder.fileCount() == 2);
}

TEST_CASE(
    "keys of one controller in a table are one adjustment for each range that they name, in order of time") {
  const test::TemporaryFolder folder;
  const Tabled tabled = poseByTable(folder, "offsets.csv",
                                    "controller,frame,move_x,first,last\n"
                                    "left-hand,14,0.1,12,18\n"
                                    "left-hand,6,0.2,2,8\n"
                                    "right-hand,14,0.3,12,18\n"
                                    "left-hand,4,0.4,2,8\n");
  REQUIRE(tabled.answer.exitCode == 0);
  const Document document = openedFile(tabled.path);
  const auto told = [&](const std::string& controller, const Vec2& range) {
    std::vector<std::pair<double, double>> keys;
    for (const rig::Adjustment& adjustment : document.adjustments) {
      if (adjustment.controller == controller && adjustment.rangeFrames == range) {
        for (const rig::OffsetKey& key : adjustment.keys) {
          keys.emplace_back(key.frame, std::round(1000.0 * key.move.x) / 1000.0);
        }
      }
    }
    return keys;
  };
  using Keys = std::vector<std::pair<double, double>>;
  CHECK(document.adjustments.size() == 3);
  CHECK(told("left-hand", Vec2(2.0, 8.0)) == Keys{{4.0, 0.4}, {6.0, 0.2}});
  CHECK(told("left-hand", Vec2(12.0, 18.0)) == Keys{{14.0, 0.1}});
  CHECK(told("right-hand", Vec2(12.0, 18.0)) == Keys{{14.0, 0.3}});
}
