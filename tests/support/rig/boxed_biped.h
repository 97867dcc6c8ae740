#pragma once

#include <filesystem>
#include <string>

#include "rig/retarget/skeleton.h"
#include "tests/support/rig/moving_biped.h"

namespace stretch::test {

/// Hangs a box on a joint, its middle at a place of the world in the bind pose: a rigid mesh.
void addBox(MovingBiped& moving, const std::string& joint, const Vec3& middle, const Vec3& half);

/// A biped with its joints and nothing to be seen.
[[nodiscard]] MovingBiped bareBiped(const SyntheticBiped& body);

/// Half sizes of the boxes of a body.
struct BoxedBody {
  Vec3 trunk{0.15, 0.3, 0.12}; ///< About (0, 1.15, 0).
  Vec3 head{0.1};              ///< About (0, 1.68, 0).
  double armLength = 1.0;      ///< Of the arms' bones against the usual ones.
};

/// A biped of boxes: trunk, head, forearms and hands, its arms level.
[[nodiscard]] MovingBiped boxedBiped(const BoxedBody& sizes = {});

/// How a clip is brought to it, which it has to be able to take.
[[nodiscard]] rig::Skeleton skeletonOf(const MovingBiped& moving);

/// Writes a file with the clip of a skeleton whose left arm goes through the chest; answers its path.
std::string crossingArms(const std::filesystem::path& file);

} // namespace stretch::test
