#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/adjust/solved_adjustments.h"
#include "rig/controllers/controller.h"

namespace stretch::rig {

/// Part of the trunk that a controller hangs on. A pole, which its limb carries, and a joint's controller
/// count as the scene's.
enum class Carrier { scene, hips, chest };

/// Place of a controller at one time, for whatever is drawn of it or done with it.
struct PlacedController {
  std::string id; ///< Copied from Controller, like the next four.
  ControllerKind kind = ControllerKind::joint;
  NodeIndex node;
  bool moves = true;
  bool turns = true;
  Vec3 placeWorld{0.0};
  /// The scene's axes as what it is on has carried them from the bind pose.
  Quat orientationWorld{1.0, 0.0, 0.0, 0.0};
  Carrier carrier = Carrier::scene;
  Mat3 carrierAxesWorld{1.0};     ///< World columns: along which its offset is counted.
  std::optional<Vec3> jointWorld; ///< Joint that a pole leads.
  /// Of a pole: from where its offset puts it to where it stands, along the carrier's axes. A first move
  /// starts with it, so that the limb keeps its bend. Zero for all others.
  Vec3 slack{0.0};
};

/// The character at one time, as its adjustments leave it and as it is seen.
struct PlacingInput {
  const Scene& scene;
  const Clip& clip;
  const SolvedAdjustments& adjustments; ///< With a body.
  const FrameState& shown; ///< With adjustments, trails and what comes after; its time is the time.
};

/// All controllers of the body, in their order, then those on other joints.
[[nodiscard]] std::vector<PlacedController> placeControllers(const PlacingInput& input);

} // namespace stretch::rig
