#include "app/things/time_map.h"

#include "core/anim/frames.h"

namespace stretch::app {

bool TimeMap::isInside(double frame) const {
  return isWithinFrames(first, last, frame);
}

double TimeMap::rounded(double frame) const {
  const double whole = std::round(frame);
  return std::abs(frame - whole) < rounding ? whole : frame;
}

double TimeMap::operator()(double frame) const {
  if (frame <= first) {
    return frame;
  }
  return rounded(isInside(frame) ? stays + (frame - stays) * factor
                 : movesAfter    ? frame + newLast() - last
                                 : std::max(frame, newLast()));
}

double TimeMap::lengthFrom(double frame, double length) const {
  const double end = frame + length;
  if (isInside(frame) && isInside(end)) {
    return rounded(std::abs(length) * factor);
  }
  const double inside = std::abs(std::clamp(end, first, last) - std::clamp(frame, first, last));
  return rounded(inside * factor + std::abs(length) - inside);
}

bool TimeMap::givesWay(double frame) const {
  return leaves(frame) && frame <= newLast() + frameTolerance;
}

bool TimeMap::leaves(double frame) const {
  return !movesAfter && frame > last + frameTolerance;
}

} // namespace stretch::app
