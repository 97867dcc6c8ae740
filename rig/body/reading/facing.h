#pragma once

#include <string>
#include <vector>

#include "rig/body/reading/trunk.h"

namespace stretch::rig::body {

/// Which side of the mirror plane is the character's left.
struct Sides {
  bool leftIsPositive = true;
  double certainty = 0.0;            ///< 0..1.
  bool areNamesAlone = false;        ///< Nothing but the joint names tells them.
  bool contradicted = false;         ///< Names and geometry say different things.
  std::vector<std::string> warnings; ///< Names against geometry, names on one side only, and the like.
  std::string reason;
};

/// Names that agree with each other decide, unless at least two kinds of hints (toes, the foot's mesh, the
/// face) clearly say otherwise and none speaks for the names. A contradiction is told as a question. Without
/// such names the hints decide, knees and elbows among them, and these alone where no other is clear; without
/// those the character is taken to face +Z, as glTF has it.
[[nodiscard]] Sides findSides(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading);

} // namespace stretch::rig::body
