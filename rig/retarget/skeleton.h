#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "rig/body/reading/detection.h"
#include "rig/limb.h"

namespace stretch::rig {

/// A leg of a skeleton, with the point of its foot that stands on the ground.
struct SkeletonLeg {
  Limb limb;
  NodeIndex toes;             ///< None: the foot has no joint for them.
  NodeIndex footing;          ///< The joint that carries the foot: the limb's end, else its last joint.
  Vec3 ballInFooting{0.0};    ///< The ball of the foot in that joint's space; the limb's end where nothing
                              ///< tells.
  double length = 0.0;        ///< Length of its bones in the bind pose, > 0.
  std::optional<double> sole; ///< How high the underside of the foot's mesh is there.

  [[nodiscard]] Vec3 ball(const std::vector<Mat4>& worlds) const;
};

/// The joints of one finger, base first.
using Fingers = std::map<std::string, std::vector<NodeIndex>>; ///< "thumb", "index", "middle", "ring",
                                                               ///< "little".

struct SkeletonArm {
  Limb limb;
  NodeIndex shoulder; ///< The clavicle. None: the arm hangs on the trunk itself.
  Fingers fingers;
};

inline constexpr std::size_t leftSide = 0;
inline constexpr std::size_t rightSide = 1;

/// A biped as another one's clip is brought to it: which joint is what, and how it stands in the bind pose.
struct Skeleton {
  const Scene* scene = nullptr;
  double height = 1.0;
  NodeIndex hips;
  NodeIndex carrier;            ///< The joint that carries legs and trunk: what travels.
  std::vector<NodeIndex> spine; ///< From the first joint above the hips to the one that carries the arms.
  std::vector<NodeIndex> neck;  ///< Without the head.
  NodeIndex head;
  std::array<std::optional<SkeletonArm>, 2> arms; ///< Left, right.
  std::array<SkeletonLeg, 2> legs;
  std::vector<Mat4> bind;      ///< World matrix of every node in the bind pose.
  std::vector<Quat> bindTurns; ///< Their rotations.
  Mat3 axes{1.0};              ///< Columns: left, up and front of the body in the bind pose, unit length.
  double groundHeight = 0.0;   ///< Height, in the bind pose, of what stands at 0 in its clips: its soles',
                               ///< where they are near 0 there.
  bool isUpright = true;       ///< The body stands along +Y there; `axes` then has exactly that.
};

/// Nothing for a character without two legs and hips: a clip of another body cannot be brought to it. The
/// scene has to outlive what is made of it.
[[nodiscard]] std::optional<Skeleton> skeletonOf(const Scene& scene, const Body& biped);

} // namespace stretch::rig
