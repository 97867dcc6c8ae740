#pragma once

#include "rig/body/evidence/body_view.h"
#include "rig/body/reading/plan_parts.h"

namespace stretch::rig::body {

/// Whether the joints of a row follow each other as closely as a serpent's; from a root on the floor to the
/// hips it is far.
[[nodiscard]] bool isEven(const Extremity& row);

/// Whether joints of both sides are called thigh or shin, or one called shin hangs below one called thigh:
/// such a body is no serpent, though it may have lost others. Fins are called arms.
[[nodiscard]] bool hasNamedLegs(const BodyView& view);

/// Whether two pairs that are no fins are long: arms and legs, however a person lies, sits or stands.
[[nodiscard]] bool hasLongLimbs(const BodyView& view, const std::vector<ExtremityPair>& pairs);

/// Whether three limbs or more part from a row or from above it, each of several joints, a third of its
/// length and none called a fin: whatever its pose, such a body is no serpent.
[[nodiscard]] bool hasBranches(const BodyView& view, const Extremity& row);

/// Whether the first joint of a row carries the body and is no part of it: it moves no vertices, and hardly
/// has a bone, or, where others move vertices, one that leads from a root in the middle or on the ground to
/// an end of the body.
[[nodiscard]] bool startsAtAnchor(const BodyView& view, const Extremity& row);

/// Ends a row at the head that is named so, where it goes on into a jaw, a tongue or an eye.
void endAtHead(Extremity& row, const Axis& axis);

/// Whether another joint hangs beside one of a row, which is not of its first two.
[[nodiscard]] bool isInFork(const BodyView& view, const Extremity& row, std::size_t place);

/// Ends a row where it parts into fins.
void endBeforeFins(const BodyView& view, Extremity& row);

/// Length of a row before it parts into fins; half of that of a row that is a fin.
[[nodiscard]] double trunkLength(const BodyView& view, const Extremity& row);

} // namespace stretch::rig::body
