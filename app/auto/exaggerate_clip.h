#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "rig/moments/moments.h"
#include "rig/styles/style.h"

namespace stretch::app {

// A whole clip exaggerated at once: its moments (docs/moments.md) in one style (docs/styles.md).

struct AutoSettings {
  rig::Style style;
  double strength = 1.0; ///< 0..2: how much of the style's exaggeration; 0 is none.
  /// Further moments of the clip: they get no trail, and others count as weak beside them all the same.
  std::vector<rig::Moment> beside = {};
};

/// Outcome for one moment of the clip.
struct AutoMoment {
  rig::Moment moment;
  int trailId = 0;      ///< Trail that was made for it; 0: none.
  double scale = 1.0;   ///< Scale of that trail.
  bool isLevel = false; ///< Along the ground alone: up and down it would go through the floor.
  std::string why = {}; ///< Why it was left out, or has less than the style's scale; empty: it has all of it.
};

/// Remark on an outcome beside its scale, such as "along the ground, with more the mesh would tear"; empty
/// where all of the style's exaggeration is there.
[[nodiscard]] std::string remarkOn(bool isExaggerated, bool isLevel, const std::string& why);

/// A clip with a trail for every moment of it that can have one.
struct AutoClip {
  Document document;
  std::vector<AutoMoment> moments; ///< One for each moment that was asked for, in that order.
  std::vector<int> trailIds;       ///< In the order of `moments`.
  bool madeLoop = false;           ///< The clip was marked as a loop, so that ways back go on at its start.
  std::vector<std::string> notes;  ///< Further things that were done: one line each.
};

/// Gives each of these moments a trail in the style, as far as the character then looks right: no limb goes
/// through the floor beyond the source's own, none leaves the style's range of lengths, a foot that carries
/// the body stays, a loop stays one, hands that hold a thing together stay together, and trails that are
/// there keep their limb to themselves. What would break that gets less, or is left out. The clip must be
/// there; trails are made, exaggerated and connected.
[[nodiscard]] AutoClip exaggerateClip(const Document& document, int clip,
                                      const std::vector<rig::Moment>& moments, const AutoSettings& settings);

} // namespace stretch::app
