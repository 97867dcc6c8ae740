#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rig/limb.h"
#include "rig/trail/trail.h"

namespace stretch::rig {

/// Source of a style's numbers.
enum class StyleOrigin {
  measured, ///< Measured in cartoons (docs/exaggeration.md, How far cartoons go); what was not measured is
            ///< the program's default.
  ours,     ///< Made for this program.
  own       ///< The user's.
};

/// How far limbs of one kind are stretched: lengths of the limb over its own.
struct ScaleRange {
  double least = 1.0; ///< Below 1 the limb may be squashed.
  double usual = 1.0; ///< Value that the strongest moments get.
  double most = largestScale;

  friend bool operator==(const ScaleRange&, const ScaleRange&) = default;
};

/// Axes along which limbs are exaggerated.
enum class AxesRule {
  all,
  level ///< Along the ground alone: what strikes at a height stays at it.
};

/// Way in which limbs that move at the same time as a stronger one take part.
struct Spread {
  double limbs = 1.0;      ///< 0..1: share of their exaggeration that other limbs take.
  double trunk = 0.0;      ///< 0..1: share of its exaggeration with which the spine follows a strike.
  double lateFrames = 0.0; ///< So much later than the leading limb the spine follows, frames of 1/24 s.

  friend bool operator==(const Spread&, const Spread&) = default;
};

/// Weight that limbs get which move freely (docs/elastic.md, Limbs with weight).
struct StyleWeight {
  double amount = 0.0; ///< 0..1; 0: none.
  double stiffness = 1.0;
  double damping = 0.7;

  friend bool operator==(const StyleWeight&, const StyleWeight&) = default;
};

/// How a character is exaggerated, as data (docs/styles.md).
struct Style {
  std::string name;
  StyleOrigin origin = StyleOrigin::own;
  ScaleRange arm;
  ScaleRange leg;
  ScaleRange torso; ///< Range of spine and neck.
  ScaleRange other; ///< Range of tails, wings, fins, feelers and chains.
  AxesRule axes = AxesRule::all;
  Reference reference = Reference::pose;
  Bend bend = Bend::keep;
  RemapKind remap = RemapKind::spline;
  Ease easeIn{0.0, 0.1};
  Ease easeOut{0.0, 0.9};
  /// Length of the way back, in lengths of the range; empty: the trail's own (docs/exaggeration.md, Release).
  std::optional<double> release;
  double overshoot = 0.0; ///< 0..1: see TrailSettings; a limb whose plan says more keeps that.
  double volume = 1.0;    ///< 0..1.
  Spread spread;
  StyleWeight weight;

  friend bool operator==(const Style&, const Style&) = default;
};

inline constexpr double longestStyleRelease = 100.0; ///< Style::release, lengths of the range.
inline constexpr std::size_t longestStyleName = 100; ///< Bytes.

/// "measured", "ours", "own".
[[nodiscard]] std::string_view originName(StyleOrigin origin);

/// The styles that the program brings along: the measured episodes in the order of their table, their
/// average, then ours.
[[nodiscard]] const std::vector<Style>& builtInStyles();

/// The style of a name, whatever its case; null when there is none. A part of the name that only one of them
/// has is enough.
[[nodiscard]] const Style* styleNamed(const std::vector<Style>& styles, std::string_view name);

/// The range for limbs of a kind.
[[nodiscard]] const ScaleRange& scalesOf(const Style& style, LimbKind kind);

/// Scale of a limb of this kind: `strength` times as much exaggeration as usual, within the style's range.
[[nodiscard]] double styledScale(const Style& style, LimbKind kind, double strength);

/// Settings with all that the style says of them, the scale too; range, pivot, space, stop and spheres stay.
/// `strength` as for styledScale.
[[nodiscard]] TrailSettings styledSettings(const TrailSettings& settings, const Style& style, LimbKind kind,
                                           double strength);

/// One limb's settings, as a style is taken from them.
struct StyledLimb {
  LimbKind kind = LimbKind::chain;
  TrailSettings settings;
};

/// The style that these settings show: of each kind of limb the range and the largest scale, of everything
/// else what the strongest of them has. A kind without settings gets the scale of the other limbs, a torso
/// none. At least one of `limbs`.
[[nodiscard]] Style styleOf(const std::vector<StyledLimb>& limbs, std::string name);

} // namespace stretch::rig
