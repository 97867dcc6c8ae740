#pragma once

#include "app/document.h"

namespace stretch::app {

// Settings from which trails and weight start where nothing else is asked: as the body's plan says of the
// limb (docs/body_plans.md, How limbs move by themselves). A chain has no plan.

/// The settings that the plan gives to a trail of this limb, without a range.
[[nodiscard]] rig::TrailSettings usualTrail(const Document& document, const rig::Limb& limb);

/// Returns the settings over these frames of a clip, in the space that fits them; a limb that stands stops at
/// the ground.
[[nodiscard]] rig::TrailSettings startingTrail(const Document& document, int clip, const rig::Limb& limb,
                                               const Vec2& rangeFrames);

[[nodiscard]] WeightSettings usualWeight(const Document& document, const std::string& limb);

} // namespace stretch::app
