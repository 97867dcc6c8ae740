#pragma once

#include <map>
#include <vector>

#include "rig/rekey/bind_leaves.h"

namespace stretch::rig {

/// The corners that carry the stretch of one joint.
struct CornerSet {
  NodeIndex joint;
  std::vector<Vec3> places;  ///< In the joint's space, at rest.
  std::size_t enclosing = 0; ///< The first of them, which hold every vertex.
  std::size_t offered = 0; ///< The first of them, which any vertex is fitted by; the rest stand at vertices.
  std::vector<BindCorner> made;        ///< The file's own, by place, which are used again; empty: new ones.
  std::vector<NodeIndex> givenUp = {}; ///< The file's own that are not enough, which vertices leave.

  [[nodiscard]] std::vector<Vec3> enclosingPlaces() const {
    return {places.begin(), places.begin() + static_cast<std::ptrdiff_t>(enclosing)};
  }
};

/// A mesh that joints move, in their own terms: a skinned one, or one that hangs on a joint rigidly.
struct MovedMesh {
  NodeIndex node;
  int skin = -1;                 ///< -1: rigid.
  std::vector<NodeIndex> joints; ///< Joint of the skin, or the node itself.
  std::vector<Mat4> inverseBind;
};

/// Corners of a joint beside those that enclose its vertices, to fit fewer influences by than a vertex can
/// have.
inline constexpr std::size_t furtherCorners = 12;

/// The corners that a file has already, those first that hold every vertex which the joint moves.
[[nodiscard]] CornerSet madeSet(const Scene& scene, const BindChain& made);

/// Meshes that the joints move; a skinned mesh stands once for each node that shows it.
[[nodiscard]] std::vector<MovedMesh> meshesOf(const Scene& scene, const std::vector<NodeIndex>& joints);

/// How the vertices of a primitive follow the mesh's joints.
[[nodiscard]] std::vector<VertexInfluences> influencesOf(const Primitive& primitive, const MovedMesh& mesh);

/// The corners for every stretched joint that a mesh follows, by joint. `further`: with so many more among
/// the vertices that another joint moves as well.
[[nodiscard]] std::map<NodeIndex, CornerSet> cornerSets(const Scene& scene,
                                                        const std::vector<ClipStretches>& clips,
                                                        const std::vector<MovedMesh>& meshes,
                                                        std::size_t further);

/// The motion of a corner under a stretch: translations, with keys between those of the stretch where its
/// axes turn, so that no corner is off by more than 1e-5 of its distance from the joint.
[[nodiscard]] Track cornerTrack(NodeIndex node, const Vec3& place, const StretchKeys& stretch);

} // namespace stretch::rig
