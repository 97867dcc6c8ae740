#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/mesh_sequence.h"
#include "core/scene/scene.h"

namespace stretch::skinning {

/// World positions of every vertex that is drawn, in the order of drawnMeshNodes and their primitives: linear
/// blend skinning v' = sum_j w_j M_j v with the matrices of skinMatrices, rigid meshes by meshMatrix, morph
/// targets before either. The reference that the graphics card's skinning is tested against.
[[nodiscard]] std::vector<Vec3> skinnedPositions(const Scene& scene, const FrameState& frame);

/// Which matrix turns the normals of skinned meshes: the one that keeps them upright on the surface, or the
/// joints' own, as three.js, Godot and others take it, which is wrong where they scale unequally. Rigid
/// meshes have the right one either way.
enum class NormalMatrix { inverseTranspose, plain };

/// The frame that engines turn normals by: a stretch that is told by translations moves vertices and turns
/// nothing. So are chains of corners, and with `newToo` what joints without a chain are stretched by.
[[nodiscard]] FrameState turningFrame(const Scene& scene, FrameState frame, bool newToo = false);

/// Normals of the same vertices in the same order, unit length.
[[nodiscard]] std::vector<Vec3> skinnedNormals(const Scene& scene, const FrameState& frame,
                                               NormalMatrix by = NormalMatrix::inverseTranspose);

/// The node that moves each drawn vertex most: its strongest joint, or of a rigid mesh the node itself.
[[nodiscard]] std::vector<NodeIndex> strongestNodes(const Scene& scene);

/// Triangles of all that is drawn, of vertices as skinnedPositions counts them.
[[nodiscard]] std::vector<Triangle> drawnTriangles(const Scene& scene);

/// A vertex in its mesh's space, moved by the morph targets.
[[nodiscard]] Vec3 morphedPosition(const Primitive& primitive, const std::vector<float>& weights,
                                   std::size_t vertex);

/// Nodes that draw a mesh, in index order, those of the default scene only.
[[nodiscard]] std::vector<NodeIndex> drawnMeshNodes(const Scene& scene);

} // namespace stretch::skinning
