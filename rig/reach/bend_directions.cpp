#include "rig/reach/bend_directions.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "rig/ik/two_bone.h"

namespace stretch::rig {

void BendDirections::add(double timeSeconds, const Vec3& base, const Vec3& joint, const Vec3& end,
                         const Quat& baseRotation) {
  const Vec3 chord = end - base;
  const double reach = glm::length(chord);
  const double length = glm::length(joint - base) + glm::length(end - joint);
  if (!(reach > 1e-6 * length)) {
    return;
  }
  const Vec3 line = chord / reach;
  const Vec3 across = (joint - base) - line * glm::dot(joint - base, line);
  const double height = glm::length(across);
  if (height > straightOfLength * length) {
    seen_.push_back({timeSeconds, glm::inverse(baseRotation) * (across / height), height / length});
  }
}

void BendDirections::keepClear() {
  // Of the limb's length: a joint that is nearer to the line is as much out of it sideways as in its bend.
  constexpr double clear = 0.05;
  Vec3 usual = clear * clear * static_cast<double>(seen_.size()) * unseen_;
  for (const Seen& seen : seen_) {
    usual += seen.height * seen.height * seen.direction;
  }
  std::erase_if(seen_, [&](const Seen& seen) {
    return seen.height < 0.5 * overextendedOfLength && glm::dot(seen.direction, usual) < 0.0;
  });
  std::erase_if(seen_, [&](const Seen& seen) { return seen.height <= clear; });
  if (const double length = glm::length(usual); seen_.empty() && length > 0.0) {
    unseen_ = usual / length;
  }
}

Vec3 BendDirections::at(double timeSeconds) const {
  if (seen_.empty()) {
    return unseen_;
  }
  const auto after = std::ranges::lower_bound(seen_, timeSeconds, {}, &Seen::timeSeconds);
  if (after == seen_.begin()) {
    return seen_.front().direction;
  }
  if (after == seen_.end()) {
    return seen_.back().direction;
  }
  const Seen& before = *(after - 1);
  const double share = (timeSeconds - before.timeSeconds) / (after->timeSeconds - before.timeSeconds);
  const Vec3 mixed = (1.0 - share) * before.direction + share * after->direction;
  const double length = glm::length(mixed);
  constexpr double opposite = 1e-6;
  return length > opposite ? mixed / length : before.direction;
}

} // namespace stretch::rig
