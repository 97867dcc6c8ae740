#include "skinning/export/key_reduction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/math/types.h"

namespace stretch::skinning {
namespace {

Vec3 vectorAt(const Course& course, std::size_t frame) {
  return {course[3 * frame], course[3 * frame + 1], course[3 * frame + 2]};
}

Quat rotationAt(const Course& course, std::size_t frame) {
  return glm::normalize(
      Quat(static_cast<double>(course[4 * frame + 3]), static_cast<double>(course[4 * frame]),
           static_cast<double>(course[4 * frame + 1]), static_cast<double>(course[4 * frame + 2])));
}

double angleBetween(const Quat& a, const Quat& b) {
  const Quat difference = glm::conjugate(a) * b;
  return 2.0 *
         std::atan2(glm::length(Vec3(difference.x, difference.y, difference.z)), std::abs(difference.w));
}

/// How far `frame` is from what is interpolated between two others.
double missAt(const Course& course, std::size_t width, std::size_t from, std::size_t to, std::size_t frame) {
  const double share = to == from ? 0.0 : static_cast<double>(frame - from) / static_cast<double>(to - from);
  if (width == 4) {
    return angleBetween(glm::slerp(rotationAt(course, from), rotationAt(course, to), share),
                        rotationAt(course, frame));
  }
  return glm::length(glm::mix(vectorAt(course, from), vectorAt(course, to), share) - vectorAt(course, frame));
}

bool spans(const Course& course, std::size_t width, std::size_t from, std::size_t to, double bound) {
  for (std::size_t frame = from + 1; frame < to; ++frame) {
    if (missAt(course, width, from, to, frame) > bound) {
      return false;
    }
  }
  return true;
}

} // namespace

std::vector<std::size_t> keysWithin(const Course& course, std::size_t width, double bound) {
  const std::size_t frames = course.size() / width;
  if (!(bound > 0.0)) {
    std::vector<std::size_t> all(frames);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  std::vector<std::size_t> keys{0};
  while (keys.back() + 1 < frames) {
    std::size_t next = keys.back() + 1;
    while (next + 1 < frames && spans(course, width, keys.back(), next + 1, bound)) {
      ++next;
    }
    keys.push_back(next);
  }
  return keys;
}

bool staysWithin(const Course& course, std::size_t width, double bound) {
  for (std::size_t frame = 1; frame < course.size() / width; ++frame) {
    if (missAt(course, width, 0, 0, frame) > bound) {
      return false;
    }
  }
  return true;
}

} // namespace stretch::skinning
