#pragma once

#include <vector>

#include "app/commands/exaggerate_modal.h"
#include "app/session.h"

namespace stretch::app {

/// Trails made ready to be exaggerated, without a history step yet.
struct ExaggerateTargets {
  Document document;         ///< With the trails made, exaggerated and connected.
  std::vector<int> trailIds; ///< Those that the modal acts on, the leading one first; at least one.
};

/// Scale of a trail that was not exaggerated before: the thesis's simple punch.
inline constexpr double firstScale = 2.0;

/// The trails that commands act on, or new ones for the selected limbs over the working range (else the
/// default range): all exaggerated and connected. An error when no limb is selected, or a range overlaps.
[[nodiscard]] Result<ExaggerateTargets> exaggerateTargets(const Session& session);

/// The document with the modal's settings on every target.
[[nodiscard]] Result<Document> exaggeratedWith(const ExaggerateTargets& targets,
                                               const ExaggerateModal& modal);

/// The new trails of the selected limbs over the working range, as plain original paths.
[[nodiscard]] Result<ExaggerateTargets> newTrails(const Session& session, bool exaggerated);

} // namespace stretch::app
