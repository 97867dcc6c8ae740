#include "skinning/locate/creature/joints_along.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/polyline.h"

namespace stretch::skinning {

namespace {

constexpr std::size_t placeCount = 49; // on a line: bones end at these

double squaredDistance(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length = glm::dot(along, along);
  const double part = length > 0.0 ? std::clamp(glm::dot(point - from, along) / length, 0.0, 1.0) : 0.0;
  const Vec3 off = point - glm::mix(from, to, part);
  return glm::dot(off, off);
}

// What a straight bone between two places of a line misses of what lies between them.
double missed(const std::vector<Vec3>& line, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from + 1; i < to; ++i) {
    sum += squaredDistance(line[i], line[from], line[to]);
  }
  return sum;
}

std::size_t placeAt(double part) {
  return static_cast<std::size_t>(std::lround(std::clamp(part, 0.0, 1.0) * (placeCount - 1.0)));
}

} // namespace

std::vector<Vec3> evenly(const std::vector<Vec3>& line, std::size_t count) {
  std::vector<Vec3> places;
  const double step = polylineLength(line) / std::max(1.0, static_cast<double>(count) - 1.0);
  double before = 0.0; // the length up to the place `next - 1`
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = static_cast<double>(i) * step;
    while (next + 1 < line.size() && before + glm::distance(line[next - 1], line[next]) < wanted) {
      before += glm::distance(line[next - 1], line[next]);
      ++next;
    }
    const double bone = next < line.size() ? glm::distance(line[next - 1], line[next]) : 0.0;
    const double part = bone > 0.0 ? std::clamp((wanted - before) / bone, 0.0, 1.0) : 0.0;
    places.push_back(part > 0.0 ? glm::mix(line[next - 1], line[next], part) : line[next - 1]);
  }
  return places;
}

// Dynamic programming over the joints: for each place the least cost of all bones up to it.
std::vector<Vec3> jointsAlong(const std::vector<Vec3>& line, const std::vector<double>& parts) {
  constexpr double usual = 0.12; // of the length: a joint so far from its part costs as much as
  constexpr double off = 0.02;   // bones that miss the line by so much of it
  constexpr std::size_t shortest = 2;
  constexpr double never = std::numeric_limits<double>::max();
  const std::vector<Vec3> places = evenly(line, placeCount);
  const double length = std::max(polylineLength(places), 1e-12);
  std::vector<std::vector<double>> costs(parts.size(), std::vector<double>(placeCount, never));
  std::vector<std::vector<std::size_t>> before(parts.size(), std::vector<std::size_t>(placeCount, 0));
  costs[0][placeAt(parts.front())] = 0.0;
  for (std::size_t joint = 1; joint < parts.size(); ++joint) {
    const bool isLast = joint + 1 == parts.size();
    for (std::size_t place = 0; place < placeCount; ++place) {
      const double astray = (static_cast<double>(place) / (placeCount - 1.0) - parts[joint]) / usual;
      if (isLast && place != placeAt(parts.back())) {
        continue;
      }
      for (std::size_t from = 0; from + shortest <= place; ++from) {
        if (costs[joint - 1][from] == never) {
          continue;
        }
        const double misses = missed(places, from, place) / placeCount / (off * off * length * length);
        const double cost = costs[joint - 1][from] + misses + astray * astray;
        if (cost < costs[joint][place]) {
          costs[joint][place] = cost;
          before[joint][place] = from;
        }
      }
    }
  }
  std::vector<Vec3> joints(parts.size());
  std::size_t place = placeAt(parts.back());
  for (std::size_t joint = parts.size(); joint-- > 0;) {
    joints[joint] = places[place];
    place = before[joint][place];
  }
  return joints;
}

} // namespace stretch::skinning
