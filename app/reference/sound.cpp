#include "app/reference/sound.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <sndfile.h>

#include "core/base/lower_case.h"

namespace stretch::app {

namespace {

constexpr std::size_t mostSamples = 100'000'000; // 200 MB; 17 minutes at 48 kHz

Error noSound(const std::filesystem::path& path) {
  return {"this is not a sound that can be read", path.string(), "give a WAV, AIFF, FLAC, Ogg or MP3"};
}

std::int16_t toSample(float value) {
  // A value that is no number is silence.
  return std::isnan(value)
             ? std::int16_t{0}
             : static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767.0F));
}

/// Adds a block of `count` times with `channels` values each.
void addBlock(const float* values, std::size_t count, int channels, Sound& sound) {
  const auto width = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < count; ++i) {
    const float* const time = values + i * width;
    if (channels == 2) {
      sound.samples.insert(sound.samples.end(), {toSample(time[0]), toSample(time[1])});
      continue;
    }
    float sum = 0.0F;
    for (std::size_t channel = 0; channel < width; ++channel) {
      sum += time[channel];
    }
    sound.samples.insert(sound.samples.end(), 2, toSample(sum / static_cast<float>(width)));
  }
}

std::vector<SoundPeak> peaksOf(const Sound& sound) {
  constexpr std::size_t step = 2 * static_cast<std::size_t>(samplesOfPeak);
  std::vector<SoundPeak> peaks;
  for (std::size_t begin = 0; begin < sound.samples.size(); begin += step) {
    const auto first = sound.samples.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = first + static_cast<std::ptrdiff_t>(std::min(step, sound.samples.size() - begin));
    const auto [low, high] = std::minmax_element(first, last);
    peaks.push_back({static_cast<float>(*low) / 32767.0F, static_cast<float>(*high) / 32767.0F});
  }
  return peaks;
}

} // namespace

double Sound::seconds() const {
  return samplesPerSecond <= 0 ? 0.0 : 0.5 * static_cast<double>(samples.size()) / samplesPerSecond;
}

double secondsOfPeak(const Sound& sound) {
  return static_cast<double>(samplesOfPeak) / sound.samplesPerSecond;
}

SoundPeak peakBetween(const Sound& sound, double fromSeconds, double toSeconds) {
  const double step = secondsOfPeak(sound);
  const auto count = static_cast<double>(sound.peaks.size());
  const double first = std::floor(fromSeconds / step);
  const double last = std::max(first + 1.0, std::ceil(toSeconds / step));
  SoundPeak loudest;
  if (!(last > 0.0) || !(first < count)) {
    return loudest;
  }
  const auto begin = static_cast<std::size_t>(std::max(0.0, first));
  const auto end = static_cast<std::size_t>(std::min(count, last));
  for (std::size_t i = begin; i < end; ++i) {
    loudest.low = std::min(loudest.low, sound.peaks[i].low);
    loudest.high = std::max(loudest.high, sound.peaks[i].high);
  }
  return loudest;
}

const std::vector<std::string>& soundEndings() {
  static const std::vector<std::string> endings{".wav", ".aif", ".aiff", ".flac", ".ogg", ".mp3"};
  return endings;
}

bool isSoundName(const std::filesystem::path& path) {
  return std::ranges::find(soundEndings(), lowerCase(path.extension().string())) != soundEndings().end();
}

Result<Sound> readSound(const std::filesystem::path& path, const std::function<bool()>& goesOn) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) { // A pipe would be waited for.
    return Error{"the sound is not there", path.string(), "choose it again"};
  }
  SF_INFO facts{};
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> file(sf_open(path.c_str(), SFM_READ, &facts), sf_close);
  if (file == nullptr || facts.channels <= 0 || facts.samplerate <= 0) {
    return noSound(path);
  }
  Sound sound;
  sound.samplesPerSecond = facts.samplerate;
  constexpr sf_count_t timesAtOnce = 4096;
  std::vector<float> block(static_cast<std::size_t>(timesAtOnce * facts.channels));
  for (sf_count_t read = timesAtOnce; read > 0;) {
    read = sf_readf_float(file.get(), block.data(), timesAtOnce);
    addBlock(block.data(), static_cast<std::size_t>(std::max<sf_count_t>(0, read)), facts.channels, sound);
    if (!goesOn()) {
      return Error{"reading it was stopped", path.string(), "choose it again"};
    }
    if (sound.samples.size() > mostSamples) {
      return Error{"the sound takes over 200 MB", path.string(), "cut it, or give one at a lower rate"};
    }
  }
  if (sound.samples.empty()) {
    return noSound(path);
  }
  sound.peaks = peaksOf(sound);
  for (const SoundPeak& peak : sound.peaks) {
    sound.loudest = std::max({sound.loudest, peak.high, -peak.low});
  }
  return sound;
}

} // namespace stretch::app
