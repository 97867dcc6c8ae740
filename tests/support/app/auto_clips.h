#pragma once

#include <string>
#include <vector>

#include "app/auto/exaggerate_clip.h"
#include "app/document.h"
#include "core/anim/clip.h"

namespace stretch::test {

// Small characters that strike, swing and step, for clips that are exaggerated in a style.

/// A built-in style by a part of its name.
[[nodiscard]] app::AutoSettings in(const char* name, double strength = 1.0);

/// Every moment of the first clip in a style.
[[nodiscard]] app::AutoClip exaggerated(const app::Document& document, const app::AutoSettings& settings);

/// Outcome for the strongest moment, which has to be there.
[[nodiscard]] const app::AutoMoment& strongest(const app::AutoClip& made);

/// Outcome for the moment of a limb with its tip there, which has to be there.
[[nodiscard]] const app::AutoMoment& momentAt(const app::AutoClip& made, const char* limb, double tip);

/// A rotation at a frame of 30 a second.
void addKey(Track& track, double frame, const Quat& turn);

/// A track without keys for the rotations of a limb's first joint.
[[nodiscard]] Track turnsOf(const app::Document& document, const char* limb);

/// The document whose only clip has these tracks.
[[nodiscard]] app::Document withTracks(app::Document document, std::vector<Track> tracks);

/// A straight punch, mirrored on the right.
[[nodiscard]] Track turnsOfPunch(const app::Document& document, const std::string& limb);

/// A loop of 24 frames in which both arms swing, the right one half a turn after the left; the left arm is
/// back at the loop's seam. With fewer keys it ends before that.
[[nodiscard]] app::Document swinger(int lastKey = 24);

/// The boxer with a left leg that stands, is lifted from frame 10 on, slowly at first, and is back at
/// frame 40.
[[nodiscard]] app::Document stepper();

/// The stepper with a right leg beside the left one, which has no keys.
[[nodiscard]] app::Document twoLeggedStepper();

} // namespace stretch::test
