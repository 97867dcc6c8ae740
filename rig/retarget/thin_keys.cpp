#include "rig/retarget/thin_keys.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

// The keys to keep, where `misses(a, b, i)` says whether key i is lost between its neighbours a and b.
template <typename Misses>
std::vector<std::size_t> keptKeys(std::size_t count, const Misses& misses) {
  const auto holds = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from + 1; i < to; ++i) {
      if (misses(from, to, i)) {
        return false;
      }
    }
    return true;
  };
  std::vector<std::size_t> kept{0};
  while (kept.back() + 1 < count) {
    const std::size_t from = kept.back();
    // Twice as far each time, then back to the farthest that holds.
    std::size_t good = from + 1;
    std::size_t bad = count;
    for (std::size_t step = 2; from + step < count; step *= 2) {
      if (!holds(from, from + step)) {
        bad = from + step;
        break;
      }
      good = from + step;
    }
    if (bad == count && holds(from, count - 1)) {
      good = count - 1;
    }
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (holds(from, middle) ? good : bad) = middle;
    }
    kept.push_back(good);
  }
  return kept;
}

double shareOf(const std::vector<float>& times, std::size_t from, std::size_t to, std::size_t i) {
  const auto start = static_cast<double>(times[from]);
  return (static_cast<double>(times[i]) - start) / (static_cast<double>(times[to]) - start);
}

Track emptyTrack(NodeIndex node, Channel channel, int width) {
  Track track;
  track.node = node;
  track.channel = channel;
  track.width = width;
  return track;
}

} // namespace

Track thinTurns(NodeIndex node, const std::vector<float>& times, std::vector<Quat> turns, double radians) {
  for (std::size_t i = 1; i < turns.size(); ++i) {
    turns[i] = glm::dot(turns[i], turns[i - 1]) < 0.0 ? -turns[i] : turns[i];
  }
  const double alike = std::cos(0.5 * radians);
  const auto misses = [&](std::size_t from, std::size_t to, std::size_t i) {
    const Quat between = glm::slerp(turns[from], turns[to], shareOf(times, from, to, i));
    return std::abs(glm::dot(between, turns[i])) < alike;
  };
  const auto isLike = [&](const Quat& turn) { return std::abs(glm::dot(turn, turns.front())) >= alike; };
  const bool isStill = std::ranges::all_of(turns, isLike);
  Track track = emptyTrack(node, Channel::rotation, 4);
  for (const std::size_t i : isStill ? std::vector<std::size_t>{0} : keptKeys(turns.size(), misses)) {
    const Quat& q = turns[i];
    track.times.push_back(times[i]);
    track.values.insert(track.values.end(), {static_cast<float>(q.x), static_cast<float>(q.y),
                                             static_cast<float>(q.z), static_cast<float>(q.w)});
  }
  return track;
}

Track thinPlaces(NodeIndex node, const std::vector<float>& times, const std::vector<Vec3>& places,
                 double distance) {
  const auto misses = [&](std::size_t from, std::size_t to, std::size_t i) {
    const Vec3 between = glm::mix(places[from], places[to], shareOf(times, from, to, i));
    return glm::length(between - places[i]) > distance;
  };
  Track track = emptyTrack(node, Channel::translation, 3);
  for (const std::size_t i : keptKeys(places.size(), misses)) {
    track.times.push_back(times[i]);
    track.values.insert(track.values.end(), {static_cast<float>(places[i].x), static_cast<float>(places[i].y),
                                             static_cast<float>(places[i].z)});
  }
  return track;
}

} // namespace stretch::rig
