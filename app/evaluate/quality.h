#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/evaluate/clip_facts.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// The mesh costs far more than the limb alone.
enum class LookAt { limb, limbAndMesh };

/// Lists what an animator would stumble over when playing an active trail, one line each with its frames, the
/// worst value and what to do about it; whose trail it is the reader knows: the limb's length over the
/// source's outside [min(1, S) / 1.5, 1.5 max(1, S)], the limb pointing more than 120 degrees away from where
/// it did, an arm's joint above the head or a hand or foot below the floor where the source has it not, a
/// limb below the lowest place of the body where no floor is known, a vertex farther from its source place
/// than 1.5 times the tip's displacement, the limb's end jumping where it stops, or an edge of the mesh more
/// than 4 times as long as it is in the source and in the bind pose (1.5 S times where that is more). Looked
/// at on every frame of range and release. A smaller scale, and one of another range, space or stop, are
/// advised only where each was tried and leaves nothing of that. Also what stays where it is though it stands
/// at the limb's end (left_behind.h).
[[nodiscard]] std::vector<std::string> motionWarnings(const Document& document,
                                                      const rig::MotionState& motion,
                                                      const rig::SolvedTrail& trail,
                                                      LookAt what = LookAt::limbAndMesh);
/// Lists them for a trail of the facts' document and clip: for the trails of one clip, whose facts are kept.
[[nodiscard]] std::vector<std::string> motionWarnings(const std::shared_ptr<ClipFacts>& facts,
                                                      const rig::MotionState& motion,
                                                      const rig::SolvedTrail& trail,
                                                      LookAt what = LookAt::limbAndMesh);

} // namespace stretch::app
