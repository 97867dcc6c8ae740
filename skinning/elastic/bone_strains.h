#pragma once

#include <vector>

#include "core/math/types.h"
#include "skinning/elastic/limb_elasticity.h"

namespace stretch::skinning {

/// Answers of the elastic model for a limb, as strains K - I in the spaces of its joints, sample first, then
/// bone; exactly zero where nothing gives way. A load that turns around a bone would need a K whose axes turn
/// in the joint, and with it shear in the saved file. So the flattening is resolved along two axes fixed in
/// each bone, those that hold most of it: all of it where the load keeps its side of the bone, as gravity
/// does on a limb at rest. Volume is kept either way.
[[nodiscard]] std::vector<std::vector<Mat3>>
boneStrains(const std::vector<std::vector<LimbStretch>>& stretches,
            const std::vector<std::vector<Mat3>>& toJoint);

} // namespace stretch::skinning
