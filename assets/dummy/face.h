#pragma once

#include "assets/dummy/skinned_mesh.h"

namespace stretch::assets {

/// Eyes, brows and mouth: small closed surfaces on the face that follow the joint `head` rigidly.
[[nodiscard]] SkinnedMesh makeFace(int head);

} // namespace stretch::assets
