#pragma once

#include <optional>
#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// One movement of a limb that is worth exaggerating: its end, seen from its base, goes from where it is slow
/// or turns, fast, to where it is slow or turns again.
struct Stroke {
  double startFrame = 0.0;
  double endFrame = 0.0;
  double travel = 0.0;    ///< From start to end, limb lengths.
  double peakSpeed = 0.0; ///< Limb lengths per second.

  friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// The strokes of a limb in a clip, in order of time; they share at most their ends. What only trembles or
/// creeps is none. Measured in limb lengths and seconds, so that size and frame rate do not matter.
[[nodiscard]] std::vector<Stroke> strokesOf(const Scene& scene, const Clip& clip, const Limb& limb);

/// The stroke in which the frame lies; of two that meet there the stronger. Between strokes the strongest of
/// those within `nearFrames`, else the nearest one. Null without strokes.
[[nodiscard]] const Stroke* strokeAt(const std::vector<Stroke>& strokes, double frame,
                                     double nearFrames = 0.0);

/// The one that goes farthest, fastest; null without strokes.
[[nodiscard]] const Stroke* strongestStroke(const std::vector<Stroke>& strokes);

/// For a limb that makes no stroke, finds where within at most `mostFrames` frames its end, seen from its
/// base, gets farthest. Nothing where it stands still.
[[nodiscard]] std::optional<Stroke> greatestMovement(const Scene& scene, const Clip& clip, const Limb& limb,
                                                     double mostFrames);

} // namespace stretch::rig
