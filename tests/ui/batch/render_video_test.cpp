// What `render` asks ffmpeg for, and what it says of its answer.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"
#include "ui/batch/render_verb.h"

using namespace stretch;
namespace fs = std::filesystem;

namespace {

/// A program that stands in for ffmpeg and keeps the words that it was called with.
class StandInFfmpeg {
public:
  /// `rest`: what its shell does then; the name of the video is in "$last".
  explicit StandInFfmpeg(const std::string& rest = "exec cat >\"${last#file:}\"\n") {
    const fs::path program = folder_.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"" +
                                                         (folder_ / "words.txt").string() + "\"\n" + rest);
    fs::permissions(program, fs::perms::owner_all);
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  StandInFfmpeg(const StandInFfmpeg&) = delete;
  StandInFfmpeg& operator=(const StandInFfmpeg&) = delete;
  ~StandInFfmpeg() { setenv("PATH", path_.c_str(), 1); }

  [[nodiscard]] std::string words() const { return readText(folder_ / "words.txt").value(); }

private:
  const std::string path_ = std::getenv("PATH");
  const test::TemporaryFolder folder_;
};

/// A video of the bundled punch, which has frames 0 to 60 at 24 a second.
test::VerbAnswer videoOfPunch(const fs::path& video, const std::vector<std::string>& more) {
  std::vector<std::string> words{"render", STRETCH_SOURCE_DIR "/assets/dummy.glb", "--video", video.string()};
  words.insert(words.end(), more.begin(), more.end());
  return test::runVerb(words, {ui::renderVerb()});
}

} // namespace

TEST_CASE(
    "A video without frames shows each frame of the clip once, and one of every second frame is as fast") {
  const test::TemporaryFolder folder;
  const StandInFfmpeg ffmpeg;
  constexpr std::uintmax_t bytesOfPicture = 4 * 32 * 16;
  REQUIRE(videoOfPunch(folder / "whole.mp4", {"--size", "32x16"}).exitCode == 0);
  CHECK(fs::file_size(folder / "whole.mp4") == 61 * bytesOfPicture);
  CHECK_THAT(ffmpeg.words(), Catch::Contains("-video_size 32x16 -framerate 24 -i pipe:0"));
  REQUIRE(videoOfPunch(folder / "half.mp4", {"--size", "32x16", "--frames", "10:20:2"}).exitCode == 0);
  CHECK(fs::file_size(folder / "half.mp4") == 6 * bytesOfPicture);
  CHECK_THAT(ffmpeg.words(), Catch::Contains("-framerate 12 -i pipe:0"));
}

TEST_CASE(
    "Of a video that ffmpeg could not write the first line of its complaint is told, and nothing is left") {
  const test::TemporaryFolder folder;
  const StandInFfmpeg ffmpeg(
      "cat > /dev/null\necho 'Unknown encoder' >&2\necho 'Conversion failed' >&2\nexit 1\n");
  const test::VerbAnswer answer = videoOfPunch(folder / "punch.mp4", {"--size", "32x16", "--frames", "0:1"});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told, Catch::Contains("punch.mp4: ffmpeg could not write it: Unknown encoder; choose") &&
                              !Catch::Contains("Conversion failed"));
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("That a video of an odd width or height becomes a line larger is told, but not of a GIF") {
  const test::TemporaryFolder folder;
  const StandInFfmpeg ffmpeg;
  struct Row {
    std::string name, size;
    bool isTold;
  };
  for (const Row& row :
       {Row{"a.mp4", "33x32", true}, Row{"a.mp4", "32x33", true}, Row{"a.webm", "33x33", true},
        Row{"a.mp4", "32x32", false}, Row{"a.gif", "33x33", false}}) {
    CAPTURE(row.name, row.size);
    const test::VerbAnswer answer = videoOfPunch(folder / row.name, {"--size", row.size, "--frames", "0:1"});
    CHECK(answer.exitCode == 0);
    const std::string warning = "a line of pixels is added to " + row.size;
    CHECK((answer.told.find(warning) != std::string::npos) == row.isTold);
  }
}
