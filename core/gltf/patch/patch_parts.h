#pragma once

#include "core/gltf/patch/appended_data.h"
#include "core/gltf/patch/edits.h"

namespace stretch::gltf {

// Parts of `patched`. The edits have to be validated; every change goes through the journal.

/// Whether the edits fit the source: indices there, tracks and transforms well formed and finite.
[[nodiscard]] Status validateEdits(const Source& source, const Edits& edits);

/// Appends the nodes, moves meshes to them, extends the children of their parents.
void patchNodes(const std::vector<AddedNode>& nodes, Journal& journal);

/// Adds what holds the joints of a skin to every scene that shows the node, which the skin moves.
void showJoints(std::size_t skin, NodeIndex node, Journal& journal);

/// Gives the nodes their new places.
void moveNodes(const std::vector<MovedNode>& nodes, Journal& journal);

inline constexpr std::size_t matrixSize = 16; ///< Numbers of a matrix in an accessor.

/// Writes a matrix column by column; its last row is that of an affine one.
void store(const Mat4& matrix, float* numbers);

/// Appends joints to skins, and points slots of skins to other joints; each skin gets an accessor of inverse
/// bind matrices of its own. The buffer views of the source have to be plain.
void patchSkins(const Source& source, const Edits& edits, Journal& journal, AppendedData& data);

/// Appends the skins and binds meshes to them, or to skins of the source.
void patchBinding(const Edits& edits, Journal& journal, AppendedData& data);

/// Appends samplers and points channels to them, or appends channels.
void patchClips(const std::vector<ClipTracks>& clips, Journal& journal, AppendedData& data);

} // namespace stretch::gltf
