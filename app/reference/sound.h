#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
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
  std::vector<std::int16_t> samples; ///< Left and right in turn; what is not of two channels is alike in
                                     ///< both.
  std::vector<SoundPeak> peaks;      ///< One for each `samplesOfPeak` times, both channels together.
  float loudest = 0.0F;              ///< Largest distance of a peak from silence, 0..1.

  [[nodiscard]] double seconds() const;
};

/// Times that one peak is of.
inline constexpr int samplesOfPeak = 256;

/// Seconds that one peak is of.
[[nodiscard]] double secondsOfPeak(const Sound& sound);

/// The loudest of the sound from one time to another; zeros outside of it.
[[nodiscard]] SoundPeak peakBetween(const Sound& sound, double fromSeconds, double toSeconds);

/// Endings of the sounds that can be read, in small letters: ".wav", ".flac" and so on.
[[nodiscard]] const std::vector<std::string>& soundEndings();
/// Whether the name ends so.
[[nodiscard]] bool isSoundName(const std::filesystem::path& path);

/// Reads a WAV, AIFF, FLAC, Ogg or MP3. Errors: not there, no sound, over 200 MB when decoded. `goesOn` is
/// asked now and then; the work ends with an error where it answers false.
[[nodiscard]] Result<Sound> readSound(
    const std::filesystem::path& path, const std::function<bool()>& goesOn = [] { return true; });

} // namespace stretch::app
