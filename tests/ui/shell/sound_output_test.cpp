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

/// Two seconds; a tone in the second one.
std::shared_ptr<const app::Sound> lateTone(const test::TemporaryFolder& folder) {
  const Result<app::Sound> sound =
      app::readSound(folder.write("tone.wav", test::wavOf(test::toneBetween(1.0, 2.0, 2.0, rate), rate)));
  REQUIRE(sound);
  return std::make_shared<const app::Sound>(*sound);
}

void waitFor(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

} // namespace

TEST_CASE("A sound is heard from the time that it is played from") {
  const test::TemporaryFolder folder;
  const std::shared_ptr<const app::Sound> sound = lateTone(folder);
  {
    SoundOutput output;
    CHECK_FALSE(output.isPlaying());
    CHECK(output.seconds() == 0.0);
    REQUIRE(output.play(sound, 1.2, 1.0, 1.0));
    CHECK(output.isPlaying());
    CHECK(output.seconds() == Approx(1.2).margin(0.1));
    waitFor(250);
    CHECK(output.seconds() > 1.25);
    output.stop();
    CHECK_FALSE(output.isPlaying());
    CHECK(output.seconds() == 0.0);
  }
  CHECK(heard().high == Approx(0.5).margin(0.05));
}

TEST_CASE("Where the sound is silent nothing is heard, and its volume is what it is asked to be") {
  const test::TemporaryFolder folder;
  const std::shared_ptr<const app::Sound> sound = lateTone(folder);
  SECTION("before the tone") {
    {
      SoundOutput output;
      REQUIRE(output.play(sound, 0.1, 1.0, 1.0));
      waitFor(200);
    }
    CHECK(heard().high < 0.01F);
  }
  SECTION("half as loud") {
    {
      SoundOutput output;
      REQUIRE(output.play(sound, 1.1, 1.0, 0.5));
      waitFor(200);
    }
    CHECK(heard().high == Approx(0.25).margin(0.03));
  }
  SECTION("turned off while it plays") {
    {
      SoundOutput output;
      REQUIRE(output.play(sound, 0.0, 1.0, 1.0));
      output.setVolume(0.0);
      waitFor(200);
      REQUIRE(output.isPlaying());
    }
    CHECK(heard().high < 0.01F);
  }
}

TEST_CASE("Another sound takes the place of the one before, and a new time that of the old") {
  const test::TemporaryFolder folder;
  const std::shared_ptr<const app::Sound> sound = lateTone(folder);
  const auto other = std::make_shared<const app::Sound>(*sound);
  SoundOutput output;
  REQUIRE(output.play(sound, 0.2, 1.0, 1.0));
  REQUIRE(output.play(other, 1.5, 1.0, 1.0));
  CHECK(output.seconds() == Approx(1.5).margin(0.1));
  REQUIRE(output.play(other, 0.5, 2.0, 1.0));
  CHECK(output.seconds() == Approx(0.5).margin(0.1));
  waitFor(300); // Twice as fast, it is through a second in half of one.
  CHECK(output.seconds() > 0.9);
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
