#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.h"

namespace stretch::app {

/// Moments of the viewed clip as the editor marks them, in the order of their tips, the strongest first where
/// tips meet: those at least a fifth as strong as the clip's strongest, a hundred at most. None without a
/// clip.
[[nodiscard]] std::vector<rig::Moment> shownMoments(const Session& session);

/// The moment that is the selected limbs' working range; nothing where that is another.
[[nodiscard]] std::optional<rig::Moment> currentMoment(const Session& session);

/// The shown moment after the current one, or before it; without a current one after the playhead, or before
/// it. Round and round; nothing where the clip has none.
[[nodiscard]] std::optional<rig::Moment> nextMoment(const Session& session, bool forwards);

/// Limbs that do it: the moment's own, or all legs for a landing.
[[nodiscard]] std::vector<std::string> limbsOfMoment(const Document& document, const rig::Moment& moment);

/// Selects its limbs and its range, and puts the playhead to its tip. Where the limb has a trail there, that
/// is selected.
void goToMoment(Session& session, const rig::Moment& moment);

/// "Left arm: stroke from 21 to 27, strength 10".
[[nodiscard]] std::string momentText(const Document& document, const rig::Moment& moment);

/// The way of the limb's end over the moment, or that of the hips, at half frames: world space, of the clip
/// as it is.
[[nodiscard]] std::vector<Vec3> pathOfMoment(const Session& session, const rig::Moment& moment);

} // namespace stretch::app
