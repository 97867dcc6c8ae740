#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rig/adjust/foot_roll.h"
#include "rig/adjust/hand_curl.h"
#include "rig/controllers/controller.h"
#include "rig/controllers/offset_curve.h"
#include "rig/reach/bind_places.h"
#include "rig/reach/limb_reach.h"

namespace stretch::rig {

/// The curves of all controllers and attributes of a clip, by their ids.
using OffsetCurves = std::map<std::string, std::vector<OffsetCurve>>;

/// Offset at one time of one controller or attribute: the sum over its curves, an attribute's value
/// from the curve that covers the time. `standard`: the value of an attribute where none does.
[[nodiscard]] Offset offsetAt(const OffsetCurves& curves, const std::string& id, double timeSeconds,
                              double standard = 0.0);

/// The controllers and attributes of one limb, by their ids; empty where it has none of the kind.
struct LimbControls {
  std::string end;
  std::string pole;
  std::string follow;
  std::string stretch;
  std::string volume;
  std::string roll;
  std::string curl;
  std::string softness;
};

/// A limb that controllers may move.
struct AdjustedLimb : ReachingLimb {
  LimbControls controls;
  NodeIndex carrier;                 ///< Node that its base goes along with: the base's parent, or the hips
                                     ///< where the base itself hangs beside them.
  std::vector<NodeIndex> detached;   ///< Nodes that belong to it and hang elsewhere than its base does.
  Quat baseBind{1.0, 0.0, 0.0, 0.0}; ///< World rotation of the base joint in the bind pose.
  std::vector<FingerJoint> fingers;  ///< Fingers of an arm.
  FootRoll roll;                     ///< Roll of a leg's foot.
  bool hangsOnHips = false;          ///< Else on the chest.
};

/// A controller on any other joint.
struct AdjustedJoint {
  std::string id;
  NodeIndex node;
  Quat parentBind{1.0, 0.0, 0.0, 0.0};
};

/// Nodes that move together, and the controllers and attributes that they depend on.
struct AdjustedPart {
  std::vector<NodeIndex> nodes;
  double boneLength = 0.0;
  std::vector<std::string> ids;
};

/// Body on which the adjustments of one clip are solved, whatever they are: made once for a clip.
struct AdjustedBody {
  ControllerList list;
  std::vector<Controller> jointControllers; ///< On every joint that none of the list moves.
  BindPlaces places;
  NodeIndex hips;
  std::vector<NodeIndex> roots; ///< Nodes that the body's controller moves: nothing of the character hangs
                                ///< elsewhere.
  std::vector<NodeIndex> besideHips; ///< Nodes that carry limbs and go along with the hips, on which they do
                                     ///< not hang.
  NodeIndex chest;                   ///< Carrier of head and hands: the end of the spine, else the hips.
  Quat hipsBind{1.0, 0.0, 0.0, 0.0};
  Quat chestBind{1.0, 0.0, 0.0, 0.0};
  Vec3 forward{0.0, 0.0, 1.0}; ///< Direction that the character faces in the bind pose; unit, level.
  std::optional<AdjustedLimb> spine;
  std::optional<AdjustedLimb> neck;
  std::vector<AdjustedLimb> limbs; ///< Those that reach out from the trunk.
};

/// The adjustments of one clip, ready for any time.
struct SolvedAdjustments {
  OffsetCurves curves; ///< Empty: nothing is adjusted, and nothing else need be filled in.
  std::shared_ptr<const AdjustedBody> body;
  std::vector<AdjustedJoint> joints;
  std::vector<AdjustedPart> parts;
  std::vector<LimbPlace> moved; ///< The limbs that a key may move; all others go along as they are.
  std::vector<NodeIndex> nodes; ///< Everything that is read or moved.

  [[nodiscard]] bool empty() const { return curves.empty(); }
  [[nodiscard]] bool moves(const LimbPlace& limb) const {
    return std::find(moved.begin(), moved.end(), limb) != moved.end();
  }
};

} // namespace stretch::rig
