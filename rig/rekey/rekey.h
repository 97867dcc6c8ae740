#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"
#include "rig/rekey/key_places.h"

namespace stretch::rig {

struct RekeyOptions {
  /// How far any joint, and the mesh that turns with it, may be from the exact motion at every frame and half
  /// frame, world units (1e-4 of the height); ten times as far at other times.
  double tolerance = 1e-4;
  KeyPlaces places = KeyPlaces::needed;
};

/// The stretch of one joint over a clip, for its bind leaf: K(t) = A(t) diag(scales) A(t)^T in the joint's
/// space. Between keys scales run straight and axes turn evenly; held before the first and after the last,
/// where K is the identity unless the clip begins or ends stretched.
struct StretchKeys {
  NodeIndex node;
  std::vector<float> times; ///< Seconds, strictly increasing.
  std::vector<Quat> axes; ///< A: turns the x axis onto the bone. One entry when the axes are fixed, else one
                          ///< for each key.
  std::vector<Vec3> scales; ///< One for each key; of a trail alone (s, q, q).

  [[nodiscard]] bool axisIsFixed() const { return axes.size() == 1; }
};

/// A clip with its active trails and the weight of its limbs keyed in.
struct RekeyedClip {
  std::vector<Track> tracks; ///< The tracks that change, whole: keys outside range and release are the
                             ///< source's bit for bit, quaternions perhaps negated after a full turn.
  std::vector<StretchKeys> stretches;
  double largestMiss = 0.0; ///< World units: how far a joint is from the exact motion between whole frames
                            ///< that alone could get keys; 0 where the tolerance is kept.
};

/// Turns the active trails and the weight into keys (docs/exaggeration.md, What saving writes): every key
/// time of the limb's channels in range and release, the tip, the ends, and as few between as the tolerance
/// needs. LINEAR stays LINEAR, CUBICSPLINE keys get tangents along the new path, STEP becomes LINEAR with its
/// steps kept outside as pairs of neighbouring keys.
[[nodiscard]] RekeyedClip rekey(const Scene& scene, const Clip& clip, const MotionState& motion,
                                const RekeyOptions& options);

/// The re-keyed clip as tracks of `clip`, for evaluating what was written: replaced and added tracks,
/// stretches left out.
[[nodiscard]] Clip withTracks(const Clip& clip, const std::vector<Track>& tracks);

} // namespace stretch::rig
