#include "rig/retarget/footing.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

Vec3 meanOver(const Stand& stand, const std::vector<Vec3>& wishes) {
  Vec3 sum(0.0);
  for (std::size_t frame = stand.first; frame <= stand.last; ++frame) {
    sum += wishes[frame];
  }
  return sum / static_cast<double>(stand.last - stand.first + 1);
}

} // namespace

std::vector<Stand> standsOf(const std::vector<Vec3>& places, const std::vector<double>& seconds,
                            double legLength) {
  constexpr double restingSpeed = 0.25; // leg lengths a second
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

std::vector<Vec3> heldOver(const std::vector<Stand>& stands, std::vector<Vec3> wishes) {
  if (stands.empty()) {
    return wishes;
  }
  std::vector<Vec3> means;
  means.reserve(stands.size());
  for (const Stand& stand : stands) {
    means.push_back(meanOver(stand, wishes));
  }
  std::size_t next = 0; // the stand that ends at the frame or later
  for (std::size_t frame = 0; frame < wishes.size(); ++frame) {
    while (next < stands.size() && stands[next].last < frame) {
      ++next;
    }
    if (next == stands.size()) {
      wishes[frame] = means.back();
    } else if (next == 0 || stands[next].first <= frame) {
      wishes[frame] = means[next];
    } else {
      const std::size_t left = stands[next - 1].last;
      const double share =
          static_cast<double>(frame - left) / static_cast<double>(stands[next].first - left);
      const double eased = smoothstep(share);
      wishes[frame] = (1.0 - eased) * means[next - 1] + eased * means[next];
    }
  }
  return wishes;
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
