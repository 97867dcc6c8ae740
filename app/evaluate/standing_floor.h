#pragma once

#include <optional>

#include "app/document.h"

namespace stretch::app {

/// How high the ends of legs are in a clip where they stand lowest, world units along +Y. Nothing where no
/// leg stands.
[[nodiscard]] std::optional<double> standingAnkles(const Document& document, int clip);

/// The plane that a leg does not reach through: where ankles stand lowest in the clip.
[[nodiscard]] std::optional<rig::StopPlane> floorForLegs(const Document& document, int clip);

/// The floor itself: what stands on it is as far below the ankle as in the bind pose.
[[nodiscard]] std::optional<double> floorHeight(const Document& document, int clip);

} // namespace stretch::app
