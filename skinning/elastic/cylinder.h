#pragma once

namespace stretch::skinning {

/// A segment of a body as the stretching model sees it: a cylinder of homogeneous, isotropic material. One
/// consistent set of units (SI: metres, kilograms, pascals).
struct Cylinder {
  double length = 1.0;       ///< l
  double width = 1.0;        ///< w: the diameter across the load.
  double mass = 1.0;         ///< m
  double youngModulus = 1.0; ///< E
};

/// How far gravity flattens a cylinder that lies across it: Eq. 6 of the paper with its integral written out,
/// dw = F pi / (2 E l), F = m g. `gravityAcross` is the acceleration perpendicular to the axis. 0 for a
/// cylinder without length or stiffness.
[[nodiscard]] double gravityDisplacement(const Cylinder& cylinder, double gravityAcross);

/// Compression factor q = dw / w, clamped to [0, 0.5]. Past `largestSmallStrain` the model's assumption of
/// small deformations is broken.
[[nodiscard]] double compressionFactor(const Cylinder& cylinder, double gravityAcross);

inline constexpr double largestSmallStrain = 0.2;
inline constexpr double largestCompression = 0.5;

/// Scale along the axis of a cylinder under an axial force (positive: pulled): 1 + F / (E A), A = volume /
/// length, clamped to [0.5, 2]. 1 for a cylinder without volume or stiffness.
[[nodiscard]] double axialScale(double axialForce, double youngModulus, double volume, double length);

/// Factors of one segment: along its axis, along the load across it, and perpendicular to both.
struct StretchFactors {
  double along = 1.0;
  double withLoad = 1.0;
  double sideways = 1.0;
};

/// Flattened by q: 1 - q with the load, (1 - q)^-volume sideways (volume 1 keeps the volume, as the paper has
/// it), then scaled along the axis and by along^(-crossVolume / 2) across.
[[nodiscard]] StretchFactors combine(double compression, double along, double volume = 1.0,
                                     double crossVolume = 1.0);

} // namespace stretch::skinning
