#include "core/anim/clip.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stretch {

namespace {

std::vector<float> allKeyTimes(const std::vector<CopyOnWrite<Track>>& tracks) {
  std::vector<float> times;
  for (const CopyOnWrite<Track>& track : tracks) {
    times.insert(times.end(), track->times.begin(), track->times.end());
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// Share of the keys that lie within 2 % of a frame of a whole frame.
double shareOnFrames(const std::vector<float>& times, double framesPerSecond) {
  const auto onFrame = std::count_if(times.begin(), times.end(), [&](float time) {
    const double frame = static_cast<double>(time) * framesPerSecond;
    return std::abs(frame - std::round(frame)) < 0.02;
  });
  return static_cast<double>(onFrame) / static_cast<double>(times.size());
}

} // namespace

int findTrack(const Clip& clip, int node, Channel channel) {
  for (std::size_t i = 0; i < clip.tracks.size(); ++i) {
    if (clip.tracks[i]->node == node && clip.tracks[i]->channel == channel) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

double guessFramesPerSecond(const std::vector<CopyOnWrite<Track>>& tracks) {
  constexpr double fallback = 30.0;
  const std::vector<float> times = allKeyTimes(tracks);
  if (times.size() < 2) {
    return fallback;
  }
  constexpr std::array<double, 12> usualRates{24, 30, 25, 60, 50, 12, 15, 48, 120, 100, 10, 8};
  constexpr double mostKeys = 0.9;
  for (const double rate : usualRates) {
    if (shareOnFrames(times, rate) >= mostKeys) {
      return rate;
    }
  }
  // An unusual rate: the median spacing of the keys names it where most keys agree.
  std::vector<double> spacings;
  for (std::size_t i = 1; i < times.size(); ++i) {
    spacings.push_back(static_cast<double>(times[i]) - static_cast<double>(times[i - 1]));
  }
  std::nth_element(spacings.begin(), spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2),
                   spacings.end());
  const double rate = 1.0 / spacings[spacings.size() / 2];
  return rate > 1.0 && rate <= 240.0 && shareOnFrames(times, rate) >= mostKeys ? rate : fallback;
}

int frameCount(const Clip& clip) {
  return static_cast<int>(std::lround(clip.endSeconds * clip.framesPerSecond)) + 1;
}

} // namespace stretch
