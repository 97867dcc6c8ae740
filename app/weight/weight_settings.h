#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/types.h"
#include "skinning/elastic/moduli.h"

namespace stretch::app {

/// How the flesh of a limb gives way to gravity and to its own inertia (docs/elastic.md, Limbs with weight).
/// SI units, for a character that is taken as 1.75 m tall whatever its file's unit is, so that the same
/// settings look the same on every character.
struct WeightSettings {
  /// Pa. Empty: so stiff that the limb at rest (an arm hanging, a leg under half the body) gives way by
  /// stillSag of its length.
  std::optional<double> youngModulus;
  double density = 1000.0;       ///< kg/m^3
  Vec3 gravity{0.0, -9.81, 0.0}; ///< m/s^2
  double inertia = 1.0;          ///< 0..1: how much of the limb's own acceleration counts.
  double stiffness = 1.0;        ///< Multiplies the moduli and quickens the response.
  double damping = 0.7;          ///< 1 comes to rest without swinging over, below it wobbles.
  double amount = 1.0;           ///< 0..1: share that is shown.
  std::vector<skinning::SegmentModuli::Range> moduli; ///< Bones with a modulus of their own, base first.
  std::optional<Vec2> rangeFrames;                    ///< First and last frame; empty: the whole clip.

  friend bool operator==(const WeightSettings&, const WeightSettings&) = default;
};

inline constexpr double stillSag = 0.025;
inline constexpr double characterSizeMetres = 1.75; ///< Of rig::Body::size.

/// A limb with weight in one clip.
struct WeightedLimb {
  std::string limb; ///< rig::Limb::id; at most one entry for a limb and clip.
  int clip = 0;     ///< Index into the file's animations.
  bool on = true;   ///< Off: kept, but the limb does not give way.
  WeightSettings settings;

  friend bool operator==(const WeightedLimb&, const WeightedLimb&) = default;
};

} // namespace stretch::app
