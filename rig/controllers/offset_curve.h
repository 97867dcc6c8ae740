#pragma once

#include <array>
#include <limits>
#include <vector>

#include "rig/controllers/adjustment.h"

namespace stretch::rig {

/// Offset that an adjustment gives at one time.
struct Offset {
  Vec3 move{0.0};
  Vec3 turn{0.0};
  double value = 0.0;

  friend bool operator==(const Offset&, const Offset&) = default;
};

/// The curve through the keys of one adjustment (docs/controllers.md, Keys).
class OffsetCurve {
public:
  /// `standard`: the value of an attribute where nothing is keyed; 0 for a controller.
  OffsetCurve(const Adjustment& adjustment, double standard, double framesPerSecond);

  /// Held before the first and after the last key; outside of the range nothing and the standard value.
  [[nodiscard]] Offset at(double timeSeconds) const;

  [[nodiscard]] bool covers(double timeSeconds) const;
  /// The range; from minus to plus infinity where there is none.
  [[nodiscard]] double startSeconds() const { return start_; }
  [[nodiscard]] double endSeconds() const { return end_; }
  /// Whether the curve jumps at the ends of its range.
  [[nodiscard]] bool jumpsAtStart() const;
  [[nodiscard]] bool jumpsAtEnd() const;
  /// When it jumps inside: at a key after a stepped one that has another value.
  [[nodiscard]] std::vector<double> jumpSeconds() const;
  [[nodiscard]] std::vector<double> keySeconds() const;

private:
  static constexpr std::size_t width = 7; // move, turn, value
  using Numbers = std::array<double, width>;
  struct Key {
    double timeSeconds = 0.0;
    Numbers numbers{};
    Numbers inSlopes{};  // per second
    Numbers outSlopes{}; // per second
    bool holds = false;
  };
  [[nodiscard]] double slopeAt(std::size_t key, std::size_t number, KeyInterpolation interpolation,
                               double given, int side) const;
  [[nodiscard]] Numbers rest() const;

  std::vector<Key> keys_;
  double standard_ = 0.0;
  double start_ = -std::numeric_limits<double>::infinity();
  double end_ = std::numeric_limits<double>::infinity();
};

} // namespace stretch::rig
