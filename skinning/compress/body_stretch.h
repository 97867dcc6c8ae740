#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skinning/compress/body_motion.h"
#include "skinning/elastic/curvature_length.h"
#include "skinning/elastic/cylinder.h"
#include "skinning/elastic/moduli.h"

namespace stretch::skinning {

/// Settings of the elastic model of a body; what is left open is fitted to the frames.
struct BodyStretchSettings {
  Vec3 gravity{0.0, -9.81, 0.0}; ///< m/s^2, in the axes of the mesh.
  double metresPerUnit = 1.0;    ///< Scale of the mesh.
  std::optional<double> mass;    ///< Mass of the whole body, kg; unset: that of water by the body's volume.
  std::optional<double> youngModulus;        ///< Pa; unset: the one that explains the frames best.
  SegmentModuli moduli;                      ///< Segments with a modulus of their own.
  std::optional<double> gravityVolume = 1.0; ///< 1: flattening widens sideways so that the volume is kept; 0:
                                             ///< not at all.
  std::optional<double> muscleVolume = 1.0;  ///< Likewise for the change of length. Unset: fitted, in [0, 1].
  LengthModel lengthModel = LengthModel::automatic;
  std::size_t firstFittedFrame = 0; ///< Frames before it (settling) are left out of all fits.

  friend bool operator==(const BodyStretchSettings&, const BodyStretchSettings&) = default;
};

/// The model with its parameters settled, and what it says of every segment and frame.
struct BodyStretch {
  LengthFunction length;
  double restLength = 0.0; ///< Length of the centre line in the first frame.
  double mass = 0.0;
  double youngModulus = 0.0; ///< Pa; 0 when there is no gravity or nothing that it could explain.
  bool modulusFitted = false;
  double gravityVolume = 1.0;
  double muscleVolume = 1.0;
  std::vector<double> compressions;      ///< q of each segment, mean over the fitted frames.
  std::vector<CurvatureLength> measured; ///< Curvature and length of every frame.
  std::vector<Vec3> loadAxes; ///< Across each segment in the bind pose: the mean direction of the load.
  bool loadTurns = false;     ///< The load turns around the body so much that its axes differ frame by frame.
  /// Frame after frame, one for each segment: factors, and the direction that withLoad scales, in the bind
  /// pose.
  std::vector<StretchFactors> factors;
  std::vector<Vec3> loadDirections;
  std::vector<std::string> warnings;
};

/// Gravity flattens every segment (Eq. 6), curvature shortens the body (Eqs. 7, 8). Errors: settings that
/// make no sense.
[[nodiscard]] Result<BodyStretch> stretchOfBody(const BodyMotion& body, const BodyStretchSettings& settings);

/// The directions of the load alone (loadAxes, loadDirections, loadTurns), for bones that are fitted to the
/// frames.
[[nodiscard]] BodyStretch loadOfBody(const BodyMotion& body, const Vec3& gravity);

} // namespace stretch::skinning
