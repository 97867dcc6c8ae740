#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/anim/frame_state.h"
#include "skinning/surface_part.h"

namespace stretch::skinning {

/// Edges of a part of a surface beside what they are in the bind pose. Joints rule out most that may be too
/// long: from end to end an edge is carried by the mean of its joints, and weight that passes from one joint
/// to another along it carries it as far as these two are apart there.
class LongEdges {
public:
  /// `part`: has edges; `bind`: the bind pose; `seen`: the length from which on an edge
  /// counts, world units, above 0.
  LongEdges(const SurfacePart& part, const FrameState& bind, double seen);

  /// Lengths of the part's edges in the bind pose, world units.
  [[nodiscard]] const std::vector<double>& lengths() const { return lengths_; }
  /// Indices of the edges that may be longer than `times` their length in the bind pose and longer than what
  /// is seen; some more than once. `part`: the one that they are of.
  [[nodiscard]] std::vector<std::uint32_t> among(const SurfacePart& part, const SurfacePart::Posed& posed,
                                                 double times) const;

private:
  struct Passing {      // of weight, along an edge
    float share = 0.0F; // over the edge's length, rounded up
    std::uint32_t edge = 0;
  };
  // Two joints between which edges pass weight on.
  struct Blend {
    std::size_t from = 0;
    std::size_t to = 0;
    Vec3 centre{0.0}; // of a ball around those edges, in their mesh
    double radius = 0.0;
    std::vector<Passing> edges = {}; // that pass on most first
  };

  void measure(const SurfacePart& part);

  double seen_;
  bool areMeans_; // without that joints rule out nothing
  std::vector<double> lengths_;
  std::vector<double> longest_; // by slot: of its edges in their mesh over what they count as in the bind
                                // pose
  std::vector<Blend> blends_;
};

} // namespace stretch::skinning
