#pragma once

#include <string>
#include <vector>

#include "rig/body/trunk.h"

namespace stretch::rig::body {

/// Which side of the mirror plane is the character's left.
struct Sides {
  bool leftIsPositive = true;
  double certainty = 0.0;            ///< 0..1.
  std::vector<std::string> warnings; ///< Names against geometry, names on one side only, and the like.
  std::string reason;
};

/// Facing comes from feet (ankle to toe, and the foot's mesh), knees and elbows; names vote as well. Where
/// both speak clearly and disagree, the feet win and a warning says so; weak geometry gives way to names;
/// without either the character is taken to face +Z, as glTF has it.
[[nodiscard]] Sides findSides(const BodyView& view, const MirrorPlane& plane, const BodyPlan& plan);

} // namespace stretch::rig::body
