#pragma once

#include <string>
#include <vector>

#include "app/session.h"

namespace stretch::app {

/// A limb's end taken in the hand at the playhead.
struct HeldLimb {
  Document document; ///< With the trail there, exaggerated and connected.
  int trailId = 0;
};

/// The limb's trail at the playhead, or a new one around it that changes nothing yet: pulling a sphere of it
/// at the playhead carries the hand, foot or head along. No history step.
[[nodiscard]] Result<HeldLimb> holdLimb(const Session& session, const std::string& limbId);

/// The document with a control sphere of the trail at the frame, where the session shows that trail; `frame`
/// becomes that of the sphere which is there already.
[[nodiscard]] Result<Document> withSphereAt(Session& session, int trailId, double& frame);

/// The arms whose hands take what is added: the selected ones, else the right one, else the left one. None
/// without arms or a clip.
[[nodiscard]] std::vector<std::string> handsForProp(const Session& session);

} // namespace stretch::app
