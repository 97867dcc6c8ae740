#pragma once

#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"

namespace stretch::rig {

/// The tracks of a clip on the nodes of another scene that have the same names.
struct CopiedTracks {
  Clip clip;                         ///< Key for key as it was; without tracks where no name is known.
  std::vector<std::string> missing;  ///< Animated nodes that the other scene lacks: names, "#3" without one.
  std::vector<std::string> ofOthers; ///< Animated nodes that are another character's of their scene: names.
  std::size_t joints = 0;            ///< Animated nodes that it has.
};

/// A name that several nodes have is that of the one that is a skin's joint, of several of these the one that
/// hangs together with `hips` most closely. Where several characters of `from` have the name, the one that
/// `fromHips` belongs to is taken, or another one of which the clip moves more; of several of one character
/// none. No two tracks come to one node and channel. Morph weights go where the mesh has as many targets.
[[nodiscard]] CopiedTracks copyTracks(const Scene& from, const Clip& clip, const Scene& to,
                                      NodeIndex hips = NodeIndex::none, NodeIndex fromHips = NodeIndex::none);

/// Whether the joints that the clip moves stand at the same places of their parents in both scenes, those
/// that have the same names, see copyTracks: then its keys mean the same in both. True where no two can be
/// compared.
[[nodiscard]] bool haveSameBones(const Scene& from, const Clip& clip, const Scene& to,
                                 NodeIndex hips = NodeIndex::none, NodeIndex fromHips = NodeIndex::none);

} // namespace stretch::rig
