#pragma once

#include <optional>
#include <string>

#include "app/things/place.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

// For the door (place.cpp): what speaks against a thing by itself, whatever else stands in its time.

/// The documents that a thing is checked against.
struct Ground {
  const Document& document;
  const Document& before; ///< Things of this one may stay past the clip's end.
  Entry entry;
  std::optional<rig::ControllerList> controllers; ///< Filled in for adjustments.
};

[[nodiscard]] Status checkAlone(const Ground& ground, const rig::Trail& trail);
[[nodiscard]] Status checkAlone(const Ground& ground, const rig::Adjustment& adjustment);
[[nodiscard]] Status checkAlone(const Ground& ground, const rig::Pin& pin);
[[nodiscard]] Status checkAlone(const Ground& ground, const rig::Grip& grip);
[[nodiscard]] Status checkAlone(const Ground& ground, const rig::Prop& prop);
[[nodiscard]] Status checkAlone(const Ground& ground, const WeightedLimb& weight);

/// Grips that lead in a circle at one time.
[[nodiscard]] Status checkCircles(const rig::Holds& holds);

/// Settings of a trail and its range, without the document.
[[nodiscard]] Status checkValues(const rig::Trail& trail);

/// Whether the document has this clip.
[[nodiscard]] Status checkClip(const Document& document, int clip);

/// Whether the document has this limb (or chain) and this clip; the error says which it lacks.
[[nodiscard]] Status checkLimbAndClip(const Document& document, const std::string& limbId, int clip);

/// The clip's last frame, as far as anything new may reach: infinite for saved work.
[[nodiscard]] double lastFrameFor(const Ground& ground, int clip);

/// A frame, or a range, that is said to lie past the clip's end, with `remedy`.
[[nodiscard]] Error outsideClip(const std::string& what, double lastFrame, const std::string& who);

} // namespace stretch::app
