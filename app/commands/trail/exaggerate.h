#pragma once

#include <optional>
#include <vector>

#include "app/commands/trail/exaggerate_modal.h"
#include "app/session.h"

namespace stretch::app {

/// Trails made ready to be exaggerated, without a history step yet.
struct ExaggerateTargets {
  Document document;         ///< With the trails made, exaggerated and connected.
  std::vector<int> trailIds; ///< Those that the modal acts on, the leading one first; at least one.
  bool madeLoop = false;     ///< The clip was marked as a loop with them.
};

/// Scale of a trail that was not exaggerated before: the thesis's simple punch.
inline constexpr double firstScale = 2.0;

/// Use of a range that was set where it shares time with a trail of the limb (rangeClash in ranges.h).
enum class OverlapChoice {
  edit,  ///< That trail is meant.
  beside ///< Another one is, in what is free of the range.
};

/// The selected trail with those of the other selected limbs that share time with it. Without one, for each
/// selected limb: its trail in the range that was set (else at the playhead), or a new one over that range;
/// where none is set, over its own stroke (ranges.h, rangeBeside). All are exaggerated and connected; new
/// ones that are made at once become a group. Where one of the clip's first trails ends so near to the clip's
/// end that its way back has no room, and the clip's last pose is its first, the clip is marked as a loop. An
/// error when no limb is selected, or no frame is free.
[[nodiscard]] Result<ExaggerateTargets> exaggerateTargets(const Session& session,
                                                          OverlapChoice choice = OverlapChoice::edit);

/// The stroke after (else before) the range of the leading target, round and round, in which no other trail
/// of the limb lies; nothing where there is none, or where the targets were there before.
[[nodiscard]] std::optional<Vec2> nextStroke(const Session& session, const ExaggerateTargets& targets,
                                             bool forwards);

/// The targets, which were made just now, over another range of the leading one, as new trails would start
/// there; the others over what they do at that time (ranges.h, rangeBesideStroke).
[[nodiscard]] Result<ExaggerateTargets> movedTo(const Session& session, const ExaggerateTargets& targets,
                                                const Vec2& range);

/// The document with the modal's settings on every target.
[[nodiscard]] Result<Document> exaggeratedWith(const ExaggerateTargets& targets,
                                               const ExaggerateModal& modal);

/// The new trails of the selected limbs, as plain original paths: over the range that was set, else each over
/// its own stroke.
[[nodiscard]] Result<ExaggerateTargets> newTrails(const Session& session, bool exaggerated);

/// Returns the settings from which a new trail of the limb over a range starts.
[[nodiscard]] rig::TrailSettings newTrailSettings(const Session& session, const rig::Limb& limb,
                                                  const Vec2& range);

} // namespace stretch::app
