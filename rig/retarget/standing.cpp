#include "rig/retarget/standing.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "rig/trail/release.h"

namespace stretch::rig {

std::vector<Stand> standingIn(const std::vector<Vec3>& places, double framesPerSecond, double height) {
  constexpr double nearLowest = 0.01; // of the height
  constexpr double slow = 0.05;       // of the height per second
  constexpr std::size_t fewest = 3;
  std::vector<Stand> stands;
  if (places.empty()) {
    return stands;
  }
  const double lowest = std::ranges::min_element(places, {}, &Vec3::y)->y;
  const auto isLow = [&](std::size_t frame) { return places[frame].y < lowest + nearLowest * height; };
  std::size_t first = 0;
  for (std::size_t frame = 1; frame <= places.size(); ++frame) {
    if (frame < places.size() && isLow(frame) && isLow(frame - 1) &&
        glm::length(places[frame] - places[frame - 1]) * framesPerSecond < slow * height) {
      continue;
    }
    if (frame - first >= fewest) {
      stands.push_back({first, frame - 1});
    }
    first = frame;
  }
  return stands;
}

double wanderIn(const std::vector<Vec3>& places, const Stand& frames) {
  double farthest = 0.0;
  for (std::size_t frame = frames.first; frame <= frames.last; ++frame) {
    farthest = std::max(farthest, glm::length(places[frame] - places[frames.first]));
  }
  return farthest;
}

std::vector<Vec3> heldInPlace(const std::vector<Vec3>& places, const std::vector<Stand>& stands) {
  if (stands.empty()) {
    return places;
  }
  std::vector<Vec3> offsets(places.size(), Vec3(0.0));
  for (const Stand& stand : stands) {
    Vec3 sum(0.0);
    for (std::size_t i = stand.first; i <= stand.last; ++i) {
      sum += places[i];
    }
    const Vec3 middle = sum / static_cast<double>(stand.last - stand.first + 1);
    for (std::size_t i = stand.first; i <= stand.last; ++i) {
      offsets[i] = middle - places[i];
    }
  }
  carryOver(stands, offsets);
  std::vector<Vec3> held;
  held.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    held.push_back(places[i] + offsets[i]);
  }
  return held;
}

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

} // namespace stretch::rig
