#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "rig/corners/bind_corners.h"
#include "rig/corners/corner_set.h"
#include "rig/corners/few_weights.h"

namespace stretch::rig {

/// A part of what a vertex follows: a joint, or one of its corners.
struct CornerInfluence {
  std::uint16_t slot = 0; ///< Index of the joint.
  int corner = -1;        ///< Index into CornerSet::places; -1: the joint itself.
  double weight = 0.0;
};

/// Splits what the vertices of a mesh follow among the corners of its joints.
class VertexSplit {
public:
  /// `sets` get further corners: where a vertex stands that has too many influences, and that no fit brings
  /// near its place. All that is given outlives the splitting.
  VertexSplit(const MovedMesh& mesh, std::map<NodeIndex, CornerSet>& sets, const CornerOptions& options);

  struct Answer {
    std::vector<CornerInfluence> parts; ///< Heaviest first, at most as many as allowed.
    bool isMoved = false;               ///< By a joint that gets corners.
    bool isFitted = false;
    double miss = 0.0; ///< Farthest from the exact place at the moments, world units.
  };
  /// `onCorners`: the vertex as the file has it, where corners of its own stand in the file; else null.
  [[nodiscard]] Answer of(const VertexInfluences& asRead, const VertexInfluences* onCorners,
                          const Vec3& place);

private:
  struct Slot {
    CornerSet* corners = nullptr;
    bool isGivenUp = false;                 // a corner of the file whose joint has new ones
    std::vector<Mat4> matrices;             // of the joint, without its stretch; for each moment
    std::vector<std::vector<Vec3>> offsets; // of the corners, by moment
  };

  [[nodiscard]] std::vector<CornerInfluence>
  partsOf(const VertexInfluences& vertex, const VertexInfluences& written, const Vec3& place) const;
  [[nodiscard]] bool isNew(std::uint16_t slot) const;
  bool putOnOwnCorners(std::vector<CornerInfluence>& parts, const Vec3& place);
  [[nodiscard]] int ownCorner(std::uint16_t index, const Vec3& own) const;
  void fit(Answer& answer, const VertexInfluences& vertex, const Vec3& place);
  [[nodiscard]] std::vector<CornerInfluence> candidatesOf(const VertexInfluences& vertex,
                                                          const std::vector<CornerInfluence>& exact) const;
  void addShading(const std::vector<CornerInfluence>& exact, const std::vector<CornerInfluence>& candidates,
                  MissProducts& products) const;
  const Slot& prepared(std::uint16_t index);

  const MovedMesh& mesh_;
  const CornerOptions& options_;
  std::vector<Slot> slots_;
  std::map<std::uint16_t, CornerInfluence> made_; // the file's corners, by slot
};

} // namespace stretch::rig
