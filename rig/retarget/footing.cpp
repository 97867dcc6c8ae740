#include "rig/retarget/footing.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

std::vector<bool> framesOf(const std::vector<Stand>& stands, std::size_t count) {
  std::vector<bool> frames(count, false);
  for (const Stand& stand : stands) {
    std::fill(frames.begin() + static_cast<std::ptrdiff_t>(stand.first),
              frames.begin() + static_cast<std::ptrdiff_t>(stand.last) + 1, true);
  }
  return frames;
}

// Runs of frames that stand without a break.
std::vector<Stand> runsOf(const std::vector<bool>& stands) {
  std::vector<Stand> runs;
  for (std::size_t frame = 0; frame < stands.size(); ++frame) {
    if (!stands[frame]) {
      continue;
    }
    if (!runs.empty() && runs.back().last + 1 == frame) {
      runs.back().last = frame;
    } else {
      runs.push_back({frame, frame});
    }
  }
  return runs;
}

// How far the ankle has to be from its wanted place over a run, for what stands to stand: about nothing on
// the mean.
void holdRun(const FootMotion& foot, const Stand& run, const std::vector<bool>& heelStands,
             const std::vector<bool>& ballStands, std::vector<Vec3>& offsets) {
  Vec3 sum(0.0);
  offsets[run.first] = Vec3(0.0);
  for (std::size_t i = run.first + 1; i <= run.last; ++i) {
    const Vec3 wanted = foot.wanted[i] - foot.wanted[i - 1];
    Vec3 step = wanted;
    if (ballStands[i] && ballStands[i - 1]) {
      step = foot.balls[i] - foot.balls[i - 1] + foot.toAnkle[i] - foot.toAnkle[i - 1];
    } else if (heelStands[i] && heelStands[i - 1]) {
      step = foot.ankles[i] - foot.ankles[i - 1];
    }
    offsets[i] = offsets[i - 1] + step - wanted;
    sum += offsets[i];
  }
  const Vec3 mean = sum / static_cast<double>(run.last - run.first + 1);
  for (std::size_t i = run.first; i <= run.last; ++i) {
    offsets[i] -= mean;
  }
}

// Carries the offsets of runs over to the frames between them.
void carryOver(const std::vector<Stand>& runs, std::vector<Vec3>& offsets) {
  for (std::size_t i = 0; i < runs.front().first; ++i) {
    offsets[i] = offsets[runs.front().first];
  }
  for (std::size_t run = 0; run + 1 < runs.size(); ++run) {
    const std::size_t from = runs[run].last;
    const std::size_t to = runs[run + 1].first;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double share = smoothstep(static_cast<double>(i - from) / static_cast<double>(to - from));
      offsets[i] = (1.0 - share) * offsets[from] + share * offsets[to];
    }
  }
  for (std::size_t i = runs.back().last + 1; i < offsets.size(); ++i) {
    offsets[i] = offsets[runs.back().last];
  }
}

} // namespace

std::vector<Stand> standsOf(const std::vector<Vec3>& places, const std::vector<double>& seconds,
                            double legLength) {
  constexpr double restingSpeed = 0.25; // leg lengths in each second
  constexpr double restingSeconds = 0.1;
  std::vector<Stand> stands;
  for (std::size_t first = 0; first + 1 < places.size();) {
    std::size_t last = first;
    while (last + 1 < places.size() && glm::length(places[last + 1] - places[last]) <=
                                           restingSpeed * legLength * (seconds[last + 1] - seconds[last])) {
      ++last;
    }
    if (last > first && seconds[last] - seconds[first] >= restingSeconds) {
      stands.push_back({first, last});
    }
    first = last + 1;
  }
  return stands;
}

std::vector<bool> standingFrames(const FootMotion& foot) {
  std::vector<bool> frames = framesOf(foot.ankleStands, foot.wanted.size());
  const std::vector<bool> ball = framesOf(foot.ballStands, foot.wanted.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i] = frames[i] || ball[i];
  }
  return frames;
}

std::vector<Vec3> plantedAnkles(const FootMotion& foot) {
  const std::vector<bool> heelStands = framesOf(foot.ankleStands, foot.wanted.size());
  const std::vector<bool> ballStands = framesOf(foot.ballStands, foot.wanted.size());
  const std::vector<Stand> runs = runsOf(standingFrames(foot));
  std::vector<Vec3> places = foot.wanted;
  if (runs.empty()) {
    return places;
  }
  std::vector<Vec3> offsets(places.size(), Vec3(0.0));
  for (const Stand& run : runs) {
    holdRun(foot, run, heelStands, ballStands, offsets);
  }
  carryOver(runs, offsets);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] += offsets[i];
  }
  return places;
}

std::vector<double> easedAbove(const std::vector<double>& needed, std::size_t frames) {
  const auto windowOf = [&](std::size_t frame) {
    return std::pair(frame < frames ? 0 : frame - frames, std::min(frame + frames + 1, needed.size()));
  };
  std::vector<double> highest(needed.size());
  for (std::size_t frame = 0; frame < needed.size(); ++frame) {
    const auto [first, past] = windowOf(frame);
    highest[frame] = *std::max_element(needed.begin() + static_cast<std::ptrdiff_t>(first),
                                       needed.begin() + static_cast<std::ptrdiff_t>(past));
  }
  std::vector<double> eased(needed.size());
  for (std::size_t frame = 0; frame < needed.size(); ++frame) {
    const auto [first, past] = windowOf(frame);
    double sum = 0.0;
    for (std::size_t i = first; i < past; ++i) {
      sum += highest[i];
    }
    eased[frame] = sum / static_cast<double>(past - first);
  }
  return eased;
}

} // namespace stretch::rig
