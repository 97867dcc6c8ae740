#pragma once

#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/body/reading/detection.h"

namespace stretch::rig {

/// A stroke of a limb; one that a clip which loops repeats, as steps are; a fall of the body that feet stop.
enum class MomentKind { stroke, cycle, landing };

/// "stroke", "cycle" or "landing".
[[nodiscard]] const char* momentKindName(MomentKind kind);

/// The limb's name of a moment of the whole body.
inline constexpr const char* wholeBody = "body";

/// A motion that is worth exaggerating (docs/moments.md): from where a limb's end, seen from its base, is
/// slow or turns, fast, to its extreme, where it is slow or turns again.
struct Moment {
  std::string limb; ///< Id of the limb; wholeBody for a landing.
  MomentKind kind = MomentKind::stroke;
  double startFrame = 0.0; ///< Whole frame of the wind-up; of a landing where feet begin to carry the body.
  double tipFrame = 0.0;   ///< Frame of the extreme; of a landing where the hips are lowest.
  double endFrame = 0.0;   ///< Last frame of the range to exaggerate; at the tip.
  double strength = 0.0;   ///< Reaches per second (docs/moments.md, Strength).

  friend bool operator==(const Moment&, const Moment&) = default;
};

/// The moments of a clip, strongest first, cycles after the others. Of each limb of the body and of `chains`;
/// those of one limb share at most their ends. Whatever is weaker than `leastStrength` or trembles is left
/// out, as is a slow sway on feet that stand throughout, so an idle clip has none; nor has one that is called
/// an idle ("idle" is the last word of its name), ends where it began, never strikes and has no cycle. Frames
/// of the clip's own rate, measured on the clip without any trail.
[[nodiscard]] std::vector<Moment> momentsOf(const Scene& scene, const Clip& clip, const Body& body,
                                            const std::vector<Limb>& chains = {});

/// The moment in which the frame lies; of several the strongest. Between moments the strongest of those
/// within `nearFrames`, else the nearest one. Null without moments.
[[nodiscard]] const Moment* momentAt(const std::vector<Moment>& moments, double frame,
                                     double nearFrames = 0.0);

/// Null without moments.
[[nodiscard]] const Moment* strongestMoment(const std::vector<Moment>& moments);

/// Strength that every moment has: a median strike has 21, a breath far less. Reaches per second.
inline constexpr double leastStrength = 0.5;

} // namespace stretch::rig
