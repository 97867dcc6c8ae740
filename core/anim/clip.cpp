#include "core/anim/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "core/math/median.h"

namespace stretch {

namespace {

// Ascending, each once. Most tracks of a clip share their times, and those of each ascend already.
std::vector<float> allKeyTimes(const std::vector<CopyOnWrite<Track>>& tracks) {
  std::set<std::vector<float>> different;
  for (const CopyOnWrite<Track>& track : tracks) {
    different.insert(track->times);
  }
  std::vector<std::vector<float>> lists(different.begin(), different.end());
  while (lists.size() > 1) {
    std::vector<std::vector<float>> joined;
    for (std::size_t i = 0; i < lists.size(); i += 2) {
      const std::vector<float> beside = i + 1 < lists.size() ? std::move(lists[i + 1]) : std::vector<float>();
      std::ranges::set_union(lists[i], beside, std::back_inserter(joined.emplace_back()));
    }
    lists = std::move(joined);
  }
  return lists.empty() ? std::vector<float>() : std::move(lists.front());
}

constexpr double mostKeys = 0.9; // of a clip or a track: enough to name its rate

// Share of the keys that lie within 2 % of a frame of a whole frame.
double shareOnFrames(const std::vector<float>& times, double framesPerSecond) {
  const auto onFrame = std::count_if(times.begin(), times.end(), [&](float time) {
    const double frame = static_cast<double>(time) * framesPerSecond;
    return std::abs(frame - std::round(frame)) < 0.02;
  });
  return static_cast<double>(onFrame) / static_cast<double>(times.size());
}

// The rate at which most of these key times fall on whole frames; 0 when there is none.
double rateOf(const std::vector<float>& times) {
  constexpr std::array<double, 12> usualRates{24, 30, 25, 60, 50, 12, 15, 48, 120, 100, 10, 8};
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
  const double rate = 1.0 / medianOf(std::move(spacings), 1.0);
  // Times in single precision put the spacing of a highest rate a little off.
  constexpr double highest = 240.5;
  return rate > 1.0 && rate <= highest && shareOnFrames(times, rate) >= mostKeys ? rate : 0.0;
}

// Share of the tracks, of those with enough keys to tell, that are keyed on whole frames of a rate.
double shareOfTracksOnFrames(const std::vector<CopyOnWrite<Track>>& tracks, double framesPerSecond) {
  constexpr std::size_t tellingKeys = 4;
  double telling = 0.0;
  double onFrames = 0.0;
  for (const CopyOnWrite<Track>& track : tracks) {
    if (track->times.size() >= tellingKeys) {
      telling += 1.0;
      onFrames += shareOnFrames(track->times, framesPerSecond) >= mostKeys ? 1.0 : 0.0;
    }
  }
  return telling > 0.0 ? onFrames / telling : 0.0;
}

} // namespace

void setEndsFromKeys(Clip& clip) {
  clip.startSeconds = clip.endSeconds = 0.0;
  bool isFirst = true;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const double start = std::max(0.0, static_cast<double>(track->times.front()));
    clip.startSeconds = isFirst ? start : std::min(clip.startSeconds, start);
    clip.endSeconds = std::max(clip.endSeconds, static_cast<double>(track->times.back()));
    isFirst = false;
  }
}

int findTrack(const Clip& clip, NodeIndex node, Channel channel) {
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
  double rate = rateOf(times);
  // Re-keying a limb puts some keys between frames: where a good part of the tracks is keyed on every second
  // frame of a high rate, that one is only the rate of those between.
  constexpr double lowestDoubled = 40.0;
  constexpr double goodPart = 0.3;
  if (rate >= lowestDoubled && shareOfTracksOnFrames(tracks, 0.5 * rate) >= goodPart) {
    rate *= 0.5;
  }
  return rate > 0.0 ? rate : fallback;
}

std::size_t keyCount(const Clip& clip) {
  std::size_t keys = 0;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    keys += track->times.size();
  }
  return keys;
}

std::int64_t frameCount(const Clip& clip) {
  constexpr double most = 1e15;
  return static_cast<std::int64_t>(std::llround(std::min(most, clip.endSeconds * clip.framesPerSecond))) + 1;
}

} // namespace stretch
