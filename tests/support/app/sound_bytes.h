#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace stretch::test {

/// Bytes of a WAV of whole numbers of 16 bits, channel by channel at each time.
[[nodiscard]] inline std::string wavOf(const std::vector<std::int16_t>& samples, int samplesPerSecond,
                                       int channels = 1) {
  std::string bytes;
  const auto number = [&](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) {
      bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
    }
  };
  const auto size = static_cast<std::uint32_t>(2 * samples.size());
  const auto rate = static_cast<std::uint32_t>(samplesPerSecond);
  const auto width = static_cast<std::uint32_t>(channels);
  bytes += "RIFF";
  number(36 + size, 4);
  bytes += "WAVEfmt ";
  number(16, 4);
  number(1, 2); // whole numbers
  number(width, 2);
  number(rate, 4);
  number(2 * width * rate, 4);
  number(2 * width, 2);
  number(16, 2);
  bytes += "data";
  number(size, 4);
  for (const std::int16_t sample : samples) {
    number(static_cast<std::uint16_t>(sample), 2);
  }
  return bytes;
}

/// Silence, with a tone of half the full strength from one time to another, in one channel.
[[nodiscard]] inline std::vector<std::int16_t> toneBetween(double fromSeconds, double toSeconds,
                                                           double lengthSeconds, int samplesPerSecond) {
  constexpr double tonesPerSecond = 440.0;
  constexpr double turn = 6.283185307179586;
  std::vector<std::int16_t> samples;
  for (int i = 0; i < static_cast<int>(lengthSeconds * samplesPerSecond); ++i) {
    const double seconds = static_cast<double>(i) / samplesPerSecond;
    const bool sounds = seconds >= fromSeconds && seconds < toSeconds;
    samples.push_back(
        static_cast<std::int16_t>(sounds ? 16383.0 * std::sin(turn * tonesPerSecond * seconds) : 0.0));
  }
  return samples;
}

} // namespace stretch::test
