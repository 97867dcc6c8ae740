#pragma once

#include "tests/support/core/glb_builder.h"
#include "tests/support/rig/moving_biped.h"

namespace stretch::test {

/// The horse of creatures.h for one second: it stands on its right legs and swings the left ones, its tail
/// and its neck.
[[nodiscard]] MovingBiped pawingHorse();

/// A snake whose skeleton hangs on a joint behind its head, which carries a jaw beside it. In one second the
/// head strikes forwards, half-way, and comes back, and the body bends.
[[nodiscard]] MovingBiped strikingSnake();

/// As a file, with a bone-shaped mesh around every bone.
[[nodiscard]] GlbBuilder creatureFile(const MovingBiped& creature);

} // namespace stretch::test
