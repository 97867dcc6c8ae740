// Frames that `render` is asked for: a series of them stands whole or not at all.
#include <filesystem>
#include <string>
#include <vector>

#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "core/base/file_series.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"
#include "ui/batch/film.h"
#include "ui/batch/render_verb.h"
#include "ui/render/picture/image_edits.h"

using namespace stretch;
namespace fs = std::filesystem;

namespace {

const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb"; // its first clip ends at frame 60

test::VerbAnswer rendered(std::vector<std::string> words) {
  words.insert(words.begin(), {"render", dummy, "--size", "33x32"});
  return test::runVerb(words, {ui::renderVerb()});
}

} // namespace

TEST_CASE("A series of which one picture cannot be written leaves none, and what was there stays") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "s.png").string();
  folder.write("s-0000.png", "of before");
  SECTION("told before anything is drawn") {
    fs::create_directories(folder / "s-0002.png");
    const test::VerbAnswer answer = rendered({"-o", output, "--frames", "0:3"});
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains("s-0002.png: is a folder"));
    CHECK(folder.fileCount() == 1);
  }
  SECTION("when the last has no place") {
    fs::create_directories(folder / "s-0001.png/inside");
    FileSeries series(folder.path());
    CHECK(series.add(folder / "s-0000.png", Bytes{1}));
    CHECK(series.add(folder / "s-0002.png", Bytes{2}));
    CHECK(series.add(folder / "s-0001.png", Bytes{3}));
    CHECK_FALSE(series.finish());
    fs::remove_all(folder / "s-0001.png");
  }
  SECTION("when it is stopped, with more files than may be open at a time") {
    rlimit before{};
    REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
    const rlimit few{64, before.rlim_max};
    REQUIRE(setrlimit(RLIMIT_NOFILE, &few) == 0);
    {
      FileSeries series(folder.path());
      for (int i = 0; i < 100; ++i) {
        REQUIRE(series.add(folder / ("s-" + std::to_string(i) + ".png"), Bytes{1}));
      }
      removeLeftParts(folder.path());
      CHECK(folder.fileCount() == 101);
    }
    REQUIRE(setrlimit(RLIMIT_NOFILE, &before) == 0);
  }
  CHECK(readText(folder / "s-0000.png").value() == "of before");
  CHECK(folder.fileCount() == 1);
  fs::remove(folder / "s-0002.png");
  CHECK(rendered({"-o", output, "--frames", "0:3"}).exitCode == 0);
  CHECK(folder.fileCount() == 4);
  CHECK(ui::readImage(folder / "s-0000.png"));
}

TEST_CASE("render refuses frames that the clip does not have, and a video of one frame") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "s.png").string();
  const auto refused = [&](std::vector<std::string> words, int exitCode) {
    words.insert(words.end(), {"-o", output});
    const test::VerbAnswer answer = rendered(words);
    CHECK(answer.exitCode == exitCode);
    return answer.told;
  };
  CHECK_THAT(refused({"--frame", "999"}, 1),
             Catch::Contains("One-two punch: there is no frame 999; give frames from 0 to 60"));
  CHECK_THAT(refused({"--frame", "-5"}, 1), Catch::Contains("there is no frame -5"));
  CHECK_THAT(refused({"--frames", "55:70"}, 1), Catch::Contains("there is no frame 61"));
  CHECK_THAT(refused({"--sheet", "--frames", "100:200"}, 1), Catch::Contains("there is no frame 100"));
  CHECK_THAT(rendered({"--video", (folder / "one.mp4").string(), "--frame", "5"}).told,
             Catch::Contains("--video excludes --frame"));
  CHECK(folder.fileCount() == 0);
  CHECK(rendered({"-o", output, "--frame", "60"}).exitCode == 0);
}

TEST_CASE("A series of parts of frames holds its last one, and each picture has a name of its own") {
  const Result<std::vector<double>> frames = ui::parseFrames("0:0.3:0.1"); // 0.3 / 0.1 is a little under 3.
  REQUIRE(frames);
  CHECK(frames->size() == 4);
  CHECK(frames->back() == Approx(0.3));
  CHECK(ui::numberedName("a/s.png", 2.0) == "a/s-0002.png");
  CHECK(ui::numberedName("a/s.png", 2.5) == "a/s-0002.500.png");
}

TEST_CASE("A series steps forwards, over a hundred thousand and one pictures at most") {
  CHECK_FALSE(ui::parseFrames("0:3:0"));
  CHECK_FALSE(ui::parseFrames("0:3:-1"));
  CHECK_FALSE(ui::parseFrames("3:0"));
  CHECK(ui::parseFrames("5:5").value() == std::vector<double>{5.0});
  CHECK(ui::parseFrames("1:6:2").value() == std::vector<double>{1.0, 3.0, 5.0});
  CHECK(ui::parseFrames("0:100000").value().size() == 100001);
  const Result<std::vector<double>> tooMany = ui::parseFrames("0:100001");
  REQUIRE_FALSE(tooMany);
  CHECK_THAT(tooMany.error().line(), Catch::Contains("100002 pictures are too many"));
}

TEST_CASE("A picture has 16 to 8192 pixels along each side") {
  const test::TemporaryFolder folder;
  constexpr int noSuchFile = 1;
  constexpr int wrongArgument = 2;
  for (const auto& [size, exitCode] : std::vector<std::pair<std::string, int>>{{"16x16", noSuchFile},
                                                                               {"8192x16", noSuchFile},
                                                                               {"16x8192", noSuchFile},
                                                                               {"15x16", wrongArgument},
                                                                               {"16x15", wrongArgument},
                                                                               {"8193x16", wrongArgument},
                                                                               {"16x8193", wrongArgument},
                                                                               {"16", wrongArgument},
                                                                               {"16x", wrongArgument},
                                                                               {"16x16x16", wrongArgument}}) {
    CAPTURE(size);
    const std::string output = (folder / "r.png").string();
    CHECK(test::runVerb({"render", "none.glb", "-o", output, "--size", size}, {ui::renderVerb()}).exitCode ==
          exitCode);
  }
}

TEST_CASE("render looks at the place of a picture or a video before it draws") {
  const test::TemporaryFolder folder;
  const auto told = [&](const std::vector<std::string>& words) {
    const test::VerbAnswer answer = rendered(words);
    CHECK(answer.exitCode == 1);
    return answer.told;
  };
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"-o", (folder / "missing/r.png").string()},
        {"-o", (folder / "missing/r.png").string(), "--frames", "0:20"},
        {"--video", (folder / "missing/r.mp4").string()}}) {
    CHECK_THAT(told(words),
               Catch::EndsWith("missing: there is no such folder; make it, or save elsewhere\n"));
  }
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("render takes what no file can make right for a wrong argument") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "r.png").string();
  for (const auto& [words, reason] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"-o", (folder / "r.jpg").string()}, "r.jpg: the name of a picture has to end in .png"},
           {{"--video", (folder / "r.avi").string()}, "the name of a video ends in .mp4, .webm or .gif"},
           {{"-o", output, "--frame", "soon"}, "--frame: 'soon' is not a number"},
           {{"-o", output, "--frames", "5-1"}, "--frames: '5-1' is not a range"},
           {{"-o", output, "--size", "8x8"}, "--size: '8x8' is not a size"},
           {{"-o", output, "--view", "behind"}, "--view: there is no view 'behind'"},
           {{"-o", output, "--sheet", "--beside", "b.glb"},
            "--sheet: a contact sheet is one picture of one file"},
           {{"--video", (folder / "r.mp4").string(), "--stages"}, "--stages: the stages are one picture"}}) {
    INFO(reason);
    std::vector<std::string> line{"render", "none.glb"};
    line.insert(line.end(), words.begin(), words.end());
    const test::VerbAnswer answer = test::runVerb(line, {ui::renderVerb()});
    CHECK(answer.exitCode == 2);
    CHECK_THAT(answer.told, Catch::Contains(reason));
  }
  CHECK(folder.fileCount() == 0);
}
