#pragma once

#include <vector>

#include "rig/moments/strokes.h"

namespace stretch::rig {

/// The falls of the hips that feet stop, strongest first: all feet fall with the body, then one of them
/// stands still and the hips go on down. `start` is where it does, `tip` where the hips are lowest. Strength
/// as of a stroke whose way is the whole fall. None of a body without hips or legs.
[[nodiscard]] std::vector<SampledStroke> landingsOf(const BodyMotion& motion, const std::vector<Limb>& limbs);

} // namespace stretch::rig
