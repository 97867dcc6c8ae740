#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig/retarget/skeleton.h"

namespace stretch::rig {

/// A joint, and what it follows: the joints of another skeleton, between two of which it may stand.
struct JointPair {
  NodeIndex joint;
  NodeIndex from;
  NodeIndex towards;               ///< Equal to `from` where one joint is followed.
  double share = 0.0;              ///< Share of `towards`, 0..1.
  Quat stance{1.0, 0.0, 0.0, 0.0}; ///< World: turns the joint from its bind pose into the stance of the
                                   ///< skeleton that it follows (a T-pose into an A-pose).
  std::optional<std::size_t> standsOn = {}; ///< The side of a foot that the other skeleton lacks: it follows
                                            ///< the shin, and is level where that stands.
};

/// How one skeleton follows another.
struct JointPairs {
  Quat world{1.0, 0.0, 0.0, 0.0}; ///< World directions of the followed skeleton to those of the following.
  std::vector<JointPair> pairs;   ///< A joint at most once.
  std::vector<std::string> left;  ///< Parts that only the followed skeleton has, in words.
};

/// Pairs joints by what they are: limbs by their bones, spine and neck by their share of the way, shoulders,
/// toes and fingers where both have them (docs/import_clip.md).
[[nodiscard]] JointPairs pairJoints(const Skeleton& from, const Skeleton& to);

} // namespace stretch::rig
