#include "rig/rekey/source_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/anim/sampling.h"

namespace stretch::rig {

namespace {

std::size_t widthOf(const Track& track) {
  return static_cast<std::size_t>(track.width);
}

Vec4 numbersAt(const Track& track, std::size_t offset) {
  Vec4 value(0.0);
  for (std::size_t i = 0; i < widthOf(track); ++i) {
    value[i] = static_cast<double>(track.values[offset + i]);
  }
  return value;
}

// Value and derivative per second of the cubic piece between two keys, before normalising.
struct Flow {
  Vec4 value{0.0};
  Vec4 perSecond{0.0};
};

Flow flowBetween(const Key& from, const Key& to, double timeSeconds) {
  const auto start = static_cast<double>(from.time);
  const double length = static_cast<double>(to.time) - start;
  const double u = (timeSeconds - start) / length;
  const double u2 = u * u;
  const double u3 = u2 * u;
  const Vec4 out = length * from.outTangent;
  const Vec4 in = length * to.inTangent;
  Flow flow;
  flow.value = (2 * u3 - 3 * u2 + 1) * from.value + (u3 - 2 * u2 + u) * out + (3 * u2 - 2 * u3) * to.value +
               (u3 - u2) * in;
  flow.perSecond =
      ((6 * u2 - 6 * u) * (from.value - to.value) + (3 * u2 - 4 * u + 1) * out + (3 * u2 - 2 * u) * in) /
      length;
  return flow;
}

Vec4 unit(const Vec4& value) {
  const double length = glm::length(value);
  return length > 1e-12 ? value / length : Vec4(0.0, 0.0, 0.0, 1.0);
}

// Derivative of the normalised curve.
Vec4 alongSphere(const Flow& flow) {
  const double length = glm::length(flow.value);
  const Vec4 direction = unit(flow.value);
  return length > 1e-12 ? (flow.perSecond - direction * glm::dot(direction, flow.perSecond)) / length
                        : Vec4(0.0);
}

constexpr int deepest = 6;
constexpr double tolerance = 1e-7;

bool follows(const SourceCurve& curve, const Key& from, const Key& to) {
  for (const double share : {0.25, 0.5, 0.75}) {
    const double time = static_cast<double>(from.time) * (1.0 - share) + static_cast<double>(to.time) * share;
    if (glm::length(unit(flowBetween(from, to, time).value) - curve.value(time)) > tolerance) {
      return false;
    }
  }
  return true;
}

// Of two times, or the even one that is nearest to it.
float middleOf(const Key& from, const Key& to, double perSecond) {
  const double middle = 0.5 * (static_cast<double>(from.time) + static_cast<double>(to.time));
  return static_cast<float>(perSecond > 0.0 ? std::round(middle * perSecond) / perSecond : middle);
}

void addJointsTo(const SourceCurve& curve, const Key& from, const Key& to, int depth, std::vector<Key>& out) {
  const float middle = middleOf(from, to, curve.jointsPerSecond());
  const float least =
      curve.jointsPerSecond() > 0.0 ? static_cast<float>(0.1 / curve.jointsPerSecond()) : 0.0F;
  if (depth == 0 || !(from.time + least < middle && middle < to.time - least) || follows(curve, from, to)) {
    return;
  }
  const Key joint = curve.cutAt(middle);
  addJointsTo(curve, from, joint, depth - 1, out);
  out.push_back(joint);
  addJointsTo(curve, joint, to, depth - 1, out);
}

} // namespace

Key keyOfSource(const Track& track, std::size_t index) {
  const std::size_t width = widthOf(track);
  Key key;
  key.time = track.times[index];
  key.sourceKey = index;
  if (track.interpolation == Interpolation::cubicSpline) {
    key.inTangent = numbersAt(track, 3 * index * width);
    key.value = numbersAt(track, (3 * index + 1) * width);
    key.outTangent = numbersAt(track, (3 * index + 2) * width);
  } else {
    key.value = numbersAt(track, index * width);
  }
  return key;
}

Vec4 SourceCurve::value(double timeSeconds) const {
  std::array<double, 4> numbers{};
  sampleTrack(track_, timeSeconds, numbers.data());
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Vec4 SourceCurve::slope(double timeSeconds, int side) const {
  if (track_.interpolation != Interpolation::cubicSpline) {
    return Vec4(0.0);
  }
  const auto later = [](double time, float key) { return time < static_cast<double>(key); };
  const auto sooner = [](float key, double time) { return static_cast<double>(key) < time; };
  const auto next = side > 0
                        ? std::upper_bound(track_.times.begin(), track_.times.end(), timeSeconds, later)
                        : std::lower_bound(track_.times.begin(), track_.times.end(), timeSeconds, sooner);
  if (next == track_.times.begin() || next == track_.times.end()) {
    return Vec4(0.0);
  }
  const auto index = static_cast<std::size_t>(next - track_.times.begin());
  const Flow flow = flowBetween(keyOfSource(track_, index - 1), keyOfSource(track_, index), timeSeconds);
  return track_.channel == Channel::rotation ? alongSphere(flow) : flow.perSecond;
}

Key SourceCurve::cutAt(float time) const {
  const auto near = std::find_if(track_.times.begin(), track_.times.end(), [&](float key) {
    return std::abs(static_cast<double>(key) - static_cast<double>(time)) <= sameKey;
  });
  Key key;
  if (near != track_.times.end()) {
    key = keyOfSource(track_, static_cast<std::size_t>(near - track_.times.begin()));
    key.sourceKey.reset();
  } else {
    key.value = value(static_cast<double>(time));
    key.inTangent = slope(static_cast<double>(time), -1);
    key.outTangent = slope(static_cast<double>(time), 1);
  }
  key.time = time;
  return key;
}

void SourceCurve::addJoints(const Key& from, const Key& to, std::vector<Key>& out) const {
  if (track_.interpolation == Interpolation::cubicSpline && track_.channel == Channel::rotation) {
    addJointsTo(*this, from, to, deepest, out);
  }
}

} // namespace stretch::rig
