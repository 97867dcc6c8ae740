#include "rig/rekey/stretch_frames.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"

namespace stretch::rig {

namespace {

constexpr double negligible = 1e-7; // of K

Mat3 stretchAt(ExactMotion& exact, NodeIndex node, double timeSeconds) {
  const FrameState& frame = exact.at(timeSeconds);
  return frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(node)];
}

Mat3 seenFrom(const Quat& axes, const Mat3& stretch) {
  const Mat3 turn = glm::mat3_cast(axes);
  return glm::transpose(turn) * stretch * turn;
}

double offDiagonal(const Mat3& m) {
  return std::max({std::abs(m[0][1]), std::abs(m[0][2]), std::abs(m[1][2])});
}

Vec3 diagonal(const Mat3& m) {
  return {m[0][0], m[1][1], m[2][2]};
}

// The turn about the third axis, by at most 45 degrees, that makes m[p][q] of a symmetric m zero.
Quat jacobiTurn(const Mat3& m, int p, int q) {
  const double ratio = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
  const double tangent = std::copysign(1.0, ratio) / (std::abs(ratio) + std::sqrt(1.0 + ratio * ratio));
  Vec3 axis(0.0);
  axis[3 - p - q] = (q - p == 1) ? -1.0 : 1.0;
  return axisAngle(axis, std::atan(tangent));
}

// How far K is from being the same in all directions.
double strength(const Mat3& stretch) {
  const Mat3 rest = stretch - Mat3((stretch[0][0] + stretch[1][1] + stretch[2][2]) / 3.0);
  return glm::length(rest[0]) + glm::length(rest[1]) + glm::length(rest[2]);
}

} // namespace

Mat3 StretchFrame::matrix() const {
  const Mat3 turn = glm::mat3_cast(axes);
  Mat3 scaled = turn;
  for (int i = 0; i < 3; ++i) {
    scaled[i] *= factors[i];
  }
  return scaled * glm::transpose(turn);
}

StretchFrame frameNear(const Mat3& stretch, const Quat& near) {
  constexpr int mostSweeps = 12;
  StretchFrame frame{near, Vec3(1.0)};
  Mat3 seen = seenFrom(frame.axes, stretch);
  for (int sweep = 0; sweep < mostSweeps && offDiagonal(seen) > negligible; ++sweep) {
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      if (std::abs(seen[p][q]) > negligible) {
        frame.axes = glm::normalize(frame.axes * jacobiTurn(seen, p, q));
        seen = seenFrom(frame.axes, stretch);
      }
    }
  }
  frame.factors = diagonal(seen);
  return frame;
}

StretchFrame mainFrame(const Mat3& stretch) {
  const StretchFrame any = frameNear(stretch, Quat(1.0, 0.0, 0.0, 0.0));
  const Vec3& f = any.factors;
  const Vec3 apart(std::abs(2.0 * f.x - f.y - f.z), std::abs(2.0 * f.y - f.x - f.z),
                   std::abs(2.0 * f.z - f.x - f.y));
  const int main = apart.x >= apart.y && apart.x >= apart.z ? 0 : (apart.y >= apart.z ? 1 : 2);
  return frameNear(stretch, shortestArc(Vec3(1, 0, 0), glm::mat3_cast(any.axes)[main]));
}

Mat3 between(const StretchFrame& a, const StretchFrame& b, double t) {
  return StretchFrame{glm::slerp(a.axes, b.axes, t), a.factors + (b.factors - a.factors) * t}.matrix();
}

StretchFrames::StretchFrames(NodeIndex node, std::vector<double> times, const std::vector<Mat3>& stretches)
    : node_(node), times_(std::move(times)), axes_(times_.size()) {
  std::size_t strongest = 0;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    strongest = strength(stretches[i]) > strength(stretches[strongest]) ? i : strongest;
  }
  axes_[strongest] = mainFrame(stretches[strongest]).axes;
  for (std::size_t i = strongest + 1; i < times_.size(); ++i) {
    axes_[i] = frameNear(stretches[i], axes_[i - 1]).axes;
  }
  for (std::size_t i = strongest; i > 0; --i) {
    axes_[i - 1] = frameNear(stretches[i - 1], axes_[i]).axes;
  }
  constexpr double unseen = 1e-5;
  const Quat main = axes_[strongest];
  if (std::ranges::all_of(
          stretches, [&](const Mat3& stretch) { return offDiagonal(seenFrom(main, stretch)) < unseen; })) {
    axes_ = {main};
  }
}

StretchFrame StretchFrames::at(ExactMotion& exact, double timeSeconds) const {
  const Mat3 stretch = stretchAt(exact, node_, timeSeconds);
  if (axesAreFixed()) {
    return {axes_.front(), diagonal(seenFrom(axes_.front(), stretch))};
  }
  const auto next = std::lower_bound(times_.begin(), times_.end(), timeSeconds);
  std::size_t index = std::min(static_cast<std::size_t>(next - times_.begin()), times_.size() - 1);
  if (index > 0 && timeSeconds - times_[index - 1] < times_[index] - timeSeconds) {
    --index;
  }
  return frameNear(stretch, axes_[index]);
}

} // namespace stretch::rig
