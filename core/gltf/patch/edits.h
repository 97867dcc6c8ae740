#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// A node that saving appends. Its index is the number of nodes of the source and of the files added to it
/// plus its position in
/// Edits::addedNodes.
struct AddedNode {
  std::string name;
  NodeIndex parent; ///< Node of the source, or an added one that stands earlier in the list.
  Transform rest;
  NodeIndex meshFrom; ///< Takes over mesh (and weights) of this node: the node of the source then holds none.
                      ///< None: no mesh.
  bool isBindLeaf = true;    ///< Marked in extras, so that readers of ours know it.
  bool isBindCorner = false; ///< Marked so beside it.
};

/// A node of the source that stands elsewhere at rest, or is turned otherwise; its scale stays.
struct MovedNode {
  NodeIndex node;
  Transform rest;
};

/// Slot of a skin that follows another node than in the source.
struct SkinSlot {
  int skin = -1;
  int slot = -1;    ///< Index into the skin's joints.
  NodeIndex node;   ///< The new joint.
  Mat4 inverseBind; ///< Its inverse bind matrix.
};

/// A joint that a skin of the source gets behind those that it has.
struct AddedSlot {
  int skin = -1;
  NodeIndex node; ///< Node of the source, or an added one.
  Mat4 inverseBind{1.0};
};

/// A skin that saving appends. Its index is the number of skins of the source plus its position in
/// Edits::addedSkins.
struct AddedSkin {
  std::string name;
  std::vector<NodeIndex> joints; ///< Nodes of the source, or added ones; at least one.
  std::vector<Mat4> inverseBind; ///< One for each joint.
};

/// A node whose mesh is bound to a skin. The attributes JOINTS_0 and WEIGHTS_0 of its primitives point to new
/// accessors, those of the second set where a vertex needs it; other sets go. A mesh that nodes show which
/// are not bound, or bound in another way, is left to them: the node gets a copy, which shares every other
/// accessor.
struct BoundMesh {
  NodeIndex node; ///< Node of the source that holds a mesh, or an added one that takes it over.
  int skin = -1;  ///< Skin of the source or added.
  /// For each primitive of Mesh::primitives (core/scene/scene.h) an entry per vertex, the slots with weight
  /// first. Points and lines, which are not among those, follow what triangles over the same places follow;
  /// where there are none, they stay as they are on the skin that moves them already, and follow the first
  /// joint of another.
  std::vector<std::vector<VertexInfluences>> influences;
  /// The influences divide those that the vertices have. Refused where the mesh has some that are not read,
  /// and would be lost: of more than eight joints, or of points and lines at places of their own.
  bool divides = false;
};

/// Tracks of one clip that replace those of the source with the same (node, channel), or are new. Each gets
/// accessors of its own: nothing that another channel or clip shares is changed in place. Tracks with equal
/// times share one input.
struct ClipTracks {
  int clip = -1; ///< Index into the file's animations.
  std::vector<Track> tracks;
  /// Noted in the clip's extras, where the key times alone would tell another rate. 0: not noted.
  double framesPerSecond = 0.0;
};

/// Everything that saving may change. Nothing is renumbered: nodes, accessors, samplers are appended,
/// pointers moved.
struct Edits {
  std::vector<AddedFile> addedFiles; ///< Their nodes come behind those of the source, before addedNodes.
  std::vector<AddedNode> addedNodes;
  std::vector<MovedNode> movedNodes;
  std::vector<SkinSlot> skinSlots;
  std::vector<AddedSlot> addedSlots; ///< In the order in which a skin's list goes on.
  std::vector<AddedSkin> addedSkins;
  std::vector<BoundMesh> boundMeshes;
  std::vector<ClipTracks> clips;
  JsonDocument work; ///< The program's own data, kept in root extras beside what restores the source. Null:
                     ///< none (a clean file).

  [[nodiscard]] bool empty() const {
    return addedFiles.empty() && addedNodes.empty() && movedNodes.empty() && skinSlots.empty() &&
           addedSlots.empty() && addedSkins.empty() && boundMeshes.empty() && clips.empty() && work.isNull();
  }
};

/// The source with the edits patched in, in memory.
[[nodiscard]] Result<Source> patched(const Source& source, const Edits& edits);

/// Writes .glb or .gltf (by the extension of `path`) atomically, with the .bin and the external images it
/// refers to where the target folder is another. Nothing is left behind on failure.
[[nodiscard]] Status save(Source source, const std::filesystem::path& path);

/// The files that saving to `path` puts beside it, as the source names them, where that is another folder
/// than the source's: what the output needs wherever it goes, by name, each once. The first buffer is none of
/// them: it lies in a .glb, and every .gltf has one beside it.
[[nodiscard]] std::vector<std::filesystem::path> filesBeside(const Source& source,
                                                             const std::filesystem::path& path);

} // namespace stretch::gltf
