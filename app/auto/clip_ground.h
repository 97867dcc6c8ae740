#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "core/anim/frame_state.h"

namespace stretch::app {

/// Limbs at one frame, in the order of allLimbs: where each of their points is, the place that stays first.
using LimbPlaces = std::vector<std::vector<Vec3>>;

/// Facts about a clip without new trails that every choice for it is measured against.
struct ClipGround {
  const Document& document; ///< Has to outlive it.
  int clip = 0;
  double framesPerSecond = 30.0;
  double lastFrame = 0.0; ///< Whole.
  bool endsMeet = false;  ///< Its last pose is its first again.
  std::vector<rig::Limb> limbs;
  std::vector<LimbPlaces> places;                  ///< One for each whole frame from 0.
  std::map<std::string, std::vector<Vec2>> stands; ///< By leg: first and last frame of standing, ascending.
  double lowest = 0.0;         ///< Height that no point of a limb goes below in the clip, world units.
  std::optional<double> floor; ///< Floor on which feet stand.

  [[nodiscard]] const LimbPlaces& placesAt(double frame) const;
  [[nodiscard]] const std::vector<Vec2>& standsOf(const std::string& leg) const;
};

[[nodiscard]] ClipGround clipGround(const Document& document, int clip);

[[nodiscard]] LimbPlaces placesOf(const std::vector<rig::Limb>& limbs, const FrameState& frame);

} // namespace stretch::app
