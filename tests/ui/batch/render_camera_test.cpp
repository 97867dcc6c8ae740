// `render` through the file's cameras, and as a video, from the command line.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/base/descriptor.h"
#include "core/base/file.h"
#include "tests/support/app/camera_file.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/temporary_folder.h"
#include "ui/batch/film.h"
#include "ui/batch/render_verb.h"
#include "ui/batch/video_writer.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/text.h"

using namespace stretch;
namespace fs = std::filesystem;

namespace {

test::VerbAnswer render(const std::vector<std::string>& words) {
  std::vector<std::string> all{"render"};
  all.insert(all.end(), words.begin(), words.end());
  return test::runVerb(all, {ui::renderVerb()});
}

Bytes drawn(const std::string& file, const test::TemporaryFolder& folder,
            const std::vector<std::string>& more) {
  const std::string picture = (folder / "out.png").string();
  std::vector<std::string> words{file, "-o", picture, "--size", "160x90"};
  words.insert(words.end(), more.begin(), more.end());
  const test::VerbAnswer answer = render(words);
  INFO(answer.told);
  REQUIRE(answer.exitCode == 0);
  return readFile(picture).value();
}

bool hasFfmpeg() {
  return std::system("ffmpeg -version > /dev/null 2>&1") == 0;
}

} // namespace

TEST_CASE("a picture through the file's camera is another one, and follows the clip that moves it") {
  const test::TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const Bytes side = drawn(file, folder, {"--camera", "Side"});
  CHECK(side == drawn(file, folder, {"--camera", "Front"})); // there at frame 0
  CHECK(side != drawn(file, folder, {"--camera", "Flat"}));
  CHECK(side != drawn(file, folder, {}));
  CHECK(side != drawn(file, folder, {"--camera", "Side", "--safe-frame"}));
  CHECK(drawn(file, folder, {"--camera", "Side", "--frame", "27"}) !=
        drawn(file, folder, {"--camera", "Front", "--frame", "27"}));
}

TEST_CASE(
    "shaded as an engine that turns normals by plain matrices, a stretch told by scale looks otherwise") {
  const test::TemporaryFolder folder;
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const auto punch = [&](const std::string& form) {
    std::string file = (folder / (form + ".glb")).string();
    REQUIRE(test::runVerb({"exaggerate", dummy, "-o", file, "--limb", "left-arm", "--range", "21:27",
                           "--scale", "3", "--form", form})
                .exitCode == 0);
    return file;
  };
  const auto shaded = [&](const std::string& file, const std::string& engine) {
    return drawn(file, folder, {"--frame", "27", "--no-trails", "--shade-as", engine});
  };
  const std::string scaled = punch("scale");
  const Bytes exact = drawn(scaled, folder, {"--frame", "27", "--no-trails"});
  CHECK(shaded(scaled, "exact") == exact);
  CHECK(shaded(scaled, "three") != exact);
  CHECK(shaded(scaled, "godot") == shaded(scaled, "three"));
  const std::string out = (folder / "no.png").string();
  CHECK(render({scaled, "-o", out, "--shade-as", "unity"}).exitCode == 2);
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("a camera or a best view that is not there is refused, and so are a camera and a view at once") {
  const test::TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const std::string out = (folder / "out.png").string();
  const test::VerbAnswer lost = render({file, "-o", out, "--camera", "Shot"});
  CHECK(lost.exitCode == 1);
  CHECK_THAT(lost.told, Catch::Contains("there is no camera 'Shot'") && Catch::Contains("Side, Front, Flat"));
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const test::VerbAnswer bare = render({dummy, "-o", out, "--camera", "Shot"});
  CHECK_THAT(bare.told, Catch::Contains("the file has none"));
  CHECK_THAT(render({file, "-o", out, "--view", "best"}).told, Catch::Contains("there is none"));
  CHECK(render({file, "-o", out, "--camera", "Side", "--view", "top"}).exitCode == 2);
  CHECK(render({file}).exitCode == 2);
  CHECK(render({file, "-o", out, "--video", (folder / "a.mp4").string()}).exitCode == 2);
  CHECK_THAT(render({file, "--video", (folder / "a.avi").string()}).told,
             Catch::Contains(".mp4, .webm or .gif"));
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("the best view of a punch is drawn from where the report says it is") {
  const test::TemporaryFolder folder;
  const std::string recipe =
      folder
          .write("punch.json",
                 R"({"version": 1, "trails": [{"limb": "left-arm", "range": [21, 27], "scale": 3}]})")
          .string();
  const std::string file = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const std::vector<std::string> punch{"--trails", recipe, "--frame", "27"};
  const auto from = [&](const std::string& view) {
    std::vector<std::string> words = punch;
    words.insert(words.end(), {"--view", view});
    return drawn(file, folder, words);
  };
  CHECK(from("best") != from("side"));
  CHECK(from("best") != from("three-quarter"));
}

TEST_CASE("two files stand side by side: the source on the left is the source alone") {
  const test::TemporaryFolder folder;
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const std::string punched = (folder / "punched.glb").string();
  REQUIRE(test::runVerb({"exaggerate", dummy, "-o", punched, "--limb", "left-arm", "--range", "21:27",
                         "--scale", "3", "--clean"})
              .exitCode == 0);
  const auto picture = [&](const std::string& file, const std::string& beside) {
    REQUIRE_FALSE(drawn(file, folder, {"--frame", "27", "--beside", beside}).empty());
    return ui::readImage(folder / "out.png").value();
  };
  const auto halfOf = [](const Image& image, bool left) {
    std::vector<std::uint8_t> bytes;
    for (int y = 30; y < image.height; ++y) { // below the label
      const auto* row = image.rgba.data() + static_cast<std::ptrdiff_t>(4 * image.width) * y;
      const int first = left ? 0 : image.width / 2 + 1;
      bytes.insert(bytes.end(), row + static_cast<std::ptrdiff_t>(4) * first,
                   row + static_cast<std::ptrdiff_t>(4) * (first + image.width / 2 - 1));
    }
    return bytes;
  };
  const Image both = picture(punched, dummy);
  CHECK(both.width == 160);
  CHECK(halfOf(both, true) != halfOf(both, false));
  const Image same = picture(dummy, dummy);
  CHECK(halfOf(same, true) == halfOf(same, false));
  // Counted twice as fast, the same moment has twice the number.
  const std::string fast = (folder / "fast.glb").string();
  REQUIRE(test::runVerb({"exaggerate", dummy, "-o", fast, "--limb", "left-arm", "--range", "42:54", "--scale",
                         "1", "--fps", "48"})
              .exitCode == 0);
  REQUIRE_FALSE(drawn(fast, folder, {"--frame", "54", "--no-trails", "--beside", dummy}).empty());
  CHECK(halfOf(ui::readImage(folder / "out.png").value(), true) == halfOf(same, true));
}

TEST_CASE("of two files beside each other the left one is told to be the one before") {
  if (ui::TextFace(11).widthOf("before") == 0) {
    return; // A system without any font writes nothing.
  }
  const test::TemporaryFolder folder;
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  REQUIRE_FALSE(drawn(dummy, folder, {"--frame", "0", "--beside", dummy}).empty());
  const Image image = ui::readImage(folder / "out.png").value();
  int differing = 0;
  for (int y = 0; y < 30; ++y) { // where a label stands
    for (int x = 0; x < image.width / 2 - 1; ++x) {
      const std::size_t left = 4 * static_cast<std::size_t>(y * image.width + x);
      const std::size_t right = left + 4 * static_cast<std::size_t>(image.width / 2 + 1);
      differing += image.rgba[left] != image.rgba[right] ? 1 : 0;
    }
  }
  CHECK(differing > 10);
}

TEST_CASE("each picture of a long series beside another file is that of its frame") {
  const test::TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const auto drawSeries = [&](const std::string& name, const std::string& frames) {
    fs::create_directories(folder / name);
    const test::VerbAnswer answer =
        render({file, "-o", (folder / (name + "/s.png")).string(), "--size", "64x32", "--camera", "Side",
                "--beside", file, "--frames", frames});
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
  };
  // More than the 32 pictures that are drawn of one file before the other has its turn.
  drawSeries("long", "0:33");
  drawSeries("short", "31:33");
  CHECK(std::distance(fs::directory_iterator(folder / "long"), fs::directory_iterator()) == 34);
  for (const char* const picture : {"/s-0031.png", "/s-0032.png", "/s-0033.png"}) {
    CAPTURE(picture);
    CHECK(readFile(folder / (std::string("long") + picture)).value() ==
          readFile(folder / (std::string("short") + picture)).value());
  }
}

TEST_CASE("a contact sheet without frames shows twelve over the whole clip, its first and last among them") {
  const test::TemporaryFolder folder;
  const std::string file = test::boxerWithCameras(folder);
  const auto cellsOf = [&](const std::vector<std::string>& frames, std::size_t count) {
    std::vector<std::string> words{"--sheet", "--camera", "Side"};
    words.insert(words.end(), frames.begin(), frames.end());
    REQUIRE_FALSE(drawn(file, folder, words).empty());
    const Image sheet = ui::readImage(folder / "out.png").value();
    const ui::SheetLayout layout = ui::layOutSheet(count, 160, 90, 0);
    REQUIRE((sheet.width == layout.widthPixels && sheet.height == layout.heightPixels));
    std::vector<std::vector<std::uint8_t>> cells;
    for (std::size_t i = 0; i < count; ++i) {
      Image cell = ui::filled(160, 90, glm::vec3(0.0F));
      ui::paste(cell, sheet, -layout.left(i), -layout.top(i));
      cells.push_back(cell.rgba);
    }
    return cells;
  };
  const auto whole = cellsOf({}, 12);
  const auto ends = cellsOf({"--frames", "0:60:60"}, 2);
  CHECK(whole[0] == ends[0]);
  CHECK(whole[11] == ends[1]);
  CHECK(whole[5] == cellsOf({"--frames", "27:28"}, 2)[0]); // five elevenths of 60, as a whole frame
}

TEST_CASE("what a file does not have is refused by its name, and nothing is drawn") {
  const test::TemporaryFolder folder;
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const std::string thing = STRETCH_SOURCE_DIR "/tests/ui/things/bat.gltf"; // without a clip
  const std::string cameras = test::boxerWithCameras(folder);
  const std::string out = (folder / "out.png").string();
  for (const auto& [words, reason] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{dummy, "--weights", "Tail"}, "--weights: no mesh follows a joint 'Tail'"},
           {{thing, "--beside", dummy}, "bat.gltf: has no clip to show beside another"},
           {{cameras, "--camera", "Side", "--beside", dummy}, "dummy.glb: has no camera 'Side'"}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"-o", out, "--size", "32x32"});
    const test::VerbAnswer answer = render(all);
    CHECK(answer.exitCode == 1);
    CHECK_THAT(answer.told, Catch::Contains(reason));
  }
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("a video has every frame of the clip at its speed, and leaves nothing when it cannot be made") {
  if (!hasFfmpeg()) {
    WARN("nothing ran: ffmpeg is not installed");
    return;
  }
  const test::TemporaryFolder folder;
  const std::string file = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  for (const std::string ending : {".mp4", ".webm", ".gif"}) {
    CAPTURE(ending);
    const std::string video = (folder / ("punch" + ending)).string();
    const test::VerbAnswer answer = render({file, "--video", video, "--size", "97x55", "--frames", "20:25"});
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    const std::string told = (folder / "told.txt").string();
    REQUIRE(
        std::system(("ffprobe -v error -count_frames -show_entries stream=nb_read_frames,r_frame_rate,width "
                     "-of default=noprint_wrappers=1 " +
                     video + " > " + told)
                        .c_str()) == 0);
    const std::string probed = readText(told).value();
    CHECK_THAT(probed, Catch::Contains("nb_read_frames=6"));
    CHECK_THAT(probed, Catch::Contains(ending == ".gif" ? "width=97" : "width=98")); // even
    if (ending != ".gif") { // which counts in hundredths of a second
      CHECK_THAT(probed, Catch::Contains("r_frame_rate=24/1"));
    }
  }
  const std::size_t before = folder.fileCount();
  const test::VerbAnswer nowhere =
      render({file, "--video", (folder / "gone" / "a.mp4").string(), "--frames", "0:1"});
  CHECK(nowhere.exitCode == 1);
  CHECK_THAT(nowhere.told, Catch::Contains("gone: there is no such folder"));
  CHECK(folder.fileCount() == before);
}

TEST_CASE("a video that is not finished leaves nothing, and without ffmpeg the remedy is told in one line") {
  const test::TemporaryFolder folder;
  const Image picture = ui::filled(16, 16, glm::vec3(0.5F));
  if (hasFfmpeg()) {
    Result<ui::VideoWriter> video = ui::VideoWriter::open({folder / "a.mp4", 16, 16, 24.0});
    REQUIRE(video);
    REQUIRE(video->add(picture));
  }
  CHECK(folder.fileCount() == 0);
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const Result<ui::VideoWriter> none = ui::VideoWriter::open({folder / "a.mp4", 16, 16, 24.0});
  setenv("PATH", path.c_str(), 1);
  REQUIRE_FALSE(none);
  CHECK_THAT(none.error().line(),
             Catch::Contains("ffmpeg, which is not installed") && Catch::Contains("-o picture.png"));
}

TEST_CASE("A picture, a sheet and numbered pictures remove what one that was killed left in their folder") {
  const test::TemporaryFolder folder;
  const std::vector<std::string> own = GENERATE(std::vector<std::string>{"--frame", "3"},
                                                std::vector<std::string>{"--frames", "0:2", "--sheet"},
                                                std::vector<std::string>{"--frames", "0:1"});
  folder.write(".stretch-engine-part-1-0.tmp", "left");
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  std::vector<std::string> words{dummy, "-o", (folder / "picture.png").string(), "--size", "32x32"};
  words.insert(words.end(), own.begin(), own.end());
  REQUIRE(render(words).exitCode == 0);
  CHECK_FALSE(fs::exists(folder / ".stretch-engine-part-1-0.tmp"));
  CHECK(folder.fileCount() >= 1);
}

TEST_CASE("A video removes what a killed one left in its folder, and nothing that is still written") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder programs;
  const fs::path ffmpeg =
      programs.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\nexec cat >\"${last#file:}\"\n");
  fs::permissions(ffmpeg, fs::perms::owner_all);
  folder.write(".stretch-engine-part-video-1.tmp", "left");
  folder.write(".stretch-engine-part-video-own.txt", "the user's");
  const Descriptor other(
      open(folder.write(".stretch-engine-part-video-2.tmp", "under way").c_str(), O_RDONLY));
  REQUIRE(flock(other.number(), LOCK_EX) == 0);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (programs.path().string() + ":" + path).c_str(), 1);
  {
    Result<ui::VideoWriter> video = ui::VideoWriter::open({folder / "a.mp4", 16, 16, 24.0});
    REQUIRE(video);
    CHECK_FALSE(fs::exists(folder / ".stretch-engine-part-video-1.tmp"));
    // One that another program opens there leaves this one alone.
    const fs::path own = folder / fmt::format(".stretch-engine-part-video-{}.tmp", getpid());
    const Descriptor seen(open(own.c_str(), O_RDONLY));
    REQUIRE(seen.number() >= 0);
    CHECK(flock(seen.number(), LOCK_EX | LOCK_NB) != 0);
    REQUIRE(video->add(ui::filled(16, 16, glm::vec3(0.5F))));
    REQUIRE(video->finish());
  }
  setenv("PATH", path.c_str(), 1);
  CHECK(fs::file_size(folder / "a.mp4") == 4 * 16 * 16);
  CHECK(fs::exists(folder / ".stretch-engine-part-video-2.tmp"));
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("A recipe's reference stands in the picture, and one that is not there is refused by its name") {
  const test::TemporaryFolder folder;
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  REQUIRE(ui::writePng(folder / "film-1.png", ui::filled(16, 16, {0.0F, 1.0F, 0.0F})));
  REQUIRE(ui::writePng(folder / "film-2.png", ui::filled(16, 16, {0.0F, 0.0F, 1.0F})));
  const auto recipe = [&](const std::string& images) {
    return folder
        .write("recipe.json",
               R"({"version": 1, "references": {"images": {"first_image": ")" + images + R"("}}})")
        .string();
  };
  const auto topColour = [&](int frame) {
    REQUIRE_FALSE(
        drawn(dummy, folder, {"--trails", recipe("film-1.png"), "--frame", std::to_string(frame)}).empty());
    const Image image = ui::readImage(folder / "out.png").value();
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t place = 4 * (width / 2 + 2 * width);
    return std::vector<int>{image.rgba[place], image.rgba[place + 1], image.rgba[place + 2]};
  };
  CHECK(topColour(0) == std::vector<int>{0, 255, 0});
  CHECK(topColour(1) == std::vector<int>{0, 0, 255});
  CHECK(topColour(2)[1] < 100);
  CHECK(topColour(2)[2] < 100);
  const auto refused = [&](const std::string& images) {
    return render({dummy, "-o", (folder / "none.png").string(), "--trails", recipe(images), "--frame", "0"});
  };
  CHECK(refused("none-1.png").exitCode == 1);
  CHECK_THAT(refused("none-1.png").told, Catch::Contains("none-1.png"));
  folder.write("broken-1.png", "no image");
  CHECK(refused("broken-1.png").exitCode == 1);
  CHECK_THAT(refused("broken-1.png").told, Catch::Contains("broken-1.png"));
  CHECK_FALSE(fs::exists(folder / "none.png"));
}

TEST_CASE("The file that stands beside another has neither its reference, nor its weights' colours") {
  const test::TemporaryFolder folder;
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  REQUIRE(ui::writePng(folder / "film-1.png", ui::filled(16, 16, {0.0F, 1.0F, 0.0F})));
  const std::string recipe =
      folder
          .write("recipe.json", R"({"version": 1, "references": {"images": {"first_image": "film-1.png"}}})")
          .string();
  const auto picture = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"--beside", dummy, "--frame", "0"};
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE_FALSE(drawn(dummy, folder, words).empty());
    return ui::readImage(folder / "out.png").value();
  };
  const Image plain = picture({});
  const auto differing = [&](const Image& image, int from, int to) {
    REQUIRE(image.rgba.size() == plain.rgba.size());
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      const int x = static_cast<int>(i / 4) % image.width;
      count += x >= from && x < to && image.rgba[i] != plain.rgba[i] ? 1 : 0;
    }
    return count;
  };
  const std::vector<std::string> more = GENERATE_COPY(std::vector<std::string>{"--trails", recipe},
                                                      std::vector<std::string>{"--weights", "LeftHand"});
  const Image changed = picture(more);
  CAPTURE(more);
  CHECK(differing(changed, 0, plain.width / 2 - 2) == 0);
  CHECK(differing(changed, plain.width / 2 + 2, plain.width) > 20);
}

TEST_CASE("A video is heard with the clip's sound, from where the film begins in it, as loud as it is set") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder programs;
  const fs::path ffmpeg =
      programs.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"" +
                                   (programs / "words.txt").string() + "\"\nexec cat >\"${last#file:}\"\n");
  fs::permissions(ffmpeg, fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (programs.path().string() + ":" + path).c_str(), 1);
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  folder.write("beat.wav", "any");
  const auto wordsOf = [&](double startFrame, double volume, const char* name) {
    const std::string recipe =
        folder
            .write("recipe.json",
                   fmt::format(R"({{"version": 1, "references": {{"sound": {{"sound_file": "beat.wav",
                               "start_frame": {}, "volume": {}}}}}}})",
                               startFrame, volume))
            .string();
    const test::VerbAnswer answer = render({dummy, "--video", (folder / name).string(), "--frames", "6:8",
                                            "--size", "32x32", "--trails", recipe});
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    const Bytes words = readFile(programs / "words.txt").value();
    return std::string(words.begin(), words.end());
  };
  const std::string sound = "-i file:" + (folder / "beat.wav").string() + " -map 0:v -map 1:a ";
  const double rate = 24.0; // of the bundled clip
  const std::string inside = wordsOf(0.0, 1.0, "a.mp4");
  CHECK_THAT(inside, Catch::Contains(fmt::format("-ss {:.6f} ", 6.0 / rate) + sound));
  CHECK_THAT(inside, Catch::Contains("volume=1.0000,apad -c:a aac"));
  CHECK_THAT(inside, Catch::Contains("-shortest"));
  const std::string later = wordsOf(12.0, 0.25, "a.webm");
  CHECK_THAT(later, Catch::Contains(fmt::format("-itsoffset {:.6f} ", 6.0 / rate) + sound));
  CHECK_THAT(later, Catch::Contains("volume=0.2500,apad -c:a libopus"));
  CHECK_THAT(wordsOf(0.0, 1.0, "a.gif"), !Catch::Contains("beat.wav"));
  CHECK_THAT(wordsOf(0.0, 0.0, "a.mp4"), !Catch::Contains("beat.wav"));
  fs::remove(folder / "beat.wav");
  const test::VerbAnswer gone = render({dummy, "--video", (folder / "gone.mp4").string(), "--frames", "6:8",
                                        "--size", "32x32", "--trails", (folder / "recipe.json").string()});
  setenv("PATH", path.c_str(), 1);
  CHECK(gone.exitCode == 0); // the last recipe has it without volume: nothing is to be heard
}

TEST_CASE("A video whose sound is not there is refused by the sound's name, and leaves nothing") {
  const test::TemporaryFolder folder;
  const std::string recipe =
      folder.write("recipe.json", R"({"version": 1, "references": {"sound": {"sound_file": "gone.wav"}}})")
          .string();
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const test::VerbAnswer answer =
      render({dummy, "--video", (folder / "a.mp4").string(), "--frames", "0:1", "--trails", recipe});
  CHECK(answer.exitCode == 1);
  CHECK_THAT(answer.told,
             Catch::Contains("the sound of the reference is not there") && Catch::Contains("gone.wav"));
  CHECK(folder.fileCount() == 1);
}
