#pragma once

#include "core/anim/clip.h"
#include "tests/support/core/glb_builder.h"

namespace stretch::test {

/// A made-up scene as a file: its nodes by the same indices, rigid and skinned meshes without triangles of
/// their own (every three vertices are one), skins and one clip for each given.
[[nodiscard]] GlbBuilder characterFile(const Scene& scene, const std::vector<Clip>& clips);

} // namespace stretch::test
