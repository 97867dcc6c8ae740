#pragma once

#include <string>

#include "app/document.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// Whether the plane where the trail stops is in the way of the limb's end at the tip. A trail may have a
/// plane that its limb never reaches. `solved`: of that motion.
[[nodiscard]] bool isStoppedAtTip(const Document& document, const rig::MotionState& motion,
                                  const rig::SolvedTrail& solved);

/// Whether the limb has the length at the tip that is asked of it, within 1e-4, with all that acts on it.
[[nodiscard]] bool hasWantedLength(const Document& document, const rig::MotionState& motion,
                                   const rig::SolvedTrail& solved);

inline constexpr const char* stoppedOnTheWay = "stopped on the way";

/// Names what keeps a limb from that length though its path reaches it: stoppedOnTheWay, "held by a grip", or
/// "shared with another trail of the limb". Empty where nothing does.
[[nodiscard]] std::string keptFromLength(const Document& document, const rig::MotionState& motion,
                                         const rig::SolvedTrail& solved);

/// Names the setting of the trail itself by which its limb does not take on that length at the tip: its
/// blend, its stretch switch or a sphere. Empty where none does.
[[nodiscard]] std::string keptBySettings(const rig::SolvedTrail& solved);

} // namespace stretch::app
