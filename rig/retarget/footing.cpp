#include "rig/retarget/footing.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

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

// Runs between which the foot shuffles only are one.
std::vector<Stand> joined(const FootMotion& foot, const std::vector<Stand>& runs) {
  std::vector<Stand> all;
  for (const Stand& run : runs) {
    bool shuffles = !all.empty();
    for (std::size_t i = shuffles ? all.back().last + 1 : 0; shuffles && i <= run.first; ++i) {
      shuffles = glm::length(foot.ankles[i] - foot.ankles[all.back().last]) < foot.shuffle;
    }
    if (shuffles) {
      all.back().last = run.last;
    } else {
      all.push_back(run);
    }
  }
  return all;
}

// The point of a foot that stands at each frame, and the one that stands quite still.
struct Footing {
  std::vector<bool> heelStands;
  std::vector<bool> ballStands;
  std::vector<bool> heelIsHeld;
  std::vector<bool> ballIsHeld;
};

// Whether the ankle follows the ball to this frame: where the ball stands quite still, or the heel does not
// and it is the ball that stands.
bool followsBall(const Footing& footing, std::size_t frame) {
  const auto isOver = [frame](const std::vector<bool>& frames) { return frames[frame] && frames[frame - 1]; };
  if (isOver(footing.ballIsHeld) || isOver(footing.heelIsHeld)) {
    return isOver(footing.ballIsHeld);
  }
  const bool isNearBall = footing.ballStands[frame] || footing.ballStands[frame - 1];
  return isOver(footing.ballStands) || (!isOver(footing.heelStands) && isNearBall);
}

// How far the ankle goes from the frame before: as the source's ball does or as its heel does.
Vec3 heldStep(const FootMotion& foot, std::size_t frame, const Footing& footing) {
  return followsBall(footing, frame)
             ? foot.balls[frame] - foot.balls[frame - 1] + foot.toAnkle[frame] - foot.toAnkle[frame - 1]
             : foot.ankles[frame] - foot.ankles[frame - 1];
}

// How far the ankle has to be from its wanted place over a run, for what stands to stand: about nothing on
// the mean.
void holdRun(const FootMotion& foot, const Stand& run, const Footing& footing, std::vector<Vec3>& offsets) {
  Vec3 sum(0.0);
  offsets[run.first] = Vec3(0.0);
  for (std::size_t i = run.first + 1; i <= run.last; ++i) {
    const Vec3 wanted = foot.wanted[i] - foot.wanted[i - 1];
    offsets[i] = offsets[i - 1] + heldStep(foot, i, footing) - wanted;
    sum += offsets[i];
  }
  const Vec3 mean = sum / static_cast<double>(run.last - run.first + 1);
  for (std::size_t i = run.first; i <= run.last; ++i) {
    offsets[i] -= mean;
  }
}

} // namespace

std::vector<Stand> standsOf(const std::vector<Vec3>& places, const std::vector<double>& seconds,
                            double legLength) {
  constexpr double restingSpeed = 0.25; // leg lengths in each second
  constexpr std::size_t fewest = 3;
  std::vector<Stand> stands;
  for (std::size_t first = 0; first + 1 < places.size();) {
    std::size_t last = first;
    while (last + 1 < places.size() && glm::length(places[last + 1] - places[last]) <=
                                           restingSpeed * legLength * (seconds[last + 1] - seconds[last])) {
      ++last;
    }
    if (last - first + 1 >= fewest) {
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
  const std::size_t count = foot.wanted.size();
  const Footing footing{framesOf(foot.ankleStands, count), framesOf(foot.ballStands, count),
                        framesOf(foot.heldAnkles, count), framesOf(foot.heldBalls, count)};
  const std::vector<Stand> runs = joined(foot, runsOf(standingFrames(foot)));
  std::vector<Vec3> places = foot.wanted;
  if (runs.empty()) {
    return places;
  }
  std::vector<Vec3> offsets(places.size(), Vec3(0.0));
  for (const Stand& run : runs) {
    holdRun(foot, run, footing, offsets);
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
