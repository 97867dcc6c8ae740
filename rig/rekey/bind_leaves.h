#pragma once

#include <vector>

#include "core/gltf/patch/edits.h"
#include "core/scene/scene.h"
#include "rig/rekey/rekey.h"

namespace stretch::rig {

/// The stretches of one re-keyed clip.
struct ClipStretches {
  int clip = -1; ///< Index into the file's animations.
  std::vector<StretchKeys> stretches;
};

/// Adds the bind chain to what is saved (docs/rig.md, Bind leaves): under each stretched joint J a
/// leaf `J_bind` with rotation A and an animated scale; in every skin that uses J its slot points to the
/// leaf, with the inverse bind matrix A^-1 IBM. Where the stretch axis moves in J, or a mesh hangs on J
/// rigidly, a second leaf `J_bind_end` below turns back by A^-1 and takes the slot (with the inverse bind
/// matrix as it was) or the mesh: a single leaf with a turning A would turn the mesh as well. At scale 1 the
/// result is the original skinning. Leaves that the file has already (Scene::bindChains) are used again.
void addBindLeaves(const Scene& scene, const std::vector<ClipStretches>& clips, gltf::Edits& edits);

/// The tracks of a clip that is saved, a new list where there is none yet.
[[nodiscard]] std::vector<Track>& tracksOf(int clip, gltf::Edits& edits);

} // namespace stretch::rig
