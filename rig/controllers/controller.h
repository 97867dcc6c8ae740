#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

enum class ControllerKind {
  body,
  hips,
  spineLow,
  spineMiddle,
  spineTop,
  head,
  hand,
  foot,
  tip,  ///< End of any other limb that reaches out.
  pole, ///< Elbow or knee.
  joint ///< Any joint that is not one of the others'.
};

/// Handle that an artist takes hold of (docs/controllers.md, The controllers).
struct Controller {
  std::string id; ///< "left-hand"; of a joint its name, or "#index".
  ControllerKind kind = ControllerKind::joint;
  NodeIndex node;   ///< The joint that it is on; -1: the estimated end of its limb.
  std::string limb; ///< Limb::id; empty where there is none.
  bool moves = true;
  bool turns = true;
  double length = 1.0; ///< World units: what a recipe counts its moves in.
};

enum class AttributeKind { stretch, volume, follow, curl, roll, softness };

/// The largest value of the attribute softness, of the limb's length.
inline constexpr double mostSoftness = 0.3;

/// A number that is keyed beside the offsets.
struct Attribute {
  std::string id; ///< "left-arm.stretch", "left-hand.curl".
  AttributeKind kind = AttributeKind::stretch;
  std::string limb;
  double minimum = 0.0;
  double maximum = 1.0;
  double standard = 1.0; ///< Value while nothing is keyed.
};

/// Controllers and attributes of one character, in the order in which they are listed.
struct ControllerList {
  std::vector<Controller> controllers; ///< Without those on other joints: controllerNamed finds them.
  std::vector<Attribute> attributes;

  /// Null when the character has none of this id.
  [[nodiscard]] const Controller* controller(const std::string& id) const;
  [[nodiscard]] const Attribute* attribute(const std::string& id) const;
};

/// Lists the controllers that the limbs found allow. `hips`: -1 where none were found.
[[nodiscard]] ControllerList controllersOf(const Scene& scene, const std::vector<Limb>& limbs,
                                           NodeIndex hips);

/// A controller by its id, or one on any other joint by the joint's name or "#index". An error says what the
/// character has instead.
[[nodiscard]] Result<Controller> controllerNamed(const Scene& scene, const std::vector<Limb>& limbs,
                                                 NodeIndex hips, const ControllerList& list,
                                                 const std::string& id);

/// Those on the other joints of the character, in the order of the file: fingers, clavicles, toes, a tail.
/// Each is what controllerNamed answers for its id.
[[nodiscard]] std::vector<Controller> jointControllers(const Scene& scene, const std::vector<Limb>& limbs,
                                                       NodeIndex hips);

/// "left-hand", "front-left-foot", "tail-tip", "head" for the controller on the end of a limb, "left-elbow",
/// "left-knee" for its pole; empty where it has none.
[[nodiscard]] std::string endController(const Limb& limb);
[[nodiscard]] std::string poleController(const Limb& limb);

} // namespace stretch::rig
