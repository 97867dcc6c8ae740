#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/math/monotone_curve.h"
#include "core/math/types.h"
#include "rig/trail/seen_tip.h"
#include "rig/trail/trail.h"

namespace stretch::rig {

/// Request that a camera makes of a path.
struct SightWish {
  CameraPlace camera; ///< In the trail's space, at the tip's time.
  bool asSeen = false;
  bool keepDepth = true;
  double largestTurnRadians = 0.0; ///< Sight::turnDegrees.
};

/// Input from which the tip is solved: one path in the trail's space (docs/exaggeration.md, The tip).
struct TipProblem {
  std::vector<Vec3> points;  ///< The original path in time order; at least one.
  std::vector<Vec3> between; ///< Further points of it: they count for how far it gets from the pivot, no
                             ///< more.
  Vec3 basePosition{0.0};    ///< P0: the limb's base at the tip's time.
  double limbLength = 0.0;   ///< L: the length that `scale` multiplies (pose or rest), > 0.
  double scale = 1.0;        ///< S.
  std::array<bool, 3> axes{true, true, true};
  Pivot pivot = Pivot::start;
  bool pull = true;
  double turnLimitRadians = pi;        ///< TrailSettings::turnLimitDegrees; not asked where a camera counts.
  std::optional<SightWish> sight = {}; ///< Nothing: no camera looks.
};

/// Why a tip is not at the wanted length, or that it is.
enum class TipOutcome {
  reached, ///< |P2 - P0| = S L on the line of the trail.
  pulled,  ///< Off the line, by the pull; the length may still differ when axes are off.
  closest, ///< Not reachable and pull is off, or the turn is limited with an axis off: as near as it gets.
  nothingToScale ///< No active axis, or the path does not move.
};

/// The exaggeration of one path: E(c) = O + (I + (S' - 1) M)(c - O), or E(c) = c + shift where the path comes
/// back on itself.
struct TipSolution {
  Vec3 pivotPoint{0.0};             ///< O.
  Vec3 originalTip{0.0};            ///< P1.
  Vec3 tip{0.0};                    ///< P2, the pull included.
  std::optional<double> trailScale; ///< S'; empty when the path is moved.
  Vec3 shift{0.0};                  ///< Added to the path as a whole when it is moved.
  Vec3 pull{0.0};                   ///< Added with the weight w.
  std::array<bool, 3> axes{true, true, true};
  bool moved = false;
  TipOutcome outcome = TipOutcome::reached;
  double wantedLength = 0.0;  ///< S L; where the scale counts as seen, the length that is reached.
  double reachedLength = 0.0; ///< |tip - P0|.
  int farthestSample = 0;     ///< Index of the point farthest from the pivot along the active axes: a better
                              ///< range end when moved.

  /// Whether the limb comes to the wanted length within 1e-4 of it, as seen where it counts so.
  [[nodiscard]] bool reached() const;

  std::optional<SeenTip> seen;    ///< For a scale that counts as seen: what `reached` answers then.
  std::optional<Vec3> keepsDepth; ///< Unit direction of the view along which E leaves points where they are.
  Vec3 base{0.0};                 ///< P0, about which the path is turned.
  std::optional<Quat> turn;       ///< Turn of the fully exaggerated path; nothing: none.
};

/// Never fails and never divides by nothing: see TipOutcome.
[[nodiscard]] TipSolution solveTip(const TipProblem& problem);

/// E(c), fully exaggerated, without pull.
[[nodiscard]] Vec3 exaggeratePoint(const TipSolution& solution, const Vec3& point);
/// Whether a path that gets `extent` away from its pivot only trembles, as a foot that stands: it is short
/// for the limb, and wanders about instead of going anywhere.
[[nodiscard]] bool onlyTrembles(const std::vector<Vec3>& points, double extent, double limbLength);

/// Ratio of each sample (docs/exaggeration.md, The path and its ratio): length of the path from the pivot's
/// end over the whole, 0 at the pivot and 1 at the tip; the fraction of time for a path of no length.
/// `timesSeconds` increases and has one entry for each point.
[[nodiscard]] std::vector<double> pathRatios(const std::vector<Vec3>& points,
                                             const std::vector<double>& timesSeconds, Pivot pivot);

/// The remap w(r) (docs/exaggeration.md, Remap and ease). Ease percents outside their range are clamped so
/// that percent in + out < 1.
class Remap {
public:
  Remap(RemapKind kind, const Ease& easeIn, const Ease& easeOut);

  [[nodiscard]] double at(double ratio) const;

private:
  std::vector<Vec2> points_;
  std::optional<MonotoneCurve> spline_;
};

} // namespace stretch::rig
