#pragma once

#include "app/retarget/retarget_figures.h"
#include "rig/retarget/retarget.h"

namespace stretch::app {

/// Moves the arms of a clip that is brought over so that hands touch what the source's touch, at the same
/// place of this body, and forearms and hands are no deeper inside trunk and head than the source's
/// (docs/import_clip.md). `amount`: share of the way, 0..1. Empty where there is nothing to do: amount 0, or
/// a body without a surface. What is given has to outlive the answer.
[[nodiscard]] rig::ShiftArms touchShifts(const PlayedClip& source, const rig::Skeleton& own, double amount);

} // namespace stretch::app
