#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include <sys/stat.h>

#include "app/reference/sound.h"
#include "tests/support/app/sound_bytes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Sound soundOf(const test::TemporaryFolder& folder, const std::string& bytes) {
  const Result<Sound> sound = readSound(folder.write("sound.wav", bytes));
  REQUIRE(sound);
  return *sound;
}

std::string soundProblem(const std::filesystem::path& file) {
  const Result<Sound> sound = readSound(file);
  REQUIRE_FALSE(sound);
  CHECK(sound.error().where == file.string());
  CHECK_FALSE(sound.error().remedy.empty());
  return sound.error().what;
}

/// A WAV of numbers between -1 and 1.
std::string floatWav(const std::vector<float>& samples, int samplesPerSecond) {
  std::string bytes = test::wavOf(std::vector<std::int16_t>(2 * samples.size()), samplesPerSecond);
  bytes[20] = 3; // floating point
  bytes[32] = 4; // bytes of a time
  bytes[34] = 32;
  std::memcpy(bytes.data() + 44, samples.data(), 4 * samples.size());
  return bytes;
}

} // namespace

TEST_CASE("A sound is read as it was written: its rate, its channels, every value") {
  const test::TemporaryFolder folder;
  const Sound mono = soundOf(folder, test::wavOf({0, 1000, -1000, 32767, -32768}, 8000));
  CHECK(mono.samplesPerSecond == 8000);
  REQUIRE(mono.samples.size() == 10); // alike on the left and on the right
  for (std::size_t i = 0; i < mono.samples.size(); i += 2) {
    CHECK(mono.samples[i] == mono.samples[i + 1]);
  }
  CHECK(mono.samples[2] == 1000);
  CHECK(mono.samples[4] == -1000);
  CHECK(mono.samples[6] >= 32766);
  CHECK(mono.samples[8] <= -32766);
  CHECK(mono.seconds() == Approx(5.0 / 8000.0));
  CHECK(mono.loudest == Approx(1.0).margin(1e-4));
  const Sound stereo = soundOf(folder, test::wavOf({100, -200, 300, -400}, 44100, 2));
  CHECK(stereo.samples == std::vector<std::int16_t>{100, -200, 300, -400});
  CHECK(stereo.seconds() == Approx(2.0 / 44100.0));
  CHECK(stereo.loudest == Approx(400.0 / 32767.0).margin(1e-4));
}

TEST_CASE("More than two channels are heard in both, as loud as their mean") {
  const test::TemporaryFolder folder;
  const Sound sound = soundOf(folder, test::wavOf({3000, 6000, 9000, -3000, 0, 0}, 48000, 3));
  CHECK(sound.samples == std::vector<std::int16_t>{6000, 6000, -1000, -1000});
}

TEST_CASE("Reading a sound ends when it is told to, with an error that names it") {
  const test::TemporaryFolder folder;
  const std::string file =
      folder.write("long.wav", test::wavOf(std::vector<std::int16_t>(100'000, 7), 8000)).string();
  int asked = 0;
  const Result<Sound> stopped = readSound(file, [&] { return ++asked < 3; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().what == "reading it was stopped");
  CHECK(stopped.error().where == file);
  CHECK(asked == 3);
}

TEST_CASE("Sounds are known by their names, in capital letters too") {
  for (const char* const name : {"a.wav", "a.aif", "a.aiff", "a.flac", "a.ogg", "a.mp3", "a.WAV"}) {
    INFO(name);
    CHECK(isSoundName(name));
  }
  CHECK_FALSE(isSoundName("a.png"));
  CHECK_FALSE(isSoundName("wav"));
}

TEST_CASE("Values beyond what can be heard are the loudest, and those that are no numbers are silence") {
  const test::TemporaryFolder folder;
  const float infinity = std::numeric_limits<float>::infinity();
  const Sound sound =
      soundOf(folder, floatWav({0.5F, 3.0F, -infinity, std::numeric_limits<float>::quiet_NaN()}, 8000));
  CHECK(sound.samples == std::vector<std::int16_t>{16384, 16384, 32767, 32767, -32767, -32767, 0, 0});
}

TEST_CASE("A stretch of sound is as loud as the loudest in it, and beside the sound there is silence") {
  const test::TemporaryFolder folder;
  constexpr int rate = 25600; // 100 peaks a second
  const Sound sound = soundOf(folder, test::wavOf(test::toneBetween(0.5, 0.7, 1.0, rate), rate));
  CHECK(secondsOfPeak(sound) == Approx(0.01));
  CHECK(sound.peaks.size() == 100);
  CHECK(peakBetween(sound, 0.0, 0.49).high == 0.0F);
  CHECK(peakBetween(sound, 0.55, 0.56).high == Approx(0.5).margin(0.01));
  CHECK(peakBetween(sound, 0.55, 0.56).low == Approx(-0.5).margin(0.01));
  CHECK(peakBetween(sound, 0.0, 1.0).high == Approx(0.5).margin(0.01));
  CHECK(peakBetween(sound, 0.6001, 0.6002).high > 0.4F); // less than a peak is long
  CHECK(peakBetween(sound, 0.71, 1.0).high == 0.0F);
  CHECK(peakBetween(sound, -2.0, -1.0).high == 0.0F);
  CHECK(peakBetween(sound, -1.0, 0.6).high > 0.4F);
  CHECK(peakBetween(sound, 0.6, 5.0).high > 0.4F);
  CHECK(peakBetween(sound, 1.5, 5.0).high == 0.0F);
  CHECK(peakBetween(sound, std::nan(""), std::nan("")).high == 0.0F);
}

TEST_CASE("The last peak of a sound is that of what is left of it") {
  const test::TemporaryFolder folder;
  std::vector<std::int16_t> samples(samplesOfPeak + 1, 0);
  samples.back() = 16384;
  const Sound sound = soundOf(folder, test::wavOf(samples, 8000));
  REQUIRE(sound.peaks.size() == 2);
  CHECK(sound.peaks[0].high == 0.0F);
  CHECK(sound.peaks[1].high == Approx(0.5).margin(1e-3));
}

TEST_CASE("What is no sound is refused in one line: missing, another kind, empty, a folder, a pipe") {
  const test::TemporaryFolder folder;
  CHECK(soundProblem(folder / "none.wav") == "the sound is not there");
  CHECK(soundProblem(folder.path()) == "the sound is not there");
  CHECK(soundProblem(folder.write("text.wav", "no sound at all")) == "this is not a sound that can be read");
  CHECK(soundProblem(folder.write("empty.wav", "")) == "this is not a sound that can be read");
  CHECK(soundProblem(folder.write("silent.wav", test::wavOf({}, 8000))) ==
        "this is not a sound that can be read");
  const std::filesystem::path pipe = folder / "pipe.wav";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(soundProblem(pipe) == "the sound is not there");
}

TEST_CASE("A sound that was cut off is read as far as it goes") {
  const test::TemporaryFolder folder;
  const std::string whole = test::wavOf(std::vector<std::int16_t>(1000, 500), 8000);
  CHECK(soundOf(folder, whole.substr(0, 44 + 600)).samples.size() == 600);
}
