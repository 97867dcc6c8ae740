#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "tests/support/app/sound_bytes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/ui/recording_device.h"
#include "ui/shell/reference/sound_output.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr int rate = 44100;

app::SoundPeak heard() {
  const Result<app::Sound> sound = app::readSound(test::recordedSound());
  REQUIRE(sound);
  return app::peakBetween(*sound, 0.0, sound->seconds());
}

/// A minute; a tone in all but the first half of it. Nothing that is played is heard.
std::shared_ptr<const app::Sound> lateTone(const test::TemporaryFolder& folder) {
  static_cast<void>(test::recordedSound());
  const Result<app::Sound> sound =
      app::readSound(folder.write("tone.wav", test::wavOf(test::toneBetween(30.0, 60.0, 60.0, rate), rate)));
  REQUIRE(sound);
  return std::make_shared<const app::Sound>(*sound);
}

/// Waits until the sound has come to a time; fails where it does not.
void waitUntil(const SoundOutput& output, double seconds) {
  for (int tries = 0; tries < 2000 && output.seconds() < seconds; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  REQUIRE(output.seconds() >= seconds);
}

} // namespace

TEST_CASE("A sound is heard from the time that it is played from") {
  const test::TemporaryFolder folder;
  const std::shared_ptr<const app::Sound> sound = lateTone(folder);
  {
    SoundOutput output;
    CHECK_FALSE(output.isPlaying());
    CHECK(output.seconds() == 0.0);
    REQUIRE(output.play(sound, 31.0, 1.0, 1.0));
    CHECK(output.isPlaying());
    CHECK(output.seconds() >= 31.0);
    waitUntil(output, 31.2);
    output.stop();
    CHECK_FALSE(output.isPlaying());
    CHECK(output.seconds() == 0.0);
  }
  CHECK(heard().high == Approx(0.5).margin(0.05));
}

TEST_CASE("Where the sound is silent nothing is heard, and its volume is what it is asked to be") {
  const test::TemporaryFolder folder;
  const std::shared_ptr<const app::Sound> sound = lateTone(folder);
  const auto heardFrom = [&](double seconds, double volume) {
    {
      SoundOutput output;
      REQUIRE(output.play(sound, seconds, 1.0, volume));
      waitUntil(output, seconds + 0.2);
    }
    return heard().high;
  };
  CHECK(heardFrom(0.5, 1.0) < 0.01F);
  CHECK(heardFrom(31.0, 0.5) == Approx(0.25).margin(0.03));
  CHECK(heardFrom(31.0, 0.0) < 0.01F);
}

TEST_CASE("The volume is turned down while a sound plays") {
  const test::TemporaryFolder folder;
  {
    SoundOutput output;
    REQUIRE(output.play(lateTone(folder), 29.0, 1.0, 1.0)); // a second of silence first
    output.setVolume(0.125);
    waitUntil(output, 30.3);
  }
  CHECK(heard().high == Approx(0.0625).margin(0.01));
}

TEST_CASE("Another sound takes the place of the one before, and a new time that of the old") {
  const test::TemporaryFolder folder;
  const std::shared_ptr<const app::Sound> sound = lateTone(folder);
  const auto other = std::make_shared<const app::Sound>(*sound);
  SoundOutput output;
  REQUIRE(output.play(sound, 5.0, 1.0, 1.0));
  REQUIRE(output.play(other, 40.0, 1.0, 1.0));
  CHECK(output.seconds() >= 40.0);
  REQUIRE(output.play(other, 10.0, 1.0, 1.0));
  CHECK(output.seconds() < 40.0);
  CHECK(output.seconds() >= 10.0);
}

TEST_CASE("Twice as fast, a sound is through two seconds in less than two") {
  const test::TemporaryFolder folder;
  SoundOutput output;
  REQUIRE(output.play(lateTone(folder), 10.0, 4.0, 1.0));
  const auto began = std::chrono::steady_clock::now();
  waitUntil(output, 12.0);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  CHECK(took.count() < 1.9); // half a second, where nothing else keeps the machine
}

TEST_CASE("Without a device that plays there is an error with what is left of the sound") {
  const test::TemporaryFolder folder;
  const std::filesystem::path home = test::recordedSound().parent_path();
  std::filesystem::remove_all(home); // The device has nowhere to write to.
  SoundOutput output;
  const Status heard = output.play(lateTone(folder), 0.0, 1.0, 1.0);
  std::filesystem::create_directory(home);
  REQUIRE_FALSE(heard);
  CHECK_THAT(heard.error().remedy, Catch::Contains("timeline"));
  output.stop();
  CHECK_FALSE(output.isPlaying());
}
