#pragma once

#include <string>
#include <vector>

#include "core/math/types.h"
#include "tests/support/rig/synthetic_biped.h"

namespace stretch::test {

/// A joint that a program's rig has beside those of every biped. "%" stands for the side in all texts.
struct HelperJoint {
  enum class How {
    beside, ///< It moves a part of the mesh, and nothing hangs on it.
    inRow,  ///< What `to` names hangs from it.
    handle, ///< It moves no mesh.
  };
  std::string name;
  std::string parent; ///< Key of a joint, or the name of a helper above.
  std::string from;   ///< Key of the joint where it stands; with `to`, `share` of the way to that one.
  std::string to = {};
  double share = 0.0;
  Vec3 offset{0.0};
  How how = How::beside;
};

/// The rig of one program or game, with the names and helpers that it is exported with.
struct WholeRig {
  NamingScheme scheme;
  std::vector<HelperJoint> helpers;
};

[[nodiscard]] const std::vector<WholeRig>& wholeRigs();

/// What of a biped a rig names.
[[nodiscard]] BodyOptions optionsOf(const WholeRig& rig);

/// Adds the helpers to a posed body of the rig's joints, and gives everything its name.
void addHelpers(SyntheticBiped& body, const WholeRig& rig);

} // namespace stretch::test
