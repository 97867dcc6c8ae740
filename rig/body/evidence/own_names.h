#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace stretch::rig::body {

/// Name of every node without the parts that nearly all joints' names begin with (a character's name before
/// each: "EndBoss_LeftArm" is "LeftArm"), since these tell no joint from another. What only limbs, hair or
/// the like share stays: the trunk has to share it as well. A file of fewer than five joints keeps its names.
[[nodiscard]] std::vector<std::string> ownNames(const Scene& scene);

} // namespace stretch::rig::body
