#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/math/types.h"
#include "skinning/elastic/cylinder.h"
#include "skinning/elastic/moduli.h"

namespace stretch::skinning {

/// A bone of a limb as the elastic model sees it. Metres.
struct LimbSegment {
  double length = 0.0;
  double width = 0.0;  ///< Mean shape diameter of the surface around it.
  double volume = 0.0; ///< Volume of the flesh; a cylinder's where nothing better is known.
};

/// Cylinders from lengths and widths.
[[nodiscard]] std::vector<LimbSegment> limbSegments(const std::vector<double>& lengths,
                                                    const std::vector<double>& widths);

/// How a limb moves over a clip: world space, metres, seconds.
struct LimbMotion {
  double framesPerSecond = 30.0;
  std::vector<std::vector<Vec3>> joints; ///< Joints in each frame: base first, end last; one more than
                                         ///< segments.
  /// How much the limb stands on its end in each frame, 0..1; empty: it hangs free throughout.
  std::vector<double> planted;
  /// Part of the body above that rests on the limb when it is planted, kg for each frame; empty: none.
  std::vector<double> carriedMass;
};

/// The artist's controls.
struct LimbElasticity {
  double youngModulus = 3e5;     ///< Pa: how stiff the flesh is.
  SegmentModuli moduli;          ///< Segments with a modulus of their own.
  double density = 1000.0;       ///< kg/m^3
  Vec3 gravity{0.0, -9.81, 0.0}; ///< m/s^2; zero leaves inertia alone.
  double inertia = 1.0;          ///< 0..1: how much of the segment's own acceleration counts.
  double stiffness = 1.0;        ///< Multiplies the moduli and quickens the response.
  double damping = 0.7; ///< Damping of the response: 1 comes to rest without swinging over, below it wobbles.
  double amount = 1.0;  ///< 0..1: share of the strain that is shown; 0 is the clip as it was.
};

/// Stretch of one segment in one frame.
struct LimbStretch {
  StretchFactors factors;       ///< All 1 where nothing pulls.
  Vec3 along{1.0, 0.0, 0.0};    ///< World direction of the segment, base to end.
  Vec3 withLoad{0.0, 1.0, 0.0}; ///< World direction across the segment that factors.withLoad scales.
};

/// Stretch of every segment in every frame (frame first). The load is gravity minus the segment's
/// acceleration: across the segment it flattens (Eq. 6), along it a free limb hangs from its base with all
/// segments beyond, a planted one stands on its end under all before it and what it carries. The acceleration
/// is smoothed over a tenth of a second, whatever the frame rate; it should be 24 frames per second or more.
/// The load passes through a damped spring that starts at rest, so a landing squashes and rings out, a swing
/// stretches, a still pose sags and stays. Errors: frames whose joints do not match the segments, no finite
/// numbers, settings out of range.
[[nodiscard]] Result<std::vector<std::vector<LimbStretch>>>
limbElasticity(const std::vector<LimbSegment>& segments, const LimbMotion& motion,
               const LimbElasticity& settings);

struct PlantedSettings {
  double speed = 0.35;             ///< Limb lengths per second: a planted end moves slower.
  double height = 0.06;            ///< Limb lengths: and is no higher than this above its lowest.
  std::optional<double> ground;    ///< Height of the ground along `up`; empty: the lowest that the end gets.
  double fadeSeconds = 1.0 / 15.0; ///< Over which planted and free fade into each other, on either side.
};

/// How much the end of a limb stands on the ground in each frame, 0..1: slow and near its lowest height along
/// `up`. Half of the fade lies within the time that it stands.
[[nodiscard]] std::vector<double> plantedWeights(const std::vector<Vec3>& end, double framesPerSecond,
                                                 double limbLength, const Vec3& up,
                                                 const PlantedSettings& settings = {});

/// How much the end of a limb touches the ground in each frame, 0..1: 1 wherever it is near its lowest height
/// along `up`, however fast; the fade lies before and after that. Of `settings` speed does not count.
[[nodiscard]] std::vector<double> touchingWeights(const std::vector<Vec3>& end, double framesPerSecond,
                                                  double limbLength, const Vec3& up,
                                                  const PlantedSettings& settings = {});

/// Mass of a body that each limb carries, frame by frame, when the limbs stand as much as their weights say:
/// the mass is shared among them in that proportion. One list of weights for each limb, all of one length.
[[nodiscard]] std::vector<std::vector<double>> sharedMass(const std::vector<std::vector<double>>& planted,
                                                          double bodyMass);

} // namespace stretch::skinning
