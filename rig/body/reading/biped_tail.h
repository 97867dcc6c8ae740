#pragma once

#include <optional>
#include <vector>

#include "rig/body/reading/facing.h"
#include "rig/limb.h"

namespace stretch::rig::body {

/// Tail of a body that was read as a biped, as candidates from its first joint to its last: a row in the
/// middle that hangs from the hips or the spine, beside the joints of `limbs`. One that is named so; else the
/// only row there of four joints or more that goes back by six tenths of its way or more. Nothing that names
/// call a garment, hair or a thing that is carried. Empty where there is none.
[[nodiscard]] std::vector<int> tailOfBiped(const BodyView& view, const MirrorPlane& plane, const Sides& sides,
                                           const Trunk& trunk, const std::vector<Limb>& limbs);

/// Whether a name of its joints says so.
[[nodiscard]] bool isNamedTail(const BodyView& view, const std::vector<int>& row);

} // namespace stretch::rig::body
