#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/anim/clip.h"
#include "rig/retarget/joint_pairs.h"
#include "rig/retarget/skeleton.h"

namespace stretch::rig {

/// Places that the ends of the legs come to; nothing: wherever their bones take them.
using FootPlaces = std::array<std::optional<Vec3>, 2>;

/// A pose of a skeleton.
struct BodyPose {
  std::vector<Transform> locals; ///< One for each node.
  std::vector<Mat4> worlds;
};

/// Poses a skeleton by the world rotations of its paired joints: all others keep their bind pose.
class BodyPoser {
public:
  BodyPoser(const Skeleton& skeleton, const std::vector<JointPair>& pairs);

  /// `turns`: one for each pair. The carrier is moved by `shift`, world space. `feet` places those ends of
  /// legs that do not hang on them.
  [[nodiscard]] BodyPose pose(const std::vector<Quat>& turns, const Vec3& shift,
                              const FootPlaces& feet) const;

  /// Index of the pair of a joint; -1: it has none.
  [[nodiscard]] int pairOf(NodeIndex joint) const { return pairOf_[at(joint)]; }

  /// The poses as tracks, of which no joint is farther than `tolerance` from its place; joints whose bind
  /// pose is not how they rest are keyed with it.
  [[nodiscard]] std::vector<Track> tracks(const std::vector<float>& times, const std::vector<BodyPose>& poses,
                                          double tolerance) const;

private:
  void addStill(NodeIndex node, float time, double tolerance, std::vector<Track>& tracks) const;
  [[nodiscard]] double scaleAbove(NodeIndex node) const;
  [[nodiscard]] std::optional<std::size_t> placedFoot(NodeIndex node) const;

  const Skeleton& skeleton_;
  std::vector<NodeIndex> order_; // parents first
  std::vector<Transform> bindLocals_;
  std::vector<Mat4> bindMatrices_; // the same, exactly
  std::vector<double> reach_;      // how far what hangs on a node is from it
  std::vector<int> pairOf_;        // per node
  std::array<NodeIndex, 2> loose_; // ends of legs that do not hang on them
};

} // namespace stretch::rig
