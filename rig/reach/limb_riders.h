#pragma once

#include <set>
#include <vector>

#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/reach/bind_places.h"

namespace stretch::rig {

/// Tells of what hangs on the bones of a limb what deforms with them (docs/rig.md, What belongs to a bone).
class Riders {
public:
  /// `othersJoints`: joints and ends of other limbs, which ride on no bone of this one.
  Riders(const Scene& scene, const Limb& limb, const BindPlaces& places, std::set<NodeIndex> othersJoints);

  /// Adds what deforms with the bone: `node`, if it does, and what hangs on it.
  void collect(NodeIndex node, std::size_t bone, std::vector<NodeIndex>& riders) const;
  /// Adds the nodes between a joint of the limb and the next that deform the mesh (split limbs), and what
  /// hangs on them along the bone. `path`: from the joint's child to the next joint.
  void collectOnPath(const std::vector<NodeIndex>& path, std::size_t bone,
                     std::vector<NodeIndex>& riders) const;
  /// Whether all of the mesh under `node`, a child of the last joint, stands at the end joint of the limb.
  [[nodiscard]] bool isAtEnd(NodeIndex node) const;

private:
  [[nodiscard]] bool holdsOthers(NodeIndex node) const;
  [[nodiscard]] bool isRigidPart(NodeIndex node) const;
  [[nodiscard]] bool covers(NodeIndex node, std::size_t bone) const;

  const Scene& scene_;
  const Limb& limb_;
  const BindPlaces& places_;
  std::set<NodeIndex> othersJoints_;
  std::set<NodeIndex> skinned_;
  std::vector<Vec3> points_; // of the limb in the bind pose
};

/// Nodes outside the limb that stand at its end joint. Of a limb that reaches out those whose mesh stands
/// there and at no other limb's: feet and heels that hang under the root, driven by IK; what hangs on the
/// trunk is not among them. Of spine and neck those that carry limbs: arms, neck and head that hang beside
/// the spine. Parents first.
[[nodiscard]] std::vector<NodeIndex> companionsElsewhere(const Scene& scene, const Limb& limb,
                                                         const std::vector<Limb>& others,
                                                         const BindPlaces& places);

/// The highest nodes that carry some of `carried`, themselves included, and none of `kept`; ascending.
[[nodiscard]] std::vector<NodeIndex> highestCarriers(const Scene& scene,
                                                     const std::vector<NodeIndex>& carried,
                                                     const std::vector<NodeIndex>& kept);

} // namespace stretch::rig
