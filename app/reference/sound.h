#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.h"

namespace stretch::app {

/// Least and greatest value of a stretch of sound, -1..1.
struct SoundPeak {
  float low = 0.0F;
  float high = 0.0F;
};

/// A sound, decoded.
struct Sound {
  int samplesPerSecond = 0;
  int channels = 1;                  ///< 1 or 2; more in the file are mixed into one.
  std::vector<std::int16_t> samples; ///< Channel by channel at each time.
  std::vector<SoundPeak> peaks;      ///< One for each `samplesOfPeak` times, all channels together.

  [[nodiscard]] double seconds() const;
};

/// Times that one peak is of.
inline constexpr int samplesOfPeak = 256;

/// Seconds that one peak is of.
[[nodiscard]] double secondsOfPeak(const Sound& sound);

/// The loudest of the sound from one time to another; zeros outside of it.
[[nodiscard]] SoundPeak peakBetween(const Sound& sound, double fromSeconds, double toSeconds);

/// Whether the name ends as one of the sounds that can be read: .wav, .aif, .aiff, .flac, .ogg or .mp3.
[[nodiscard]] bool isSoundName(const std::filesystem::path& path);

/// Reads a WAV, AIFF, FLAC, Ogg or MP3. Errors: not there, no sound, over 200 MB when decoded.
[[nodiscard]] Result<Sound> readSound(const std::filesystem::path& path);

} // namespace stretch::app
