#pragma once

namespace stretch::rig {

/// How the tip's offset decays back to the original motion (docs/exaggeration.md, Release): 1 at the tip, 0
/// at the end of the release.
class Release {
public:
  Release() = default;
  /// `seconds` >= 0. `overshoot` in [0, 1]: the decay swings to -overshoot before it settles.
  /// `lingerSeconds`: of `seconds`, before the decay begins; no more than these.
  Release(double seconds, double overshoot, double lingerSeconds = 0.0);

  /// `secondsPastTip` >= 0. 1 at 0; 0 past the end (and for every positive time when the release has no
  /// length).
  [[nodiscard]] double at(double secondsPastTip) const;
  [[nodiscard]] double seconds() const { return seconds_; }

private:
  double seconds_ = 0.0;
  double lingerSeconds_ = 0.0;
  double swing_ = 0.0; ///< Factor of the overshoot term.
};

/// 3 u^2 - 2 u^3 on [0, 1], held outside.
[[nodiscard]] double smoothstep(double u);

} // namespace stretch::rig
