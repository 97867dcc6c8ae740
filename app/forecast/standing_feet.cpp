#include "app/forecast/standing_feet.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace stretch::app {

std::vector<Stretch> standingIn(const std::vector<Vec3>& places, double framesPerSecond, double height) {
  constexpr double nearLowest = 0.01; // of the height
  constexpr double slow = 0.05;       // of the height per second
  constexpr std::size_t fewest = 3;
  std::vector<Stretch> stretches;
  if (places.empty()) {
    return stretches;
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
      stretches.push_back({first, frame - 1});
    }
    first = frame;
  }
  return stretches;
}

double wanderIn(const std::vector<Vec3>& places, const Stretch& frames) {
  double farthest = 0.0;
  for (std::size_t frame = frames.first; frame <= frames.last; ++frame) {
    farthest = std::max(farthest, glm::length(places[frame] - places[frames.first]));
  }
  return farthest;
}

} // namespace stretch::app
